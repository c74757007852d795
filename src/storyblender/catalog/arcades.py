"""Measures of an arcade: its builder and the planners read the same numbers."""

from __future__ import annotations


def arch_radius(width: float, height: float, arches: int) -> float:
    """Return the radius of each round arch, metres."""
    return min(width / arches * 0.36, height - 2.35)


def piers(width: float, height: float, arches: int) -> tuple[tuple[float, float], ...]:
    """Return left and right end of every pier along the arcade, metres from its middle."""
    bay, radius, left = width / arches, arch_radius(width, height, arches), -width / 2
    lefts = [left, *(left + bay * (index + 0.5) + radius for index in range(arches))]
    rights = [*(left + bay * (index + 0.5) - radius for index in range(arches)), -left]
    return tuple(zip(lefts, rights, strict=True))
