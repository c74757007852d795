"""Camera moves drawn on a panel: an arrow, or the inner frame of a push in or pull out."""

from __future__ import annotations

import math

from reportlab.lib.colors import Color
from reportlab.pdfgen.canvas import Canvas

from storyblender.deliver.panel import Panel, Way

ARROW = Color(0.91, 0.27, 0.16, alpha=0.9)
NARROWEST_INNER, WIDEST_INNER = 0.25, 0.84
"""Smallest and largest inner frame that is drawn for a push in or pull out, as shares of the picture."""


def draw_way(canvas: Canvas, panel: Panel, way: Way, x: float, y: float, width: float, height: float) -> None:
    """Draw the camera move of a shot over its picture.

    Args:
        canvas: The page.
        panel: The shot.
        way: Direction of the move.
        x: Left edge of the picture in points.
        y: Lower edge.
        width: Of the picture.
        height: Of the picture.
    """
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
            _arrow(canvas, *((outer, corner) if way == "in" else (corner, outer)), line * 5)
    else:
        dx, dy = {"left": (-1, 0), "right": (1, 0), "up": (0, 1), "down": (0, -1)}[way]
        edge_x, edge_y = cx + dx * width * 0.42, cy + dy * height * 0.40
        if dx:
            edge_y = y + height * 0.09
        start = (edge_x - dx * width * 0.30, edge_y - dy * height * 0.40)
        _arrow(canvas, start, (edge_x, edge_y), line * 5)
    canvas.restoreState()


def _arrow(canvas: Canvas, start: tuple[float, float], end: tuple[float, float], size: float) -> None:
    """Draw a line with an arrow head of ``size`` points at its end."""
    canvas.line(*start, *end)
    angle = math.atan2(end[1] - start[1], end[0] - start[0])
    path = canvas.beginPath()
    path.moveTo(end[0] + size * 0.4 * math.cos(angle), end[1] + size * 0.4 * math.sin(angle))
    for turn in (2.6, -2.6):
        path.lineTo(end[0] + size * math.cos(angle + turn), end[1] + size * math.sin(angle + turn))
    path.close()
    canvas.drawPath(path, fill=1, stroke=0)
