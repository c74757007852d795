"""Makes a compiled scene pleasant to work in: readable names, rigs with controls, render settings."""

from __future__ import annotations

import re
from collections.abc import Collection

import bpy

from storyblender.blender.merge import IDENTITY, identity_of
from storyblender.blender.motion.control_keys import key_controls
from storyblender.blender.painting import PAINTED, plain_name
from storyblender.blender.people.control_rig import add_controls
from storyblender.blender.people.rig_display import show_controls
from storyblender.catalog.color_words import color_word
from storyblender.look.grade import AGX_CONTRAST

_COLORED = re.compile(r"_[0-9a-f]{6}(?=_|$)")
_COPY = re.compile(r"\.(\d{3,})$")
_PAINT = re.compile(r"(\w+) [\d.]+ [\d.]+ [\d.]+ \((painted|alpha [\d.e-]+)\)")
"""Names of people's materials in a pack: finish, colour and kind of colouring (``people.parts``)."""
_VERSION = """\
Made for Blender 4.5 LTS: open it with Blender 4.5 or newer.

Blender 4.2 LTS opens this file too, without a warning, but plays the wrong motion: people are animated with layered
actions, one slot a person, which came with Blender 4.4.
"""


def tidy(objects: Collection[bpy.types.Object]) -> None:
    """Give objects added last, their data and materials readable names, and controls to rigs."""
    for obj in objects:
        _name_object(obj)
    rigs = [obj for obj in objects if obj.type == "ARMATURE"]
    add_controls(rigs)
    key_controls(rigs)
    show_controls(rigs)
    for material in bpy.data.materials:
        if IDENTITY not in material:
            material[IDENTITY] = identity_of(material)
            material.name = _unused_name(readable_name(material), bpy.data.materials)


def readable_name(material: bpy.types.Material) -> str:
    """Return a readable name for a material of a pack: ``Cloth navy``, ``Wood dark``, ``Leather brown``."""
    name = identity_of(material)
    color = color_word(tuple(material.diffuse_color[:3]))
    paint = _PAINT.fullmatch(name)
    if paint is not None:
        return paint[1].capitalize() if paint[2] == "painted" else f"{paint[1].capitalize()} {color}"
    if PAINTED in material:
        return f"{_COLORED.sub('', plain_name(material)).replace('_', ' ').capitalize()} {color}"
    if not name.startswith("MT_"):
        return name
    plain = _COLORED.sub("", name.removeprefix("MT_")).replace("_", " ")
    return (plain[:1].upper() + plain[1:]) + (f" {color}" if _COLORED.search(name) else "")


def set_render_defaults(scene: bpy.types.Scene) -> None:
    """Set samples and denoising of both engines, and the board's colour management."""
    scene.render.engine = "BLENDER_EEVEE_NEXT"
    scene.eevee.taa_render_samples, scene.eevee.use_raytracing = 64, True
    scene.cycles.samples, scene.cycles.use_adaptive_sampling, scene.cycles.adaptive_threshold = 128, True, 0.02
    scene.cycles.use_denoising = True
    scene.cycles.max_bounces = 6
    scene.view_settings.view_transform, scene.view_settings.look = "AgX", AGX_CONTRAST


def write_version_note() -> None:
    """Add a text to the file that says which Blender it needs."""
    name = "READ ME"
    text = bpy.data.texts.get(name) or bpy.data.texts.new(name)
    text.from_string(_VERSION)
    text.use_fake_user = True


def show_on_opening(scene: bpy.types.Scene) -> None:
    """Show a scene through its camera in every 3D view; the scene of the cut has only strips, and its view is empty."""
    bpy.context.window.scene = scene
    for screen in bpy.data.screens:
        for area in screen.areas:
            for space in area.spaces:
                if isinstance(space, bpy.types.SpaceView3D):
                    space.region_3d.view_perspective = "CAMERA"
                    space.shading.type = "MATERIAL"


def _name_object(obj: bpy.types.Object) -> None:
    """Remove a copy's number from an object's name, and name its own data after it."""
    copy = _COPY.search(obj.name)
    if copy is not None:
        obj.name = _unused_name(obj.name[: copy.start()], bpy.data.objects, "_")
    data = obj.data
    if obj.type == "ARMATURE":
        data.name = obj.name
    elif obj.type == "MESH" and data.shape_keys is not None:
        data.name = data.shape_keys.name = obj.name
    elif obj.type == "MESH" and "digest" not in data and data.name not in bpy.data.objects:
        data.name = obj.name  # of the set; what several pieces share is called after the first


def _unused_name(name: str, taken: bpy.types.bpy_prop_collection, between: str = " ") -> str:
    """Return the name, with a number from 2 on if it is taken."""
    found, number = name, 1
    while found in taken:
        number += 1
        found = f"{name}{between}{number}"
    return found
