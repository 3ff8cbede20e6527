# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Observer`: something that watches a mission. It changes nothing."""

from typing import Protocol

from ltp.sim.record import FlightRecord
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step


class Observer(Protocol):
    """Progress on a terminal, a log, a recording: told of a mission step by step."""

    def on_start(self, setup: MissionSetup) -> None:
        """Before the first step."""

    def on_step(self, step: Step) -> None:
        """After each step's plan, before the vehicle moves; and where it has collided."""

    def on_end(self, record: FlightRecord) -> None:
        """After the last step."""
