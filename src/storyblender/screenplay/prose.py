"""Prose: paragraphs as action, chapter and section breaks as sections. Quoted speech is left to the Director."""

from __future__ import annotations

import re

from storyblender.screenplay.model import Element, ElementKind, Screenplay

_BREAK = re.compile(r"(?:[*•~#]\s*){1,7}|[-–—_]{3,}|={3,}")
_MARKDOWN_TITLE = re.compile(r"#{1,6}\s+(?P<title>.+?)\s*#*")
_CHAPTER = re.compile(r"(?:chapter|part|scene|act|prologue|epilogue)\b[^.!?]{0,60}", re.IGNORECASE)
_BYLINE = re.compile(
    r"(?P<credit>(?:(?:a )?(?:short )?story |written )?by)\s+(?P<author>(?:\b[A-Z]\.|[^.!?]){2,60})", re.IGNORECASE
)
_LONG_LINE = 100
"""A line this long (characters) is a whole paragraph: the file does not wrap by hand."""


def parse(text: str, path: str = "") -> Screenplay:
    """Read prose.

    Args:
        text: The story, newlines as ``\\n``.
        path: Kept for display.
    """
    elements: list[Element] = []
    title_page: list[tuple[str, str]] = []
    paragraphs = _paragraphs(text)
    for start, end, line in paragraphs:
        words = text[start:end]
        if not elements and (byline := _BYLINE.fullmatch(words)):
            title_page += [("Credit", byline["credit"]), ("Author", byline["author"].strip())]
            continue
        first = line == paragraphs[0][2] and len(paragraphs) > 1
        kind, shown = _classify(words, first=first)
        if first and kind == "section" and not _CHAPTER.fullmatch(shown) and not _BREAK.fullmatch(words):
            title_page.append(("Title", shown))
            continue
        elements.append(Element(kind=kind, text=shown, start=start, end=end, line=line))
    return Screenplay(path=path, format="prose", text=text, title_page=tuple(title_page), elements=tuple(elements))


def _classify(words: str, *, first: bool) -> tuple[ElementKind, str]:
    if _BREAK.fullmatch(words):
        return "section", words
    if title := _MARKDOWN_TITLE.fullmatch(words):
        return "section", title["title"]
    if _CHAPTER.fullmatch(words):
        return "section", words
    untitled = "\n" in words or len(words.split()) > 10 or re.search(r"[.!?,;:\"”'’]$", words)
    return ("action", words) if untitled or not first else ("section", words)


def _paragraphs(text: str) -> list[tuple[int, int, int]]:
    """Return start, end and line number of every paragraph.

    Blank lines divide paragraphs; so do an indent, an opening quotation mark, and every line of a file whose lines are
    not wrapped by hand.
    """
    found: list[tuple[int, int, int]] = []
    unwrapped = open_block = False
    position = 0
    for number, raw in enumerate(text.split("\n"), 1):
        words = raw.strip()
        start, position = position + len(raw) - len(raw.lstrip()), position + len(raw) + 1
        if not words:
            open_block = False
            continue
        alone = bool(_BREAK.fullmatch(words) or _MARKDOWN_TITLE.fullmatch(words) or _CHAPTER.fullmatch(words))
        indented = raw.startswith(("\t", "  ", "\u3000"))
        fresh = not open_block or alone or indented or unwrapped or len(words) > _LONG_LINE or words[0] in '"“«„‘'
        if fresh:
            found.append((start, start + len(words), number))
        else:
            found[-1] = (found[-1][0], start + len(words), found[-1][2])
        open_block, unwrapped = not alone, len(words) > _LONG_LINE
    return found
