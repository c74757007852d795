"""One asset as glTF, for a viewer: metres, on its feet at the origin, its front to the viewer."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy

from storyblender.blender.moment_glb import export_still
from storyblender.blender.still import held_still


def write_asset(parts: Sequence[bpy.types.Object], part: Path) -> None:
    """Write the mesh objects of one thing or person as they stand.

    Args:
        parts: About one origin; rigs that bend them need not be in a scene.
        part: The .glb to write.
    """
    scene = bpy.context.window.scene
    for obj in parts:
        scene.collection.objects.link(obj)
    with held_still(scene) as still:
        export_still(still, part)
