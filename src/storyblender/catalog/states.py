"""States of props that the story changes (open, off, broken, on fire, spilled, full) and how each state looks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from storyblender.catalog.liquids import SPOUTS, VESSELS, filling_of, spill_width, usual_liquid
from storyblender.catalog.props import PROPS
from storyblender.catalog.writing import MAX_LETTERS, WRITING
from storyblender.memory.asset_sheet import ParamValue
from storyblender.memory.base import Vec3
from storyblender.memory.thing_states import LYING_STATES, OF_LAMPS, OFF_STATES, Condition
from storyblender.memory.vocabulary import ThingState

STATE_BEFORE: Mapping[str, ThingState] = {
    "closed": "open", "off": "on", "unlit": "lit", "on": "off", "lit": "unlit", "open": "closed", "running": "off",
    "burning": "unlit", "there": "gone", "empty": "full", "spilled": "full", "full": "empty",
}  # fmt: skip
"""State -> the state of a thing before it changed to that one for the first time."""
SEEN_AGAIN = LYING_STATES | {"broken", "burning", "smoking"}
"""States in which a thing still is when its place is seen again, though the script does not mention it."""
_FLAT = 0.35
"""Ratio of height to width below which a thing is too flat to fall over."""
_FRAGILE = frozenset({
    "cup", "glass", "wine_glass", "beer_mug", "bottle", "plate", "bowl", "vase", "teapot", "jar", "jug", "wall_mirror",
    "hourglass", "light_bulb", "beaker", "picture", "aquarium", "test_tubes", "pumpkin", "egg", "balloon", "statue",
    "window", "mug", "water_bottle",
})  # fmt: skip
_ADDED: Mapping[str, str] = {"burning": "flames", "smoking": "smoke", "steaming": "smoke"}
_RUNNING = frozenset({"running", "on", "overflowing"})
_SWITCHES: Mapping[str, Mapping[str, bool]] = {
    "open": {"open": True, "up": True}, "closed": {"open": False, "up": False}, "lit": {"lit": True},
    "unlit": {"lit": False}, "burning": {"lit": True}, "on": {"lit": True, "on": True},
    "off": {"lit": False, "on": False}, "running": {"on": True}, "flickering": {"on": True}, "empty": {"food": False},
}  # fmt: skip
"""State -> the switches of a prop's builder that it sets, where the prop has them."""
_LEVELS = {"full": 0.9, "empty": 0.0, "spilled": 0.0}
"""How full a glass is in a state."""


class StateLook(NamedTuple):
    """The prop to build for a thing in a state, or for what the state adds beside it, such as flames or a puddle.

    Attributes:
        key: Prop key.
        params: Parameters of the prop.
        added: Whether it is shown beside the thing rather than instead of it.
        width: Metres to which it is scaled; None keeps its size.
        location: Where an added prop is, in the thing's own frame, metres.
        lying: Whether it stays level when the thing lies on its side.
    """

    key: str
    params: dict[str, ParamValue]
    added: bool = False
    width: float | None = None
    location: Vec3 = (0.0, 0.0, 0.0)
    lying: bool = False


def topples(size: Vec3) -> bool:
    """Return whether a thing of this (width, depth, height) can fall over and lie on its side."""
    return size[2] > _FLAT * max(size[:2])


def state_looks(
    key: str, params: Mapping[str, ParamValue], condition: Condition, size: Vec3 = (0.2, 0.2, 0.2), liquid: str = ""
) -> tuple[StateLook, ...]:
    """Return how a thing is built in its condition, and what is seen beside it; empty where it looks as at first.

    Args:
        key: Prop key of the thing.
        params: Parameters it was built with at first.
        condition: Its states, with what is written on it and its open doors.
        size: Its width, depth and height in metres.
        liquid: Hex colour of the liquid that the script says it holds; empty if it names none.
    """
    if key not in PROPS:
        return ()
    now, changed = key, dict(params)
    added: list[StateLook] = []
    for state in condition.states:
        look = state_look(now, changed, state, condition.writing, condition.doors)
        if look is not None and look.added:
            added.append(look._replace(width=max(0.25, max(size) * 0.7)))
        elif look is not None:
            now, changed = look.key, look.params
        added += _liquid(key, state, condition, size, liquid)
    was = {**PROPS[key].params, **params}
    if now != key:
        lies = bool(LYING_STATES & {*condition.states}) and topples(size)
        pieces = StateLook(now, changed, width=max(0.25, max(size) * 1.1), lying=lies)
        pieces = pieces._replace(location=(0.0, 0.0, -size[1] / 2)) if lies else pieces
        return pieces, *(each for each in added if each.key == "puddle")
    as_it_was = {**PROPS[key].params, **changed} == was
    return (*(() if as_it_was else (StateLook(key, changed),)), *added)


def state_look(
    key: str,
    params: Mapping[str, ParamValue],
    state: ThingState,
    writing: str = "",
    doors: Sequence[str] | None = None,
) -> StateLook | None:
    """Return how a prop is built in one state; None where the state does not change its look.

    Args:
        key: Prop key of the thing.
        params: Parameters it was built with at first.
        state: The state.
        writing: The words on it, where it is ``lettered``.
        doors: Names of its open doors; None for what has none with a name.
    """
    entry = PROPS.get(key)
    if entry is None:
        return None
    if state == "broken" and key in _FRAGILE:
        material = str(params.get("material", "")) or next(iter(entry.materials.values()))
        color = {"color": params["color"]} if "color" in params else {}
        return StateLook("shards", {"material": material, **color})
    if state in _ADDED and "lit" not in entry.params and entry.lamp is None:
        return StateLook(_ADDED[state], {}, added=True)
    if state == "lettered":
        text = writing.strip()[:MAX_LETTERS]
        return StateLook(key, {**params, "text": text}) if key in WRITING and params.get("text") != text else None
    switches = _SWITCHES.get(state, {}).items()
    changed = {**params, **{name: on for name, on in switches if isinstance(entry.params.get(name), bool)}}
    if state in OF_LAMPS:
        changed.pop("unlit", None)
    if doors is not None and state in ("open", "closed") and isinstance(entry.params.get("open"), str):
        changed["open"] = " ".join(doors) if state == "open" else ""
    if state in OFF_STATES and entry.lights:
        changed["unlit"] = True
    if "fill" in entry.params and state in _LEVELS:
        changed["fill"] = _LEVELS[state]
    was = {**entry.params, **params}
    return StateLook(key, changed) if {**entry.params, **changed} != was else None


def _liquid(key: str, state: ThingState, condition: Condition, size: Vec3, named: str) -> Iterator[StateLook]:
    """Yield the stream, the puddle or the filling that a state adds to a thing of ``size``."""
    width, depth, height = size
    color = named or usual_liquid(key)
    if state in _RUNNING and key in SPOUTS:
        mouth, end, thrown = SPOUTS[key]
        at = (mouth[0] * width, mouth[1] * depth, end * height)
        fall = (mouth[2] - end) * height
        built: dict[str, ParamValue] = {"color": color, "height": max(fall, 0.03)}
        if thrown:
            out = (at[0], at[1] - thrown / 2, at[2])  # what is built has its origin in its middle
            yield StateLook("water_jet", {**built, "depth": thrown}, added=True, location=out)
        elif fall > 0:
            yield StateLook("running_water", built, added=True, location=at)
    spills = state == "spilled" and (named or key in VESSELS)
    if spills or (state in LYING_STATES and named and "empty" not in condition.states):
        wide = spill_width(size)
        puddle: dict[str, ParamValue] = {"width": wide, "depth": 0.85 * wide, "color": color}
        fallen = topples(size)
        at = (0.0, -height - 0.36 * wide, 0.003 - depth / 2) if fallen else (0.0, -depth / 2 - 0.3 * wide, 0.003)
        yield StateLook("puddle", puddle, added=True, location=at, lying=fallen)
    filling = filling_of(key, size) if state in ("full", "overflowing") else None
    if filling is not None and "fill" not in PROPS[key].params:
        (w, d, h), z, oblong = filling
        surface: dict[str, ParamValue] = {"width": w, "depth": d, "height": h, "oblong": oblong}
        yield StateLook("liquid", {**surface, "color": color}, added=True, location=(0.0, 0.0, z - h))


def state_at_first(changes: Sequence[str]) -> ThingState | Literal[""]:
    """Return the state of a thing before the first of its changes; empty where it cannot be concluded."""
    return STATE_BEFORE.get(changes[0], "") if changes else ""
