// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"

namespace bindings {
namespace {

/// A wider array is rather one of (3, N), *assumed*.
constexpr py::ssize_t kMostColumns = 32;

[[noreturn]] void refuse(py::handle value, const std::string& name, Numbers numbers) {
  throw py::type_error((name.empty() ? "" : name + ": ") +
                       "expected points of shape (N, 3) or wider, (H, W, 3) or wider, or with "
                       "fields x, y and z, of " +
                       (numbers == Numbers::Floating ? "float32 or float64" : "real numbers") +
                       ", got " + described(value));
}

bool has_dtype(py::handle value) {
  return py::isinstance<py::array>(value) || py::hasattr(value, "dtype");
}

bool is_floating(const py::dtype& dtype) {
  return dtype.kind() == 'f' && (dtype.itemsize() == 4 || dtype.itemsize() == 8);
}

bool is_real(const py::dtype& dtype) {
  return dtype.kind() == 'f' || dtype.kind() == 'i' || dtype.kind() == 'u';
}

py::array reshaped(const py::array& array, py::ssize_t rows, py::ssize_t columns) {
  return array.attr("reshape")(rows, columns);
}

py::array null_array() { return py::reinterpret_steal<py::array>(py::handle()); }

/// Whether it is an array of which a mask hides something.
bool hides_some(py::handle value) {
  // Asked by attribute first: hardly any array has a mask.
  if (!py::isinstance<py::array>(value) || !py::hasattr(value, "filled")) return false;
  const py::object mask = py::module_::import("numpy.ma").attr("getmask")(value);
  const py::module_ numpy = py::module_::import("numpy");
  // As plain booleans: of records it has a field each.
  return numpy.attr("ascontiguousarray")(mask).attr("view")("?").attr("any")().cast<bool>();
}

bool has_xyz(const py::array& records) {
  const py::object names = records.dtype().attr("names");
  return names.contains("x") && names.contains("y") && names.contains("z");
}

/// The coordinates of records of which a mask hides some: a copy, in which those are NaN.
/// Null where they are no numbers.
py::array unmasked_records(py::handle records) {
  py::list columns;
  for (const char* field : {"x", "y", "z"}) {
    const py::object column = records.attr("__getitem__")(field);
    if (column.attr("dtype").attr("kind").cast<std::string>() != "f") return null_array();
    columns.append(
        column.attr("astype")("f8").attr("filled")(std::numeric_limits<double>::quiet_NaN()));
  }
  return py::module_::import("numpy").attr("stack")(columns, "axis"_a = -1);
}

/// The fields x, y, z of records as columns, (N, 3). Without a copy if they lie side by side.
std::optional<py::array> columns_of_records(const py::array& records) {
  if (!has_xyz(records)) return std::nullopt;
  const py::array flat = records.attr("reshape")(-1);
  const py::array x = flat[py::str("x")];
  const py::array y = flat[py::str("y")];
  const py::array z = flat[py::str("z")];
  if (x.ndim() != 1 || y.ndim() != 1 || z.ndim() != 1) return std::nullopt;  // fields of arrays
  if (!is_real(x.dtype()) || !is_real(y.dtype()) || !is_real(z.dtype())) return std::nullopt;
  const auto begins = [](const py::array& array) { return static_cast<const char*>(array.data()); };
  const py::ssize_t size = x.itemsize();
  if (x.dtype().equal(y.dtype()) && x.dtype().equal(z.dtype()) && begins(y) - begins(x) == size &&
      begins(z) - begins(y) == size) {
    return py::array(x.dtype(), {flat.shape(0), py::ssize_t{3}}, {flat.strides(0), size}, x.data(),
                     flat);
  }
  const py::module_ numpy = py::module_::import("numpy");
  return py::array(numpy.attr("stack")(py::make_tuple(x, y, z), "axis"_a = -1));
}

/// (N, 3) or wider, if that is what the array is.
std::optional<py::array> rows_of(const py::array& array, bool from_list) {
  if (!array.dtype().attr("names").is_none()) return columns_of_records(array);
  if (array.ndim() == 1 && array.shape(0) == 3) return reshaped(array, 1, 3);
  if (array.ndim() == 1 && array.shape(0) == 0 && from_list) return reshaped(array, 0, 3);
  if (array.ndim() != 2 && array.ndim() != 3) return std::nullopt;
  const py::ssize_t columns = array.shape(array.ndim() - 1);
  if (columns < 3 || columns > kMostColumns) return std::nullopt;
  if (array.ndim() == 2) return array;
  return reshaped(array, array.shape(0) * array.shape(1), columns);
}

/// Whether a view of floats or doubles can read the array as it is.
template <typename Number>
bool readable(const py::array& rows) {
  const py::ssize_t size = sizeof(Number);
  if (!py::isinstance<py::array_t<Number>>(rows) || rows.strides(1) != size) return false;
  if (reinterpret_cast<std::uintptr_t>(rows.data()) % size != 0) return false;
  return rows.shape(0) < 2 || (rows.strides(0) >= 3 * size && rows.strides(0) % size == 0);
}

template <typename Number>
py::array copied(const py::array& rows) {
  const py::slice all(std::nullopt, std::nullopt, std::nullopt);
  const py::array xyz = rows[py::make_tuple(all, py::slice(0, 3, 1))];
  return py::array_t<Number, py::array::c_style | py::array::forcecast>(xyz);
}

}  // namespace

py::array as_array(py::handle value) {
  const py::array array = py::array::ensure(value);
  if (!array || !hides_some(value)) return array;
  if (array.dtype().kind() == 'f') {
    return value.attr("filled")(std::numeric_limits<double>::quiet_NaN());
  }
  if (!array.dtype().attr("names").is_none() && has_xyz(array)) return unmasked_records(value);
  return null_array();
}

std::string described(py::handle value) {
  if (has_dtype(value) && py::hasattr(value, "shape")) {
    return "an array of shape " + py::str(value.attr("shape")).cast<std::string>() + " and dtype " +
           py::str(value.attr("dtype")).cast<std::string>() +
           (hides_some(value) ? ", partly masked" : "");
  }
  const py::array array = value.is_none() ? null_array() : py::array::ensure(value);
  if (array && is_real(array.dtype())) {
    return "numbers of shape " + py::str(array.attr("shape")).cast<std::string>();
  }
  return "an object of type " + py::str(py::type::of(value).attr("__name__")).cast<std::string>();
}

py::array points_array(py::handle value, const std::string& name, Numbers numbers) {
  const py::array array = as_array(value);
  if (!array) refuse(value, name, numbers);
  const bool from_list = !has_dtype(value);
  const std::optional<py::array> rows = rows_of(array, from_list);
  if (!rows) refuse(value, name, numbers);
  if (readable<double>(*rows) || readable<float>(*rows)) return *rows;
  const py::dtype dtype = rows->dtype();
  const bool fits = numbers == Numbers::Real || from_list ? is_real(dtype) : is_floating(dtype);
  if (!fits) refuse(value, name, numbers);
  return dtype.kind() == 'f' && dtype.itemsize() == 4 ? copied<float>(*rows)
                                                      : copied<double>(*rows);
}

ltp::PointsView view_of(const py::array& points) {
  const py::ssize_t rows = points.shape(0);
  const py::ssize_t stride = rows < 2 ? 3 : points.strides(0) / points.itemsize();
  if (points.itemsize() == sizeof(float)) {
    return ltp::PointsView(static_cast<const float*>(points.data()), rows, stride);
  }
  return ltp::PointsView(static_cast<const double*>(points.data()), rows, stride);
}

ltp::Point point_from(py::handle value) {
  const py::array array = as_array(value);
  const bool three = array && (array.ndim() == 1 || (array.ndim() == 2 && array.shape(1) == 1)) &&
                     array.shape(0) == 3;
  if (!three || !(is_real(array.dtype()) || array.dtype().kind() == 'b')) {
    throw py::type_error("expected a point, three real numbers of shape (3,), got " +
                         described(value));
  }
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  return Eigen::Map<const ltp::Point>(numbers.data());
}

}  // namespace bindings
