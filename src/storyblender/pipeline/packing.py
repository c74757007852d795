"""Scenes as Blender has them: what is staged becomes a pack, named by the hash of all that it depends on."""

from __future__ import annotations

from concurrent.futures import Future

from storyblender.memory.base import scene_name
from storyblender.memory.coverage import is_cut_anew, spans_of, staged_spans
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef, SceneJob
from storyblender.memory.paint import paints_in
from storyblender.pipeline.hand_motions import with_hand_motions
from storyblender.pipeline.run import Run
from storyblender.pipeline.state_assets import assets_in_states, build_states


def pack_scenes(run: Run) -> None:
    """Build the packs, all at once over the pool; a pack that is there already is only looked up."""
    staged = [scene.scene_id for scene in run.graph.scenes if scene.layout is not None]
    jobs = {scene_id: with_hand_motions(run, scene_job(run.graph, scene_id)) for scene_id in staged}
    build_states(run, jobs.values())
    waiting: dict[int, Future[PackRef]] = {}
    for scene_id, job in jobs.items():
        known = known_pack(run, job)
        if known is None:
            waiting[scene_id] = run.engine.pack_scene(job)
        else:
            run.packs[scene_id] = with_coverage(run.graph, known)
    for step, (scene_id, job) in enumerate(jobs.items()):
        run.progress("pack", step, len(jobs), scene_name(scene_id))
        if scene_id in waiting:
            run.packs[scene_id] = with_coverage(run.graph, _noted(run, job, waiting[scene_id].result()))
    run.progress("pack", len(jobs), len(jobs))


def pack_scene(run: Run, job: SceneJob) -> PackRef:
    """Return the pack of one scene, built now if it is not there.

    Args:
        run: Its engine packs.
        job: The scene, which need not be committed.

    Raises:
        EngineError: It cannot be packed.
    """
    if (known := known_pack(run, job)) is not None:
        return known
    build_states(run, (job,))
    return _noted(run, job, run.engine.pack_scene(job).result())


def known_pack(run: Run, job: SceneJob) -> PackRef | None:
    """Return the pack of a scene if it is there already."""
    return run.outputs.read(job.record, PackRef.model_validate_json) if run.outputs.whole(job.out) else None


def _noted(run: Run, job: SceneJob, pack: PackRef) -> PackRef:
    """Return a pack that was just built, after noting its files."""
    run.outputs.note(job.out)
    run.outputs.write(job.record, pack.model_dump_json())
    return pack


def with_coverage(graph: ContinuityMemoryGraph, pack: PackRef) -> PackRef:
    """Return a pack that tells of the shots that a person split, joined or added when they begin and what is played.

    Args:
        graph: The story.
        pack: Of one of its scenes, as it is kept.
    """
    shots = graph.shots_of(pack.scene_id)
    if not is_cut_anew(shots):
        return pack
    spans, staged = spans_of(shots), staged_spans(shots)
    opening = min((start for _, start in pack.starts), default=1)
    covering = tuple((shot.shot_id, opening + spans[shot.shot_id][0]) for shot in shots if shot.covers is not None)
    timing = list(pack.timing)
    for shot_id, (first, end) in spans.items():
        for cue in pack.timing:
            offset = staged[cue.shot_id][0] - first
            if cue.shot_id != shot_id and cue.over + offset > 0 and cue.began + offset < end - first:
                times = {"start": max(cue.start + offset, 0), "began": cue.began + offset, "over": cue.over + offset}
                timing.append(cue.model_copy(update={"shot_id": shot_id, **times}))
    return pack.model_copy(update={"covering": covering, "timing": tuple(timing)})


def scene_job(graph: ContinuityMemoryGraph, scene_id: int) -> SceneJob:
    """Return what the engine needs to build a scene.

    Args:
        graph: The story, with the assets built.
        scene_id: A scene that is staged.

    Raises:
        KeyError: There is no such scene.
    """
    scene, shots = graph.scene(scene_id), graph.staged_shots_of(scene_id)
    assets = graph.assets_of(scene_id)
    states = assets_in_states(assets, shots, scene.setup.found)
    paints = paints_in(graph.paints, scene_id, (asset.asset_id for asset in assets))
    return SceneJob(scene=scene, shots=shots, assets=assets, fps=graph.format.fps, in_states=states, paints=paints)
