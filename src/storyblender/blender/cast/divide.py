"""Divides the long edges of a coarse figure, so that it can bend where its joints are."""

from __future__ import annotations

import bmesh
import bpy
import numpy as np

LONGEST = 0.04
"""Longest edge of a figure that bends, as a share of its height: a cylinder has vertices at its ends only."""
ENOUGH = 20_000
"""Triangles from which a figure is left as it is."""
ROUNDS = 6
"""How often edges are halved at most."""


def divide_long_edges(mesh: bpy.types.Mesh) -> None:
    """Halve the edges of a mesh, in place, until none is long; its shape, materials and texture coordinates stay.

    Args:
        mesh: Of a whole figure, in any unit.
    """
    surface = bmesh.new()
    surface.from_mesh(mesh)
    places = np.array([vertex.co for vertex in surface.verts])
    longest = LONGEST * float(np.ptp(places, axis=0).max())
    for _ in range(ROUNDS):
        long = [edge for edge in surface.edges if edge.calc_length() > longest]
        if not long or sum(len(face.verts) - 2 for face in surface.faces) > ENOUGH:
            break
        bmesh.ops.subdivide_edges(surface, edges=long, cuts=1, use_grid_fill=True)
    surface.to_mesh(mesh)
    surface.free()
