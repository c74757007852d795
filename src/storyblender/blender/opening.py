"""How the story's file looks when an artist opens it: the first shot, through its camera, in its colours."""

from __future__ import annotations

import bpy


def open_on(scene: bpy.types.Scene) -> None:
    """Show a scene through its camera in every 3D view of the file.

    Args:
        scene: What is seen first; the scene of the cut itself holds strips only, and its 3D view is empty.
    """
    bpy.context.window.scene = scene
    for screen in bpy.data.screens:
        for area in screen.areas:
            for space in area.spaces:
                if isinstance(space, bpy.types.SpaceView3D):
                    space.region_3d.view_perspective = "CAMERA"
                    space.shading.type = "MATERIAL"
