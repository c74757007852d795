"""Decides inside or outside for scenes without a place of their own, by their things, and finds people in boats."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import rule

_OUTSIDE, _INSIDE, _AFLOAT = lexicon.words("outdoor_sign"), lexicon.words("indoor_sign"), lexicon.words("afloat")
_ENOUGH = 2
"""Least number of signs that switch a scene between inside and outside."""
_WATERS = frozenset({"sea", "ocean", "river", "lake", "bay", "water", "lagoon"})


@rule("place.side")
def settle_sides(text: str, scenes: Sequence[SceneReading], *, chat: bool = False) -> None:
    """Set scenes to inside or outside if only their things can decide it.

    A scene without a place follows its things; one that only inherits its place from the scene before goes outside
    if all of its things are outdoor things. People in a boat on the water are on its deck.

    Args:
        text: The script.
        scenes: The scenes in order; changed here.
        chat: The page is a chat, whose senders are in different places.
    """
    for index, scene in enumerate(scenes):
        words = re.findall(r"[a-z]+", text[scene.start : scene.end].lower())
        outside, inside = ({word for word in words if word in signs} for signs in (_OUTSIDE, _INSIDE))
        if not scene.place and not scene.heading and not chat:
            scene.scene_type = "indoor" if len(inside) > len(outside) else scene.scene_type
        inherited = index > 0 and not scene.heading and scene.place == scenes[index - 1].place
        if inherited and scene.scene_type == "indoor" and len(outside) >= _ENOUGH > len(inside):
            _go_out(scene, words)
        if scene.place in _WATERS and len({*words} & _AFLOAT) >= _ENOUGH:
            scene.place, scene.place_kind = f"boat on the {scene.place}", "ship_deck"


def _go_out(scene: SceneReading, words: Sequence[str]) -> None:
    """Move a scene outside the door of the place that it inherits."""
    places = lexicon.OUTDOOR - lexicon.INDOOR
    named = next((word for word in words if word in places and word in lexicon.PLACE_KINDS), "yard")
    scene.place, scene.place_kind = named, lexicon.place_kind(named)
    scene.scene_type, scene.reference = "outdoor", None
