"""Commercials in two columns, picture and sound: each row is one shot; its cells are read one after the other."""

from __future__ import annotations

import re
from typing import Final

from storyblender.screenplay.headings import is_heading
from storyblender.screenplay.layout.labels import element_of_label
from storyblender.screenplay.layout.lines import Page, lines_of
from storyblender.screenplay.layout.speech import add_cue, add_speech
from storyblender.screenplay.model import ElementKind, Screenplay

_PICTURE: Final = r"(?:VIDEO|VISUALS?|PICTURE|IMAGE|BILD|V[ÍI]DEO|IMAGEN|VISION|ACTION)"
_SOUND: Final = r"(?:AUDIO|SOUND|TON|SON|SONIDO|DIALOGUE|VOICE ?OVER|NARRATION|VO)"
_HEADER = re.compile(
    rf"\|?[\s*_]*{_PICTURE}[\s*_]*(?:\s{{3,}}|\t+|\s*[|/]\s*)[\s*_]*(?P<right>{_SOUND})[\s*_:]*\|?", re.IGNORECASE
)
_STACKED = re.compile(rf"[*_]*(?:(?P<picture>{_PICTURE})|(?P<sound>{_SOUND}))[*_]*\s*:[*_]*\s*", re.IGNORECASE)
_RULE = re.compile(r"[\s|:=_+-]+")
_LABEL = re.compile(r"(?P<name>[A-ZÀ-Þ][\w.'’/# -]{0,24}?)\s*(?P<bracket>\([^)]{1,60}\))?\s*:(?=\s|$)")
_VOICE = re.compile(
    r"(?:[MF]?\.?V\.?/?O\.?|ANN(?:OUN)?C(?:E)?R|NARRATOR|VOICE ?-?OVER|LOCUTOR|SPRECHER)\b.*", re.IGNORECASE
)
_SCENE_HEAD = re.compile(r"[^.]{2,60}?\.[^.]{2,60}?(?=\.\s|$)")


def is_columns(text: str) -> bool:
    """Return whether a page has a column of pictures and one of sounds, or both labelled in turn."""
    lines = [line.words for line in lines_of(text)]
    if any(_HEADER.fullmatch(line) for line in lines):
        return True
    labels = [match for line in lines if (match := _STACKED.match(line))]
    return sum(bool(m["picture"]) for m in labels) >= 2 and sum(bool(m["sound"]) for m in labels) >= 2


def parse(text: str, path: str = "") -> Screenplay:
    """Read a script in columns; its text becomes the rows, picture before sound.

    Args:
        text: The script, newlines as ``\\n``.
        path: File path, for display only.
    """
    lines = text.split("\n")
    head = next((i for i, line in enumerate(lines) if _HEADER.fullmatch(line.strip())), None)
    rows = _rows(lines, head) if head is not None else _stacked(lines)
    first = head if head is not None else next(i for i, line in enumerate(lines) if _STACKED.match(line.strip()))
    front = [" ".join(line.split()) for line in lines[:first] if line.strip()]
    pieces: list[tuple[str, str]] = [("front", words) for words in front]
    for left, right in rows:
        pieces += [("row", "")]
        pieces += [("left", item) for item in left] + [("right", item) for item in right]
    laid = "\n\n".join(words for _, words in pieces if words)
    page = Page(laid)
    _read(page, pieces)
    return Screenplay(
        path=path,
        format="script",
        text=laid,
        title_page=tuple(page.title_page),
        elements=tuple(page.elements),
        page="columns",
    )


def _rows(lines: list[str], head: int) -> list[tuple[list[str], list[str]]]:
    """Return the items of picture and sound of each row below the header."""
    header = _HEADER.search(lines[head])
    assert header is not None, "it was found by it"
    column = header.start("right")
    rows: list[tuple[list[str], list[str]]] = []
    left: list[str] = []
    right: list[str] = []
    for line in [*lines[head + 1 :], ""]:
        if _RULE.fullmatch(line) or not line.strip():
            if left or right:
                rows.append((_items(left), _items(right)))
            left, right = [], []
            continue
        picture, sound = _cells(line, column)
        left += [picture] if picture else []
        right += [sound] if sound else []
    return rows


def _cells(line: str, column: int) -> tuple[str, str]:
    """Split a line at its bar or tab, else at the gap nearest to where the second column begins."""
    if "|" in line:
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        return cells[0], " ".join(cells[1:])
    if "\t" in line.strip():
        picture, sound = line.rstrip().split("\t", 1)
        return picture.strip(), sound.strip()
    if not line[:column].strip():
        return "", line.strip()
    gaps = [match for match in re.finditer(r"\s{2,}", line.rstrip()) if abs(match.end() - column) <= 6]
    gap = min(gaps, key=lambda match: abs(match.end() - column), default=None)
    if gap is None:
        return line.strip(), ""
    return line[: gap.start()].strip(), line[gap.end() :].strip()


def _stacked(lines: list[str]) -> list[tuple[list[str], list[str]]]:
    """Return one row for each picture of a script with ``VIDEO: ..`` above ``AUDIO: ..``"""
    rows: list[tuple[list[str], list[str]]] = []
    side: int | None = None
    cells: tuple[list[str], list[str]] = ([], [])
    for line in lines:
        words = line.strip()
        match = _STACKED.match(words)
        if match and match["picture"]:
            cells = ([], [])
            rows.append(cells)
        if match:
            side = 0 if match["picture"] else 1
            words = words[match.end() :]
        if side is not None and words and rows:
            cells[side].append(words)
    return [(_items(left), _items(right)) for left, right in rows]


def _items(lines: list[str]) -> list[str]:
    """Return the lines of a cell joined into items; a label begins a new item."""
    items: list[str] = []
    for line in lines:
        if not items or _LABEL.match(line):
            items.append(line)
        else:
            items[-1] += f" {line}"
    return items


def _read(page: Page, pieces: list[tuple[str, str]]) -> None:
    """Read the cells of all rows."""
    at = 0
    for place, words in pieces:
        if place == "row":
            page.open_picture()
            continue
        end = at + len(words)
        if place == "front":
            title = re.match(r"(?:JOB|TITLE|SPOT|PROJECT)\s*:\s*(.*)", words, re.IGNORECASE)
            if title and not page.title_page:
                page.title_page.append(("Title", title[1].strip()))
            page.add("section", at, end)
        elif place == "left":
            _picture(page, at, end)
        else:
            _sound(page, at, end)
        at = end + 2


def _picture(page: Page, at: int, end: int) -> None:
    """Add a cell of the picture column."""
    words = page.text[at:end]
    told = element_of_label(words)
    if told:
        page.picture = None if told[0] == "section" else page.picture
        page.add(told[0], at + told[1], end)
        return
    head = _SCENE_HEAD.match(words) if is_heading(words) else None
    if head:
        page.add("heading", at, at + head.end())
    page.add("action", at + head.end() + 1 if head else at, end)


def _sound(page: Page, at: int, end: int) -> None:
    """Add a cell of the sound column."""
    words = page.text[at:end]
    label = _LABEL.match(words)
    told = element_of_label(words)
    if told or label is None:
        kind: ElementKind = told[0] if told else "sound"
        page.add(kind, at, end)
        return
    bracket = (label["bracket"] or "").strip("()")
    name = label["name"].strip()
    if _VOICE.fullmatch(name):
        bracket = "V.O."
    add_cue(page, at, at + label.end("name"), name, bracket if _VOICE.fullmatch(name) else "")
    if bracket and not _VOICE.fullmatch(name):
        page.add("parenthetical", at + label.start("bracket"), at + label.end("bracket"))
    add_speech(page, at + label.end(), end)
