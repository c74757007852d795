"""Builds a Blender mesh with materials of our own from a plain model: nothing else of a user's file comes along."""

from __future__ import annotations

import hashlib
import re

import bpy
import numpy as np

from storyblender.blender.mesh_builder import SHARP_ANGLE
from storyblender.blender.models.palette import palette_of
from storyblender.blender.models.pictures import flat_picture, mean_level, tinted
from storyblender.blender.models.plain import MAPS, PlainMaterial, PlainModel
from storyblender.errors import InputError
from storyblender.memory.base import Color, content_hash

_PLAIN = PlainMaterial(name="plain", color=(0.6, 0.6, 0.6))
"""Of faces that have no material."""
_ODD = re.compile(r"[^\w -]+")


def build_mesh(model: PlainModel, name: str) -> bpy.types.Mesh:
    """Return a new mesh of a model, in the model's frame and unit.

    Args:
        model: The surface with its materials.
        name: Of the mesh data-block.

    Raises:
        InputError: No face of it is whole.
    """
    vertices, corners = _welded(model)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(vertices))
    mesh.loops.add(len(corners))
    mesh.polygons.add(len(model.sizes))
    mesh.vertices.foreach_set("co", vertices.ravel())
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.foreach_set("loop_start", (np.cumsum(model.sizes) - model.sizes).astype(np.int32))
    mesh.polygons.foreach_set("loop_total", model.sizes)
    materials, slots, layout = _looks(model)
    mesh.polygons.foreach_set("material_index", slots)
    mesh.polygons.foreach_set("use_smooth", model.smooth)
    if len(layout):
        mesh.uv_layers.new(name="UVMap").uv.foreach_set("vector", layout.astype(np.float32).ravel())
    for material in materials:
        mesh.materials.append(_material(material))
    mesh.validate()
    mesh.update(calc_edges=True)
    if not len(mesh.polygons):
        bpy.data.meshes.remove(mesh)
        raise InputError("no face of its surface is whole")
    mesh.set_sharp_from_angle(angle=SHARP_ANGLE)
    return mesh


def _welded(model: PlainModel) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices, one for each place, and the corners: exporters part them at every seam."""
    keys = np.ascontiguousarray(model.vertices + np.float32(0.0)).view([("", np.float32)] * 3).ravel()
    _, first, where = np.unique(keys, return_index=True, return_inverse=True)
    order = np.argsort(np.argsort(first))
    return model.vertices[np.sort(first)], order[where][model.corners].astype(np.int32)


def _looks(model: PlainModel) -> tuple[list[PlainMaterial], np.ndarray, np.ndarray]:
    """Return the materials, the material of each face and the texture coordinates of each corner.

    Faces with vertex colours and no picture get a palette of their colours for a picture, so that every renderer and
    every other program shows them.
    """
    materials = [*model.materials, _PLAIN]
    slots = np.where(model.slots < 0, len(materials) - 1, model.slots).astype(np.int32)
    layout = np.zeros((len(model.corners), 2), np.float32)
    face_of = np.repeat(np.arange(len(model.sizes)), model.sizes)
    for number, material in enumerate(materials):
        layer = min(material.layer, len(model.layers) - 1)
        if material.is_mapped and layer >= 0:
            chosen = slots[face_of] == number
            layout[chosen] = _laid(model.layers[layer][chosen], material)
    if len(model.paint):
        pictured = np.array([material.is_mapped for material in materials])
        for number in np.unique(slots[~pictured[slots]]).tolist():
            faces = np.flatnonzero(slots == number)
            paint = model.paint * np.array(materials[number].color, np.float32)
            picture, places = palette_of(paint, model.sizes, faces)
            materials.append(_painted(materials[number], picture))
            slots[faces] = len(materials) - 1
            layout[np.isin(face_of, faces)] = np.repeat(places, model.sizes[faces], axis=0)
    used = np.unique(slots)
    plain = not any(materials[index].is_mapped for index in used)
    return (
        [materials[index] for index in used],
        np.searchsorted(used, slots).astype(np.int32),
        np.zeros((0, 2), np.float32) if plain else layout,
    )


def _painted(material: PlainMaterial, picture: bytes) -> PlainMaterial:
    return PlainMaterial(
        name=material.name or "painted", alpha=material.alpha, roughness=material.roughness,
        metallic=material.metallic, emission=material.emission, picture=picture, color=(1.0, 1.0, 1.0),
    )  # fmt: skip


def _laid(layer: np.ndarray, material: PlainMaterial) -> np.ndarray:
    """Return texture coordinates moved as the material moves its picture (glTF turns about the upper left corner)."""
    if (material.offset, material.repeat, material.turn) == ((0.0, 0.0), (1.0, 1.0), 0.0):
        return layer
    u, v = layer[:, 0] * material.repeat[0], (1 - layer[:, 1]) * material.repeat[1]
    cosine, sine = np.cos(material.turn), np.sin(material.turn)
    return np.stack([cosine * u + sine * v + material.offset[0], 1 - (cosine * v - sine * u + material.offset[1])], 1)


def _material(plain: PlainMaterial) -> bpy.types.Material:
    """Return the material of this content, made if the open file does not have it.

    Its name ends in a digest of all that it is, so two files' materials of one name stay two.
    """
    values: dict[str, object] = {key: str(value) for key, value in vars(plain).items() if key not in (*MAPS, "name")}
    maps: dict[str, object] = {name: hashlib.sha256(getattr(plain, name)).hexdigest() for name in MAPS}
    digest = content_hash(maps, values)
    speaking = _ODD.sub("", plain.name).strip()[:32] or "material"
    name = f"{speaking} {digest[:8]}"
    found = next((each for each in bpy.data.materials if each.name == name and each.get("digest") == digest), None)
    return found or _make(name, digest, plain)


def _make(name: str, digest: str, plain: PlainMaterial) -> bpy.types.Material:
    block = bpy.data.materials.new(name)
    block.use_nodes = True
    tree = block.node_tree
    shader = tree.nodes["Principled BSDF"]
    mean = plain.color
    _link_maps(tree, shader, plain)
    if plain.is_mapped:  # Workbench and glTF take the active image, which must not be another map
        picture = plain.picture or flat_picture((1.0, 1.0, 1.0))
        texture = _texture(tree, picture if min(plain.color) > 0.99 else tinted(picture, plain.color), 240)
        mean = _mean_color(texture.image)
        tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
        tree.nodes.active = texture
    shader.inputs["Base Color"].default_value = (*mean, 1)
    roughness = mean_level(plain.roughness_map) if plain.roughness_map else plain.roughness
    metallic = mean_level(plain.metallic_map) if plain.metallic_map else plain.metallic
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    shader.inputs["Alpha"].default_value = plain.alpha
    if max(plain.emission) > 0:
        strength = max(plain.emission)
        shader.inputs["Emission Strength"].default_value = strength
        shader.inputs["Emission Color"].default_value = (*(channel / strength for channel in plain.emission), 1)
    block.diffuse_color = (*mean, 1)
    block.roughness, block.metallic = roughness, 0.3 * metallic  # Workbench blackens full metal
    block["digest"] = digest
    return block


def _link_maps(tree: bpy.types.NodeTree, shader: bpy.types.Node, plain: PlainMaterial) -> None:
    """Add the maps that renderers read beside the base colour."""
    for name, data, height in (("Roughness", plain.roughness_map, -40), ("Metallic", plain.metallic_map, -320)):
        if data:
            tree.links.new(_texture(tree, data, height, "Non-Color").outputs["Color"], shader.inputs[name])
    if plain.normal_map:
        bumps = tree.nodes.new("ShaderNodeNormalMap")
        bumps.location, bumps.inputs["Strength"].default_value = (-160, -600), plain.relief
        texture = _texture(tree, plain.normal_map, -600, "Non-Color")
        tree.links.new(texture.outputs["Color"], bumps.inputs["Color"])
        tree.links.new(bumps.outputs["Normal"], shader.inputs["Normal"])
    if plain.glow_map:
        glow = _texture(tree, tinted(plain.glow_map, _tint(plain.emission)), -880)
        tree.links.new(glow.outputs["Color"], shader.inputs["Emission Color"])


def _tint(emission: Color) -> Color:
    red, green, blue = (channel / max(*emission, 1e-6) for channel in emission)
    return red, green, blue


def _texture(tree: bpy.types.NodeTree, data: bytes, height: float, space: str = "sRGB") -> bpy.types.Node:
    """Return a new node with a picture.

    Args:
        tree: Of a material.
        data: The picture.
        height: Where the node stands.
        space: Colour space of the picture.
    """
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image = _image(data, space)
    texture.location = (-480, height)
    texture.interpolation = "Closest" if space == "sRGB" and texture.image.size[0] <= 256 else "Linear"
    return texture


def _image(data: bytes, space: str) -> bpy.types.Image:
    """Return the packed image of a picture, found again by its content."""
    digest = hashlib.sha256(data).hexdigest()[:12]
    name = f"TX_{digest}" if space == "sRGB" else f"TX_{digest}_data"
    block = bpy.data.images.get(name)
    if block is None:
        block = bpy.data.images.new(name, 1, 1)
        block.pack(data=data, data_len=len(data))
        block.source = "FILE"
        block["digest"] = digest
        block.colorspace_settings.name = space
    return block


def _mean_color(block: bpy.types.Image) -> Color:
    """Return the mean scene-linear colour of a picture in sRGB."""
    width, height = block.size
    pixels = np.empty(width * height * 4, np.float32)
    block.pixels.foreach_get(pixels)
    red, green, blue = (float(value) for value in pixels.reshape(-1, 4)[:, :3].mean(axis=0) ** 2.2)
    return red, green, blue
