"""Line spacing: finds empty lines that divide nothing, on pages whose speeches are double spaced, as in sitcoms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from storyblender.screenplay.cues import looks_like_cue
from storyblender.screenplay.headings import is_heading

_ENOUGH = 2
"""Fewest speeches apart from their names from which a page is double spaced."""
_CUE_WORDS = 5
_FULL = 30
"""Characters of a line that goes on below it."""
_DEEP = 40
"""Most lines of one bracket."""


class PageRow(NamedTuple):
    """A line of a page: the number of spaces before its words, and the words."""

    indent: int
    words: str

    @property
    def spoken(self) -> bool:
        """Whether it has small letters: where action is in capitals, only speeches do."""
        return any(letter.islower() for letter in self.words)

    @property
    def cue(self) -> bool:
        """Whether it may be the name above a speech."""
        words = self.words
        return not self.spoken and words[:1] != "(" and len(words.split()) <= _CUE_WORDS and looks_like_cue(words)


def line_spacing(rows: Sequence[PageRow]) -> frozenset[int]:
    """Return the indices of the empty lines that stand inside a speech or a sentence of a double-spaced page."""
    cues = [i for i in range(len(rows) - 2) if rows[i].words and (not i or not rows[i - 1].words) and rows[i].cue]
    apart = [i for i in cues if not rows[i + 1].words and rows[i + 2].spoken]
    close = sum(rows[i + 1].spoken for i in cues)
    if len(apart) < _ENOUGH or len(apart) <= close:
        return frozenset()
    margin = min(row.indent for row in rows if row.words)
    indented = sum(margin < rows[i + 2].indent < rows[i].indent for i in apart) > len(apart) / 2
    if not indented and not _loud(rows, {*apart}):
        return frozenset()
    return frozenset(_Walk(rows, frozenset(apart), indented).spacing())


def _loud(rows: Sequence[PageRow], apart: set[int]) -> bool:
    """Whether action stands in capitals: small letters occur only below names."""
    told = [row for row in rows if row.words and not is_heading(row.words) and len(row.words.split()) > _CUE_WORDS]
    large = sum(not row.spoken for row in told)
    first = min(apart)
    before = sum(row.spoken for row in rows[:first] if row.words.endswith((".", "!", "?")))
    return large >= _ENOUGH and not before


@dataclass
class _Walk:
    """Walks down a page and finds the empty lines inside speeches and sentences."""

    rows: Sequence[PageRow]
    apart: frozenset[int]
    indented: bool

    def spacing(self) -> list[int]:
        """Collect the empty lines that divide nothing."""
        found: list[int] = []
        at, speech = 0, -1
        while at < len(self.rows) - 2:
            row, following = self.rows[at], self.rows[at + 2]
            single = bool(row.words) and not self.rows[at + 1].words and bool(following.words)
            if row.words[:1] in ("(", "[") and speech < 0 and (close := self._closing(at)) > at:
                found += [i for i in range(at, close) if not self.rows[i].words]
                at = close
                continue
            if at in self.apart:
                speech = following.indent
                found.append(at + 1)
                at += 2
                continue
            if not row.words and not self.rows[at + 1].words:
                speech = -1
            elif single and (self._goes_on(at + 2, speech) if speech >= 0 else self._sentence_goes_on(row, following)):
                found.append(at + 1)
            elif single:
                speech = -1
            at += 1
        return found

    def _goes_on(self, at: int, speech: int) -> bool:
        """Whether a line belongs to the speech above it."""
        row = self.rows[at]
        if self.indented:
            return speech - 2 <= row.indent <= speech + 6 and at not in self.apart and not is_heading(row.words)
        aside = row.words[:1] == "(" and at + 2 < len(self.rows) and self.rows[at + 2].spoken
        return (row.spoken or (aside and len(row.words.split()) <= _CUE_WORDS)) and not is_heading(row.words)

    def _sentence_goes_on(self, row: PageRow, following: PageRow) -> bool:
        """Whether a line of action that fills its line ends no sentence."""
        told = len(row.words) > _FULL and not row.cue and not is_heading(row.words) and row.indent == following.indent
        return told and not row.words.endswith((".", "!", "?", ":", ")")) and not is_heading(following.words)

    def _closing(self, at: int) -> int:
        """Return the index of the line on which the bracket that a line opens is closed; the line itself if none."""
        depth = 0
        for index in range(at, min(at + _DEEP, len(self.rows))):
            words = self.rows[index].words
            depth += sum(words.count(mark) for mark in "([") - sum(words.count(mark) for mark in ")]")
            if depth <= 0:
                return index
        return at
