"""States that outlast a scene: what is broken stays broken, a door left open is open, what is gone stays away."""

from __future__ import annotations

import re
from collections.abc import Iterable

from storyblender.agents.director.fixtures import is_fixture
from storyblender.agents.director.reading import Reading, SceneReading, Unit
from storyblender.catalog.states import GONE, Condition, after

_LASTING = frozenset({"broken", "smashed", "shattered", "cracked", "torn", "burnt", GONE})
"""States that time does not undo."""
_MUCH_LATER = re.compile(
    r"\b(next|following|morning after|days?|weeks?|months?|years?) (later|after|day|morning|night|evening|week)\b"
    r"|\b(next|following) \w+\b|\b(weeks|months|years|days)\b",
    re.IGNORECASE,
)
"""Words in a heading after which doors have been shut and lamps switched again."""
LIGHT = "light"
"""Subject of what happens to the light of a whole place."""


def found_states(reading: Reading) -> dict[int, dict[str, Condition]]:
    """Return, for each scene id, the states that earlier scenes left things and doors in.

    A thing that can be carried is in its state wherever it is; a part of a place, and what is gone from it, only there.

    Args:
        reading: What the script says.
    """
    bound = {thing.id for thing in reading.things if thing.kind == "set_piece" or is_fixture(thing)} | {LIGHT}
    units_of: dict[int, list[Unit]] = {}
    for unit in reading.units:
        units_of.setdefault(unit.scene, []).append(unit)
    roots: dict[int, int] = {}
    now: dict[tuple[int | None, str], Condition] = {}
    last: dict[int, SceneReading] = {}
    before: SceneReading | None = None
    found: dict[int, dict[str, Condition]] = {}
    for index, scene in enumerate(reading.scenes):
        root = roots[scene.id] = roots.get(scene.reference or scene.id, scene.id)
        units = units_of.get(index, [])
        here = _shown(units)
        for key in list(now):
            since = before if key[0] is None else last.get(root)
            if key[0] in (None, root) and since is not None and _time_passes(since, scene):
                now[key] = tuple(state for state in now[key] if state in _LASTING)
            if key[0] == root and key[1] in here:
                now[key] = tuple(state for state in now[key] if state != GONE)
        found[scene.id] = {thing: states for (place, thing), states in now.items() if place in (None, root) and states}
        for change in (change for unit in units for change in unit.changes):
            gone = change.state == GONE
            key = root if change.subject in bound or gone else None, change.subject
            now[key] = after(now.get(key, ()), change.state)
        last[root] = before = scene
    return found


def _shown(units: Iterable[Unit]) -> set[str]:
    """Return the things that the words of a scene show or use."""
    told = {thing for unit in units for thing in unit.things if unit.kind == "action" and thing not in unit.absent}
    used = {name for unit in units for deed in unit.deeds for name in (deed.prop, deed.target) if name}
    return told | used


def _time_passes(since: SceneReading, scene: SceneReading) -> bool:
    words = f"{scene.heading} {scene.time_written}"
    return since.time != scene.time or _MUCH_LATER.search(words) is not None
