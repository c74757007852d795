"""A shot seen at once after an edit: its scene is rehearsed in Blender, its camera set alone; nothing is committed."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.camera_scene import measured_frames, shoot_scene
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.agents.layout_artist.story_moment import story_moment
from storyblender.catalog.sets import plan_of
from storyblender.memory.base import content_hash
from storyblender.memory.coverage import as_filmed, parts_of
from storyblender.memory.jobs import PackRef
from storyblender.memory.shot_context import CameraState, ShotContext
from storyblender.pipeline.filming import PackViewfinder, figures_of
from storyblender.pipeline.hand_motions import with_hand_motions
from storyblender.pipeline.packing import scene_job, with_coverage
from storyblender.pipeline.run import Run
from storyblender.pipeline.state_assets import build_states


class CamerasToMatch:
    """The cameras as they were last all set, and the faces before them: what a camera that is set alone has to match.

    Args:
        run: With all cameras set.
    """

    def __init__(self, run: Run) -> None:
        self._run, self._shots = run, {(shot.scene_id, shot.shot_id): shot for shot in as_filmed(run.graph).shots}
        self._moments: dict[tuple[int, int], Sequence[Moment]] = {}
        self.found: dict[str, CameraState] = {}
        """Cameras that were set in rehearsals, by all that they depend on: another light leaves them where they are."""

    def shot(self, shot: ShotContext) -> ShotContext | None:
        """Return a shot with its camera, or with the one it had last; None where it never had one."""
        former = self._shots.get((shot.scene_id, shot.shot_id))
        if shot.camera is not None or former is None or former.camera is None:
            return shot if shot.camera is not None else None
        return shot.model_copy(update={"camera": former.camera, "frame": former.frame})

    def moments(self, shot: ShotContext) -> Sequence[Moment]:
        """Return everybody's faces in a shot as they were then; none where they have not been measured."""
        key = (shot.scene_id, shot.shot_id)
        if key not in self._moments:
            former, pack = self._shots.get(key), self._run.packs.get(shot.scene_id)
            if former is None or pack is None or not self._run.outputs.whole(figures_of(pack)):
                return ()
            self._moments[key] = PackViewfinder(self._run, pack, (former,)).moments(former)
        return self._moments[key]


def rehearse(run: Run, shot: ShotContext) -> PackRef:
    """Have the scene of a shot be as it is staged now, in that shot, and return its pack, which is not saved.

    Args:
        run: In front; the pack is the scene's in it.
        shot: The shot; its scene is up to date.
    """
    graph, scene_id = run.graph, shot.scene_id
    shots = graph.shots_of(scene_id)
    job = with_hand_motions(run, scene_job(graph, scene_id))
    build_states(run, (job,))
    parts = [part.shot_id for part in parts_of(shots, graph.shot(scene_id, shot.shot_id))]
    pack = run.packs[scene_id] = with_coverage(graph, run.engine.rehearse(job, parts).result())
    return pack


def with_camera_in_rehearsal(run: Run, shot: ShotContext, matching: CamerasToMatch) -> ShotContext:
    """Return a shot with its camera; one that is not set is set alone, after those that are known of the shots before.

    Args:
        run: With the shot rehearsed.
        shot: As it is committed.
        matching: What cameras that are not set either were before.
    """
    if shot.camera is not None:
        return shot
    pack, graph = run.packs[shot.scene_id], as_filmed(run.graph)
    own = graph.shot(shot.scene_id, shot.shot_id)
    own = own.model_copy(update={"frame": story_moment(own, pack.played(shot.shot_id))})
    shots = list[ShotContext]()
    for each in graph.shots_in_order(shot.scene_id):
        if each.shot_id == shot.shot_id:
            break
        if (set_before := matching.shot(each)) is not None and matching.moments(each):
            shots.append(set_before)
    known = content_hash(
        pack.path, *(each.model_copy(update={"lighting": None, "lights": ()}) for each in (*shots, own))
    )
    if known in matching.found:
        return shot.model_copy(update={"camera": matching.found[known], "frame": own.frame})
    environment = graph.scene(shot.scene_id).environment
    assert environment is not None, "the set comes before the camera"
    start, viewfinder = pack.start_of(shot.shot_id), PackViewfinder(run, pack, (own,))

    def moments(each: ShotContext) -> Sequence[Moment]:
        if each.shot_id != shot.shot_id:
            return matching.moments(each)
        frames = measured_frames(own, pack.played(own.shot_id))
        figures = run.engine.read_figures(pack, [start + frame for frame in frames]).result()
        return [Moment(frame, tuple(found)) for frame, found in zip(frames, figures, strict=True)]

    states = shoot_scene(
        graph.model_copy(update={"shots": (*shots, own)}),
        shot.scene_id,
        plan_of(environment),
        measures_of(graph.assets),
        moments,
        viewfinder,
        operator=run.crew.camera_operator,
        kit=run.settings.lens_kit,
    )
    matching.found[known] = states[shot.shot_id]
    return shot.model_copy(update={"camera": states[shot.shot_id], "frame": own.frame})
