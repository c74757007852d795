"""Appends from another .blend at a cost that does not grow with the open file.

Blender makes appended data-blocks local one at a time, each time going through everything in the open file: fifty
scenes take minutes. Blocks that are already linked are copied instead, which costs only the copy.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy


def append(path: Path, kind: str, names: Sequence[str] | None = None) -> list[bpy.types.ID]:
    """Append data-blocks, with everything they use, to the open file.

    Args:
        path: The .blend to take them from.
        kind: A collection of ``bpy.data``: ``scenes``, ``collections``.
        names: Names of the blocks; None for all of that kind.

    Returns:
        The local data-blocks, in the order of the names.
    """
    linked = _load(path, kind, names, link=True)
    local = _load(path, kind, names, link=False)
    bpy.data.batch_remove({block.library for block in linked})
    return local


def _load(path: Path, kind: str, names: Sequence[str] | None, *, link: bool) -> list[bpy.types.ID]:
    """Link or append data-blocks."""
    with bpy.data.libraries.load(str(path), link=link) as (source, target):
        setattr(target, kind, list(getattr(source, kind) if names is None else names))
    return [block for block in getattr(target, kind) if block is not None]
