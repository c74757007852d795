"""The Spatial Planner's view of a scene: its projection of the graph."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from storyblender.agents.layout_artist.scripted_spots import find_scripted_spots
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.props.prop_names import props_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSetup, Spot
from storyblender.memory.shot_context import BodyState, ShotContext

_RESTING = ("idle", "stand", "sit", "lean")
"""Motions of people who are somewhere and do nothing else."""


@dataclass(frozen=True)
class SpatialPlannerView:
    """The Spatial Planner's view of one scene.

    Attributes:
        scene_id: Number of the scene.
        setup: The scene's people and things, and their relations.
        measures: By asset id, for everything that may be placed.
        plan: The set.
        dressed: Furniture that the Set Dresser has already placed.
        pending: Asset ids of the things that need a place.
        states: Postures of the people on stage when the scene begins.
        groups: Groups of people in conversation, the most talkative first.
        targets: Asset ids of things that people walk to, sit on or handle later: they stay reachable.
        reference: The layout of an earlier scene in the same place.
        seed: Random seed of the solver.
        placements: ``floor``, ``surface``, ``wall`` or ``ceiling`` by asset id, where the catalog knows it.
        handlers: People who take a thing into their hands, in order, by the thing's asset id.
        companions: People placed beside another as the scene begins: companion -> the person the script places.
        found_later: States of people whom a later shot shows in place without an entrance: jurors, guests.
        resting_places: Ids of things at which people are first seen at rest, by asset id: the dock, the door.
        props: Catalog keys by asset id.
        scripted_spots: Spots of things in the script, by asset id.
        first_actions: Motions that each person does on the spot in their first shot, each with its prop.
        distance_scale: Factor on distances between people who stand together.
        outline: The lines of the scene.
        staging: Number of another staging, in which people act elsewhere and stand the other way round; 0 is the first.
    """

    scene_id: int
    setup: SceneSetup
    measures: Mapping[str, AssetMeasure]
    plan: SetPlan
    dressed: tuple[LayoutObject, ...] = ()
    pending: tuple[str, ...] = ()
    states: tuple[BodyState, ...] = ()
    found_later: tuple[BodyState, ...] = ()
    groups: tuple[tuple[str, ...], ...] = ()
    targets: tuple[str, ...] = ()
    reference: Layout | None = None
    seed: int = 0
    placements: Mapping[str, str] = field(default_factory=dict)
    handlers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    companions: Mapping[str, str] = field(default_factory=dict)
    resting_places: Mapping[str, str] = field(default_factory=dict)
    props: Mapping[str, str] = field(default_factory=dict)
    scripted_spots: Mapping[str, Spot] = field(default_factory=dict)
    first_actions: Mapping[str, tuple[tuple[str, str | None], ...]] = field(default_factory=dict)
    distance_scale: float = 1.0
    outline: SceneOutline | None = None
    staging: int = 0


def measures_of(assets: Iterable[Asset]) -> dict[str, AssetMeasure]:
    """Return the measures of all assets that have geometry, by asset id."""
    return {
        asset.asset_id: AssetMeasure(
            asset_id=asset.asset_id,
            digest=asset.canonical.digest,
            geometry_hash=asset.canonical.geometry_hash,
            dimensions=asset.canonical.dimensions,
            anchors=asset.canonical.anchors,
            asset_type=asset.asset_type,
        )
        for asset in assets
        if asset.canonical is not None
    }


def spatial_planner_view(
    graph: ContinuityMemoryGraph,
    scene_id: int,
    plan: SetPlan,
    dressed: tuple[LayoutObject, ...] = (),
    pending: tuple[str, ...] | None = None,
    placements: Mapping[str, str] | None = None,
    distance_scale: float = 1.0,
    staging: int = 0,
) -> SpatialPlannerView:
    """Return the Spatial Planner's projection of the graph.

    Args:
        graph: The graph, with the Director's scenes and shots, and the assets already built.
        scene_id: Number of the scene.
        plan: Its set.
        dressed: Furniture that the Set Dresser has placed.
        pending: Asset ids of things to place; None takes every object of the scene that is not dressed.
        placements: ``floor``, ``surface``, ``wall`` or ``ceiling`` by asset id.
        distance_scale: Factor on the distances between people who stand together.
        staging: Number of another staging; 0 is the first one.
    """
    scene, shots = graph.scene(scene_id), graph.staged_shots_of(scene_id)
    objects = {asset.asset_id for asset in graph.assets if asset.asset_type == "object"}
    standing = {item.asset_id for item in dressed}
    first = shots[0] if shots else None
    held = {asset_id for state in (first.states if first else ()) for asset_id in state.held}
    if pending is None:
        pending = tuple(asset_id for asset_id in scene.setup.asset_ids if asset_id in objects - standing)
    talk: dict[tuple[str, ...], int] = {}
    for shot in shots:
        if shot.camera_instruction.axis is not None:
            pair = tuple(sorted(shot.camera_instruction.axis))
            talk[pair] = talk.get(pair, 0) + 1
    targets = [
        wanted
        for shot in shots
        for action in shot.character_actions
        for wanted in (action.target_id, action.prop_id)
        if wanted in objects
    ]
    handlers: dict[str, tuple[str, ...]] = {}
    for shot in shots:
        for action in shot.character_actions:
            if action.prop_id in objects:
                handlers[action.prop_id] = (*handlers.get(action.prop_id, ()), action.asset_id)
    reference = scene.setup.reference_scene_id
    return SpatialPlannerView(
        scene_id=scene_id,
        setup=scene.setup,
        measures=measures_of(graph.assets),
        plan=plan,
        dressed=dressed,
        pending=tuple(asset_id for asset_id in pending if asset_id not in held),
        states=tuple(state for state in first.states if state.asset_id in first.on_stage) if first else (),
        groups=tuple(sorted(talk, key=lambda pair: (-talk[pair], pair))),
        targets=tuple(dict.fromkeys(str(target) for target in targets)),
        reference=graph.scene(reference).layout if reference is not None else None,
        seed=graph.format.seed,
        placements=placements or {},
        handlers=handlers,
        companions=_companions(first) if first is not None else {},
        found_later=_people_found_later(shots),
        resting_places=_resting_places(shots),
        props=props_of(graph.assets),
        scripted_spots=find_scripted_spots(scene.setup, shots),
        first_actions=_first_actions(shots, props_of(graph.assets)),
        distance_scale=distance_scale,
        staging=staging,
        outline=graph.outline_of(scene_id),
    )


def _people_found_later(shots: Sequence[ShotContext]) -> tuple[BodyState, ...]:
    """Return the first state of everybody who is first seen in a later shot without walking in."""
    seen = {*shots[0].on_stage} if shots else set[str]()
    found: list[BodyState] = []
    for shot in shots[1:]:
        come = {action.asset_id for action in shot.character_actions if MOTIONS[action.motion].speed}
        found += [state for state in shot.states if state.asset_id in {*shot.on_stage} - seen - come]
        seen |= {*shot.on_stage}
    return tuple(found)


def _resting_places(shots: Sequence[ShotContext]) -> dict[str, str]:
    """Return the id of the thing at which each person is first seen at rest."""
    seen: set[str] = set()
    places: dict[str, str] = {}
    for shot in shots:
        for action in shot.character_actions:
            if action.asset_id not in seen and action.motion in _RESTING and action.target_id is not None:
                places.setdefault(action.asset_id, action.target_id)
        seen |= {*shot.on_stage}
    return places


def _first_actions(
    shots: Sequence[ShotContext], props: Mapping[str, str]
) -> dict[str, tuple[tuple[str, str | None], ...]]:
    """Return each person's actions on the spot, with their props, in the first shot that shows them."""
    actions_of: dict[str, tuple[tuple[str, str | None], ...]] = {}
    for shot in shots:
        done: dict[str, list[tuple[str, str | None]]] = {person: [] for person in shot.on_stage}
        for action in shot.character_actions:
            if MOTIONS[action.motion].speed is None and action.asset_id in done:
                done[action.asset_id].append((action.motion, props.get(action.prop_id or action.target_id or "")))
        for person, motions in done.items():
            actions_of.setdefault(person, tuple(motions))
    return actions_of


def _companions(first: ShotContext) -> dict[str, str]:
    """Return the person beside whom each companion stands as the scene begins."""
    found: dict[str, str] = {}
    for action in first.character_actions:
        for companion in action.company if action.motion in _RESTING else ():
            found.setdefault(companion, action.asset_id)
    return found
