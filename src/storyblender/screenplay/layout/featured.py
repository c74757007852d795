"""The list of a scene's people under its heading, as in sitcoms: ``(Vernon, Lottie, Boyd)``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from storyblender.screenplay.model import Element

_LISTED = re.compile(r"\s*[(\[](?P<names>[^()\[\]]{2,300})[)\]][ \t]*(?:\n|$)")
_BETWEEN = re.compile(r"\s*(?:[,;/&\n]|\b(?:and|AND|with|WITH)\b)\s*")
_HALF = 0.5
"""Share of the names in such brackets that speak on the page."""


def list_featured(text: str, elements: Sequence[Element]) -> tuple[Element, ...]:
    """Return the elements with the entries of such lists as ``cast``: who they name may come in later.

    Args:
        text: The page.
        elements: Its elements in reading order.
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
