# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of every command that takes mission settings, and the settings that they mean."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .inputs import telling_old_names
from .naming import naming

if TYPE_CHECKING:
    from ltp.config import MissionConfig


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Where the settings come from: a file or the defaults, and over them a preset."""

    config: Annotated[
        Path | None,
        typer.Option(
            "--config", help="TOML file with mission settings; `ltp config` prints them all."
        ),
    ] = None
    preset: Annotated[
        str | None,
        typer.Option(
            help="Settings over those of --config: the map of `paper` (2 x 2 x 4 m, inflated by "
            "whole cells; planar flight), `low` (1 m) or `landing` (0.5 m, 60 m wide); `fly`: it "
            "may climb 20 m."
        ),
    ] = None

    def open(self) -> "MissionConfig":
        """The settings; old names in the file are told on stderr."""
        from ltp.config import MissionConfig

        settings = MissionConfig()
        if self.config is not None:
            with telling_old_names(self.config):
                settings = MissionConfig.load(self.config)
        if self.preset is not None:
            with naming("preset"):
                settings.use_preset(self.preset)
        return settings
