"""Postures without a motion that leads to them (hanging, floating, riding), and activities that last (painting).

Telephone calls are in ``calls.py``.
"""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.bearing.calls import ACTIVITY
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Posture

_HANGING = frozenset({"hang", "dangle"})
_FLOATING = frozenset({"float", "hover", "levitate"})
_MOUNTS = lexicon.words("mounts")
_FROM = frozenset({"from", "off", "on", "onto", "by", "to", "under", "over"})
_ASTRIDE = frozenset({"on", "astride", "atop", "onto"})
_PASSING = frozenset({"up", "out", "around", "round", "on"})
"""``hangs up``, ``hangs around``: particles with which the person does not hang."""


@rule("postures.told")
def note_posture(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Set the posture that a clause describes in the scene.

    Args:
        state: The state before.
        clause: A clause that is neither negated nor hypothetical.
        roles: The people and things of the clause.
    """
    if not roles.subjects or clause.object or clause.passive or clause.earlier:
        return
    posture: Posture | None = None
    if clause.verb in _HANGING and clause.particle not in _PASSING:
        posture = "upside_down" if _is_upside_down(state) else "hang"
    elif clause.verb in _FLOATING:
        posture = "float"
    elif clause.verb in ("be", "ride", "sit") and (mount := _mount(state, roles)):
        for person in roles.subjects:
            state.scene.posture[person.id] = ("ride", mount)
        return
    support = next((thing for place in roles.places if place.preposition in _FROM for thing in place.things), None)
    for person in roles.subjects if posture else ():
        state.scene.posture[person.id] = (posture or "hang", support)


def _is_upside_down(state: ReaderState) -> bool:
    """Whether the sentence says that a person hangs upside down."""
    text = state.unit.text.lower()
    return "upside down" in text or "upside-down" in text or "by his feet" in text or "by her feet" in text


def _mount(state: ReaderState, roles: Roles) -> str | None:
    """Return the id of the animal or vehicle that a person rides, or None."""
    return next((found for place in roles.places if (found := _mount_of(state, place))), None)


def _mount_of(state: ReaderState, place: Place) -> str | None:
    """Return the animal or vehicle that a place names, or None."""
    if place.preposition not in _ASTRIDE:
        return None
    thing = next((thing for thing in place.things if state.inventory.head(thing) in _MOUNTS), None)
    return thing or next((person.id for person in place.people if person.role in _MOUNTS), None)


_LASTING = frozenset(
    {"write", "drive", "ride", "play_music", "cook", "clean", "work", "read", "type", "dance", "smoke", "eat"}
    | {"sing", "search", "cut", "stir", "swim", "pray", "drink", "aim"}
)
"""Motions that may continue through the following lines."""
_BESIDE_IT = frozenset(
    {"talk", "whisper", "shout", "look", "look_around", "nod", "shake_head", "shrug", "laugh", "listen", "peek", "cry"}
    | {"stand", "sit", "think"}
)
"""Deeds that do not interrupt a lasting activity."""
_OVER = lexicon.BEARING["over"]


@rule("bearing.activity")
def note_lasting_activities(state: ReaderState, clauses: Sequence[Clause], people: Sequence[Person]) -> None:
    """Begin and end lasting activities.

    Args:
        state: Its unit has the deeds of the sentence; the scene keeps the activities.
        clauses: The clauses of the sentence.
        people: The people of the sentence.
    """
    text = joined(state.sentence.words)
    going_on = state.scene.activities
    progressive = {clause.at for clause in clauses if clause.participle and not clause.negated and not clause.unreal}
    over = _OVER.search(text) is not None
    for deed in state.unit.deeds:
        if going_on.get(deed.actor, ACTIVITY) != ACTIVITY and (
            over or deed.motion not in _BESIDE_IT | {going_on[deed.actor]}
        ):
            _end_activity(state, deed.actor)
        if deed.motion in _LASTING and deed.at in progressive and not over:
            _begin_activity(state, deed.actor, deed.motion)
    for person in people:
        if over and going_on.get(person.id, ACTIVITY) != ACTIVITY:
            _end_activity(state, person.id)


def _begin_activity(state: ReaderState, person: str, motion: str) -> None:
    """Begin a lasting activity of a person."""
    if state.scene.activities.get(person) != motion:
        state.scene.activities[person] = motion
        state.unit.activities[person] = motion


def _end_activity(state: ReaderState, person: str) -> None:
    """End the lasting activity of a person."""
    del state.scene.activities[person]
    state.unit.activities[person] = ""
