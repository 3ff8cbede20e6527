# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp world`: import real cities, write the built-in one, draw one."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .app import PoliteGroup
from .common import WorldArgument, console, open_world, tell

if TYPE_CHECKING:
    from ltp.world import World

Out = Annotated[Path, typer.Option("--out", "-o", help="World file to write, .npz.")]
Name = Annotated[str, typer.Option(help="Of the world (default: the file's).")]
Attribution = Annotated[
    str, typer.Option(help="The line that must stand beside every picture of this data.")
]
Vertical = Annotated[str, typer.Option(help="Name of the height datum.")]


def register(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(
        cls=PoliteGroup, help="Import, draw and write worlds.", no_args_is_help=True
    )
    imports = typer.Typer(
        cls=PoliteGroup,
        help='Import a real city into a world file. Needs pip install "ltp\\[geo]".',
        no_args_is_help=True,
    )
    imports.command("geotiff")(import_geotiff)
    imports.command("las")(import_las)
    imports.command("osm")(import_osm)
    group.add_typer(imports, name="import")
    group.command("show")(show)
    group.command("city")(city)
    app.add_typer(group, name="world")


def import_geotiff(
    out: Out,
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
            help="What a code in --classes means, e.g. 4=building; once for each code.",
        ),
    ] = None,
    cell: Annotated[
        float | None, typer.Option(help="Cell size [m] (default: the rasters').")
    ] = None,
    name: Name = "",
    attribution: Attribution = "",
    vertical: Vertical = "as in the rasters",
) -> None:
    """Import GeoTIFF rasters that share one metric grid."""
    from ltp.world import geotiff

    world = geotiff.read(
        dsm=dsm,
        dem=dem,
        canopy=canopy,
        classes=classes,
        class_table=_class_table(meaning or []) if classes is not None else None,
        cell=cell,
        name=name,
        attribution=attribution,
        vertical=vertical,
    )
    _save(world, out)


def import_las(
    file: Annotated[Path, typer.Argument(help="A .las or .laz file with ASPRS classes.")],
    out: Out,
    cell: Annotated[float, typer.Option(help="Cell size [m].")] = 2.0,
    bounds: Annotated[
        tuple[float, float, float, float] | None,
        typer.Option(help="x_min y_min x_max y_max in the CRS, to cut a piece out [m]."),
    ] = None,
    max_gap: Annotated[
        float, typer.Option(help="Wider gaps without returns are unknown ground [m].")
    ] = 8.0,
    crs: Annotated[str | None, typer.Option(help="The CRS, where the file does not say.")] = None,
    name: Name = "",
    attribution: Attribution = "",
    vertical: Vertical = "as in the survey",
) -> None:
    """Import a classified airborne laser survey."""
    from ltp.world import point_cloud

    world = point_cloud.read(
        file,
        cell=cell,
        bounds=bounds,
        max_gap=max_gap,
        crs=crs,
        name=name,
        attribution=attribution,
        vertical=vertical,
    )
    _save(world, out)


def import_osm(
    file: Annotated[Path, typer.Argument(help="An OpenStreetMap extract, .osm.pbf or .osm.")],
    out: Out,
    bounds: Annotated[
        tuple[float, float, float, float],
        typer.Option(help="x_min y_min x_max y_max in the CRS [m]."),
    ],
    crs: Annotated[str, typer.Option(help="A projected CRS in metres, e.g. EPSG:32618.")],
    cell: Annotated[float, typer.Option(help="Cell size [m].")] = 1.0,
    default_height: Annotated[
        float, typer.Option(help="Of a building without any tag that tells its height [m].")
    ] = 10.0,
    name: Name = "",
    attribution: Annotated[
        str | None, typer.Option(help="Instead of the line that OpenStreetMap asks for.")
    ] = None,
) -> None:
    """Import an OpenStreetMap extract."""
    from ltp.world import osm

    line = osm.ATTRIBUTION if attribution is None else attribution
    world = osm.read(
        file,
        bounds=bounds,
        crs=crs,
        cell=cell,
        default_height=default_height,
        name=name,
        attribution=line,
    )
    _save(world, out)


def show(
    world: WorldArgument = "city",
    out: Annotated[Path, typer.Option("--out", "-o", help=".png, .pdf or .svg")] = Path(
        "out/world.png"
    ),
    altitude: Annotated[
        float, typer.Option(help="Of the flight, above ground: sets the camera's footprint [m].")
    ] = 50.0,
) -> None:
    """Draw height, land classes and both priority maps into one picture."""
    from ltp.world.picture import world_picture

    place = open_world(world)
    out.parent.mkdir(parents=True, exist_ok=True)
    world_picture(place, out, altitude)
    tell("picture", out)


def city(
    out: Out = Path("out/city.npz"),
    seed: Annotated[int, typer.Option(help="The same seed gives the same city.")] = 1,
    size: Annotated[float, typer.Option(help="Edge of the square map [m].")] = 1000.0,
    cell: Annotated[float, typer.Option(help="Cell size [m].")] = 1.0,
) -> None:
    """Write the built-in city to a world file."""
    from ltp.world.city import make_city

    _save(make_city(seed=seed, size=size, cell=cell), out)


def _save(world: "World", out: Path) -> None:
    out.parent.mkdir(parents=True, exist_ok=True)
    world.save(out)
    x_min, y_min, x_max, y_max = world.extent
    console.print(
        f"{world.name}: {x_max - x_min:g} m x {y_max - y_min:g} m at {world.cell:g} m, ground at "
        f"{world.ground.min():.1f} ... {world.ground.max():.1f} m, top at "
        f"{world.surface.max():.1f} m",
        markup=False,
    )
    tell("world", out)


def _class_table(meanings: list[str]) -> dict[int, str]:
    table: dict[int, str] = {}
    for text in meanings:
        code, sign, name = text.partition("=")
        if not sign or not code.strip().isdigit():
            raise ValueError(f"--class: expected CODE=CLASS, e.g. 4=building, not {text!r}")
        table[int(code)] = name.strip()
    return table
