# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp world import`: real cities, from rasters, laser surveys and OpenStreetMap."""

from pathlib import Path
from typing import Annotated

import typer

from ltp.installed import pip_install

from .app import make_group
from .naming import naming
from .saved_world import Cell, WorldFile, save_world

Name = Annotated[str, typer.Option(help="Name of the world; by default the file's.")]
Attribution = Annotated[
    str, typer.Option(help="Line that must stand beside every picture of this data.")
]
Vertical = Annotated[str, typer.Option(help="Name of the height datum.")]
ConvertHeights = Annotated[
    bool,
    typer.Option("--convert-heights", help="Scale heights that are said to be in feet to metres."),
]
Box = tuple[float, float, float, float]
BOUNDS = typer.Option(help="Piece to import: x_min y_min x_max y_max in the CRS [m].")


def register(app: typer.Typer) -> None:
    """Add the commands."""
    group = make_group(
        "import", f"Import a real city into a world file.\n\nNeeds {pip_install('geo')}."
    )
    group.command("geotiff")(import_geotiff)
    group.command("las")(import_las)
    group.command("osm")(import_osm)
    app.add_typer(group)


def import_geotiff(
    out: WorldFile,
    dsm: Annotated[Path, typer.Option(help="Heights of ground and buildings [m].")],
    dem: Annotated[Path, typer.Option(help="Heights of the bare ground [m].")],
    canopy: Annotated[
        Path | None, typer.Option(help="Heights of tree crowns above the ground [m].")
    ] = None,
    classes: Annotated[Path | None, typer.Option(help="Land-class codes.")] = None,
    meaning: Annotated[
        list[str] | None,
        typer.Option(
            "--class",
            metavar="CODE=CLASS",
            help="Meaning of a code in --classes, e.g. 4=building; once for each code.",
        ),
    ] = None,
    cell: Annotated[
        float | None, typer.Option(help="Cell size [m]; by default the rasters'.")
    ] = None,
    align: Annotated[
        bool,
        typer.Option("--align", help="Resample rasters of other grids or CRSs onto that of --dsm."),
    ] = False,
    convert_heights: ConvertHeights = False,
    name: Name = "",
    attribution: Attribution = "",
    vertical: Vertical = "as in the rasters",
) -> None:
    """Import GeoTIFF rasters that share one metric grid."""
    from ltp.world.importers import geotiff

    with naming("cell", "classes", "align", "convert_heights"):
        world = geotiff.read(
            dsm=dsm,
            dem=dem,
            canopy=canopy,
            classes=classes,
            class_table=_class_table(meaning or []) if classes is not None else None,
            cell=cell,
            align=align,
            convert_heights=convert_heights,
            name=name,
            attribution=attribution,
            vertical=vertical,
        )
    save_world(world, out)


def import_las(
    file: Annotated[Path, typer.Argument(help="A .las or .laz file with ASPRS classes.")],
    out: WorldFile,
    cell: Cell = 2.0,
    bounds: Annotated[Box | None, BOUNDS] = None,
    max_gap: Annotated[
        float, typer.Option(help="Widest gap without returns that counts as known ground [m].")
    ] = 8.0,
    crs: Annotated[
        str | None, typer.Option(help="CRS of the survey, where the file does not say.")
    ] = None,
    convert_heights: ConvertHeights = False,
    user_classes: Annotated[
        str,
        typer.Option(
            help="Meaning of the classes 64 to 255, which belong to the producer: `ign` is the "
            "French survey's, `none` nobody's, `auto` what the file says of its origin."
        ),
    ] = "auto",
    meaning: Annotated[
        list[str] | None,
        typer.Option(
            "--class",
            metavar="CODE=CLASS",
            help="Meaning of a class of the survey, e.g. 65=building or 70=noise; once for each.",
        ),
    ] = None,
    name: Name = "",
    attribution: Attribution = "",
    vertical: Vertical = "as in the survey",
) -> None:
    """Import a classified airborne laser survey."""
    from ltp.world.importers import las

    options = ("cell", "bounds", "max_gap", "crs", "convert_heights", "user_classes")
    with naming(*options, class_table="--class"):
        world = las.read(
            file,
            cell=cell,
            bounds=bounds,
            max_gap=max_gap,
            crs=crs,
            convert_heights=convert_heights,
            user_classes=user_classes,
            class_table=_class_table(meaning or []),
            name=name,
            attribution=attribution,
            vertical=vertical,
        )
    save_world(world, out)


def import_osm(
    file: Annotated[Path, typer.Argument(help="An OpenStreetMap extract, .osm.pbf or .osm.")],
    out: WorldFile,
    bounds: Annotated[Box, BOUNDS],
    crs: Annotated[
        str, typer.Option(help="Projected CRS in metres to import into, e.g. EPSG:32618.")
    ],
    cell: Cell = 1.0,
    default_height: Annotated[
        float,
        typer.Option(help="Height of a building without any tag that tells it [m]."),
    ] = 10.0,
    name: Name = "",
    attribution: Annotated[
        str | None,
        typer.Option(help="Line to show instead of the one that OpenStreetMap asks for."),
    ] = None,
) -> None:
    """Import an OpenStreetMap extract."""
    from ltp.world.importers import osm

    line = osm.ATTRIBUTION if attribution is None else attribution
    with naming("cell", "bounds", "crs", "default_height"):
        world = osm.read(
            file,
            bounds=bounds,
            crs=crs,
            cell=cell,
            default_height=default_height,
            name=name,
            attribution=line,
        )
    save_world(world, out)


def _class_table(meanings: list[str]) -> dict[int, str]:
    table: dict[int, str] = {}
    for text in meanings:
        code, sign, name = text.partition("=")
        if not sign or not code.strip().isdecimal():
            raise ValueError(f"--class: expected CODE=CLASS, e.g. 4=building, not {text!r}")
        table[int(code)] = name.strip()
    return table
