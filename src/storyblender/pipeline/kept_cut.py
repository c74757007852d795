"""The cut that a person made, found again in a plan of a changed script: what is omitted, and in which order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from storyblender.memory.graph import ContinuityMemoryGraph, in_order
from storyblender.memory.history import replace
from storyblender.memory.paint import Paint

ShotKey = tuple[int, int]
"""Scene id and shot id."""


def with_cut(
    old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, matched: Mapping[ShotKey, ShotKey]
) -> ContinuityMemoryGraph:
    """Return a plan in which scenes are omitted and ordered as a person did it; what is new follows what it followed.

    Args:
        old: The graph as it is.
        plan: The new plan.
        matched: Old shots by new ones, by their words.
    """
    former = _former_scenes(plan, matched)
    for scene in plan.scenes:
        if scene.scene_id not in former:
            continue
        past = old.scene(former[scene.scene_id])
        now = {then: new for new, then in matched.items() if new[0] == scene.scene_id}
        kept = [now[past.scene_id, shot_id][1] for shot_id in past.shot_order if (past.scene_id, shot_id) in now]
        order = _ordered([shot.shot_id for shot in plan.shots_of(scene.scene_id)], kept)
        if past.omitted or order:
            plan = replace(plan, scene.model_copy(update={"omitted": past.omitted, "shot_order": order}))
    present = {then: new for new, then in former.items()}
    kept = [present[scene_id] for scene_id in old.scene_order if scene_id in present]
    order = _ordered([scene.scene_id for scene in plan.scenes], kept)
    return plan.model_copy(update={"scene_order": order, "paints": tuple(_kept_paints(old, present))})


def _kept_paints(old: ContinuityMemoryGraph, present: Mapping[int, int]) -> Iterator[Paint]:
    """Yield what a person painted, in the scenes as they are numbered now; of a scene that is gone nothing is left."""
    for paint in old.paints:
        scene_id = paint.target.scene_id
        if scene_id is None or scene_id in present:
            target = paint.target.model_copy(update={"scene_id": scene_id and present[scene_id]})
            yield paint.model_copy(update={"target": target})


def _former_scenes(plan: ContinuityMemoryGraph, matched: Mapping[ShotKey, ShotKey]) -> dict[int, int]:
    """Return the old scene with most of the words of each new one, by the new one's id; each old one once."""
    found: dict[int, int] = {}
    for scene in plan.scenes:
        pasts = Counter(past for (scene_id, _), (past, _) in matched.items() if scene_id == scene.scene_id)
        past = next((each for each, _ in pasts.most_common() if each not in found.values()), None)
        if past is not None:
            found[scene.scene_id] = past
    return found


def _ordered(known: Sequence[int], kept: Sequence[int]) -> tuple[int, ...]:
    """Return a person's order of what is left with what is new in it; empty where it is that of the script."""
    order = in_order(known, kept)
    natural = [each for each in known if each in kept]
    return () if list(kept) == natural or list(order) == list(known) else order
