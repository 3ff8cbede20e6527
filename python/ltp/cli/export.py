# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp export`: flown paths for maps and globes."""

import json
from pathlib import Path
from typing import Annotated

import typer

from .inputs import open_world
from .options import WorldArgument
from .output import tell, write_text

_ENDINGS = (".geojson", ".kml")


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("export")(export)


def export(
    world: WorldArgument,
    records: Annotated[
        list[Path],
        typer.Argument(help="Flight records (.npz), or folders that hold some, of that world."),
    ],
    out: Annotated[
        Path, typer.Option("--out", "-o", help="File to write: .geojson or .kml.")
    ] = Path("out/flights.geojson"),
) -> None:
    """Write flown paths and dropped waypoints as GeoJSON or KML.

    The world must know its CRS, as imported worlds do. Records are what `ltp fly` and `ltp evaluate
    --records` keep.
    """
    from ltp.sim import FlightRecord
    from ltp.sim.export import to_geojson, to_kml

    if out.suffix.lower() not in _ENDINGS:
        raise ValueError(f"--out must end in {' or '.join(_ENDINGS)}, not {str(out)!r}")
    files = [file for path in records for file in _files(path)]
    place = open_world(world)
    flown = [FlightRecord.load(file) for file in files]
    if out.suffix.lower() == ".kml":
        text = to_kml(place, flown)
    else:
        text = json.dumps(to_geojson(place, flown)) + "\n"
    out.parent.mkdir(parents=True, exist_ok=True)
    write_text(text, out)
    tell("flights", out)


def _files(path: Path) -> list[Path]:
    if not path.is_dir():
        return [path]
    if not (found := sorted(path.glob("*.npz"))):
        raise ValueError(f"{path} holds no flight records (.npz)")
    return found
