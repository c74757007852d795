"""Exchange formats of one scene: glTF and USD, with the people's motion."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import bpy

from storyblender.errors import EngineError


def export_scene(story: Path, scene_name: str, kind: Literal["glb", "usd"], out: Path) -> None:
    """Write one scene of the story's file.

    Args:
        story: The compiled .blend, opened with scripts disabled.
        scene_name: For example ``SC010``.
        kind: ``glb`` or ``usd``.
        out: The file to write.

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
        bpy.ops.export_scene.gltf(
            filepath=str(out),
            export_format="GLB",
            use_active_scene=True,
            export_cameras=True,
            export_lights=True,
            export_extras=True,
            export_animation_mode="NLA_TRACKS",
            export_force_sampling=False,
        )
    else:
        bpy.ops.wm.usd_export(filepath=str(out), export_animation=True, export_armatures=True, export_lights=True)


def _lighten(scene: bpy.types.Scene) -> None:
    """Switch off what shapes meshes in the view: glTF takes them as they are, but each frame would reckon them anew."""
    for obj in scene.objects:
        for modifier in obj.modifiers:
            modifier.show_viewport = False
