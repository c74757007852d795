"""What an edit made stale is made anew: of a scene its light, its motion or its staging, of a shot its motion."""

from __future__ import annotations

from collections.abc import Collection

from storyblender.memory.base import scene_name
from storyblender.pipeline.run import Run
from storyblender.pipeline.staging import act_in_layout, animate_again, light_scene, stage_scene


def make_stale_anew(run: Run, scenes: Collection[int] | None = None) -> None:
    """Make anew what is stale of each scene, in story order, then the motion of each shot.

    Args:
        run: With all assets built.
        scenes: Ids of the scenes to look at; None looks at all.

    Raises:
        AnswerAwaited: An answer has to come from outside first.
        Cancelled: The run is cancelled.
    """
    ids = [scene.scene_id for scene in run.graph.scenes if scenes is None or scene.scene_id in scenes]
    stale = [scene_id for scene_id in ids if run.graph.scene(scene_id).stale]
    for step, scene_id in enumerate(stale):
        run.progress("stage", step, len(stale), scene_name(scene_id))
        wanted = {*run.graph.scene(scene_id).stale}
        if wanted <= {"light"}:
            _relight(run, scene_id)
        elif wanted <= {"light", "motion"}:
            act_in_layout(run, run.graph.scene(scene_id))
        else:
            stage_scene(run, scene_id)
    if stale:
        run.progress("stage", len(stale), len(stale))
    animate_again(run, ids)


def _relight(run: Run, scene_id: int) -> None:
    scene, shots = light_scene(run, run.graph.scene(scene_id), run.graph.staged_shots_of(scene_id))
    scene = scene.model_copy(update={"stale": ()})
    run.commit("lighting_arranger", f"light of {scene_name(scene_id)}", scene, *shots)
