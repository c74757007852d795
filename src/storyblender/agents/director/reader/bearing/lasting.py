"""Activities that last: painting, driving, playing; until the person does something else. Calls: ``calls.py``."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.bearing.calls import ACTIVITY
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

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
def note_lasting(stage: Stage, clauses: Sequence[Clause], people: Sequence[Person]) -> None:
    """Begin and end lasting activities.

    Args:
        stage: Its unit has the deeds of the sentence; the scene keeps the activities.
        clauses: The clauses of the sentence.
        people: The people of the sentence.
    """
    text = joined(stage.sentence.words)
    going_on = stage.scene.activities
    progressive = {clause.at for clause in clauses if clause.participle and not clause.negated and not clause.unreal}
    over = _OVER.search(text) is not None
    for deed in stage.unit.deeds:
        if going_on.get(deed.actor, ACTIVITY) != ACTIVITY and (
            over or deed.motion not in _BESIDE_IT | {going_on[deed.actor]}
        ):
            _end(stage, deed.actor)
        if deed.motion in _LASTING and deed.at in progressive and not over:
            _begin(stage, deed.actor, deed.motion)
    for person in people:
        if over and going_on.get(person.id, ACTIVITY) != ACTIVITY:
            _end(stage, person.id)


def _begin(stage: Stage, person: str, motion: str) -> None:
    if stage.scene.activities.get(person) != motion:
        stage.scene.activities[person] = motion
        stage.unit.activities[person] = motion


def _end(stage: Stage, person: str) -> None:
    del stage.scene.activities[person]
    stage.unit.activities[person] = ""
