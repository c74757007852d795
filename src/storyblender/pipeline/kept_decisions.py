"""What a person decided about scenes, things and takes, found again in a plan of a changed script."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from storyblender.catalog.recipe import made_from
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.kept_takes import BlockingTake
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.scene_decision import BlockingDecision
from storyblender.memory.shot_context import ShotContext, Take
from storyblender.pipeline.hand_motions import can_be_animated

_DECIDED = ("light_decision", "set_decision", "layout_decision", "layout_takes")
"""Fields of a scene that are a person's."""


def with_decided_models(old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Return a plan in which things are made from what a person decided, though all else is chosen anew.

    Args:
        old: The graph as it is.
        plan: Of other settings.
    """
    former = {asset.asset_id: asset for asset in old.assets}
    known = (asset for asset in plan.assets if asset.asset_id in former)
    return replace(plan, *(decided_as_before(asset, former[asset.asset_id]) for asset in known))


def decided_as_before(asset: Asset, past: Asset) -> Asset:
    """Return an asset with what a person decided about what it is made from, and how it looks.

    Args:
        asset: As the Director plans it.
        past: As it was.
    """
    asset = asset.model_copy(update={"look_decision": past.look_decision, "turned_down": past.turned_down})
    return asset if past.decision is None else made_from(asset, past.decision)


def with_scene_decisions(
    old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, matched: Mapping[tuple[int, int], tuple[int, int]]
) -> ContinuityMemoryGraph:
    """Return a plan in which each scene has what a person decided about the old scene with most of its words.

    Args:
        old: The graph as it is.
        plan: The new plan.
        matched: Old shots by new ones, each as (scene_id, shot_id).
    """
    for scene in plan.scenes:
        pasts = Counter(past for (scene_id, _), (past, _) in matched.items() if scene_id == scene.scene_id)
        if pasts:
            plan = _decided_as(old.scene(pasts.most_common(1)[0][0]), old, plan, scene)
    for scene in plan.scenes:  # in story order: a place keeps its set in scenes that are new
        reference = scene.setup.reference_scene_id
        if reference is not None and (decided := plan.scene(reference).set_decision) is not None:
            plan = replace(plan, scene.model_copy(update={"set_decision": decided}))
    return plan


def takes_of(planned: ShotContext, past: ShotContext) -> dict[str, object]:
    """Return the takes of an old shot as an update of the new shot with its words; their cameras are set anew.

    Args:
        planned: As the Director plans it.
        past: The old shot.
    """
    if not past.takes:
        return {}
    takes: list[Take] = []
    for take in past.takes:
        decision = take.camera_decision
        instruction = planned.camera_instruction if decision is None else decision.applied(planned.camera_instruction)
        fresh = {"camera_instruction": instruction, "camera_decision": decision, "in_frame": planned.in_frame}
        takes.append(Take(number=take.number, moment=planned.moment, **fresh))
    return {"take": past.take, "takes": tuple(takes)}


def marks_of(
    old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, planned: ShotContext, past: ShotContext
) -> dict[str, object]:
    """Return the marks that a person set in an old shot, and what they animated, for the new shot with its words.

    Those of people who are not in it any more go, and all of them where it plays in another kind of place.

    Args:
        old: The graph as it is.
        plan: The new plan.
        planned: As the Director plans it.
        past: The old shot.
    """
    moved = old.scene(past.scene_id).setup.kit != plan.scene(planned.scene_id).setup.kit
    if moved:
        return {}
    decided = _of_people(past.blocking_decision, planned)
    update: dict[str, object] = {"blocking_decision": decided} if decided is not None else {}
    if (takes := past.blocking_takes) is not None:
        others = (
            BlockingTake(number=each.number, decision=_of_people(each.decision, planned)) for each in takes.others
        )
        update["blocking_takes"] = takes.model_copy(update={"others": tuple(others)})
    moves = past.motion_by_hand
    by_hand = {name: digest for name, digest in moves.items() if can_be_animated(plan, planned, name)}
    return {**update, "motion_by_hand": by_hand} if by_hand else update


def _of_people(decision: BlockingDecision | None, planned: ShotContext) -> BlockingDecision | None:
    """Return what was decided of people who are in a shot; None for nothing."""
    people = decision.people if decision is not None else {}
    there = {name: marks for name, marks in people.items() if name in planned.on_stage}
    return BlockingDecision(people=there) if there else None


def _decided_as(
    past: SceneContext, old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, scene: SceneContext
) -> ContinuityMemoryGraph:
    decided = {name: getattr(past, name) for name in _DECIDED}
    if not any(decided.values()):
        return plan
    layout, setup, there = past.layout_decision, scene.setup, {asset.asset_id for asset in plan.assets}
    added = [old.asset(asset_id) for asset_id in (layout.added or () if layout is not None else ())]
    removed = [each for each in (layout.removed or () if layout is not None else ()) if each in there]
    ids = tuple(dict.fromkeys((*setup.asset_ids, *(asset.asset_id for asset in added))))
    scenery = tuple(dict.fromkeys((*setup.scenery, *removed)))
    if (ids, scenery) != (setup.asset_ids, setup.scenery):
        own = {asset.asset_id for asset in added}
        placed = (each for each in past.setup.relations if each.asset_id in own and each not in setup.relations)
        relations = (*setup.relations, *placed)
        decided["setup"] = setup.model_copy(update={"asset_ids": ids, "scenery": scenery, "relations": relations})
    return replace(plan, *(asset for asset in added if asset.asset_id not in there), scene.model_copy(update=decided))
