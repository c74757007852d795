"""The flat pictures of a moving shot: texture and depth, and what glows.

Under a camera that stands still the set is drawn once, and then only what moves, in the part of the picture it reaches.
Workbench's own shadows, cavities and antialiasing cost five times the picture itself on a software renderer (measured
on the cafe: 0.70 s against 0.14 s of processor); the compositor's occlusion and lines stand in for them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager

import numpy as np

from storyblender.blender.hiding import out_of_picture
from storyblender.blender.render.complexion import told_in_shades
from storyblender.blender.render.exr import Channels, color
from storyblender.blender.render.movement import Movement
from storyblender.blender.render.passes import flat_workbench, has_painted_skin, render_glow
from storyblender.blender.render.session import DRAWN, RenderSession, changed
from storyblender.look.gbuffer import FAR, View
from storyblender.look.moving_light import FlatFrame
from storyblender.look.raster import Image, Mask, Window

_AT_ONCE = 24
"""Frames drawn by one call: Blender keeps what it knows of the scene between them."""


def draw_flat(session: RenderSession, frames: Sequence[int], movement: Movement) -> Iterator[FlatFrame]:
    """Give the flat frames of one shot, in order; a held one is the last one again. Use inside ``animatic_workbench``.

    Args:
        session: The shot.
        frames: Timeline frames.
        movement: Of these frames.
    """
    drawings = _drawings(session, frames, movement)
    flat = next(drawings)
    yield flat
    for anew in movement.anew[1:]:
        flat = next(drawings) if anew else flat
        yield flat


def _drawings(session: RenderSession, frames: Sequence[int], movement: Movement) -> Iterator[FlatFrame]:
    """Draw what is not held."""
    plate = _plate(session, frames[:1], movement) if movement.is_locked_off else None
    wanted = [(number, view) for number, view, anew in zip(frames, movement.views, movement.anew, strict=True) if anew]
    for first in range(0, len(wanted), _AT_ONCE):
        batch, views = zip(*wanted[first : first + _AT_ONCE], strict=True)
        yield from _whole(session, batch, movement, views) if plate is None else _over(plate, session, batch, movement)


def _whole(
    session: RenderSession, frames: Sequence[int], movement: Movement, views: Sequence[View]
) -> Iterator[FlatFrame]:
    """Draw everything: the camera moves."""
    width, height = views[0].width, views[0].height
    everywhere = np.ones((height, width), bool)
    with out_of_picture(movement.unseen):
        pictures = session.exr_frames(frames, width, height, depth=True)
        glows = render_glow(session, frames, width, height)
    for channels, view, glow in zip(pictures, views, glows, strict=True):
        yield _flat(channels, view, everywhere, glow)


def _plate(session: RenderSession, frame: Sequence[int], movement: Movement) -> FlatFrame:
    """Draw what stands still."""
    view = movement.views[0]
    with out_of_picture((*movement.unseen, *movement.movers)):
        (channels,) = session.exr_frames(frame, view.width, view.height, depth=True)
        (glow,) = render_glow(session, frame, view.width, view.height)
    return _flat(channels, view, np.zeros((view.height, view.width), bool), glow)


def _over(plate: FlatFrame, session: RenderSession, frames: Sequence[int], movement: Movement) -> Iterator[FlatFrame]:
    """Draw what moves, in its window, and lay it over the plate."""
    view, window, movers = plate.view, movement.window, set(movement.movers)
    with out_of_picture(obj for obj in session.scene.objects if obj.type in DRAWN and obj not in movers):
        pictures = session.exr_frames(frames, view.width, view.height, depth=True, window=window)
        glows = render_glow(session, frames, view.width, view.height, window=window)
    for channels, glow in zip(pictures, glows, strict=True):
        part = _flat(channels, view.cropped(window), np.ones(window.shape, bool), glow)
        yield _laid_over(plate, part, window)


def _laid_over(plate: FlatFrame, part: FlatFrame, window: Window) -> FlatFrame:
    """Return the plate with the part before it where that is nearer."""
    nearer = part.depth < plate.depth[window.cut]
    albedo, coverage = plate.albedo.copy(), plate.coverage.copy()
    depth, glow, moving = plate.depth.copy(), plate.glow.copy(), plate.moving.copy()
    for whole, piece in (
        (albedo, part.albedo),
        (coverage, part.coverage),
        (depth, part.depth),
        (glow, part.glow),
        (moving, part.moving),
    ):
        whole[window.cut][nearer] = piece[nearer]
    return FlatFrame(albedo, coverage, depth, glow, moving, plate.view, window)


def _flat(channels: Channels, view: View, moving: Mask, glow: Image) -> FlatFrame:
    coverage = channels["Combined.A"]
    depth = np.where(coverage > 0.5, channels["Depth.Z"], np.float32(FAR))
    return FlatFrame(color(channels), coverage, depth, glow, moving, view, view.whole)


@contextmanager
def animatic_workbench(session: RenderSession, movement: Movement) -> Iterator[None]:
    """Set Workbench up for flat frames of a shot."""
    unseen = set(movement.unseen)
    with ExitStack() as stack:
        stack.enter_context(flat_workbench(session.scene))
        stack.enter_context(changed(session.scene.display.shading, {"light": "FLAT", "color_type": "TEXTURE"}))
        for obj in session.scene.objects:
            if obj not in unseen and has_painted_skin(obj):
                stack.enter_context(told_in_shades(obj))
        yield
