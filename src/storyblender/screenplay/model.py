"""One Screenplay model for every format. Every element knows its characters in the decoded text."""

from __future__ import annotations

from typing import Literal

from storyblender.memory.base import Frozen

ScriptFormat = Literal["fountain", "fdx", "prose", "script"]
"""``script``: a play, a comic or a commercial, or a screenplay in its writer's own layout."""
PageKind = Literal["screenplay", "play", "comic", "columns", "picture_book", "outline", "chat", "prose"]
"""The form of a page: cues and headings, panels, picture and sound side by side, one picture a page, numbered
cards, messages with their senders, or paragraphs."""
ElementKind = Literal[
    "heading", "action", "cue", "parenthetical", "dialogue", "lyric", "transition", "shot", "centered",
    "section", "synopsis", "note", "boneyard", "page_break", "title", "sound", "cast",
]  # fmt: skip


class Element(Frozen):
    """One element of a screenplay.

    ``text`` is what the element says without markup; ``start``/``end`` point into ``Screenplay.text``
    so that ``Screenplay.text[start:end]`` is exactly what the user wrote for it. ``title`` is what can be read on a
    screen or a card, ``sound`` a noise or music that is written with a label, ``cast`` an entry of the list of people.
    """

    kind: ElementKind
    text: str
    start: int
    end: int
    line: int
    """1-based line in the file as the user sees it (FDX: line of the XML)."""
    name: str = ""
    """cue: the character's name without extensions."""
    extension: str = ""
    """cue: what stood in brackets, e.g. ``V.O.``, ``CONT'D`` removed."""
    scene_number: str = ""
    dual: bool = False
    """cue and its speech: second column of dual dialogue."""
    picture: int | None = None
    """Panel, item of a series of shots, row of two columns, page of a picture book: one number is one shot."""


class Screenplay(Frozen):
    """A script as read: decoded text, title page, elements in reading order."""

    path: str = ""
    """Name of the file, without its folder: the same script is the same everywhere."""
    format: ScriptFormat
    text: str
    """Decoded, newlines as \\n. For FDX the plain text that the elements were laid into."""
    title_page: tuple[tuple[str, str], ...] = ()
    elements: tuple[Element, ...] = ()
    page: PageKind = "screenplay"

    @property
    def title(self) -> str:
        """The title on the title page, or an empty string."""
        return self._title_page_line("title")

    @property
    def edition(self) -> str:
        """Version and date on the title page: ``Second draft, 22 November 2026``; empty where it has neither."""
        version = self._title_page_line("version", "revision", "draft")
        date = self._title_page_line("draft date", "revision date", "date")
        return " ".join(", ".join(filter(None, (version, date))).split())

    def _title_page_line(self, *keys: str) -> str:
        """Return what stands on the title page under the first of these keys that it has, or an empty string."""
        return next((value for wanted in keys for key, value in self.title_page if key.lower() == wanted), "")
