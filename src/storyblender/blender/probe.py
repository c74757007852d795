"""``python -m storyblender.blender.probe [PICTURE]``: imports Blender and draws, for ``storyblender doctor``.

It is a process of its own, because bpy cannot be imported without system libraries, and Blender aborts without EGL.
"""

from __future__ import annotations

import os
import sys

import bpy


def draw(path: str) -> None:
    """Draw an empty scene with Workbench, 16 pixels square, to a file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(scene.camera)
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.render.resolution_x = scene.render.resolution_y = 16
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def main() -> None:
    """Draw the picture named on the command line, if one is, and print Blender's version."""
    if len(sys.argv) > 1:
        draw(sys.argv[1])
    print(bpy.app.version_string, flush=True)
    os._exit(0)


if __name__ == "__main__":
    main()
