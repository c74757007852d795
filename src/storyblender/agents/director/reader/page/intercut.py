"""Intercutting: ``INTERCUT - OFFICE / STABLE``; each line then belongs to the place of its character."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph
from storyblender.agents.director.reader.page.named_places import (
    last_scene_with_words,
    place_without_verb,
    type_of_place,
)
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import rule

_INTERCUT = re.compile(
    r"(?:BEGIN |START )?INTERCUT(?:TING)?(?: BETWEEN| WITH)?\b\s*[-–—:.]*\s*(?P<places>[^\n.]*)\.?\s*$", re.IGNORECASE
)
_BETWEEN = re.compile(r"\s*(?:/|&|,|\bAND\b|\bWITH\b|\bBETWEEN\b|\s[-–—]+\s)\s*", re.IGNORECASE)
_SIDE = re.compile(r"(?:INT|EXT)\.?\s+", re.IGNORECASE)
_OFF = re.compile(r"O\.?S|V\.?O|SCREEN|(?<!INTO )PHONE|FILTER|RADIO|OFF", re.IGNORECASE)


@rule("page.intercut", without=[])
def intercut_places(text: str, scenes: Sequence[SceneReading]) -> list[SceneReading]:
    """Return the places that a line orders to be intercut, as scenes to copy; empty if it orders no intercut.

    Args:
        text: The paragraph.
        scenes: The scenes before.
    """
    match = _INTERCUT.match(text.strip())
    if match is None or not scenes:
        return []
    named = [_SIDE.sub("", part).strip(" .\"'") for part in _BETWEEN.split(match["places"]) if part.strip(" .-")]
    found = [_place(name, scenes) for name in named]
    places = [scene for scene in found if scene is not None]
    if len(places) < 2 and len(scenes) > 1:  # ``INTERCUT:`` after two scenes: these two
        places = [scenes[-2], scenes[-1]]
    return places if len(places) > 1 else []


def _place(name: str, scenes: Sequence[SceneReading]) -> SceneReading | None:
    """Return a scene to copy for a place of the intercut, or None where the words name none."""
    been = last_scene_with_words(name, scenes)
    if been:
        return replace(been, place=been.place)
    told = place_without_verb(name.lower())
    place = told.place if told and told.place else name.lower()
    if not place or (told is None and len(name.split()) > 3):
        return None
    last = scenes[-1]
    return replace(
        last,
        heading="",
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=type_of_place(place, last.scene_type),
        reference=None,
        furniture=[],
    )


class Intercut:
    """Assigns the sentences of an intercut to its two or more places.

    Args:
        places: Scenes of two or more places.
        before: The sentences so far; characters of the current scene belong to its place.
        scenes: All scenes so far.
    """

    def __init__(self, places: list[SceneReading], before: Sequence[Sentence], scenes: Sequence[SceneReading]) -> None:
        self.places = places
        self.homes: dict[str, int] = {}
        self.at = next((i for i, place in enumerate(places) if place.place == scenes[-1].place), 0)
        here = {scene.place: index for index, scene in enumerate(places)}
        for sentence in before[-200:]:
            home = here.get(scenes[sentence.scene].place)
            if home is not None:
                self._assign_people(sentence, home)

    def place(self, told: list[Sentence], scenes: list[SceneReading], cue: Paragraph | None) -> None:
        """Give each sentence the scene of its place; a change of place opens a new scene.

        Args:
            told: Sentences of one paragraph.
            scenes: All scenes; new ones are appended.
            cue: The cue of the speaker, if it is a speech.
        """
        for sentence in told:
            named = self._named(sentence)
            home = named if named is not None else self._place_of_person(sentence, cue)
            if home is not None:
                self.at = home
            if named is not None or home is not None:
                self._assign_people(sentence, self.at)
            wanted = self.places[self.at]
            if scenes[-1].place != wanted.place:
                first = next((scene for scene in scenes if scene.place == wanted.place), None)
                scenes.append(
                    replace(
                        wanted,
                        id=len(scenes) + 1,
                        heading="",
                        number=scenes[-1].number,
                        reference=(first.reference or first.id) if first else None,
                        start=sentence.start,
                        end=sentence.end,
                        furniture=[],
                    )
                )
            sentence.scene = len(scenes) - 1
            scenes[-1].end = max(scenes[-1].end, sentence.end)

    def _named(self, sentence: Sentence) -> int | None:
        """Return the index of the place that a sentence begins with: ``In the stable, a tail``; None if none."""
        opening = sentence.paragraph.raw[sentence.start - sentence.paragraph.start :][:60].lower()
        match = re.match(
            r"\W*(?:back |then,? |meanwhile,? )*(?:in|at|on|inside|outside|from)?\s*(?:the |his "
            r"|her )?([a-z' ]{2,30})[:,]",
            opening,
        )
        if match is None:
            return None
        words = frozenset(match[1].split())
        return next(
            (
                i
                for i, scene in enumerate(self.places)
                if words and words <= frozenset(re.findall(r"[a-z']+", scene.place))
            ),
            None,
        )

    def _place_of_person(self, sentence: Sentence, cue: Paragraph | None) -> int | None:
        """Return the index of the place of the person who speaks or acts; new people are at the empty one."""
        if sentence.speech:
            seen = cue is not None and not _OFF.search(cue.extension)
            return self.homes.get(cue.name.lower(), self._empty_place()) if cue and seen else None
        people = _people(sentence)
        known = (self.homes[name] for names in people for name in names if name in self.homes)
        return next(known, self._empty_place() if people else None)

    def _empty_place(self) -> int | None:
        """Return the index of the one place where nobody was seen, or None."""
        empty = {*range(len(self.places))} - {*self.homes.values()}
        return empty.pop() if len(empty) == 1 else None

    def _assign_people(self, sentence: Sentence, home: int) -> None:
        """Note that the people of a sentence are at a place."""
        if sentence.speech:
            if sentence.speech.name and not _OFF.search(sentence.speech.extension):
                self.homes.setdefault(sentence.speech.name.lower(), home)
            return
        people = _people(sentence)
        for names in people[:1]:
            self.homes |= dict.fromkeys(names, home)
        for names in people[1:]:
            self.homes |= {name: home for name in names if name not in self.homes}


def _people(sentence: Sentence) -> list[list[str]]:
    """Return the names of each person named in a sentence."""
    mentions = [word.mention for word in sentence.words if word.mention and len(word.mention.candidates) == 1]
    return [[alias.lower() for alias in mention.candidates[0].aliases] for mention in mentions]
