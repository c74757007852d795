"""Appending from another .blend at a cost that does not grow with the open file.

Blender makes what it appends local one data-block at a time, and for each goes through everything in the open
file: fifty scenes take minutes. What is linked already it copies instead, which costs only the copy.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy


def append(path: Path, kind: str, names: Sequence[str] | None = None) -> list[bpy.types.ID]:
    """Append data-blocks, with all that they use, to the open file.

    Args:
        path: The .blend to take them from.
        kind: Which collection of ``bpy.data``: ``scenes``, ``collections``.
        names: Which ones; all of that kind where none are given.

    Returns:
        The local data-blocks, in the order of the names.
    """
    linked = _load(path, kind, names, link=True)
    local = _load(path, kind, names, link=False)
    bpy.data.batch_remove({block.library for block in linked})
    return local


def _load(path: Path, kind: str, names: Sequence[str] | None, *, link: bool) -> list[bpy.types.ID]:
    with bpy.data.libraries.load(str(path), link=link) as (source, target):
        setattr(target, kind, list(getattr(source, kind) if names is None else names))
    return [block for block in getattr(target, kind) if block is not None]
