"""Materials of the catalog as Blender materials: one per key and colour, shared by all renderers."""

from __future__ import annotations

import bpy

from storyblender.blender.textures import image, paint
from storyblender.catalog.materials import MATERIALS, MaterialEntry
from storyblender.memory.base import Color

_SOOT = 0.02
"""Share of its colour that a flame reflects."""


def material(key: str, color: Color | None = None) -> bpy.types.Material:
    """Return the material of the open file for a catalog key, created on first use.

    It carries the custom properties ``key``, ``tile`` (metres of one picture), ``emit`` (emission strength) and
    ``grain`` (whether boards turn the picture to their length).

    Args:
        key: A key of ``catalog.materials``.
        color: Scene-linear colour instead of the entry's own.

    Raises:
        KeyError: The catalog has no such material.
    """
    entry = MATERIALS[key]
    name = f"MT_{key}" if color is None else f"MT_{key}_{_code(color)}"
    return bpy.data.materials.get(name) or _make(name, entry, color or entry.color)


def _code(color: Color) -> str:
    """Return the hex digits of a colour."""
    return "".join(f"{round(255 * min(max(channel, 0.0), 1.0)):02x}" for channel in color)


def _make(name: str, entry: MaterialEntry, color: Color) -> bpy.types.Material:
    """Create a material with its nodes."""
    block = bpy.data.materials.new(name)
    block.use_nodes = True
    tree = block.node_tree
    shader = tree.nodes["Principled BSDF"]
    mean = color
    texture = None
    if entry.pattern:
        picture = paint(entry, color)
        mean = tuple(float(channel) for channel in picture.mean(axis=(0, 1)))
        texture = tree.nodes.new("ShaderNodeTexImage")
        texture.image = image(name.replace("MT_", "TX_", 1), picture)
        texture.location = (-320, 240)
        tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
        tree.nodes.active = texture  # Workbench and glTF take the active image
    body = tuple(_SOOT * channel for channel in mean) if entry.gas else mean
    shader.inputs["Base Color"].default_value = (*body, 1)
    shader.inputs["Roughness"].default_value = entry.roughness
    shader.inputs["Metallic"].default_value = entry.metallic
    if entry.emission:
        shader.inputs["Emission Strength"].default_value = entry.emission
        shader.inputs["Emission Color"].default_value = (*mean, 1)
        if texture is not None:
            tree.links.new(texture.outputs["Color"], shader.inputs["Emission Color"])
    if entry.wet:
        add_puddles(tree, shader)
    block.diffuse_color = (*mean, 1)
    block.roughness, block.metallic = entry.roughness, 0.3 * entry.metallic  # Workbench blackens full metal
    block["key"], block["tile"], block["emit"], block["grain"] = entry.key, entry.tile, entry.emission, entry.grain
    return block


def add_puddles(tree: bpy.types.NodeTree, shader: bpy.types.Node) -> None:
    """Vary roughness with low noise over the world, so that water lies in patches (notes: sets and light, 1.8).

    Args:
        tree: Of the material.
        shader: Its shader.
    """
    place = tree.nodes.new("ShaderNodeNewGeometry")
    noise = tree.nodes.new("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value, noise.inputs["Detail"].default_value = 0.55, 3
    spread = tree.nodes.new("ShaderNodeMapRange")
    for socket, value in (("From Min", 0.42), ("From Max", 0.58), ("To Min", 0.06), ("To Max", 0.38)):
        spread.inputs[socket].default_value = value
    tree.links.new(place.outputs["Position"], noise.inputs["Vector"])
    tree.links.new(noise.outputs[0], spread.inputs["Value"])
    tree.links.new(spread.outputs[0], shader.inputs["Roughness"])
    shader.inputs["Specular IOR Level"].default_value = 0.8
