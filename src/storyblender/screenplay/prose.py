"""Prose: paragraphs as action; chapters, titles and remarks before the story as sections; numbered scenes as headings.

Quoted speech is left to the Director.
"""

from __future__ import annotations

import re

from storyblender.screenplay.headings import heading_words, is_heading, scene_label
from storyblender.screenplay.layout.labels import element_of_label
from storyblender.screenplay.model import Element, ElementKind, Screenplay

_BREAK = re.compile(r"(?:[*•~#]\s*){1,7}|[-–—_]{3,}|={3,}")
_MARKDOWN_TITLE = re.compile(r"#{1,6}\s+(?P<title>.+?)\s*#*")
_CHAPTER = re.compile(r"(?:chapter|part|scene|act|prologue|epilogue)\b[^.!?]{0,60}", re.IGNORECASE)
_BYLINE = re.compile(
    r"(?P<credit>(?:(?:a )?(?:short )?story |written )?by)\s+(?P<author>(?:\b[A-Z]\.|[^.!?]){2,60})", re.IGNORECASE
)
_REMARK = re.compile(
    r"[(\[].*[)\]]|(?:title|author|by|word count|genre|log ?line|treatment|outline|draft"
    r"|synopsis)\b[^.!?]{0,80}[:.]?.{0,80}"
    r"|(?:in which|wherein|of how|containing)\b.{0,240}|(?:for|to) [A-Z][^.!?]{0,40}[.,]?|the end\.?|fin\.?|finis\.?"
    r"|ende\.?|\*+",
    re.IGNORECASE | re.DOTALL,
)
"""Remarks about the story that are not part of it."""
_LETTER = re.compile(
    r"(?:my )?(?:dear|dearest|darling)(?: [^.!?\n]{1,40})?[,:—-]{0,2}"
    r"|(?:(?:mon|tues|wednes|thurs|fri|satur|sun)day,? )?(?:the )?\d{1,2}(?:st|nd|rd"
    r"|th)?(?: of)? [A-Z][a-z]+,?(?: \d{4})?\.?"
    r"|(?:(?:mon|tues|wednes|thurs|fri|satur|sun)day,? )?[A-Z][a-z]+ \d{1,2}(?:st|nd|rd|th)?,?(?: \d{4})?\.?"
    r"|(?:(?:yours?|love|with love|sincerely|affectionately|regards|best wishes|ever|always|kisses|xx*|p\.?s\.?"
    r"|your \w+)\b[^.!?]{0,40})",
    re.IGNORECASE,
)
"""The date, the address and the greeting of a letter."""
_SIGNED = re.compile(r"[—–-]?\s*[A-Z][\w.'’]*(?: [A-Z][\w.'’]*){0,2}")
_FRONT = 8
"""Most paragraphs at the start that may be a title, a byline or remarks."""
_HEADED = 100
"""Most characters of a line that is a heading as a whole; of a longer line only the first sentence is."""
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
    begins = _begins(text, paragraphs)
    letters = any(re.match(r"(?:my )?dear(?:est)?\b", text[start:end], re.IGNORECASE) for start, end, _ in paragraphs)
    for at, (start, end, line) in enumerate(paragraphs):
        words = text[start:end]
        if at < begins:
            named = _titled(words, title_page)
            title_page += named
            if not named:
                elements.append(Element(kind="section", text=words, start=start, end=end, line=line))
            continue
        kind, shown, after = _classify(words)
        if letters and kind == "action" and (_LETTER.fullmatch(words) or _SIGNED.fullmatch(words)):
            kind = "section"
        number = heading_words(shown).number if kind == "heading" else ""
        start += words.index(shown) if kind == "title" else 0
        elements.append(Element(kind=kind, text=shown, start=start, end=end - after, line=line, scene_number=number))
        if after:
            rest = text[end - after : end]
            first = end - after + len(rest) - len(rest.lstrip())
            elements.append(Element(kind="action", text=rest.strip(), start=first, end=end, line=line))
    headed = sum(element.kind == "heading" for element in elements) > 1
    return Screenplay(
        path=path,
        format="prose",
        text=text,
        title_page=tuple(title_page),
        elements=tuple(elements),
        page="outline" if headed else "prose",
    )


def _begins(text: str, paragraphs: list[tuple[int, int, int]]) -> int:
    """Return the index of the first paragraph of the story: after the title, the byline and remarks about it.

    If scenes are numbered or headed, everything before the first heading is front matter.
    """
    first = next((i for i, (start, end, _) in enumerate(paragraphs) if _is_scene(text[start:end])), None)
    numbered = sum(scene_label(text[start:end]) is not None for start, end, _ in paragraphs) > 1
    if first is not None and first < _FRONT and numbered:
        return first
    begins = 0
    for index, (start, end, _) in enumerate(paragraphs[: min(_FRONT, len(paragraphs) - 1)]):
        words = text[start:end]
        if _is_scene(words):
            break
        if _BYLINE.fullmatch(words) or _REMARK.fullmatch(words) or (_is_title(words) and index <= begins + 1):
            begins = index + 1
        elif not _CHAPTER.fullmatch(words) and not _BREAK.fullmatch(words):
            break
    return begins


def _is_title(words: str) -> bool:
    """Return whether a paragraph is a title, with or without more lines that do not end in a full stop."""
    lines = [line.strip() for line in words.split("\n")]
    closed = re.search(r"[.!?,;\"”'’…]$", lines[-1]) and not re.fullmatch(r"[\"“'‘][^\"”]*[\"”'’]", lines[-1])
    dated = _LETTER.fullmatch(lines[0]) is not None
    told = dated or closed or lines[0].endswith((",", ".", ";")) or len(lines) > 4 or words[0] in "—-"
    return not told and len(lines[0].split()) <= 12 and all(len(line) <= _HEADED for line in lines)


def _titled(words: str, known: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return the title page entries of a paragraph before the story."""
    keys = {key for key, _ in known}
    if byline := _BYLINE.fullmatch(words):
        return [("Credit", byline["credit"]), ("Author", byline["author"].strip())]
    shown = _MARKDOWN_TITLE.fullmatch(words)
    title = shown["title"] if shown else words.partition("\n")[0].strip('"“”*_ ')
    chapter = _CHAPTER.fullmatch(words) is not None and shown is None
    fits = "Title" not in keys and not chapter and len(title.split()) <= 12 and not title.endswith((".", ","))
    return [("Title", title)] if fits else []


def _is_scene(words: str) -> bool:
    """Return whether a paragraph begins with a heading: ``INT. MILL``, ``Scene 2``."""
    return is_heading(words) or scene_label(words) is not None


def _classify(words: str) -> tuple[ElementKind, str, int]:
    """Return the kind of a paragraph, its text, and how many characters at its end are action below it."""
    if _BREAK.fullmatch(words):
        return "section", words, 0
    if title := _MARKDOWN_TITLE.fullmatch(words):
        return "section", title["title"], 0
    if _is_scene(words):
        head = words if len(words) <= _HEADED and "\n" not in words else _first_sentence(words)
        return "heading", head, len(words) - len(head)
    if _CHAPTER.fullmatch(words) or re.fullmatch(r"(?:the end|fin|finis|ende|fine)\W*", words, re.IGNORECASE):
        return "section", words, 0
    told = element_of_label(words)
    if told:
        return told[0], words[told[1] :], 0
    return "action", words, 0


def _first_sentence(words: str) -> str:
    """Return the first sentence of a paragraph."""
    line = words.partition("\n")[0]
    if len(line) <= _HEADED:
        return line
    stop = re.search(r"(?<=[a-z]{2}[.!?])\s", line)
    return line[: stop.start()] if stop else line[:_HEADED]


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
        alone = bool(
            _BREAK.fullmatch(words)
            or _MARKDOWN_TITLE.fullmatch(words)
            or _CHAPTER.fullmatch(words)
            or (_is_scene(words) and len(words) <= _HEADED)
        )
        indented = raw.startswith(("\t", "  ", "\u3000"))
        fresh = not open_block or alone or indented or unwrapped or len(words) > _LONG_LINE or words[0] in '"“«„‘'
        if fresh:
            found.append((start, start + len(words), number))
        else:
            found[-1] = (found[-1][0], start + len(words), found[-1][2])
        open_block, unwrapped = not alone, len(words) > _LONG_LINE
    return found
