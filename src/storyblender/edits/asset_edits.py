"""Edits of things: made from something else, added, taken away. Furniture of a set changes with its place."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

from storyblender.catalog.fixtures import fixtures_called, parts_of
from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.props.prop_names import kind_named, prop_named, prop_of
from storyblender.catalog.props.variants import read_variant
from storyblender.catalog.recipe import made_from
from storyblender.catalog.set_plan import Furnishing
from storyblender.catalog.sets import SETS, plan_of
from storyblender.edits.effect import (
    Effect,
    name_of,
    refuse_far,
    refuse_locked,
    refuse_locked_staging,
    scene_effect,
    scenes_of_place,
)
from storyblender.edits.targets import as_id, scene_named
from storyblender.edits.thing_edits import made_anew, thing_effects
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset, AssetDecision
from storyblender.memory.base import shot_name
from storyblender.memory.edits import AssetEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Relation, SceneContext
from storyblender.memory.scene_decision import LayoutDecision, SetDecision
from storyblender.memory.shot_context import ShotContext


def asset_effects(graph: ContinuityMemoryGraph, edit: AssetEdit) -> list[Effect]:
    """Return what replacing, adding or taking away a thing does to it, and to the scenes that show it.

    Args:
        graph: The story.
        edit: The thing by its id, its name, or what it is.

    Raises:
        InputError: There is no such thing, the library has nothing of that name, or something is locked.
    """
    scene = scene_named(graph, edit.scene) if edit.scene is not None else None
    if edit.action == "add":
        assert scene is not None, "the edit is whole"
        return _added(graph, scene, edit)
    asset = _thing(graph, edit.thing or "", scene)
    if edit.action == "rename":
        return [_renamed(graph, asset, edit)]
    if edit.action in ("resize", "turn", "regenerate") or edit.file is not None:
        if asset is None:
            raise InputError(f"there is no thing {edit.thing!r} of the story's own", mend=_names(graph))
        return thing_effects(graph, asset, edit)
    if asset is not None:
        if edit.action == "replace":
            return made_anew(graph, asset, _decision(edit, prop_of(asset)), (edit.model or "").replace("_", " "))
        assert scene is not None, "the edit is whole"
        return [_removed(graph, scene, asset)]
    if scene is None:
        mend = "name its scene if it is furniture of the set" if kind_named(edit.thing or "") else _names(graph)
        raise InputError(f"there is no thing {edit.thing!r}", mend=mend)
    made = decision_of(edit.model or "") if edit.action == "replace" else None
    return _refurnished(graph, scene, edit.thing or "", made, edit.model or "")


def decision_of(words: str) -> AssetDecision:
    """Return the prop of the library that words call by name, with the colour and material that they tell.

    Args:
        words: ``red bench``, or the key of a prop.

    Raises:
        InputError: The library has nothing of that name.
    """
    entry = PROPS.get(words) or prop_named(words)
    if entry is None:
        names = [name for each in PROPS.values() for name in (each.name, *each.tags)]
        near = get_close_matches(words.lower(), names, n=3, cutoff=0.6)
        mend = f"did you mean {', '.join(dict.fromkeys(near))}?" if near else "`storyblender catalog` lists what it has"
        raise InputError(f"the library has no {words!r}", mend=mend)
    return AssetDecision(prop=entry.key, params=read_variant(entry, words))


def _decision(edit: AssetEdit, prop: str | None) -> AssetDecision:
    """Return what an edit has a thing made from: a model from Blender, used as what it was, or the library's."""
    if edit.adopted is None:
        return decision_of(edit.model or "")
    return AssetDecision(prop=prop or "", adopted=edit.adopted)


def _added(graph: ContinuityMemoryGraph, scene: SceneContext, edit: AssetEdit) -> list[Effect]:
    refuse_locked_staging(graph, scene)
    model = edit.model or ""
    decision = _decision(edit, "")
    known = {asset.asset_id for asset in graph.assets}
    speaking = as_id(model).replace("_", "").isalnum() and as_id(model).isascii()
    base = as_id(model) if speaking else decision.prop or "thing"
    asset_id = next(
        name for count in range(1, 1000) if (name := base[:60] + (f"_{count}" if count > 1 else "")) not in known
    )
    asset = Asset(asset_id=asset_id, asset_type="object", name=model, description=model, tags=("prop",), origin="user")
    before = scene.layout_decision or LayoutDecision()
    places = {asset_id: edit.place} if edit.place is not None else {}
    decided = before.then(LayoutDecision(added=(*(before.added or ()), asset_id), things=places))
    setup = scene.setup.model_copy(update={"asset_ids": (*scene.setup.asset_ids, asset_id)})
    words = f"{model} added" if edit.place is None else f"{model} added {edit.place.words}"
    if edit.place is not None and edit.place.location is not None:
        refuse_far((*edit.place.location, edit.place.height or 0.0), scene)
    if edit.relation is not None and edit.anchor is not None:
        _refuse_no_anchor(graph, scene, edit.anchor)
        relation = Relation(asset_id=asset_id, kind=edit.relation, anchor_asset_id=edit.anchor)
        setup = setup.model_copy(update={"relations": (*setup.relations, relation)})
        words = f"{words} {edit.relation.replace('_', ' ')} {edit.anchor.replace('_', ' ')}"
    return [
        Effect(made_from(asset, decision), asset_id, words, frozenset({"asset"})),
        scene_effect(graph, scene, words, "layout", ("layout",), setup=setup, layout_decision=decided),
    ]


def _renamed(graph: ContinuityMemoryGraph, asset: Asset | None, edit: AssetEdit) -> Effect:
    """Return what another name does to a thing or a person of the story: it is printed, and nothing is drawn."""
    if asset is None:
        raise InputError(f"there is no thing {edit.thing!r} of the story's own", mend=_names(graph))
    words = f"is called {edit.name}"
    return Effect(asset.model_copy(update={"name": edit.name}), asset.asset_id, words, frozenset({"name"}))


def _refuse_no_anchor(graph: ContinuityMemoryGraph, scene: SceneContext, anchor: str) -> None:
    """Refuse a place at what is not in a scene."""
    if _thing(graph, anchor, scene) is not None or scene.environment is None or scene.environment.kit not in SETS:
        return
    plan = plan_of(scene.environment)
    if not _furniture(plan.furnishings, anchor) and not fixtures_called(plan, anchor):
        mend = f"parts of its set: {', '.join(parts_of(plan)[:12])}"
        raise InputError(f"there is no {anchor.replace('_', ' ')!r} in {name_of(scene)}", mend=mend)


def _removed(graph: ContinuityMemoryGraph, scene: SceneContext, asset: Asset) -> Effect:
    """Return what taking a thing out of a scene does: one that a person added is gone, the script's is not placed."""
    refuse_locked_staging(graph, scene)
    asset_id = asset.asset_id
    for shot in graph.shots_of(scene.scene_id):
        if asset_id in _used(shot):
            mend = "change the script, or replace it"
            raise InputError(f"{asset_id} is used in {shot_name(shot.scene_id, shot.shot_id)}", mend=mend)
    before = scene.layout_decision or LayoutDecision()
    if asset_id in (before.added or ()):
        decided = before.model_copy(update={"added": tuple(each for each in before.added or () if each != asset_id)})
        left = tuple(each for each in scene.setup.asset_ids if each != asset_id)
        relations = tuple(each for each in scene.setup.relations if each.asset_id != asset_id)
        setup = scene.setup.model_copy(update={"asset_ids": left, "relations": relations})
    else:
        decided = before.then(LayoutDecision(removed=(*(before.removed or ()), asset_id)))
        setup = scene.setup.model_copy(update={"scenery": (*scene.setup.scenery, asset_id)})
    words = f"{asset_id} taken away"
    return scene_effect(graph, scene, words, "layout", ("layout",), setup=setup, layout_decision=decided)


def _used(shot: ShotContext) -> set[str | None]:
    """Return the ids of the things that the people of a shot use, or that its picture is of."""
    states = (*shot.states, *shot.end_states)
    used: set[str | None] = {*shot.camera_instruction.focus_on_ids, *shot.thing_spots}
    used |= {each for action in shot.character_actions for each in (action.target_id, action.prop_id)}
    used |= {each for state in states for each in (state.support_id, *state.held)}
    used |= {state.spot.anchor_id for state in states if state.spot is not None}
    return used | {each.asset_id for each in shot.asset_modifications}


def _refurnished(
    graph: ContinuityMemoryGraph, scene: SceneContext, thing: str, made: AssetDecision | None, said: str
) -> list[Effect]:
    """Return what other furniture does to the scenes of a place."""
    name = name_of(scene)
    if scene.environment is None or scene.environment.kit not in SETS:
        raise InputError(f"{name} has no set yet", mend="run `storyblender render` first")
    plan = plan_of(scene.environment)
    items = _furniture(plan.furnishings, thing)
    if not items:
        kinds = sorted({item.prop.replace("_", " ") for item in plan.furnishings})
        raise InputError(f"there is no {thing!r} in {name}", mend=f"its furniture: {', '.join(kinds) or 'none'}")
    plural = thing not in {item.node_id for item in items} and _is_plural(thing)
    if len(items) > 1 and not plural:
        named = ", ".join(item.node_id for item in items[:6])
        raise InputError(f"{name} has {len(items)} of {thing!r}", mend=f"say them all ({thing}s), or name one: {named}")
    furniture = dict.fromkeys((item.node_id for item in items), made)
    words = f"{thing} taken away" if made is None else f"{thing} replaced by {said}"
    effects: list[Effect] = []
    for each in scenes_of_place(graph, scene):
        refuse_locked(each, "set")
        refuse_locked_staging(graph, each)
        decided = (each.set_decision or SetDecision()).then(SetDecision(furniture=furniture))
        effects.append(scene_effect(graph, each, words, "set", ("set",), set_decision=decided))
    return effects


def _furniture(furnishings: Sequence[Furnishing], thing: str) -> list[Furnishing]:
    """Return the furniture that words name: by node id, as the prop that it is, else as one of its family."""
    kind = kind_named(thing.replace("_", " "))
    named = [item for item in furnishings if item.node_id == thing]
    same = [item for item in furnishings if item.prop == kind]
    return named or same or [item for item in furnishings if item.prop in family_of(kind)]


def _is_plural(thing: str) -> bool:
    last = thing.lower().split()[-1] if thing.split() else ""
    return noun_key(last) != last or thing.lower().startswith("all ")


def _thing(graph: ContinuityMemoryGraph, thing: str, scene: SceneContext | None) -> Asset | None:
    """Return the thing of the script, or one that a person added, that words name; None if it is furniture or nothing.

    Args:
        graph: The story.
        thing: Its id, its name, or what it is.
        scene: Where it is; None looks in the whole story.
    """
    there = graph.assets if scene is None else [graph.asset(each) for each in scene.setup.asset_ids]
    own = [asset for asset in there if asset.origin != "dressing"]
    own = [asset for asset in own if scene is None or asset.asset_id not in scene.setup.scenery]
    kind = kind_named(thing.replace("_", " "))
    for fits in (
        lambda asset: thing in (asset.asset_id, asset.name) or as_id(thing) in (asset.asset_id, as_id(asset.name)),
        lambda asset: bool(kind) and scene is not None and prop_of(asset) == kind,
    ):
        found = [asset for asset in own if fits(asset)]
        if found:
            return found[0]
    return None


def _names(graph: ContinuityMemoryGraph) -> str:
    things = [asset.asset_id for asset in graph.assets if asset.asset_type == "object" and asset.origin != "dressing"]
    return f"there are: {', '.join(things[:12])}" if things else "the story has none of its own"
