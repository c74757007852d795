"""Refines a coarse motion by the words around it: ``look`` with "over the shoulder" is ``look_back``."""

from __future__ import annotations

import re
from functools import lru_cache
from importlib.resources import files
from typing import NamedTuple

from storyblender.catalog.motions import MOTION_KEYS, MOTIONS

UNREAD = "idle"
"""The motion of verbs that the motion vocabulary lacks; the verb then decides."""


_PLAIN = frozenset({"yawn", "sneeze", "cough", "curtsy"})
"""Verbs that name an action by themselves."""


class _Row(NamedTuple):
    """The fine motion of a coarse motion with one of these verbs and words; an empty field matches any."""

    motion: str
    coarse: frozenset[str]
    verbs: frozenset[str]
    words: re.Pattern[str] | None


@lru_cache(maxsize=1)
def _rows() -> tuple[_Row, ...]:
    """Return the rows of ``finer.tsv``."""
    text = files("storyblender.agents.director.lexicon").joinpath("finer.tsv").read_text(encoding="utf-8")
    rows = [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]
    return tuple(
        _Row(motion, _any_or(coarse), _any_or(verbs), None if words == "*" else re.compile(words))
        for motion, coarse, verbs, words in rows
        if motion in MOTIONS
    )


def _any_or(cell: str) -> frozenset[str]:
    """Return the words of a cell; empty for any."""
    return frozenset() if cell == "*" else frozenset(cell.split(" "))


def fine_motion(motion: str, verb: str, words: str) -> str:
    """Return the key of the finest motion of the catalogue for an action.

    Args:
        motion: The coarse motion, from the reader or a corrected reading.
        verb: The verb as a lemma; may be empty.
        words: The script's words for the action.
    """
    said, lemma = words.lower(), verb.lower().split(" ")[0]
    for row in _rows():
        done = (
            not row.verbs or lemma in row.verbs or (not lemma and any(_has_form_of(each, said) for each in row.verbs))
        )
        known = motion == UNREAD or not row.coarse or motion in row.coarse
        if motion == UNREAD:
            telling = bool(row.verbs) and (row.words is not None or bool(row.verbs & _PLAIN))
        else:
            telling = bool(row.verbs) or row.words is not None
        fits = done and known and telling
        if fits and (row.words is None or row.words.search(said)):
            return row.motion
    return MOTION_KEYS[motion]


def _has_form_of(verb: str, words: str) -> bool:
    """Whether a verb occurs in the words, in one of its regular forms."""
    return re.search(rf"\b{verb.removesuffix('e')}(e|es|s|ed|ing|{verb[-1]}ed|{verb[-1]}ing)?\b", words) is not None
