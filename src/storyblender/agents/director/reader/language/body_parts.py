"""Body parts whose motions count as their owner's: ``her foot meets the step``, ``Her eyes went to the door``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.rules import rule

_EYES = frozenset({"eye", "gaze", "glance"})
_HANDS = frozenset({"hand", "finger", "fist", "palm", "thumb", "fingertip", "knuckle"})
_LOOKING = lexicon.words("looking")
"""What eyes do when they look at something."""
_GRASPING = frozenset({"close", "tighten", "curl", "wrap", "clamp", "fasten", "lock", "grip", "fold", "clench"})
_FEELING = frozenset({"find", "brush", "touch", "rest", "settle", "land", "graze", "stroke", "trace", "explore"})
_REACHING = frozenset({"reach", "go", "fly", "dart", "shoot", "grope"})
_ONTO = frozenset({"around", "round", "on", "over", "about", "upon", "onto"})
_BY_HAND = frozenset(
    {
        "take",
        "press",
        "knock",
        "open",
        "close",
        "hit",
        "push",
        "pull",
        "wave",
        "point",
        "write",
        "type",
        "hold",
        "touch",
    }
    | {"throw", "give", "pick_up", "put_down", "catch", "clap", "search"}
)


@rule("deeds.part_of_body")
def motion_of_part(clause: Clause) -> str | None:
    """Return the motion of the owner of the body part that is the subject of a clause, or None.

    Args:
        clause: Its subject may be a part of a body with an owner.
    """
    noun = clause.subject[0] if clause.subject else None
    if noun is None or noun.kind != "thing" or not noun.owner or clause.passive:
        return None
    prepositions = {preposition for preposition, _ in clause.places}
    somewhere = bool(clause.object or clause.places or clause.particle)
    if noun.head in _EYES:
        return "look" if clause.verb in _LOOKING and somewhere else None
    if noun.head not in _HANDS or not (clause.object or clause.places):
        return None
    if clause.verb in _GRASPING:
        return "hold" if clause.object or prepositions & _ONTO else None
    if clause.verb in _REACHING and "for" in prepositions:
        return "take"
    if clause.verb in _FEELING:
        return "touch"
    motion = lexicon.MOTION_OF_VERB.get(clause.verb)
    return motion if motion in _BY_HAND and clause.object else None
