"""The flat pictures of a moving shot: texture and depth, and what glows.

Under a camera that stands still the set is drawn once, and then only what moves, in the part of the picture it reaches.
Workbench's own shadows, cavities and antialiasing cost five times the picture itself on a software renderer (measured
on the cafe: 0.70 s against 0.14 s of processor); the compositor's occlusion and lines stand in for them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from itertools import repeat

import bpy
import numpy as np

from storyblender.blender.hiding import out_of_picture
from storyblender.blender.render.coarser import in_coarser_pictures
from storyblender.blender.render.complexion import told_in_shades
from storyblender.blender.render.exr import Channels, color
from storyblender.blender.render.glow import Told, render_glow, told_by_number
from storyblender.blender.render.movement import Movement
from storyblender.blender.render.passes import flat_workbench, has_painted_skin
from storyblender.blender.render.session import DRAWN, RenderSession, changed
from storyblender.look.far_textures import HALVINGS
from storyblender.look.gbuffer import FAR, View
from storyblender.look.moving_light import FlatFrame
from storyblender.look.raster import Image, Mask, Window, windows_round

_AT_ONCE = 24
"""Frames drawn by one call: Blender keeps what it knows of the scene between them."""
_BODY = 32
"""Pixels over which two places that have changed belong to one body."""
_SAME = 0.002
"""Change of depth, as a share of it, below which a pixel still shows the same place."""
_TONE, _DARK = 0.03, 0.1
"""Change of colour, as a share of it and of a dark one, below which a pixel looks the same."""


def draw_flat(session: RenderSession, frames: Sequence[int], movement: Movement, told: Told) -> Iterator[FlatFrame]:
    """Give the flat frames of one shot, in order; a held one is the last one again. Use inside ``animatic_workbench``.

    Args:
        session: The shot.
        frames: Timeline frames.
        movement: Of these frames.
        told: What ``animatic_workbench`` gave.
    """
    drawings = _drawings(session, frames, movement, told)
    flat = next(drawings)
    yield flat
    for anew in movement.anew[1:]:
        flat = next(drawings) if anew else flat
        yield flat


def _drawings(session: RenderSession, frames: Sequence[int], movement: Movement, told: Told) -> Iterator[FlatFrame]:
    """Draw what is not held."""
    plate = _plate(session, frames[:1], movement, told) if movement.is_locked_off else None
    wanted = [(number, view) for number, view, anew in zip(frames, movement.views, movement.anew, strict=True) if anew]
    last = plate
    for first in range(0, len(wanted), _AT_ONCE):
        batch, views = zip(*wanted[first : first + _AT_ONCE], strict=True)
        if plate is None or last is None:
            yield from _whole(session, batch, movement, told, views)
            continue
        for part in _parts(session, batch, movement, told, plate.view):
            last = _laid_over(plate, part, movement.window, last)
            yield last


def _whole(
    session: RenderSession, frames: Sequence[int], movement: Movement, told: Told, views: Sequence[View]
) -> Iterator[FlatFrame]:
    """Draw everything: the camera moves."""
    width, height = views[0].width, views[0].height
    with out_of_picture(movement.unseen):
        pictures = session.exr_frames(frames, width, height, depth=True)
        depths = [channels["Depth.Z"] for channels in pictures]
        glows = render_glow(session, frames, (width, height), depths, told)
    for channels, view, glow in zip(pictures, views, glows or repeat(None, len(pictures)), strict=True):
        yield _flat(channels, view, told, glow)


def _plate(session: RenderSession, frame: Sequence[int], movement: Movement, told: Told) -> FlatFrame:
    """Draw what stands still."""
    view = movement.views[0]
    with out_of_picture((*movement.unseen, *movement.movers)):
        (channels,) = session.exr_frames(frame, view.width, view.height, depth=True)
        glows = render_glow(session, frame, (view.width, view.height), [channels["Depth.Z"]], told)
    return _flat(channels, view, told, glows[0] if glows else None)


def _parts(
    session: RenderSession, frames: Sequence[int], movement: Movement, told: Told, view: View
) -> Iterator[FlatFrame]:
    """Draw what moves, in its window."""
    window, movers = movement.window, set(movement.movers)
    with out_of_picture(obj for obj in session.scene.objects if obj.type in DRAWN and obj not in movers):
        pictures = session.exr_frames(frames, view.width, view.height, depth=True, window=window)
        depths = [channels["Depth.Z"] for channels in pictures]
        glows = render_glow(session, frames, (view.width, view.height), depths, told, window)
    for channels, glow in zip(pictures, glows or repeat(None, len(pictures)), strict=True):
        yield _flat(channels, view.cropped(window), told, glow)


def _laid_over(plate: FlatFrame, part: FlatFrame, window: Window, last: FlatFrame) -> FlatFrame:
    """Return the plate with the part before it where that is nearer; what differs invisibly stays as it was.

    Args:
        plate: What stands still.
        part: What moves.
        window: Where the part lies.
        last: The frame before; the plate itself before the first.
    """
    nearer = part.depth < plate.depth[window.cut]
    changed, moving = np.zeros(last.depth.shape, bool), np.zeros(last.depth.shape, bool)
    moving[window.cut] = nearer
    layers = [np.copy(layer, order="K") for layer in (last.depth, last.albedo, last.coverage, last.glow)]
    pieces = (part.depth, part.albedo, part.coverage, part.glow)
    behind = (plate.depth, plate.albedo, plate.coverage, plate.glow)
    for near in windows_round(nearer | last.moving[window.cut], 0, _BODY):
        here = near.moved(window.top, window.left).cut
        front = nearer[near.cut]
        now = [_in_front(front, piece[near.cut], back[here]) for piece, back in zip(pieces, behind, strict=True)]
        differs = _differs(now, [layer[here] for layer in layers])
        # A person who turns a little keeps much of depth and colour, but takes the light otherwise.
        body = front | last.moving[here]
        for piece in windows_round(differs, _BODY // 2):
            differs[piece.cut] |= body[piece.cut]
        changed[here] = differs
        for layer, value in zip(layers, now, strict=True):
            np.copyto(layer[here], value, where=_over(differs, value))
    depth, albedo, coverage, glow = layers
    return FlatFrame(albedo, coverage, depth, glow, changed, moving, plate.view)


def _in_front(front: Mask, piece: Image, back: Image) -> Image:
    result = np.copy(back, order="K")
    np.copyto(result, piece, where=_over(front, piece))
    return result


def _over(mask: Mask, layer: Image) -> Mask:
    """Return the mask for all that a pixel of the layer holds."""
    return mask if layer.ndim == 2 else mask[..., None]


def _differs(now: Sequence[Image], before: Sequence[Image]) -> Mask:
    """Return where depth, albedo or glow are not the same to the eye; both in that order, coverage third."""
    differs = np.abs(now[0] - before[0]) > _SAME * now[0]
    for layer, last in ((now[1], before[1]), (now[3], before[3])):
        away = np.abs(layer - last) - _TONE * (layer + _DARK)
        differs |= np.maximum(np.maximum(away[..., 0], away[..., 1]), away[..., 2]) > 0
    return differs


def _flat(channels: Channels, view: View, told: Told, glow: Image | None) -> FlatFrame:
    """Return a picture as it was drawn, with what its colours tell of light; ``glow`` is what was drawn for itself."""
    albedo, given = told.read(color(channels))
    if glow is not None:
        given += glow
    coverage = channels["Combined.A"]
    depth = np.where(coverage > 0.5, channels["Depth.Z"], np.float32(FAR))
    everywhere, nowhere = np.ones(depth.shape, bool), np.zeros(depth.shape, bool)
    return FlatFrame(albedo, coverage, depth, given, everywhere, nowhere, view)


@contextmanager
def animatic_workbench(session: RenderSession, movement: Movement) -> Iterator[Told]:
    """Set Workbench up for flat frames of a shot; give what their colours tell of light.

    Args:
        session: The open scene.
        movement: The shot; what is outside its picture all the time stays as it is.
    """
    unseen = set(movement.unseen)
    with ExitStack() as stack:
        told = stack.enter_context(told_by_number())
        stack.enter_context(flat_workbench(session.scene))
        stack.enter_context(changed(session.scene.display.shading, {"light": "FLAT", "color_type": "TEXTURE"}))
        stack.enter_context(in_coarser_pictures(list(bpy.data.materials), HALVINGS[0]))
        for obj in session.scene.objects:
            if obj not in unseen and has_painted_skin(obj):
                stack.enter_context(told_in_shades(obj))
        yield told
