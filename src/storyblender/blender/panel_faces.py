"""Wild panels of a mesh, which a shot may take away: a number on each face, and the panels' names on the mesh."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np

PANEL, PANELS = "panel", "panels"
"""Face attribute with the number of a wild panel, from 1 on; property of the mesh with the panels' names."""


def mark_panels(mesh: bpy.types.Mesh, parts: Sequence[tuple[str, int]]) -> None:
    """Write the panel of each face as a number, 0 for none, and the names of the panels beside them.

    Args:
        mesh: Without panels, it stays as it is.
        parts: Name of the panel, empty for none, and number of faces, in the order of the faces.
    """
    names = sorted({panel for panel, _ in parts} - {""})
    if not names:
        return
    numbers = [names.index(panel) + 1 if panel else 0 for panel, _ in parts]
    each = np.repeat(numbers, [faces for _, faces in parts]).astype(np.int32)
    mesh.attributes.new(PANEL, "INT", "FACE").data.foreach_set("value", each)
    mesh[PANELS] = " ".join(names)
