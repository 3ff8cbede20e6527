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

/// Throws if the pose is none.
Eigen::Matrix3d turn_of(const Pose& pose) {
  check::finite("pose", pose);
  return pose.world_from_body.normalized().toRotationMatrix();
}

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
  /// @param directions  of the rays, in the sensor's frame
  Sorter(const LidarOptions& options, const Path& directions, const Pose& pose, Misses misses,
         Scan& out)
      : options_(options),
        directions_(directions),
        turn_(turn_of(pose)),
        misses_(misses),
        out_(out) {
    out.origin = pose.position;
    out.statistics = {};
    out.misses.clear();
    if (misses == Misses::Listed) out.misses.reserve(directions.rows());
  }

  const Eigen::Matrix3d& turn() const { return turn_; }

  /// No return from rays [first, last).
  void miss(Eigen::Index first, Eigen::Index last) {
    out_.statistics.misses += last - first;
    if (misses_ == Misses::Counted) return;
    for (Eigen::Index ray = first; ray < last; ++ray) {
      out_.misses.push_back(at(ray, options_.max_range));
    }
  }

  /// A range that a sensor measured.
  void add_range(Eigen::Index ray, double range) {
    if (!(range > 0.0)) {  // negated for NaN
      ++out_.statistics.invalid;
    } else if (range < options_.min_range) {
      ++out_.statistics.too_near;
    } else if (range >= options_.max_range) {
      miss(ray, ray + 1);
    } else {
      out_.hits.push_back(at(ray, range));
    }
  }

  /// A true hit, seen by a sensor with noise or a minimum range.
  void add_hit(Eigen::Index ray, double range, const Point& inside, std::uint64_t sequence) {
    const sensing::RayNoise noise(options_.seed, sequence, static_cast<std::uint64_t>(ray));
    if (noise.uniform(kDropOutDraw) < options_.drop_out) {
      ++out_.statistics.dropped;
    } else if (options_.range_noise_sd > 0.0) {
      add_range(ray, range + options_.range_noise_sd * noise.normal(kRangeDraw));
    } else if (range < options_.min_range) {
      ++out_.statistics.too_near;
    } else {
      out_.hits.push_back(inside);
    }
  }

  void finish() { out_.statistics.hits = static_cast<std::int64_t>(out_.hits.size()); }

 private:
  Point at(Eigen::Index ray, double range) const {
    return out_.origin + range * turned(turn_, directions_.row(ray));
  }

  const LidarOptions& options_;
  const Path& directions_;
  Eigen::Matrix3d turn_;
  Misses misses_;
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
  check::not_negative("min_range", min_range);
  if (!(min_range < max_range)) check::fail("min_range", min_range, "less than max_range");
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

void Lidar::scan(const Surface& surface, const Pose& pose, std::uint64_t sequence, Scan& out,
                 Misses misses) const {
  static thread_local RayHits hits;  // both reused from scan to scan
  static thread_local std::vector<Eigen::Vector2d> turned_headings;
  Sorter sorter(options_, directions_, pose, misses, out);
  const Eigen::Matrix3d& turn = sorter.turn();
  const bool sorted =
      options_.range_noise_sd > 0.0 || options_.drop_out > 0.0 || options_.min_range > 0.0;
  if (!sorted) hits.swap_inside(out.hits);  // to be found where they are wanted
  hits.reset(directions_.rows());

  const bool level = (turn.col(2) - Point::UnitZ()).norm() <= kLevel;
  if (level) {
    turned_headings.clear();
    for (const Eigen::Vector2d& heading : headings_) {
      turned_headings.push_back((turn.topLeftCorner<2, 2>() * heading).normalized());
    }
    surface.cast_fans(pose.position, turned_headings, fan_, options_.max_range, hits);
  } else {
    surface.cast_bundle(pose.position, turn, directions_, options_.max_range, hits);
  }

  if (sorted) {
    out.hits.clear();
    out.hits.reserve(directions_.rows());
  }
  if (sorted || misses == Misses::Listed) {
    std::int64_t next = 0;
    for (std::int64_t n = 0; n < hits.size(); ++n) {
      const std::int32_t ray = hits.ray(n);
      sorter.miss(next, ray);
      if (sorted) sorter.add_hit(ray, hits.range(n), hits.inside(n), sequence);
      next = ray + 1;
    }
    sorter.miss(next, directions_.rows());
  } else {
    sorter.miss(hits.size(), directions_.rows());  // whichever they are
  }
  if (!sorted) hits.swap_inside(out.hits);
  sorter.finish();
}

void Lidar::from_ranges(const Eigen::Ref<const Eigen::VectorXd>& ranges, const Pose& pose,
                        Scan& out) const {
  sort_ranges(ranges, pose, out);
}

void Lidar::from_ranges(const Eigen::Ref<const Eigen::VectorXf>& ranges, const Pose& pose,
                        Scan& out) const {
  sort_ranges(ranges, pose, out);
}

template <typename Ranges>
void Lidar::sort_ranges(const Ranges& ranges, const Pose& pose, Scan& out) const {
  if (ranges.size() != directions_.rows()) {
    check::fail("ranges.size", ranges.size(), "one range a ray: azimuths * rows");
  }
  Sorter sorter(options_, directions_, pose, Misses::Listed, out);
  out.hits.clear();
  out.hits.reserve(directions_.rows());
  for (Eigen::Index ray = 0; ray < ranges.size(); ++ray) sorter.add_range(ray, ranges[ray]);
  sorter.finish();
}

}  // namespace ltp
