"""Things that change during a scene: a part for every state, seen from the moment of the change on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.tags import tag
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import PlayedCue, SceneJob
from storyblender.memory.shot_context import ShotContext

Shown = list[tuple[int, bool]]


class StateParts:
    """The parts of the things of a scene that show their states; each goes where its thing goes.

    Args:
        job: The scene.
        store: Where the parts are.
        props: The placed objects, by asset id.
        assets: Of the scene, by asset id.
    """

    def __init__(
        self, job: SceneJob, store: AssetStore, props: Mapping[str, bpy.types.Object], assets: Mapping[str, Asset]
    ) -> None:
        self._job, self._props = job, props
        self._parts: dict[str, dict[str, tuple[bpy.types.Object, bool]]] = {}
        for each in job.in_states:
            thing = props.get(each.asset.asset_id)
            if thing is None:
                continue
            part = bpy.data.objects.new(f"{thing.name}.{each.state.replace(' ', '_')}", store.append_mesh(each.asset))
            part.parent = thing
            tag(part, kind="prop", node_id=thing["node_id"], asset_id=each.asset.asset_id, surface=thing["surface"])
            for collection in thing.users_collection:
                collection.objects.link(part)
            self._parts.setdefault(each.asset.asset_id, {})[each.state] = part, each.added

    @property
    def changing(self) -> Sequence[str]:
        """Asset ids of what changes."""
        return list(self._parts)

    def shown(
        self, asset_id: str, seen: Mapping[int, bool], timing: Sequence[PlayedCue]
    ) -> Iterator[tuple[bpy.types.Object, Shown]]:
        """Yield a thing and each of its parts with the frames from which on they are seen or not.

        Args:
            asset_id: The thing.
            seen: First frame of each shot, and whether the thing is seen in it at all.
            timing: When the cues of the shots were played.
        """
        parts = self._parts.get(asset_id, {})
        changes = dict(self._changes(asset_id, list(seen), timing)) if parts else {}
        frames = sorted({*seen, *changes})
        there: dict[str | None, Shown] = {state: [] for state in (None, *parts)}
        now, visible = "", True
        for frame in frames:
            visible, now = seen.get(frame, visible), changes.get(frame, now)
            replaced = now in parts and not parts[now][1]
            there[None].append((frame, visible and not replaced))
            for state in parts:
                there[state].append((frame, visible and state == now))
        yield self._props[asset_id], there[None]
        for state, (part, _) in parts.items():
            yield part, there[state]

    def _changes(self, asset_id: str, starts: Sequence[int], timing: Sequence[PlayedCue]) -> Iterator[tuple[int, str]]:
        """Yield the frames at which a thing comes into its states: in the middle of the deed that brings it there."""
        for start, shot in zip(starts, self._job.shots, strict=True):
            for change in shot.asset_modifications:
                if change.asset_id == asset_id and change.state:
                    yield start + self._moment(shot, asset_id, timing), change.state

    def _moment(self, shot: ShotContext, asset_id: str, timing: Sequence[PlayedCue]) -> int:
        node = str(self._props[asset_id]["node_id"])
        deeds = {
            (cue.asset_id, cue.clip, cue.start) for cue in shot.cues if {cue.prop_id, cue.target_id} & {asset_id, node}
        }
        played = [
            (each.began + each.over) // 2
            for each in timing
            if each.shot_id == shot.shot_id
            and (each.asset_id, each.clip, each.start) in deeds
            and each.clip not in _IDLE
        ]
        return min(max(played, default=0), shot.duration - 1)


_IDLE = frozenset({"look", "walk", "run", "face"})
"""Clips that change nothing."""
