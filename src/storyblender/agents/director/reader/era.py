"""The words of a script that tell when its story plays."""

from __future__ import annotations

from storyblender.agents.director.reader.manuscript import QUOTATION, without_quotations
from storyblender.screenplay.model import ElementKind, Screenplay

_TOLD: frozenset[ElementKind] = frozenset(
    {"heading", "action", "cue", "parenthetical", "shot", "centered", "section", "synopsis", "title"}
)
_SAID: frozenset[ElementKind] = frozenset({"dialogue", "lyric"})


def told_and_said(screenplay: Screenplay) -> tuple[str, str]:
    """Return what the story tells and what its people say, a paragraph a line.

    Of the title page only the title belongs to the story: contact, dates and copyright tell when and where it was
    written. Notes and cut text do not count either.
    """
    told, said = [screenplay.title], []
    for element in screenplay.elements:
        if element.kind in _SAID:
            said.append(element.text)
        elif element.kind in _TOLD and screenplay.format == "prose":
            told.append(without_quotations(element.text))
            said += [quotation.group() for quotation in QUOTATION.finditer(element.text)]
        elif element.kind in _TOLD:
            told.append(element.text)
    return "\n".join(told), "\n".join(said)
