# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign's folder was flown for, so that no command overwrites another's rows.

`campaign.json` names the world, the settings and the global paths of a folder, and the keys of all
its flights in the order of the table. A campaign of the same world, settings and paths adds its
flights to them; any other is refused.
"""

import hashlib
import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, get_origin, get_type_hints

from ltp._core import Raster
from ltp.config import MissionConfig
from ltp.files import atomic_write
from ltp.world import World

from .. import digests
from ..scenarios import Scenario
from .flights import Flight

MANIFEST = "campaign.json"
_FORMAT = {"format": "ltp.campaign", "version": 1}


@dataclass
class Folder:
    """The manifest of a campaign's folder; a field each in `campaign.json`."""

    world: str  # its name
    world_digest: str
    settings: dict[str, Any]  # the base configuration, without what the variants put into it
    program: str  # digest of the build that flew
    paths: dict[str, str] = field(default_factory=dict)  # "seed/index" -> digest of a global path
    flights: list[str] = field(default_factory=list)  # keys, in the order of the table

    @staticmethod
    def of(
        world: World,
        base: MissionConfig,
        flights: Sequence[Flight],
        priority: Raster | None = None,
    ) -> "Folder":
        """What a campaign's folder holds once it is flown."""
        own = {} if priority is None else {"priority": digests.raster_digest(priority)}
        return Folder(
            world.name,
            digests.world_digest(world),
            _settings(base) | own,
            digests.program_digest(),
            {_number(flight.scenario): _path_digest(flight.scenario) for flight in flights},
            [flight.key for flight in flights],
        )

    @staticmethod
    def load(path: Path) -> "Folder | None":
        """The manifest of a folder; None if there is none.

        Raises:
            ValueError: naming the file, if it is no manifest.
        """
        try:
            values = json.loads(path.read_bytes())
            if {name: values.pop(name, None) for name in _FORMAT} != _FORMAT:
                raise ValueError(f"expected {_FORMAT}")
            manifest = Folder(**values)
            for name, kind in get_type_hints(Folder).items():
                if not isinstance(getattr(manifest, name), get_origin(kind) or kind):
                    raise ValueError(f"{name} is no {kind}")
            return manifest
        except FileNotFoundError:
            return None
        except (ValueError, TypeError, AttributeError, RecursionError) as error:
            raise ValueError(
                f"{path} is not what a campaign writes ({error}): give another folder"
            ) from error

    def save(self, path: Path) -> None:
        """Write it, all or nothing."""
        with atomic_write(path) as file:
            file.write((json.dumps({**_FORMAT, **asdict(self)}, indent=1) + "\n").encode())

    def differs(self, other: "Folder") -> str | None:
        """What of another campaign does not belong into this folder, in words; None if all does."""
        if other.world_digest != self.world_digest:
            same = " (another one of that name)" if other.world == self.world else ""
            return f"flights over {self.world}, not over {other.world}{same}"
        if names := _differences(self.settings, other.settings):
            return f"flights with other settings ({', '.join(names)})"
        for number, digest in other.paths.items():
            if self.paths.get(number, digest) != digest:
                seed, index = number.split("/")
                return f"flights along other global paths (number {index} of seed {seed})"
        return None

    def add(self, other: "Folder") -> None:
        """Take over another campaign's flights that this folder does not hold yet."""
        self.paths |= other.paths
        self.flights = list(dict.fromkeys([*self.flights, *other.flights]))


def open_folder(
    folder: Path,
    table: str,
    world: World,
    base: MissionConfig,
    flights: Sequence[Flight],
    priority: Raster | None = None,
) -> Folder:
    """Make a folder ready for a campaign's flights; its manifest is on the disk when this returns.

    Where another build of the program has flown the table, that one is kept beside the new, under
    the name of its build: a table never mixes them.

    Raises:
        ValueError: if the folder holds flights of another world, of other settings or along other
            global paths.
    """
    path = folder / MANIFEST
    mine = Folder.of(world, base, flights, priority)
    theirs = Folder.load(path)
    if theirs is not None:
        if found := theirs.differs(mine):
            raise ValueError(f"{folder} holds {found}: give another folder")
        if theirs.program == mine.program:
            theirs.add(mine)
            mine = theirs
        else:
            _set_aside(folder / table, theirs.program)
    elif (folder / table).exists():  # flown by ltp 0.2 or older
        _set_aside(folder / table, "before")
    mine.save(path)
    return mine


def _set_aside(table: Path, build: str) -> None:
    if table.exists():
        table.replace(table.with_name(f"{table.stem}-{build[:8]}{table.suffix}"))


def _settings(base: MissionConfig) -> dict[str, Any]:
    values: dict[str, Any] = json.loads(json.dumps(base.to_dict()))
    for name in ("planner", "priority_map"):
        values.pop(name)
    for name in ("weights", "refine"):
        values["planner_options"].pop(name)
    return values


def _differences(ours: Any, theirs: Any, name: str = "") -> list[str]:
    """The names of the settings that are not the same."""
    if not (isinstance(ours, dict) and isinstance(theirs, dict)):
        return [] if ours == theirs else [name]
    keys: Iterable[str] = dict.fromkeys([*ours, *theirs])
    prefix = f"{name}." if name else ""
    return [
        found
        for key in keys
        for found in _differences(ours.get(key), theirs.get(key), f"{prefix}{key}")
    ]


def _number(scenario: Scenario) -> str:
    return f"{scenario.seed}/{scenario.index}"


def _path_digest(scenario: Scenario) -> str:
    return hashlib.sha256(scenario.global_path.tobytes()).hexdigest()[:20]
