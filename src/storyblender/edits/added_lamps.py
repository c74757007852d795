"""Lamps that a person added in Blender, as lamps of the light plan."""

from __future__ import annotations

import math
from statistics import median

from storyblender.edits.adopting_objects import called_in_story
from storyblender.edits.blend_change import BlendChange
from storyblender.memory.base import scene_name
from storyblender.memory.blend_values import NodeValues, SceneValues, Vector
from storyblender.memory.edits import LightEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_decision import LampDecision, LightDecision


def lamp_edit(graph: ContinuityMemoryGraph, change: BlendChange, node: NodeValues, scene: SceneValues) -> LightEdit:
    """Return the edit that adds a lamp to the plan of its scene.

    Args:
        graph: The story.
        change: Says that it is new.
        node: The lamp.
        scene: As the file was compiled, for how bright its own lamps are there.
    """
    assert node.lamp is not None, "a lamp has the values of one"
    lighting = next(each.lighting for each in graph.scenes if scene_name(each.scene_id) == change.scene)
    planned = {light.name: light.power for light in lighting.lights} if lighting is not None else {}
    shares = [
        planned[each.node_id] / each.lamp.power
        for each in scene.nodes
        if each.lamp is not None and each.lamp.power and planned.get(each.node_id)
    ]
    name = called_in_story(node.name, change.scene).replace(" ", "_")
    while name in planned:
        name += "_added"
    aimed = zip(node.location, looking(node.rotation), strict=True)
    x, y, z = (round(at + 2.0 * toward, 4) for at, toward in aimed)
    red, green, blue = (min(max(each, 0.0), 1.0) for each in node.lamp.color)
    lamp = LampDecision(
        kind=node.lamp.kind,
        location=node.location,
        target=(x, y, z),
        power=round(node.lamp.power * (median(shares) if shares else 1.0), 4),
        color=(red, green, blue),
        size=node.lamp.size,
        cone=node.lamp.cone if node.lamp.kind == "SPOT" else None,
    )
    return LightEdit(scene=change.scene, decision=LightDecision(lamps={name: lamp}))


def looking(rotation: Vector) -> Vector:
    """Return where a lamp shines that is turned by some degrees about X, Y and Z: along its own -Z."""
    x, y, z = map(math.radians, rotation)
    return (
        -(math.cos(z) * math.sin(y) * math.cos(x) + math.sin(z) * math.sin(x)),
        -(math.sin(z) * math.sin(y) * math.cos(x) - math.cos(z) * math.sin(x)),
        -math.cos(y) * math.cos(x),
    )
