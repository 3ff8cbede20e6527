# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure sweep`, `curve`: from a campaign over several ratios of the weights."""

from pathlib import Path
from typing import Annotated

import typer

from .inputs import planner_names, read_flights_over
from .options import FlightsArgument, PictureFile, WorldArgument
from .output import write_figure


def sweep(
    flights: FlightsArgument,
    world: WorldArgument = "city",
    out: PictureFile = Path("out/sweep.png"),
) -> None:
    """Draw mean priority and length ratio over W_P / W_L.

    From a campaign such as `ltp evaluate WORLD --rows none --ratios default`.
    """
    from ltp.evaluation.figures.flights import sweep_figure

    rows, place = read_flights_over(flights, world)
    write_figure(sweep_figure(rows, place.attribution), out)


def curve(
    flights: FlightsArgument,
    world: WorldArgument = "city",
    planners: Annotated[
        str,
        typer.Option(help="Planners to draw, with commas between; by default all that were swept."),
    ] = "",
    out: PictureFile = Path("out/curve.png"),
) -> None:
    """Draw flown length against mean priority, one curve a planner.

    From a campaign such as `ltp evaluate WORLD --rows none --planners lp-dijkstra,sweep --ratios
    default`.
    """
    from ltp.evaluation.figures.curves import curve_figure

    rows, place = read_flights_over(flights, world)
    write_figure(curve_figure(rows, place.attribution, planner_names("--planners", planners)), out)
