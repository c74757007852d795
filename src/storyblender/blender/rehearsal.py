"""A scene that stays in the open file between edits: things are moved, and only shots that are looked at are performed.

What it shows of a shot that is performed is what the pack of the same job shows, to the pixel. It is never saved.
"""

from __future__ import annotations

from collections.abc import Collection

import bpy

from storyblender.blender.asset_store import AssetStore
from storyblender.blender.pack import ScenePacker
from storyblender.blender.staging import moved_assets
from storyblender.memory.base import content_hash
from storyblender.memory.jobs import PackRef, SceneJob


class Rehearsal:
    """One scene in the open file, which it replaces.

    Args:
        job: The scene.
        store: The canonical assets.
    """

    def __init__(self, job: SceneJob, store: AssetStore) -> None:
        self._job, self._built = job, _built_of(job)
        self._packer = ScenePacker(job, store)
        self._packer.set_up()
        self._performed: set[int] = set()
        self._pack: PackRef | None = None

    def can_show(self, job: SceneJob) -> bool:
        """Return whether a scene is this one with things elsewhere and other motion; anything else is built anew."""
        return _built_of(job) == self._built

    def perform(self, job: SceneJob, shot_ids: Collection[int]) -> PackRef:
        """Have the scene be as a job says in some of its shots, and return what its pack is so far.

        Args:
            job: One that it can show.
            shot_ids: Staged shots of it.
        """
        if job.digest != self._job.digest:
            self._packer.move_to(job)
            self._performed.clear()
            self._pack = None
        self._job = job
        missing = [shot for shot in job.shots if shot.shot_id in shot_ids and shot.shot_id not in self._performed]
        if missing or self._pack is None:
            for shot in missing:
                self._packer.perform(shot)
                self._performed.add(shot.shot_id)
            self._pack = self._packer.finish()
            bpy.context.scene.frame_set(1)  # as a file is opened: what was evaluated before is evaluated again
        return self._pack


def _built_of(job: SceneJob) -> str:
    """Return the hash of all that cannot be changed in a scene that is built: all but places and motion."""
    fitted = {asset.asset_id for asset in job.assets if asset.fitted_part}
    layout = job.scene.layout
    assert layout is not None, "the Spatial Planner comes before the pack"
    unplaced = tuple(
        item if item.asset_id in fitted else item.model_copy(update={"location": (0, 0, 0), "rotation": (0, 0, 0)})
        for item in layout.objects
    )
    scene = job.scene.model_copy(update={"layout": layout.model_copy(update={"objects": unplaced})})
    shots = tuple(shot.model_copy(update={"blocking": (), "cues": (), "prop_states": ()}) for shot in job.shots)
    people = sorted({blocking.start.asset_id for shot in job.shots for blocking in shot.blocking})
    still = job.model_copy(update={"scene": scene, "shots": shots, "by_hand": ()})
    return content_hash(still.digest, " ".join(people), " ".join(moved_assets(job)))
