"""Functions that kit files call by name for what tables cannot express: ``hook = [{ name = "row_of_houses" }]``."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets.drawing import Drawing
from storyblender.catalog.sets.street import STREET_LENGTH, row_of_facades

Hook = Callable[[Drawing, Mapping[str, ParamValue]], None]


def row_of_houses(drawing: Drawing, given: Mapping[str, ParamValue]) -> None:
    """Close one side of a street with houses.

    Args:
        drawing: Drawing of the kit.
        given: ``y`` of the fronts, ``yaw`` (0 faces -Y), fewest and most storeys ``low`` and ``high``, ``shops``,
            and the ends of the row: ``start`` and ``end``.
    """
    low, high = int(given.get("low", 3)), int(given.get("high", 5))
    row_of_facades(
        drawing,
        float(given.get("y", 6.0)),
        float(given.get("yaw", 0.0)),
        start=float(given.get("start", -STREET_LENGTH)),
        end=float(given.get("end", STREET_LENGTH)),
        floors=tuple(range(low, high + 1)),
        shops=bool(given.get("shops", True)),
    )


HOOKS: Mapping[str, Hook] = {"row_of_houses": row_of_houses}
