"""Edits of how a character looks: body, hair, clothes. Only the scenes that show them follow."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Final

from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.wardrobe import garment_words, look_words, put_on, take_off, worn_by
from storyblender.edits.effect import Effect, name_of, refuse_locked_staging, scene_effect, shot_names
from storyblender.edits.targets import person_named, refuse_other
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset, LookDecision
from storyblender.memory.edits import LookEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext

BODY: Final = frozenset(("gender", "age", "stature"))
"""Fields of a look on which a person's height depends, and so their marks and cameras."""
_OF_PEOPLE: Final = frozenset(("gender", "skin", "hair", "hair_color", "facial_hair", "face"))
"""Fields that an animal which acts has not."""


def look_effects(graph: ContinuityMemoryGraph, edit: LookEdit) -> list[Effect]:
    """Return what a decision about a look does to the person, and to the scenes that show them.

    Args:
        graph: The story.
        edit: The person by their id or name.

    Raises:
        InputError: There is no such person, garment or hair, or something is locked.
    """
    asset = graph.asset(person_named(graph, edit.person))
    if asset.asset_type != "character" or asset.look is None:
        raise InputError(f"{asset.asset_id} is a thing", mend="things are changed with `storyblender asset`")
    if asset.locked:
        raise InputError(f"{asset.asset_id} is locked", mend="unlock it first")
    decision = _with_clothes(asset, edit)
    _refuse_unknown(asset, decision)
    worn = [f"puts on {garment_words(each)}" for each in edit.wear]
    worn += [f"takes off {each.replace('_', ' ')}" for each in edit.take_off]
    said = look_words(edit.decision)
    words = f"look: {'; '.join([*([said] if said else []), *worn])}"
    return _looks(graph, asset, (asset.look_decision or LookDecision()).then(decision), words)


def look_given_back(graph: ContinuityMemoryGraph, asset: Asset) -> list[Effect]:
    """Return what unlocking a person does: they look as the script says again."""
    freed = asset.model_copy(update={"locked": False})
    if asset.decision is not None:
        update = {"look_decision": None, "decision": None, "canonical": None, "dimension": None}
        own = Effect(freed.model_copy(update=update), asset.asset_id, "unlocked", frozenset({"asset"}))
        scenes = [scene for scene in graph.scenes if asset.asset_id in scene.setup.asset_ids]
        return [own, *(scene_effect(graph, scene, "unlocked", "layout", ("motion",)) for scene in scenes)]
    if asset.look_decision is None:
        return [Effect(freed, asset.asset_id, "unlocked", frozenset({"asset"}))]
    return _looks(graph, freed, None, "unlocked")


def _looks(graph: ContinuityMemoryGraph, asset: Asset, decision: LookDecision | None, words: str) -> list[Effect]:
    """Return what a person's look does: they are built anew; where their height may change, they are staged anew."""
    changed = asset.model_copy(update={"look_decision": decision})
    if changed.decided_look == asset.decided_look:
        return [Effect(changed, asset.asset_id, words, frozenset({"asset"}))]
    update: dict[str, Any] = {"canonical": None}
    before, now = asset.decided_look, changed.decided_look
    grown = any(getattr(before, name) != getattr(now, name) for name in BODY)
    update |= {"dimension": None} if grown else {}
    scenes = [scene for scene in graph.scenes if asset.asset_id in scene.setup.asset_ids]
    stale = tuple(name for scene in scenes for name in shot_names(graph, scene.scene_id))
    own = Effect(changed.model_copy(update=update), asset.asset_id, words, frozenset({"asset"}), stale)
    if asset.decision is not None and decision is not None and decision.told.keys() - {"stature"}:
        own = own.warned((f"{asset.asset_id} is made from {asset.decision.file}, which keeps its own looks",))
    if not grown:
        return [own.warned(tuple(_approved(graph, scenes)))]
    for scene in scenes:
        refuse_locked_staging(graph, scene)
    return [own, *(scene_effect(graph, scene, words, "layout", ("motion",)) for scene in scenes)]


def _approved(graph: ContinuityMemoryGraph, scenes: Iterable[SceneContext]) -> Iterator[str]:
    """Yield what a person should know of shots that they approved and that show the person otherwise now."""
    for scene in scenes:
        for shot in graph.shots_of(scene.scene_id):
            if shot.approved is not None:
                yield f"{name_of(shot)} is approved, and is drawn anew"


def _with_clothes(asset: Asset, edit: LookEdit) -> LookDecision:
    """Return a decision with all that a person wears once something is put on or taken off."""
    if not edit.wear and not edit.take_off:
        return edit.decision
    outfit = worn_by(asset) if edit.decision.garments is None else edit.decision.garments
    for key in edit.take_off:
        refuse_other(key, f"garment on {asset.asset_id}", [each.key for each in outfit])
    outfit = take_off(outfit, edit.take_off)
    for garment in edit.wear:
        refuse_other(garment.key, "garment", GARMENTS)
        outfit = put_on(outfit, garment)
    return edit.decision.model_copy(update={"garments": outfit})


def _refuse_unknown(asset: Asset, decision: LookDecision) -> None:
    """Refuse what the catalogue has not, and what an animal has not."""
    if not decision.told:
        raise InputError(f"nothing is decided about {asset.asset_id}", mend="give an age, hair, clothes ...")
    if asset.look is not None and asset.look.species and (odd := decision.told.keys() & _OF_PEOPLE):
        raise InputError(f"{asset.asset_id} is a {asset.look.species}", mend=f"it has no {min(odd).replace('_', ' ')}")
    if decision.hair is not None:
        refuse_other(decision.hair, "hair", HAIRSTYLES)
    for garment in decision.garments or ():
        refuse_other(garment.key, "garment", GARMENTS)
