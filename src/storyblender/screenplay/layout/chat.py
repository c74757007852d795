"""Group chats as exported by a phone: keeps sender and message; leaves out times and numbers."""

from __future__ import annotations

import re

from storyblender.screenplay.layout.lines import Page, lines_of
from storyblender.screenplay.model import Screenplay

_STAMP = (
    r"[\[(]?\s*(?:\d{1,4}[./-]\d{1,2}(?:[./-]\d{2,4})?,?\s+)?\d{1,2}[:.]\d{2}(?:[:.]\d{2})?"
    r"\s*(?:[ap]\.?\s?m\.?)?\s*[\])]?\s*[-–—:]?\s*"
)
_MESSAGE = re.compile(rf"{_STAMP}(?P<name>[^:\n]{{1,40}}?):\s(?P<words>.*)", re.IGNORECASE)
_STAMPED = re.compile(rf"{_STAMP}\S", re.IGNORECASE)
_OMITTED = re.compile(r"<[^>]*omitted>|<attached:[^>]*>|This message was deleted|\W*", re.IGNORECASE)


def is_chat(text: str) -> bool:
    """Return whether most lines of a page are messages with a time and a sender."""
    lines = [line.words for line in lines_of(text) if line.words]
    messages = sum(_MESSAGE.match(line) is not None for line in lines)
    return messages >= 4 and messages * 2 >= len(lines)


def parse(text: str, path: str = "") -> Screenplay:
    """Read messages; each becomes a line of its sender.

    Args:
        text: The page, newlines as ``\\n``.
        path: File path, for display only.
    """
    page = Page(text)
    open_start = open_end = -1
    for line in lines_of(text):
        match = _MESSAGE.match(line.words) if line.words else None
        if match is None and _STAMPED.match(line.words) is None and open_start >= 0 and line.words:
            open_end = line.end
            continue
        if open_start >= 0:
            page.add("action", open_start, open_end)
            open_start = -1
        if match is None:
            if line.words and not page.title_page:
                page.title_page.append(("Title", line.words))
            page.add("section", line.start, line.end)
            continue
        if _OMITTED.fullmatch(match["words"]):
            page.add("section", line.start + match.start("words"), line.end)
            continue
        name = re.sub(r"[\W\d_]+$", "", match["name"])
        page.add(
            "cue", line.start + match.start("name"), line.start + match.end("name"), name=name.upper(), extension="V.O."
        )
        open_start, open_end = line.start + match.start("words"), line.end
    if open_start >= 0:
        page.add("action", open_start, open_end)
    return Screenplay(
        path=path,
        format="script",
        text=text,
        title_page=tuple(page.title_page),
        elements=tuple(page.elements),
        page="chat",
    )
