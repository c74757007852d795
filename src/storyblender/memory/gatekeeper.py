"""The Gatekeeper: V(o_new, S_exist) -> {0, 1} (paper, section 3.2). Nothing enters the graph past it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from storyblender.errors import Rejected
from storyblender.memory.base import ADDED_FROM, staged_id
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Change, key_of
from storyblender.memory.keeping import lock_violations
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext


class Gatekeeper:
    """Judges a new state against the existing one.

    Args:
        existing: The graph as it is committed (S_exist).
        motions: Keys of the motions that there are; None lets any pass.
    """

    def __init__(self, existing: ContinuityMemoryGraph, motions: Collection[str] | None = None) -> None:
        self.existing, self.motions = existing, motions

    def admit(self, graph: ContinuityMemoryGraph, changes: Sequence[Change], author: str = "user") -> None:
        """Let the new state in, or raise.

        Only what changed is checked, except where something was removed: then every reference is.

        Args:
            graph: The proposed graph.
            changes: What differs from the existing one.
            author: Who proposes it; what a person decided, the crew leaves alone.

        Raises:
            Rejected: With one sentence per violation.
        """
        violations = tuple(self._violations(graph, changes, author))
        if violations:
            raise Rejected(violations)

    def _violations(self, graph: ContinuityMemoryGraph, changes: Sequence[Change], author: str) -> Iterator[str]:
        removed = any(change.after is None for change in changes)
        touched = {(change.layer, change.key) for change in changes}
        yield from _faulty_references(graph, None if removed else touched)
        for shot in graph.shots:
            if self.motions is not None and ("shots", key_of(shot)) in touched:
                for motion in sorted(shot.motions.difference(self.motions)):
                    yield f"shot {shot.scene_id}/{shot.shot_id}: there is no motion {motion!r}"
        if author == "director":  # another reading of the script moves shots; ``revise`` keeps locks with their words
            return
        for layer in ("assets", "scenes", "shots"):
            proposed = {key_of(item): item for item in getattr(graph, layer)}
            for old in getattr(self.existing, layer):
                key = key_of(old)
                if (layer, key) in touched and key in proposed:
                    yield from lock_violations(old, proposed[key], author)


def faults_of(graph: ContinuityMemoryGraph) -> Iterator[str]:
    """Yield one sentence for everything that is wrong in a whole graph, as one that was just read."""
    yield from _faulty_references(graph, None)
    planned = [f"{scene.scene_id}/{shot.shot_id}" for scene in graph.outline for shot in scene.shots]
    yield from _duplicates("outline of shot", planned)
    made = {f"{shot.scene_id}/{shot.shot_id}" for shot in graph.shots}
    for name in planned:
        if name not in made:
            yield f"the outline has shot {name}, which does not exist"


def _faulty_references(
    graph: ContinuityMemoryGraph, touched: set[tuple[str, tuple[int | str, ...]]] | None
) -> Iterator[str]:
    """Yield duplicates and references to items that do not exist.

    Args:
        graph: The graph.
        touched: Layer and key of the scenes and shots to check; None checks all.
    """
    assets = {asset.asset_id for asset in graph.assets}
    scenes = {scene.scene_id: scene for scene in graph.scenes}
    yield from _duplicate_items(graph)
    yield from _cast_violations(graph, assets)
    yield from _coverage_violations(graph)
    for scene in graph.scenes:
        if touched is None or ("scenes", (scene.scene_id,)) in touched:
            yield from _scene_violations(scene, scenes, assets)
    for shot in graph.shots:
        if touched is None or ("shots", (shot.scene_id, shot.shot_id)) in touched:
            yield from _shot_violations(shot, scenes, assets)


def _duplicate_items(graph: ContinuityMemoryGraph) -> Iterator[str]:
    yield from _duplicates("asset", [asset.asset_id for asset in graph.assets])
    yield from _duplicates("scene", [str(scene.scene_id) for scene in graph.scenes])
    yield from _duplicates("outline of scene", [str(scene.scene_id) for scene in graph.outline])
    yield from _duplicates("shot", [f"{shot.scene_id}/{shot.shot_id}" for shot in graph.shots])


def _coverage_violations(graph: ContinuityMemoryGraph) -> Iterator[str]:
    """Yield what is wrong with shots that a person split off, added or joined."""
    staged = {(shot.scene_id, shot.shot_id) for shot in graph.shots if shot.covers is None}
    first = dict(sorted(staged, reverse=True))
    for shot in graph.shots:
        name = f"shot {shot.scene_id}/{shot.shot_id}"
        if (shot.covers is None) != (shot.shot_id < ADDED_FROM):
            yield f"{name} has the number of a shot of another kind"
        elif shot.covers is not None and (shot.scene_id, staged_id(shot.shot_id)) not in staged:
            yield f"{name} shows a part of a shot that does not exist"
        elif shot.joined and (shot.covers is not None or shot.shot_id == first[shot.scene_id]):
            yield f"{name} is joined to no shot before it"


def _cast_violations(graph: ContinuityMemoryGraph, assets: set[str]) -> Iterator[str]:
    for asset in graph.assets:
        if asset.reference_character and asset.reference_character not in assets:
            yield f"{asset.asset_id} refers to an unknown character {asset.reference_character!r}"


def _duplicates(what: str, names: list[str]) -> Iterator[str]:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            yield f"{what} {name!r} exists twice"
        seen.add(name)


def _scene_violations(scene: SceneContext, scenes: dict[int, SceneContext], assets: set[str]) -> Iterator[str]:
    name = f"scene {scene.scene_id}"
    reference = scene.setup.reference_scene_id
    if reference is not None and (reference not in scenes or reference >= scene.scene_id):
        yield f"{name} refers to scene {reference}, which is not an earlier one"
    for asset_id in (*scene.setup.asset_ids, *scene.setup.scenery):
        if asset_id not in assets:
            yield f"{name} uses {asset_id!r}, which is not on the asset sheet"
    if scene.layout is None:
        return
    nodes = {item.node_id for item in scene.layout.objects}
    yield from _duplicates(f"{name}: node", [item.node_id for item in scene.layout.objects])
    for item in scene.layout.objects:
        if item.asset_id not in assets:
            yield f"{name}: {item.node_id} shows {item.asset_id!r}, which is not on the asset sheet"
        if item.anchor_asset_id is not None and item.anchor_asset_id not in nodes:
            yield f"{name}: {item.node_id} is anchored to {item.anchor_asset_id!r}, which is not in the layout"


def _shot_violations(shot: ShotContext, scenes: dict[int, SceneContext], assets: set[str]) -> Iterator[str]:
    name = f"shot {shot.scene_id}/{shot.shot_id}"
    if shot.scene_id not in scenes:
        yield f"{name} belongs to a scene that does not exist"
    people = {
        *shot.on_stage,
        *shot.in_frame,
        *(state.asset_id for state in shot.states),
        *(action.asset_id for action in shot.character_actions),
        *(mark.start.asset_id for mark in shot.blocking),
        *(state.asset_id for state in shot.prop_states),
    }
    for asset_id in sorted(people - assets):
        yield f"{name} uses {asset_id!r}, which is not on the asset sheet"
    layout = scenes[shot.scene_id].layout if shot.scene_id in scenes else None
    known = assets | {item.node_id for item in (layout.objects if layout else ())}
    for focus in (shot.camera_instruction.focus, shot.camera_instruction.focus_to):
        if focus is not None and focus not in known:
            yield f"{name} is focused on {focus!r}, which does not exist"
    if shot.camera is not None and not shot.camera.poses:
        yield f"{name} has a camera without a pose"
    for cue in shot.cues:
        if cue.asset_id not in assets:
            yield f"{name}: a cue for {cue.asset_id!r}, which is not on the asset sheet"
