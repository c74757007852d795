"""Picture books: the words of a page, or of two that face each other, are one picture."""

from __future__ import annotations

import re

from storyblender.screenplay.layout.lines import Line, Page, lines_of
from storyblender.screenplay.model import Screenplay

_PAGE = re.compile(
    r"[\[(*_]*(?:(?:p{1,2}\.?|pgs?\.?|pages?|spread|seiten?|p[áa]g(?:inas?|\.)?)\s*)(?:\d{1,3}|one|two|three|four|five|six|seven|eight|nine|ten)"
    r"(?:\s*(?:[-–—/&+]|and|to)\s*\w{1,5})?[\])*_]*\s*[:.–—-]*[*_]*(?=\s|$)",
    re.IGNORECASE,
)
_ART = re.compile(r"[\[(]?\s*(?:illustration|art|illo|picture|image|art note|ill\.)\s*(?:note)?\s*:\s*", re.IGNORECASE)


def is_picture_book(text: str) -> bool:
    """Return whether a text is divided into numbered pages of a few lines each."""
    lines = [line.words for line in lines_of(text) if line.words]
    pages = sum(_PAGE.match(line) is not None for line in lines)
    return pages >= 4 and pages * 14 >= len(lines) and any(_PAGE.fullmatch(line) for line in lines)


def parse(text: str, path: str = "") -> Screenplay:
    """Read a picture book.

    Args:
        text: The book, newlines as ``\\n``.
        path: File path, for display only.
    """
    page = Page(text)
    lines = lines_of(text)
    first = next(i for i, line in enumerate(lines) if _PAGE.match(line.words))
    _front(page, lines[:first])
    run: list[Line] = []
    for line in [*lines[first:], Line(0, len(text), "", 0)]:
        match = _PAGE.match(line.words) if line.words else None
        deeper = run and line.words and line.indent > run[0].indent + 1
        if run and (match or not line.words or line.words[0] in '["“' or run[-1].words[-1] in "]") and not deeper:
            _paragraph(page, run[0].start, run[-1].end)
            run = []
        if match:
            page.open_picture()
            page.add("section", line.start, line.start + match.end())
            if line.words[match.end() :].strip():
                rest = line.words[match.end() :]
                run = [Line(line.number, line.end - len(rest.lstrip()), rest.strip(), line.indent)]
        elif line.words:
            run.append(line)
    return Screenplay(
        path=path,
        format="prose",
        text=text,
        title_page=tuple(page.title_page),
        elements=tuple(page.elements),
        page="picture_book",
    )


def _front(page: Page, lines: list[Line]) -> None:
    """Read the lines before the first page."""
    for line in lines:
        if line.words and not page.title_page:
            page.title_page.append(("Title", line.words.strip('*_"“” ')))
        page.add("section", line.start, line.end)


def _paragraph(page: Page, start: int, end: int) -> None:
    """Add a paragraph of the story; text in brackets is an illustration note."""
    words = page.text[start:end]
    art = _ART.match(words)
    if art:
        start += art.end()
    elif words[0] in "[":
        start += 1
    page.add("action", start, end - (page.text[end - 1] == "]"))
