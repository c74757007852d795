"""Things scaled by hand: a thing of the story in all its scenes, furniture in all scenes of its place."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from storyblender.agents.layout_artist.placed_by_hand import carried, riders_of, scale_on_it, stand_of
from storyblender.agents.visual_effects_artist.furniture import dressing_asset, prop_size
from storyblender.catalog.recipe import made_from
from storyblender.catalog.sets import SETS, plan_of
from storyblender.edits.effect import (
    Effect,
    refuse_locked,
    scene_effect,
    scenes_of_place,
)
from storyblender.edits.locked_shots import refuse_shown_in_locked
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import PLAUSIBLE, Asset, AssetDecision, AssetDimension, CanonicalAsset, ModelPose
from storyblender.memory.base import Vec3
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import LayoutObject, SceneContext
from storyblender.memory.scene_decision import LayoutDecision, SetDecision

_SIDES = ("width", "depth", "height")


def scale_effects(graph: ContinuityMemoryGraph, scene: SceneContext, item: LayoutObject, factor: float) -> list[Effect]:
    """Return what another size of a thing does to it and to the scenes that show it: their layouts stay.

    Args:
        graph: The story.
        scene: Where it was scaled.
        item: In its layout.
        factor: Of its present size.

    Raises:
        InputError: It would be too small or too large, it is no part of the plan of its set, or something is locked.
    """
    asset = graph.asset(item.asset_id)
    words = f"{item.node_id} scaled by {factor:g}"
    if asset.origin != "dressing":
        return thing_scaled(graph, asset, factor, words)
    return _furniture_scaled(graph, scene, item, built(asset, (factor, factor, factor)), factor, words)


def thing_scaled(graph: ContinuityMemoryGraph, asset: Asset, factor: float, words: str) -> list[Effect]:
    """Return what another size of a thing of the story does to it and to the scenes that show it: layouts stay.

    Args:
        graph: The story.
        asset: The thing.
        factor: Of its present size.
        words: What is done.

    Raises:
        InputError: It would be too small or too large, or something is locked.
    """
    made = built(asset, (factor, factor, factor))
    if asset.locked:
        raise InputError(f"{asset.asset_id} is locked", mend="unlock it first")
    larger = Effect(_resized(asset, made, factor), asset.asset_id, words, frozenset({"asset"}))
    scaled = ((each, _scaled_layout(graph, each, _nodes_of(each, asset.asset_id), factor)) for each in graph.scenes)
    shown = ((each, update) for each, update in scaled if update)
    return [larger, *(scene_effect(graph, each, words, "layout", ("motion",), **update) for each, update in shown)]


def built(asset: Asset, factors: Vec3) -> CanonicalAsset:
    """Return what a thing became, once it is sure that it can be so many times as wide, as deep and as high.

    Args:
        asset: The thing.
        factors: Of its present width, depth and height.

    Raises:
        InputError: It is not built yet, or would be too small or too large.
    """
    made = asset.canonical
    if made is None:
        raise InputError(f"{asset.asset_id} is not built yet", mend="run `storyblender render` first")
    sides = [side * factor for side, factor in zip(made.dimensions, factors, strict=True)]
    if not all(PLAUSIBLE[0] <= side <= PLAUSIBLE[1] for side in sides):
        sizes = " x ".join(f"{side:.3g}" for side in sides)
        raise InputError(
            f"{asset.asset_id} cannot be {sizes} m", mend=f"a side has {PLAUSIBLE[0]:g} to {PLAUSIBLE[1]:g} m"
        )
    return made


def _resized(asset: Asset, made: CanonicalAsset, factor: float) -> Asset:
    """Return an asset that is to be built in another size, with what its measures will be."""
    measures: dict[str, Any] = {
        "dimensions": tuple(round(side * factor, 6) for side in made.dimensions),
        "anchors": tuple(
            anchor.model_copy(
                update={
                    "location": tuple(each * factor for each in anchor.location),
                    "size": tuple(each * factor for each in anchor.size),
                    "clearance": anchor.clearance and anchor.clearance * factor,
                }
            )
            for anchor in made.anchors
        ),
        "geometry_hash": "",
    }
    told = {side: length * factor for side, length in asset.dimension or () if length is not None}
    dimension = AssetDimension(**(told or {"width": measures["dimensions"][0]}))
    if made.source == "catalog":
        whole = made_from(asset, _in_size(asset, made, factor))
        assert whole.canonical is not None
        canonical = whole.canonical.model_copy(update={**measures, "match_score": made.match_score})
        kept = {"kind": asset.kind, "image_prompt": asset.image_prompt}
        return whole.model_copy(update={"canonical": canonical, "dimension": dimension, **kept})
    if made.source == "file":  # which need not have the size that such a thing usually has
        width, depth, height = measures["dimensions"]
        level = max(width, depth)
        dimension = AssetDimension(height=height) if height >= level else AssetDimension(width=level)
    canonical = made.model_copy(update={**measures, "params": {**made.params, "told": True}})
    decided = {"decision": _file_in_size(made, dimension)} if made.source == "file" else {}
    return asset.model_copy(update={"canonical": canonical, "dimension": dimension, **decided})


def _file_in_size(made: CanonicalAsset, dimension: AssetDimension) -> AssetDecision:
    """Return what a thing is made from whose size a person decided, if that is a model of the user."""
    told = {side: length for side, length in dimension if length is not None}
    return AssetDecision(file=made.key, params={**ModelPose.of(made.params).params, **told, "told": True})


def _nodes_of(scene: SceneContext, asset_id: str) -> list[str]:
    """Return the node ids in the layout of a scene that show an asset."""
    return [each.node_id for each in scene.layout.objects if each.asset_id == asset_id] if scene.layout else []


def _in_size(asset: Asset, made: CanonicalAsset, factor: float) -> AssetDecision:
    """Return what a thing is made from in another size, from what the library has and how much larger it is here."""
    usual = prop_size(made.key, made.params)
    told = [each for each, (_, length) in enumerate(asset.dimension or ()) if length is not None]
    here = made.dimensions[told[0]] / usual[told[0]] if told else 1.0
    sides = {side: round(length * here * factor, 6) for side, length in zip(_SIDES, usual, strict=True)}
    return AssetDecision(prop=made.key, params={**made.params, **sides})


def _furniture_scaled(
    graph: ContinuityMemoryGraph,
    scene: SceneContext,
    item: LayoutObject,
    made: CanonicalAsset,
    factor: float,
    words: str,
) -> list[Effect]:
    """Return what another size of a piece of furniture does to the scenes of its place, each with that size decided."""
    environment = scene.environment
    planned = plan_of(environment).furnishings if environment is not None and environment.kit in SETS else ()
    if made.source != "catalog" or item.node_id not in {each.node_id for each in planned}:
        raise InputError(f"the size of {item.node_id} cannot be changed", mend="replace it by another thing")
    decision = _in_size(graph.asset(item.asset_id), made, factor)
    larger = dressing_asset(decision.prop, decision.params)
    effects: list[Effect] = []
    if larger.asset_id not in {asset.asset_id for asset in graph.assets}:
        measured = _resized(graph.asset(item.asset_id), made, factor).canonical
        assert measured is not None and larger.canonical is not None
        larger = larger.model_copy(
            update={"canonical": larger.canonical.model_copy(update={"anchors": measured.anchors})}
        )
        effects.append(Effect(larger, larger.asset_id, words, frozenset({"asset"})))
    for each in scenes_of_place(graph, scene):
        refuse_locked(each, "set")
        decided = (each.set_decision or SetDecision()).then(SetDecision(furniture={item.node_id: decision}))
        update: dict[str, Any] = {"set_decision": decided}
        if each.environment is not None:
            furniture = {**each.environment.furniture, item.node_id: decision}
            update["environment"] = each.environment.model_copy(update={"furniture": furniture})
        if scaled := _scaled_layout(graph, each, [item.node_id], factor):
            objects = tuple(
                part.model_copy(update={"asset_id": larger.asset_id}) if part.node_id == item.node_id else part
                for part in scaled["layout"].objects
            )
            update |= {**scaled, "layout": scaled["layout"].model_copy(update={"objects": objects})}
        effects.append(scene_effect(graph, each, words, "set", ("motion",), **update))
    return effects


def _scaled_layout(
    graph: ContinuityMemoryGraph, scene: SceneContext, node_ids: Iterable[str], factor: float
) -> dict[str, Any]:
    """Return the update of a scene with what is on scaled things where it is then; empty if it shows none of them.

    Raises:
        InputError: Something in the scene is locked.
    """
    there = {item.node_id for item in scene.layout.objects} if scene.layout is not None else set[str]()
    shown = [node_id for node_id in node_ids if node_id in there]
    if scene.layout is None or scene.environment is None or not shown:
        return {}
    layout, stand = scene.layout, stand_of(graph.assets, scene.environment)
    riders = [rider for node_id in shown for rider in riders_of(layout, node_id, stand)]
    refuse_shown_in_locked(graph, scene, stand, (*shown, *riders), layout)
    decision = scene.layout_decision
    for node_id in shown:
        layout = scale_on_it(layout, node_id, factor, stand)
        if decision is not None:
            taken = carried(decision.things, riders_of(scene.layout, node_id, stand), layout)
            decision = decision.then(LayoutDecision(things=taken))
    return {"layout": layout, "layout_decision": decision}
