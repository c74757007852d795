"""Edits of one thing of the story wherever it is: what it is made from, its size, its front and top, chosen anew."""

from __future__ import annotations

from typing import Any, Final

from storyblender.agents.concept_artist.asset_formatter import pose_problem
from storyblender.catalog.props.prop_names import kind_named
from storyblender.catalog.recipe import made_from
from storyblender.edits.effect import Effect, refuse_locked_staging, scene_effect
from storyblender.edits.scale_edits import built, thing_scaled
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset, AssetDecision, AssetDimension, ModelPose, file_words
from storyblender.memory.edits import AssetEdit
from storyblender.memory.graph import ContinuityMemoryGraph

SIDES: Final[tuple[str, ...]] = ("width", "depth", "height")
ODD: Final = 4.0
"""Times as large, or as small, as a thing was, from which on a person is told so: metres may not be what was meant."""
_SAME = 0.001
"""Relative difference of factors that are the same one."""


def thing_effects(graph: ContinuityMemoryGraph, asset: Asset, edit: AssetEdit) -> list[Effect]:
    """Return what an edit does to a thing of the story, and to the scenes that show it.

    Args:
        graph: The story.
        asset: The thing.
        edit: Resizes it, turns it, lets the crew choose anew, or makes it from a file.

    Raises:
        InputError: It cannot be, or something is locked.
    """
    if asset.asset_type == "character":
        return _recast(graph, asset, edit)
    _refuse_person(asset)
    match edit.action:
        case "resize":
            assert edit.dimension is not None, "the edit is whole"
            return _resized(graph, asset, edit.dimension)
        case "turn":
            assert edit.pose is not None, "the edit is whole"
            return _turned(graph, asset, edit.pose)
        case "regenerate":
            return _regenerated(graph, asset)
        case _:
            assert edit.file is not None, "the edit is whole"
            return made_anew(graph, asset, AssetDecision(file=edit.file), file_words(edit.file))


def _recast(graph: ContinuityMemoryGraph, asset: Asset, edit: AssetEdit) -> list[Effect]:
    """Return what a character does that is made from a model, or whose model has another front."""
    if asset.locked:
        raise InputError(f"{asset.asset_id} is locked", mend="unlock it first")
    if edit.action == "turn" and edit.pose is not None:
        return _turned(graph, asset, edit.pose)
    if edit.file is None:
        raise InputError(f"{asset.asset_id} is a person", mend="people are changed with `storyblender cast`")
    words = f"is made from {file_words(edit.file)}"
    warnings = (f"what {asset.asset_id} wears no longer shows",) if asset.look_decision is not None else ()
    own = Effect(made_from(asset, AssetDecision(file=edit.file)), asset.asset_id, words, frozenset({"asset"}))
    return [own.warned(warnings), *_staged_again(graph, asset.asset_id, words)]


def made_anew(graph: ContinuityMemoryGraph, asset: Asset, decision: AssetDecision, said: str) -> list[Effect]:
    """Return what a thing that is made from something else does.

    Args:
        graph: The story.
        asset: The thing.
        decision: What it is made from.
        said: The same, for people.

    Raises:
        InputError: It is a person, or something is locked.
    """
    _refuse_person(asset)
    words = f"is made from {said}"
    own = Effect(made_from(asset, decision), asset.asset_id, words, frozenset({"asset"}))
    return [own, *_staged_again(graph, asset.asset_id, words)]


def given_back(graph: ContinuityMemoryGraph, asset: Asset) -> list[Effect]:
    """Return what unlocking a thing does: the Asset Retriever chooses again where a person had chosen.

    Args:
        graph: The story.
        asset: Locked, or decided by a person, or neither.
    """
    decided = asset.decision is not None or bool(asset.turned_down)
    update = {"locked": False, **(_left_to_the_crew(asset, ()) if decided else {})}
    scenes = _staged_again(graph, asset.asset_id, "unlocked") if decided else []
    return [Effect(asset.model_copy(update=update), asset.asset_id, "unlocked", frozenset({"asset"})), *scenes]


def _regenerated(graph: ContinuityMemoryGraph, asset: Asset) -> list[Effect]:
    """Return what a thing does that the crew makes from something else than what it is."""
    made = asset.canonical
    if made is None:
        raise InputError(f"{asset.asset_id} is not built yet", mend="run `storyblender render` first")
    turned_down = tuple(dict.fromkeys((*asset.turned_down, made.key)))
    former = file_words(made.key) if made.source == "file" else made.key.replace("_", " ")
    words = f"is made anew, not from {former}"
    fresh = asset.model_copy(update=_left_to_the_crew(asset, turned_down))
    own = Effect(fresh, asset.asset_id, words, frozenset({"asset"}))
    return [own, *_staged_again(graph, asset.asset_id, words)]


def _left_to_the_crew(asset: Asset, turned_down: tuple[str, ...]) -> dict[str, Any]:
    """Return the update of a thing that the crew makes from what it finds."""
    kind = kind_named(asset.name or asset.asset_id)
    return {"decision": None, "kind": kind, "canonical": None, "dimension": None, "turned_down": turned_down}


def _resized(graph: ContinuityMemoryGraph, asset: Asset, dimension: AssetDimension) -> list[Effect]:
    """Return what another size of a thing does; of one side, or in proportion, all stays where it is."""
    told = {side: length for side, length in dimension if length is not None}
    if not told or asset.canonical is None:
        mend = "give a width, a depth or a height" if asset.canonical else "run `storyblender render` first"
        raise InputError(f"the size of {asset.asset_id} is not known", mend=mend)
    now: dict[str, float] = dict(zip(SIDES, asset.canonical.dimensions, strict=True))
    factors = {side: length / now[side] for side, length in told.items()}
    first = next(iter(factors.values()))
    words = f"is {', '.join(f'{length:g} m {_WORDS[side]}' for side, length in told.items())}"
    if all(abs(each / first - 1) < _SAME for each in factors.values()):
        whole, *scenes = thing_scaled(graph, asset, first, words)
        odd = f"{asset.asset_id} is {first:.2g} times as large as it was"
        return [whole.warned((odd,) if max(first, 1 / first) > ODD else ()), *scenes]
    made = built(asset, tuple(factors.get(side, 1.0) for side in SIDES))  # type: ignore[arg-type]
    if made.source != "catalog":
        mend = "give one side; the others follow"
        raise InputError(f"{asset.asset_id} keeps its proportions, as it is no prop of the library", mend=mend)
    sides = {side: round(told.get(side, length), 6) for side, length in now.items()}
    decision = AssetDecision(prop=made.key, params={**made.params, **sides})
    own = Effect(made_from(asset, decision), asset.asset_id, words, frozenset({"asset"}))
    return [own, *_staged_again(graph, asset.asset_id, words)]


_WORDS: Final[dict[str, str]] = {"width": "wide", "depth": "deep", "height": "high"}


def _turned(graph: ContinuityMemoryGraph, asset: Asset, pose: ModelPose) -> list[Effect]:
    """Return what another front and top of a model do to the thing."""
    file = _model_file(asset)
    if not file:
        mend = "only models from your folders are turned; in a scene it is turned with `storyblender place`"
        raise InputError(f"{asset.asset_id} is no model of yours", mend=mend)
    problem = pose_problem(pose) or ("" if pose.top is not None else "it needs a top")
    if problem:
        raise InputError(f"{asset.asset_id} cannot be turned so: {problem}")
    kept = asset.decision.params if asset.decision is not None else {}
    decision = AssetDecision(file=file, params={**kept, **pose.params})
    words = f"its {pose.front} is the front, its {pose.top} the top" if pose.front else f"its {pose.top} is the top"
    own = Effect(made_from(asset, decision), asset.asset_id, words, frozenset({"asset"}))
    return [own, *_staged_again(graph, asset.asset_id, words)]


def _model_file(asset: Asset) -> str:
    """Return the model that an asset is made from, or is to be; empty if it is none of the user's."""
    if asset.canonical is not None:
        return asset.canonical.key if asset.canonical.source == "file" else ""
    return asset.decision.file if asset.decision is not None else ""


def _refuse_person(asset: Asset) -> None:
    if asset.asset_type == "character":
        raise InputError(f"{asset.asset_id} is a person", mend="people are changed with `storyblender cast`")
    if asset.locked:
        raise InputError(f"{asset.asset_id} is locked", mend="unlock it first")


def _staged_again(graph: ContinuityMemoryGraph, asset_id: str, words: str) -> list[Effect]:
    """Return the staging of every scene that shows an asset as stale."""
    effects: list[Effect] = []
    for scene in graph.scenes:
        if asset_id in {each.asset_id for each in graph.assets_of(scene.scene_id)}:
            refuse_locked_staging(graph, scene)
            effects.append(scene_effect(graph, scene, words, "layout", ("layout",)))
    return effects
