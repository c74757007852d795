"""Cuts a script into scenes and sentences, by its headings or by the places that its text names."""

from __future__ import annotations

import re
from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Manuscript, Paragraph, without_quotations
from storyblender.agents.director.reader.page.asides import is_aside
from storyblender.agents.director.reader.page.hours import default_time
from storyblender.agents.director.reader.page.intercut import Intercut, intercut_places
from storyblender.agents.director.reader.page.named_places import NamedPlace, place_in_capitals, place_without_verb
from storyblender.agents.director.reader.page.prose_places import WHOLE
from storyblender.agents.director.reader.page.prose_scenes import read_scene_change
from storyblender.agents.director.reader.page.prose_sentences import prose_sentences
from storyblender.agents.director.reader.page.scenes import first_scene, read_heading, same_place, settle_sides
from storyblender.agents.director.reader.page.sentences import Sentence, SpokenText, action_sentences, speech_sentences
from storyblender.agents.director.reader.people.narrator import mark_narrator
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import as_rule

_LOOKED_AT = 3
"""Paragraphs searched for a place under a heading that names none."""
_INSIDE = re.compile(r"\b(?:in|inside|into|int)\b", re.IGNORECASE)
_PICTURED = frozenset({"comic", "columns"})
"""Kinds of pages on which the first words of a picture name its place."""


def cut_page(script: Manuscript, roster: Roster, scenes: list[SceneReading]) -> list[Sentence]:
    """Return the sentences and speeches of a script in reading order, and fill its scenes.

    Args:
        script: The page.
        roster: The people of the page.
        scenes: The scenes; filled here.
    """
    return _Cutter(script, roster, scenes).cut()


class _Cutter:
    """Cuts the paragraphs of one script."""

    def __init__(self, script: Manuscript, roster: Roster, scenes: list[SceneReading]) -> None:
        self.script = script
        self.roster = roster
        self.scenes = scenes
        self.page = script.screenplay.page
        self.headed = any(paragraph.kind == "heading" for paragraph in script.paragraphs)
        self.sentences: list[Sentence] = []
        self.cue: Paragraph | None = None
        self.picture: int | None = None
        self.read_ahead: int | None = None
        """Index of the first heading, if text before it belongs to its scene."""
        self.fresh = False
        """Whether a heading was just read."""
        self.intercut: Intercut | None = None
        self.homes: dict[str, int] = {}
        """Person -> index of the scene of the last picture that showed them."""

    def cut(self) -> list[Sentence]:
        """Return the sentences and speeches of the script."""
        for index, paragraph in enumerate(self.script.paragraphs):
            headed = paragraph.kind == "heading"
            with as_rule("place.heading" if headed else "place.told", paragraph.start, paragraph.end):
                if headed:
                    self._heading(index, paragraph)
                elif paragraph.kind == "cue":
                    self.cue = paragraph
                elif paragraph.kind != "cast":
                    self._action(index, paragraph)
        settle_sides(self.script.text, self.scenes, chat=self.page == "chat")
        return self.sentences

    # -- scenes ----------------------------------------------------------------------------------------------------
    def _heading(self, index: int, paragraph: Paragraph) -> None:
        """Open the scene of a heading."""
        self.intercut = None
        if index == self.read_ahead:
            return
        scene = read_heading(paragraph, self.scenes)
        if not scene.place:
            scene = self._placed_by_text(index, scene)
        self.scenes.append(scene)
        self.fresh, self.picture = True, paragraph.picture

    def _placed_by_text(self, index: int, scene: SceneReading) -> SceneReading:
        """Take the place of a heading such as ``Scene 4`` from the text below it, else the last place."""
        below = self.script.paragraphs[index + 1 : index + 1 + _LOOKED_AT]
        side: NamedPlace | None = None
        for paragraph in below:
            if paragraph.kind == "heading":
                break
            if paragraph.kind != "action":
                continue
            told = place_without_verb(without_quotations(paragraph.raw), pictured=True)
            if told and (told.place or told.scene_type) and (found := self._scene_at(told, paragraph, scene.number)):
                return replace(found, heading=scene.heading, start=scene.start, end=scene.end)
            side = side or told
        for paragraph in below[:1] if below and below[0].kind == "action" else []:
            found = read_scene_change(paragraph, self.scenes, "")
            if found and found.place:
                found.reference = same_place(found.place, found.scene_type, self.scenes)
                time = (side.time if side else None) or found.time
                return replace(
                    found, id=scene.id, heading=scene.heading, number=scene.number, start=scene.start, time=time
                )
        if not self.scenes:
            return scene
        last = self.scenes[-1]
        return replace(
            scene,
            place=last.place,
            place_kind=last.place_kind,
            scene_type=last.scene_type,
            reference=last.reference or last.id,
            time=(side.time if side else None) or scene.time,
        )

    def _open_without_heading(self, index: int, paragraph: Paragraph) -> None:
        """Read text before the first heading: it belongs to the first heading's scene, else it names the place."""
        told = (
            place_without_verb(paragraph.raw, pictured=self.page in _PICTURED) if paragraph.kind == "action" else None
        )
        ahead = next(
            (i for i in range(index, len(self.script.paragraphs)) if self.script.paragraphs[i].kind == "heading"), None
        )
        if ahead is not None and not (told and told.place):
            self._heading(ahead, self.script.paragraphs[ahead])
            self.read_ahead, self.scenes[-1].start, self.fresh = ahead, paragraph.start, False
            return
        change = self._scene_from_first_paragraphs(index) if self.script.prose or not (told and told.place) else None
        if told and told.place and not (change and change.place):
            self.scenes.append(self._new_scene(told, paragraph, ""))
            return
        self.scenes.append(change or first_scene(paragraph))
        if told and told.time and not (change and change.time_written):
            self.scenes[-1].time = told.time

    def _scene_from_first_paragraphs(self, index: int) -> SceneReading | None:
        """Return a scene of the place that the first paragraphs name, or None."""
        title = self.script.screenplay.title
        first = self.script.paragraphs[index]
        for paragraph in self.script.paragraphs[index : index + _LOOKED_AT]:
            change = read_scene_change(paragraph, [], title) if paragraph.kind == "action" else None
            if change and (change.place or self.script.prose):
                return replace(change, start=first.start)
        return None

    def _scene_at(self, told: NamedPlace, paragraph: Paragraph, number: str) -> SceneReading | None:
        """Return the scene that a named place opens; None if it is the current place."""
        last = self.scenes[-1] if self.scenes else None
        if last is None:
            return self._new_scene(told, paragraph, number)
        if (
            last.scene_type == "outdoor"
            and told.place.rpartition("'s ")[2] in WHOLE
            and not _INSIDE.search(paragraph.raw[:60])
        ):
            told = told._replace(scene_type="outdoor")  # a building that a street leads to is seen from outside
        if not told.place and told.scene_type:
            told = NamedPlace(self._other_side(told), told.scene_type, told.time)
        elif not told.place:
            if told.time in (None, last.time):
                return None
            told = NamedPlace(last.place, last.scene_type, told.time)
        if (told.place, told.scene_type) == (last.place, last.scene_type) and told.time in (None, last.time):
            return None
        return self._new_scene(told, paragraph, number)

    def _other_side(self, told: NamedPlace) -> str:
        """Return the building that the last scene named, for ``Inside.``"""
        last = self.scenes[-1]
        if told.scene_type == "outdoor" or last.scene_type == "indoor":
            return last.place
        words = re.findall(r"[a-z]+", self.script.text[last.start : last.end].lower())
        return next((word for word in words if word in WHOLE), last.place)

    def _new_scene(self, told: NamedPlace, paragraph: Paragraph, number: str) -> SceneReading:
        """Return a new scene at a named place."""
        scene_type = told.scene_type or "outdoor"
        last = self.scenes[-1] if self.scenes else None
        return SceneReading(
            id=len(self.scenes) + 1,
            heading="",
            place=told.place,
            place_kind=lexicon.place_kind(told.place),
            scene_type=scene_type,
            time=told.time or default_time(self.scenes, told.place),
            time_written=told.time or "",
            weather=last.weather if last and told.place and scene_type == "outdoor" == last.scene_type else "clear",
            reference=same_place(told.place, scene_type, self.scenes),
            number=number,
            start=paragraph.start,
            end=paragraph.end,
        )

    def _scene_of_people(self, paragraph: Paragraph, number: str) -> SceneReading | None:
        """Return the last scene of all people in a picture if it is at another place, else None."""
        named = self._people_in(paragraph)
        homes = {self.homes[person] for person in named if person in self.homes}
        last = self.scenes[-1]
        if len(homes) != 1 or not named or any(person not in self.homes for person in named):
            return None
        home = self.scenes[homes.pop()]
        if home.place == last.place:
            return None
        return self._new_scene(NamedPlace(home.place, home.scene_type, None), paragraph, number)

    def _people_in(self, paragraph: Paragraph) -> list[str]:
        """Return the ids of the people named in a paragraph of action."""
        told = action_sentences(paragraph, len(self.scenes) - 1, self.roster)
        mentions = [word.mention for sentence in told for word in sentence.words if word.mention]
        return [mention.candidates[0].id for mention in mentions if len(mention.candidates) == 1]

    def _scene_change(self, paragraph: Paragraph) -> SceneReading | None:
        """Return the scene that a paragraph opens without a heading, or None."""
        number = self.scenes[-1].number
        if self.fresh:
            return None
        if self.script.prose:
            change = read_scene_change(paragraph, self.scenes, self.script.screenplay.title)
            told = None if change else place_without_verb(without_quotations(paragraph.raw))
            return (
                replace(change, number=number) if change else self._scene_at(told, paragraph, number) if told else None
            )
        slug = place_in_capitals(paragraph.text, self.scenes)
        if slug:
            return self._scene_at(slug, paragraph, number)
        begins = paragraph.picture is not None and paragraph.picture != self.picture
        if begins or (self.page in _PICTURED and paragraph.picture is None):
            told = place_without_verb(paragraph.raw, pictured=True)
            return self._scene_at(told, paragraph, number) if told else self._scene_of_people(paragraph, number)
        if not self.headed and self.page not in ("play", "chat"):
            change = read_scene_change(paragraph, self.scenes)
            return replace(change, number=number) if change else None
        return None

    # -- sentences -------------------------------------------------------------------------------------------------
    def _action(self, index: int, paragraph: Paragraph) -> None:
        """Add the sentences of a paragraph of action."""
        if not self.scenes:
            self._open_without_heading(index, paragraph)
        elif paragraph.kind == "action":
            change = self._scene_change(paragraph)
            if change:
                self.scenes.append(change)
        self.fresh, self.picture = False, paragraph.picture
        self.scenes[-1].end = max(self.scenes[-1].end, paragraph.end)
        told = self._sentences_of(index, paragraph)
        if self.intercut:
            self.intercut.place(told, self.scenes, self.cue)
        self.sentences += told
        if self.page in _PICTURED and paragraph.kind == "action":
            self.homes |= dict.fromkeys(self._people_in(paragraph), len(self.scenes) - 1)

    def _sentences_of(self, index: int, paragraph: Paragraph) -> list[Sentence]:
        """Return the sentences of a paragraph."""
        scene = len(self.scenes) - 1
        whole = Sentence(paragraph, scene, paragraph.start, paragraph.end)
        if paragraph.kind in ("title", "sound"):
            return [replace(whole, beside="title" if paragraph.kind == "title" else "sound")]
        if paragraph.kind == "dialogue":
            return speech_sentences(self.script, index, scene, self.cue)
        if paragraph.kind != "action":
            return []
        places = intercut_places(paragraph.text, self.scenes)
        if places:
            self.intercut = Intercut(places, self.sentences, self.scenes)
            return [replace(whole, beside="aside")]
        if self.page == "chat" and self.cue:
            return self._message(paragraph, scene)
        if self.script.prose:
            return prose_sentences(paragraph, scene, self.roster)
        told = action_sentences(paragraph, scene, self.roster)
        for sentence in told:
            if is_aside(sentence, self.script.text, drawn=self.page in _PICTURED):
                sentence.beside = "aside"
        return told

    def _message(self, paragraph: Paragraph, scene: int) -> list[Sentence]:
        """Return the sentences of a message: its sender speaks off screen, and its content is shown."""
        assert self.cue is not None, "a message has a sender"
        sender = next(iter(self.roster.find(self.cue.name)), None)
        told = action_sentences(paragraph, scene, self.roster)
        for sentence in told:
            mark_narrator(sentence.words, sender)
            words = self.script.text[sentence.start : sentence.end]
            sentence.speech = SpokenText(" ".join(words.split()), self.cue.name, self.cue.extension)
        return told
