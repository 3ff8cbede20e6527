// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/lidar.hpp"

#include <cmath>

#include "ltp/geometry/check.hpp"
#include "noise.hpp"

namespace ltp {
namespace {

constexpr double kRadians = 0.017453292519943295;
constexpr std::int64_t kMostRays = std::int64_t{1} << 20;  // a tenth of a second
constexpr double kLevel = 1e-12;  // a body axis this near to the world's is upright

enum Draw : std::uint64_t { kRangeDraw = 0, kDropOutDraw = 2 };  // a normal takes two numbers

LidarPattern checked(const LidarOptions& options) {
  options.check();
  return options.pattern;
}

std::vector<double> elevations(const LidarPattern& pattern) {
  std::vector<double> radians(pattern.rows);
  const double span = pattern.elevation_to_deg - pattern.elevation_from_deg;
  for (int row = 0; row < pattern.rows; ++row) {
    const double share = pattern.rows > 1 ? row / (pattern.rows - 1.0) : 0.0;
    radians[row] = kRadians * (pattern.elevation_from_deg + share * span);
  }
  return radians;
}

std::vector<Eigen::Vector2d> headings(const LidarPattern& pattern) {
  std::vector<Eigen::Vector2d> unit(pattern.azimuths);
  const double span = pattern.azimuth_to_deg - pattern.azimuth_from_deg;
  const int steps = span < 360.0 ? pattern.azimuths - 1 : pattern.azimuths;
  for (int n = 0; n < pattern.azimuths; ++n) {
    const double share = steps > 0 ? static_cast<double>(n) / steps : 0.0;
    const double azimuth = kRadians * (pattern.azimuth_from_deg + share * span);
    unit[n] = {std::cos(azimuth), std::sin(azimuth)};
  }
  return unit;
}

/// Sorts the returns of one scan into its lists.
class Sorter {
 public:
  Sorter(const LidarOptions& options, const Point& origin, std::uint64_t sequence, Scan& out)
      : options_(options),
        sequence_(sequence),
        noisy_(options.range_noise_sd > 0.0 || options.drop_out > 0.0),
        out_(out) {
    out.origin = origin;
    out.statistics = {};
    out.hits.clear();
    out.misses.clear();
    out.hits.reserve(options.pattern.size());
    out.misses.reserve(options.pattern.size());
  }

  /// A ray's hit on a surface. `direction` is called only if the end point must be computed.
  template <typename Direction>
  void add(std::int64_t ray, const RayHit& hit, const Direction& direction) {
    if (!hit.hit()) {
      miss(direction());
    } else if (!noisy_) {
      out_.hits.push_back(hit.inside);
    } else {
      add_noisy(ray, hit, direction());
    }
  }

  /// A range that a sensor measured.
  void add_range(double range, const Point& direction) {
    if (!(range > 0.0)) {  // negated for NaN
      ++out_.statistics.invalid;
    } else if (range >= options_.max_range) {
      miss(direction);
    } else {
      out_.hits.push_back(out_.origin + range * direction);
    }
  }

  void finish() {
    out_.statistics.hits = static_cast<std::int64_t>(out_.hits.size());
    out_.statistics.misses = static_cast<std::int64_t>(out_.misses.size());
  }

 private:
  void miss(const Point& direction) {
    out_.misses.push_back(out_.origin + options_.max_range * direction);
  }

  void add_noisy(std::int64_t ray, const RayHit& hit, const Point& direction) {
    const sensing::RayNoise noise(options_.seed, sequence_, static_cast<std::uint64_t>(ray));
    if (noise.uniform(kDropOutDraw) < options_.drop_out) {
      ++out_.statistics.dropped;
    } else if (options_.range_noise_sd > 0.0) {
      add_range(hit.range + options_.range_noise_sd * noise.normal(kRangeDraw), direction);
    } else {
      out_.hits.push_back(hit.inside);
    }
  }

  const LidarOptions& options_;
  std::uint64_t sequence_;
  bool noisy_;
  Scan& out_;
};

}  // namespace

void LidarPattern::check() const {
  if (azimuths < 1) check::fail("azimuths", azimuths, "at least 1");
  if (rows < 1) check::fail("rows", rows, "at least 1");
  if (size() > kMostRays) check::fail("azimuths * rows", size(), "at most 2^20 rays");
  check::finite("azimuth_from_deg", azimuth_from_deg);
  check::finite("azimuth_to_deg", azimuth_to_deg);
  const double span = azimuth_to_deg - azimuth_from_deg;
  if (!(span <= 360.0) || !(azimuths > 1 ? span > 0.0 : span >= 0.0)) {
    check::fail("azimuth_to_deg", azimuth_to_deg,
                "more than azimuth_from_deg, by 360 at most (equal only for a single azimuth)");
  }
  if (!(std::abs(elevation_from_deg) < 90.0)) {
    check::fail("elevation_from_deg", elevation_from_deg, "within (-90, 90)");
  }
  if (!(std::abs(elevation_to_deg) < 90.0)) {
    check::fail("elevation_to_deg", elevation_to_deg, "within (-90, 90)");
  }
  if (rows > 1 ? elevation_to_deg <= elevation_from_deg : elevation_to_deg < elevation_from_deg) {
    check::fail("elevation_to_deg", elevation_to_deg,
                "more than elevation_from_deg (equal only for a single row)");
  }
}

void LidarOptions::check() const {
  pattern.check();
  check::positive("max_range", max_range);
  check::not_negative("range_noise_sd", range_noise_sd);
  if (!(drop_out >= 0.0 && drop_out <= 1.0)) check::fail("drop_out", drop_out, "within [0, 1]");
}

Lidar::Lidar(const LidarOptions& options)
    : options_(options), headings_(headings(checked(options))), fan_(elevations(options.pattern)) {
  directions_.resize(options.pattern.size(), 3);
  Eigen::Index ray = 0;
  for (const Eigen::Vector2d& heading : headings_) {
    for (int row = 0; row < fan_.size(); ++row, ++ray) {
      const BeamFan::Beam& beam = fan_[row];
      directions_.row(ray) << beam.cosine * heading.x(), beam.cosine * heading.y(), beam.sine;
    }
  }
}

void Lidar::scan(const Surface& surface, const Pose& pose, std::uint64_t sequence,
                 Scan& out) const {
  check::finite("pose", pose);
  const Eigen::Matrix3d turn = pose.world_from_body.normalized().toRotationMatrix();
  Sorter sorter(options_, pose.position, sequence, out);

  const bool level = (turn.col(2) - Point::UnitZ()).norm() <= kLevel;
  if (level) {
    static thread_local std::vector<RayHit>
        hits;  // reused from azimuth to azimuth and scan to scan
    std::int64_t ray = 0;
    for (const Eigen::Vector2d& forward : headings_) {
      const Eigen::Vector2d heading = (turn.topLeftCorner<2, 2>() * forward).normalized();
      surface.cast_fan(pose.position, heading, fan_, options_.max_range, hits);
      for (int row = 0; row < fan_.size(); ++row, ++ray) {
        const BeamFan::Beam& beam = fan_[row];
        sorter.add(ray, hits[row], [&] {
          return Point(beam.cosine * heading.x(), beam.cosine * heading.y(), beam.sine);
        });
      }
    }
  } else {
    for (Eigen::Index ray = 0; ray < directions_.rows(); ++ray) {
      const Point direction = turn * directions_.row(ray).transpose();
      const RayHit hit = surface.cast(pose.position, direction, options_.max_range);
      sorter.add(ray, hit, [&] { return direction; });
    }
  }
  sorter.finish();
}

void Lidar::from_ranges(const Eigen::Ref<const Eigen::VectorXd>& ranges, const Pose& pose,
                        Scan& out) const {
  check::finite("pose", pose);
  if (ranges.size() != directions_.rows()) {
    check::fail("ranges.size", ranges.size(), "one range a ray: azimuths * rows");
  }
  const Eigen::Matrix3d turn = pose.world_from_body.normalized().toRotationMatrix();
  Sorter sorter(options_, pose.position, 0, out);
  for (Eigen::Index ray = 0; ray < ranges.size(); ++ray) {
    sorter.add_range(ranges[ray], turn * directions_.row(ray).transpose());
  }
  sorter.finish();
}

}  // namespace ltp
