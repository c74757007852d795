"""Where a deed is done that is told without a place: one stirs at a stove, types at a desk. Pure data."""

from __future__ import annotations

WORKPLACES: dict[str, tuple[str, ...]] = {
    "cook": ("stove", "wood_stove", "counter"),
    "stir": ("stove", "wood_stove", "counter"),
    "cut": ("counter", "dining_table", "workbench"),
    "cut_food": ("counter", "dining_table", "round_table"),
    "wash": ("sink",),
    "wash_up": ("sink",),
    "type": ("desk", "typewriter", "school_desk"),
    "play_piano": ("piano", "grand_piano"),
    "pour": ("bar_counter", "counter"),
    "paint": ("easel",),
    "pray": ("altar", "pew"),
}
"""Motion to the props it is done at, the likeliest first."""

_AT_SINK = frozenset({"pot", "pan", "plate", "bowl", "cup", "dish", "glass", "mug", "frying_pan"})


def workplaces_of(motion: str, prop: str | None) -> tuple[str, ...]:
    """Return the props at which a motion is done, the likeliest first.

    Args:
        motion: Key of the motion, the Director's or a clip's.
        prop: Key of the thing it is done with, if any: who cleans a plate is at the sink.
    """
    if motion == "clean" and prop in _AT_SINK:
        return WORKPLACES["wash"]
    return WORKPLACES.get(motion, ())
