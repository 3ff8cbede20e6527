# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
# Generated from the compiled module by `make stub`; do not edit.
"""
The compiled core of ltp. World frame: ENU, metres, z up.
"""
from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import os
import typing
__all__: list[str] = ['AraOptions', 'BezierOptions', 'Budget', 'ConcurrentTrajectoryPlanner', 'Decision', 'ExactOptions', 'Front', 'Gate', 'GridFrame', 'HeightSurface', 'HermiteOptions', 'InsertStatistics', 'Lidar', 'LidarOptions', 'LidarPattern', 'LinearisedOptions', 'LocalTrajectoryPlanner', 'NavigationOptions', 'NavigationReason', 'NavigationStatus', 'ObstacleMap', 'ObstacleMapOptions', 'OccupancyGrid', 'OctreeSurface', 'PathTally', 'PenaltyWeights', 'Plan', 'PlanRecord', 'PlanStatus', 'Planner', 'PlannerInfo', 'PlannerOptions', 'Pose', 'Query', 'Raster', 'RayHit', 'RiskOptions', 'Scan', 'ScanStatistics', 'Scene', 'SearchStats', 'Surface', 'TangentBugOptions', 'WaypointEvent', 'closest_point', 'distance_field', 'flood_fill', 'inflate', 'onto_columns', 'pareto_front', 'path_length', 'penalty', 'planner_info', 'planners', 'point_at', 'resample', 'tally']
class Pose:
    """
    Where a body is and how it is turned (world ENU, body x forward, y left, z up).
    """
    def __init__(self, position: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], *, yaw: typing.SupportsFloat | typing.SupportsIndex = 0.0, pitch: typing.SupportsFloat | typing.SupportsIndex = 0.0, roll: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        position: (3,) [m]. yaw, pitch, roll: turns about z, y, x, applied in this order [rad].
        """
    def __repr__(self) -> str:
        ...
    @property
    def position(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), world [m]
        """
    @property
    def rotation(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        (3, 3), world from body
        """
class GridFrame:
    """
    Where a grid of box-shaped cells lies in the world. Cell (i, j, k) covers
    [origin + (i, j, k) * cell, + cell); a point on a face belongs to the upper cell.
    """
    __hash__: typing.ClassVar[None] = None
    def __eq__(self, other: GridFrame) -> bool:
        ...
    def __init__(self, origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], cell: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], dims: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        """
        origin: (3,) lowest corner [m]. cell: (3,) edges [m]. dims: cells along x, y, z.
        """
    def __repr__(self) -> str:
        ...
    def cell_of(self, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[3, 1]"]:
        """
        (3,) int: the cell that holds a point [m]; may lie outside.
        """
    def centre(self, cell: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,): the centre of a cell, world [m]. cell: three integers.
        """
    def contains(self, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> bool:
        """
        Whether a point (3,) [m] lies inside the grid.
        """
    def shifted(self, by: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> GridFrame:
        """
        The same lattice, its window moved by whole cells (three integers). ValueError beyond 10^9 cells.
        """
    @property
    def cell(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), edges of a cell [m]
        """
    @property
    def dims(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        """
        cells along x, y, z
        """
    @property
    def origin(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), lowest corner, world [m]
        """
    @property
    def upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), highest corner, world [m]
        """
class Raster:
    """
    A scalar field over the ground - heights [m] or priority in [0, 1] - constant on each
    square cell: cell (i, j) covers [origin + (i, j) * cell, + cell); axis 0 is x (east).
    """
    def __init__(self, values: numpy.ndarray, origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"] = ..., cell: typing.SupportsFloat | typing.SupportsIndex = 1.0, outside: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        values: (nx, ny), finite. origin: (2,) outer corner of cell (0, 0) [m]. cell: edge [m].
        outside: the value beyond the edges. ValueError names what is wrong.
        """
    def __repr__(self) -> str:
        ...
    def at(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], y: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Any:
        """
        Value of the cell that holds (x, y) [m]; vectorised.
        """
    def bilinear(self, x: typing.Annotated[numpy.typing.ArrayLike, numpy.float64], y: typing.Annotated[numpy.typing.ArrayLike, numpy.float64]) -> typing.Any:
        """
        Bilinear interpolation between cell centres; vectorised.
        """
    def integral(self, a: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> float:
        """
        Exact integral of the field along the segment a-b, (3,) each, over its 3-D length [m].
        """
    @property
    def cell(self) -> float:
        """
        edge of a cell [m]
        """
    @property
    def origin(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,), outer corner of cell (0, 0) [m]
        """
    @property
    def outside(self) -> float:
        """
        value beyond the edges
        """
    @property
    def shape(self) -> tuple[int, int]:
        ...
    @property
    def values(self) -> numpy.ndarray:
        """
        (nx, ny) float64, a read-only view
        """
class OccupancyGrid:
    """
    Which cells are blocked, one bit a cell. A cell never set is free.
    """
    __hash__: typing.ClassVar[None] = None
    @staticmethod
    def from_array(blocked: numpy.ndarray, frame: GridFrame) -> OccupancyGrid:
        """
        blocked: bool (nx, ny, nz), the frame's dims. TypeError for another dtype.
        """
    def __eq__(self, other: OccupancyGrid) -> bool:
        ...
    def __init__(self, frame: GridFrame) -> None:
        """
        An empty grid.
        """
    def __repr__(self) -> str:
        ...
    def blocked_at(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"]) -> numpy.typing.NDArray[numpy.bool]:
        """
        bool (N,): whether the cells that hold points (N, 3) [m] are blocked; False outside.
        """
    def count(self) -> int:
        """
        Number of blocked cells.
        """
    def first_blocked(self, path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], from_arc_length: typing.SupportsFloat | typing.SupportsIndex = 0.0, ignored: typing.Annotated[numpy.typing.ArrayLike, numpy.int32, "[3, 1]"] | None = None) -> float | None:
        """
        Arc length [m] at which a path (N, 3) first touches a blocked cell, exactly; None if it touches none. The
        cell `ignored` (3,) counts as free.
        """
    def roll(self, shift: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        """
        Moves the window by whole cells (three integers); what leaves is forgotten, what enters is free. ValueError for a grid that belongs to a map.
        """
    def to_array(self) -> numpy.typing.NDArray[numpy.bool]:
        """
        A dense copy, bool (nx, ny, nz).
        """
    @property
    def columns(self) -> numpy.ndarray:
        """
        uint64 (nx, ny, words), a read-only view without a copy: bit k of word w of a column is
        level 64 w + k.
        """
    @property
    def frame(self) -> GridFrame:
        ...
class PenaltyWeights:
    """
    W_L and W_P of Eq. (5).
    """
    __fields__: typing.ClassVar[tuple] = ('length', 'priority')
    def __copy__(self) -> PenaltyWeights:
        ...
    def __deepcopy__(self, memo: dict) -> PenaltyWeights:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def length(self) -> float:
        """
        W_L, of the length over the direct length; >= 0
        """
    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def priority(self) -> float:
        """
        W_P, of the mean priority along the path; >= 0
        """
    @priority.setter
    def priority(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class PathTally:
    """
    The two integrals along a path that Eq. (5) is made of.
    """
    __fields__: typing.ClassVar[tuple] = ('length', 'priority')
    def __init__(self, *, length: typing.SupportsFloat | typing.SupportsIndex = 0.0, priority: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def length(self) -> float:
        """
        L, Eq. (2) [m]
        """
    @property
    def mean_priority(self) -> float:
        """
        -Eq. (4), in [0, 1]
        """
    @property
    def priority(self) -> float:
        """
        integral of the priority along the path, Eq. (4) [m]
        """
class RayHit:
    """
    Where a ray first meets a surface.
    """
    def __repr__(self) -> str:
        ...
    @property
    def hit(self) -> bool:
        """
        whether there is one
        """
    @property
    def inside(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), the point hit, moved 1 mm into the solid through the face hit; NaN: no hit
        """
    @property
    def range(self) -> float:
        """
        from the ray's origin [m]; inf: no hit
        """
class Surface:
    """
    Something that a ray can hit.
    """
    def cast(self, origin: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], direction: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], max_range: typing.SupportsFloat | typing.SupportsIndex) -> RayHit:
        """
        The first hit nearer than max_range [m] of the ray from origin (3,) along the unit vector
        direction (3,). A ray that starts inside the solid hits at range 0.
        """
    def cast_rays(self, origins: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], directions: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], max_range: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        """
        (N,): ranges [m] of the rays from origins (N, 3) [m] along the unit vectors directions (N, 3);
        inf: no hit nearer than max_range [m]. Neighbours with the same origin are cast
        together, a thousand or more of them several times faster.
        """
    def clearance(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], max_distance: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        """
        (N,): distance [m] from points (N, 3) to the solid, 0 inside it, at most
        max_distance.
        """
    def first_collision(self, path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"]) -> float | None:
        """
        Arc length [m] at which a path (N, 3) first touches the solid, exactly along its
        segments; None if it never does. Grazing a top or a wall touches it.
        """
class HeightSurface(Surface):
    """
    The exact surface of a height raster: each cell is a solid column from below everything up
    to its height. Outside the raster there is nothing.
    """
    def __init__(self, heights: Raster) -> None:
        """
        heights: above the datum [m].
        """
    def __repr__(self) -> str:
        ...
    def occupancy(self, frame: GridFrame) -> OccupancyGrid:
        """
        OccupancyGrid of the cells that hold any of the solid: what a perfect and complete sensor
        would map.
        """
    @property
    def heights(self) -> Raster:
        ...
class OctreeSurface(Surface):
    """
    The occupied voxels of an OctoMap octree, as bricks of bits; rays are walked exactly. The
    bounding box may have any size; ValueError if voxels lie so scattered that they would take
    more than 1 GiB.
    """
    @typing.overload
    def __init__(self, path: os.PathLike | str | bytes) -> None:
        """
        Reads a .bt or .ot file. ValueError names the file and what is wrong with it.
        """
    @typing.overload
    def __init__(self, points: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], resolution: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Voxels of edge resolution [m], 1e-6 to 1e6, that hold points (N, 3) [m].
        """
    def __repr__(self) -> str:
        ...
    @property
    def memory(self) -> int:
        """
        of the bricks and what is above them [bytes]
        """
    @property
    def resolution(self) -> float:
        """
        edge of a voxel [m]
        """
    @property
    def size(self) -> int:
        """
        occupied voxels
        """
    @property
    def voxels(self) -> OccupancyGrid:
        """
        OccupancyGrid over their bounding box, made when it is first asked for; ValueError if
        the box has 2^31 voxels or more
        """
class LidarPattern:
    """
    The rays of one revolution, in the sensor's frame (x forward, y left, z up).
    """
    __fields__: typing.ClassVar[tuple] = ('azimuths', 'azimuth_from_deg', 'azimuth_to_deg', 'rows', 'elevation_from_deg', 'elevation_to_deg')
    def __copy__(self) -> LidarPattern:
        ...
    def __deepcopy__(self, memo: dict) -> LidarPattern:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def azimuth_from_deg(self) -> float:
        """
        first azimuth, counter-clockwise from x [deg]
        """
    @azimuth_from_deg.setter
    def azimuth_from_deg(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def azimuth_to_deg(self) -> float:
        """
        last azimuth; a full circle stops one step short [deg]
        """
    @azimuth_to_deg.setter
    def azimuth_to_deg(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def azimuths(self) -> int:
        """
        rays a row, evenly over the range, >= 1
        """
    @azimuths.setter
    def azimuths(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def elevation_from_deg(self) -> float:
        """
        lowest row, and the only one if rows = 1; > -90 [deg]
        """
    @elevation_from_deg.setter
    def elevation_from_deg(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def elevation_to_deg(self) -> float:
        """
        highest row; < 90 [deg]
        """
    @elevation_to_deg.setter
    def elevation_to_deg(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rows(self) -> int:
        """
        rows, evenly over the range, both ends, >= 1
        """
    @rows.setter
    def rows(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class LidarOptions:
    """
    Settings of the LiDAR.
    """
    __fields__: typing.ClassVar[tuple] = ('pattern', 'min_range', 'max_range', 'range_noise_sd', 'drop_out', 'seed')
    def __copy__(self) -> LidarOptions:
        ...
    def __deepcopy__(self, memo: dict) -> LidarOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def drop_out(self) -> float:
        """
        probability that a return is lost, in [0, 1]
        """
    @drop_out.setter
    def drop_out(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_range(self) -> float:
        """
        a return at or beyond it is no return [m]
        """
    @max_range.setter
    def max_range(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_range(self) -> float:
        """
        a return nearer than it is no return, nor a miss [m]
        """
    @min_range.setter
    def min_range(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pattern(self) -> LidarPattern:
        """
        which rays
        """
    @pattern.setter
    def pattern(self, arg0: LidarPattern) -> None:
        ...
    @property
    def range_noise_sd(self) -> float:
        """
        standard deviation of a range [m]
        """
    @range_noise_sd.setter
    def range_noise_sd(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def seed(self) -> int:
        """
        of noise and drop-out
        """
    @seed.setter
    def seed(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class ScanStatistics:
    """
    What became of a scan's rays; the counts add up to all of them.
    """
    __fields__: typing.ClassVar[tuple] = ('hits', 'misses', 'too_near', 'invalid', 'dropped')
    def __repr__(self) -> str:
        ...
    @property
    def dropped(self) -> int:
        """
        returns lost to drop-out
        """
    @property
    def hits(self) -> int:
        """
        returns between the minimum and the maximum range
        """
    @property
    def invalid(self) -> int:
        """
        NaN, 0, negative or -inf
        """
    @property
    def misses(self) -> int:
        """
        no return: +inf, or at or beyond the maximum range
        """
    @property
    def too_near(self) -> int:
        """
        returns nearer than the minimum range
        """
class Scan:
    """
    One revolution of a LiDAR, in the world frame.
    """
    def __repr__(self) -> str:
        ...
    @property
    def hits(self) -> numpy.ndarray:
        """
        (N, 3), end points of the returns [m]; a read-only view
        """
    @property
    def misses(self) -> numpy.ndarray:
        """
        (M, 3), where rays without a return end, at the maximum range [m]; a read-only view; empty if only counted
        """
    @property
    def origin(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), of all its rays [m]
        """
    @property
    def statistics(self) -> ScanStatistics:
        ...
class Lidar:
    """
    A scanning LiDAR. May be used from several threads at once.
    """
    def __init__(self, options: LidarOptions = ...) -> None:
        """
        ValueError names the option that is wrong.
        """
    def __repr__(self) -> str:
        ...
    def from_ranges(self, ranges: typing.Any, pose: Pose) -> Scan:
        """
        The scan that a real sensor's ranges (azimuths * rows,) or (azimuths, rows) [m] mean, in the
        order of directions; float32 or float64. NaN, 0, negative and -inf are invalid; what is nearer than
        the minimum range is too near; +inf and anything at or beyond the maximum range is a miss.
        """
    def scan(self, surface: Surface, pose: Pose, sequence: typing.SupportsInt | typing.SupportsIndex = 0, *, misses: bool = True) -> Scan:
        """
        Scans a surface. sequence numbers the scan: noise differs from scan to scan and repeats from
        run to run. misses=False only counts the misses, which saves about half of the time.
        """
    @property
    def directions(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (azimuths * rows, 3), unit vectors in the sensor frame: azimuth by azimuth, rows ascending; a
        read-only view
        """
    @property
    def options(self) -> LidarOptions:
        ...
class ObstacleMapOptions:
    """
    Settings of the obstacle map.
    """
    __fields__: typing.ClassVar[tuple] = ('cell', 'dims', 'inflation_radius', 'margin', 'inflate_whole_cells', 'max_range', 'blind_distance', 'body_min', 'body_max', 'remember', 'carve_free_space', 'keep_hits', 'hit_log_odds', 'miss_log_odds', 'min_log_odds', 'max_log_odds')
    def __copy__(self) -> ObstacleMapOptions:
        ...
    def __deepcopy__(self, memo: dict) -> ObstacleMapOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def blind_distance(self) -> float:
        """
        a hit nearer than this to the scan's origin marks nothing [m]: the aircraft itself, or a sensor's own place written for no return; 0: any hit counts
        """
    @blind_distance.setter
    def blind_distance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def body_max(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), its highest corner [m]; the same as body_min: no box
        """
    @body_max.setter
    def body_max(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @property
    def body_min(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), lowest corner of a box about a scan's pose, in its frame, or the world's if only an origin is given [m]: hits in it mark nothing
        """
    @body_min.setter
    def body_min(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @property
    def carve_free_space(self) -> bool:
        """
        learn from what rays passed, too
        """
    @carve_free_space.setter
    def carve_free_space(self, arg0: bool) -> None:
        ...
    @property
    def cell(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), edges of a planning cell [m], multiples of the smallest one
        """
    @cell.setter
    def cell(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        ...
    @property
    def dims(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        """
        planning cells along x, y, z
        """
    @dims.setter
    def dims(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        ...
    @property
    def hit_log_odds(self) -> float:
        """
        added to a voxel by a hit, > 0
        """
    @hit_log_odds.setter
    def hit_log_odds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def inflate_whole_cells(self) -> bool:
        """
        measure from whole occupied cells, not from the voxels in them: blocks more where cells are higher than wide
        """
    @inflate_whole_cells.setter
    def inflate_whole_cells(self, arg0: bool) -> None:
        ...
    @property
    def inflation_radius(self) -> float:
        """
        the vehicle's radius [m]: a cell within it, and the margin, of an occupied voxel is blocked
        """
    @inflation_radius.setter
    def inflation_radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def keep_hits(self) -> bool:
        """
        only with carving: rays that pass an occupied voxel say nothing about it
        """
    @keep_hits.setter
    def keep_hits(self, arg0: bool) -> None:
        ...
    @property
    def margin(self) -> float:
        """
        added to inflation_radius [m], for errors of pose, range and path keeping
        """
    @margin.setter
    def margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_log_odds(self) -> float:
        """
        clamping, > 0
        """
    @max_log_odds.setter
    def max_log_odds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_range(self) -> float:
        """
        a hit at or beyond this distance from the scan's origin marks nothing [m]
        """
    @max_range.setter
    def max_range(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def min_log_odds(self) -> float:
        """
        clamping, < 0
        """
    @min_log_odds.setter
    def min_log_odds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def miss_log_odds(self) -> float:
        """
        added by a ray that passes, < 0
        """
    @miss_log_odds.setter
    def miss_log_odds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def remember(self) -> bool:
        """
        keep what leaves the window, without limit: it is there again when the window comes back
        """
    @remember.setter
    def remember(self, arg0: bool) -> None:
        ...
class InsertStatistics:
    """
    What became of a scan's points, and of the map.
    """
    __fields__: typing.ClassVar[tuple] = ('marked', 'too_near', 'in_body', 'outside', 'out_of_range', 'invalid', 'new_cells', 'erased_cells')
    def __repr__(self) -> str:
        ...
    def warnings(self, options: ObstacleMapOptions) -> list[str]:
        """
        Sentences: in which ways a map of these ObstacleMapOptions loses more hits than it should - to max_range and
        the window's edges (0.1 % of the hits), to blind_distance (any), to the body box (a tenth). [] if all is well.
        """
    @property
    def erased_cells(self) -> int:
        """
        planning cells that became free by carving
        """
    @property
    def in_body(self) -> int:
        """
        hits in the body box: ignored
        """
    @property
    def invalid(self) -> int:
        """
        hits or misses that are not finite: ignored
        """
    @property
    def marked(self) -> int:
        """
        hits that fell into the window
        """
    @property
    def new_cells(self) -> int:
        """
        planning cells that became occupied
        """
    @property
    def out_of_range(self) -> int:
        """
        hits at or beyond the map's maximum range: treated as misses; many of them, and the sensor sees
        farther than the map was told
        """
    @property
    def outside(self) -> int:
        """
        hits beyond the window: kept for when it comes there, if the map remembers and does not carve
        """
    @property
    def too_near(self) -> int:
        """
        hits nearer than the blind distance: ignored
        """
class ObstacleMap:
    """
    What the sensor has touched round the UAV. Voxels are the memory, planning cells the view: a cell is
    occupied if any voxel in it is, blocked if its box is within inflation_radius + margin of an occupied voxel's
    box. Use a map from one thread at a time. The map of a planner is read-only: what would change it raises
    ValueError.
    """
    def __init__(self, options: ObstacleMapOptions = ..., centre: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...) -> None:
        """
        centre: (3,), of the window, world [m]. ValueError names the option that is wrong.
        """
    def __repr__(self) -> str:
        ...
    def clear(self) -> None:
        """
        Forgets everything.
        """
    def insert(self, origin: Pose | typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], hits: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], misses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"] | None = None) -> InsertStatistics:
        """
        Adds a scan: where its rays began, (3,) or a Pose whose attitude turns the body box; where they hit and, for
        carving, where those without a return ended; world [m]. Clouds are float32 or float64 of any layout: (N, 3) or
        wider (columns x, y, z first), organised (H, W, 3) or wider, or with fields x, y, z; C-ordered ones are not
        copied. Points that are not finite, too near, in the body, out of range or outside the window are counted, never
        an error. Returns InsertStatistics.
        """
    def load(self, path: os.PathLike | str | bytes) -> None:
        """
        Adds what a `.bt` or `.ot` file of the same voxel size knows (with `remember` off: about the window). ValueError
        names the file; the map then stays as it was.
        """
    def log_odds_at(self, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> float:
        """
        Log-odds of the voxel at a point (3,) [m], in the window or remembered; 0 where nothing is known.
        """
    def recentre(self, centre: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> typing.Annotated[numpy.typing.NDArray[numpy.int32], "[3, 1]"]:
        """
        Centres the window on a point (3,) [m]. Cells that enter are as they were when they left; with `remember` off
        what leaves is forgotten. Returns the shift in cells, (3,) int.
        """
    def remembered(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3), centres of all occupied voxels of the mission, in the window and beyond [m]; with `remember` off, of
        the window.
        """
    def save(self, path: os.PathLike | str | bytes) -> None:
        """
        Writes the whole mission (with `remember` off: the window) as OctoMap's `.bt` (occupied or free) or `.ot`
        (log-odds), atomically.
        """
    @property
    def blocked(self) -> OccupancyGrid:
        """
        the same, inflated: what planners get; a view that follows the map
        """
    @property
    def mission_bytes(self) -> int:
        """
        what the memory of the mission takes, roughly [bytes]
        """
    @property
    def occupied(self) -> OccupancyGrid:
        """
        planning cells with a hit in them; a view that follows the map
        """
    @property
    def options(self) -> ObstacleMapOptions:
        ...
    @property
    def totals(self) -> InsertStatistics:
        """
        InsertStatistics, the sum over all scans since the map was made
        """
    @property
    def version(self) -> int:
        """
        grows, from 0, whenever planning cells become occupied, blocked or free: by a scan, a file or `clear`
        """
    @property
    def voxel_size(self) -> float:
        """
        edge of a voxel [m]
        """
    @property
    def voxels(self) -> OccupancyGrid:
        """
        occupied voxels; a view that follows the map
        """
class Scene:
    """
    What a planner may look at: obstacles and priority. Keeps both alive.
    """
    def __init__(self, occupancy: OccupancyGrid, priority: Raster) -> None:
        ...
    def __repr__(self) -> str:
        ...
class Gate:
    """
    A waypoint with the region in which it is served: an upright cylinder.
    """
    __fields__: typing.ClassVar[tuple] = ('point', 'radius', 'height')
    def __init__(self, point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], radius: typing.SupportsFloat | typing.SupportsIndex = 0.0, height: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    @property
    def height(self) -> float:
        """
        above and below the point [m]
        """
    @property
    def point(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), world [m]
        """
    @property
    def radius(self) -> float:
        """
        horizontally [m]; 0: the cell of the point
        """
class Query:
    """
    From where to where, and how far the path may leave the altitudes between.
    """
    def __init__(self, start: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], goal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], band: tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex] = ..., gate_radius: typing.SupportsFloat | typing.SupportsIndex = 0.0, gate_height: typing.SupportsFloat | typing.SupportsIndex = 0.0, then: collections.abc.Sequence[Gate] = []) -> None:
        """
        start, goal: (3,), world [m]. band: (below, above), how far the path may go under the lower and over the
        higher of both ends [m], >= 0; (0, 0) is planar flight, the default is open to the whole window. gate_radius, gate_height: of the region about the goal in which it is served [m], >= 0; the path ends
        where it enters; radius 0: at the point itself. then: the Gates after it, planned jointly; the path passes them in
        order, and L_direct is the way through all their points.
        """
    def __repr__(self) -> str:
        ...
    @property
    def band(self) -> tuple[float, float]:
        ...
    @property
    def direct_length(self) -> float:
        """
        L_direct of Eq. (3) [m]
        """
    @property
    def gate_height(self) -> float:
        ...
    @property
    def gate_radius(self) -> float:
        ...
    @property
    def goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        ...
    @property
    def start(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        ...
    @property
    def then(self) -> list[Gate]:
        ...
class PlanStatus:
    """
    How a plan ended.

    Members:

      FOUND

      OUTSIDE_MAP : start or goal lies beyond the window

      START_BLOCKED

      GOAL_BLOCKED

      UNREACHABLE : proved: no free path exists on this grid

      NONE_FOUND : gave up without proof

      OUT_OF_BUDGET : the caller's limit was reached first
    """
    FOUND: typing.ClassVar[PlanStatus]
    GOAL_BLOCKED: typing.ClassVar[PlanStatus]
    NONE_FOUND: typing.ClassVar[PlanStatus]
    OUTSIDE_MAP: typing.ClassVar[PlanStatus]
    OUT_OF_BUDGET: typing.ClassVar[PlanStatus]
    START_BLOCKED: typing.ClassVar[PlanStatus]
    UNREACHABLE: typing.ClassVar[PlanStatus]
    __members__: typing.ClassVar[dict[str, PlanStatus]]
    def __bool__(self) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: PlanStatus) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __int__(self) -> int:
        ...
    @typing.overload
    def __ne__(self, other: PlanStatus) -> bool:
        ...
    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class SearchStats:
    """
    What a search did.
    """
    __fields__: typing.ClassVar[tuple] = ('expanded', 'pushed', 'seconds')
    def __repr__(self) -> str:
        ...
    @property
    def expanded(self) -> int:
        """
        cells (or curves) examined
        """
    @property
    def pushed(self) -> int:
        """
        entries that went into the open list
        """
    @property
    def seconds(self) -> float:
        """
        wall time [s]
        """
class Plan:
    """
    A planner's answer.
    """
    __fields__: typing.ClassVar[tuple] = ('status', 'tally', 'penalty', 'bound', 'priority_resampled', 'stats')
    def __repr__(self) -> str:
        ...
    @property
    def bound(self) -> float | None:
        """
        no path through vertices of cells has a smaller penalty (a refined one may); None without a proof
        """
    @property
    def passed(self) -> list[float]:
        """
        where along the path each waypoint is passed, arc lengths [m]; fewer than asked for where a later one is
        blocked, unreachable or beyond the window; empty unless FOUND
        """
    @property
    def path(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3), start ... goal, world [m]; empty unless FOUND
        """
    @property
    def penalty(self) -> float:
        """
        Eq. (5); inf unless FOUND
        """
    @property
    def priority_resampled(self) -> bool:
        """
        the priority was off the grid's columns: planned and tallied over `ltp.onto_columns` of it
        """
    @property
    def stats(self) -> SearchStats:
        """
        what the search did
        """
    @property
    def status(self) -> PlanStatus:
        """
        how it ended
        """
    @property
    def tally(self) -> PathTally:
        """
        length and priority integral of the path
        """
class Front:
    """
    The paths of which none is both shorter and over better ground.
    """
    __fields__: typing.ClassVar[tuple] = ('status', 'priority_resampled', 'stats')
    def __repr__(self) -> str:
        ...
    @property
    def paths(self) -> list[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]]:
        """
        k arrays (N, 3), start ... goal, world [m]
        """
    @property
    def priority_resampled(self) -> bool:
        """
        as in `Plan`
        """
    @property
    def stats(self) -> SearchStats:
        """
        what the search did
        """
    @property
    def status(self) -> PlanStatus:
        """
        how it ended
        """
    @property
    def tallies(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]"]:
        """
        (k, 2): length and priority integral of each path [m], by rising length; empty unless FOUND
        """
class BezierOptions:
    """
    The Bezier planner's exhaustive search.
    """
    __fields__: typing.ClassVar[tuple] = ('offsets', 'reach', 'z_offsets', 'z_reach', 'segments')
    def __copy__(self) -> BezierOptions:
        ...
    def __deepcopy__(self, memo: dict) -> BezierOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def offsets(self) -> int:
        """
        M, offsets tried for each control point; odd
        """
    @offsets.setter
    def offsets(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reach(self) -> float:
        """
        largest sideways offset [m]
        """
    @reach.setter
    def reach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def segments(self) -> int:
        """
        straight pieces of the curve
        """
    @segments.setter
    def segments(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def z_offsets(self) -> int:
        """
        offsets tried in height; odd
        """
    @z_offsets.setter
    def z_offsets(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def z_reach(self) -> float:
        """
        largest offset in height [m]
        """
    @z_reach.setter
    def z_reach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class LinearisedOptions:
    """
    The searches of `additive`, `sweep` and `auto`.
    """
    __fields__: typing.ClassVar[tuple] = ('alpha', 'tolerance', 'searches', 'effort', 'whole_first', 'remember', 'closing')
    def __copy__(self) -> LinearisedOptions:
        ...
    def __deepcopy__(self, memo: dict) -> LinearisedOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def alpha(self) -> float:
        """
        of the first search; 0: from the weights
        """
    @alpha.setter
    def alpha(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def closing(self) -> int:
        """
        labels and cells that may be spent on closing the gap that is left (`auto`: none)
        """
    @closing.setter
    def closing(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def effort(self) -> int:
        """
        expansions that may be spent, see `whole_first`; 0: no limit (`auto`: 20,000)
        """
    @effort.setter
    def effort(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def remember(self) -> bool:
        """
        begins with the slope at the last path to the same goal
        """
    @remember.setter
    def remember(self, arg0: bool) -> None:
        ...
    @property
    def searches(self) -> int:
        """
        at most (`additive`: one)
        """
    @searches.setter
    def searches(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        of Eq. (5): ends when path and bound are this close
        """
    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def whole_first(self) -> bool:
        """
        `effort` counts from the first path on: that search is never cut
        """
    @whole_first.setter
    def whole_first(self, arg0: bool) -> None:
        ...
class ExactOptions:
    """
    The exact search of `exact`, and the Pareto front's.
    """
    __fields__: typing.ClassVar[tuple] = ('memory', 'eps')
    def __copy__(self) -> ExactOptions:
        ...
    def __deepcopy__(self, memo: dict) -> ExactOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def eps(self) -> float:
        """
        Eq. (5) + W_P p_max may be this part above its optimum
        """
    @eps.setter
    def eps(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def memory(self) -> float:
        """
        for its labels; needing more is OUT_OF_BUDGET [MB]
        """
    @memory.setter
    def memory(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class AraOptions:
    """
    The weights of `ara-star`.
    """
    __fields__: typing.ClassVar[tuple] = ('first_weight', 'step')
    def __copy__(self) -> AraOptions:
        ...
    def __deepcopy__(self, memo: dict) -> AraOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def first_weight(self) -> float:
        """
        of the heuristic in the first round, 1 to 100
        """
    @first_weight.setter
    def first_weight(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def step(self) -> float:
        """
        by which it falls from round to round, to 1; >= 0.01
        """
    @step.setter
    def step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class RiskOptions:
    """
    The cost of `risk-a-star`.
    """
    __fields__: typing.ClassVar[tuple] = ('length_factor')
    def __copy__(self) -> RiskOptions:
        ...
    def __deepcopy__(self, memo: dict) -> RiskOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def length_factor(self) -> float:
        """
        what a metre costs beside its risk (0 to 1 a metre); > 0
        """
    @length_factor.setter
    def length_factor(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class TangentBugOptions:
    """
    The sensor of `tangent-bug`.
    """
    __fields__: typing.ClassVar[tuple] = ('range')
    def __copy__(self) -> TangentBugOptions:
        ...
    def __deepcopy__(self, memo: dict) -> TangentBugOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def range(self) -> float:
        """
        how far it sees [m], >= 0; 0: only what it touches
        """
    @range.setter
    def range(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class HermiteOptions:
    """
    The optimised curve of `hermite`.
    """
    __fields__: typing.ClassVar[tuple] = ('segments', 'starts', 'reach', 'refined', 'iterations')
    def __copy__(self) -> HermiteOptions:
        ...
    def __deepcopy__(self, memo: dict) -> HermiteOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def iterations(self) -> int:
        """
        rounds of the optimisation of each
        """
    @iterations.setter
    def iterations(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reach(self) -> float:
        """
        the largest of them, in direct lengths
        """
    @reach.setter
    def reach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def refined(self) -> int:
        """
        the best so many of those curves are optimised
        """
    @refined.setter
    def refined(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def segments(self) -> int:
        """
        straight pieces of the curve
        """
    @segments.setter
    def segments(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def starts(self) -> int:
        """
        sideways tangents tried at each end to begin with; odd
        """
    @starts.setter
    def starts(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class PlannerOptions:
    """
    What every planner can be told.
    """
    __fields__: typing.ClassVar[tuple] = ('weights', 'scaled_heuristic', 'refine', 'bezier', 'linearised', 'exact', 'ara', 'risk', 'tangent_bug', 'hermite')
    def __copy__(self) -> PlannerOptions:
        ...
    def __deepcopy__(self, memo: dict) -> PlannerOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def ara(self) -> AraOptions:
        """
        of `ara-star`
        """
    @ara.setter
    def ara(self, arg0: AraOptions) -> None:
        ...
    @property
    def bezier(self) -> BezierOptions:
        """
        of `bezier`
        """
    @bezier.setter
    def bezier(self, arg0: BezierOptions) -> None:
        ...
    @property
    def bug(self) -> typing.Any:
        """
        The old name of `tangent_bug`.
        """
    @bug.setter
    def bug(self, arg1: typing.Any) -> None:
        ...
    @property
    def exact(self) -> ExactOptions:
        """
        of `exact`
        """
    @exact.setter
    def exact(self, arg0: ExactOptions) -> None:
        ...
    @property
    def hermite(self) -> HermiteOptions:
        """
        of `hermite`
        """
    @hermite.setter
    def hermite(self, arg0: HermiteOptions) -> None:
        ...
    @property
    def length_weight(self) -> typing.Any:
        """
        The old name of `weights.length`.
        """
    @length_weight.setter
    def length_weight(self, arg1: typing.Any) -> None:
        ...
    @property
    def linearised(self) -> LinearisedOptions:
        """
        of `additive`, `sweep` and `auto`
        """
    @linearised.setter
    def linearised(self, arg0: LinearisedOptions) -> None:
        ...
    @property
    def pareto(self) -> typing.Any:
        """
        The old name of `exact`.
        """
    @pareto.setter
    def pareto(self, arg1: typing.Any) -> None:
        ...
    @property
    def priority_weight(self) -> typing.Any:
        """
        The old name of `weights.priority`.
        """
    @priority_weight.setter
    def priority_weight(self, arg1: typing.Any) -> None:
        ...
    @property
    def refine(self) -> bool:
        """
        free the path from the grid's directions; never a larger penalty
        """
    @refine.setter
    def refine(self, arg0: bool) -> None:
        ...
    @property
    def risk(self) -> RiskOptions:
        """
        of `risk-a-star`
        """
    @risk.setter
    def risk(self, arg0: RiskOptions) -> None:
        ...
    @property
    def scaled_heuristic(self) -> bool:
        """
        multiply Eq. (9) by W_L, which it lacks as printed
        """
    @scaled_heuristic.setter
    def scaled_heuristic(self, arg0: bool) -> None:
        ...
    @property
    def tangent_bug(self) -> TangentBugOptions:
        """
        of `tangent-bug`
        """
    @tangent_bug.setter
    def tangent_bug(self, arg0: TangentBugOptions) -> None:
        ...
    @property
    def weights(self) -> PenaltyWeights:
        """
        W_L and W_P of Eq. (5)
        """
    @weights.setter
    def weights(self, arg0: PenaltyWeights) -> None:
        ...
class Budget:
    """
    What one plan may spend. A search that reaches a limit ends with OUT_OF_BUDGET, or with the best
    path that it has.
    """
    __fields__: typing.ClassVar[tuple] = ('max_expansions', 'time_limit')
    def __copy__(self) -> Budget:
        ...
    def __deepcopy__(self, memo: dict) -> Budget:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def max_expansions(self) -> int:
        """
        cells, curves or labels examined, >= 0; 0: no limit
        """
    @max_expansions.setter
    def max_expansions(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def time_limit(self) -> float:
        """
        wall time [s], >= 0; 0: no limit
        """
    @time_limit.setter
    def time_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class PlannerInfo:
    """
    What a planner is: a row of the registry.
    """
    __fields__: typing.ClassVar[tuple] = ('name', 'title', 'family', 'complete', 'on_grid', 'anytime', 'remembers', 'uses_priority', 'bounds', 'regions', 'horizon')
    def __repr__(self) -> str:
        ...
    @property
    def anytime(self) -> bool:
        """
        out of budget, it answers with the best path so far
        """
    @property
    def bounds(self) -> bool:
        """
        proves a lower bound of Eq. (5)
        """
    @property
    def complete(self) -> bool:
        """
        its UNREACHABLE proves that no path exists
        """
    @property
    def family(self) -> str:
        """
        'paper': of the paper's tables; 'ours'; 'baseline': of other authors, to compare with
        """
    @property
    def horizon(self) -> bool:
        """
        plans several waypoints jointly; others go leg by leg
        """
    @property
    def name(self) -> str:
        """
        by which it is made
        """
    @property
    def on_grid(self) -> bool:
        """
        its paths run through vertices of cells
        """
    @property
    def regions(self) -> bool:
        """
        its goal is a whole region; others are given one cell of it
        """
    @property
    def remembers(self) -> bool:
        """
        an answer may depend on what was asked before
        """
    @property
    def title(self) -> str:
        """
        as tables print it
        """
    @property
    def uses_priority(self) -> bool:
        """
        the priority map shapes its paths
        """
class Planner:
    """
    A local planner; made by `make_planner`.
    """
    def __init__(self, name: str, options: PlannerOptions = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def front(self, scene: Scene, query: Query, eps: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> Front:
        """
        Deprecated: `ltp.pareto_front`.
        """
    def plan(self, scene: Scene, query: Query, budget: Budget = ...) -> Plan:
        """
        Plans a path. Lets other threads run; Ctrl-C interrupts it. ValueError for a query that is not finite and for
        a negative limit.
        """
    @property
    def complete(self) -> bool:
        """
        whether its failure proves that no path exists
        """
    @property
    def info(self) -> PlannerInfo:
        """
        its row of the registry
        """
    @property
    def name(self) -> str:
        ...
class NavigationOptions:
    """
    When a waypoint is reached, a path left, a height allowed.
    """
    __fields__: typing.ClassVar[tuple] = ('band', 'climb', 'reach_distance', 'leave_distance', 'escape_distance', 'gate_radius', 'gate_height', 'horizon', 'max_expansions', 'time_limit', 'max_detour', 'fly_route')
    def __copy__(self) -> NavigationOptions:
        ...
    def __deepcopy__(self, memo: dict) -> NavigationOptions:
        ...
    def __init__(self, **kwargs) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def band_from(self, start: typing.SupportsFloat | typing.SupportsIndex, highest: typing.SupportsFloat | typing.SupportsIndex) -> tuple[float, float]:
        """
        The band (below, above) of a leg that begins at an altitude and whose highest waypoint lies at another [m].
        """
    def check(self) -> None:
        """
        Raises `ValueError` that names the field.
        """
    @property
    def band(self) -> tuple[float, float]:
        """
        (below, above): how far to leave the altitudes of UAV and waypoint [m]; (0, 0) is planar flight
        """
    @band.setter
    def band(self, arg1: tuple[typing.SupportsFloat | typing.SupportsIndex, typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def climb(self) -> float:
        """
        how far above the highest waypoint of a leg the UAV may rise, however high it is by now [m]; 0: `band`'s second number
        """
    @climb.setter
    def climb(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def escape_distance(self) -> float:
        """
        how far to look for a free cell when standing in a blocked one [m]
        """
    @escape_distance.setter
    def escape_distance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fly_route(self) -> bool:
        """
        where the planner finds no path and a way is known, fly the shortest one instead of holding
        """
    @fly_route.setter
    def fly_route(self, arg0: bool) -> None:
        ...
    @property
    def gate_height(self) -> float:
        """
        the same, up and down [m]; 0: one cell
        """
    @gate_height.setter
    def gate_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def gate_radius(self) -> float:
        """
        a waypoint but the last is served within it, horizontally [m]; 0: it is a point, see `reach_distance`
        """
    @gate_radius.setter
    def gate_radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def horizon(self) -> int:
        """
        waypoints that are planned jointly, >= 1
        """
    @horizon.setter
    def horizon(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def leave_distance(self) -> float:
        """
        farther from its path the UAV has left it [m]; 0: one horizontal cell diagonal
        """
    @leave_distance.setter
    def leave_distance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_detour(self) -> float:
        """
        a waypoint that would cost more metres than the shortest way to it that was known at first, by so many, is skipped as too far [m]; 0: none is
        """
    @max_detour.setter
    def max_detour(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def max_expansions(self) -> int:
        """
        of a plan, see `Budget`; 0: no limit
        """
    @max_expansions.setter
    def max_expansions(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def memory_widths(self) -> int:
        """
        Without effect.
        """
    @memory_widths.setter
    def memory_widths(self, arg1: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reach_distance(self) -> float:
        """
        a waypoint is reached within it, horizontally [m]; 0: one horizontal cell diagonal
        """
    @reach_distance.setter
    def reach_distance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def time_limit(self) -> float:
        """
        of a plan, see `Budget` [s]; 0: no limit
        """
    @time_limit.setter
    def time_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class NavigationStatus:
    """
    What the local trajectory planner is doing.

    Members:

      FINISHED : no waypoint is left

      FOLLOWING : there is a path to follow

      ESCAPING : leaving a blocked cell by the nearest free one

      HOLDING : no path and no proof: stay
    """
    ESCAPING: typing.ClassVar[NavigationStatus]
    FINISHED: typing.ClassVar[NavigationStatus]
    FOLLOWING: typing.ClassVar[NavigationStatus]
    HOLDING: typing.ClassVar[NavigationStatus]
    __members__: typing.ClassVar[dict[str, NavigationStatus]]
    def __bool__(self) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: NavigationStatus) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __int__(self) -> int:
        ...
    @typing.overload
    def __ne__(self, other: NavigationStatus) -> bool:
        ...
    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def label(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def value(self) -> int:
        ...
class NavigationReason:
    """
    Why a UAV holds or escapes, or why a waypoint was dropped.

    Members:

      NONE :

      UNDECIDED : nothing has been planned yet

      START_BLOCKED : the UAV stands too near to what was hit and leaves by the nearest free cell

      START_IN_GROUND : start in the ground's cell: the UAV is less than a free cell above what lies beneath it, and no free cell is near

      NO_ESCAPE : the UAV stands too near to what was hit, and no free cell can be reached

      WALLED_IN : the UAV is walled in by its own map

      OUT_OF_BUDGET : the planner's budget ran out before it found a path

      NO_PATH : no path was found, and no proof that there is none

      GOAL_BLOCKED : the waypoint lies in a blocked cell of the map

      UNREACHABLE : the waypoint is proved unreachable: all around it is closed

      TOO_FAR : the waypoint is too far: the way to it is longer than the largest detour allows

      ALL_DROPPED : all waypoints were dropped, none was reached
    """
    ALL_DROPPED: typing.ClassVar[NavigationReason]
    GOAL_BLOCKED: typing.ClassVar[NavigationReason]
    NONE: typing.ClassVar[NavigationReason]
    NO_ESCAPE: typing.ClassVar[NavigationReason]
    NO_PATH: typing.ClassVar[NavigationReason]
    OUT_OF_BUDGET: typing.ClassVar[NavigationReason]
    START_BLOCKED: typing.ClassVar[NavigationReason]
    START_IN_GROUND: typing.ClassVar[NavigationReason]
    TOO_FAR: typing.ClassVar[NavigationReason]
    UNDECIDED: typing.ClassVar[NavigationReason]
    UNREACHABLE: typing.ClassVar[NavigationReason]
    WALLED_IN: typing.ClassVar[NavigationReason]
    __members__: typing.ClassVar[dict[str, NavigationReason]]
    def __bool__(self) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: NavigationReason) -> bool:
        ...
    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...
    def __getstate__(self) -> int:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __int__(self) -> int:
        ...
    @typing.overload
    def __ne__(self, other: NavigationReason) -> bool:
        ...
    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    def __str__(self) -> str:
        ...
    @property
    def label(self) -> str:
        ...
    @property
    def name(self) -> str:
        ...
    @property
    def text(self) -> str:
        """
        a plain sentence without its full stop; empty for NONE
        """
    @property
    def value(self) -> int:
        ...
class WaypointEvent:
    """
    What became of a waypoint.
    """
    __fields__: typing.ClassVar[tuple] = ('index', 'reached', 'reason', 'why', 'position', 'goal', 'distance', 'window_origin', 'route')
    def __repr__(self) -> str:
        ...
    @property
    def distance(self) -> float:
        """
        from the UAV to the waypoint [m]
        """
    @property
    def goal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), the waypoint [m]
        """
    @property
    def index(self) -> int:
        """
        of the waypoint, from 0
        """
    @property
    def position(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), of the UAV [m]
        """
    @property
    def reached(self) -> bool:
        """
        True: reached; False: dropped
        """
    @property
    def reason(self) -> PlanStatus:
        """
        why it was dropped: GOAL_BLOCKED or UNREACHABLE, on proof; NONE_FOUND: it was too far
        """
    @property
    def route(self) -> int:
        """
        counts the calls of `set_waypoints`: by which it was given, from 1
        """
    @property
    def why(self) -> NavigationReason:
        """
        the same as a reason with a text; NONE: reached
        """
    @property
    def window_origin(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), of the map's window [m]
        """
class PlanRecord:
    """
    One answer of the planner.
    """
    __fields__: typing.ClassVar[tuple] = ('waypoint', 'direct_length', 'plan')
    def __repr__(self) -> str:
        ...
    @property
    def direct_length(self) -> float:
        """
        L_direct of the query [m]; with a horizon of all its legs
        """
    @property
    def plan(self) -> Plan:
        """
        the answer
        """
    @property
    def way_point(self) -> typing.Any:
        """
        The old name of `waypoint`.
        """
    @property
    def waypoint(self) -> int:
        """
        for which it was asked
        """
class LocalTrajectoryPlanner:
    """
    The loop that flies: waypoints, scans and poses in; plan and status out. Replans when the path is
    blocked, left, or its waypoint retired; drops a waypoint only on proof.
    """
    def __init__(self, priority: Raster, position: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], *, planner: str = 'auto', planner_options: PlannerOptions = ..., map_options: ObstacleMapOptions = ..., options: NavigationOptions = ...) -> None:
        """
        priority: Raster in [0, 1]. position: (3,) [m]. planner: one of `ltp.PLANNERS`.
        """
    def __repr__(self) -> str:
        ...
    def clear_map(self) -> None:
        """
        Forgets all obstacles, those beyond the window too; the next update plans on it.
        """
    def load_map(self, path: os.PathLike | str | bytes) -> None:
        """
        Adds what a `.bt` or `.ot` file knows, as ObstacleMap.load does: of an earlier mission, say. The next update plans
        on it, beyond the window too (unless the map's `remember` is off).
        """
    def sense(self, origin: Pose | typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], hits: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], misses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"] | None = None) -> InsertStatistics:
        """
        Adds a scan: where its rays began, (3,) or a Pose whose attitude turns the map's body box; where they hit and,
        for carving, where those without a return ended; world [m]. Clouds as ObstacleMap.insert takes them.
        """
    def set_planner(self, planner: str = 'auto', *, planner_options: PlannerOptions = ..., keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Another planner, from the next update on. Map and waypoints stay.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def set_priority(self, priority: Raster, keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Another Raster in [0, 1], from the next update on.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def set_way_points(self, way_points: typing.Any) -> None:
        """
        The old name of `set_waypoints`.
        """
    def set_waypoints(self, waypoints: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], gates: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]", "flags.c_contiguous"] = ...) -> None:
        """
        Replaces what is left of the global path; (N, 3), world [m]. gates: (N, 2), radius and height in which each is served
        [m], 0: within `reach_distance`, one cell; default: those of the options.
        """
    def set_weights(self, weights: PenaltyWeights, keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Other weights of Eq. 5, by the same planner made anew, from the next update on. Map and waypoints stay.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def take_events(self) -> list[WaypointEvent]:
        """
        What became of waypoints, each told once: also of waypoints that were replaced since, see WaypointEvent.route.
        """
    def update(self, position: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> NavigationStatus:
        """
        Decides what to do at a position (3,) [m].
        """
    @property
    def events(self) -> list[WaypointEvent]:
        """
        reached and dropped waypoints, in order
        """
    @property
    def events_count(self) -> int:
        ...
    @property
    def map(self) -> ObstacleMap:
        """
        a read-only view: see `load_map` and `clear_map`
        """
    @property
    def path(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3), the path to follow [m]
        """
    @property
    def path_id(self) -> int:
        """
        as long as it stands, so does `path`
        """
    @property
    def plans(self) -> list[PlanRecord]:
        """
        the planner's answers when it was last asked
        """
    @property
    def plans_made(self) -> int:
        """
        since the beginning
        """
    @property
    def reason(self) -> NavigationReason:
        """
        why it holds or escapes; NONE: it does not
        """
    @property
    def status(self) -> NavigationStatus:
        ...
    @property
    def way_point_index(self) -> typing.Any:
        """
        The old name of `waypoint_index`.
        """
    @property
    def way_points(self) -> typing.Any:
        """
        The old name of `waypoints`.
        """
    @property
    def waypoint_index(self) -> int:
        """
        the waypoint flown to
        """
    @property
    def waypoints(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        ...
class Decision:
    """
    What the planning thread decided on one scan's map.
    """
    __fields__: typing.ClassVar[tuple] = ('scan', 'status', 'reason', 'path', 'path_id', 'waypoint_index', 'events', 'plans', 'plans_made')
    def __repr__(self) -> str:
        ...
    @property
    def events(self) -> list[WaypointEvent]:
        """
        reached and dropped waypoints, in order
        """
    @property
    def path(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        """
        (N, 3), the path to follow [m]
        """
    @property
    def path_id(self) -> int:
        """
        as long as it stands, so does `path`
        """
    @property
    def plans(self) -> list[PlanRecord]:
        """
        the planner's answers when it was last asked
        """
    @property
    def plans_made(self) -> int:
        """
        since the beginning
        """
    @property
    def reason(self) -> NavigationReason:
        """
        why it holds or escapes
        """
    @property
    def scan(self) -> int:
        """
        number of the last scan that it knows, from 1; 0: none yet
        """
    @property
    def status(self) -> NavigationStatus:
        """
        what to do
        """
    @property
    def way_point_index(self) -> typing.Any:
        """
        The old name of `waypoint_index`.
        """
    @property
    def waypoint_index(self) -> int:
        """
        the waypoint flown to
        """
class ConcurrentTrajectoryPlanner:
    """
    A LocalTrajectoryPlanner whose scans never wait for a plan: it plans on a thread of its own, on snapshots of the
    map. Call it from one thread. If each scan is waited for, it decides as the LocalTrajectoryPlanner does.
    """
    def __init__(self, priority: Raster, position: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], *, planner: str = 'auto', planner_options: PlannerOptions = ..., map_options: ObstacleMapOptions = ..., options: NavigationOptions = ...) -> None:
        """
        As a LocalTrajectoryPlanner's.
        """
    def __repr__(self) -> str:
        ...
    def clear_map(self) -> None:
        """
        As LocalTrajectoryPlanner's; the map is handed over to be planned on at once.
        """
    def load_map(self, path: os.PathLike | str | bytes) -> None:
        """
        As LocalTrajectoryPlanner's; the map is handed over to be planned on at once.
        """
    def plan(self) -> bool:
        """
        Decides on the newest map, in the calling thread: instead of `start`. Whether there was a new one.
        """
    def sense(self, origin: Pose | typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], hits: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], misses: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"] | None = None) -> InsertStatistics:
        """
        Adds a scan, as LocalTrajectoryPlanner does, and hands the map over to be planned on; the UAV is at its origin.
        """
    def set_planner(self, planner: str = 'auto', *, planner_options: PlannerOptions = ..., keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Another planner, from the next scan on. Map and waypoints stay.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def set_priority(self, priority: Raster, keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Another Raster in [0, 1], from the next scan on.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def set_way_points(self, way_points: typing.Any) -> None:
        """
        The old name of `set_waypoints`.
        """
    def set_waypoints(self, waypoints: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], gates: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 2]", "flags.c_contiguous"] = ...) -> None:
        """
        Replaces what is left of the global path from the next scan on; (N, 3), world [m].
        gates: as LocalTrajectoryPlanner's.
        """
    def set_weights(self, weights: PenaltyWeights, keep_if_within: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        """
        Other weights of Eq. 5, by the same planner made anew, from the next scan on. Map and waypoints stay.
        keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by more than that by Eq. 5, from
        where the UAV is, by the new priority and weights.
        """
    def start(self) -> None:
        """
        Begins the planning thread.
        """
    def stop(self) -> None:
        """
        Ends the planning thread; interrupts a long search.
        """
    def take_events(self) -> list[WaypointEvent]:
        """
        What became of waypoints, each told once: also of waypoints that were replaced since, see WaypointEvent.route.
        """
    def wait(self, seconds: typing.SupportsFloat | typing.SupportsIndex = ...) -> bool:
        """
        Returns when the planning thread has decided on the newest map, or after so long [s]; whether it has. Raises
        what it has raised.
        """
    @property
    def blocked_at(self) -> float | None:
        """
        arc length of the last decision's path at which the newest map blocks it, an escape: at which something was hit [m]; None if it is free
        """
    @property
    def decision(self) -> Decision:
        """
        the newest one
        """
    @property
    def map(self) -> ObstacleMap:
        """
        a read-only view: see `load_map` and `clear_map`
        """
    @property
    def scans(self) -> int:
        """
        sensed so far
        """
    @property
    def way_points(self) -> typing.Any:
        """
        The old name of `waypoints`.
        """
    @property
    def waypoints(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
        ...
def closest_point(path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], point: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], from_arc_length: typing.SupportsFloat | typing.SupportsIndex = 0.0, to_arc_length: typing.SupportsFloat | typing.SupportsIndex = ...) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], float, float]:
    """
    (point (3,), arc length [m], distance [m]) of the closest point of a polyline between two arc lengths.
    """
def distance_field(grid: OccupancyGrid, source: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"], levels: tuple[typing.SupportsInt | typing.SupportsIndex, typing.SupportsInt | typing.SupportsIndex] | None = None) -> numpy.typing.NDArray[numpy.float64]:
    """
    float64 (nx, ny, nz): the length of the shortest path [m] from the centre of the cell that holds a point to the
    centre of every cell, by the planners' 26 steps; inf where none leads. That cell counts as free itself. source:
    (3,), world [m]. levels: (lowest, highest), the only ones to use, both included; default: all. ValueError if the
    source is outside the grid or its levels, or these are not the grid's. Lets other threads run; Ctrl-C interrupts it.
    """
def flood_fill(grid: OccupancyGrid, query: Query) -> numpy.typing.NDArray[numpy.bool]:
    """
    bool (nx, ny, nz): the cells that any planner could reach from the query's start within its band, by a flood
    that shares nothing with the planners. ValueError if the start is outside the grid.
    """
def inflate(grid: OccupancyGrid, radius: typing.SupportsFloat | typing.SupportsIndex, parts: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [1, 1, 1]) -> OccupancyGrid:
    """
    The grid with every cell blocked whose box is within `radius` [m] of the box of a blocked one: any radius > 0
    adds at least the 26 neighbours, 0 none. With `parts`, so many of the given grid's cells along each edge make one
    of the result's. ValueError unless its dims, and where its window begins, are multiples.
    """
def onto_columns(raster: Raster, frame: GridFrame) -> Raster:
    """
    The raster with one value over each column of a grid: the mean over the column's area. It covers the grid and has
    the same value outside. Columns that are no squares are several cells of it. Planners do so with a priority that is
    off their grid's columns (`Plan.priority_resampled`). ValueError where the columns' edges have no common part, down
    to a sixteenth of the longer one.
    """
def pareto_front(scene: Scene, query: Query, options: ExactOptions = ..., budget: Budget = ...) -> Front:
    """
    All paths of which none is both shorter (L) and over better ground (R = p_max L - P, p_max the largest priority in
    the window, P the priority integral). With options.eps, for each path one of them has at most (1 + eps) times its
    L and its R. OUT_OF_BUDGET where memory or budget end. ValueError for a query that is not finite and for a wrong
    option. Lets other threads run; Ctrl-C interrupts it.
    """
def path_length(path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"]) -> float:
    """
    Length of a polyline, path: (N, 3) [m].
    """
@typing.overload
def penalty(tally: PathTally, direct_length: typing.SupportsFloat | typing.SupportsIndex, weights: PenaltyWeights = ...) -> float:
    """
    Eq. (5): weights.length * L / direct_length - weights.priority * mean priority.
    """
@typing.overload
def penalty(tally: PathTally, direct_length: typing.SupportsFloat | typing.SupportsIndex, length_weight: typing.SupportsFloat | typing.SupportsIndex = 0.5, priority_weight: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> float:
    """
    Deprecated: give `weights`.
    """
def planner_info(name: str) -> PlannerInfo:
    """
    The planner of a name; an old name warns. ValueError for an unknown one, listing those known.
    """
def planners() -> list[PlannerInfo]:
    """
    All planners, in the order of the paper's tables.
    """
def point_at(path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], arc_length: typing.SupportsFloat | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
    """
    The point (3,) at an arc length [m] of a polyline; clamped to its ends.
    """
def resample(path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], spacing: typing.SupportsFloat | typing.SupportsIndex) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 3]"]:
    """
    Points every `spacing` [m] along a polyline, both ends kept: (M, 3). path: (N, 3), N >= 1 [m].
    """
def tally(path: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 3]"], priority: Raster) -> PathTally:
    """
    Length and priority integral of a path (N, 3) [m]; exact for a priority constant on each cell of its raster.
    """
__version__: str = ...
