// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Points as they come from Python: arrays of any layout, read without a copy where that can be.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "ltp/geometry/points_view.hpp"
#include "ltp/geometry/types.hpp"

namespace bindings {

/// Which numbers an array may hold. Integers are refused where they could be a sensor's
/// millimetres.
enum class Numbers { Real, Floating };

/// What a value is, for errors: "an array of shape (2, 2) and dtype float64".
std::string described(pybind11::handle value);

/// What numpy makes of a value. What a mask hides becomes NaN, whatever lies beneath it. Null where
/// numpy makes nothing of it, or a mask hides integers or the like, which cannot be NaN.
pybind11::array as_array(pybind11::handle value);

/// An array of floats or doubles, (N, 3) or wider, C-ordered: what was given, or a copy. Takes (N,
/// 3) or wider, organised (H, W, 3) or wider, structured with fields x, y, z, and (3,) as one
/// point; float32 or float64 of any layout and byte order, and lists of numbers. Throws `TypeError`
/// that says in one sentence what was given and what is expected.
/// @param name  of the argument; empty: unknown
pybind11::array points_array(pybind11::handle value, const std::string& name, Numbers numbers);

/// The rows of such an array. Valid as long as the array.
ltp::PointsView view_of(const pybind11::array& points);

/// Three numbers. Throws `TypeError` as `points_array` does.
ltp::Point point_from(pybind11::handle value);

/// An argument that is points; read, and named in errors, by the function that takes it.
struct Points {
  pybind11::object given;
};

/// Points that are being read, whatever array holds them.
class PointsInUse {
 public:
  PointsInUse(const Points& points, const char* name, Numbers numbers = Numbers::Floating)
      : array_(points_array(points.given, name, numbers)), view_(view_of(array_)) {}
  /// No points, if there are none.
  PointsInUse(const std::optional<Points>& points, const char* name) {
    if (points) *this = PointsInUse(*points, name);
  }
  const ltp::PointsView& view() const { return view_; }

 private:
  pybind11::array array_;
  ltp::PointsView view_;
};

/// Where a sensor is: a `Pose`, or only its position.
struct Place {
  ltp::Pose pose;
};

}  // namespace bindings

namespace pybind11::detail {

template <>
struct type_caster<bindings::Points> {
  PYBIND11_TYPE_CASTER(bindings::Points, EigenProps<ltp::Path>::descriptor);
  bool load(handle source, bool) {
    value.given = reinterpret_borrow<object>(source);
    return true;
  }
  static handle cast(const bindings::Points& points, return_value_policy, handle) {
    return points.given.inc_ref();
  }
};

template <>
struct type_caster<bindings::Place> {
  PYBIND11_TYPE_CASTER(bindings::Place, make_caster<ltp::Pose>::name + const_name(" | ") +
                                            EigenProps<ltp::Point>::descriptor);
  bool load(handle source, bool) {
    value.pose = isinstance<ltp::Pose>(source) ? source.cast<ltp::Pose>()
                                               : ltp::Pose{bindings::point_from(source)};
    return true;
  }
};

/// Every `Point` that a function takes or returns. As Eigen's own caster, but a wrong shape is told
/// in one sentence.
template <>
struct type_caster<ltp::Point> {
  using Props = EigenProps<ltp::Point>;

 public:
  static constexpr auto name = Props::descriptor;
  template <typename>
  using cast_op_type = const ltp::Point&;
  operator const ltp::Point&() { return value_; }  // NOLINT: what a caster must have

  bool load(handle source, bool) {
    value_ = bindings::point_from(source);
    return true;
  }
  // What is returned by value is copied, whatever the policy: nobody keeps it.
  static handle cast(ltp::Point&& point, return_value_policy, handle) {
    return eigen_array_cast<Props>(point);
  }
  static handle cast(const ltp::Point&& point, return_value_policy, handle) {
    return eigen_array_cast<Props>(point);
  }
  static handle cast(const ltp::Point& point, return_value_policy policy, handle parent) {
    if (policy == return_value_policy::reference_internal) {
      return eigen_ref_array<Props>(point, parent);
    }
    return eigen_array_cast<Props>(point);
  }
  static handle cast(const ltp::Point* point, return_value_policy policy, handle parent) {
    return cast(*point, policy, parent);
  }

 private:
  ltp::Point value_;
};

/// Every path and point set that a function takes.
template <>
struct type_caster<ltp::PathRef> {
  using Map = Eigen::Map<const ltp::Path, 0, Eigen::OuterStride<>>;

 public:
  static constexpr auto name = EigenProps<ltp::Path>::descriptor;
  template <typename>
  using cast_op_type = const ltp::PathRef&;
  operator const ltp::PathRef&() { return *ref_; }  // NOLINT: what a caster must have

  bool load(handle source, bool) {
    kept_ = bindings::points_array(source, "", bindings::Numbers::Real);
    const ltp::PointsView view = bindings::view_of(kept_);
    if (view.scalar() == ltp::PointsView::Scalar::Float) {
      doubles_ = Eigen::Map<const Floats, 0, Eigen::OuterStride<>>(
                     view.data<float>(), view.rows(), 3, Eigen::OuterStride<>(view.stride()))
                     .cast<double>();
      ref_.emplace(doubles_);
    } else {
      ref_.emplace(Map(view.data<double>(), view.rows(), 3, Eigen::OuterStride<>(view.stride())));
    }
    return true;
  }

 private:
  using Floats = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

  array kept_;
  ltp::Path doubles_;
  std::optional<ltp::PathRef> ref_;
};

}  // namespace pybind11::detail
