"""Merging what appending duplicates: one material, one image, one canonical mesh, however many files it came from."""

from __future__ import annotations

import re
from collections.abc import Iterable

import bpy

_COPY = re.compile(r"\.\d{3,}$")


def merge_duplicates() -> None:
    """Point every user of a numbered copy at the original and remove the copy.

    Images and materials are named by what they are made of, so equal names mean equal content; meshes and
    armatures also carry the digest of their recipe. A mesh with shape keys stays single: its face is animated.
    """
    for block in (bpy.data.images, bpy.data.node_groups, bpy.data.materials):
        _merge(block, same=lambda copy, original: True)
    meshes = [mesh for mesh in bpy.data.meshes if mesh.shape_keys is None]
    _merge(bpy.data.meshes, same=_same_digest, among=meshes)


def _merge(block, same, among: Iterable[bpy.types.ID] | None = None) -> None:
    for copy in sorted(block if among is None else among, key=lambda item: item.name):
        base = _COPY.sub("", copy.name)
        original = block.get(base)
        if base == copy.name or original is None or original == copy or not same(copy, original):
            continue
        copy.user_remap(original)
        if copy.users == 0 or (copy.users == 1 and copy.use_fake_user):
            block.remove(copy)


def _same_digest(copy: bpy.types.ID, original: bpy.types.ID) -> bool:
    return copy.get("digest") is not None and copy.get("digest") == original.get("digest")
