"""Exchange formats of one scene: glTF and USD, with the people's motion."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import bpy

from storyblender.errors import EngineError

_PLACED = ("location", "rotation_quaternion", "rotation_euler", "scale")
"""What of an object glTF can move."""


def export_scene(story: Path, scene_name: str, kind: Literal["glb", "usd"], part: Path) -> None:
    """Write one scene of the story's file.

    Args:
        story: The compiled .blend, opened with scripts disabled.
        scene_name: For example ``SC010``.
        kind: ``glb`` or ``usd``.
        part: The file to write.

    Raises:
        EngineError: The file has no such scene.
    """
    bpy.ops.wm.open_mainfile(filepath=str(story), load_ui=False, use_scripts=False)
    scene = bpy.data.scenes.get(scene_name)
    if scene is None:
        raise EngineError(f"{story.name} has no scene {scene_name}")
    bpy.context.window.scene = scene
    if kind == "glb":
        _lighten(scene)
        _string(scene)
        bpy.ops.export_scene.gltf(
            filepath=str(part),
            export_format="GLB",
            use_active_scene=True,
            export_cameras=True,
            export_lights=True,
            export_extras=True,
            export_animation_mode="NLA_TRACKS",
            export_force_sampling=False,
            export_current_frame=True,  # without motion people stand where the scene begins
            export_optimize_animation_keep_anim_object=True,  # who stands still in a shot stands there
        )
    else:
        bpy.ops.wm.usd_export(filepath=str(part), export_animation=True, export_armatures=True, export_lights=True)


def _lighten(scene: bpy.types.Scene) -> None:
    """Switch off what shapes meshes in the view: glTF takes them as they are, but each frame would reckon them anew."""
    for obj in scene.objects:
        for modifier in obj.modifiers:
            modifier.show_viewport = False


def _string(scene: bpy.types.Scene) -> None:
    """Make a strip of what moves by an action of its own, cameras and doors: glTF gets an animation a strip's track."""
    for obj in scene.objects:
        data = obj.animation_data
        if data is None or data.action is None or data.nla_tracks:
            continue
        if any(curve.data_path in _PLACED for curve in data.action.fcurves):
            action, slot, track = data.action, data.action_slot, data.nla_tracks.new()
            track.name = obj.name if obj.type == "CAMERA" else scene.name
            strip = track.strips.new(track.name, int(action.frame_range[0]), action)
            strip.action_slot = slot
            data.action = None
