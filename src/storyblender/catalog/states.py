"""What a thing looks like once the story has changed it: open, off, broken, on fire. Pure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import read_variant
from storyblender.memory.asset_sheet import ParamValue

BEFORE: Mapping[str, str] = {
    "closed": "open", "shut": "open", "off": "on", "out": "lit", "on": "off", "lit": "unlit", "open": "closed",
    "running": "off", "burning": "unlit",
}  # fmt: skip
"""What a thing was before its first change."""
_DARK = frozenset({"off", "out", "unlit", "dead"})
_BROKEN = frozenset({"broken", "smashed", "shattered", "cracked"})
_FRAGILE = frozenset({
    "cup", "glass", "wine_glass", "beer_mug", "bottle", "plate", "bowl", "vase", "teapot", "jar", "jug", "wall_mirror",
    "hourglass", "light_bulb", "beaker", "picture", "aquarium", "test_tubes", "pumpkin", "egg", "balloon", "statue",
    "window",
})  # fmt: skip
_ADDED = {"burning": "flames", "on fire": "flames", "in flames": "flames", "smoking": "smoke", "steaming": "smoke"}


class StateLook(NamedTuple):
    """How a thing is built in a state.

    Attributes:
        key: Prop key.
        params: Of the prop.
        added: Whether it is seen together with the thing and not in its place.
    """

    key: str
    params: dict[str, ParamValue]
    added: bool = False


def look_in(key: str, params: Mapping[str, ParamValue], state: str) -> StateLook | None:
    """Return how a prop is built in a state; None where it looks as it did.

    Args:
        key: Prop key of the thing.
        params: As it was built at first.
        state: ``open``, ``off``, ``broken``.
    """
    entry = PROPS.get(key)
    if entry is None:
        return None
    if state in _BROKEN and key in _FRAGILE:
        material = str(params.get("material", "")) or next(iter(entry.materials.values()))
        color = {"color": params["color"]} if "color" in params else {}
        return StateLook("shards", {"material": material, **color})
    if state in _ADDED and "lit" not in entry.params:
        return StateLook(_ADDED[state], {}, added=True)
    changed = {**params, **read_variant(entry, state)}
    changed.pop("unlit", None)
    if state in _DARK and entry.lights:
        changed["unlit"] = True
    was = {**entry.params, **params}
    return StateLook(key, changed) if {**entry.params, **changed} != was else None


def state_at_first(changes: Sequence[str]) -> str:
    """Return the state of a thing before the changes that the story tells of it; empty if nothing follows from them."""
    return BEFORE.get(changes[0], "") if changes else ""
