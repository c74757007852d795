"""Surfaces of a set that are made of pictures: their materials, and how the pictures lie on a floor."""

from __future__ import annotations

import re
from pathlib import PurePosixPath

import bpy

from storyblender.blender.materials import add_puddles
from storyblender.blender.models.tangents import TANGENTS, add_tangents
from storyblender.blender.sets.finish import finish
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.finishes import finish_of
from storyblender.folder import Folder
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.texture import Texture, TextureMap

TEXTURED = "texture"
"""Custom property of a material that is made of pictures: the digest of the surface."""
_ODD = re.compile(r"[^A-Za-z0-9 _-]+")


def load_textures(plan: SetPlan, files: Folder) -> None:
    """Bring the pictures of a set into the open file, each once.

    Args:
        plan: The set.
        files: The project folder.
    """
    for texture in plan.textures:
        for name in texture.maps:
            if bpy.data.images.get(_image_name(texture, name)) is None:
                data = files.path(texture.file(name)).read_bytes()
                image = bpy.data.images.new(_image_name(texture, name), 1, 1)
                image.pack(data=data, data_len=len(data))
                image.source = "FILE"
                image.colorspace_settings.name = "sRGB" if name == "color" else "Non-Color"


def skin_of(key: str, texture: Texture | None) -> bpy.types.Material:
    """Return the material of a surface: of its finish, or of pictures that ``load_textures`` brought.

    Args:
        key: Its finish, or a plain material key.
        texture: Its pictures.

    Raises:
        KeyError: There is no such finish, or the pictures were not brought.
    """
    if texture is None:
        return finish(key)
    entry = MATERIALS[finish_of(key).material]
    patchy, wet = entry.patchy, entry.wet
    told = content_hash(texture.provenance.digest, texture.metres, patchy, wet)
    name = f"TX_{_ODD.sub('', PurePosixPath(texture.provenance.file).stem)[:32]} {told[:8]}"
    return bpy.data.materials.get(name) or _make(name, texture, patchy, wet=wet)


def lies_across(texture: Texture | None, polygon: tuple[Vec2, ...]) -> bool:
    """Return whether the picture of a floor is turned by a quarter, so that boards run along its longer side."""
    if texture is None or texture.upright is None:
        return False
    width, depth = (max(each) - min(each) for each in zip(*polygon, strict=True))
    return texture.upright == (width >= depth)


def with_tangents(mesh: bpy.types.Mesh) -> bpy.types.Mesh:
    """Return a mesh of a set, with the tangents that a normal map of its materials needs."""
    mapped = any(block is not None and block.get("relief", False) for block in mesh.materials)
    if mapped and TANGENTS not in mesh.color_attributes:
        add_tangents(mesh)
    return mesh


def _image_name(texture: Texture, name: TextureMap) -> str:
    return f"TX_{texture.provenance.digest[:12]}_{name}"


def _make(name: str, texture: Texture, patchy: float, *, wet: bool) -> bpy.types.Material:
    block = bpy.data.materials.new(name)
    block.use_nodes = True
    tree = block.node_tree
    shader = tree.nodes["Principled BSDF"]
    sockets: dict[TextureMap, str] = {"color": "Base Color", "roughness": "Roughness"}
    for row, each in enumerate(texture.maps):
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image, node.location = bpy.data.images[_image_name(texture, each)], (-480, 240 - 280 * row)
        if each == "normal":
            bumps = tree.nodes.new("ShaderNodeNormalMap")
            bumps.location = (-160, node.location[1])
            tree.links.new(node.outputs["Color"], bumps.inputs["Color"])
            tree.links.new(bumps.outputs["Normal"], shader.inputs["Normal"])
        else:
            tree.links.new(node.outputs["Color"], shader.inputs[sockets[each]])
        if each == "color":
            tree.nodes.active = node  # Workbench and glTF take the active image
    shader.inputs["Base Color"].default_value = (*texture.color, 1)
    shader.inputs["Roughness"].default_value = texture.roughness
    if wet:
        add_puddles(tree, shader)
    block.diffuse_color, block.roughness = (*texture.color, 1), texture.roughness
    block["tile"], block["grain"], block["patchy"] = texture.metres, False, patchy
    block[TEXTURED], block["relief"] = texture.provenance.digest, "normal" in texture.maps
    return block
