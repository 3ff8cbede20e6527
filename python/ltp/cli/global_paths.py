# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of every command that flies seeded global paths, and the paths that they mean."""

from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from .naming import naming

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ltp.evaluation.scenarios import Scenario, ScenarioOptions
    from ltp.world import World

T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class GlobalPaths:
    """What the global paths look like: `ScenarioOptions`, its defaults, but for their number."""

    altitude: Annotated[float, typer.Option(help="Altitude of the global paths [m].")] = 50.0
    reference: Annotated[
        str,
        typer.Option(
            help="Height that the altitude counts from: `ground` beneath each waypoint, or `datum`."
        ),
    ] = "ground"
    seed: Annotated[int, typer.Option(help="Seed of the set of global paths.")] = 1
    length: Annotated[float, typer.Option(help="Length of a global path, over the ground [m].")] = (
        500.0
    )
    spacing: Annotated[float, typer.Option(help="Distance between its waypoints [m].")] = 50.0
    margin: Annotated[
        float, typer.Option(help="Distance between a path and the world's edge [m].")
    ] = 20.0
    clearance: Annotated[
        float,
        typer.Option(
            help="Distance between a path's start and all that stands on the ground, which does "
            "not count itself [m]."
        ),
    ] = 10.0
    through_buildings: Annotated[
        float, typer.Option(help="Share of the global paths that must cross a building, 0...1.")
    ] = 1.0

    def options(self, count: int) -> "ScenarioOptions":
        """A set of so many of them."""
        from ltp.evaluation.scenarios import ScenarioOptions

        return self._named(lambda: ScenarioOptions(count=count, **asdict(self)))

    def over(self, world: "World", count: int) -> "list[Scenario]":
        """So many of them over a world."""
        from ltp.evaluation.scenarios import make_scenarios

        options = self.options(count)
        return self._named(lambda: make_scenarios(world, options))

    def one(self, world: "World", index: int) -> "NDArray[np.float64]":
        """The waypoints of one of them, (n, 3), without the others."""
        from ltp.evaluation.scenarios import make_scenario

        if index < 0:
            raise ValueError(f"--scenario must be >= 0, not {index}")
        options = self.options(index + 1)
        return self._named(lambda: make_scenario(world, options, index)).global_path

    def _named(self, make: Callable[[], T]) -> T:
        with naming(*(item.name for item in fields(self)), count="--paths"):
            return make()
