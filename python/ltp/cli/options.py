# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments and options that several commands have, each with its help."""

from pathlib import Path
from typing import Annotated

import typer


def _picture(path: Path) -> Path:
    """Refuse what no figure is written to before anything is flown for it."""
    if path.suffix.lower() not in (".png", ".pdf", ".svg"):
        raise ValueError(f"--out must end in .png, .pdf or .svg, not {str(path)!r}")
    return path


WorldArgument = Annotated[
    str,
    typer.Argument(
        metavar="WORLD",
        help="A world file (.npz, see `ltp world import`), or `city` for the built-in one; "
        "`city:7` is the one of seed 7.",
    ),
]
FlightsArgument = Annotated[
    Path, typer.Argument(help="A campaign's folder, or the flights.csv in it.")
]

Processes = Annotated[
    int, typer.Option(help="Number of processes to fly in; 0 is one per processor.")
]

ScenarioIndex = Annotated[
    int, typer.Option("--scenario", help="Index of the global path in the seeded set, from 0.")
]
Planner = Annotated[str, typer.Option(help="Name of the planner.")]
PriorityMap = Annotated[str, typer.Option("--map", help="Priority map: `binary` or `lpf`.")]
PriorityMaps = Annotated[
    str, typer.Option("--maps", help="Priority maps, with commas between: `binary`, `lpf` or both.")
]
PriorityFile = Annotated[
    Path | None,
    typer.Option(
        "--priority",
        help="Priority map to fly with instead of that of the land classes: a GeoTIFF in the "
        "world's CRS or an .npz of values, origin and cell; shares from 0 to 1.",
    ),
]
Ratio = Annotated[float, typer.Option(help="Ratio of the weights, W_P / W_L.")]
Memory = Annotated[float, typer.Option(help="Memory that the exact search may use [MB].")]

ResumedFolder = Annotated[
    Path,
    typer.Option("--out", help="Folder of the results; what it holds already is not done again."),
]
PictureFile = Annotated[
    Path,
    typer.Option("--out", "-o", help="Picture to write: .png, .pdf or .svg.", callback=_picture),
]
InsteadOfPrinting = Annotated[
    Path | None, typer.Option("--out", help="File to write instead of printing.")
]
