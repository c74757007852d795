"""Scenes that stay in the open file between edits: things are moved, and only what is looked at is performed.

A shot is posed exactly at the frames that are looked at, and roughly between them. What it shows there is what the pack
of the same job shows, within the tolerance of baked keys (``motion.bake``). It is never saved.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.motion.solve import SolvedShot
from storyblender.blender.pack import ScenePacker, begin_file, shot_starts
from storyblender.blender.staging import moved_assets
from storyblender.memory.base import content_hash
from storyblender.memory.jobs import PackRef, SceneJob

ROUGHLY = 8
"""Frames between poses where nothing is looked at."""
MOST_SCENES = 6
"""Scenes that are kept at most; the least recently used one is removed for another, so that memory is bounded."""


class Rehearsals:
    """The rehearsed scenes of the open file, which they replace; each stays as it is while others are rehearsed.

    Args:
        store: The canonical assets.
    """

    def __init__(self, store: AssetStore) -> None:
        self._store = store
        self._scenes: dict[int, Rehearsal] = {}
        self._empty = begin_file()

    def perform(self, job: SceneJob, shot_ids: Collection[int]) -> PackRef:
        """Have a scene be as a job says in some of its shots, and return what its pack is so far.

        Args:
            job: The scene.
            shot_ids: Staged shots of it.
        """
        scene_id = job.scene.scene_id
        known = self._scenes.get(scene_id)
        if known is not None and not known.can_show(job):
            known = self._forget(scene_id)
        if known is None:
            if len(self._scenes) >= MOST_SCENES:
                self._forget(next(iter(self._scenes)))
            known = Rehearsal(job, self._store, self._empty.copy())
        self._scenes.pop(scene_id, None)
        self._scenes[scene_id] = known  # the last
        return known.perform(job, shot_ids)

    def _forget(self, scene_id: int) -> None:
        """Remove a scene from the file."""
        bpy.context.window.scene = self._empty
        self._scenes.pop(scene_id).remove()
        bpy.data.orphans_purge(do_recursive=True)

    def pose(self, scene_id: int, frames: Iterable[int]) -> None:
        """Have a scene show frames of its timeline exactly, where its shots are performed."""
        self._scenes[scene_id].pose(frames)


class Rehearsal:
    """One scene in the open file.

    Args:
        job: The scene.
        store: The canonical assets.
        scene: Empty; it becomes the scene.
    """

    def __init__(self, job: SceneJob, store: AssetStore, scene: bpy.types.Scene) -> None:
        self._job, self._built, self._scene = job, _built_of(job), scene
        self._packer = ScenePacker(job, store)
        self._packer.set_up(scene)
        self._solved: dict[int, SolvedShot] = {}
        self._posed: dict[int, frozenset[int]] = {}
        """Frames from the start of each shot that are baked exactly."""

    def can_show(self, job: SceneJob) -> bool:
        """Return whether a scene is this one with things elsewhere and other motion; anything else is built anew."""
        return _built_of(job) == self._built

    def perform(self, job: SceneJob, shot_ids: Collection[int]) -> PackRef:
        """Have the scene be as a job says, with some of its shots solved, and return what its pack is so far.

        Args:
            job: One that it can show.
            shot_ids: Staged shots of it.
        """
        bpy.context.window.scene = self._scene
        if job.digest != self._job.digest:
            self._packer.move_to(job)
            self._solved.clear()
            self._posed.clear()
        self._job = job
        for shot in job.shots:
            if shot.shot_id in shot_ids and shot.shot_id not in self._solved:
                self._solved[shot.shot_id] = self._packer.solve(shot)
        return self._packer.reference()

    def remove(self) -> None:
        """Remove the scene from the file."""
        self._packer.remove_motion()
        parts = self._scene.collection.children_recursive
        bpy.data.batch_remove({*self._scene.collection.all_objects, *parts, self._scene})

    def pose(self, frames: Iterable[int]) -> None:
        """Have the scene show frames of its timeline exactly, where its shots are performed."""
        starts, posed = shot_starts(self._job.shots), False
        for shot in self._job.shots:
            own = {frame - starts[shot.shot_id] for frame in frames} & set(range(shot.duration))
            known = self._posed.get(shot.shot_id, frozenset())
            if shot.shot_id in self._solved and not own <= known:
                exact = self._posed[shot.shot_id] = known | own | {*range(0, shot.duration, ROUGHLY), shot.duration - 1}
                self._packer.pose(shot, self._solved[shot.shot_id], sorted(exact))
                posed = True
        if posed:
            self._packer.finish()
            self._scene.frame_set(1)  # as a file is opened: what was evaluated before is evaluated again


_UNMOVED = {"blocking": (), "cues": (), "prop_states": (), "duration": 1}
"""Fields of a shot that may differ without building its scene anew, as they are without motion."""


def _built_of(job: SceneJob) -> str:
    """Return the hash of all that cannot be changed in a scene that is built: all but places, motion and lengths."""
    fitted = {asset.asset_id for asset in job.assets if asset.fitted_part}
    layout = job.scene.layout
    assert layout is not None, "the Spatial Planner comes before the pack"
    unplaced = tuple(
        item if item.asset_id in fitted else item.model_copy(update={"location": (0, 0, 0), "rotation": (0, 0, 0)})
        for item in layout.objects
    )
    scene = job.scene.model_copy(update={"layout": layout.model_copy(update={"objects": unplaced})})
    shots = tuple(shot.model_copy(update=_UNMOVED) for shot in job.shots)
    people = sorted({blocking.start.asset_id for shot in job.shots for blocking in shot.blocking})
    still = job.model_copy(update={"scene": scene, "shots": shots, "by_hand": ()})
    return content_hash(still.digest, " ".join(people), " ".join(moved_assets(job)))
