# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`boxes`: a world by hand, in one line."""

from collections.abc import Iterable
from typing import Any

from .shapes import Box, Shape
from .world import World


def boxes(
    shapes: Iterable[Shape | tuple[float, float, float, float, float]], **arguments: Any
) -> World:
    """A world of boxes on flat grass.

        boxes([(60, 50, 90, 80, 40), (150, 60, 185, 100, 25)], size=(260, 220))

    Args:
        shapes: boxes as (x_min, y_min, x_max, y_max, height) [m], or any `Box`, `Cylinder` or
            `Prism`.
        arguments: size, extent, cell, ground, ... of `World.from_shapes`.

    Raises:
        ValueError: naming the argument or the shape that is wrong.
    """
    made: list[Shape] = []
    for index, shape in enumerate(shapes):
        if isinstance(shape, tuple | list):
            if len(shape) != 5:
                raise ValueError(
                    f"shapes[{index}] must be (x_min, y_min, x_max, y_max, height), not {shape!r}"
                )
            try:
                shape = Box(*shape)
            except ValueError as error:
                raise ValueError(f"shapes[{index}]: {error}") from error
        made.append(shape)
    return World.from_shapes(made, **{"name": "boxes", **arguments})
