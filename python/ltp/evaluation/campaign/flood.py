# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flood from cell to cell that shares nothing with the planners: it judges their proofs."""

import itertools

import numpy as np
from numpy.typing import NDArray


def connected(free: NDArray[np.bool_], start: NDArray[np.int64], goals: NDArray[np.int64]) -> bool:
    """Whether a walk leads from a cell (3,) to one of others (n, 3), all of them free.

    Two floods, one from each end; the one with the smaller front advances. The step rule reads the
    same in both directions, so they may meet half way. A goal in a small yard is settled by filling
    the yard.
    """
    cells = free.reshape(-1)
    ends = (start[None], goals)
    fronts = [np.ravel_multi_index(tuple((end + 1).T), free.shape) for end in ends]
    if np.isin(fronts[0], fronts[1]).any():
        return True
    steps = step_boxes(free.shape)
    reached = np.zeros(cells.shape, dtype=np.uint8)
    for mark, front in enumerate(fronts, start=1):
        reached[front] = mark
    while all(len(front) for front in fronts):
        side = int(len(fronts[1]) < len(fronts[0]))
        mine, other = side + 1, 2 - side
        found = []
        for target, box in steps:
            legal = cells[fronts[side] + box[0]]
            for offset in box[1:]:
                legal &= cells[fronts[side] + offset]
            next_cells = fronts[side][legal] + target
            marks = reached[next_cells]
            if np.any(marks == other):
                return True
            fresh = next_cells[marks == 0]
            reached[fresh] = mine
            found.append(fresh)
        fronts[side] = np.concatenate(found)
    return False


def step_boxes(shape: tuple[int, ...]) -> list[tuple[int, list[int]]]:
    """For each of the 26 steps (8 through one level): its offset in a flat array of cells with one
    blocked cell all round, and the offsets of the other cells of its bounding box."""
    strides = (shape[1] * shape[2], shape[2], 1)
    steps = []
    climbs = (0,) if shape[2] == 3 else (-1, 0, 1)  # one level between the blocked ones
    for step in itertools.product((-1, 0, 1), (-1, 0, 1), climbs):
        if step == (0, 0, 0):
            continue
        box = itertools.product(*[(0, d) if d else (0,) for d in step])
        offsets = [sum(d * s for d, s in zip(corner, strides, strict=True)) for corner in box]
        steps.append((offsets[-1], offsets[1:]))
    return steps
