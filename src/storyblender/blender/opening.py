"""The view of a story's file when an artist opens it: the first shot, through its camera."""

from __future__ import annotations

import bpy


def show_on_opening(scene: bpy.types.Scene) -> None:
    """Show a scene through its camera in every 3D view; the scene of the cut has only strips, and its view is empty."""
    bpy.context.window.scene = scene
    for screen in bpy.data.screens:
        for area in screen.areas:
            for space in area.spaces:
                if isinstance(space, bpy.types.SpaceView3D):
                    space.region_3d.view_perspective = "CAMERA"
                    space.shading.type = "MATERIAL"
