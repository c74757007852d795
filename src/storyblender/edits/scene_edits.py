"""Edits of a scene: its light, its set, another staging. Each names what the crew has to make anew."""

from __future__ import annotations

from typing import Any

from storyblender.agents.visual_effects_artist.decided import with_surfaces
from storyblender.agents.visual_effects_artist.lighting_arranger_view import MOST_LIGHTS
from storyblender.catalog.light_recipes import HOURS
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.decided import has_ground, has_walls
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.edits.effect import (
    Effect,
    name_of,
    refuse_far,
    refuse_locked,
    refuse_locked_staging,
    scene_effect,
    scenes_of_place,
)
from storyblender.edits.targets import refuse_other, scene_named
from storyblender.errors import InputError
from storyblender.memory.edits import LayoutEdit, LightEdit, SetEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.scene_decision import LayoutDecision, LightDecision, SetDecision


def light_effects(graph: ContinuityMemoryGraph, edit: LightEdit) -> list[Effect]:
    """Return what a decision about light does. Raises InputError."""
    scene = scene_named(graph, edit.scene)
    _refuse_nothing(scene, edit.decision.words, "light", "give an hour, a weather, a warmth ...")
    refuse_locked(scene, "light")
    _refuse_lamps(scene, edit.decision)
    decided = (scene.light_decision or LightDecision()).then(edit.decision)
    done = scene_effect(graph, scene, f"light: {edit.decision.words}", "light", ("light",), light_decision=decided)
    return [done.warned(_unlit(scene, edit.decision))]


def _unlit(scene: SceneContext, decision: LightDecision) -> tuple[str, ...]:
    """Return what a person should know of a panorama that does not light the scene. Raises InputError for a room."""
    if decision.panorama in (None, "none"):
        return ()
    if scene.setup.scene_type == "indoor":
        mend = "choose one for a scene outside; rooms are lit by their lamps and windows"
        raise InputError(f"{name_of(scene)} is inside, and a panorama lights what is outside", mend=mend)
    hour = decision.time_of_day or scene.decided_setup.time_of_day
    burning = HOURS[hour].lamps
    return (f"{name_of(scene)} plays at {hour}; a panorama lights it from morning to afternoon",) if burning else ()


def _refuse_lamps(scene: SceneContext, decision: LightDecision) -> None:
    """Refuse a lamp that the scene has not and that is not whole, one too far away, and more than it can have."""
    own = {light.name for light in scene.lighting.lights} if scene.lighting is not None else set[str]()
    before = scene.light_decision.lamps if scene.light_decision is not None else {}
    for name, lamp in decision.lamps.items():
        known = name in own or before.get(name) is not None
        if not known and (lamp is None or lamp.kind is None):
            names = ", ".join(sorted(own)) or "none"
            mend = f"it has: {names}; a kind (POINT, SPOT, AREA, SUN) adds one"
            raise InputError(f"there is no lamp {name!r} in {name_of(scene)}", mend=mend)
        for point in (lamp.location, lamp.target) if lamp is not None else ():
            if point is not None:
                refuse_far(point, scene)
    if len({*own, *(name for name, lamp in {**before, **decision.lamps}.items() if lamp is not None)}) > MOST_LIGHTS:
        raise InputError(f"{name_of(scene)} has {MOST_LIGHTS} lamps already", mend="take one away first")


def set_effects(graph: ContinuityMemoryGraph, edit: SetEdit) -> list[Effect]:
    """Return what a decision about the set of a place does to its scenes. Raises InputError."""
    scene, decision = scene_named(graph, edit.scene), edit.decision
    _refuse_nothing(scene, decision.words, "set", "give a material, an option, a kit ...")
    _refuse_unknown(scene, decision)
    effects: list[Effect] = []
    for each in scenes_of_place(graph, scene):
        refuse_locked(each, "set")
        decided = (each.set_decision or SetDecision()).then(decision)
        words = f"set: {decision.words}"
        if decision.only_finishes and each.environment is not None:
            made = with_surfaces(each.environment, decision)
            effects.append(scene_effect(graph, each, words, "set", (), environment=made, set_decision=decided))
        else:
            refuse_locked_staging(graph, each)
            effects.append(scene_effect(graph, each, words, "set", ("set",), set_decision=decided))
    return effects


def layout_effects(graph: ContinuityMemoryGraph, edit: LayoutEdit) -> list[Effect]:
    """Return what another staging does to a scene. Raises InputError."""
    scene = scene_named(graph, edit.scene)
    before = scene.layout_decision or LayoutDecision()
    now = before.staging or 0
    staging = now + 1 if edit.staging is None else edit.staging
    if staging == now:
        raise InputError(f"{name_of(scene)} has staging {staging} already", mend="leave the number out for another")
    decided = before.then(LayoutDecision(staging=staging))
    return staged_anew(graph, scene, f"staging {staging}", layout_decision=decided)


def staged_anew(graph: ContinuityMemoryGraph, scene: SceneContext, words: str, **update: Any) -> list[Effect]:
    """Return what staging a scene anew does to it, and to later scenes of its place in which its things are.

    Args:
        graph: The story.
        scene: As it is.
        words: What is done.
        **update: Fields of the scene.

    Raises:
        InputError: Something of it is locked.
    """
    refuse_locked_staging(graph, scene)
    own = scene_effect(graph, scene, words, "layout", ("layout",), **update)
    things = {asset.asset_id for asset in graph.own_objects_of(scene.scene_id)}
    followers = [
        each
        for each in scenes_of_place(graph, scene)
        if each.scene_id > scene.scene_id and things.intersection(each.setup.asset_ids) and "layout" not in each.locked
    ]
    words = f"staged after {name_of(scene)}"
    return [own, *(scene_effect(graph, each, words, "layout", ("layout",)) for each in followers)]


def _refuse_nothing(scene: SceneContext, words: str, part: str, mend: str) -> None:
    if not words:
        raise InputError(f"nothing is decided about the {part} of {name_of(scene)}", mend=mend)


def _refuse_unknown(scene: SceneContext, decision: SetDecision) -> None:
    """Refuse what the catalogue, or the set of a scene, does not have."""
    kit = SETS.get(decision.kit or scene.decided_setup.kit)
    if decision.kit is not None:
        refuse_other(decision.kit, "set kit", SETS)
        assert kit is not None
        if kit.indoor != (scene.setup.scene_type == "indoor"):
            where = "indoors" if kit.indoor else "outdoors"
            mend = "change the heading in the script, or choose another kit"
            raise InputError(f"the set kit {kit.key!r} is {where}, {name_of(scene)} is not", mend=mend)
    for option in decision.options:
        refuse_other(option, f"option of the set {kit.key if kit else ''}".rstrip(), kit.options if kit else ())
    for name in ("walls", "ground"):
        finish = getattr(decision, name)
        if finish is not None:
            refuse_other(finish, "material", {**FINISHES, **MATERIALS})
    if scene.environment is None or scene.environment.kit not in SETS or decision.kit is not None:
        return
    plan = plan_of(scene.environment)
    if (decision.walls or decision.wall_texture) and not has_walls(plan):
        raise InputError(f"the set of {name_of(scene)} has no walls", mend="choose a kit that has, or a ground")
    if (decision.ground or decision.ground_texture) and not has_ground(plan):
        raise InputError(f"the set of {name_of(scene)} has no ground that can be of another material")
    for node_id, prop in decision.furniture.items():
        refuse_other(node_id, f"furniture of {name_of(scene)}", [item.node_id for item in plan.furnishings])
        if prop is not None:
            refuse_other(prop.prop, "prop", PROPS)
