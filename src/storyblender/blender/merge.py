"""Merges the duplicates that appending creates: one material, one image, one canonical mesh."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

import bpy

IDENTITY = "identity"
"""Custom property of a material that was renamed for people: its content, by which it is merged."""
_COPY = re.compile(r"\.\d{3,}$")

Copies = dict[bpy.types.ID, bpy.types.ID]


def merge_duplicates() -> None:
    """Point every user of a copy at the original and remove the copy.

    Images and materials are named by their content, so equal names mean equal content; meshes also carry the digest of
    their recipe. Meshes with shape keys stay, because their faces are animated.
    """
    images = _copies(bpy.data.images)
    for tree in _node_trees():
        for node in tree.nodes:
            if getattr(node, "image", None) in images:
                node.image = images[node.image]
    _remove(images)
    materials = _copies(bpy.data.materials)
    for mesh in bpy.data.meshes if materials else ():
        _replace_materials(mesh.materials, materials)
    _remove(materials)
    meshes = _copies([mesh for mesh in bpy.data.meshes if mesh.shape_keys is None], same=_same_digest)
    for obj in bpy.data.objects if meshes else ():
        if obj.data in meshes:
            obj.data = meshes[obj.data]
    _remove(meshes)


def identity_of(block: bpy.types.ID) -> str:
    """Return the content of a data-block as text; equal identities mean equal content."""
    return str(block.get(IDENTITY, "")) or _COPY.sub("", block.name)


def _copies(
    blocks: Iterable[bpy.types.ID], same: Callable[[bpy.types.ID, bpy.types.ID], bool] = lambda copy, original: True
) -> Copies:
    """Return every copy with its original: the block renamed for people, else the one without a number."""
    every = list(blocks)
    originals = {block.name: block for block in every if not _COPY.search(block.name) and IDENTITY not in block}
    originals |= {str(block[IDENTITY]): block for block in every if IDENTITY in block}
    pairs = ((block, originals.get(identity_of(block))) for block in every)
    return {copy: original for copy, original in pairs if original not in (None, copy) and same(copy, original)}


def _same_digest(copy: bpy.types.ID, original: bpy.types.ID) -> bool:
    """Return whether two meshes have the same recipe."""
    return copy.get("digest") is not None and copy.get("digest") == original.get("digest")


def _node_trees() -> list[bpy.types.NodeTree]:
    """Return the node trees of the file."""
    users = (*bpy.data.materials, *bpy.data.worlds, *bpy.data.lights)
    return [user.node_tree for user in users if user.node_tree is not None]


def _replace_materials(slots: bpy.types.IDMaterials, copies: Copies) -> None:
    """Replace copies in material slots by their originals."""
    for index, material in enumerate(slots):
        if material in copies:
            slots[index] = copies[material]


def _remove(copies: Copies) -> None:
    """Remove unused copies in one batch, because each removal goes through the whole file."""
    unused = [copy for copy in copies if copy.users == int(copy.use_fake_user)]
    if unused:
        bpy.data.batch_remove(unused)
