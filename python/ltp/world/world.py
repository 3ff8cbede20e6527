# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`World`: ground, obstacle surface and land classes of one place, on one metric frame."""

import os
from collections.abc import Iterable
from dataclasses import asdict, dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.files import blamed_on

from .archive import SOUND, read_fields, write_fields
from .checks import (
    corner,
    finite,
    heights,
    land_classes,
    not_negative,
    positive,
    resolvable,
    sentences,
    text,
    triples,
)
from .classes import LandClass
from .crs import metric_crs
from .geodesy import from_lon_lat, lon_lat
from .shapes import Extent, Shape, checked, extent_of, raise_shapes

if TYPE_CHECKING:
    from ltp._core import Raster

#: Rounding may put the surface this far below the ground [m]; more is a mistake in the data.
SURFACE_TOLERANCE = 1e-6


@dataclass(frozen=True)
class Datum:
    """Where the local frame sits on the Earth."""

    crs: str | None = None  # e.g. "EPSG:27700"; None for a made-up city
    easting: float = 0.0  # CRS coordinate of local x = 0 [m]
    northing: float = 0.0  # CRS coordinate of local y = 0 [m]
    vertical: str = "local"  # name of the height datum; z is the height above it [m]

    def __post_init__(self) -> None:
        if self.crs is not None:
            text("datum.crs", self.crs)
        text("datum.vertical", self.vertical)
        object.__setattr__(self, "easting", finite("datum.easting", self.easting))
        object.__setattr__(self, "northing", finite("datum.northing", self.northing))


@dataclass(frozen=True, eq=False)
class World:
    """A piece of the Earth's surface as rasters over the ground.

    Frame: ENU, metres, z up. Arrays are indexed [ix, iy]: axis 0 = x east, axis 1 = y north. Cell
    (i, j) covers [x0 + i*cell, x0 + (i+1)*cell) x [y0 + j*cell, y0 + (j+1)*cell), (x0, y0) being
    `origin`. A cell is a flat top: everything below its surface is solid. The arrays are checked
    copies, C-contiguous and read-only. Two worlds are equal only if they are the same object.

    Raises:
        ValueError: naming the argument of wrong shape, type or values; also if the surface lies
            more than `SURFACE_TOLERANCE` below the ground anywhere.
    """

    name: str
    ground: NDArray[np.float64]  # (nx, ny) bare ground, height above the datum [m]
    surface: NDArray[np.float64]  # (nx, ny) top of what stands there, trees too, >= ground [m]
    classes: NDArray[np.uint8]  # (nx, ny) LandClass
    cell: float  # edge of a cell [m]
    origin: tuple[float, float] = (0.0, 0.0)  # x, y of the outer corner of cell (0, 0) [m]
    datum: Datum = Datum()
    attribution: str = ""  # line that must stand beside every picture
    report: tuple[str, ...] = ()  # what its import read, guessed and dropped: a sentence each

    def __post_init__(self) -> None:
        text("name", self.name)
        text("attribution", self.attribution)
        if not isinstance(self.datum, Datum):
            raise ValueError(f"datum must be a Datum, not {self.datum!r}")
        ground = heights("ground", self.ground)
        surface = heights("surface", self.surface, ground.shape)
        below = ground - surface
        if below.max() > SURFACE_TOLERANCE:
            i, j = np.unravel_index(int(below.argmax()), below.shape)
            raise ValueError(
                f"surface must not lie below ground: surface[{i}, {j}] = {surface[i, j]:g} m, "
                f"ground[{i}, {j}] = {ground[i, j]:g} m"
            )
        if below.max() > 0.0:
            surface = np.maximum(surface, ground)
        classes = land_classes(self.classes, ground.shape)
        for array in (ground, surface, classes):
            array.setflags(write=False)
        for field, value in (
            ("ground", ground),
            ("surface", surface),
            ("classes", classes),
            ("cell", positive("cell", self.cell)),
            ("origin", corner(self.origin)),
            ("report", sentences("report", self.report)),
        ):
            object.__setattr__(self, field, value)
        resolvable(self.origin, self.cell, ground.shape)

    def __repr__(self) -> str:
        x_cells, y_cells = self.shape
        return (
            f"World({self.name!r}, {x_cells} x {y_cells} cells of {self.cell:g} m, "
            f"{self.datum.crs or 'no CRS'}, ground at {self.ground.min():.1f} ... "
            f"{self.ground.max():.1f} m, top at {self.surface.max():.1f} m)"
        )

    def __reduce__(self) -> tuple[type["World"], tuple[Any, ...]]:
        # Through the constructor: an array that was only unpickled would be writable.
        return World, tuple(getattr(self, field.name) for field in fields(self))

    @property
    def shape(self) -> tuple[int, int]:
        """Cells along x and y."""
        return self.ground.shape[0], self.ground.shape[1]

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(x_min, y_min, x_max, y_max) of the covered area [m]."""
        x, y = self.origin
        return x, y, x + self.shape[0] * self.cell, y + self.shape[1] * self.cell

    @property
    def height_above_ground(self) -> NDArray[np.float64]:
        """(nx, ny) height of the surface above the bare ground [m]; a new array."""
        return np.asarray(self.surface - self.ground)

    def surface_raster(self) -> "Raster":
        """The obstacle surface as a `Raster`: height above the datum [m], one value per cell."""
        return self._raster(self.surface)

    def ground_raster(self) -> "Raster":
        """The bare ground as a `Raster`: height above the datum [m], one value per cell."""
        return self._raster(self.ground)

    def _raster(self, values: NDArray[np.float64]) -> "Raster":
        from ltp._core import Raster

        return Raster(values, origin=self.origin, cell=self.cell)

    def to_map(self, points: ArrayLike) -> NDArray[np.float64]:
        """Where on the Earth local points lie.

        Args:
            points: (N, 3) x, y, z [m], or one of shape (3,).

        Returns:
            Latitude, longitude [degrees, WGS 84] and altitude [m] of each, in the same shape. The
            altitude is z, above the vertical datum (`datum.vertical`), not above the ellipsoid.
            Latitudes are as good as PROJ's transformation from the CRS to WGS 84 is without
            downloaded grids: exact for WGS 84 zones, to some metres for old national datums.
            `to_local` brings them back to a millimetre.

        Raises:
            ImportError: if pyproj is not installed.
            ValueError: naming `points`, also where the CRS does not reach; or if the world has no
                CRS.
        """
        points, crs = triples("points", points), self._crs()
        x, y, z = points[..., 0], points[..., 1], points[..., 2]
        east, north = x + self.datum.easting, y + self.datum.northing
        lon, lat = lon_lat(crs, east, north)
        # Far beyond its area a projection gives any place at all, and does not come back from it.
        east_again, north_again = from_lon_lat(crs, lon, lat)
        if not (np.hypot(east_again - east, north_again - north) < 1.0).all():
            raise ValueError(f"points lie beyond the area of {self.datum.crs}")
        return np.stack([lat, lon, z], axis=-1)

    def to_local(self, places: ArrayLike) -> NDArray[np.float64]:
        """Local points of places on the Earth: the inverse of `to_map`.

        Args:
            places: (N, 3) latitude, longitude [degrees, WGS 84] and altitude [m] above the vertical
                datum, or one of shape (3,).

        Returns:
            x, y, z [m] of each, in the same shape; also where that is outside of the world.

        Raises:
            ImportError: if pyproj is not installed.
            ValueError: naming `places`, or if the world has no CRS.
        """
        places, crs = triples("places", places), self._crs()
        lat, lon, z = places[..., 0], places[..., 1], places[..., 2]
        if (np.abs(lat) > 90.0).any():
            worst = float(lat.flat[np.abs(lat).argmax()])
            raise ValueError(f"places must have latitudes in -90...90, not {worst:g}")
        x, y = from_lon_lat(crs, lon, lat)
        return np.stack([x - self.datum.easting, y - self.datum.northing, z], axis=-1)

    def _crs(self) -> Any:
        if self.datum.crs is None:
            raise ValueError(
                f"{self.name} has no CRS (datum.crs is None): nobody knows where on the Earth it is"
            )
        return metric_crs(self.datum.crs, "datum.crs")

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the world to one compressed .npz, all or nothing; same world, same bytes.

        Raises:
            OSError: if the file cannot be written; whatever stood under `path` is then untouched.
        """
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        write_fields({**values, "datum": asdict(self.datum)}, path)

    @staticmethod
    def from_shapes(
        shapes: Iterable[Shape],
        *,
        size: tuple[float, float] | None = None,
        extent: Extent | None = None,
        margin: float = 50.0,
        cell: float = 1.0,
        ground: float = 0.0,
        land: LandClass | str = LandClass.GRASS,
        name: str = "shapes",
        attribution: str = "",
    ) -> "World":
        """Boxes, cylinders and prisms on flat ground; see also `ltp.world.boxes`.

        A cell that a shape reaches into is as high as the shape; of several, as the highest. What
        reaches beyond the world is cropped.

        Args:
            shapes: each a `Box`, `Cylinder` or `Prism`, its height above the ground.
            size: of the world along x and y, from (0, 0) [m].
            extent: (x_min, y_min, x_max, y_max) instead [m]. Whole cells cover either.
            margin: round the shapes, where neither is given [m].
            cell: edge of a cell [m].
            ground: height of the ground above the datum [m].
            land: class of the ground between the shapes.
            name: of the world.
            attribution: line that must stand beside every picture.

        Raises:
            ValueError: naming the argument that is wrong, or the shape that lies off the world.
        """
        shapes = checked(shapes)
        if size is not None and extent is not None:
            raise ValueError("size and extent must not both be given")
        if size is not None:
            try:
                across, up = size
            except (TypeError, ValueError):
                raise ValueError(f"size must be two lengths (x, y) [m], not {size!r}") from None
            extent = 0.0, 0.0, positive("size[0]", across), positive("size[1]", up)
        elif extent is None:
            extent = extent_of(shapes, not_negative("margin", margin), positive("cell", cell))
        raised = raise_shapes(shapes, extent, cell, ground, land)
        return World(name=name, attribution=attribution, **raised._asdict())

    @staticmethod
    def load(path: str | os.PathLike[str]) -> "World":
        """Read a world that `save` wrote. Nothing in the file is executed, unpickled or trusted.

        Raises:
            OSError: if the file cannot be opened or read.
            ValueError: naming the file and the culprit, if it is not a sound world file.
        """
        values = read_fields(path)
        with blamed_on(path, SOUND):
            return World(**{**values, "datum": Datum(**values["datum"])})
