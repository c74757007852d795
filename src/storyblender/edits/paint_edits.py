"""Edits of materials: painted in one asset, in one scene, or in the whole story."""

from __future__ import annotations

from difflib import get_close_matches

from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.sets import SETS, plan_of
from storyblender.edits.conflicts import FILM, paint_aspect
from storyblender.edits.effect import Effect, refuse_locked, shot_names
from storyblender.edits.targets import as_id, person_or_thing, scene_named
from storyblender.errors import InputError
from storyblender.memory.base import scene_name
from storyblender.memory.edits import PaintEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.paint import Paint, PaintDecision, PaintTarget
from storyblender.memory.scene_context import SceneContext


def paint_effects(graph: ContinuityMemoryGraph, edit: PaintEdit) -> list[Effect]:
    """Return what painting a material, or taking its paint off, does to the story. Raises InputError."""
    target = _target_of(graph, edit)
    if edit.look is not None and edit.look.finish is not None and edit.look.finish not in MATERIALS:
        near = get_close_matches(edit.look.finish, MATERIALS, n=3, cutoff=0.6)
        mend = f"did you mean {', '.join(near)}?" if near else "`storyblender catalog materials` lists them"
        raise InputError(f"there is no material {edit.look.finish!r}", mend=mend)
    reached = _scenes_reached(graph, target)
    if target.asset_id is not None and graph.asset(target.asset_id).locked:
        raise InputError(f"{target.asset_id} is locked", mend="unlock it first")
    for scene in reached if target.asset_id is None else ():
        refuse_locked(scene, "set")
    before = next((each for each in graph.paints if each.target == target), None)
    if edit.look is None and before is None:
        raise InputError(f"{_called(target)} is not painted")
    others = tuple(each for each in graph.paints if each is not before)
    now = () if edit.look is None else (Paint(target=target, look=_over(before, edit.look)),)
    words = f"{target.material or 'main material'} {edit.look.words if edit.look else 'as it was made'}"
    stale = tuple(name for scene in reached for name in shot_names(graph, scene.scene_id))
    aspect = frozenset({paint_aspect(target.material)})
    return [Effect(None, _called(target), words, aspect, stale, head={"paints": (*others, *now)})]


def _over(before: Paint | None, look: PaintDecision) -> PaintDecision:
    return look if before is None else before.look.then(look)


def _target_of(graph: ContinuityMemoryGraph, edit: PaintEdit) -> PaintTarget:
    """Return which surfaces an edit means. Raises InputError: there is no such thing or scene."""
    material = edit.material and edit.material.removeprefix("MT_")
    if edit.scene is None:
        return PaintTarget(material=material, asset_id=person_or_thing(graph, edit.thing) if edit.thing else None)
    scene = scene_named(graph, edit.scene)
    if edit.thing is None:
        return PaintTarget(material=material, scene_id=scene.scene_id)
    return PaintTarget(material=material, scene_id=scene.scene_id, **_standing(graph, scene, edit.thing))


def _standing(graph: ContinuityMemoryGraph, scene: SceneContext, thing: str) -> dict[str, str]:
    """Return what a name means in a scene: an object of its layout, an asset that it shows, or a piece of its set."""
    items = scene.layout.objects if scene.layout is not None else ()
    if thing in {item.node_id for item in items}:
        return {"node_id": thing}
    for asset in graph.assets_of(scene.scene_id):
        if thing == asset.asset_id or as_id(thing) in (asset.asset_id, as_id(asset.name)):
            return {"asset_id": asset.asset_id}
    environment = scene.environment
    plan = plan_of(environment) if environment is not None and environment.kit in SETS else None
    built = (*plan.walls, *plan.slabs, *plan.pieces, *plan.backdrops) if plan is not None else ()
    pieces = {each.node_id for each in built}
    if thing not in pieces:
        near = get_close_matches(thing, [*pieces, *(item.node_id for item in items)], n=3, cutoff=0.5)
        mend = f"did you mean {', '.join(near)}?" if near else f"its set has {', '.join(sorted(pieces)[:12])}"
        raise InputError(f"there is no {thing!r} in {scene_name(scene.scene_id)}", mend=mend)
    return {"node_id": thing}


def _scenes_reached(graph: ContinuityMemoryGraph, target: PaintTarget) -> list[SceneContext]:
    scenes = [each for each in graph.scenes if target.scene_id in (None, each.scene_id)]
    if target.asset_id is None:
        return scenes
    return [each for each in scenes if target.asset_id in {one.asset_id for one in graph.assets_of(each.scene_id)}]


def _called(target: PaintTarget) -> str:
    where = scene_name(target.scene_id) if target.scene_id is not None else ""
    return " ".join(filter(None, [where, target.node_id or target.asset_id])) or FILM
