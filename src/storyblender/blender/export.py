"""Exchange formats of one scene: glTF and USD, with people's motion and the visibility of objects in each shot."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import bpy

from storyblender.blender.glb_visibility import hide_nodes
from storyblender.blender.hiding import is_hidden, key_hidden
from storyblender.blender.people.control_rig import remove_controls
from storyblender.blender.usd_visibility import hide_prims
from storyblender.errors import EngineError

_PLACED = ("location", "rotation_quaternion", "rotation_euler", "scale")
"""Properties of an object that glTF can animate."""


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
    remove_controls([obj for obj in scene.objects if obj.type == "ARMATURE"])
    shots = [(marker.name, marker.frame) for marker in sorted(scene.timeline_markers, key=lambda mark: mark.frame)]
    shown = _show_all(scene, [frame for _, frame in shots])
    if kind == "glb":
        _export_glb(scene, shots, shown, part)
    else:
        bpy.ops.wm.usd_export(filepath=str(part), export_animation=True, export_armatures=True, export_lights=True)
        hide_prims(part, [frame for _, frame in shots], shown)


def _show_all(scene: bpy.types.Scene, frames: list[int]) -> dict[str, list[bool]]:
    """Make every object permanently visible; return the visibility by shot of those that were hidden in some."""
    shown = {obj.name: [not is_hidden(obj, frame) for frame in frames] for obj in scene.objects}
    for obj in scene.objects:
        key_hidden(obj, [(scene.frame_start, True)])
    scene.frame_set(scene.frame_start)
    return {name: seen for name, seen in shown.items() if not all(seen)}


def _export_glb(scene: bpy.types.Scene, shots: list[tuple[str, int]], shown: dict[str, list[bool]], part: Path) -> None:
    """Export the scene as .glb; lamps that only burn in some shots are left out, as glTF cannot switch them."""
    ends = [frame for _, frame in shots[1:]] + [scene.frame_end + 1]
    spans = [(name, start, end - 1) for (name, start), end in zip(shots, ends, strict=True)]
    for obj in [obj for obj in scene.objects if obj.type == "LIGHT" and obj.name in shown]:
        bpy.data.objects.remove(obj)
    _switch_off_modifiers(scene)
    _split_actions(scene, spans)
    bpy.ops.export_scene.gltf(
        filepath=str(part),
        export_format="GLB",
        use_active_scene=True,
        export_cameras=True,
        export_lights=True,
        export_extras=True,
        export_animation_mode="NLA_TRACKS",
        export_force_sampling=False,
        export_anim_slide_to_zero=True,
        export_current_frame=True,  # without motion people stand where the scene begins
        export_optimize_animation_keep_anim_object=True,  # or people without motion in a shot would not be placed
    )
    hide_nodes(part, [(name, (last - first) / scene.render.fps) for name, first, last in spans], shown)


def _switch_off_modifiers(scene: bpy.types.Scene) -> None:
    """Switch off modifiers in the viewport, which glTF ignores but would evaluate at every frame."""
    for obj in scene.objects:
        for modifier in obj.modifiers:
            modifier.show_viewport = False


def _split_actions(scene: bpy.types.Scene, spans: list[tuple[str, int, int]]) -> None:
    """Split the actions of cameras and doors into one NLA strip per shot, as people's motion is.

    glTF gets an animation for each name of a track; a camera has one only in its own shot.
    """
    for obj in scene.objects:
        data = obj.animation_data
        if data is None or data.action is None or data.nla_tracks:
            continue
        if any(curve.data_path in _PLACED for curve in data.action.fcurves):
            action, slot = data.action, data.action_slot
            data.action = None
            for name, first, last in spans:
                if obj.type == "CAMERA" and obj.name != name:
                    continue
                track = data.nla_tracks.new()
                track.name = name
                strip = track.strips.new(name, first, action)
                strip.action_slot = slot
                strip.action_frame_start, strip.action_frame_end = first, last
                strip.frame_start, strip.frame_end = first, last
