"""Notes ``[[ ]]`` and boneyard ``/* */`` of Fountain: found first, and blanked so that offsets stay true."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal, NamedTuple

from storyblender.errors import InputError

_OPENING = re.compile(r"/\*|\[\[")
_COMMENT = re.compile(r"\s*(?:/\*.*?\*/|\[\[.*?\]\])(?=\s|$)|/\*.*?\*/|\[\[.*?\]\]", re.DOTALL)
"""With the space before it, where there is space behind it too."""


class Comment(NamedTuple):
    """What is not on the page, with its marks."""

    kind: Literal["note", "boneyard"]
    start: int
    end: int


def find_comments(text: str, path: str = "") -> list[Comment]:
    """Return the notes and boneyards of a script in order; one that opens inside another belongs to it.

    Args:
        text: The script.
        path: Named in errors.

    Raises:
        InputError: One is opened and never closed, or a note opens inside a note.
    """
    found: list[Comment] = []
    position = 0
    while opening := _OPENING.search(text, position):
        boneyard = opening[0] == "/*"
        end = text.find("*/" if boneyard else "]]", opening.end())
        another = -1 if boneyard else text.find("[[", opening.end())
        if end < 0 or 0 <= another < end:
            what, mark = ("boneyard", "*/") if boneyard else ("note", "]]")
            raise InputError(
                f"a {what} is opened with {opening[0]} and never closed",
                mend=f"close it with {mark}",
                path=path or None,
                line=text.count("\n", 0, opening.start()) + 1,
            )
        position = end + 2
        found.append(Comment("boneyard" if boneyard else "note", opening.start(), position))
    return found


def without_comments(text: str) -> str:
    """Return words of a script as they read: without the notes and boneyards that stand in them."""
    return _COMMENT.sub("", text) if "[[" in text or "/*" in text else text


def blank(text: str, comments: Sequence[Comment]) -> str:
    """Return ``text`` with every comment replaced by spaces of equal length; line ends stay.

    Args:
        text: The script.
        comments: The comments of this text.
    """
    pieces, position = [], 0
    for comment in comments:
        pieces += [text[position : comment.start], re.sub(r"[^\n]", " ", text[comment.start : comment.end])]
        position = comment.end
    return "".join([*pieces, text[position:]])
