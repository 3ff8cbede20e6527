# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's tables: on the terminal, as Markdown, as CSV."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from .output import GREY, console, narrow_table, remark, tell, write_text

if TYPE_CHECKING:
    from ltp.evaluation.campaign.rows import FlightRow


def write_tables(rows: Sequence["FlightRow"], folder: Path) -> None:
    """Print the tables and write them into a folder."""
    write_text(markdown_tables(rows), folder / "tables.md")
    write_text(csv_tables(rows), folder / "tables.csv")
    _print_tables(rows)
    tell("tables", folder / "tables.md")


def _print_tables(rows: Sequence["FlightRow"]) -> None:
    """Narrow tables for the terminal: under each row, in grey, the paper's."""
    from ltp.evaluation.campaign.summary import summarise
    from ltp.evaluation.campaign.tables import averaged_over, brief_cells, table_variants

    for title, variants in table_variants(rows).items():
        summaries = summarise(variants, rows)
        titles, lines = brief_cells(summaries)
        grid = narrow_table(title, titles)
        for ours, paper in lines:
            grid.add_row(*[f"[bold green]{cell}[/]" if best else cell for cell, best in ours])
            if paper is not None:
                grid.add_row(*paper, style=GREY)
        console().print(grid)
        remark(averaged_over(summaries))
    remark(
        "P mean priority, L length flown over global path's (SD); time per plan; dropped "
        "waypoints (wrongly: by\nthe map's cells of the true world, by its cells of 0.5 m); clear: "
        "smallest clearance [m]; grey: the paper",
    )


def markdown_tables(rows: Sequence["FlightRow"]) -> str:
    """All tables of a campaign, in one document."""
    from ltp.evaluation.campaign.summary import summarise
    from ltp.evaluation.campaign.tables import markdown_table, table_variants

    parts = [f"# {rows[0].world}\n"]
    for title, variants in table_variants(rows).items():
        parts.append(f"## {title}\n\n{markdown_table(summarise(variants, rows))}")
    return "\n".join(parts)


def csv_tables(rows: Sequence["FlightRow"]) -> str:
    """All rows of the tables, one a line."""
    from ltp.evaluation.campaign.summary import summarise
    from ltp.evaluation.campaign.tables import csv_table, table_variants

    tables = table_variants(rows).values()
    return csv_table([line for variants in tables for line in summarise(variants, rows)])
