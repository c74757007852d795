"""The storyboard as a PDF: a grid of panels, or one panel a page. A scene's heading stands over its first panel."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal
from xml.sax.saxutils import escape

from reportlab import rl_config
from reportlab.lib.colors import Color, HexColor
from reportlab.lib.pagesizes import A4, landscape
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.utils import ImageReader
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable, Paragraph

from storyblender.deliver import fonts
from storyblender.deliver.lettering import Lettering, width_of
from storyblender.deliver.panel import Panel, Way, cue_of, length_of, panels
from storyblender.memory.graph import ContinuityMemoryGraph

INK, GREY, RULE = HexColor("#1b1b1f"), HexColor("#6d6d76"), HexColor("#d5d5da")
ARROW = Color(0.91, 0.27, 0.16, alpha=0.9)
MARGIN, GUTTER = 30.0, 16.0
NARROWEST_INNER, WIDEST_INNER = 0.25, 0.84
"""Shares of the picture between which the frame of a camera going in or out is drawn, so that it can be read."""
HEADING = 13.0
"""Points over every picture for the heading of a scene that begins there."""
PAGE_WIDTH, PAGE_HEIGHT = landscape(A4)

LEAST_WORDS = 480.0
"""Points across that the words under a single picture have, however narrow it is."""
ELLIPSIS = 12.0
"""Points kept free at the right for the sign that more was written."""
SHRINKING = (0.9, 0.8, 0.7)
"""Shares that the letters of a long text shrink to before any of it is left out."""
PICTURE_SHARE = {"grid": 0.66, "single": 0.78}
"""At most this share of a panel's height is picture; the rest is for the words."""


class _Print(ImageReader):
    """A picture to be bound. A JPEG goes in as it is; reportlab would unpack it too, only to name it by its pixels."""

    _dataA = None

    def getRGBData(self) -> bytes:
        packed = self.jpeg_fh()
        return super().getRGBData() if packed is None else packed.read()


def write_board(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    part: Path,
    layout: Literal["grid", "single"] = "grid",
) -> None:
    """Write the board.

    Args:
        graph: The story.
        frames: Shot name to picture, JPEG for a small file; a missing one is drawn as an empty frame.
        part: The PDF.
        layout: ``grid`` sets six panels on a page, ``single`` one.
    """
    fonts.register()
    rl_config.useA85 = 0  # pictures as the bytes they are: to write them as text takes nine tenths of the time
    canvas = Canvas(str(part), pagesize=(PAGE_WIDTH, PAGE_HEIGHT), invariant=1)
    canvas.setTitle(graph.title or "Storyboard")
    canvas.setAuthor("StoryBlender")
    shots = panels(graph)
    pages = _pages(shots, 6 if layout == "grid" else 1)
    listed: set[int] = set()
    for number, page in enumerate(pages, start=1):
        _furniture(canvas, graph.title, length_of(shots), number, len(pages))
        for index, panel in enumerate(page):
            x, y, width, height = _cell(index, layout, graph.format.aspect)
            if index == 0 or panel.scene is not page[index - 1].scene:
                _line(canvas, panel.scene.numbered_title, x, y + 4, 9, width, color=GREY)
            if panel.scene.scene_id not in listed:
                listed.add(panel.scene.scene_id)
                canvas.bookmarkPage(panel.name)
                canvas.addOutlineEntry(panel.scene.numbered_title, panel.name)
            _panel(canvas, panel, frames.get(panel.name), graph.format.aspect, x, y, width, height, layout)
        canvas.showPage()
    canvas.save()


def _pages(items: Sequence[Panel], size: int) -> list[list[Panel]]:
    """Split into pages; one, without panels, where there is nothing to show."""
    return [list(items[index : index + size]) for index in range(0, len(items), size)] or [[]]


def _cell(index: int, layout: str, aspect: float) -> tuple[float, float, float, float]:
    """Left, top, width, height of a panel on the page."""
    top, height = PAGE_HEIGHT - MARGIN - 16, PAGE_HEIGHT - 2 * MARGIN - 22
    if layout == "single":
        picture = (height - HEADING) * PICTURE_SHARE["single"] * aspect
        width = min(PAGE_WIDTH - 2 * MARGIN, max(picture, LEAST_WORDS))
        return (PAGE_WIDTH - width) / 2, top - HEADING, width, height - HEADING
    width = (PAGE_WIDTH - 2 * MARGIN - 2 * GUTTER) / 3
    row_height = height / 2
    column, row = index % 3, index // 3
    return MARGIN + column * (width + GUTTER), top - HEADING - row * row_height, width, row_height - HEADING


def _furniture(canvas: Canvas, title: str, length: str, number: int, count: int) -> None:
    """Title, length and page number around the panels."""
    room = PAGE_WIDTH - 2 * MARGIN
    told = canvas.stringWidth(length, fonts.REGULAR, 9)
    _line(canvas, title or "Untitled", MARGIN, PAGE_HEIGHT - MARGIN, 12, room - told - GUTTER)
    _line(canvas, length, MARGIN, PAGE_HEIGHT - MARGIN, 9, room, color=GREY, right=True)
    canvas.setFillColor(GREY)
    canvas.setFont(fonts.REGULAR, 8)
    canvas.drawRightString(PAGE_WIDTH - MARGIN, MARGIN - 12, f"{number} / {count}")
    canvas.setStrokeColor(RULE)
    canvas.line(MARGIN, PAGE_HEIGHT - MARGIN - 8, PAGE_WIDTH - MARGIN, PAGE_HEIGHT - MARGIN - 8)


def _panel(
    canvas: Canvas,
    panel: Panel,
    frame: Path | None,
    aspect: float,
    x: float,
    top: float,
    width: float,
    height: float,
    layout: str,
) -> None:
    single = layout == "single"
    picture_height = min(width / aspect, height * PICTURE_SHARE[layout])
    picture_width = picture_height * aspect
    left = x + (width - picture_width) / 2
    bottom = top - picture_height
    if frame is not None:
        canvas.drawImage(_Print(str(frame)), left, bottom, picture_width, picture_height)
    canvas.setStrokeColor(INK)
    canvas.setLineWidth(0.8)
    canvas.rect(left, bottom, picture_width, picture_height)
    if panel.way is not None:
        _arrow(canvas, panel, panel.way, left, bottom, picture_width, picture_height)
    size = 13.0 if single else 9.0
    y = bottom - size * 1.35
    _line(canvas, panel.name, x, y, size, width)
    name_width = canvas.stringWidth(panel.name, fonts.REGULAR, size)
    _line(canvas, panel.facts, x + name_width + 8, y, size * 0.86, width - name_width - 40, color=GREY)
    _line(canvas, f"{panel.seconds:.1f} s", x, y, size * 0.86, width, color=GREY, right=True)
    _words(canvas, panel, x, y - 4, width, y - 4 - (top - height), size)


def _words(canvas: Canvas, panel: Panel, x: float, y: float, width: float, room: float, size: float) -> None:
    """Action, then dialogue, in smaller letters where it is long; an ellipsis says that more was written."""
    texts = _texts(panel, size)
    for shrunk in SHRINKING:
        if sum(text.wrap(width, room)[1] for text in texts) <= room:
            break
        texts = _texts(panel, size * shrunk)
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
    """What stands under a picture, in letters of ``size`` points and a little less."""
    style = ParagraphStyle("action", fontName=fonts.REGULAR, fontSize=size * 0.9, leading=size * 1.12, textColor=INK)
    speech = ParagraphStyle("speech", parent=style, leftIndent=size)
    said = panel.action or ("" if panel.dialogue else panel.outline.shot_description)
    texts = [_setting([(said, INK)], style)] if said else []
    return texts + [_setting([(cue_of(line), GREY), (line.text, INK)], speech) for line in panel.dialogue]


def _setting(pieces: Sequence[tuple[str, Color]], style: ParagraphStyle, most: int = 0) -> Flowable:
    """Return texts with their colours as a paragraph; as a picture of it where Noto Sans lacks their letters.

    Args:
        pieces: Texts with their colours, in reading order.
        style: Size and indent.
        most: Lines that a picture may have; 0 for all.
    """
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
    """One line of text, cut where it is too long."""
    while text and _width(canvas, text, size) > width:
        text = text[:-2].rstrip() + "…"
    style = ParagraphStyle("line", fontName=fonts.REGULAR, fontSize=size, leading=size * 1.2,
                           textColor=color, alignment=2 if right else 0)  # fmt: skip
    paragraph = _setting([(text, color)], style, most=1)
    paragraph.wrap(width, size * 3)
    paragraph.drawOn(canvas, x, y - size * 0.35)


def _width(canvas: Canvas, text: str, size: float) -> float:
    return canvas.stringWidth(text, fonts.REGULAR, size) if fonts.in_regular(text) else width_of(text, size)


def _arrow(canvas: Canvas, panel: Panel, way: Way, x: float, y: float, width: float, height: float) -> None:
    """Draw the camera move on the picture as boards do: an arrow, or the frame that it closes to or opens from."""
    canvas.saveState()
    canvas.setStrokeColor(ARROW)
    canvas.setFillColor(ARROW)
    line = min(2.5, max(1.2, width / 200))
    canvas.setLineWidth(line)
    cx, cy = x + width / 2, y + height / 2
    if way in ("in", "out"):
        inner = min(WIDEST_INNER, max(NARROWEST_INNER, panel.closes_to)) / 2
        canvas.setDash(line * 4, line * 3)
        canvas.rect(cx - width * inner, cy - height * inner, width * inner * 2, height * inner * 2)
        canvas.setDash()
        begins = min(0.47, inner + 0.17)
        for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            outer, corner = ((cx + sx * width * at, cy + sy * height * at) for at in (begins, inner))
            _head(canvas, *((outer, corner) if way == "in" else (corner, outer)), line * 5)
    else:
        dx, dy = {"left": (-1, 0), "right": (1, 0), "up": (0, 1), "down": (0, -1)}[way]
        edge_x, edge_y = cx + dx * width * 0.42, cy + dy * height * 0.40
        if dx:
            edge_y = y + height * 0.09
        start = (edge_x - dx * width * 0.30, edge_y - dy * height * 0.40)
        _head(canvas, start, (edge_x, edge_y), line * 5)
    canvas.restoreState()


def _head(canvas: Canvas, start: tuple[float, float], end: tuple[float, float], size: float) -> None:
    """A line with an arrow head at its end."""
    canvas.line(*start, *end)
    angle = math.atan2(end[1] - start[1], end[0] - start[0])
    path = canvas.beginPath()
    path.moveTo(end[0] + size * 0.4 * math.cos(angle), end[1] + size * 0.4 * math.sin(angle))
    for turn in (2.6, -2.6):
        path.lineTo(end[0] + size * math.cos(angle + turn), end[1] + size * math.sin(angle + turn))
    path.close()
    canvas.drawPath(path, fill=1, stroke=0)
