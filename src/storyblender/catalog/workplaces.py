"""Default workplaces of motions that the script gives no place: stirring at a stove, typing at a desk. Data."""

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
"""Motion to its usual workplace props, the likeliest first."""

_AT_SINK = frozenset({"pot", "pan", "plate", "bowl", "cup", "dish", "glass", "mug", "frying_pan"})


def workplaces_of(motion: str, prop: str | None) -> tuple[str, ...]:
    """Return the usual workplace props of a motion, the likeliest first.

    Args:
        motion: Key of a Director motion or of a clip.
        prop: Key of the prop used in the motion, if any: plates are cleaned at the sink.
    """
    if motion == "clean" and prop in _AT_SINK:
        return WORKPLACES["wash"]
    return WORKPLACES.get(motion, ())
