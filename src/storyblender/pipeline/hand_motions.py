"""Motions by hand of a project: read from their files for the packs."""

from __future__ import annotations

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.memory.base import Digest, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import SceneJob
from storyblender.memory.motion_by_hand import HandMotion, MotionByHand, by_hand_file
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.run import Run
from storyblender.trace import Event


def read_motion(files: Folder, digest: Digest) -> MotionByHand | None:
    """Return the motion by hand of a name; None where the file is gone, or was changed.

    Args:
        files: The project folder.
        digest: Of the motion.
    """
    try:
        motion = MotionByHand.model_validate_json(files.path(by_hand_file(digest)).read_bytes())
    except (OSError, ValueError, InputError):
        return None
    return motion if motion.digest == digest else None


def can_be_animated(graph: ContinuityMemoryGraph, shot: ShotContext, asset_id: str) -> bool:
    """Return whether a person is on stage in a shot, or a thing is one of its scene.

    Args:
        graph: With the shot.
        shot: The shot.
        asset_id: The person or the thing, which need not be in the story.
    """
    if asset_id in shot.on_stage:
        return True
    things = {asset.asset_id for asset in graph.assets if asset.asset_type == "object"}
    return asset_id in things and asset_id in graph.scene(shot.scene_id).setup.asset_ids


def with_hand_motions(run: Run, job: SceneJob) -> SceneJob:
    """Return a job with what a person animated by hand in its shots; what cannot be read is told, and acted.

    Args:
        run: On the project.
        job: A scene.
    """
    found: list[HandMotion] = []
    for shot in job.shots:
        for asset_id, digest in shot.motion_by_hand.items():
            motion = read_motion(run.project.files, digest)
            if motion is not None:
                found.append(HandMotion(shot_id=shot.shot_id, asset_id=asset_id, motion=motion))
                continue
            name = shot_name(shot.scene_id, shot.shot_id)
            message = f"{by_hand_file(digest)} is gone or damaged, so the crew acts {asset_id} in {name}"
            run.tell(Event(kind="warning", role="animator", subject=name, message=message))
    return job.model_copy(update={"by_hand": tuple(found)}) if found else job
