"""Path-traced light: few samples at low resolution for the boards, full size for the final picture."""

from __future__ import annotations

from contextlib import ExitStack

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.exr import color
from storyblender.blender.render.session import RenderSession, changed
from storyblender.look.surface import Surface


def render_cycles(
    session: RenderSession, width: int, height: int, *, samples: int, bounces: int, seed: int, draft: bool = True
) -> NDArray[np.float32]:
    """Return the (h, w, 3) linear picture of the scene as it is lit, sky included.

    Args:
        session: The frame; its lamps are set already.
        width: Pixels.
        height: Pixels.
        samples: Paths a pixel; the denoiser does the rest.
        bounces: Path length.
        seed: Of the sampling pattern; the same seed gives the same pixels.
        draft: Denoise fast and clamp hard, for light that texture will cover.
    """
    scene = session.scene
    settings = {
        "device": "CPU",
        "seed": seed % 2**31,
        "samples": samples,
        "use_adaptive_sampling": False,
        "use_denoising": True,
        "denoiser": "OPENIMAGEDENOISE",
        "denoising_quality": "FAST" if draft else "HIGH",
        "denoising_input_passes": "RGB_ALBEDO_NORMAL",
        "max_bounces": bounces,
        "diffuse_bounces": min(2, bounces) if draft else bounces,
        "glossy_bounces": 2,
        "transmission_bounces": 2 if draft else 6,
        "caustics_reflective": False,
        "caustics_refractive": False,
        "sample_clamp_direct": 20.0,
        "sample_clamp_indirect": 2.0 if draft else 6.0,
        "blur_glossy": 1.0,
        "pixel_filter_type": "BLACKMAN_HARRIS",
        "filter_width": 1.3,
        "use_light_tree": True,
        "use_fast_gi": False,
    }
    with ExitStack() as stack:
        stack.enter_context(changed(scene.render, {"engine": "CYCLES", "film_transparent": False}))
        stack.enter_context(changed(scene.cycles, settings))
        # A wall taken away for the camera still keeps the daylight out.
        for wall in session.hidden_objects:
            stack.enter_context(changed(wall, {"hide_render": False, "visible_camera": False}))
        for obj in session.visible_objects():
            if int(obj.get("surface", Surface.PROP)) == Surface.CARD:
                stack.enter_context(changed(obj, {"visible_shadow": False}))
        return color(session.exr(width, height))
