# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planning works: shortest path, Dijkstra, the wave, the proof that no path exists."""

from ..contest import Shared, Solver, Work
from ..judges import lengths, near
from . import ours
from . import path_peers as peers

#: Rounding of double-precision sums; and what whole-number lengths or single precision may add.
_SAME, _NEARLY = 1e-9, 1e-6
_CORNERS = 1.05  # a path that may squeeze past blocked cells is up to so much shorter
_DISCOVERED = 1.0 - 5e-3  # dijkstra3d stops when the goal is discovered, not when it is settled

shortest = Work("shortest", "shortest path, one query", lambda shared: len(shared.town.pairs))
dijkstra = Work("dijkstra", "Dijkstra, one query", lambda shared: len(shared.town.pairs))
ggwp = Work("ggwp", "GGWP, one query", lambda shared: len(shared.town.pairs))
unreachable = Work(
    "unreachable", "proof that a goal is unreachable", lambda shared: len(shared.town.sealed)
)

shortest.enter("ltp auto")(ours.shortest("auto"))
shortest.enter("ltp additive", judge=lengths(1 - _SAME, 1 + _SAME))(ours.shortest("additive"))
shortest.enter("ltp lp-a-star", judge=lengths(1 - _SAME, 1 + _SAME))(ours.shortest("lp-a-star"))
dijkstra.enter("ltp lp-dijkstra")(ours.shortest("lp-dijkstra"))
ggwp.enter("ltp ggwp")(ours.shortest("ggwp"))
ggwp.enter("ltp auto", judge=lengths(1.0 - _SAME, 2.0))(ours.shortest("auto"))
unreachable.enter("ltp auto")(ours.proof("auto"))
unreachable.enter("ltp lp-a-star", judge=near(0, 0))(ours.proof("lp-a-star"))


@shortest.enter("scipy, our graph", "scipy", lengths(1 - _SAME, 1 + _SAME))
@dijkstra.enter("scipy, our graph", "scipy", lengths(1 - _SAME, 1 + _SAME))
def _(shared: Shared) -> Solver:
    return peers.scipy_dijkstra(shared.town.solid, shared.town.pairs)


@shortest.enter("dijkstra3d A*, our graph", "dijkstra3d", lengths(_DISCOVERED, 1 + _NEARLY))
def _(shared: Shared) -> Solver:
    return peers.dijkstra3d_weighted(shared.town.solid, shared.town.pairs, True, our_graph=True)


@shortest.enter("dijkstra3d A*", "dijkstra3d", lengths(_DISCOVERED, _CORNERS))
def _(shared: Shared) -> Solver:
    return peers.dijkstra3d_weighted(shared.town.solid, shared.town.pairs, True)


@dijkstra.enter("dijkstra3d, our graph", "dijkstra3d", lengths(_DISCOVERED, 1 + _NEARLY))
def _(shared: Shared) -> Solver:
    return peers.dijkstra3d_weighted(shared.town.solid, shared.town.pairs, False, our_graph=True)


@dijkstra.enter("dijkstra3d", "dijkstra3d", lengths(_DISCOVERED, _CORNERS))
def _(shared: Shared) -> Solver:
    return peers.dijkstra3d_binary(shared.town.solid, shared.town.pairs)


@dijkstra.enter("tcod", "tcod", lengths(1 - _NEARLY, _CORNERS))
def _(shared: Shared) -> Solver:
    return peers.tcod_graph(shared.town.solid, shared.town.pairs, a_star=False)


@shortest.enter("tcod A*", "tcod", lengths(1 - _NEARLY, _CORNERS))
def _(shared: Shared) -> Solver:
    return peers.tcod_graph(shared.town.solid, shared.town.pairs, a_star=True)


@shortest.enter("scikit-image", "scikit-image", lengths(1 - _NEARLY, _CORNERS))
@dijkstra.enter("scikit-image", "scikit-image", lengths(1 - _NEARLY, _CORNERS))
def _(shared: Shared) -> Solver:
    return peers.scikit_image(shared.town.solid, shared.town.pairs)


@shortest.enter("scikit-fmm (length only)", "scikit-fmm", lengths(1.0, 1.2))
def _(shared: Shared) -> Solver:
    return peers.scikit_fmm(shared.town.solid, shared.town.pairs)


@shortest.enter("OMPL BIT*, 20 ms budget", "ompl", lengths(0.0, 1.15))
def _(shared: Shared) -> Solver:
    return peers.ompl_bit_star(shared.town.solid, shared.town.pairs, seconds=0.02)


@unreachable.enter("dijkstra3d A*, our graph", "dijkstra3d", near(0, 0))
def _(shared: Shared) -> Solver:
    town = shared.town
    return _proof(peers.dijkstra3d_weighted(town.hollow, town.sealed, True, our_graph=True))


@unreachable.enter("dijkstra3d A*", "dijkstra3d", near(0, 0))
def _(shared: Shared) -> Solver:
    return _proof(peers.dijkstra3d_weighted(shared.town.hollow, shared.town.sealed, True))


@unreachable.enter("tcod A*", "tcod", near(0, 0))
def _(shared: Shared) -> Solver:
    return _proof(peers.tcod_graph(shared.town.hollow, shared.town.sealed, a_star=True))


@unreachable.enter("scikit-image", "scikit-image", near(0, 0))
def _(shared: Shared) -> Solver:
    return _proof(peers.scikit_image(shared.town.hollow, shared.town.sealed))


def _proof(solver: Solver) -> Solver:
    """A search as a proof: whether there is no path."""
    return Solver(solver.solve, lambda raw: solver.answer(raw) == float("inf"))
