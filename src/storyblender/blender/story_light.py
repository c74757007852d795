"""The light of a scene in the story's file: lamps keyed by shot, and the sky, as bright as on the board."""

from __future__ import annotations

import math
from collections.abc import Sequence

import bpy

from storyblender.blender.hiding import key_hidden
from storyblender.blender.render.lamps import PANORAMA, PanoramaImage, add_panorama, make_lamp
from storyblender.blender.render.meter import balanced
from storyblender.blender.sets.world import set_world
from storyblender.blender.tags import tag
from storyblender.folder import Folder
from storyblender.look.illumination import sky_colors
from storyblender.memory.base import shot_name
from storyblender.memory.jobs import PackRef
from storyblender.memory.scene_context import Light, Lighting, SceneContext
from storyblender.memory.shot_context import ShotContext

_SIDES = {
    "above": ((0.0, 0.0, 1.0), 0.8),
    "below": ((0.0, 0.0, -1.0), 0.4),
    "front": ((0.0, -1.0, 0.0), 0.55),
    "back": ((0.0, 1.0, 0.0), 0.55),
    "left": ((-1.0, 0.0, 0.0), 0.55),
    "right": ((1.0, 0.0, 0.0), 0.55),
}
"""Directions of ambient light under a roof and their shares: a little more from above, less in sum for corners."""


def light_scene(
    scene: bpy.types.Scene,
    collection: bpy.types.Collection,
    context: SceneContext,
    shots: Sequence[ShotContext],
    pack: PackRef,
    files: Folder,
) -> None:
    """Add the lamps and the sky of a scene's light plans, metered as for the board, and the lamps of its shots.

    Args:
        scene: The Blender scene, with set and people.
        collection: Receives the lamps.
        context: Has the light plan that the scene begins with.
        shots: Of the scene, in order; a shot may bring a plan that applies from there on.
        pack: Has the first frames of the shots.
        files: The project folder, with the pictures of panoramas.
    """
    starts = [pack.start_of(shot.shot_id) for shot in shots]
    plans = _plans(context, shots)
    scene.view_layers[0].update()
    for number, (plan, first, last) in enumerate(plans):
        metered = balanced(scene, plan)
        plan = metered.plan
        prefix = shot_name(shots[first].scene_id, shots[first].shot_id) if number else scene.name
        lamps = make_lights(plan.lights, collection, prefix)
        for lamp in make_lights(_ambient(plan, metered.roofed), collection, prefix):
            lamp.data.use_shadow, lamp.data.specular_factor = False, 0.0
            lamps.append(lamp)
        for lamp in lamps:
            key_hidden(lamp, [(start, first <= index < last) for index, start in enumerate(starts)])
        if number == 0:
            set_world(scene, plan.sky)
            later = (each.panorama for each, *_ in plans if each.panorama is not None)
            panorama = plan.panorama or next(later, None)
            if panorama is not None:
                _pack(add_panorama(scene.world, PanoramaImage(panorama, files.path(panorama.file))))
        if len(plans) > 1:
            _key_sky(scene.world, plan, starts[first])
    people = bpy.data.collections.get(f"{scene.name}_cast")
    for index, shot in enumerate(shots):
        for lamp in make_lights(shot.lights, collection, shot_name(shot.scene_id, shot.shot_id)):
            lamp.light_linking.blocker_collection = people  # only people cast shadows from them, as on the board
            key_hidden(lamp, [(start, other == index) for other, start in enumerate(starts)])


def _pack(picture: bpy.types.Image) -> None:
    """Put a picture into the file, without the path that it was read from."""
    if picture.packed_file is None:
        picture.pack()
        picture.filepath_raw = picture.packed_files[0].filepath = f"//{picture.name}"


def make_lights(lights: Sequence[Light], collection: bpy.types.Collection, prefix: str) -> list[bpy.types.Object]:
    """Make one light object per lamp, tagged with its name and the person it lights.

    Args:
        lights: Of the scene or of a shot.
        collection: Receives the objects.
        prefix: Leads the objects' names: that of the scene, or of the shot that they are for.

    Returns:
        The objects, in order; area lights are not seen by cameras.
    """
    objects = []
    for light in lights:
        lamp = make_lamp(light, f"{prefix}.{light.name}")
        tag(lamp, kind="light", node_id=light.name, asset_id=light.for_asset or "")
        lamp["role"], lamp["glow"] = light.role, light.glow
        collection.objects.link(lamp)
        objects.append(lamp)
    return objects


def _ambient(plan: Lighting, roofed: float) -> list[Light]:
    """Return shadowless suns from all sides for the ambient light of a room, which no sky gives."""
    level = max(plan.ambient) * roofed
    if level <= 0:
        return []
    red, green, blue = (channel / max(plan.ambient) for channel in plan.ambient)
    return [
        Light(
            name=f"ambient_{side}",
            kind="SUN",
            location=toward,
            power=math.pi * level * share,
            color=(red, green, blue),
            size=0.0,
        )
        for side, (toward, share) in _SIDES.items()
    ]


def _plans(context: SceneContext, shots: Sequence[ShotContext]) -> list[tuple[Lighting, int, int]]:
    """Return each light plan with the index of its first shot and of the first one after it."""
    begins = [(shot.lighting, index) for index, shot in enumerate(shots) if shot.lighting is not None]
    if context.lighting is not None and (not begins or begins[0][1] > 0):
        begins.insert(0, (context.lighting, 0))
    ends = [index for _, index in begins[1:]] + [len(shots)]
    return [(plan, first, last) for (plan, first), last in zip(begins, ends, strict=True) if plan is not None]


def _key_sky(world: bpy.types.World, plan: Lighting, frame: int) -> None:
    """Key the sky's colours on the world's dome from a frame on, and whether a panorama lights in its place."""
    nodes, sky = world.node_tree.nodes, plan.sky
    if PANORAMA in nodes:
        share = nodes[f"{PANORAMA}_share"].inputs["Fac"]
        share.default_value = 0.0 if plan.panorama is None else 1.0
        share.keyframe_insert("default_value", frame=frame)
    if PANORAMA in nodes and plan.panorama is not None:
        turn, strength = nodes[f"{PANORAMA}_turn"].inputs["Rotation"], nodes[PANORAMA].inputs["Strength"]
        turn.default_value[2] = -math.radians(plan.panorama.yaw)
        strength.default_value = plan.panorama.strength
        turn.keyframe_insert("default_value", index=2, frame=frame)
        strength.keyframe_insert("default_value", frame=frame)
    ramp = next(node for node in nodes if node.type == "VALTORGB").color_ramp
    for stop, color in zip(ramp.elements, sky_colors(sky), strict=True):
        stop.color = (*(float(channel) for channel in color), 1.0)
        stop.keyframe_insert("color", frame=frame)
    for curve in world.node_tree.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "CONSTANT"
