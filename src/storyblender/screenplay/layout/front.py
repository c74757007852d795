"""Front matter of a script (title, byline, cast list, notes to the crew) and lists of people under scene headings."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from storyblender.screenplay.layout.lines import Line, Page, plain
from storyblender.screenplay.model import Element

_CAST = re.compile(
    r"(?:(?:THE )?(?:CAST|CHARACTERS?|PERSONS?|PEOPLE|PLAYERS|DRAMATIS PERSON(?:AE|Æ|S)|PERSONNAGES|PERSONAJES"
    r"|PERSONEN|ROLLEN|REPARTO"
    r"|PERSONAGGI)(?: (?:OF|IN|LIST|DES|DE|DER|DELLA)[\w' ]*)?(?: (?:IN|OF) [\w' ]+)?)\s*[:.]?(?:[-–—]+)?",
    re.IGNORECASE,
)
_STARTS = re.compile(
    r"(?:SETTING|SET|SCENE|SC\.|TIME|PLACE|ACT|PROLOGUE|AT RISE|THE SETTING|AT (?:THE )?(?:CURTAIN|RISE)|LIGHTS"
    r"|CURTAIN|SYNOPSIS"
    r"|INT|EXT|INNEN|AUSSEN|FADE IN|PAGE|PANEL|ESCENA|SZENE|SC[ÈE]NE)\b",
    re.IGNORECASE,
)
_BY = re.compile(
    r"(?:(?:a )?(?:[\w-]+ ){0,3}?(?:written |story |script |screenplay |play )?by)\s+(?P<author>.{2,80})", re.IGNORECASE
)
_LONG = 100
"""Characters: a line of this length is no entry of a list."""


def read_front(page: Page, lines: Sequence[Line]) -> frozenset[str]:
    """Read the front matter into the page: title and author, cast entries, and the rest as sections.

    Args:
        page: Takes the elements.
        lines: The lines before the story begins.

    Returns:
        The names of the cast list, in capitals.
    """
    names: set[str] = set()
    listing = False
    for line in lines:
        if not line.words:
            continue
        if _CAST.fullmatch(line.words):
            listing = True
            page.add("section", line.start, line.end)
        elif listing and _STARTS.match(line.words) is None and len(line.words) <= _LONG:
            names.add(_entry(line.words))
            page.add("cast", line.start, line.end)
        else:
            listing = False
            _titled(page, line)
    return frozenset(names - {""})


def titled(
    title_page: tuple[tuple[str, str], ...], elements: Sequence[Element]
) -> tuple[tuple[tuple[str, str], ...], list[Element]]:
    """Move title, byline and the like from the lines before the first heading to the title page.

    Args:
        title_page: Keys and values so far.
        elements: Elements of the script.

    Returns:
        The title page and the elements that are left.
    """
    first = next((i for i, element in enumerate(elements) if element.kind in ("heading", "cue")), 0)
    named = {key for key, _ in title_page}
    found = list(title_page)
    told = list(elements)
    opens = len(told) > 2 and [element.kind for element in told[:2]] == ["cue", "dialogue"] and "Title" not in named
    closed = opens and told[1].text.rstrip("\"”') ").endswith((".", "!", "?", "…", "-"))
    if (
        opens
        and not closed
        and told[2].kind != "dialogue"
        and not any(element.name == told[0].name for element in told[1:])
    ):
        found.append(("Title", told[0].text))
        told[:2] = [element.model_copy(update={"kind": "section", "name": ""}) for element in told[:2]]
        return tuple(found), told
    for index, element in enumerate(elements[:first]):
        by = _BY.fullmatch(element.text)
        short = len(element.text.split()) <= 8 and not element.text.endswith((".", "!", ":"))
        loud = element.text == element.text.upper() and any(letter.isalpha() for letter in element.text)
        if element.kind not in ("action", "centered") or "\n" in element.text:
            break
        if by and "Author" not in named:
            found.append(("Author", by["author"].strip(" .")))
            named.add("Author")
        elif short and (loud or index == 0 or element.kind == "centered") and "Title" not in named:
            found.append(("Title", element.text.strip('"“”')))
            named.add("Title")
        elif element.kind != "centered" and not (short and (loud or "Author" not in named)):
            break
        told[index] = element.model_copy(update={"kind": "section"})
    return tuple(found), told


def cast_list(lines: Sequence[Line]) -> int | None:
    """Return the index of the heading of a cast list, within the first lines of a page, or None."""
    return next((i for i, line in enumerate(lines[:60]) if line.words and _CAST.fullmatch(line.words)), None)


def ends_cast(line: Line) -> bool:
    """Return whether a line cannot belong to a cast list: the play begins."""
    return _STARTS.match(line.words) is not None or len(line.words) > _LONG


def _titled(page: Page, line: Line) -> None:
    """Add the title or author that a line gives to the title page."""
    words = plain(line.words).strip("\"“”'’* ")
    keys = {key for key, _ in page.title_page}
    by = _BY.fullmatch(words)
    keyed = re.fullmatch(r"(title|author|credit|date|draft date|draft|version)\s*:\s*(.+)", words, re.IGNORECASE)
    if keyed:
        page.title_page.append((keyed[1].capitalize(), keyed[2].strip('"“” ')))
    elif by and "Author" not in keys:
        page.title_page.append(("Author", by["author"].strip(" .")))
    elif "Title" not in keys and ":" not in words and len(words.split()) <= 12 and not words.endswith((".", ":", ",")):
        page.title_page.append(("Title", words))
    page.add("section", line.start, line.end)


def _entry(words: str) -> str:
    """Return the name in an entry: the text before a comma, a dash, dots or a bracket."""
    name = re.split(r",|\s[-–—]+\s|\.{2,}|\(|:|\s{3,}|[-–—]{2}", plain(words), maxsplit=1)[0]
    return re.sub(r"^(?:A|AN|THE)\s+", "", name.strip(" .*_-").upper())


_LISTED = re.compile(r"\s*[(\[](?P<names>[^()\[\]]{2,300})[)\]][ \t]*(?:\n|$)")
_BETWEEN = re.compile(r"\s*(?:[,;/&\n]|\b(?:and|AND|with|WITH)\b)\s*")
_HALF = 0.5
"""Share of the names in such brackets that speak on the page."""


def list_featured(text: str, elements: Sequence[Element]) -> tuple[Element, ...]:
    """Return the elements with the people listed under a heading as ``cast`` elements: ``(Vernon, Lottie)``.

    Args:
        text: The script.
        elements: Its elements.
    """
    speaking = {word for element in elements if element.kind == "cue" for word in element.name.upper().split()}
    told: list[Element] = []
    for element in elements:
        below = bool(told) and told[-1].kind == "heading" and element.kind == "action"
        listed = _LISTED.match(text, max(element.start - 1, told[-1].end)) if below else None
        entries = [*_entries(listed, element)] if listed else []
        spoken = sum(bool({*entry.text.upper().split()} & speaking) for entry in entries)
        if listed is None or not entries or spoken < _HALF * len(entries):
            told.append(element)
            continue
        told += entries
        rest = listed.end() + len(text[listed.end() : element.end]) - len(text[listed.end() : element.end].lstrip())
        if rest < element.end:
            cut = element.text.find(")") + 1 or element.text.find("]") + 1
            line = element.line + text.count("\n", element.start, rest)
            told.append(element.model_copy(update={"start": rest, "text": element.text[cut:].strip(), "line": line}))
    return tuple(told)


def _entries(listed: re.Match[str], element: Element) -> Iterator[Element]:
    """Return an element for each name between the brackets."""
    at = listed.start("names")
    for name in _BETWEEN.split(listed["names"]):
        start = listed.string.index(name, at)
        at = start + len(name)
        if name:
            yield element.model_copy(update={"kind": "cast", "text": name, "start": start, "end": at})
