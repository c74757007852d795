"""What a person decided about materials, laid over the objects of a scene.

A painted material is a copy with a name of its own, which tells its content, and the custom property ``painted`` with
the name of the material that it was made from.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Literal

import bpy
import numpy as np

from storyblender.blender.materials import material as made_of
from storyblender.blender.merge import identity_of
from storyblender.blender.textures import image
from storyblender.look.patterns import Floats
from storyblender.look.raster import LUMA
from storyblender.memory.base import Color, content_hash
from storyblender.memory.paint import Paint, PaintDecision

PAINTED = "painted"
"""Custom property of a painted material: the name of the one that it was made from."""
POINT_COLORS = "Color"
"""Colour attribute of people's meshes, on the corners of their faces."""
_Slots = dict[int, PaintDecision]


def paint_objects(objects: Iterable[bpy.types.Object], paints: Sequence[Paint], scene_id: int | None = None) -> None:
    """Paint the materials of objects as a person decided; of several paints of one surface the narrowest counts.

    Args:
        objects: Tagged with their ids.
        paints: Of the story.
        scene_id: Of the scene that they are in; None where they are the canonical assets.
    """
    ordered = sorted(paints, key=lambda paint: -paint.target.narrowness)
    ordered = [paint for paint in ordered if paint.target.scene_id in (None, scene_id)]
    if not ordered:
        return
    meshes = [obj for obj in objects if obj.type == "MESH" and obj.data.materials]
    mains = _main_materials(meshes)
    wanted = {obj: _painted_slots(obj, ordered, mains.get(str(obj.get("asset_id", "")), "")) for obj in meshes}
    for obj, slots in wanted.items():
        alike = [other for other in meshes if other.data == obj.data and wanted[other] == slots]
        if slots and len(alike) < obj.data.users - obj.data.use_fake_user:  # only some of those that share a mesh
            obj.data = obj.data.copy()
    done = set[bpy.types.Mesh]()
    for obj, slots in wanted.items():
        if slots and obj.data not in done:
            done.add(obj.data)
            _paint(obj.data, slots)


def _painted_slots(obj: bpy.types.Object, ordered: Sequence[Paint], main: str) -> _Slots:
    """Return the decision of each slot of an object that is painted."""
    asset_id, node_id = str(obj.get("asset_id", "")), str(obj.get("node_id", ""))
    slots = _Slots()
    for index, block in enumerate(obj.data.materials):
        if block is None or not can_be_painted(block):
            continue
        name = plain_name(block)
        for paint in ordered:
            target = paint.target
            meant = target.material == name or (target.material is None and (name == main or not main))
            if meant and target.asset_id in (None, asset_id) and target.node_id in (None, node_id):
                slots[index] = paint.look
                break
    return slots


def plain_name(block: bpy.types.Material) -> str:
    """Return what a material is called in edits: as it was before it was painted, without the catalogue's mark."""
    return str(block.get(PAINTED, "") or identity_of(block)).removeprefix("MT_")


def can_be_painted(block: bpy.types.Material) -> bool:
    """Return whether a material has a colour of its own: not that of the daylight, nor that of each point of a skin."""
    return "follows" not in block and base_of(block) != "other"


def base_of(block: bpy.types.Material) -> Literal["plain", "picture", "other"]:
    """Return where a material's colour comes from: ``plain``, a ``picture``, or something ``other``."""
    shader = shader_of(block)
    if shader is None or not shader.inputs["Base Color"].is_linked:
        return "plain"
    return "picture" if _picture_of(shader) is not None else "other"


def shader_of(block: bpy.types.Material) -> bpy.types.Node | None:
    """Return the shader of a material; None for one without nodes."""
    nodes = block.node_tree.nodes if block.use_nodes and block.node_tree is not None else ()
    return next((node for node in nodes if node.type == "BSDF_PRINCIPLED"), None)


def _picture_of(shader: bpy.types.Node) -> bpy.types.Node | None:
    links = shader.inputs["Base Color"].links
    node = links[0].from_node if links else None
    return node if node is not None and node.type == "TEX_IMAGE" and node.image is not None else None


def _main_materials(meshes: Collection[bpy.types.Object]) -> dict[str, str]:
    """Return the material that covers most of each asset, by its id."""
    areas: dict[str, dict[str, float]] = {}
    seen = set[tuple[str, bpy.types.Mesh]]()
    for obj in meshes:
        asset_id = str(obj.get("asset_id", ""))
        if not asset_id or (asset_id, obj.data) in seen:
            continue
        seen.add((asset_id, obj.data))
        area, slot = np.empty(len(obj.data.polygons), np.float32), np.empty(len(obj.data.polygons), np.int32)
        obj.data.polygons.foreach_get("area", area)
        obj.data.polygons.foreach_get("material_index", slot)
        for index, block in enumerate(obj.data.materials):
            if block is not None:
                own = areas.setdefault(asset_id, {})
                own[plain_name(block)] = own.get(plain_name(block), 0.0) + float(area[slot == index].sum())
    return {asset_id: max(own, key=lambda name: (own[name], name)) for asset_id, own in areas.items()}


def _paint(mesh: bpy.types.Mesh, slots: _Slots) -> None:
    for index, look in slots.items():
        mesh.materials[index] = painted(mesh.materials[index], look)
        if look.color is not None and POINT_COLORS in mesh.color_attributes:
            _color_points(mesh, index, look.color)
    if "digest" in mesh:  # what is painted otherwise is another mesh, and is not merged with it
        told = {str(index): look.model_dump(mode="json") for index, look in slots.items()}
        mesh["digest"] = content_hash(str(mesh["digest"]), dict[str, object](told))


def _color_points(mesh: bpy.types.Mesh, slot: int, color: Color) -> None:
    """Give the corners of a slot's faces a colour: the drawn looks take that of people's clothes from there."""
    slots, sizes = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("material_index", slots)
    mesh.polygons.foreach_get("loop_total", sizes)
    attribute = mesh.color_attributes[POINT_COLORS]
    colors = np.empty(len(mesh.loops) * 4, np.float32)
    attribute.data.foreach_get("color", colors)
    colors.reshape(-1, 4)[np.repeat(slots == slot, sizes), :3] = color
    attribute.data.foreach_set("color", colors)


def painted(block: bpy.types.Material, look: PaintDecision) -> bpy.types.Material:
    """Return a material as it looks painted, created on first use.

    Args:
        block: As it was made.
        look: What was decided about it.
    """
    name = plain_name(block)
    called = f"{name[:40]} {content_hash(name, look)[:8]}"
    known = bpy.data.materials.get(called)
    if known is not None:
        return known
    copy = (block if look.finish is None else made_of(look.finish)).copy()
    copy.name, copy[PAINTED] = called, name
    shader = shader_of(copy)
    if look.plain and shader is not None and (picture := _picture_of(shader)) is not None:
        copy.node_tree.nodes.remove(picture)
    if look.color is not None:
        _color(copy, shader, look.color)
    for value, field, socket, shown in (
        (look.roughness, "roughness", "Roughness", 1.0),
        (look.metallic, "metallic", "Metallic", 0.3),  # Workbench blackens full metal
    ):
        if value is not None:
            setattr(copy, field, shown * value)
            if shader is not None and not shader.inputs[socket].is_linked:
                shader.inputs[socket].default_value = value
    return copy


def _color(block: bpy.types.Material, shader: bpy.types.Node | None, color: Color) -> None:
    """Give a material a colour, and its picture if it has one."""
    block.diffuse_color = (*color, block.diffuse_color[3])
    if shader is None:
        return
    shader.inputs["Base Color"].default_value = (*color, 1.0)
    if shader.inputs["Emission Strength"].default_value > 0:
        shader.inputs["Emission Color"].default_value = (*color, 1.0)
    texture = _picture_of(shader)
    if texture is not None:
        texture.image = image(f"TX_{block.name}", _tinted(_pixels(texture.image), color))


def _pixels(picture: bpy.types.Image) -> Floats:
    """Return a picture, (h, w, 3), scene-linear, bottom row first."""
    width, height = picture.size
    pixels = np.empty(width * height * 4, np.float32)
    picture.pixels.foreach_get(pixels)
    shown = pixels.reshape(height, width, 4)[..., :3].astype(float)
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def _tinted(picture: Floats, color: Color) -> Floats:
    """Return a picture in another colour: lighter and darker where it was."""
    light = picture @ LUMA.astype(float)
    share = light / max(float(light.mean()), 1e-4)
    return np.clip(share[..., None] * np.array(color), 0.0, 1.0)
