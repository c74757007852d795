"""The flat pictures of a moving shot: texture and depth, faces in their own colours, what glows.

Workbench's own shadows, cavities and antialiasing cost five times the picture itself on a software renderer (measured
on the cafe: 0.70 s against 0.14 s of processor); the compositor's occlusion and lines stand in for them.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.exr import color
from storyblender.blender.render.passes import flat_workbench, has_painted_skin, render_glow
from storyblender.blender.render.session import RenderSession, changed
from storyblender.look.gbuffer import FAR, View
from storyblender.look.moving_light import FlatFrame, same_view

_SAME_PLACE = 0.01
_SKIN = np.array([0.50, 0.34, 0.27], np.float32)
"""What every skin is painted while its own colours are drawn apart; near to all of them, so edges do not fringe."""
_OTHERS = (0.0, 0.0, 1.0, 1.0)
"""What all other things are painted then; no skin is pure blue."""


@dataclass(frozen=True)
class _Plate:
    """The set without its people, from where the camera stands.

    Attributes:
        view: The camera.
        depth: (h, w).
        glow: (h, w, 3) light given off.
    """

    view: View
    depth: NDArray[np.float32]
    glow: NDArray[np.float32]


class FlatCamera:
    """Draws the flat frames of one shot; use inside ``animatic_workbench``.

    Args:
        session: The shot.
        width: Pixels.
        height: Pixels.
        painted: Draw brows, lips and complexion, as ``animatic_workbench`` was told.
    """

    def __init__(self, session: RenderSession, width: int, height: int, *, painted: bool) -> None:
        self._session, self._width, self._height = session, width, height
        self._painted = painted and any(has_painted_skin(obj) for obj in session.visible_objects())
        self._plate: _Plate | None = None

    def draw(self) -> FlatFrame:
        """Draw the frame the timeline stands at."""
        channels = self._session.exr(self._width, self._height, depth=True)
        view = self._session.view(self._width, self._height)
        coverage = channels["Combined.A"]
        depth = np.where(coverage > 0.5, channels["Depth.Z"], np.float32(FAR))
        albedo = color(channels)
        if self._painted:
            albedo *= self._skin_tint()
        if self._plate is None or not same_view(self._plate.view, view):
            self._plate = self._draw_plate(view)
        bare = np.abs(depth - self._plate.depth) < _SAME_PLACE * depth
        return FlatFrame(albedo, coverage, depth, self._plate.glow * bare[..., None], ~bare, view)

    def _skin_tint(self) -> NDArray[np.float32]:
        """Return what turns the one colour of all skin into each pixel's own: brows, lips, complexion."""
        scene = self._session.scene
        with flat_workbench(scene), changed(scene.display.shading, {"light": "FLAT", "color_type": "VERTEX"}):
            seen = color(self._session.exr(self._width, self._height))
        skin = (seen[..., 2] < 0.95) & (seen.max(axis=2) > 0)
        return np.where(skin[..., None], seen / _SKIN, np.float32(1))

    def _draw_plate(self, view: View) -> _Plate:
        with ExitStack() as stack:
            for obj in self._session.visible_objects():
                if obj.get("kind") == "character":
                    stack.enter_context(changed(obj, {"hide_render": True}))
            glow, depth = render_glow(self._session, self._width, self._height)
        return _Plate(view, depth, glow)


@contextmanager
def animatic_workbench(session: RenderSession, *, painted: bool) -> Iterator[None]:
    """Set Workbench up for flat frames.

    Args:
        session: The shot.
        painted: Faces are large enough for brows and lips: a second pass draws them. Otherwise skin has one colour.
    """
    scene = session.scene
    with ExitStack() as stack:
        stack.enter_context(flat_workbench(scene))
        stack.enter_context(changed(scene.display.shading, {"light": "FLAT", "color_type": "TEXTURE"}))
        for obj in session.visible_objects():
            if has_painted_skin(obj):
                skin = _SKIN if painted else _complexion(obj)
                for slot in obj.material_slots:
                    stack.enter_context(changed(slot.material, {"diffuse_color": (*skin.tolist(), 1.0)}))
            else:
                stack.enter_context(changed(obj, {"color": _OTHERS}))
        yield


def _complexion(obj: bpy.types.Object) -> NDArray[np.float32]:
    """Return the mean of the colours painted on an object."""
    layer = obj.data.color_attributes[0]
    colors = np.empty(len(layer.data) * 4, np.float32)
    layer.data.foreach_get("color", colors)
    return colors.reshape(-1, 4)[:, :3].mean(axis=0)
