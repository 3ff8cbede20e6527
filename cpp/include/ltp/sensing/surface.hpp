// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Surface`: something that a ray can hit.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// Where a ray first meets a surface.
struct RayHit {
  double range = std::numeric_limits<double>::infinity();  ///< from the ray's origin [m]; inf: none
  /// The point hit, moved into the solid by `kHitDepth` along the inward normal of the face hit, so
  /// that rounding it to a cell finds the solid's cell and never the free one before it. It also
  /// keeps `kHitMargin` from the other faces of the column or voxel hit.
  Point inside = Point::Constant(std::numeric_limits<double>::quiet_NaN());

  bool hit() const { return range < std::numeric_limits<double>::infinity(); }
};

inline constexpr double kHitDepth = 1e-3;   ///< [m]
inline constexpr double kHitMargin = 1e-6;  ///< [m]; far above rounding, far below any cell

/// The hits among many rays, in the order of the rays. Memory for all rays is taken beforehand, so
/// that noting a hit is three writes.
class RayHits {
 public:
  /// Forgets all hits; room for `rays` of them.
  void reset(std::int64_t rays);
  void add(std::int64_t ray, double range, const Point& inside) {
    rays_[size_] = static_cast<std::int32_t>(ray);
    ranges_[size_] = range;
    inside_[size_++] = inside;
  }

  /// Memory for more hits, to be written at once.
  struct Slots {
    std::int32_t* rays;
    double* ranges;
    Point* inside;
  };
  Slots extend(std::int64_t count) {
    const std::int64_t first = size_;
    size_ += count;
    return {rays_.data() + first, ranges_.data() + first, inside_.data() + first};
  }

  std::int64_t size() const { return size_; }
  std::int32_t ray(std::int64_t hit) const { return rays_[hit]; }  ///< its number
  double range(std::int64_t hit) const { return ranges_[hit]; }    ///< as in `RayHit` [m]
  const Point& inside(std::int64_t hit) const { return inside_[hit]; }
  /// Swaps the points, one a hit, with a list whose memory serves the next ones. Forgets all hits.
  void swap_inside(std::vector<Point>& points);

 private:
  std::int64_t size_ = 0;
  std::vector<std::int32_t> rays_;
  std::vector<double> ranges_;
  std::vector<Point> inside_;
};

/// The beams of one azimuth. They share a ground track; only their slopes differ.
class BeamFan {
 public:
  struct Beam {
    double slope;    ///< metres up per metre along the ground
    double run;      ///< metres along the ground per metre up; inf for a level beam
    double cosine;   ///< of the elevation
    double sine;     ///< of the elevation
    double stretch;  ///< metres along the beam per metre along the ground
  };

  /// @param elevations  ascending [rad], each in (-pi/2, pi/2)
  explicit BeamFan(const std::vector<double>& elevations);

  int size() const { return static_cast<int>(beams_.size()); }
  const Beam& operator[](int row) const { return beams_[row]; }

 private:
  std::vector<Beam> beams_;
};

/// A direction, shape (3,) by row, turned: always by the same additions in the same order.
template <typename Row>
Point turned(const Eigen::Matrix3d& turn, const Row& direction) {
  return turn.col(0) * direction[0] + turn.col(1) * direction[1] + turn.col(2) * direction[2];
}

/// A ray touches a surface's solid when it enters its interior: one that only grazes a face, an
/// edge or a corner goes on. A ray that starts inside the solid hits at range 0.
class Surface {
 public:
  virtual ~Surface() = default;

  /// The first hit of the ray from `origin` [m] along the unit vector `direction`, nearer than
  /// `max_range` [m]. All finite; not checked.
  virtual RayHit cast(const Point& origin, const Point& direction, double max_range) const = 0;

  /// Fans from one origin, one after the other, all beams of a fan at once: directions (cosine *
  /// heading, sine), numbered from 0.
  /// @param headings  unit vectors in the plane (x, y)
  /// @param hits      the fans' are added
  /// The default casts one by one; a height surface sweeps the horizon once a fan.
  virtual void cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                         const BeamFan& fan, double max_range, RayHits& hits) const;

  /// All rays of one origin at once, numbered from 0: what `cast` says of each, to the last bit.
  /// @param turn        a rotation, applied to each direction by `turned`
  /// @param directions  unit vectors, shape (N, 3)
  /// @param hits        the bundle's are added
  /// The default casts one by one; a height surface first looks where each ray can hit at all.
  virtual void cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                           const PathRef& directions, double max_range, RayHits& hits) const;

  /// Arc length [m] at which a path, shape (N, 3) [m], first touches the solid, exactly along its
  /// segments; empty if it never does. A path of one point is tested as that point. Throws for
  /// coordinates that are not finite. The default casts along each segment, so a path that only
  /// grazes goes on.
  virtual std::optional<double> first_collision(const PathRef& path) const;

  /// Distance [m] from a point to the solid, 0 inside it, at most `max_distance`. Throws for values
  /// that are not finite or a negative distance. The default does not know it: NaN.
  virtual double clearance(const Point& point, double max_distance) const;

  /// Ranges [m] of any rays; inf: no hit nearer than `max_range`. Neighbours with the same origin
  /// are cast together.
  /// @param origins     shape (N, 3) [m], finite; not checked
  /// @param directions  unit vectors, shape (N, 3); not checked
  /// @param ranges      shape (N,), written
  void cast_rays(const PathRef& origins, const PathRef& directions, double max_range,
                 Eigen::Ref<Eigen::VectorXd> ranges) const;
};

}  // namespace ltp
