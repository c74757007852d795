"""The Asset Retriever's view of an object and the critic of what it was found to be."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator, Mapping

from pydantic import Field

from storyblender.agents.side_views import nothing_drawn
from storyblender.catalog.meanings import OVERHEAD_OUTDOORS
from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.catalog.sets import SETS
from storyblender.catalog.states import state_at_first
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetViews
from storyblender.reflection import Critique, Fault

RETRIEVAL_THRESHOLD = 7.0
"""tau of the Retriever: under it the Generator takes over (paper, section 3.3)."""
_LINES = 4
"""Lines of the script in a view."""


class AssetRetrieverView(AssetQuery):
    """The Concept Artist's view: one object, and what it must not be made from."""

    rejected: frozenset[str] = frozenset()
    """Keys of recipes that could not be built or fetched."""
    place: str = ""
    """Heading of the first place it is in."""
    lines: tuple[str, ...] = ()
    """The first lines of the script that have its name."""
    draw: Callable[[Asset], AssetViews] = Field(default=nothing_drawn, exclude=True, repr=False)
    """Draws an object. Raises NoAnswer."""


def asset_retriever_view(
    graph: ContinuityMemoryGraph,
    asset: Asset,
    means: Mapping[str, str],
    rejected: Collection[str] = (),
    draw: Callable[[Asset], AssetViews] = nothing_drawn,
) -> AssetRetrieverView:
    """Return the Concept Artist's projection of the graph: an asset with what the first place where it is says of it.

    Args:
        graph: With the Director's plan.
        asset: The object.
        means: What plain words mean in the story's age.
        rejected: Keys of recipes that could not be built or fetched.
        draw: Draws an object. Raises NoAnswer.
    """
    refused = frozenset(rejected)
    setup = next((scene.setup for scene in graph.scenes if asset.asset_id in scene.setup.asset_ids), None)
    if setup is None:
        return AssetRetrieverView(asset=asset, rejected=refused, draw=draw)
    changes = [change for shot in graph.shots for change in shot.asset_modifications if change.doors is None]
    states = [change.state for change in changes if change.asset_id == asset.asset_id and change.state]
    outdoors = setup.scene_type == "outdoor"
    overhead = OVERHEAD_OUTDOORS if outdoors and _is_overhead(graph, asset.asset_id) else {}
    return AssetRetrieverView(
        asset=asset,
        rejected=refused,
        draw=draw,
        means={**means, **SETS[setup.kit].meanings, **overhead},
        weather=setup.weather if outdoors else "",
        place=setup.place,
        lines=tuple(itertools.islice(_lines_with(graph, asset.name.lower()), _LINES)) if asset.name else (),
        state=state_at_first(states) or ("open" if _is_looked_into(graph, asset.asset_id) else ""),
    )


def _lines_with(graph: ContinuityMemoryGraph, name: str) -> Iterator[str]:
    """Yield the lines of the script with a name (small letters)."""
    for scene in graph.outline:
        for shot in scene.shots:
            yield from (line.text for line in shot.lines if name in line.text.lower())


def _is_looked_into(graph: ContinuityMemoryGraph, asset_id: str) -> bool:
    """Return whether the script tells of a thing inside another: that one is open, so that the thing is seen."""
    told = [(each.kind, each.anchor_asset_id) for scene in graph.scenes for each in scene.setup.relations]
    spots = (spot for shot in graph.shots for spot in shot.thing_spots.values())
    told += [(spot.relation, spot.anchor_id) for spot in spots if spot.anchor_id is not None]
    return ("in", asset_id) in told or ("inside", asset_id) in told


def _is_overhead(graph: ContinuityMemoryGraph, asset_id: str) -> bool:
    """Return whether the script puts a character or a thing under another thing."""
    told = [(each.kind, each.anchor_asset_id) for scene in graph.scenes for each in scene.setup.relations]
    for shot in graph.shots:
        spots = (*shot.thing_spots.values(), *(state.spot for state in shot.states if state.spot is not None))
        told += [(spot.relation, spot.anchor_id) for spot in spots if spot.anchor_id is not None]
    return ("under", asset_id) in told


class AssetRetrieverCritic:
    """Judges a recipe by how well it fits: the Retriever's is held against its threshold, the Generator's is final."""

    def judge(self, draft: Recipe, view: AssetRetrieverView) -> Critique:
        """Score the draft 1 to 10.

        Args:
            draft: Recipe with the score of its fit.
            view: The object that it is for.
        """
        if draft.source == "stand_in" or draft.final:
            return Critique(score=10.0)
        if draft.score >= RETRIEVAL_THRESHOLD:
            return Critique(score=draft.score)
        fault = Fault(
            kind="match",
            message=f"{view.phrase!r} is only {draft.score:.1f} of 10 like {draft.key!r}",
            subject=view.asset.asset_id,
            severity=10.0 - draft.score,
        )
        return Critique(score=draft.score, faults=(fault,))
