"""Fountain, the whole syntax (fountain.io), with every element tied to its characters.

Notes and boneyard are blanked with spaces of equal length before the lines are read, so offsets stay true. Forcing
characters (``. ! @ > ~``) lie outside an element's span; emphasis lies inside it, and is stripped from ``text`` only.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from storyblender.screenplay.comments import blank, find_comments
from storyblender.screenplay.cues import (
    item_mark,
    looks_like_cue,
    opens_series,
    plain_line,
    split_cue,
    strip_emphasis,
)
from storyblender.screenplay.headings import is_heading, scene_label, split_number
from storyblender.screenplay.layout.front import titled
from storyblender.screenplay.layout.labels import element_of_label
from storyblender.screenplay.layout.spacing import PageRow, line_spacing
from storyblender.screenplay.line_kinds import TRANSITION, kind_of_words
from storyblender.screenplay.model import Element, ElementKind, Screenplay

_LISTS_SHOTS = re.compile(r"\bMONTAGE\b|\bSERIES OF SHOTS\b")
"""Nobody is called so: what stands right below is no speech."""
_SCENE_NUMBER = re.compile(r"#([\w.\-–()]+)#$")
_TITLE_KEY = re.compile(r"([^\W\d_][\w ]{0,30}):[ \t]*(.*)")
_MANNER = re.compile(r"\((?=[^)]*[A-Z])[^a-z()]+\)")
"""A bracket in capitals inside a speech, as in sitcoms: how its next words are said."""
_LONGEST_NAME = 4
"""Words of a name above a speech in capitals."""
_MARK = re.compile(r"#+|[>=~]?")
_KNOWN_TITLE_KEYS = {
    "title", "credit", "author", "authors", "source", "notes", "draft date", "date", "contact", "copyright", "revision",
}  # fmt: skip


class _Line(NamedTuple):
    """A line of the file: ``shown`` has notes and boneyard blanked out."""

    number: int
    start: int
    raw: str
    shown: str

    @property
    def words(self) -> str:
        """The words of the line as shown."""
        return self.shown.strip()

    @property
    def blank(self) -> bool:
        """Whether it is blank as written; a line that only holds a note is not."""
        return not self.raw.strip()


def parse(text: str, path: str = "") -> Screenplay:
    """Read Fountain.

    Args:
        text: The script, newlines as ``\\n``.
        path: Named in errors.

    Raises:
        InputError: A boneyard or a note is opened and never closed.
    """
    return _FountainReader(text, path).read()


class _FountainReader:
    """Reads the lines of a Fountain file into elements, from top to bottom."""

    def __init__(self, text: str, path: str) -> None:
        self.text = text
        self.path = path
        self.comments = find_comments(text, path)
        self.shown = blank(text, self.comments)
        self.lines = self._split_lines()
        self.elements: list[Element] = []
        self.at = 0
        self.labelled = not any(is_heading(line.words) for line in self.lines)
        """Whether no heading begins with INT or EXT, so that ``Scene 2`` counts as a heading."""
        self.series = False
        """Whether the current line is inside a series of shots."""
        self.pictures = 0
        self.picture: int | None = None

    def read(self) -> Screenplay:
        """Return the screenplay."""
        title_page = self._title_page()
        while self.at < len(self.lines):
            self._element()
        title_page, self.elements = titled(title_page, self.elements)
        self._add_comments()
        return Screenplay(
            path=self.path,
            format="fountain",
            text=self.text,
            title_page=title_page,
            elements=tuple(sorted(self.elements, key=lambda element: element.start)),
        )

    def _split_lines(self) -> list[_Line]:
        """Return the lines of the text."""
        lines, start = [], 0
        for number, raw in enumerate(self.text.split("\n"), 1):
            lines.append(_Line(number, start, raw, self.shown[start : start + len(raw)]))
            start += len(raw) + 1
        spacing = line_spacing([PageRow(len(line.raw) - len(line.raw.lstrip()), line.words) for line in lines])
        return [line for index, line in enumerate(lines) if index not in spacing]

    def _title_page(self) -> tuple[tuple[str, str], ...]:
        """Return keys and values of the title page, and move past it."""
        first = next((index for index, line in enumerate(self.lines) if line.words), len(self.lines))
        block = []
        for line in self.lines[first:]:
            if line.blank:
                break
            block.append(line)
        keys = [match[1].strip().lower() for line in block if (match := _TITLE_KEY.fullmatch(line.shown.rstrip()))]
        if not block or not _TITLE_KEY.fullmatch(block[0].shown.rstrip()) or not _KNOWN_TITLE_KEYS & set(keys):
            return ()
        entries: list[tuple[str, list[str]]] = []
        for line in block:
            match = _TITLE_KEY.fullmatch(line.shown.rstrip())
            if match:
                entries.append((match[1].strip(), [match[2]]))
            else:
                entries[-1][1].append(line.words)
        self.at = first + len(block)
        return tuple(
            (key, strip_emphasis("\n".join(part.strip() for part in value if part.strip()))) for key, value in entries
        )

    def _element(self) -> None:
        """Read the element at the current line."""
        line = self.lines[self.at]
        if not line.words:
            self.at += 1
            return
        kind = self._kind(self.at)
        self._follow_series(kind, line.words)
        if kind == "cue":
            self._speech()
        elif kind == "action":
            self._action()
        else:
            self._single(kind, line)
            self.at += 1

    def _kind(self, index: int) -> ElementKind:
        """Classify the line at ``index`` by its forcing mark, or by its form and its neighbours."""
        words = self.lines[index].words
        if not words:  # a boneyard and nothing beside it
            return "action"
        before = index == 0 or not self.lines[index - 1].words or self._ends_shot(index - 1)
        after = index + 1 == len(self.lines) or self.lines[index + 1].blank
        forced = self._forced(words)
        if forced is not None:
            return forced
        words = plain_line(words)
        told = kind_of_words(words)
        if told == "heading" and (before or words == words.upper()):
            return "heading"
        if told not in (None, "heading") and before and (after or _LISTS_SHOTS.search(words) or opens_series(words)):
            return told
        label = scene_label(words) if before and len(words) <= 80 else None
        if label and (self.labelled or label.end() == len(words)):
            return "heading" if self.labelled else "section"
        labelled = element_of_label(words[item_mark(words) :] if self.series else words)
        if labelled and labelled[0] != "section":
            return labelled[0]
        named = before and not after and looks_like_cue(words)
        return "cue" if named and not self._goes_on_loud(index) else "action"

    def _goes_on_loud(self, index: int) -> bool:
        """Return whether a long line in capitals is followed by more: action on the page of a sitcom."""
        below = self.lines[index + 1].words
        return len(self.lines[index].words.split()) > _LONGEST_NAME and below == below.upper() and below[0] != "("

    def _ends_shot(self, index: int) -> bool:
        """Return whether a line is a cut, so that a heading may follow without a blank line."""
        return TRANSITION.fullmatch(self.lines[index].words) is not None

    def _follow_series(self, kind: ElementKind, words: str) -> None:
        """Note where a series of shots begins and ends, and open a picture for each of its items."""
        if kind == "heading":
            self.series, self.picture = _LISTS_SHOTS.search(words) is not None, None
        elif kind in ("section", "transition"):
            self.series, self.picture = opens_series(words), None
        elif kind == "action" and self.series:
            self.pictures += 1
            self.picture = self.pictures
        elif kind in ("title", "sound") and item_mark(words):
            self.picture = None

    @staticmethod
    def _forced(words: str) -> ElementKind | None:
        """Return the kind that a forcing mark at the start of a line gives, or None."""
        if re.fullmatch(r"={3,}", words):
            return "page_break"
        if re.match(r"\.[^\W_]", words):
            return "heading"
        if words[0] == ">":
            return "centered" if words[-1] == "<" and len(words) > 1 else "transition"
        marks: dict[str, ElementKind] = {"!": "action", "@": "cue", "~": "lyric", "#": "section", "=": "synopsis"}
        return marks.get(words[0])

    def _single(self, kind: ElementKind, line: _Line) -> None:
        """Add an element of one line."""
        number = ""
        start, end = self._trim(line.start, line.start + len(line.shown))
        if kind == "heading":
            start += self.text[start] == "."
            number, start, end = self._without_number(start, end)
        elif kind in ("title", "sound"):
            words = self.shown[start:end]
            if plain_line(words) != words:
                start, end = start + len(words) - len(words.lstrip("_*")), start + len(words.rstrip("_*"))
                words = self.shown[start:end]
            mark = item_mark(words) if self.series else 0
            labelled = element_of_label(words[mark:])
            start += mark + (labelled[1] if labelled else 0)
        elif kind in ("lyric", "section", "synopsis", "transition", "centered"):
            start = _MARK.match(self.shown, start, end).end()  # pyright: ignore[reportOptionalMemberAccess]
            end -= kind == "centered"
        self._add(kind, start, end, scene_number=number)

    def _without_number(self, start: int, end: int) -> tuple[str, int, int]:
        """Return the number of a heading (``#12A#``, or ``12A`` before it), and the span without it."""
        match = _SCENE_NUMBER.search(self.shown[start:end])
        if match:
            return match[1], start, start + match.start()
        number, after = split_number(self.shown[start:end])
        if not number:
            return "", start, end
        again = re.search(rf"\s{re.escape(number)}[.)]?$", self.shown[start + after : end])
        return number, start + after, start + after + again.start() if again else end

    def _action(self) -> None:
        """Add a paragraph of action."""
        first = self.at
        self.at += 1
        while self.at < len(self.lines) and not self.lines[self.at].blank:
            line = self.lines[self.at]
            another = self.series and item_mark(line.words) > 0
            if line.words and (another or line.words[0] == "!" or self._kind(self.at) != "action"):
                break
            self.at += 1
        start = self.lines[first].start + len(self.lines[first].shown) - len(self.lines[first].shown.lstrip())
        start += self.text[start] == "!"
        start += item_mark(self.lines[first].words) if self.series else 0
        self._add_pieces("action", *self._unbracketed(start, self._end_of(self.at - 1)))

    def _unbracketed(self, start: int, end: int) -> tuple[int, int]:
        """Return the span inside the brackets of action that is all in brackets, as in sitcoms."""
        start, end = self._trim(start, end)
        words = self.shown[start:end]
        whole = words[:1] == "(" and words.find(")") == len(words) - 1 and len(words.split()) > 1
        return (start + 1, end - 1) if whole else (start, end)

    def _speech(self) -> None:
        """Add a cue and its speech."""
        line = self.lines[self.at]
        start, end = self._trim(line.start, line.start + len(line.shown))
        start += self.text[start] == "@"
        name, extension, dual = split_cue(self.shown[start:end])
        end -= dual
        self._add("cue", start, end, name=strip_emphasis(name), extension=extension, dual=dual)
        self.at += 1
        while self._in_speech(self.at):
            first = self.at
            kind = self._speech_kind(self.lines[first].words)
            self.at += 1
            while self._speech_goes_on(kind):
                self.at += 1
            lyric = kind == "lyric"
            said = self.shown.find(")", self.lines[first].start, self._end_of(self.at - 1)) + 1
            start = self.lines[first].start + (self.lines[first].shown.find("~") + 1 if lyric else 0)
            if kind == "parenthetical" and self.shown[said : self._end_of(self.at - 1)].strip():
                self._add_pieces(kind, start, said, dual=dual)
                kind, start = "dialogue", said
            for manner in _MANNER.finditer(self.shown, start, self._end_of(self.at - 1)) if kind == "dialogue" else ():
                self._add_pieces(kind, start, manner.start(), dual=dual)
                self._add_pieces("parenthetical", *manner.span(), dual=dual)
                start = manner.end()
            self._add_pieces(kind, start, self._end_of(self.at - 1), dual=dual)

    def _in_speech(self, index: int) -> bool:
        """Return whether a line belongs to the speech above; it ends at a blank line without two spaces."""
        if index >= len(self.lines) or not self.lines[index].blank:
            return index < len(self.lines)
        following = index + 1 < len(self.lines) and not self.lines[index + 1].blank
        return len(self.lines[index].raw) >= 2 and following and self._kind(index + 1) == "action"

    @staticmethod
    def _speech_kind(words: str) -> ElementKind:
        """Return the kind of a line inside a speech."""
        return "parenthetical" if words.startswith("(") else "lyric" if words.startswith("~") else "dialogue"

    def _speech_goes_on(self, kind: ElementKind) -> bool:
        """Return whether the current line belongs to the element of speech above."""
        if not self._in_speech(self.at) or kind == "lyric":
            return False
        before = self.lines[self.at - 1].words
        if kind == "parenthetical" and (")" not in before or before.endswith(")")):
            return ")" not in before
        return self._speech_kind(self.lines[self.at].words) == "dialogue"

    def _end_of(self, index: int) -> int:
        """Return the end offset of a line."""
        return self.lines[index].start + len(self.lines[index].shown)

    def _trim(self, start: int, end: int) -> tuple[int, int]:
        """Return a span without the spaces around what is shown in it."""
        shown = self.shown[start:end]
        return start + len(shown) - len(shown.lstrip()), start + len(shown.rstrip())

    def _add_pieces(self, kind: ElementKind, start: int, end: int, *, dual: bool = False) -> None:
        """Add what lies between the comments of a span, one element a piece, so that each is verbatim."""
        inside = [comment for comment in self.comments if start < comment.end and comment.start < end]
        for comment in inside:
            self._add(kind, start, comment.start, dual=dual)
            start = max(start, comment.end)
        self._add(kind, start, end, dual=dual)

    def _add(
        self,
        kind: ElementKind,
        start: int,
        end: int,
        *,
        name: str = "",
        extension: str = "",
        scene_number: str = "",
        dual: bool = False,
    ) -> None:
        """Add an element."""
        start, end = self._trim(start, max(start, end))
        if start >= end:
            return
        text = strip_emphasis(self.shown[start:end])
        if kind == "parenthetical":
            text = text.strip("()").strip()
        self.elements.append(
            Element(
                kind=kind,
                text=text,
                start=start,
                end=end,
                line=self._line_at(start),
                name=name,
                extension=extension,
                scene_number=scene_number,
                dual=dual,
                picture=self.picture,
            )
        )

    def _line_at(self, offset: int) -> int:
        """Return the line number of an offset, from 1."""
        low, high = 0, len(self.lines)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.lines[middle].start <= offset else (low, middle)
        return self.lines[low].number

    def _add_comments(self) -> None:
        """Add notes and boneyards, except those that lie inside another element (a heading, a cue)."""
        inside = [(element.start, element.end) for element in self.elements]
        spans = iter(sorted(inside))
        span = next(spans, None)
        for comment in self.comments:
            while span and span[1] <= comment.start:
                span = next(spans, None)
            if span and span[0] <= comment.start:
                continue
            self.elements.append(
                Element(
                    kind=comment.kind,
                    text=self.text[comment.start + 2 : comment.end - 2].strip(),
                    start=comment.start,
                    end=comment.end,
                    line=self._line_at(comment.start),
                )
            )
