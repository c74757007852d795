"""Cue names on lines of their own above their speeches, with or without blank lines around them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from storyblender.screenplay.cues import looks_like_cue, split_cue
from storyblender.screenplay.fountain import kind_of_words
from storyblender.screenplay.layout.labels import element_of_label
from storyblender.screenplay.layout.lines import Line, plain

_BROKEN = 2
"""Number of cues in places Fountain does not accept from which a page has a layout of its own."""
_SHARE = 0.25
"""Least share of those among all names on lines of their own."""


def standing_names(lines: Sequence[Line]) -> frozenset[str]:
    """Return the names in capitals that stand alone on two or more lines."""
    counts = Counter(name for line in lines if (name := standing_name(line)))
    return frozenset(name for name, count in counts.items() if count > 1)


def standing_name(line: Line) -> str:
    """Return the name that a line consists of, without its brackets; empty if it is something else."""
    words = line.words
    if not words or len(words) > 50 or not looks_like_cue(words) or kind_of_words(words) or element_of_label(words):
        return ""
    return plain(split_cue(words)[0])


def is_out_of_place(lines: Sequence[Line]) -> bool:
    """Return whether many cues of a page lack the blank line above, or have one below, so that Fountain misses them."""
    names = standing_names(lines)
    padded = [Line(0, 0, "", 0), *lines, Line(0, 0, "", 0)]
    found = [i for i in range(1, len(padded) - 1) if standing_name(padded[i]) in names and padded[i].words]
    broken = sum(bool(padded[i - 1].words) or not padded[i + 1].words for i in found)
    return broken >= _BROKEN and broken >= _SHARE * len(found)


def goes_on_as_action(line: Line, before: Line, names: frozenset[str]) -> bool:
    """Return whether a line under a speech is action again: it begins with a character's name, after a full stop.

    Args:
        line: The line.
        before: The line above.
        names: Names of the speakers, in capitals.
    """
    if not re.search(r"[.!?…][\"”')]*$", before.words):
        return False
    first = re.match(r"(?:(?:Mr|Mrs|Ms|Dr)\.? )?([^\W\d_][\w'’-]+)(?=\s+[a-z])", line.words)
    return first is not None and any(first[1].upper() in name.split() for name in names) and not first[1].isupper()
