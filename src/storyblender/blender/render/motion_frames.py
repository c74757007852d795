"""Moving frames for the animatic: one Workbench picture each, lit in numpy by the lamps of the shot's board."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy
import numpy as np

from storyblender.blender.measure.figures import figures
from storyblender.blender.render.flat_frames import FlatCamera, animatic_workbench
from storyblender.blender.render.frame import FrameRequest, PersonHead, render_frame
from storyblender.blender.render.picture import write_png
from storyblender.blender.render.session import RenderSession
from storyblender.look.atmosphere import add_rain
from storyblender.look.grade import to_bytes, to_display
from storyblender.look.ink import add_lines
from storyblender.look.moving_light import MovingLight
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting

_METER_WIDTH = 320
"""Width of the still whose lamps and exposure the whole shot keeps: exposure that follows the frames would flicker."""
_LARGE_FACE = 26
"""Pixels from crown to chin from which a second pass for the colours of faces is worth its time."""
GROWN_HEAD = 0.235
"""Metres from crown to chin that count as scale 1."""


def render_motion(
    scene: bpy.types.Scene,
    camera_object: bpy.types.Object,
    frames: Sequence[int],
    width: int,
    height: int,
    out_dir: Path,
    lighting: Lighting,
    *,
    hidden_node_ids: Sequence[str] = (),
    in_frame: Sequence[str] | None = None,
    seed: int = 0,
) -> tuple[Path, ...]:
    """Draw the frames of one shot, one PNG for each, named by its number in five digits.

    Args:
        scene: With set, props and people; posed by its timeline.
        camera_object: A camera of the scene, animated or not.
        frames: Timeline frames to draw; every second one for an animatic on twos.
        width: Pixels.
        height: Pixels.
        out_dir: An existing folder.
        lighting: The scene's light plan as designed.
        hidden_node_ids: Wild walls, taken away for this shot.
        in_frame: asset_ids of the people who get lamps of their own; None is everybody.
        seed: Of the rain.
    """
    if not frames:
        return ()
    still_request = FrameRequest(
        look="fast",
        width=_METER_WIDTH,
        height=max(2, round(_METER_WIDTH * height / width / 2) * 2),
        frame=frames[0],
        hidden_node_ids=tuple(hidden_node_ids),
        supersample=1,
    )
    paths = []
    with RenderSession(scene, camera_object, frames[0], hidden_node_ids) as session:
        first = _heads(scene, in_frame)
        still = render_frame(scene, camera_object, lighting, first, still_request)
        gain = np.float32(2.0**still.statistics.exposure)
        plan, light = still.balance.plan, MovingLight(still.balance.plan, still.balance.roofed)
        close = any(_faces_are_large(session, frame, width, height) for frame in (frames[-1], frames[0]))
        with animatic_workbench(session, painted=close):
            camera = FlatCamera(session, width, height, painted=close)
            for number in frames:
                session.go_to(number)
                flat = camera.draw()
                lamps = still.set_lights + _followed(still.lights, first, _heads(scene, in_frame))
                picture = light.light(flat, lamps) * gain
                picture = add_lines(add_rain(picture, flat.depth, plan.rain, seed + number), flat.depth, flat.view)
                paths.append(out_dir / f"{number:05d}.png")
                write_png(to_bytes(to_display(picture)), paths[-1], quick=True)
    return tuple(paths)


def _faces_are_large(session: RenderSession, frame: int, width: int, height: int) -> bool:
    """Return whether a face in the picture is tall enough to show its brows and lips."""
    session.go_to(frame)
    view = session.view(width, height)
    for figure in figures(session.scene):
        _, row, depth = view.project(np.asarray(figure.face))
        rows = figure.head * view.pixels_per_metre / max(float(depth), 0.1)
        if depth > 0 and -rows < row < height + rows and rows > _LARGE_FACE:
            return True
    return False


def _heads(scene: bpy.types.Scene, in_frame: Sequence[str] | None) -> tuple[PersonHead, ...]:
    return tuple(
        PersonHead(figure.node_id, figure.face, figure.yaw, figure.head / GROWN_HEAD)
        for figure in figures(scene)
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
