# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from GeoTIFF rasters: surface model, terrain model, canopy heights and land classes."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass, land_class
from ltp.world.world import Datum, World

from ..limits import OBJECT_HEIGHT
from . import holes
from .align import alignment, onto, onto_codes
from .coarsen import coarsen
from .frame import check_heights_agree, heights_report
from .raster import PathLike, TiffRaster, read_raster

_MOST_CODES = 8  # named in a sentence

ClassTable = Mapping[int, LandClass | str | int]


def read(
    *,
    dsm: PathLike,
    dem: PathLike,
    canopy: PathLike | None = None,
    classes: PathLike | None = None,
    class_table: ClassTable | None = None,
    cell: float | None = None,
    align: bool = False,
    convert_heights: bool = False,
    name: str = "",
    attribution: str = "",
    vertical: str = "as in the rasters",
) -> World:
    """Read a world from rasters that share one metric, axis-parallel grid.

    Args:
        dsm: heights of ground and buildings above the height datum [m], with or without trees.
        dem: heights of the bare ground above the same datum [m].
        canopy: heights of the tree crowns **above the ground** [m], 0 where there is no tree.
        classes: land-class codes; `class_table` gives each code in it a meaning.
        class_table: code -> LandClass, its name in any case, or its number.
        cell: cell size of the world [m], a multiple of that of the rasters; default: theirs.
        align: bring rasters that lie on another grid, in another CRS even, onto that of `dsm`:
            heights by bilinear interpolation (finer canopies by the highest), classes by nearest.
        convert_heights: scale heights that a file says are in feet, or another unit, to metres;
            else it is refused.
        name: name of the world; default: the file name of `dsm`.
        attribution: the line that must stand beside every picture.
        vertical: name of the height datum.

    Returns:
        A world whose surface is the highest of `dsm`, `dem` + `canopy` and `dem`. Crowns above 2 m
        are TREES unless over a BUILDING. Without `classes`, what stands above 2 m is a BUILDING
        and the rest UNKNOWN, as it may be water. Cells without a height in `dsm` or `dem`, and
        blocks of a fill value whose no-data tag was lost (`fills`), are interpolated and UNKNOWN;
        `report` says how many and why.

    Raises:
        ImportError: if rasterio is not installed.
        ValueError: naming the file and what is wrong with it.
        OSError: if a file cannot be opened.
    """
    table = _check_table(class_table, classes)
    surface_model = read_raster(dsm, convert_heights=convert_heights)
    grid, report = surface_model.grid, [surface_model.frame.report, *surface_model.report]
    frames = {surface_model.path: surface_model.frame}

    def read_beside(path: PathLike, heights: bool = True) -> TiffRaster:
        raster = read_raster(
            path,
            like=surface_model,
            heights=heights,
            align=align,
            convert_heights=convert_heights,
        )
        if heights:
            frames[raster.path] = raster.frame
            check_heights_agree(frames)
        report.extend([*raster.report, *alignment(raster, surface_model)])
        return raster

    raster = read_beside(dem)
    ground = onto(surface_model, raster, holes.terrain(raster))
    top = holes.surface(surface_model, ground)
    report += [*top.report, *ground.report]
    crowns = np.zeros_like(ground.heights)
    no_canopy = np.zeros(crowns.shape, dtype=bool)
    if canopy is not None:
        raster = read_beside(canopy)
        layer = onto(surface_model, raster, holes.canopy(raster), peaks=True)
        crowns, no_canopy = layer.heights, layer.unknown
        report += layer.report

    surface = np.maximum(np.maximum(top.heights, ground.heights + crowns), ground.heights)
    if classes is not None:
        codes = read_beside(classes, heights=False)
        kinds, told = _translate(codes, table)
        kinds = onto_codes(surface_model, codes, kinds)
        report += told
    else:
        built = top.heights - ground.heights > OBJECT_HEIGHT
        kinds = np.where(built, LandClass.BUILDING, LandClass.UNKNOWN).astype(np.uint8)
        report.append(
            "warning: no land classes were given (classes, --classes): what stands above "
            f"{OBJECT_HEIGHT:g} m is BUILDING, all open ground is UNKNOWN, as it may be water, and "
            "nobody lands there"
        )
    kinds[no_canopy & (kinds != LandClass.BUILDING)] = LandClass.UNKNOWN
    kinds[(crowns > OBJECT_HEIGHT) & (kinds != LandClass.BUILDING)] = LandClass.TREES
    unknown = ground.unknown | top.unknown
    kinds[unknown] = LandClass.UNKNOWN
    if unknown.any():
        report.append(
            f"holes: {np.count_nonzero(unknown):,} of {unknown.size:,} cells "
            f"({100.0 * unknown.mean():.2g} %) have no sure height in dsm or dem; they are "
            "UNKNOWN, with heights interpolated from around, and nobody lands there"
        )

    factor = _factor(cell, grid.cell)
    ground_heights = ground.heights
    if factor > 1:
        ground_heights, surface, kinds = coarsen(
            ground_heights, surface, kinds, factor, unknown | no_canopy
        )
    return World(
        name=name or Path(dsm).stem,
        ground=ground_heights,
        surface=surface,
        classes=kinds,
        cell=grid.cell * factor,
        datum=Datum(grid.crs, grid.xmin, grid.ymin, vertical),
        attribution=attribution,
        report=(*report, *heights_report(frames)),
    )


def _check_table(table: ClassTable | None, classes: PathLike | None) -> dict[int, LandClass]:
    if (table is None) != (classes is None):
        raise ValueError("classes and class_table go together: codes mean nothing by themselves")
    return {int(code): land_class(kind) for code, kind in (table or {}).items()}


def _translate(
    raster: TiffRaster, table: Mapping[int, LandClass]
) -> tuple[NDArray[np.uint8], list[str]]:
    """The class of each cell, and a sentence for each class."""
    kinds = np.full(raster.values.shape, LandClass.UNKNOWN, dtype=np.uint8)
    present = ~raster.missing & np.isfinite(raster.values)
    of_kind: dict[LandClass, list[str]] = {}
    codes, counts = np.unique(raster.values[present], return_counts=True)
    for code, count in zip(codes, counts, strict=True):
        if code not in table:
            raise ValueError(
                f"{raster.path} holds code {code:g} in {count} cells, class_table names only "
                f"{sorted(table)}; add {code:g}=unknown, or what it means"
            )
        kind = table[int(code)]
        kinds[present & (raster.values == code)] = kind
        of_kind.setdefault(kind, []).append(f"{code:g}")
    report = []
    for kind, names in of_kind.items():
        few = ", ".join(names[:_MOST_CODES]) + (", ..." if len(names) > _MOST_CODES else "")
        n = np.count_nonzero(present & (kinds == kind))
        plural = "code {} is" if len(names) == 1 else "codes {} are"
        report.append(f"{raster.path.name}: {plural.format(few)} {kind.name}: {n:,} cells")
    if not present.all():
        n = np.count_nonzero(~present)
        report.append(f"{raster.path.name}: {n:,} cells without a code are UNKNOWN")
    return kinds, report


def _factor(cell: float | None, native: float) -> int:
    """How many cells of the rasters make one of the world, along each axis."""
    if cell is None:
        return 1
    ratio = cell / native if np.isfinite(cell) else 0.0
    factor = round(ratio)
    if factor < 1 or abs(ratio - factor) > 1e-6:
        raise ValueError(f"cell must be a multiple of the rasters' {native:g} m, not {cell!r}")
    return factor
