"""Moving frames for the animatic: one Workbench picture each, lit in numpy by the lamps of the shot's board."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.measure.figures import figures
from storyblender.blender.progress import Report, ignore
from storyblender.blender.render.detail import in_detail_seen
from storyblender.blender.render.flat_frames import animatic_workbench, draw_flat
from storyblender.blender.render.frame import FrameRequest, FrameResult, PersonHead, render_frame
from storyblender.blender.render.movement import watch
from storyblender.blender.render.picture import write_jpeg
from storyblender.blender.render.session import RenderSession
from storyblender.blender.render.smoke import puffs_of
from storyblender.blender.still import held_still
from storyblender.geometry.framing import Figure
from storyblender.look.aperture import look_through
from storyblender.look.atmosphere import add_rain
from storyblender.look.exposure import with_shadows_raised
from storyblender.look.grade import to_bytes, to_film
from storyblender.look.ink import add_lines
from storyblender.look.moving_focus import MovingFocus
from storyblender.look.moving_light import FlatFrame, MovingLight
from storyblender.look.optics import Lens
from storyblender.look.raster import Image as Picture
from storyblender.look.raster import Window
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting
from storyblender.memory.vocabulary import Aperture

_METER_WIDTH = 320
"""Width of the still whose lamps and exposure the whole shot keeps: exposure that follows the frames would flicker."""
_RIM = 3
"""Pixels of a window's edge that are not drawn anew."""
GROWN_HEAD = 0.235
"""Metres from crown to chin that count as scale 1."""


def render_motion(
    scene: bpy.types.Scene,
    camera_object: bpy.types.Object,
    frames: range,
    width: int,
    height: int,
    part: Path,
    lighting: Lighting,
    *,
    hidden_node_ids: Sequence[str] = (),
    in_frame: Sequence[str] | None = None,
    through: Aperture | None = None,
    soft_focus: bool = False,
    seed: int = 0,
    report: Report = ignore,
) -> tuple[Path, ...]:
    """Draw the frames of one shot, one JPEG for each, named by its number in five digits.

    Args:
        scene: With set, props and people; posed by its timeline.
        camera_object: A camera of the scene, animated or not.
        frames: Timeline frames to draw; every second one for an animatic on twos.
        width: Pixels.
        height: Pixels.
        part: An existing folder.
        lighting: The scene's light plan as designed.
        hidden_node_ids: Wild walls, taken away for this shot.
        in_frame: asset_ids of the people who get lamps of their own; None is everybody.
        through: What a point of view looks through.
        soft_focus: Whether a diffusion filter is before the lens.
        seed: Of the rain.
        report: Hears how many frames are drawn.
    """
    if not frames:
        return ()
    paths: list[Path] = []
    shown = np.zeros((height, width, 3), np.uint8)
    with ExitStack() as stack:
        session = stack.enter_context(RenderSession(scene, camera_object, frames[0], hidden_node_ids))
        stack.enter_context(in_detail_seen(session, frames, width, height))
        still = _metered(session, lighting, height / width, in_frame)
        plan, gain = still.balance.plan, np.float32(2.0**still.statistics.exposure)
        light = MovingLight(plan, still.balance.roofed, puffs_of(session.smoke_objects))
        movement = watch(session, frames, width, height)
        people = [_heads(faces, in_frame) for faces in movement.people]
        told = stack.enter_context(animatic_workbench(session, movement))
        focus = MovingFocus(height, width)
        flats = draw_flat(session, frames, movement, told)
        film = zip(frames, people, movement.anew, movement.lenses, flats, strict=True)
        for number, heads, anew, lens, flat in film:
            report(len(paths), len(frames))
            paths.append(part / f"{number:05d}.jpg")
            if plan.rain > 0:
                flat = replace(flat, changed=np.ones_like(flat.changed))
            elif not anew and not focus.differs(lens):
                shutil.copyfile(paths[-2], paths[-1])
                continue
            lamps = still.set_lights + _followed(still.lights, people[0], heads)
            parts = [
                (window, with_shadows_raised(picture * gain, still.statistics.shadow_lift))
                for window, picture in (light.light(flat, lamps) if anew or plan.rain > 0 else ())
            ]
            for window, picture in _finished(parts, flat, lens, focus, (plan.rain, seed + number)):
                _paste(shown, picture, window)
            write_jpeg(look_through(shown, through, soft_focus), paths[-1])
    return tuple(paths)


def _finished(
    parts: Sequence[tuple[Window, Picture]],
    flat: FlatFrame,
    lens: Lens | None,
    focus: MovingFocus,
    rain: tuple[float, int],
) -> list[tuple[Window, Picture]]:
    """Return the parts of a frame that are not as in the last one, linear, with lines, rain and depth of field.

    Args:
        parts: What differs in its light, exposed: windows and (h, w, 3).
        flat: The whole frame.
        lens: As it is set; None where everything is sharp.
        focus: Of this shot, with the frames before.
        rain: Its amount, 0 for none, and the seed of its drops.
    """
    if lens is None:
        wet = ((window, add_rain(picture, flat.depth[window.cut], *rain)) for window, picture in parts)
        return [(window, add_lines(picture, flat.depth[window.cut], flat.view)) for window, picture in wet]
    inked = [(window, add_lines(picture, flat.depth[window.cut], flat.view)) for window, picture in parts]
    seen = focus.blurred(inked, _RIM, flat.depth, lens)
    return [(window, add_rain(picture, flat.depth[window.cut], *rain)) for window, picture in seen]


def _metered(session: RenderSession, lighting: Lighting, tall: float, in_frame: Sequence[str] | None) -> FrameResult:
    """Draw the first frame as a small still, for its lamps and its exposure.

    Args:
        session: The shot.
        lighting: The scene's light plan as designed.
        tall: Height / width.
        in_frame: asset_ids of the people who get lamps of their own; None is everybody.
    """
    height = max(2, round(_METER_WIDTH * tall / 2) * 2)
    request = FrameRequest("fast", _METER_WIDTH, height, supersample=1, shadows=False)
    with held_still(session.scene) as moment:
        moment.collection.objects.link(session.camera)
        return render_frame(moment, session.camera, lighting, _heads(figures(session.scene), in_frame), request)


def _paste(shown: NDArray[np.uint8], picture: Picture, window: Window) -> None:
    """Lay the window over the last frame but for its rim, whose lines lack the neighbours beyond it."""
    height, width = shown.shape[:2]
    inner = window.inner(_RIM, height, width)
    top, left = inner.top - window.top, inner.left - window.left
    rows, columns = inner.shape
    shown[inner.cut] = to_bytes(to_film(picture[top : top + rows, left : left + columns]))


def _heads(faces: Sequence[Figure], in_frame: Sequence[str] | None) -> tuple[PersonHead, ...]:
    return tuple(
        PersonHead(figure.node_id, figure.face, figure.yaw, figure.head / GROWN_HEAD)
        for figure in faces
        if in_frame is None or figure.node_id in in_frame
    )


def _followed(lamps: Sequence[Light], before: Sequence[PersonHead], now: Sequence[PersonHead]) -> tuple[Light, ...]:
    """Move each face's lamps as its face has moved since the still."""
    start = {head.asset_id: np.asarray(head.location) for head in before}
    way = {head.asset_id: np.asarray(head.location) - start[head.asset_id] for head in now if head.asset_id in start}

    def moved(point: Vec3, by: np.ndarray) -> Vec3:
        x, y, z = (np.asarray(point) + by).tolist()
        return (x, y, z)

    return tuple(
        lamp.model_copy(
            update={
                "location": moved(lamp.location, way[lamp.for_asset]),
                "target": moved(lamp.target, way[lamp.for_asset]),
            }
        )
        if lamp.for_asset in way
        else lamp
        for lamp in lamps
    )
