"""Gaze that rests on nothing in the set: up, down, aside, into the camera, or eyes closed."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_WAYS = ("closed", "camera", "up", "down", "left", "right")
_OPENED = lexicon.BEARING["eyes_open"]
_DENIED = re.compile(r"\b(?:not|n't|never|without|cannot)\b")


@rule("bearing.gaze")
def note_gaze(stage: Stage, people: Sequence[Person]) -> None:
    """Note the gaze of the people of a sentence, and end an earlier gaze when they look at something.

    Args:
        stage: Its unit takes the directions; the scene remembers the people with a gaze.
        people: The people of the sentence.
    """
    turned = stage.scene.gaze
    for deed in stage.unit.deeds:
        if deed.motion in ("look", "read", "talk", "peek") and deed.target and deed.actor in turned:
            stage.unit.gaze[deed.actor] = deed.target
            turned.discard(deed.actor)
    text = joined(stage.sentence.words)
    way = next((way for way in _WAYS if lexicon.BEARING[f"gaze_{way}"].search(text)), None)
    if way and people and not _DENIED.search(text):
        for person in people:
            stage.unit.gaze[person.id] = way
            turned.add(person.id)
        _forget_the_camera(stage, way)
    elif _OPENED.search(text):
        for person in (person for person in people if person.id in turned):
            stage.unit.gaze[person.id] = "camera"
            turned.discard(person.id)


def _forget_the_camera(stage: Stage, way: str) -> None:
    """A look at the camera is a look at the audience: there is no camera on the set."""
    if way != "camera":
        return
    cameras = {
        thing for _, thing in stage.sentence.things if stage.inventory.head(thing) in ("camera", "lens", "audience")
    }
    for thing in cameras:
        stage.inventory.forget(thing)
    stage.unit.things = [thing for thing in stage.unit.things if thing not in cameras]
    for deed in stage.unit.deeds:
        deed.target = None if deed.target in cameras else deed.target
