"""Sentences and speeches of a screenplay, in reading order."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Literal

from storyblender.agents.director import lexicon
from storyblender.agents.director.camera_phrases import both_directions
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.words import Word, joined, tokenize
from storyblender.agents.director.reader.manuscript import Manuscript, Paragraph, without_brackets, without_quotations
from storyblender.agents.director.reader.people.mentions import mark_mentions
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import CameraNote

_ON_A_SCREEN = re.compile(
    r"\b(screen|screens|monitor|monitors|tv|television|photo|photograph|picture|painting|dream|flashback|video|mirror)\b"
)
_SHOWING = re.compile(r"\b(?:show|depict)(?:s|ed)\b(?! up)")
_LONGEST = 150
"""Words of the longest sentence that is read as one; so the time to read a page does not depend on where it has stops.
"""
_PAUSES = frozenset({",", ";", ":", "--", "—", "–"})
_ABBREVIATIONS = frozenset({"mr", "mrs", "ms", "dr", "prof", "st", "sgt", "lt", "vs", "jr", "capt"})


@dataclass
class SpokenText:
    """The speech of a sentence: its words, speaker and brackets."""

    text: str
    name: str = ""
    """Screenplay: the cue."""
    extension: str = ""
    parenthetical: str = ""
    sung: bool = False
    dual: bool = False
    verb: str = "say"
    """Prose: said, whispered, shouted ..."""
    subject: list[Word] = field(default_factory=list)
    """Prose: the words for who says it."""
    after: Word | None = None
    """Prose: who is spoken of right after it, where nobody is said to say it: ``"It is fear." She raised her veil``."""
    alone: bool = False
    """Prose: its paragraph tells nothing else."""


@dataclass
class Sentence:
    """One sentence of action, or one speech; in prose possibly both."""

    paragraph: Paragraph
    scene: int
    start: int
    end: int
    words: list[Word] = field(default_factory=list)
    speech: SpokenText | None = None
    camera: CameraNote | None = None
    beside: Literal["title", "sound", "aside"] | None = None
    """Set for on-screen text, sounds and asides, which change no positions."""
    pictured: bool = False
    """What it tells is on a screen, in a photograph or a dream: nobody in it comes on stage."""


def action_sentences(paragraph: Paragraph, scene: int, roster: Roster) -> list[Sentence]:
    """Return the sentences of an action paragraph, each with the camera direction that holds from it.

    Args:
        paragraph: The paragraph.
        scene: Index of its scene.
        roster: The cast.
    """
    body = without_quotations(without_brackets(paragraph.body))
    words = mark_mentions(tokenize(body, paragraph.start), roster)
    sentences: list[Sentence] = []
    for whole in split_sentences(words):
        for run, pictured in _at_colon(whole):
            sentences.append(Sentence(paragraph, scene, run[0].start, run[-1].end, run, pictured=pictured))
    for at, camera in paragraph.cameras:
        _attach_camera(sentences, camera, at, paragraph, scene)
    return sentences


def _attach_camera(sentences: list[Sentence], camera: CameraNote, at: int, paragraph: Paragraph, scene: int) -> None:
    """Give a camera direction to the first sentence that ends after it, else to the last, else to a new empty one.

    What is said of the focus alone joins the direction that the sentence has.
    """
    holder = next((sentence for sentence in sentences if sentence.end >= at and sentence.camera), None)
    if holder and holder.camera and (joined := both_directions(holder.camera, camera)):
        holder.camera = joined
        return
    free = [sentence for sentence in sentences if sentence.camera is None]
    following = next((sentence for sentence in free if sentence.end >= at), free[-1] if free else None)
    spoken = any(word.solid for sentence in sentences for word in sentence.words)
    if following and spoken:
        following.camera = camera
    elif not sentences:
        sentences.append(Sentence(paragraph, scene, paragraph.start, paragraph.end, camera=camera))


def split_sentences(words: list[Word]) -> list[list[Word]]:
    """Return words cut after full stops, exclamation and question marks; names are never cut."""
    sentences: list[list[Word]] = [[]]
    for index, word in enumerate(words):
        sentences[-1].append(word)
        if word.text not in (".", "!", "?", "..."):
            continue
        before = words[index - 1].low.strip(".") if index else ""
        after = words[index + 1].text if index + 1 < len(words) else ""
        if (word.text == "." and before in _ABBREVIATIONS) or after in ('"', "”", "'"):
            continue
        sentences.append([])
    return [part for sentence in sentences for part in of_readable_length(sentence)]


def of_readable_length(words: list[Word]) -> list[list[Word]]:
    """Return words cut after their last pause where they are too long for one sentence."""
    parts: list[list[Word]] = []
    at = 0
    while len(words) - at > _LONGEST:
        pauses = (i for i in range(at + _LONGEST, at, -1) if words[i - 1].text in _PAUSES)
        end = next(pauses, at + _LONGEST)
        parts.append(words[at:end])
        at = end
    return [*parts, words[at:]] if at < len(words) else parts


def _at_colon(words: list[Word]) -> list[tuple[list[Word], bool]]:
    """Cut at a colon; with each part, whether it is only pictured: ``On the monitor: Pip pushes a mop``."""
    colon = next((index for index, word in enumerate(words) if word.text == ":"), None)
    if colon is None:
        return [(words, False)]
    before, after = words[:colon], words[colon + 1 :]
    if (
        after
        and before
        and before[0].low in lexicon.PREPOSITIONS
        and not any(w.low in FORMS and FORMS[w.low].kind in ("3sg", "past", "aux") for w in before)
    ):
        return (
            [([*before, replace(words[colon], text=","), *after], False)]
            if not _ON_A_SCREEN.search(joined(before))
            else [(before, False), (after, True)]
        )
    pictured = _ON_A_SCREEN.search(joined(before)) and not any(word.named for word in before)
    if before and after and (pictured or _SHOWING.search(joined(before))):
        return [(before, False), (after, True)]
    return [(part, False) for part in (before, after) if part]


def speech_sentences(manuscript: Manuscript, index: int, scene: int, cue: Paragraph | None) -> list[Sentence]:
    """Return the speech of a dialogue paragraph, with the parenthetical right before it.

    Args:
        manuscript: The script.
        index: Index of the paragraph.
        scene: Index of its scene.
        cue: The paragraph with the name, or None.
    """
    paragraph = manuscript.paragraphs[index]
    before = manuscript.paragraphs[index - 1] if index else paragraph
    speech = SpokenText(
        " ".join(paragraph.text.split()),
        cue.name if cue else "",
        cue.extension if cue else "",
        before.text if before.kind == "parenthetical" else "",
        dual=cue.dual if cue else False,
        sung=manuscript.screenplay.elements[paragraph.element].kind == "lyric",
    )
    return [Sentence(paragraph, scene, paragraph.start, paragraph.end, speech=speech)]
