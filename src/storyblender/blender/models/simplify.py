"""Takes faces away from a mesh that has more than a thing of its size can show."""

from __future__ import annotations

import bpy

from storyblender.blender.mesh_builder import SHARP_ANGLE

BUDGETS = ((0.3, 20_000), (3.0, 60_000), (float("inf"), 120_000))
"""Metres of the longest side up to which a thing has so many triangles at most."""
MOST_FACES = BUDGETS[-1][1]
"""Triangles of anything."""
THINNED_FACES = 3 * MOST_FACES
"""Triangles from which a surface is thinned out before it becomes a mesh."""


def face_budget(longest: float) -> int:
    """Return how many triangles a thing may have.

    Args:
        longest: Metres of its longest side.
    """
    return next(faces for side, faces in BUDGETS if longest <= side)


def simplified(mesh: bpy.types.Mesh, most: int) -> bpy.types.Mesh:
    """Return a mesh of at most so many triangles, which takes the place of one that has more.

    Edges are collapsed where the surface changes least; texture coordinates and materials stay.

    Args:
        mesh: Without users; it is removed if another takes its place.
        most: Triangles.
    """
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    if count <= most:
        return mesh
    obj = bpy.data.objects.new(mesh.name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    modifier = obj.modifiers.new("simplify", "DECIMATE")
    modifier.ratio, modifier.use_collapse_triangulate = most / count, True
    graph = bpy.context.evaluated_depsgraph_get()
    found = bpy.data.meshes.new_from_object(obj.evaluated_get(graph), depsgraph=graph)
    name = mesh.name
    bpy.data.objects.remove(obj)
    bpy.data.meshes.remove(mesh)
    found.name = name
    found.set_sharp_from_angle(angle=SHARP_ANGLE)
    return found
