"""A scene as the Instructor sees it: hour, set, furniture, things, staging."""

from __future__ import annotations

from collections.abc import Mapping

from storyblender.catalog.fixtures import parts_of
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.decided import is_ground
from storyblender.memory.base import Frozen, scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.scene_decision import LightDecision


class SceneNow(Frozen):
    """A scene as it is."""

    name: str
    kit: str
    indoor: bool
    time_of_day: str
    weather: str
    light: LightDecision
    """What a person decided so far."""
    options: Mapping[str, bool]
    """Options of the kit, on or off."""
    walls: str = ""
    """Finish or material of the walls; empty where the set has none, or is not made yet."""
    ground: str = ""
    """The same of the floor or the ground."""
    size: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Width, depth and height of the set in metres; 0 where it is not made yet."""
    furniture: Mapping[str, str] = {}
    """Catalogue key of each piece of the kit's furniture, by node id."""
    things: Mapping[str, str] = {}
    """Catalogue key of each thing of the story in the scene, by asset id; empty for what the library lacks."""
    parts: tuple[str, ...] = ()
    """Words for the parts of the set at which a thing can be placed: ``door``, ``window``, ``bar``."""


def scene_now(graph: ContinuityMemoryGraph, scene: SceneContext) -> SceneNow:
    """Return a scene as the Instructor sees it.

    Args:
        graph: The story.
        scene: One of its scenes.
    """
    setup, made = scene.decided_setup, scene.environment
    kit = SETS.get(made.kit if made is not None else setup.kit)
    params = made.params if made is not None else {}
    options = {name: bool(params.get(name, on)) for name, on in kit.options.items()} if kit is not None else {}
    now = SceneNow(
        name=scene_name(scene.scene_id),
        kit=kit.key if kit is not None else setup.kit,
        indoor=setup.scene_type == "indoor",
        time_of_day=setup.time_of_day,
        weather=setup.weather,
        light=scene.light_decision or LightDecision(),
        options=options,
        things={asset.asset_id: prop_of(asset) for asset in graph.own_objects_of(scene.scene_id)},
    )
    if made is None or kit is None:
        return now
    plan = plan_of(made)
    height = max((wall.base + wall.height for wall in plan.walls), default=0.0)
    size = (plan.size.x - plan.size.x_negative, plan.size.y - plan.size.y_negative, height)
    return now.model_copy(
        update={
            "walls": next((wall.material for wall in plan.walls if not wall.missing), ""),
            "ground": next((slab.material for slab in plan.slabs if is_ground(slab, plan)), ""),
            "size": size,
            "parts": parts_of(plan),
            "furniture": {item.node_id: item.prop for item in plan.furnishings},
        }
    )
