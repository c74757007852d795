"""The storyboard as a PDF: panels in a grid, with scene headings over the first panel of each scene."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

from reportlab import rl_config
from reportlab.lib.colors import Color, HexColor
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.utils import ImageReader
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable, Paragraph

from storyblender.deliver import fonts
from storyblender.deliver.arrows import draw_way
from storyblender.deliver.board_cells import GUTTER, MARGIN, Cell, cells_of, page_size
from storyblender.deliver.lettering import Lettering, width_of
from storyblender.deliver.panel import Panel, length_of, panels
from storyblender.memory.board_layout import BoardLayout
from storyblender.memory.graph import ContinuityMemoryGraph

INK, GREY, RULE, NOTE = HexColor("#1b1b1f"), HexColor("#6d6d76"), HexColor("#d5d5da"), HexColor("#2f5f9e")

ELLIPSIS = 12.0
"""Points kept free at the right for the ellipsis of a cut text."""
BASELINE = 0.15
"""Offset of a line's baseline below its y, as a share of the font size."""
MOST_LETTERS = 4000
"""Characters of a text that are laid out at most; a page holds fewer."""
SHRINKING, SMALLEST = (0.9, 0.8, 0.7, 0.6, 0.5, 0.4), 5.5
"""Font sizes, as shares of the usual one, that are tried before a long text is cut; the smallest of them in points."""
_GAP = 0.45
"""Space between slate and words, as a share of the font size."""
USUAL = BoardLayout()


class _Print(ImageReader):
    """A picture that enters the PDF as the JPEG that it is; reportlab would decode it only to hash its pixels."""

    _dataA = None

    def getRGBData(self) -> bytes:
        packed = self.jpeg_fh()
        return super().getRGBData() if packed is None else packed.read()


def write_board(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    part: Path,
    layout: BoardLayout = USUAL,
) -> None:
    """Write the board.

    Args:
        graph: The story.
        frames: Shot name to picture, JPEG for a small file; a missing one is drawn as an empty frame.
        part: The PDF.
        layout: Of the pages.
    """
    fonts.register()
    rl_config.useA85 = 0  # pictures as the bytes they are: to write them as text takes nine tenths of the time
    size, aspect = page_size(layout), graph.format.aspect
    canvas = Canvas(str(part), pagesize=size, invariant=1)
    canvas.setTitle(graph.title or "Storyboard")
    canvas.setAuthor("StoryBlender")
    shots, cells = panels(graph), cells_of(layout, aspect)
    length = length_of(shots)
    pages = _pages(shots, layout.panels)
    listed: set[int] = set()
    for number, page in enumerate(pages, start=1):
        _page_frame(canvas, graph, length, (number, len(pages)), size)
        for index, (panel, cell) in enumerate(zip(page, cells, strict=False)):
            if index == 0 or panel.scene is not page[index - 1].scene:
                _heading(canvas, panel, cell)
            if panel.scene.scene_id not in listed:
                listed.add(panel.scene.scene_id)
                canvas.bookmarkPage(panel.name)
                canvas.addOutlineEntry(panel.scene.numbered_title, panel.name)
            _panel(canvas, panel, frames.get(panel.name), cell)
        canvas.showPage()
    canvas.save()


def _pages(items: Sequence[Panel], size: int) -> list[list[Panel]]:
    """Split panels into pages of ``size``; a single empty page for no panels."""
    return [list(items[index : index + size]) for index in range(0, len(items), size)] or [[]]


def _page_frame(
    canvas: Canvas, graph: ContinuityMemoryGraph, length: str, page: tuple[int, int], size: tuple[float, float]
) -> None:
    """Draw title, length, script version and page number around the panels."""
    across, down = size
    room = across - 2 * MARGIN
    length_width = canvas.stringWidth(length, fonts.REGULAR, 9)
    _line(canvas, graph.title or "Untitled", MARGIN, down - MARGIN, 12, room - length_width - GUTTER)
    _line(canvas, length, MARGIN, down - MARGIN, 9, room, color=GREY, right=True)
    source = " · ".join(filter(None, (graph.script_name, graph.edition)))
    _line(canvas, source, MARGIN, MARGIN - 12, 8, room * 0.8, color=GREY)
    _line(canvas, f"{page[0]} / {page[1]}", MARGIN, MARGIN - 12, 8, room, color=GREY, right=True)
    canvas.setStrokeColor(RULE)
    canvas.line(MARGIN, down - MARGIN - 8, across - MARGIN, down - MARGIN - 8)


def _heading(canvas: Canvas, panel: Panel, cell: Cell) -> None:
    """Draw the heading of a panel's scene over its picture."""
    left = min(cell.picture.left, cell.words.left)
    right = max(box.left + box.width for box in (cell.picture, cell.words))
    _line(canvas, panel.scene.numbered_title, left, cell.picture.top + 4, 9, right - left, color=GREY)


def _panel(canvas: Canvas, panel: Panel, frame: Path | None, cell: Cell) -> None:
    left, top, width, height = cell.picture
    bottom = top - height
    if frame is not None:
        canvas.drawImage(_Print(str(frame)), left, bottom, width, height)
    canvas.setStrokeColor(INK)
    canvas.setLineWidth(0.8)
    canvas.rect(left, bottom, width, height)
    if panel.way is not None:
        draw_way(canvas, panel, panel.way, left, bottom, width, height)
    slate = _slate(canvas, panel, cell)
    _words(canvas, panel, cell.words.left, slate, cell.words.width, slate - cell.words.bottom, cell.size)


def _slate(canvas: Canvas, panel: Panel, cell: Cell) -> float:
    """Draw name, length and camera of a shot, on two lines where one is too short; return where its words begin."""
    (x, top, width, _), size = cell.words, cell.size
    y = top - size * (1.0 if cell.beside else 1.35)
    _line(canvas, panel.name, x, y, size, width)
    length = f"{panel.seconds:.1f} s"
    _line(canvas, length, x, y, size * 0.86, width, color=GREY, right=True)
    facts = " · ".join(filter(None, (panel.status, panel.facts)))
    name_width = canvas.stringWidth(panel.name, fonts.REGULAR, size)
    room = width - name_width - canvas.stringWidth(length, fonts.REGULAR, size * 0.86) - 16
    if _width(canvas, facts, size * 0.86) <= room:
        _line(canvas, facts, x + name_width + 8, y, size * 0.86, room, color=GREY)
        return y - size * _GAP
    y -= size * 1.2
    _line(canvas, facts, x, y, size * 0.86, width, color=GREY)
    return y - size * _GAP


def _words(canvas: Canvas, panel: Panel, x: float, y: float, width: float, room: float, size: float) -> None:
    """Draw action, dialogue and notes; long text shrinks first and is then cut with an ellipsis.

    Args:
        canvas: The page.
        panel: The shot.
        x: Left edge in points.
        y: Upper edge.
        width: Of the text.
        room: Height for the text.
        size: Usual font size.
    """
    texts = _texts(panel, size)
    for smaller in (size * share for share in SHRINKING):
        if sum(text.wrap(width, room)[1] for text in texts) <= room or smaller < SMALLEST:
            break
        texts = _texts(panel, smaller)
    for paragraph in texts:
        _, used = paragraph.wrap(width, room)
        if used > room:
            for lines in paragraph.split(width - ELLIPSIS, room)[:1]:
                lines.wrap(width - ELLIPSIS, room)
                lines.drawOn(canvas, x, y - lines.height)
            canvas.setFillColor(GREY)
            canvas.setFont(fonts.REGULAR, size)
            canvas.drawRightString(x + width, y - room + 1, "…")
            return
        paragraph.drawOn(canvas, x, y - used)
        y, room = y - used, room - used


def _texts(panel: Panel, size: float) -> list[Flowable]:
    """Return the paragraphs under a picture; ``size`` is the font size of the slate in points."""
    style = ParagraphStyle("action", fontName=fonts.REGULAR, fontSize=size * 0.9, leading=size * 1.12, textColor=INK)
    speech = ParagraphStyle("speech", parent=style, leftIndent=size)
    texts = [
        _setting([(cue, GREY), (text, INK)], speech) if cue else _setting([(text, INK)], style)
        for cue, text in panel.script or (("", panel.description),)
    ]
    return texts + [_setting([("Note", GREY), (note, NOTE)], style) for note in panel.open_notes]


def _setting(pieces: Sequence[tuple[str, Color]], style: ParagraphStyle, most: int = 0) -> Flowable:
    """Return coloured texts as one paragraph, drawn as a picture where Noto Sans lacks a character.

    Args:
        pieces: Texts with their colours, in reading order.
        style: Size and indent.
        most: Most lines of the picture; 0 for all.
    """
    pieces = [(text[:MOST_LETTERS], color) for text, color in pieces]
    colored = [(text, f"#{color.hexval()[2:]}") for text, color in pieces]
    if not all(fonts.in_regular(text) for text, _ in pieces):
        return Lettering(colored, style.fontSize, style.leftIndent, most)
    return Paragraph(" ".join(f'<font color="{color}">{escape(text)}</font>' for text, color in colored), style)


def _line(
    canvas: Canvas,
    text: str,
    x: float,
    y: float,
    size: float,
    width: float,
    *,
    color: Color = INK,
    right: bool = False,
) -> None:
    """Draw one line of text, cut with an ellipsis if it is wider than ``width`` points; ``right`` aligns it right."""
    text = " ".join(text.splitlines())
    if len(text) > width or _width(canvas, text, size) > width:  # hardly a letter is narrower than a point
        fits = bisect_right(range(min(len(text), int(width))), width, key=lambda n: _width(canvas, _cut(text, n), size))
        text = _cut(text, max(0, fits - 1))
    if fonts.in_regular(text):
        canvas.setFillColor(color)
        canvas.setFont(fonts.REGULAR, size)
        (canvas.drawRightString if right else canvas.drawString)(x + width * right, y - size * BASELINE, text)
        return
    style = ParagraphStyle("line", fontName=fonts.REGULAR, fontSize=size, leading=size * 1.2,
                           textColor=color, alignment=2 if right else 0)  # fmt: skip
    paragraph = _setting([(text, color)], style, most=1)
    paragraph.wrap(width, size * 3)
    paragraph.drawOn(canvas, x, y - size * 0.35)


def _cut(text: str, length: int) -> str:
    return f"{text[:length].rstrip()}…"


def _width(canvas: Canvas, text: str, size: float) -> float:
    return canvas.stringWidth(text, fonts.REGULAR, size) if fonts.in_regular(text) else width_of(text, size)
