"""Shoots a scene shot by shot: every camera knows the shots it has to match."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from storyblender.agents.layout_artist.camera_continuity import SceneCuts
from storyblender.agents.layout_artist.camera_details import detail_box, held_box, story_moment_of
from storyblender.agents.layout_artist.camera_operator import Operator, operate, rules_operator
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment, too_far_to_frame
from storyblender.agents.layout_artist.kept_camera import keep_camera
from storyblender.agents.layout_artist.layout_things import size_of
from storyblender.agents.layout_artist.story_moment import board_frame, is_at_rest
from storyblender.agents.layout_artist.vehicle_panels import open_doors, panel_boxes
from storyblender.agents.story_lines import lines_of_shot
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Film
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PlayedCue
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, CameraState, Cue, ShotContext
from storyblender.ports import Viewfinder
from storyblender.trace import Event, Listener, silent

_RELEASING_CLIPS = ("put_down", "drop", "throw")
"""Clips after which a thing is in nobody's hands."""
_TAKING_CLIPS = ("pick_up", "take", "catch")
"""Clips after which a thing is in the hand."""
Moments = Callable[[ShotContext], Sequence[Moment]]
"""Returns the figures of a shot at the frames of `measured_frames`, as the engine measured them."""


def props_put_away(shot: ShotContext, frame: int) -> set[str]:
    """Return the asset ids of props that a person has put down before a frame and no longer handles.

    Args:
        shot: The shot with its cues; an insert has none.
        frame: Frame of the shot.
    """
    if shot.camera_instruction.kind == "insert":
        return set()
    gone: set[str] = set()
    for cue in sorted(shot.cues, key=lambda cue: cue.start):
        if cue.prop_id is not None and cue.start <= frame:
            gone = gone - {cue.prop_id} | ({cue.prop_id} if cue.clip in _RELEASING_CLIPS else set())
    busy = [cue for cue in shot.cues if cue.start <= frame and not is_at_rest(cue)]
    last: dict[str, Cue] = {}
    for cue in sorted(busy, key=lambda cue: cue.start):
        # Both people of an embrace are busy with it, whatever their hands did before.
        pair = (cue.asset_id, cue.target_id) if MOTIONS[cue.clip].reach == "person" else (cue.asset_id,)
        last |= {who: cue for who in pair if who is not None}
    return gone - {cue.prop_id for cue in last.values()}


def measured_frames(shot: ShotContext, played: Sequence[PlayedCue] = ()) -> tuple[int, ...]:
    """Return the frames at which the engine measures figures: start, story moment and end of the shot.

    Args:
        shot: The shot.
        played: The cues as the engine played them; may be empty.
    """
    last = max(shot.duration - 1, 0)
    middle = min(max(board_frame(shot, played), 1), max(last - 1, 0))
    return tuple(dict.fromkeys((0, middle, last)))


def shoot_scene(
    graph: ContinuityMemoryGraph,
    scene_id: int,
    plan: SetPlan,
    measures: Mapping[str, AssetMeasure],
    moments: Moments,
    viewfinder: Viewfinder,
    *,
    operator: Operator = rules_operator,
    kit: tuple[float, ...] = (),
    listener: Listener = silent,
) -> dict[int, CameraState]:
    """Return the camera of every shot of a scene by shot id; cameras that are set stay, and the others match them.

    Args:
        graph: The graph, with layout and blocking of the scene.
        scene_id: Number of the scene.
        plan: Its set.
        measures: Measures by asset id.
        moments: Returns the figures of a shot.
        viewfinder: The engine's viewfinder.
        operator: Builds the Camera Operator for a shot.
        kit: Focal lengths in mm of the lenses at hand; empty for any lens.
        listener: Receives the trace.
    """
    cameras: dict[int, CameraState] = {}
    cuts = SceneCuts()
    for shot in graph.shots_in_order(scene_id):
        view = cuts.match(shot, replace(camera_operator_view(graph, shot, plan, measures, moments(shot)), kit=kit))
        state = shot.camera
        if state is None:
            state = _set_camera(view, shot.former_camera, viewfinder, operator, listener)
            state = _with_people_left_out(state, shot, view)
        cameras[shot.shot_id] = state
        if not shot.omitted:
            cuts.remember(shot, view, state)
    return cameras


def _set_camera(
    view: CameraOperatorView,
    former: CameraState | None,
    viewfinder: Viewfinder,
    operator: Operator,
    listener: Listener,
) -> CameraState:
    """Return the camera of a shot: the one it had before it was staged again, if that still works, or a new one."""
    if former is None:
        return operate(view, viewfinder, operator, listener)
    kept, why = keep_camera(view, former, operator(viewfinder).critic)
    if kept is not None:
        return kept
    state = operate(view, viewfinder, operator, listener)
    if state.poses != former.poses:
        name = shot_name(view.scene_id, view.shot_id)
        listener(Event(kind="follow", role="camera_operator", subject=name, message=f"has another camera: {why}"))
    return state


def _with_people_left_out(state: CameraState, shot: ShotContext, view: CameraOperatorView) -> CameraState:
    """Return the camera state with the people whom the shot is meant to show but had to leave out."""
    left = tuple(node for node in shot.in_frame if node not in view.in_frame)
    return state.model_copy(update={"leaves_out": left}) if left else state


def _handling_cues(shot: ShotContext, frame: int) -> list[Cue]:
    """Return the cues that handle things up to a frame: the last for each thing not put down again."""
    last: dict[str, Cue] = {}
    for cue in sorted(shot.cues, key=lambda cue: cue.start):
        if cue.prop_id is None or cue.start > frame:
            continue
        taken = last.get(cue.prop_id)
        if taken is None or taken.clip not in _TAKING_CLIPS or cue.clip in (*_TAKING_CLIPS, *_RELEASING_CLIPS):
            last[cue.prop_id] = cue
    return [cue for cue in last.values() if cue.clip not in _RELEASING_CLIPS]


def _ordered(shot: ShotContext) -> CameraInstruction:
    """Return the instruction of a shot; what a person asked for counts as ordered, like what the script asks for."""
    asked = shot.camera_decision is not None and shot.camera_decision.reframes
    return shot.camera_instruction.model_copy(update={"explicit": True}) if asked else shot.camera_instruction


def camera_operator_view(
    graph: ContinuityMemoryGraph,
    shot: ShotContext,
    plan: SetPlan,
    measures: Mapping[str, AssetMeasure],
    moments: Sequence[Moment],
) -> CameraOperatorView:
    """Return the Camera Operator's projection of the graph for one shot, without the shots it has to match.

    Args:
        graph: The graph, with layout and blocking of the scene.
        shot: The shot.
        plan: The set.
        measures: Measures by asset id.
        moments: Its figures at start, story moment and end; may be empty.
    """
    layout = graph.scene(shot.scene_id).layout
    props: dict[str, Box] = {}
    nodes: dict[str, str] = {}
    panels: dict[str, Box] = {}
    carried: dict[str, tuple[str, ...]] = {}
    used: list[str] = []
    handled = {name for deed in shot.character_actions for name in (deed.target_id, deed.prop_id) if name is not None}
    away = {state.asset_id: state for state in shot.prop_states}
    for item in layout.objects if layout is not None else ():
        measure, state = measures.get(item.asset_id), away.get(item.asset_id)
        if measure is None or measure.asset_type == "character" or (state is not None and not state.visible):
            continue
        location, yaw = item.location, item.rotation[2]
        if state is not None and state.location is not None:
            location, yaw = state.location, state.rotation[2]
        if state is None or state.held_by is None:
            props[item.node_id] = Box(*location, *size_of(measure), math.radians(yaw))
            doors = open_doors(graph.shots_of(shot.scene_id), shot.shot_id, item.asset_id) if measure.anchors else ()
            panels |= panel_boxes(item.node_id, location, yaw, measure.anchors, doors)
        nodes.setdefault(item.asset_id, item.node_id)
        if item.asset_id in handled or item.node_id in handled:
            used.append(item.node_id)
    for state in shot.prop_states:
        holder = story_moment_of(moments).figure(state.held_by) if moments and state.visible else None
        measure = measures.get(state.asset_id)
        if measure is None or not state.visible:
            continue
        node = nodes.get(state.asset_id, state.asset_id)
        if holder is not None:
            props[node] = held_box(holder, state.hand, size_of(measure))
            carried[state.held_by or ""] = (*carried.get(state.held_by or "", ()), node)
        elif state.location is not None:  # brought along and laid down: the layout does not have it
            props[node] = Box(*state.location, *size_of(measure), math.radians(state.rotation[2]))
    instruction, in_frame = _ordered(shot), shot.in_frame
    for cue in _handling_cues(shot, story_moment_of(moments).frame) if moments else ():
        node, holder = nodes.get(cue.prop_id or "", cue.prop_id or ""), story_moment_of(moments).figure(cue.asset_id)
        if holder is None or node in carried.get(cue.asset_id, ()):
            continue
        carried[cue.asset_id] = (*carried.get(cue.asset_id, ()), node)
        if cue.clip in _TAKING_CLIPS and (measure := measures.get(cue.prop_id or "")) is not None:
            props[node] = held_box(holder, cue.hand, size_of(measure))
    if moments:
        over = props_put_away(shot, story_moment_of(moments).frame)
        instruction = instruction.model_copy(
            update={"focus_on_ids": tuple(name for name in instruction.focus_on_ids if name not in over)}
        )
        together = (*(nodes.get(name, name) for name in instruction.focus_on_ids[:1]), *in_frame)
        distant = too_far_to_frame(instruction, story_moment_of(moments), together)
        in_frame = tuple(node for node in in_frame if node not in distant)
    return CameraOperatorView(
        scene_id=shot.scene_id,
        shot_id=shot.shot_id,
        instruction=instruction,
        duration=shot.duration,
        moments=tuple(moments),
        plan=plan,
        props=props,
        in_frame=in_frame,
        film=Film(graph.format.sensor_width, graph.format.aspect),
        nodes=nodes,
        carried=carried,
        detail=detail_box(shot, moments),
        used=tuple(used),
        lines=lines_of_shot(graph.outline_of(shot.scene_id), shot.shot_id),
        asked=shot.camera_decision or CameraDecision(),
        panels=panels,
    )
