"""Lamps and sky of a light plan as Blender lights and world: for good, or for the length of one render."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

import bpy
from mathutils import Vector

from storyblender.blender.render.session import changed
from storyblender.look.illumination import SKY_STOPS, direction_of, sky_colors
from storyblender.memory.panorama import PanoramaLight
from storyblender.memory.scene_context import Light, Sky

PANORAMA = "panorama"
"""Leads the names of the nodes of a panorama in a world: ``panorama`` its strength, ``panorama_turn``, ``_share``."""
FACE_ROLES = frozenset({"key", "fill", "rim"})
"""Lamps of one shot, set for its faces; only people cast shadows from them, so no wall can take a face's light."""


def make_lamp(light: Light, name: str) -> bpy.types.Object:
    """Return a light object, linked to no collection, with the plan's power, colour, size and direction.

    Args:
        light: The lamp in the plan; world, metres.
        name: Of the object and its data-block.
    """
    data = bpy.data.lights.new(name, light.kind)
    data.color, data.energy = light.color, light.power
    if light.kind == "AREA":
        data.shape, data.size = "DISK", light.size
    elif light.kind == "SUN":
        data.angle = math.radians(light.size)
    else:
        data.shadow_soft_size = light.size
    if light.kind == "SPOT":
        data.spot_size, data.spot_blend = math.radians(light.cone), light.blend
    lamp = bpy.data.objects.new(name, data)
    lamp.location = light.location
    lamp.rotation_mode = "QUATERNION"
    lamp.rotation_quaternion = Vector(direction_of(light)).to_track_quat("-Z", "Y")
    lamp.visible_camera = False
    lamp.visible_glossy = light.kind not in ("AREA", "SUN") and light.role not in FACE_ROLES
    return lamp


def make_world(sky: Sky, name: str) -> bpy.types.World:
    """Return a world of the sky's colours over the sine of elevation: the same dome that the compositor draws.

    Args:
        sky: Scene-linear colours.
        name: Of the world data-block.
    """
    world = bpy.data.worlds.new(name)
    world.use_nodes = True
    # A smooth dome needs no fine importance map: the automatic one takes three seconds and 200 MB.
    world.cycles.sampling_method, world.cycles.sample_map_resolution = "MANUAL", 64
    tree = world.node_tree
    place = tree.nodes.new("ShaderNodeTexCoord")
    split = tree.nodes.new("ShaderNodeSeparateXYZ")
    height = tree.nodes.new("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -1.0
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    stops = ramp.color_ramp.elements
    while len(stops) < len(SKY_STOPS):
        stops.new(0.5)
    for stop, position, color in zip(stops, SKY_STOPS, sky_colors(sky), strict=True):
        stop.position, stop.color = (position + 1) / 2, (*(float(c) for c in color), 1.0)
    tree.links.new(place.outputs["Generated"], split.inputs[0])
    tree.links.new(split.outputs["Z"], height.inputs["Value"])
    tree.links.new(height.outputs[0], ramp.inputs[0])
    tree.links.new(ramp.outputs[0], tree.nodes["Background"].inputs[0])
    return world


@dataclass(frozen=True)
class PanoramaImage:
    """A panorama of a light plan as a renderer gets it.

    Attributes:
        light: How it is turned, and how strong it is.
        path: The prepared picture.
        seen: Whether cameras see it too; else they see the gradient sky, as in the drawn looks.
    """

    light: PanoramaLight
    path: Path
    seen: bool = True


def add_panorama(world: bpy.types.World, panorama: PanoramaImage) -> bpy.types.Image:
    """Let a panorama light the world where its gradient sky did; return its picture, not packed yet.

    Args:
        world: Made by ``make_world``.
        panorama: The picture, its turn and its strength.
    """
    world.cycles.sample_map_resolution = 256
    tree = world.node_tree
    image = bpy.data.images.get(panorama.path.name)
    if image is None:
        image = bpy.data.images.load(str(panorama.path))
        image.name = panorama.path.name
    place, turn = tree.nodes.new("ShaderNodeTexCoord"), tree.nodes.new("ShaderNodeMapping")
    texture, light = tree.nodes.new("ShaderNodeTexEnvironment"), tree.nodes.new("ShaderNodeBackground")
    share = tree.nodes.new("ShaderNodeMixShader")
    turn.name, light.name, share.name = f"{PANORAMA}_turn", PANORAMA, f"{PANORAMA}_share"
    texture.image = image
    turn.inputs["Rotation"].default_value[2] = -math.radians(panorama.light.yaw)  # the place turns, not the picture
    light.inputs["Strength"].default_value = panorama.light.strength
    share.inputs["Fac"].default_value = 1.0
    tree.links.new(place.outputs["Generated"], turn.inputs["Vector"])
    tree.links.new(turn.outputs[0], texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], light.inputs["Color"])
    tree.links.new(tree.nodes["Background"].outputs[0], share.inputs[1])
    tree.links.new(light.outputs[0], share.inputs[2])
    if not panorama.seen:
        ray, inverse = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeMath")
        inverse.operation, inverse.inputs[0].default_value = "SUBTRACT", 1.0
        tree.links.new(ray.outputs["Is Camera Ray"], inverse.inputs[1])
        tree.links.new(inverse.outputs[0], share.inputs["Fac"])
    tree.links.new(share.outputs[0], tree.nodes["World Output"].inputs["Surface"])
    return image


@contextmanager
def lit(
    scene: bpy.types.Scene,
    lights: Sequence[Light],
    sky: Sky,
    cast: Sequence[bpy.types.Object],
    panorama: PanoramaImage | None = None,
) -> Iterator[None]:
    """Light the scene by exactly these lamps and this sky; the scene's own lights and world come back after.

    Args:
        scene: To be rendered inside the ``with`` block.
        lights: Lamps of the set and of the shot.
        sky: Becomes the world.
        cast: The people's objects: all that casts shadows from the lamps of faces.
        panorama: Lights in the place of the sky.
    """
    with ExitStack() as stack:
        for obj in scene.objects:
            if obj.type == "LIGHT" and not obj.hide_render:
                stack.enter_context(changed(obj, {"hide_render": True}))
        world = make_world(sky, "temporary")
        stack.callback(bpy.data.worlds.remove, world)
        if panorama is not None:
            stack.callback(bpy.data.images.remove, add_panorama(world, panorama))
        stack.enter_context(changed(scene, {"world": world}))
        blockers = bpy.data.collections.new("temporary")
        stack.callback(bpy.data.collections.remove, blockers)
        for obj in cast:
            blockers.objects.link(obj)
        for light in lights:
            lamp = make_lamp(light, "temporary")
            stack.callback(bpy.data.lights.remove, lamp.data)
            scene.collection.objects.link(lamp)
            if light.role in FACE_ROLES:
                lamp.light_linking.blocker_collection = blockers
        scene.view_layers[0].update()
        yield
