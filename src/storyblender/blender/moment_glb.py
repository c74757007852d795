"""One moment of a packed scene as glTF, for a viewer: people posed, no rigs, lamps, cameras or motion."""

from __future__ import annotations

from pathlib import Path

import bpy

from storyblender.blender.still import held_still


def write_moment(scene: bpy.types.Scene, frame: int, part: Path) -> None:
    """Write what a scene looks like at one frame; every node carries the ``node_id`` and ``kind`` it came from.

    Args:
        scene: The packed scene.
        frame: On the scene's timeline.
        part: The .glb to write.
    """
    with held_still(scene, frame) as still:
        export_still(still, part)


def export_still(still: bpy.types.Scene, part: Path) -> None:
    """Write a scene of plain meshes as glTF; it is the window's scene then.

    Args:
        still: As ``held_still`` yields it.
        part: The .glb to write.
    """
    bpy.context.window.scene = still
    for obj in still.objects:
        obj.update_tag()  # the exporter reads places that Blender works out only for the window's scene
    bpy.context.view_layer.update()
    bpy.ops.export_scene.gltf(
        filepath=str(part),
        export_format="GLB",
        use_active_scene=True,
        export_extras=True,
        export_animations=False,
        export_skins=False,
        export_morph=False,
        export_tangents=False,
        export_image_format="JPEG",
        export_jpeg_quality=80,
    )
