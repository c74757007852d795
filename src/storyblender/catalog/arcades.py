"""Measures of an arcade: its builder and the planners read the same numbers."""

from __future__ import annotations


def arch_radius(width: float, height: float, arches: int) -> float:
    """Return the radius of each round arch of an arcade, metres.

    Args:
        width: Of the arcade, metres.
        height: Of the arcade.
        arches: Number of arches.
    """
    return min(width / arches * 0.36, height - 2.35)


def piers(width: float, height: float, arches: int) -> tuple[tuple[float, float], ...]:
    """Return the left and right end of every pier of an arcade, metres from its middle.

    Args:
        width: Of the arcade, metres.
        height: Of the arcade.
        arches: Number of arches; there is one pier more.
    """
    bay, radius, left = width / arches, arch_radius(width, height, arches), -width / 2
    lefts = [left, *(left + bay * (index + 0.5) + radius for index in range(arches))]
    rights = [*(left + bay * (index + 0.5) - radius for index in range(arches)), -left]
    return tuple(zip(lefts, rights, strict=True))
