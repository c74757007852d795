"""The phrases about people in a shot that the rules know: how they stand or sit, what they look at and hold."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final

from storyblender.agents.instructor.mentions import MARK, Mentions, Present
from storyblender.memory.edits import BlockingEdit, Edit
from storyblender.memory.scene_decision import DecidedPosture, PersonMarks, PersonPlace

_POSTURES: Final[Mapping[DecidedPosture, str]] = {
    "stand": r"stands?(?: up)?|gets? up", "sit": r"sits?(?: down)?", "lie": r"lies?(?: down)?",
    "kneel": r"kneels?(?: down)?", "crouch": r"crouch(?:es)?(?: down)?", "lean": r"leans?",
}  # fmt: skip
_WAYS: Final[Mapping[str, str]] = {
    "left": r"(?:to the )?left", "right": r"(?:to the )?right", "up": "up", "down": "down",
    "camera": r"(?:into|at) the (?:camera|lens)",
}  # fmt: skip
_WHO: Final = rf"(?:(?:let|have|make) )?(?P<who>{MARK})"
_WHEN: Final = r"(?P<end> (?:at|in) the end| as (?:it|the shot) ends)?"
_THING: Final = rf"(?P<thing>{MARK}|(?:the |a |an )?[a-z]+(?: [a-z]+)?)"
_POSED: Final[list[tuple[DecidedPosture, re.Pattern[str]]]] = [
    (posture, re.compile(rf"{_WHO} (?:{words})(?: (?:on|in|at|against) {_THING})??{_WHEN}"))
    for posture, words in _POSTURES.items()
]
_LOOKS: Final = re.compile(rf"{_WHO} looks? at (?P<thing>{MARK}){_WHEN}")
_LOOKS_AWAY: Final = [(way, re.compile(rf"{_WHO} looks? {words}{_WHEN}")) for way, words in _WAYS.items()]
_HOLDS: Final = re.compile(rf"{_WHO} holds? (?:(?P<thing>{MARK})|nothing){_WHEN}")
_ON: Final = ("sit", "lie", "lean")


def edits_of_person(
    words: str, shot: str, mentions: Mentions, present: Present, furniture: Mapping[str, str]
) -> list[Edit]:
    """Return what words decide of a person in a shot; none where they mean something else.

    Args:
        words: In lower case: ``rick sits on the sofa``, ``ilsa looks at rick``, ``rick holds the letter at the end``.
        shot: Name of the shot.
        mentions: Finds people and things of the story.
        present: Who is there.
        furniture: Catalogue key of each piece of the set's furniture, by node id.
    """
    marked, found = mentions.marked(words)
    said = _place(marked)
    if said is None or not found:
        return []
    match, place = said
    ids = [mentions.ids(each, present) for each in found]
    people = [each for each in ids[0] if each in present.people]
    thing = match.groupdict().get("thing")
    if not people or (thing == MARK and (len(ids) < 2 or len(ids[1]) != 1)):
        return []
    if thing is not None:
        named = ids[1][0] if thing == MARK else _furniture(thing, furniture)
        if named is None:
            return []
        place = _with(place, named)
    when = "end" if match["end"] else "start"
    return [BlockingEdit(shot=shot, person=each, marks=PersonMarks.model_validate({when: place})) for each in people]


def _place(marked: str) -> tuple[re.Match[str], PersonPlace] | None:
    """Return what words with marks for mentions decide, without what they name, and the match."""
    for posture, pattern in _POSED:
        if (match := pattern.fullmatch(marked)) and (match["thing"] is None or posture in _ON):
            return match, PersonPlace(posture=posture)
    for way, pattern in _LOOKS_AWAY:
        if match := pattern.fullmatch(marked):
            return match, PersonPlace(looking_at=way)
    if match := _LOOKS.fullmatch(marked):
        return match, PersonPlace()
    match = _HOLDS.fullmatch(marked)
    return (match, PersonPlace(holding=())) if match else None


def _with(place: PersonPlace, thing: str) -> PersonPlace:
    """Return a place with what they are on, look at or hold."""
    if place.posture is not None:
        return place.model_copy(update={"on": thing})
    return PersonPlace(looking_at=thing) if place.holding is None else PersonPlace(holding=(thing,))


def _furniture(words: str, furniture: Mapping[str, str]) -> str | None:
    """Return the node id of a piece of furniture by what it is called; of several the first, None of none."""
    called = re.sub(r"^(?:the|an?) ", "", words).replace(" ", "_")
    nodes: Sequence[str] = sorted(node for node, key in furniture.items() if called in (key, node))
    return nodes[0] if nodes else None
