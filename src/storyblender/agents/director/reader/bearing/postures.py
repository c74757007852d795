"""Postures without a motion that leads to them: hanging, also upside down, floating, riding."""

from __future__ import annotations

from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Posture

_HANGING = frozenset({"hang", "dangle"})
_FLOATING = frozenset({"float", "hover", "levitate"})
_MOUNTS = frozenset(
    {"horse", "horseback", "pony", "mule", "donkey", "camel", "elephant", "bicycle", "bike", "motorcycle", "broomstick"}
)
_FROM = frozenset({"from", "off", "on", "onto", "by", "to", "under", "over"})
_ASTRIDE = frozenset({"on", "astride", "atop", "onto"})
_PASSING = frozenset({"up", "out", "around", "round", "on"})
"""``hangs up``, ``hangs around``: particles with which the person does not hang."""


@rule("postures.told")
def note_posture(stage: Stage, clause: Clause, roles: Roles) -> None:
    """Set the posture that a clause describes in the scene.

    Args:
        stage: The state before.
        clause: A clause that is neither negated nor hypothetical.
        roles: The people and things of the clause.
    """
    if not roles.subjects or clause.object or clause.passive or clause.earlier:
        return
    posture: Posture | None = None
    if clause.verb in _HANGING and clause.particle not in _PASSING:
        posture = "upside_down" if _is_upside_down(stage) else "hang"
    elif clause.verb in _FLOATING:
        posture = "float"
    elif clause.verb in ("be", "ride", "sit") and (mount := _mount(stage, roles)):
        for person in roles.subjects:
            stage.scene.posture[person.id] = ("ride", mount)
        return
    support = next((thing for place in roles.places if place.preposition in _FROM for thing in place.things), None)
    for person in roles.subjects if posture else ():
        stage.scene.posture[person.id] = (posture or "hang", support)


def _is_upside_down(stage: Stage) -> bool:
    text = stage.unit.text.lower()
    return "upside down" in text or "upside-down" in text or "by his feet" in text or "by her feet" in text


def _mount(stage: Stage, roles: Roles) -> str | None:
    """Return the id of the animal or vehicle a person rides."""
    return next((found for place in roles.places if (found := _mount_of(stage, place))), None)


def _mount_of(stage: Stage, place: Place) -> str | None:
    if place.preposition not in _ASTRIDE:
        return None
    thing = next((thing for thing in place.things if stage.inventory.head(thing) in _MOUNTS), None)
    return thing or next((person.id for person in place.people if person.role in _MOUNTS), None)
