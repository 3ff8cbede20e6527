# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp table`: a campaign's tables, from its flights."""

from typing import Annotated

import typer

from .campaign_tables import csv_tables, markdown_tables
from .inputs import read_flights
from .options import FlightsArgument, InsteadOfPrinting
from .output import tell, write_text


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("table")(table)


def table(
    flights: FlightsArgument,
    style: Annotated[
        str, typer.Option("--format", help="Format of the tables: `markdown` or `csv`.")
    ] = "markdown",
    out: InsteadOfPrinting = None,
) -> None:
    """Print a campaign's Table I and II beside the paper's."""
    if style not in ("markdown", "csv"):
        raise ValueError(f"--format must be markdown or csv, not {style!r}")
    rows = read_flights(flights)
    text = markdown_tables(rows) if style == "markdown" else csv_tables(rows)
    if out is None:
        print(text, end="")
        return
    write_text(text, out)
    tell("table", out)
