"""Decides the set of each scene: its kit, the options of the kit, snow on the ground, and how full the place is."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from storyblender.agents.director.crowds import crowd_in
from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.reading import Reading, SceneReading
from storyblender.catalog.sets import SETS, SetKit
from storyblender.catalog.sets.period import period_of
from storyblender.memory.vocabulary import Age, Crowd

_OPTION_WORDS: Final = {
    "log": r"\blog\b|cabin|lodge",
    "pines": r"\bpines?\b|\bfirs?\b|snow",
    "palms": r"palms?|tropic|island|lagoon|jungle|rain ?forest",
    "dry": r"\bdry\b|prairie|savanna|wheat|corn|dusty|steppe",
    "lighthouse": r"light ?house",
    "cranes": r"\bcranes?\b",
    "space": r"\bspace|star ?ship|\bstars\b|orbit|shuttle|galax|planet",
    "frontier": r"frontier|western town|cowboy|gunslinger|sheriff|marshal|saloon|stagecoach|gold rush",
    "railway": r"station|rail|\btrains?\b|ticket|depot",
    "train": r"\btrain (stands|waits|stops|is standing|has stopped|at the platform)",
    "air": r"\bplane|air ?plane|aero ?plane|aircraft|airliner|\bjet\b|flight",
    "taxi": r"\btaxi|\bcab\b|cabbie",
}
_SNOW: Final = r"\bsnow(y|field|drift|bound)?\b|glacier|\barctic|\bantarctic|blizzard|\bfrozen"
_SHIP_IN_SPACE: Final = r"\bspace|star ?ship|airlock|\bhyper|cryo|\borbit"
_ON_EARTH: Final = (
    r"hotel|hospital|school|office|house|home|flat|apartment|prison|police|court|castle|palace|museum|theat"
)
"""Words of a place that is not aboard a ship in space, though the story has one."""


@dataclass(frozen=True)
class ChosenSet:
    """What the Director decides about the set of a scene; the fields are those of ``SceneSetup``."""

    kit: str
    set_options: tuple[str, ...]
    snow: bool
    crowd: Crowd | None


class SetChoice:
    """Decides the sets of a story, scene by scene in story order.

    Args:
        reading: The reading of the script.
        summary: Summary of the story.
    """

    def __init__(self, reading: Reading, summary: str) -> None:
        self._age: Age | None = reading.age
        self._summary = summary.lower()
        headings = " / ".join(scene.heading for scene in reading.scenes).lower()
        self._in_space = re.search(_SHIP_IN_SPACE, headings) is not None
        self._chosen: dict[int, ChosenSet] = {}

    def decide(self, scene: SceneReading, things: Sequence[str], contents: str, action: str) -> ChosenSet:
        """Return the set of a scene: that of the earlier scene in the same place if there is one.

        Args:
            scene: The scene.
            things: Ids of the people and things that are there.
            contents: The place and what is in it, in words.
            action: The action of the scene, without its dialogue.
        """
        before = self._chosen.get(scene.reference or 0)
        kit = before.kit if before else choose_kit(scene, things, contents, self._age)
        options = before.set_options if before else self._options(scene, SETS[kit], contents.lower())
        snow = scene.weather == "snow" or re.search(_SNOW, scene.place.lower()) is not None
        crowd = crowd_in(scene.place, action, before.crowd if before else None)
        if scene.snow is not None:
            snow = scene.snow
        if scene.crowd is not None:
            crowd = None if scene.crowd == "none" else scene.crowd
        chosen = self._chosen[scene.id] = ChosenSet(kit, options, snow, crowd)
        return chosen

    def _options(self, scene: SceneReading, kit: SetKit, words: str) -> tuple[str, ...]:
        """Return the options of a kit that a person named, or that the words of the place or the story ask for."""
        if scene.set_options is not None:
            return tuple(option for option in scene.set_options if option in kit.options)
        words = f"{words} {scene.weather}"
        story = f"{words} {self._summary}" if period_of(kit, self._age) == "past" else words
        aboard = self._in_space and not re.search(_ON_EARTH, words)

        def is_meant(option: str) -> bool:
            listed = "|".join(rf"\b{re.escape(word)}" for word in kit.option_words.get(option, ()))
            told = re.search(listed or _OPTION_WORDS[option], story if option == "frontier" else words)
            return told is not None or (option == "space" and aboard)

        return tuple(filter(is_meant, kit.options))
