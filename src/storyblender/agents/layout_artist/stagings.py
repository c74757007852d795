"""Other stagings of a scene: which ones are tried, and which of them is taken."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.memory.scene_context import Layout, SceneContext
from storyblender.reflection import Outcome

_TRIED = 4
"""Layouts of which a staging is the best."""

Staged = Outcome[SpatialPlannerView, Layout]


def stagings_to_try(scene: SceneContext) -> range:
    """Return the numbers of the layouts to try for a scene: the usual one, or some others if a person wants another.

    Args:
        scene: With the staging that a person decided, if they did.
    """
    wanted = scene.layout_decision.staging if scene.layout_decision is not None else None
    first = _TRIED * ((wanted or 0) - 1) + 1
    return range(first, first + _TRIED) if wanted else range(1)


def most_different(tried: Sequence[Staged], present: Layout | None, threshold: float) -> Staged:
    """Return the layout with the fewest faults; of several that pass, the one that differs most from the present one.

    Args:
        tried: In order of their numbers; at least one.
        present: The layout as it is; None if there is none.
        threshold: Score from which a layout passes.
    """

    def rank(staged: Staged) -> tuple[float, float]:
        people = [each for each, measure in staged.view.measures.items() if measure.asset_type == "character"]
        moved = difference(staged.draft, present, people), difference(staged.draft, present)
        return min(staged.critique.score, threshold), round(moved[0] or moved[1], 3)

    return max(tried, key=rank)


def difference(layout: Layout, present: Layout | None, among: Collection[str] | None = None) -> float:
    """Return how far apart two layouts are: the mean distance in metres of what stands in both, but for furniture.

    Args:
        layout: One layout.
        present: The other; with None there is no difference.
        among: Ids of the people or things that count; None counts all.
    """
    before = {item.node_id: item for item in present.objects} if present is not None else {}
    moved = [
        math.dist(item.location, before[item.node_id].location)
        for item in layout.objects
        if item.node_id in before and not item.node_id.startswith("set_")
        if among is None or item.asset_id in among
    ]
    return sum(moved) / len(moved) if moved else 0.0
