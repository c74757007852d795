"""Default workplaces of motions that the script gives no place: stirring at a stove, typing at a desk. Data."""

from __future__ import annotations

WORKPLACES: dict[str, tuple[str, ...]] = {
    "stir": ("stove", "wood_stove", "counter"),
    "cut": ("counter", "dining_table", "workbench"),
    "wash_up": ("sink",),
    "type": ("desk", "typewriter", "school_desk"),
    "pour": ("bar_counter", "counter"),
    "paint": ("easel",),
    "pray": ("altar", "pew"),
}
"""Motion to its usual workplace props, the likeliest first."""

_AT_SINK = frozenset({"pot", "pan", "plate", "bowl", "cup", "dish", "glass", "mug", "frying_pan"})


def workplaces_of(motion: str, prop: str | None) -> tuple[str, ...]:
    """Return the usual workplace props of a motion, the likeliest first.

    Args:
        motion: Key of ``catalog.motions``.
        prop: Key of the prop used in the motion, if any: plates are cleaned at the sink.
    """
    if motion == "wipe" and prop in _AT_SINK:
        return WORKPLACES["wash_up"]
    return WORKPLACES.get(motion, ())
