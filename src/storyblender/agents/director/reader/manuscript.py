"""The script as the reader works on it: paragraphs with the offsets of the text as the user wrote it.

What is no sentence (markup, camera directions) is blanked with spaces of equal length.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from storyblender.agents.director import camera_phrases
from storyblender.agents.director.lexicon.foreign import Tongue, tongue_of
from storyblender.agents.director.naming import UPPER
from storyblender.agents.director.reader.capitals import in_sentence_case
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.agents.director.reading import CameraNote
from storyblender.screenplay.model import Element, Screenplay

ParagraphKind = Literal["heading", "action", "cue", "parenthetical", "dialogue", "title", "sound", "cast"]

_KINDS: dict[str, ParagraphKind] = {
    "heading": "heading", "action": "action", "shot": "action", "cue": "cue", "parenthetical": "parenthetical",
    "dialogue": "dialogue", "lyric": "dialogue", "title": "title", "sound": "sound", "cast": "cast",
}  # fmt: skip
_MARKUP = re.compile(r"[*\\]|(?<!\w)_(?=\S)|(?<=\S)_(?!\w)|\[\[.*?\]\]|/\*.*?\*/", re.DOTALL)
_BRACKETS = re.compile(r"\([^)]*\)")
_ASIDES = re.compile(r"\([^)]*\)|\[[^\]]*\]")
_SENTENCE_END = re.compile(
    r"(?<=[.!?])(?<!\bMR\.)(?<!\bDR\.)(?<!\bMS\.)(?<!\bST\.)(?<!\bMRS\.)(?<!\bMr\.)(?<!\bDr\.)(?<!\bMs\.)(?<!\bSt\.)"
    rf"(?<!\bMrs\.)(?<!\b[A-Z]\.)\s+(?=[{UPPER}\"“'‘0-9#])"
)
_LONGEST = 1000
"""Characters of what is searched for a camera direction at once."""
QUOTATION = re.compile(
    r""""[^"”]*["”]|“[^"“”]*["”]|«[^«»]*»|„[^„“”]*[“”]|‘[^‘’]*(?:(?<=\w)’(?=\w)[^‘’]*)*’(?!\w)"""
    rf"""|(?<!\w)'(?=[{UPPER}])[^"]{{1,400}}?[,.!?…—-]'(?!\w)"""
)
"""Something in quotation marks, also single ones; an apostrophe stands between letters."""
QUOTATION_MARKS = "\"“”«»„‘’'"


@dataclass
class Paragraph:
    """One element of the screenplay that tells something."""

    kind: ParagraphKind
    element: int
    """Index into ``Screenplay.elements``."""
    start: int
    end: int
    text: str
    """What it says, without markup."""
    raw: str
    """Its characters as written, markup blanked; ``raw[i]`` is character ``start + i`` of the script."""
    name: str = ""
    extension: str = ""
    dual: bool = False
    scene_number: str = ""
    picture: int | None = None
    """Number of its panel, series item or table row."""
    cameras: list[tuple[int, CameraNote]] = field(default_factory=list)
    """Camera directions with the offset they hold from."""
    body: str = ""
    """``raw`` without camera directions."""


@dataclass
class Manuscript:
    """The whole script as paragraphs."""

    screenplay: Screenplay
    paragraphs: list[Paragraph]
    text: str
    """The characters all offsets count, with action in its usual capitals."""

    @cached_property
    def tongue(self) -> Tongue | None:
        """The language of the action, or None for English."""
        return tongue_of(" ".join(p.raw for p in self.paragraphs if p.kind == "action"))

    @property
    def prose(self) -> bool:
        """Whether it is a story and no screenplay."""
        return self.screenplay.format == "prose"


def blanked(pattern: re.Pattern[str], text: str) -> str:
    """Return ``text`` with every match of ``pattern`` replaced by as many spaces."""
    return pattern.sub(lambda match: " " * len(match.group(0)), text)


def without_brackets(text: str) -> str:
    """Return a text with descriptions in brackets blanked."""
    return blanked(_BRACKETS, text)


def without_asides(text: str) -> str:
    """Return a text with everything in round and square brackets blanked."""
    return blanked(_ASIDES, text)


def without_quotations(text: str) -> str:
    """Return a text with everything in quotation marks blanked."""
    return blanked(QUOTATION, text)


def open_manuscript(screenplay: Screenplay) -> Manuscript:
    """Return a screenplay laid out for reading."""
    text = in_sentence_case(screenplay)
    told: list[tuple[int, ParagraphKind, list[Element]]] = []
    for index, element in enumerate(screenplay.elements):
        kind = _KINDS.get(element.kind)
        _, before, pieces = told[-1] if told else (0, None, [])
        if kind == before == "action" and _only_comment(screenplay.text[pieces[-1].end : element.start]):
            pieces.append(element)
        elif kind:
            told.append((index, kind, [element]))
    paragraphs = [_paragraph(screenplay, text, index, _joined(pieces), kind) for index, kind, pieces in told]
    return Manuscript(screenplay, paragraphs, text)


def _joined(pieces: list[Element]) -> Element:
    """Return one paragraph of the pieces around its notes."""
    if len(pieces) == 1:
        return pieces[0]
    return pieces[-1].model_copy(update={"start": pieces[0].start, "text": " ".join(piece.text for piece in pieces)})


def _only_comment(between: str) -> bool:
    """Whether only a note or cut text, and no blank line, divides two pieces of one paragraph."""
    return between.strip() != "" and not blanked(_MARKUP, between).strip() and not re.search(r"\n\s*\n", between)


def _paragraph(screenplay: Screenplay, text: str, index: int, element: Element, kind: ParagraphKind) -> Paragraph:
    """Return an element as a paragraph, with its markup blanked."""
    raw = blanked(_MARKUP, text[element.start : element.end])
    paragraph = Paragraph(
        kind, index, element.start, element.end, element.text, raw, element.name, element.extension, element.dual,
        element.scene_number, element.picture, body=raw,
    )  # fmt: skip
    if kind == "action" and screenplay.format != "prose":
        _take_out_cameras(paragraph)
    return paragraph


def _take_out_cameras(paragraph: Paragraph) -> None:
    """Move the camera directions of a paragraph from its body to its notes."""
    body = list(paragraph.raw)
    for start, end in _sentence_spans(paragraph.raw):
        camera, span = camera_phrases.parse_direction(paragraph.raw[start:end])
        if camera:
            camera, (first, last) = _without_action(camera, span, paragraph.raw[start:end])
            paragraph.cameras.append((paragraph.start + start, camera))
            kept = range(start + first, start + last)
            for at in range(start, end):
                body[at] = body[at] if at in kept or body[at] == "\n" else " "
    paragraph.body = "".join(body)


def _without_action(
    camera: CameraNote, span: camera_phrases.Span, sentence: str
) -> tuple[CameraNote, camera_phrases.Span]:
    """Keep the action in ``OVER RICK'S SHOULDER: Ilsa and Laszlo walk``: a subject that acts is kept as action.

    Returns:
        The direction with the subject only, and the span of the sentence that is action.
    """
    words = camera.subject.split()
    verb = next((i for i, word in enumerate(words) if i and word.islower() and _acts(words[i - 1], word)), None)
    at = sentence.rfind(camera.subject)
    if span[0] < span[1] or verb is None or at < 0:
        return camera, span
    return replace(camera, subject=" ".join(words[:verb])), (at, len(sentence))


def _acts(left: str, word: str) -> bool:
    """Whether a word is a plural verb after a name: ``Laszlo walk``."""
    return left[0].isupper() and form_kind(word) == "base"


def _sentence_spans(text: str) -> list[tuple[int, int]]:
    """Return rough sentences: cut after full stops before a capital or a quotation mark."""
    spans: list[tuple[int, int]] = []
    start = 0
    for match in _SENTENCE_END.finditer(text):
        spans += _pieces(start, match.start())
        start = match.end()
    return [*spans, *_pieces(start, len(text))]


def _pieces(start: int, end: int) -> list[tuple[int, int]]:
    """Cut a span that is too long for a sentence."""
    return [(at, min(at + _LONGEST, end)) for at in range(start, max(end, start + 1), _LONGEST)]
