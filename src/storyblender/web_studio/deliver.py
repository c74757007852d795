"""What a project delivers, for the page: every file, when it was written, whether it shows the story as it is."""

from __future__ import annotations

import re
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

from storyblender.deliver.asset_list import ASSETS_FILE
from storyblender.deliver.board_cells import Box, cells_of, page_size
from storyblender.deliver.checklist import CHECKLIST_FILE
from storyblender.deliver.credits import CREDITS_FILE
from storyblender.memory.base import Described
from storyblender.memory.board_layout import BoardLayout
from storyblender.results import Delivery
from storyblender.session import Session
from storyblender.web_studio.page_call import PageCall

Written = Literal["all", "board", "film", "glb", "usd", "edl", "fcpxml"]
_ON_REQUEST = re.compile(r"timeline\.(edl|fcpxml)|export/SC\d{3,6}\.(glb|usdc)|animatic\.srt")
_EXPORTS = {"glb": "export/*.glb", "usd": "export/*.usdc", "edl": "timeline.edl", "fcpxml": "timeline.fcpxml"}


class DeliverCall(PageCall):
    """Asks what the project delivers, and how a page of its board looks."""

    call: Literal["deliver"]
    """Which call this is."""
    layout: BoardLayout | None = None
    """Of the page that is shown; that of the project if not given."""


class WriteCall(PageCall):
    """Writes something now; ``status`` says how far it is."""

    call: Literal["write"]
    """Which call this is."""
    what: Written
    """``all``: board, lists, timeline and story.blend, which are written by themselves after a while."""
    layout: BoardLayout | None = None
    """Of the board; the project keeps it."""


class DeliveredFile(Described):
    """A file to download."""

    name: str
    """In the project."""
    bytes: int
    """Its size."""
    written: str
    """When, as ISO 8601 with the time zone."""


class Deliverable(Described):
    """Something that a project delivers."""

    what: str
    """What ``write`` calls it, and what it is for the page."""
    title: str
    """For people."""
    words: str
    """What it is good for."""
    files: tuple[DeliveredFile, ...]
    """None while it is not written."""
    state: Literal["fresh", "old", "none", "saved"]
    """Whether the files show the story as it is; ``saved``: a person saved one in Blender, and it is not taken over."""
    write: Written
    """What writes it now."""


class PageCell(Described):
    """A panel on a page of the board; boxes are left, top, width and height in points, from the upper left corner."""

    picture: tuple[float, float, float, float]
    """Its frame."""
    words: tuple[float, float, float, float]
    """Slate and script under or beside it."""
    size: float
    """Font size in points."""


class BoardPage(Described):
    """A page of the board."""

    width: float
    """Points."""
    height: float
    """Points."""
    cells: tuple[PageCell, ...]
    """Its panels, in order."""


class Deliveries(Described):
    """All that a project delivers."""

    layout: BoardLayout
    """Of the board as it is kept."""
    page: BoardPage
    """A page in the layout that was asked for."""
    items: tuple[Deliverable, ...]
    """In the order people open them."""


def deliveries_of(session: Session, layout: BoardLayout | None) -> Deliveries:
    """Return what a project delivers.

    Args:
        session: Of a made project.
        layout: Of the board's page that is shown; that of the project if None.
    """
    page = _page(layout or session.board_layout, session.graph.format.aspect)
    return Deliveries(layout=session.board_layout, page=page, items=tuple(_items(session)))


def may_be_downloaded(name: str) -> bool:
    """Return whether a name is that of a file that is written on request."""
    return _ON_REQUEST.fullmatch(name) is not None


def write_now(session: Session, call: WriteCall) -> Delivery:
    """Write what a call asks for; raises as ``Session.render``."""
    if call.what == "film":
        return session.render_film()
    if call.what == "board":
        return session.print_board(call.layout or session.board_layout)
    if call.what == "all":
        return session.render()
    if not session.delivered:
        session.render()
    return session.export([call.what])


def _page(layout: BoardLayout, aspect: float) -> BoardPage:
    width, height = page_size(layout)

    def from_above(box: Box) -> tuple[float, float, float, float]:
        left, top, across, down = (round(value, 1) for value in box)
        return left, round(height - top, 1), across, down

    cells = (
        PageCell(picture=from_above(cell.picture), words=from_above(cell.words), size=round(cell.size, 1))
        for cell in cells_of(layout, aspect)
    )
    return BoardPage(width=width, height=height, cells=tuple(cells))


def _items(session: Session) -> Iterator[Deliverable]:
    """Yield what is written by itself, then what is written on request."""
    by_itself = (
        ("story.blend", "Blender file", "every scene with people, sets, light and cameras, to work in"),
        ("shots.csv", "Shot list", "a row for every shot, for spreadsheets"),
        (ASSETS_FILE, "Asset list", "people and things with their sizes"),
        (CHECKLIST_FILE, "Checklist", "what a person should look at, each with what mends it"),
        (CREDITS_FILE, "Credits", "whose models are in it"),
        ("timeline.otio", "Timeline (OTIO)", "for editing programs"),
    )
    fresh, saved = session.delivered, session.saved_in_blender
    yield _item(session, "board", "Board (PDF)", "to print", ("board.pdf", "board_single.pdf"), fresh, "board")
    for name, title, words in by_itself:
        if name != CREDITS_FILE or (session.folder / name).exists():
            item = _item(session, name, title, words, (name,), fresh, "all")
            yield item.model_copy(update={"state": "saved"}) if name in saved else item
    film = ("animatic.mp4", "animatic.srt")
    yield _item(session, "film", "Animatic", "the moving board with subtitles; takes some minutes", film, False, "film")
    exports: tuple[tuple[Written, str, str], ...] = (
        ("edl", "Timeline (EDL)", "for editing programs that read only that"),
        ("fcpxml", "Timeline (FCPXML)", "for Final Cut Pro and DaVinci Resolve"),
        ("glb", "Scenes (glTF)", "a file a scene, for other 3D programs and the web"),
        ("usd", "Scenes (USD)", "a file a scene, for other 3D programs"),
    )
    for kind, title, words in exports:
        found = sorted(session.folder.glob(_EXPORTS[kind]))
        names = tuple(path.relative_to(session.folder).as_posix() for path in found)
        yield _item(session, kind, title, words, names, False, kind)


def _item(
    session: Session, what: str, title: str, words: str, names: tuple[str, ...], fresh: bool, write: Written
) -> Deliverable:
    files = tuple(_file(session.folder, name) for name in names if (session.folder / name).is_file())
    fresh = fresh or all(session.shows_story(each.name) for each in files if not each.name.endswith(".srt"))
    state = "none" if not files else "fresh" if fresh else "old"
    return Deliverable(what=what, title=title, words=words, files=files, state=state, write=write)


def _file(folder: Path, name: str) -> DeliveredFile:
    seen = (folder / name).stat()
    written = datetime.fromtimestamp(seen.st_mtime, UTC).isoformat(timespec="seconds")
    return DeliveredFile(name=name, bytes=seen.st_size, written=written)
