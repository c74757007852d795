"""The shots of an open story.blend: markers and cameras in its scenes, and which project the file is of."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import bpy

VALUES = "storyblender.json"
"""The text block with what the file was compiled as."""
LTS, NEXT = (4, 5, 0), (5, 0, 0)
"""The version that files are compiled with, and the first that may save what it cannot read."""
_CUT = "EDIT"
"""The scene with a strip a shot."""


class ShotInFile(NamedTuple):
    """A shot that the file has."""

    name: str
    """Such as ``SC010_SH020``."""
    scene: bpy.types.Scene
    """That it is in."""
    frame: int | None
    """At which it begins; None where the file does not say."""


def project_of(path: str) -> Path | None:
    """Return the project folder of a .blend; None if it belongs to none.

    Args:
        path: Of the file: ``story.blend``, or that of a sequence in the folder ``story``.
    """
    folders = Path(path).parents[:2] if path else ()
    return next((folder for folder in folders if (folder / "graph.json").is_file()), None)


def shots() -> list[ShotInFile]:
    """Return the shots of the open file, scene by scene, in their time."""
    found: list[ShotInFile] = []
    for scene in sorted((each for each in bpy.data.scenes if "scene_id" in each), key=lambda scene: scene.name):
        marked = {marker.name: marker.frame for marker in scene.timeline_markers}
        cameras = [obj.name for obj in scene.objects if obj.type == "CAMERA" and obj.name.startswith(f"{scene.name}_")]
        found += [ShotInFile(name, scene, marked.get(name, _in_cut(name))) for name in sorted({*marked, *cameras})]
    return found


def go_to(window: bpy.types.Window, name: str) -> bool:
    """Show a shot: its scene, its first frame, its camera.

    Args:
        window: That shows it.
        name: Of the shot.

    Returns:
        Whether the file has it.
    """
    found = next((shot for shot in shots() if shot.name == name), None)
    if found is None:
        return False
    window.scene = found.scene
    if found.frame is not None:
        found.scene.frame_set(found.frame)
    camera = found.scene.objects.get(name)
    if camera is not None and found.scene.library is None:  # of a linked scene the marker says which camera
        found.scene.camera = camera
    return True


def warnings() -> list[str]:
    """Return what a person should know of this Blender and this file, one sentence each."""
    told: list[str] = []
    if bpy.app.version < LTS:
        told.append("This Blender is older than 4.5 LTS: people in this file move wrongly here.")
    if bpy.app.version >= NEXT:
        told.append("StoryBlender reads files back with Blender 4.5: what you save here may not be taken over.")
    elif bpy.data.version >= NEXT:
        told.append("This file was saved by a newer Blender: save it in 4.5 before you pull.")
    if VALUES not in bpy.data.texts and any("scene_id" in scene for scene in bpy.data.scenes):
        told.append("This file does not say what it was compiled as: what you change in it cannot be taken over.")
    return told


def _in_cut(name: str) -> int | None:
    """Return where a shot without a marker begins, which is another camera on the time of a shot: its strip knows."""
    cut = bpy.data.scenes.get(_CUT)
    strip = cut.sequence_editor.strips.get(name) if cut is not None and cut.sequence_editor is not None else None
    return int(strip.scene.frame_start + strip.frame_offset_start) if strip is not None else None
