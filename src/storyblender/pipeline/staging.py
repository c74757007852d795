"""Spatial-temporal dynamics: set, dressing, layout, motion and light of every scene (paper, section 3.4)."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import partial

from storyblender.agents.layout_artist.asked_places import places_not_kept
from storyblender.agents.layout_artist.bystanders import bystander_objects, crowd_size, place_bystanders
from storyblender.agents.layout_artist.cleared_action import clear_action
from storyblender.agents.layout_artist.fitted_places import with_fitted_parts
from storyblender.agents.layout_artist.placed_by_hand import (
    bare_object,
    place_by_hand,
    placed_flaws,
    placements_of,
    stand_of,
)
from storyblender.agents.layout_artist.room_steps import RoomStep, drop_dressing, enlarge_set, find_fitting_room
from storyblender.agents.layout_artist.spatial_planner import free_floor_of
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView, measures_of
from storyblender.agents.layout_artist.stagings import most_different, stagings_to_try
from storyblender.agents.visual_effects_artist.decided import decided_environment, decided_light
from storyblender.agents.visual_effects_artist.furniture import dressing_asset
from storyblender.agents.visual_effects_artist.lamp_states import light_shots
from storyblender.agents.visual_effects_artist.lighting_arranger_view import lighting_arranger_view
from storyblender.agents.visual_effects_artist.staging_flaws import staging_flaws
from storyblender.agents.visual_effects_artist.vehicle_doors import add_open_doors
from storyblender.catalog.sets import plan_of
from storyblender.errors import AnswerAwaited
from storyblender.geometry.camera_path import retimed
from storyblender.memory.base import Vec2, scene_name, shot_name
from storyblender.memory.coverage import parts_of
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import Environment, Layout, Lighting, SceneContext
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.light_preview import LightPreview
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.own_motions import give_own_motions
from storyblender.pipeline.run import Run
from storyblender.pipeline.surroundings import with_offered_panorama, with_pictured_surfaces
from storyblender.reflection import Outcome
from storyblender.trace import Event

_LONGER = "what people do in it takes longer"
"""Why a shot that is staged again has another length: it is never made shorter."""


def stage(run: Run) -> None:
    """Stage every scene that is not staged yet, in story order; one commit a scene, so a kill loses one at most.

    Raises:
        AnswerAwaited: Answers have to come from outside first; scenes that do not need them are staged before the run
            stops.
    """
    scenes = [scene.scene_id for scene in run.graph.scenes]
    awaited: dict[int, AnswerAwaited] = {}
    for step, scene_id in enumerate(scenes):
        run.progress("stage", step, len(scenes), scene_name(scene_id))
        scene = run.graph.scene(scene_id)
        place = scene.setup.reference_scene_id  # the first scene in the same place, whose set this one takes over
        if scene.lighting is not None or place in awaited:
            continue
        try:
            stage_scene(run, scene_id)
        except AnswerAwaited as error:
            awaited[scene_id] = error
    if awaited:
        raise AnswerAwaited.of([*awaited.values()])
    run.progress("stage", len(scenes), len(scenes))


def stage_scene(run: Run, scene_id: int) -> None:
    """Stage a scene, or stage it again: its set if that is stale, dressing, layout, motion and light.

    Args:
        run: With the scene's assets built.
        scene_id: The scene.

    Raises:
        AnswerAwaited: An answer has to come from outside first.
    """
    name, before = scene_name(scene_id), run.graph.scene(scene_id)
    kept = before.environment if before.lighting is not None and "set" not in before.stale else None
    environment = kept or design(run, run.graph, scene_id)
    decided = before.set_decision is not None and (before.set_decision.width or before.set_decision.depth)
    fixed = kept is not None or decided or before.setup.reference_scene_id is not None  # it stays as large as it is

    def stage_in(room: RoomStep, faulty: Collection[Vec2]) -> tuple[SceneContext, Outcome[SpatialPlannerView, Layout]]:
        return _laid_out(run, scene_id, enlarge_set(environment, 1.0 if fixed else room.set_scale), room, faulty)

    fitted = find_fitting_room(stage_in, threshold=run.crew.spatial_planner.threshold)
    placed = before.layout_decision.things if before.layout_decision is not None else {}
    layout = clear_action(fitted.outcome.view, fitted.outcome.draft, placed)
    layout = _with_crowd(run, fitted.outcome.view, layout)
    layout = with_fitted_parts(layout, run.graph.assets, before.setup.asset_ids)
    scene = fitted.tried
    if placed:
        assert scene.environment is not None
        layout = place_by_hand(layout, placed, stand_of(run.graph.assets, scene.environment))
    scene = scene.model_copy(update={"layout": layout})
    run.commit("spatial_planner", f"layout of {name}", scene)
    _tell_places_not_kept(run, scene)
    act_in_layout(run, scene, {*fitted.outcome.view.pending} - {item.asset_id for item in layout.objects})


def _tell_places_not_kept(run: Run, scene: SceneContext) -> None:
    """Warn of what a person added at a place and stands elsewhere."""
    added = scene.layout_decision.added if scene.layout_decision is not None else None
    if not added or scene.environment is None or scene.layout is None:
        return
    assets = {asset.asset_id: asset for asset in run.graph.assets}
    for message in places_not_kept(scene.setup, scene.layout, plan_of(scene.environment), assets, added):
        run.tell(Event(kind="warning", role="spatial_planner", subject=scene_name(scene.scene_id), message=message))


def act_in_layout(run: Run, scene: SceneContext, left_out: Collection[str] | None = None) -> None:
    """Stage the people of a scene in its layout as it is, light it, and let cameras follow but for those kept.

    Args:
        run: With the layout committed.
        scene: As it is committed.
        left_out: Asset ids of things without a place; None where they are those that were left out before.
    """
    name, before = scene_name(scene.scene_id), {shot.shot_id: shot for shot in run.graph.shots_of(scene.scene_id)}
    give_own_motions(run, scene.scene_id)
    shots = _animate(run, scene.scene_id)
    if scene.lighting is not None:
        shots = tuple(_with_camera_to_set(shot, before[shot.shot_id], scene) for shot in shots)
    added = tuple(_with_camera_to_set(shot, shot, scene) for shot in before.values() if shot.covers is not None)
    if "light" not in scene.locked:
        scene, shots = light_scene(run, scene, shots)
    scene = scene.model_copy(update={"stale": ()})
    shots = tuple(_with_flaws(run.graph, scene, shot, before[shot.shot_id], left_out) for shot in shots)
    anew = run.graph.scene(scene.scene_id).lighting is not None
    run.commit("animator", f"motion and light of {name}", scene, *shots, *added)
    if anew:
        _tell_lengths(run, before, shots)


def _with_flaws(
    graph: ContinuityMemoryGraph,
    scene: SceneContext,
    shot: ShotContext,
    before: ShotContext,
    left_out: Collection[str] | None,
) -> ShotContext:
    """Return a shot that was staged again with the flaws of that; those of what a person placed are on the first one.

    Args:
        graph: The story.
        scene: With its layout.
        shot: As it is staged now.
        before: As it was.
        left_out: Asset ids of things without a place; None for those that were left out before.
    """
    flaws = staging_flaws(shot, {asset.asset_id: asset for asset in graph.assets}, left_out or ())
    if left_out is None:
        flaws = (*flaws, *(flaw for flaw in before.flaws if flaw.kind == "left_out"))
    if shot.shot_id == graph.shots_of(shot.scene_id)[0].shot_id:
        flaws = (*flaws, *placed_flaws(graph, scene))
    return shot.model_copy(update={"flaws": flaws, "stale": ()})


def _with_camera_to_set(shot: ShotContext, before: ShotContext, scene: SceneContext | None = None) -> ShotContext:
    """Return a shot that is staged again, without its camera; one that a person locked or placed stays.

    The Camera Operator gives a shot that was not edited its camera again where that still works.

    Args:
        shot: As it is staged now.
        before: As it was.
        scene: Its scene, where all of it is staged again; in a new set every camera is a new one.
    """
    update: dict[str, object] = {"takes": shot.takes_to_set_anew}
    placed = shot.camera_decision is not None and shot.camera_decision.placed is not None
    if "camera" in shot.locked or placed:
        return shot.model_copy(update=update)
    former = before.camera or before.former_camera
    if former is None or before.stale or (scene is not None and "set" in scene.stale):
        return shot.model_copy(
            update=update | {"camera": None, "former_camera": None, "lights": (), "camera_retake": None}
        )
    former = retimed(former, before.duration, shot.duration)
    return shot.model_copy(update=update | {"camera": None, "former_camera": former, "lights": ()})


def animate_again(run: Run, scenes: Collection[int]) -> None:
    """Animate the scenes of shots whose motion an edit made stale; shots that come out as they were stay untouched.

    A shot whose people stand or go elsewhere now gets a new camera, unless a person locked or placed it, or the
    shot was not edited and its camera still works.

    Args:
        run: With the scenes staged.
        scenes: Ids of the scenes to look at.
    """
    for scene_id in sorted({shot.scene_id for shot in run.graph.shots if shot.stale} & {*scenes}):
        before = {shot.shot_id: shot for shot in run.graph.shots_of(scene_id)}
        scene = run.graph.scene(scene_id)
        shots = [_with_flaws(run.graph, scene, shot, before[shot.shot_id], None) for shot in _animate(run, scene_id)]
        shots = _with_cameras_after(before, shots)
        names = ", ".join(shot_name(scene_id, shot_id) for shot_id, shot in before.items() if shot.stale)
        run.commit("animator", f"motion of {names}", *shots)
        _tell_lengths(run, before, shots)
        for shot in shots:
            for flaw in shot.flaws:
                if flaw not in before[shot.shot_id].flaws:
                    subject = shot_name(scene_id, shot.shot_id)
                    run.tell(Event(kind="warning", role="animator", subject=subject, message=flaw.message))


def _tell_lengths(run: Run, before: Mapping[int, ShotContext], shots: Sequence[ShotContext]) -> None:
    """Tell which shots that were not edited have another length, because of what is done in them now."""
    fps = run.graph.format.fps
    for shot in shots:
        past = before[shot.shot_id]
        now, then = (f"{each.duration / fps:.1f}" for each in (shot, past))
        if now != then and not past.stale:
            message = f"lasts {now} s instead of {then} s: {_LONGER}"
            subject = shot_name(shot.scene_id, shot.shot_id)
            run.tell(Event(kind="follow", role="animator", subject=subject, message=message))


def _with_cameras_after(before: Mapping[int, ShotContext], shots: Sequence[ShotContext]) -> list[ShotContext]:
    """Return shots that were animated again; cameras go of those that show people who are elsewhere now.

    Args:
        before: All shots of the scene, by id.
        shots: The staged ones as they are now; the added ones are returned with them.
    """
    moved = {shot.shot_id for shot in shots if shot.blocking != before[shot.shot_id].blocking}
    every = [*before.values()]
    result: list[ShotContext] = []
    for shot in (*shots, *(each for each in every if each.covers is not None)):
        parts = (shot,) if shot.joined else parts_of(every, before[shot.shot_id])
        follows = moved & {part.shot_id for part in parts}
        result.append(_with_camera_to_set(shot, before[shot.shot_id]) if follows else shot)
    return result


def _laid_out(
    run: Run, scene_id: int, environment: Environment, room: RoomStep, faulty: Collection[Vec2]
) -> tuple[SceneContext, Outcome[SpatialPlannerView, Layout]]:
    """Dress a set and lay the scene out in it, without the dressing near what did not fit before."""
    name, plan = scene_name(scene_id), plan_of(environment)
    scene = run.graph.scene(scene_id).model_copy(update={"environment": environment})
    dressing = run.reflect(run.crew.set_dresser, name, replace(run.graph, scene), scene_id).draft
    known = {asset.asset_id for asset in run.graph.assets}
    fresh = [asset for asset in dressing.assets if asset.asset_id not in known]
    run.commit("set_dresser", f"set and dressing of {name}", scene, *fresh)
    with run.doing("Building what dresses the sets"):
        materialize(run, fresh)
    placements = placements_of(run.graph.assets)
    standing, pending = drop_dressing(dressing.objects, plan, faulty, room.clear_radius), dressing.pending
    if scene.layout_decision is not None and scene.layout_decision.things:
        things = scene.layout_decision.things
        kept = [item for item in dressing.objects if item in standing or item.node_id in things]
        own = [bare_object(node_id, place) for node_id, place in things.items() if node_id in pending]
        layout = Layout(scene_size=plan.size, objects=(*kept, *(item for item in own if item is not None)))
        standing = place_by_hand(layout, things, stand_of(run.graph.assets, environment)).objects
        pending = tuple(each for each in pending if each not in {item.node_id for item in standing})
    role, args = run.crew.spatial_planner, (plan, standing, pending, placements, room.distance_scale)
    tried = [run.reflect(role, name, run.graph, scene_id, *args, staging) for staging in stagings_to_try(scene)]
    return scene, most_different(tried, scene.layout, role.threshold)


def _with_crowd(run: Run, view: SpatialPlannerView, layout: Layout) -> Layout:
    """Return a layout with as many people of the background as the place is full of."""
    graph, size = run.graph, view.plan.size
    area = (size.x - size.x_negative) * (size.y - size.y_negative)
    count = crowd_size(graph.scene(view.scene_id).setup.crowd, area) - graph.people_in(view.scene_id)
    if count <= 0:
        return layout
    found = place_bystanders(view, layout, count, free_floor_of(view, layout))
    age = graph.age or "today"
    params = [{"posture": each.posture, "variant": each.variant, "age": age} for each in found]
    figures = [dressing_asset("background_figure", dict(each)) for each in params]
    known = {asset.asset_id for asset in graph.assets}
    fresh = {asset.asset_id: asset for asset in figures if asset.asset_id not in known}
    if fresh:
        run.commit("set_dresser", f"people of the background of {scene_name(view.scene_id)}", *fresh.values())
        with run.doing("Building the people of the background"):
            materialize(run, list(fresh.values()))
    objects = bystander_objects(found, figures, measures_of(run.graph.assets))
    return layout.model_copy(update={"objects": (*layout.objects, *objects)})


def design(run: Run, graph: ContinuityMemoryGraph, scene_id: int) -> Environment:
    """Return the set that a scene of a graph gets.

    Args:
        run: Its Environment Designer decides.
        graph: The story, which need not be committed.
        scene_id: The scene.

    Raises:
        AnswerAwaited: The answer has to come from outside first.
    """
    outcome = run.reflect(run.crew.environment_designer, scene_name(scene_id), graph, scene_id)
    environment = decided_environment(outcome.draft, outcome.view, graph.scene(scene_id).set_decision)
    return with_pictured_surfaces(run, graph, scene_id, environment)


def _animate(run: Run, scene_id: int) -> tuple[ShotContext, ...]:
    draft = run.reflect(run.crew.animator, scene_name(scene_id), run.graph, scene_id).draft
    staged = {staging.shot_id: staging for staging in draft.shots}
    layout = run.graph.scene(scene_id).layout
    assert layout is not None, "the layout comes before motion"
    played = tuple(staged[shot.shot_id].applied(shot) for shot in run.graph.staged_shots_of(scene_id))
    return add_open_doors(played, layout.objects, run.graph.assets_of(scene_id))


def light_scene(
    run: Run, scene: SceneContext, shots: tuple[ShotContext, ...]
) -> tuple[SceneContext, tuple[ShotContext, ...]]:
    """Return a scene with its light, and its shots, each from which on the script changes the light with its own.

    Args:
        run: With the scene laid out.
        scene: As it is to be committed.
        shots: Of the scene, with their motion.
    """
    shots = tuple(shot.model_copy(update={"lighting": None}) for shot in shots)
    scene = with_offered_panorama(run, scene)
    role, graph, scene_id = run.crew.lighting_arranger, run.graph, scene.scene_id
    if scene.offered_panorama != graph.scene(scene_id).offered_panorama:
        known = graph.scene(scene_id).model_copy(update={"offered_panorama": scene.offered_panorama})
        graph = replace(graph, known)
    preview = LightPreview(run, scene, shots)
    usual = run.reflect(role, scene_name(scene_id), graph, scene_id, draw=preview.draw_opening).draft

    def change(current: Lighting, shot: ShotContext) -> Lighting:
        name, draw = shot_name(scene_id, shot.shot_id), partial(preview.draw_change, shot, current)
        return run.reflect(role, name, graph, scene_id, current, shot.light_change, shot.shot_id, draw).draft

    first, lit, found = light_shots(usual, lighting_arranger_view(graph, scene_id), shots, scene.setup.found, change)
    setup = scene.setup if found == scene.setup.found else scene.setup.model_copy(update={"found": found})
    decision = scene.light_decision
    lit = tuple(
        shot.model_copy(update={"lighting": shot.lighting and decided_light(shot.lighting, decision)}) for shot in lit
    )
    return scene.model_copy(update={"lighting": decided_light(first, decision), "setup": setup}), lit
