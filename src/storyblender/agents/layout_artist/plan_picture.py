"""The plan of a layout as a picture: walls, doors, windows, footprints with ids and arrows for what faces where. Pure.

Seen from above, the audience below the lower edge. Language models get it where a layout is refined or judged.
"""

from __future__ import annotations

import io
import math
from dataclasses import dataclass, field

from PIL import Image, ImageDraw, ImageFont

from storyblender.agents.layout_artist.layout_things import thing_of, walls_of
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.fixtures import fixtures_of
from storyblender.geometry.boxes import Box, corners
from storyblender.geometry.relations import LayoutThing
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.request import Picture
from storyblender.memory.scene_context import Layout
from storyblender.reflection import view_digest

_LONG, _LARGEST = 1000, 90.0
"""Pixels of the longer side of the playing area, and most pixels a metre."""
_MARGIN = 1.0
"""Metres shown around the playing area."""
_TEXT = 14
"""Pixels."""
_NAMED = 0.45
"""Metres across from which the furniture of the set is named."""
_FOOT = 26
"""Pixels below the plan for the audience."""
_PAPER, _INK, _WALL, _DOOR, _WINDOW = "#ffffff", "#1a1a1a", "#4a4a4a", "#b06a1f", "#3b82c4"
_SET, _THING, _PERSON = "#e4e4e0", "#cfe0f2", "#f6c9b4"
"""Fills: furniture of the set, things of the script, people."""


@dataclass
class _Sheet:
    """A drawing in metres; y grows upwards.

    Attributes:
        draw: Draws in pixels.
        left: World x of the left edge.
        top: World y of the upper edge.
        scale: Pixels a metre.
        labels: Middle, upper edge and width of the texts so far, pixels.
    """

    draw: ImageDraw.ImageDraw
    left: float
    top: float
    scale: float
    labels: list[tuple[float, float, float]] = field(default_factory=list)

    def at(self, x: float, y: float) -> Vec2:
        """Return a world point in pixels."""
        return (x - self.left) * self.scale, (self.top - y) * self.scale

    def box(self, box: Box, fill: str, outline: str | None = _INK) -> None:
        """Draw the footprint of a box."""
        self.draw.polygon([self.at(x, y) for x, y, _ in corners(box)[:4]], fill=fill, outline=outline)

    def arrow(self, box: Box) -> None:
        """Draw an arrow from the middle of a box out of its front."""
        x, y = box.x, box.y
        fx, fy = box.forward
        reach = box.depth / 2 + 0.25
        tip = self.at(x + fx * reach, y + fy * reach)
        self.draw.line([self.at(x, y), tip], fill=_INK, width=2)
        x, y = x + fx * (reach - 0.16), y + fy * (reach - 0.16)
        barbs = [self.at(x + side * fy * 0.09, y - side * fx * 0.09) for side in (-1, 1)]
        self.draw.polygon([tip, *barbs], fill=_INK)

    def label(self, text: str, x: float, y: float, color: str = _INK) -> None:
        """Write a text at a world point, or below it where another text is."""
        px, py = self.at(x, y)
        font = ImageFont.load_default(_TEXT)
        wide = self.draw.textlength(text, font=font)
        left, top = px - wide / 2, py - _TEXT / 2
        while any(abs(left + wide / 2 - x) < (wide + w) / 2 and abs(top - y) < _TEXT for x, y, w in self.labels):
            top += _TEXT / 2
        self.labels.append((left + wide / 2, top, wide))
        self.draw.text((left, top), text, font=font, fill=color, stroke_width=2, stroke_fill=_PAPER)


def plan_picture(layout: Layout, view: SpatialPlannerView) -> Picture:
    """Return the plan of a layout, as a PNG about 1000 pixels wide.

    Args:
        layout: The layout.
        view: The scene.
    """
    size = layout.scene_size
    wide, deep = size.x - size.x_negative + 2 * _MARGIN, size.y - size.y_negative + 2 * _MARGIN
    scale = min(_LONG / max(wide, deep), _LARGEST)
    image = Image.new("RGB", (round(wide * scale), round(deep * scale) + _FOOT), _PAPER)
    sheet = _Sheet(ImageDraw.Draw(image), size.x_negative - _MARGIN, size.y + _MARGIN, scale)
    area = [sheet.at(size.x_negative, size.y), sheet.at(size.x, size.y_negative)]
    sheet.draw.rectangle([*area[0], *area[1]], outline="#c8c8c8")
    _draw_set(sheet, view)
    _draw_things(sheet, layout, view)
    sheet.label("audience", (size.x + size.x_negative) / 2, size.y_negative - _MARGIN - _FOOT / 2 / scale)
    part = io.BytesIO()
    image.save(part, "PNG")
    return Picture(name="plan", png=part.getvalue(), drawn_from=content_hash("plan", view_digest(view), layout))


def _draw_set(sheet: _Sheet, view: SpatialPlannerView) -> None:
    """Draw walls and solid parts, doors and windows, and named points of the floor."""
    for wall in walls_of(view.plan):
        sheet.box(wall.box, _WALL if wall.box.height > 1.5 else _SET)
    for part in fixtures_of(view.plan):
        if part.kind in ("door", "window"):
            color = _DOOR if part.kind == "door" else _WINDOW
            sheet.box(Box(part.box.x, part.box.y, 0, part.box.width, 0.12, 1, part.box.yaw), color, None)
            sheet.label(part.name, part.box.x, part.box.y, color)


def _draw_things(sheet: _Sheet, layout: Layout, view: SpatialPlannerView) -> None:
    """Draw footprints, the lowest first, then arrows and ids; small furniture of the set is not named."""
    dressed = {item.node_id for item in view.dressed}
    seen = (thing_of(item, view.measures, view.plan, view.placements) for item in layout.objects)
    things = sorted((thing for thing in seen if thing is not None), key=lambda thing: (thing.walks, thing.box.top))
    for thing in things:
        sheet.box(thing.box, _PERSON if thing.walks else _SET if thing.name in dressed else _THING)
    named = [thing for thing in things if thing.name not in dressed or _is_large(thing)]
    for thing in named:
        if thing.walks or (thing.name not in dressed and thing.relationship != "on_top_of"):
            sheet.arrow(thing.box)
    for thing in sorted(named, key=lambda thing: (thing.name in dressed, not thing.walks)):
        sheet.label(thing.name, thing.box.x, thing.box.y, "#6b6b6b" if thing.name in dressed else _INK)


def _is_large(thing: LayoutThing) -> bool:
    """Return whether a thing is large enough for its id."""
    return thing.box.z < 0.3 and math.sqrt(thing.box.width * thing.box.depth) > _NAMED
