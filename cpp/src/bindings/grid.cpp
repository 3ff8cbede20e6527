// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor 1 in Python: frames, rasters, occupancy grids.
#include <pybind11/numpy.h>

#include "bindings.hpp"
#include "borrowed.hpp"
#include "ltp/grid/columns.hpp"
#include "ltp/grid/frame.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"

namespace {

using BoolArray = py::array_t<bool, py::array::c_style>;
/// Cells that come from Python: as an Eigen vector, 0.5 and 2^32 would silently become 0.
using Integers = std::array<int, 3>;

ltp::Cell cell_from(const Integers& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

py::array unmasked(const char* name, const py::array& given) {
  const py::array array = bindings::as_array(given);
  if (!array) {
    throw py::type_error(std::string(name) + ": expected an array without a mask, got " +
                         bindings::described(given));
  }
  return array;
}

ltp::OccupancyGrid from_array(const py::array& given, const ltp::GridFrame& frame) {
  const py::array blocked = unmasked("blocked", given);
  if (!py::isinstance<py::array_t<bool>>(blocked)) {
    throw py::type_error("blocked.dtype = " + py::str(blocked.dtype()).cast<std::string>() +
                         ": expected bool");
  }
  if (blocked.ndim() != 3 || blocked.shape(0) != frame.nx() || blocked.shape(1) != frame.ny() ||
      blocked.shape(2) != frame.nz()) {
    ltp::check::fail("blocked.shape", shape_of(blocked), "the frame's dims, (nx, ny, nz)");
  }
  const BoolArray dense = BoolArray::ensure(blocked);
  // Read as bytes: a view of other data as bool may hold more than 0 and 1.
  const auto* values = static_cast<const std::uint8_t*>(dense.request().ptr);
  const py::gil_scoped_release release;
  ltp::OccupancyGrid grid(frame);
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      std::uint64_t* column = grid.column(ix, iy);
      for (int iz = 0; iz < frame.nz(); ++iz) {
        column[iz >> 6] |= std::uint64_t{*values++ != 0} << (iz & 63);
      }
    }
  }
  return grid;
}

BoolArray to_array(const ltp::OccupancyGrid& grid) {
  const ltp::GridFrame& frame = grid.frame();
  BoolArray dense({frame.nx(), frame.ny(), frame.nz()});
  bool* values = dense.mutable_data();
  const py::gil_scoped_release release;
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      const std::uint64_t* column = grid.column(ix, iy);
      for (int iz = 0; iz < frame.nz(); ++iz) *values++ = column[iz >> 6] >> (iz & 63) & 1u;
    }
  }
  return dense;
}

/// A read-only view of the bit columns that keeps the grid alive.
py::array columns_view(py::object self) {
  const auto& grid = self.cast<const ltp::OccupancyGrid&>();
  py::array_t<std::uint64_t> view({grid.frame().nx(), grid.frame().ny(), grid.words_per_column()},
                                  grid.words().data(), self);
  view.attr("flags").attr("writeable") = false;
  return view;
}

ltp::Raster make_raster(const py::array& given, const Eigen::Vector2d& origin, double cell,
                        double outside) {
  const py::array values = unmasked("values", given);
  if (values.ndim() != 2) ltp::check::fail("values.shape", shape_of(values), "(nx, ny)");
  if (values.dtype().kind() != 'f' && values.dtype().kind() != 'i' &&
      values.dtype().kind() != 'u' && values.dtype().kind() != 'b') {
    throw py::type_error("values.dtype = " + py::str(values.dtype()).cast<std::string>() +
                         ": expected real numbers");
  }
  return ltp::Raster(values.cast<ltp::Raster::Values>(), origin, cell, outside);
}

py::array raster_view(py::object self) {
  const auto& raster = self.cast<const ltp::Raster&>();
  py::array_t<double> view({raster.nx(), raster.ny()}, raster.values().data(), self);
  view.attr("flags").attr("writeable") = false;
  return view;
}

void bind_frame(py::module_& m) {
  py::class_<ltp::GridFrame>(
      m, "GridFrame",
      "Where a grid of box-shaped cells lies in the world. Cell (i, j, k) covers\n"
      "[origin + (i, j, k) * cell, + cell); a point on a face belongs to the upper cell.")
      .def(py::init<const ltp::Point&, const ltp::Point&, const std::array<int, 3>&>(), "origin"_a,
           "cell"_a, "dims"_a,
           "origin: (3,) lowest corner [m]. cell: (3,) edges [m]. dims: cells along x, y, z.")
      .def_property_readonly("origin", &ltp::GridFrame::origin, "(3,), lowest corner, world [m]")
      .def_property_readonly("upper", &ltp::GridFrame::upper, "(3,), highest corner, world [m]")
      .def_property_readonly("cell", &ltp::GridFrame::cell, "(3,), edges of a cell [m]")
      .def_property_readonly("dims", &ltp::GridFrame::dims, "cells along x, y, z")
      .def("cell_of", &ltp::GridFrame::cell_of, "point"_a,
           "(3,) int: the cell that holds a point [m]; may lie outside.")
      .def(
          "centre",
          [](const ltp::GridFrame& frame, const Integers& cell) {
            return frame.centre(cell_from(cell));
          },
          "cell"_a, "(3,): the centre of a cell, world [m]. cell: three integers.")
      .def("contains", py::overload_cast<const ltp::Point&>(&ltp::GridFrame::contains, py::const_),
           "point"_a, "Whether a point (3,) [m] lies inside the grid.")
      .def(
          "shifted",
          [](const ltp::GridFrame& frame, const Integers& by) {
            return frame.shifted(cell_from(by));
          },
          "by"_a,
          "The same lattice, its window moved by whole cells (three integers). ValueError beyond "
          "10^9 cells.")
      .def("__eq__", &ltp::GridFrame::operator==, "other"_a, py::is_operator())
      .def("__repr__", [](const ltp::GridFrame& frame) {
        std::ostringstream text;
        const Eigen::IOFormat row(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "",
                                  "(", ")");
        text << "GridFrame(origin=" << frame.origin().transpose().format(row)
             << ", cell=" << frame.cell().transpose().format(row) << ", dims=(" << frame.nx()
             << ", " << frame.ny() << ", " << frame.nz() << "))";
        return text.str();
      });
}

void bind_raster(py::module_& m) {
  py::class_<ltp::Raster>(
      m, "Raster",
      "A scalar field over the ground - heights [m] or priority in [0, 1] - constant on each\n"
      "square cell: cell (i, j) covers [origin + (i, j) * cell, + cell); axis 0 is x (east).")
      .def(py::init(&make_raster), "values"_a, "origin"_a = Eigen::Vector2d(0, 0), "cell"_a = 1.0,
           "outside"_a = 0.0,
           "values: (nx, ny), finite. origin: (2,) outer corner of cell (0, 0) [m]. cell: edge "
           "[m].\n"
           "outside: the value beyond the edges. ValueError names what is wrong.")
      .def_property_readonly("values", &raster_view, "(nx, ny) float64, a read-only view")
      .def_property_readonly("origin", &ltp::Raster::origin,
                             "(2,), outer corner of cell (0, 0) [m]")
      .def_property_readonly("cell", &ltp::Raster::cell, "edge of a cell [m]")
      .def_property_readonly("outside", &ltp::Raster::outside, "value beyond the edges")
      .def_property_readonly("shape",
                             [](const ltp::Raster& r) { return py::make_tuple(r.nx(), r.ny()); })
      .def("at", py::vectorize(&ltp::Raster::at), "x"_a, "y"_a,
           "Value of the cell that holds (x, y) [m]; vectorised.")
      .def("bilinear", py::vectorize(&ltp::Raster::bilinear), "x"_a, "y"_a,
           "Bilinear interpolation between cell centres; vectorised.")
      .def(
          "integral",
          [](const ltp::Raster& raster, const ltp::Point& a, const ltp::Point& b) {
            ltp::check::finite("a", a);
            ltp::check::finite("b", b);
            return raster.integral(a, b);
          },
          "a"_a, "b"_a,
          "Exact integral of the field along the segment a-b, (3,) each, over its 3-D length [m].");
  m.def("onto_columns", &ltp::onto_columns, "raster"_a, "frame"_a,
        "The raster with one value over each column of a grid: the mean over the column's area. It "
        "covers the grid and has\n"
        "the same value outside. Columns that are no squares are several cells of it. Planners do "
        "so with a priority that is\n"
        "off their grid's columns (`Plan.priority_resampled`). ValueError where the columns' edges "
        "have no common part, down\n"
        "to a sixteenth of the longer one.");
}

void bind_occupancy(py::module_& m) {
  py::class_<ltp::OccupancyGrid>(
      m, "OccupancyGrid", "Which cells are blocked, one bit a cell. A cell never set is free.")
      .def(py::init<const ltp::GridFrame&>(), "frame"_a, "An empty grid.")
      .def_static("from_array", &from_array, "blocked"_a, "frame"_a,
                  "blocked: bool (nx, ny, nz), the frame's dims. TypeError for another dtype.")
      .def("to_array", &to_array, "A dense copy, bool (nx, ny, nz).")
      .def_property_readonly("columns", &columns_view,
                             "uint64 (nx, ny, words), a read-only view without a copy: bit k of "
                             "word w of a column is\n"
                             "level 64 w + k.")
      .def_property_readonly("frame", &ltp::OccupancyGrid::frame, py::return_value_policy::copy)
      .def("count", &ltp::OccupancyGrid::count, "Number of blocked cells.")
      .def(
          "blocked_at",
          [](const ltp::OccupancyGrid& grid, const bindings::Points& points) {
            const bindings::PointsInUse in_use(points, "points", bindings::Numbers::Real);
            py::array_t<bool> out(in_use.view().rows());
            grid.blocked_at(in_use.view(), out.mutable_data());
            return out;
          },
          "points"_a,
          "bool (N,): whether the cells that hold points (N, 3) [m] are blocked; False outside.")
      .def(
          "roll",
          [](ltp::OccupancyGrid& grid, const Integers& shift) { own(grid).roll(cell_from(shift)); },
          "shift"_a,
          "Moves the window by whole cells (three integers); what leaves is forgotten, what enters "
          "is free. ValueError for a grid that belongs to a map.")
      .def(
          "first_blocked",
          [](const ltp::OccupancyGrid& grid, const ltp::PathRef& path, double from_arc_length,
             const std::optional<ltp::Cell>& ignored) {
            require_finite("path", path);
            return grid.first_blocked(path, from_arc_length, ignored);
          },
          "path"_a, "from_arc_length"_a = 0.0, "ignored"_a = py::none(),
          "Arc length [m] at which a path (N, 3) first touches a blocked cell, exactly; None if it "
          "touches none. The\ncell `ignored` (3,) counts as free.")
      .def("__eq__", &ltp::OccupancyGrid::operator==, "other"_a, py::is_operator());
}

}  // namespace

void bind_grid(py::module_& m) {
  bind_frame(m);
  bind_raster(m);
  bind_occupancy(m);
}
