"""Things that change during a scene: a part for every state, visible from the moment of the change on."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.sections import fitted_in, split_sections
from storyblender.blender.tags import surface_of, tag
from storyblender.look.surface import Surface
from storyblender.memory.jobs import AssetInState, PlayedCue, SceneJob
from storyblender.memory.shot_context import ShotContext
from storyblender.memory.thing_states import Condition

Shown = list[tuple[int, bool]]
Part = tuple[bpy.types.Object, AssetInState]


class StateParts:
    """Objects that show the states of a scene's things, parented to them.

    Args:
        job: The scene.
        store: The built parts.
        nodes: The placed objects of each asset, by asset id.
    """

    def __init__(self, job: SceneJob, store: AssetStore, nodes: Mapping[str, Sequence[bpy.types.Object]]) -> None:
        self._job, self._nodes = job, nodes
        self._found = job.scene.setup.found
        self._parts: dict[str, dict[Condition, list[Part]]] = {}
        for each in job.in_states:
            for thing in nodes.get(each.asset.asset_id, ()):
                parts = self._parts.setdefault(thing.name, {}).setdefault(each.condition, [])
                parts.append((_part(thing, each, store), each))
        stated = {change.asset_id for shot in job.shots for change in shot.asset_modifications if change.state}
        self._changing = [name for name in nodes if name in stated or name in self._found]

    @property
    def changing(self) -> Sequence[str]:
        """Asset ids of things that change, or that begin the scene in a state."""
        return self._changing

    def follow(self, job: SceneJob) -> None:
        """Take over a later version of the scene, in which the same things come into the same states."""
        self._job = job

    def visibility(
        self, asset_id: str, seen: Mapping[int, bool], timing: Sequence[PlayedCue]
    ) -> Iterator[tuple[bpy.types.Object, Shown]]:
        """Yield a thing's objects and their parts, each with (frame, whether it is visible from there on).

        Args:
            asset_id: The thing.
            seen: First frame of each shot -> whether the thing is visible in it at all.
            timing: Actual timing of the shots' cues.
        """
        changes = dict(self._changes(asset_id, list(seen), timing)) if asset_id in self._changing else {}
        frames = sorted({*seen, *changes})
        for thing in self._nodes[asset_id]:
            parts = self._parts.get(thing.name, {})
            there: Shown = []
            of_part: dict[str, Shown] = {}
            now, visible = self._found.get(asset_id, Condition()), True
            for frame in frames:
                visible, now = seen.get(frame, visible), changes.get(frame, now)
                here = visible and "gone" not in now.states
                replaced = any(not each.added for _, each in parts.get(now, ()))
                there.append((frame, here and not replaced))
                for condition, objects in parts.items():
                    for part, _ in objects:
                        of_part.setdefault(part.name, []).append((frame, here and condition == now))
            yield thing, there
            for part, _ in (pair for pairs in parts.values() for pair in pairs):
                yield part, of_part[part.name]

    def _changes(
        self, asset_id: str, starts: Sequence[int], timing: Sequence[PlayedCue]
    ) -> Iterator[tuple[int, Condition]]:
        """Yield (frame, condition) for each change of a thing, in the middle of the action that causes it."""
        now = self._found.get(asset_id, Condition())
        for start, shot in zip(starts, self._job.shots, strict=True):
            for change in shot.asset_modifications:
                if change.asset_id == asset_id and change.state:
                    now = now.after(change.state, change.writing, change.doors)
                    yield start + self._moment(shot, asset_id, timing), now

    def _moment(self, shot: ShotContext, asset_id: str, timing: Sequence[PlayedCue]) -> int:
        """Return the frame of a shot at which a thing changes."""
        names = {asset_id, *(str(thing["node_id"]) for thing in self._nodes[asset_id])}
        deeds = {(cue.asset_id, cue.clip, cue.start) for cue in shot.cues if {cue.prop_id, cue.target_id} & names}
        played = [
            (each.began + each.over) // 2
            for each in timing
            if each.shot_id == shot.shot_id
            and (each.asset_id, each.clip, each.start) in deeds
            and each.clip not in _IDLE
        ]
        return min(max(played, default=0), shot.duration - 1)


def _part(thing: bpy.types.Object, each: AssetInState, store: AssetStore) -> bpy.types.Object:
    """Return a new object for a state of a thing; level parts are turned back under a thing on its side."""
    name = f"{thing.name}.{'_'.join(each.condition.labels).replace(' ', '_')[:30]}"
    part = bpy.data.objects.new(name, store.append_mesh(each.asset))
    part.parent = thing
    x, y, z = each.location
    part.location = (x, z, -y) if each.lying else (x, y, z)
    part.rotation_euler[0] = math.radians(-90.0) if each.lying else 0.0
    surface = surface_of(part) if surface_of(part) == Surface.SMOKE else thing["surface"]
    tag(part, kind="prop", node_id=thing["node_id"], asset_id=each.asset.asset_id, surface=surface)
    for collection in thing.users_collection:
        collection.objects.link(part)
    split_sections(part, fitted_in(thing))
    return part


_IDLE = frozenset({"look", "walk", "run", "face"})
"""Clips that change nothing."""
