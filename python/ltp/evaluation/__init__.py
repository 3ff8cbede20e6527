# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""From many flights and plans to tables and figures: scenarios, campaigns, gaps, drawings.

What the words mean, everywhere in here:

* planner: an algorithm, by its name in `ltp.PLANNERS`; `ltp.planners()` tells what it is.
* `Contender`: who is compared, by one name: a planner, the same with `+refine`, or `shortest`.
* `Weights`: W_L and W_P of Eq. 5. Their ratio W_P / W_L says all that matters to most planners.
* `Scenario`: one global path across a world.
* `Variant` (campaign): a contender's planner under weights over a priority map; a row of a table.
* `Flight` (campaign): a variant over a scenario, to be flown; `FlightRow` is what became of it.
* `FlownVariant` (campaign): a variant with the rows of its flights, by scenario.
* `Case` (gap): what all contenders of one table share: priority map, band, ratio.
* `RegretRow` (regret): a flight against the best routes that one finds knowing all obstacles.
* `RecordedQuery` (gap): one question asked in flight; `GapRow` is a contender's answer to it.

Folders: `campaign` flies closed loop, `gap` asks open loop; neither knows the other. `regret`
judges a campaign's flights. `figures` draws what all of them give.
"""

from .campaign import (
    TABLE_I,
    TABLE_II,
    Campaign,
    FlightRow,
    Variant,
    read_rows,
    run_campaign,
)
from .conditions import Weights
from .contenders import Contender
from .dataframe import to_dataframe
from .scenarios import Scenario, ScenarioOptions, make_scenarios

__all__ = [
    "TABLE_I",
    "TABLE_II",
    "Campaign",
    "Contender",
    "FlightRow",
    "Scenario",
    "ScenarioOptions",
    "Variant",
    "Weights",
    "make_scenarios",
    "read_rows",
    "run_campaign",
    "to_dataframe",
]
