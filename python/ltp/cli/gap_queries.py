# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The queries of `ltp gap`: recorded in flight, or kept from before."""

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from .global_paths import GlobalPaths
from .naming import naming
from .output import console, say

if TYPE_CHECKING:
    from ltp.config import MissionConfig
    from ltp.evaluation.gap.queries import QuerySet
    from ltp.world import World

_FILE = "queries.npz"


def queries_file(folder: Path) -> Path:
    """Where the queries of a comparison are kept."""
    return folder / _FILE


def recorded_queries(
    world: "World",
    global_paths: GlobalPaths,
    flights: int,
    config: "MissionConfig",
    count: int,
    folder: Path,
) -> "QuerySet":
    """The folder's queries if they were recorded just so; else they are recorded."""
    from ltp.evaluation.digests import program_digest, world_digest
    from ltp.evaluation.gap.queries import QuerySet, record_queries

    lines = global_paths.options(flights)
    facts = [program_digest(), world_digest(world), asdict(lines), config.to_dict(), count]
    source = hashlib.sha256(json.dumps(facts).encode()).hexdigest()
    path = queries_file(folder)
    if path.exists() and (kept := QuerySet.load(path)).source == source:
        say(f"{len(kept.queries)} queries were recorded before")
        return kept
    scenarios = global_paths.over(world, flights)
    with (
        console().status("flying") as status,
        naming(**{"the number of queries": "--queries"}),
    ):
        found = record_queries(
            world,
            scenarios,
            config,
            count,
            source,
            lambda done: status.update(f"flying: {done} of {len(scenarios)} flights"),
        )
    folder.mkdir(parents=True, exist_ok=True)
    found.save(path)
    say(f"{found.world}: {len(found.queries)} queries of {len(scenarios)} flights")
    return found
