# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One flight with progress on the terminal, recorded for the viewer, and its picture."""

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .output import console, note, say

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ltp._core import Raster
    from ltp.config import MissionConfig
    from ltp.sim.record import FlightRecord
    from ltp.world import World


def fly_recorded(
    world: "World",
    config: "MissionConfig",
    global_path: "NDArray[np.float64]",
    recording: Path,
    wanted: bool | None,
    title: str,
    priority: "Raster | None" = None,
    known_map: Path | None = None,
    save_map: Path | None = None,
) -> tuple["FlightRecord", Any, Path | None]:
    """Fly with progress, gather what was sensed, and record for the viewer if wanted.

    The flight may begin with the map of an earlier one, and leave its own.

    Returns:
        The record, the sensed cells, and the recording's path if one was written.
    """
    from ltp.evaluation.sensed import SensedTrace
    from ltp.installed import pip_install
    from ltp.sim import Mission
    from ltp.viewer.rerun_module import has_rerun

    from .progress import FlightProgress

    sensed = SensedTrace()
    recorded = has_rerun() if wanted is None else wanted
    with ExitStack() as stack:
        observers: list[Any] = [
            stack.enter_context(FlightProgress(console(), title)),
            sensed,
        ]
        if recorded:
            from ltp.viewer import FlightRecording

            observers.append(stack.enter_context(FlightRecording(recording)))
        mission = Mission(world, config, global_path, observers, priority, known_map=known_map)
        record = mission.fly()
        if save_map is not None:
            mission.planner.map.save(save_map)
    for sentence in record.map_losses:
        note(f"map: {sentence}")
    if not recorded and wanted is None:
        say(f"no recording: it needs {pip_install('viewer')}")
    return record, sensed, recording if recorded else None


def draw_summary(world: "World", records: "list[FlightRecord]", sensed: Any, path: Path) -> None:
    """Draw flights of one global path over the city."""
    from ltp.evaluation.figures.backdrop import save_figure
    from ltp.evaluation.figures.summary import summary_figure

    save_figure(summary_figure(world, records, sensed), path)
