"""The viewfinder's picture, for those who want to see it: plain colours in studio light, drawn by Workbench."""

from __future__ import annotations

from typing import Final

import numpy as np

from storyblender.blender.measure.view import OpenViewfinder, ViewfinderPose
from storyblender.blender.render.exr import color
from storyblender.blender.render.session import changed
from storyblender.blender.render.turning import encode_srgb
from storyblender.look.viewfinder_picture import MARGIN, annotated, as_png

WIDTH: Final = 512
"""Pixels."""
_STUDIO: Final = {
    "light": "STUDIO", "studio_light": "paint.sl", "color_type": "TEXTURE", "show_cavity": True, "cavity_type": "BOTH",
    "show_object_outline": True, "object_outline_color": (0.05, 0.05, 0.06),
}  # fmt: skip
_SKY, _NOTHING = (0.62, 0.74, 0.85), (0.02, 0.02, 0.02)
"""Colours of the sky and of what is not built, sRGB."""


def preview(finder: OpenViewfinder, view: ViewfinderPose, aspect: float) -> bytes:
    """Return a picture of a camera pose as PNG, wider than the frame, with the focus outlined.

    Args:
        finder: Open at the pose's frame.
        view: The pose.
        aspect: Width over height.
    """
    width, height = WIDTH, max(2, round(WIDTH / aspect))
    session = finder.session
    with finder.aimed(view, width, height, MARGIN) as orbit:
        ids, sky, _ = finder.mask(orbit, width, height)
        display = session.scene.display
        with changed(display, {"render_aa": "5"}), changed(display.shading, _STUDIO):
            channels = session.exr(width, height)
    drawn, alpha = color(channels), channels["Combined.A"][..., None]
    behind = np.where(sky[..., None], np.array(_SKY), np.array(_NOTHING))
    picture = encode_srgb(drawn) * alpha + behind * (1 - alpha)
    focus = [ids == finder.numbers[node] for node in view.focus_ids if node in finder.numbers]
    return as_png(annotated((picture.clip(0, 1) * 255).round().astype(np.uint8), focus))
