"""Moving frames for the animatic: one Workbench picture each, lit in numpy by the lamps of the shot's board."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.measure.figures import figures
from storyblender.blender.render.exr import color
from storyblender.blender.render.frame import FrameRequest, PersonHead, render_frame
from storyblender.blender.render.meter import balanced
from storyblender.blender.render.passes import flat_workbench, render_glow
from storyblender.blender.render.picture import write_png
from storyblender.blender.render.session import RenderSession, changed
from storyblender.look.atmosphere import add_rain
from storyblender.look.gbuffer import FAR, View
from storyblender.look.grade import to_bytes, to_display
from storyblender.look.illumination import direction_of
from storyblender.look.moving_light import FlatFrame, MovingLight, same_view
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting

_METER_WIDTH = 320
"""Width of the still whose lamps and exposure the whole shot keeps: exposure that follows the frames would flicker."""
GROWN_HEAD = 0.235
"""Metres from crown to chin that count as scale 1."""
_SAME_PLACE = 0.01
_LINE = (0.012, 0.010, 0.012)
_SHADOW = 0.4


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
        set_light = balanced(scene, lighting)
        plan, light = set_light.plan, MovingLight(set_light.plan, set_light.roofed)
        glow: tuple[View, NDArray[np.float32], NDArray[np.float32]] | None = None
        with _animatic_workbench(session, still.set_lights + still.lights):
            for number in frames:
                session.go_to(number)
                lamps = still.set_lights + _followed(still.lights, first, _heads(scene, in_frame))
                channels, view = session.exr(width, height, depth=True), session.view(width, height)
                depth = np.where(channels["Combined.A"] > 0.5, channels["Depth.Z"], np.float32(FAR))
                if glow is None or not same_view(glow[0], view):
                    glow = (view, depth, render_glow(session, width, height))
                shown = np.abs(depth - glow[1]) < _SAME_PLACE * depth
                flat = FlatFrame(color(channels), channels["Combined.A"], depth, glow[2] * shown[..., None], view)
                picture = add_rain(light.light(flat, lamps) * gain, depth, plan.rain, seed + number)
                paths.append(out_dir / f"{number:05d}.png")
                write_png(to_bytes(to_display(picture)), paths[-1], quick=True)
    return tuple(paths)


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


@contextmanager
def _animatic_workbench(session: RenderSession, lamps: Sequence[Light]) -> Iterator[None]:
    """Flat texture with outlines, cavities and one hard shadow, from the sun or else from the first key."""
    scene = session.scene
    caster = next((lamp for lamp in lamps if lamp.kind == "SUN"), None)
    caster = caster or next((lamp for lamp in lamps if lamp.role == "key"), None)
    toward = -direction_of(caster) if caster else np.array([0.3, -0.5, 0.8])
    shading = {
        "light": "FLAT",
        "color_type": "TEXTURE",
        "show_shadows": True,
        "shadow_intensity": _SHADOW,
        "show_cavity": True,
        "cavity_type": "BOTH",
        "cavity_ridge_factor": 0.4,
        "cavity_valley_factor": 1.2,
        "curvature_ridge_factor": 0.3,
        "curvature_valley_factor": 0.7,
        "show_object_outline": True,
        "object_outline_color": _LINE,
    }
    display = {
        "render_aa": "FXAA",
        # Workbench wants the direction to the light with its axes turned (notes: engine, section 4).
        "light_direction": (float(toward[0]), float(toward[2]), float(-toward[1])),
        "matcap_ssao_distance": 0.25,
    }
    with ExitStack() as stack:
        stack.enter_context(flat_workbench(scene))
        stack.enter_context(changed(scene.display.shading, shading))
        stack.enter_context(changed(scene.display, display))
        if caster is None or caster.kind != "SUN":
            # Indoors, walls and ceiling would put everything in shadow.
            for obj in session.visible_objects():
                if obj.get("kind") == "set":
                    stack.enter_context(changed(obj.display, {"show_shadows": False}))
        yield
