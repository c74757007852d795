"""Shoots a scene in order: every camera knows the cuts before it, its reverse, and the side of the line."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from storyblender.agents.layout_artist.camera_continuity import SceneCuts
from storyblender.agents.layout_artist.camera_details import detail_of, held_at, middle_of
from storyblender.agents.layout_artist.camera_operator import Operator, operate, rules_operator
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment, too_far_to_frame
from storyblender.agents.layout_artist.layout_things import size_of
from storyblender.agents.layout_artist.story_moment import AT_REST, board_frame
from storyblender.catalog.motions import clip_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Film
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PlayedCue
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.shot_context import CameraState, Cue, ShotContext
from storyblender.ports import Viewfinder
from storyblender.trace import Listener, silent

_LEAVES = ("put_down", "drop", "throw")
"""Clips after which a thing is in nobody's hands."""
_TAKES = ("pick_up", "take", "catch")
"""Clips after which a thing is in the hand."""
Moments = Callable[[ShotContext], Sequence[Moment]]
"""Where everybody's face is at the frames of ``telling_frames``, as the engine measured it."""


def put_away(shot: ShotContext, frame: int) -> set[str]:
    """Return what somebody has put down and left before a frame: a picture of what they do next is not about it."""
    if shot.camera_instruction.kind == "insert":
        return set()
    gone: set[str] = set()
    for cue in sorted(shot.cues, key=lambda cue: cue.start):
        if cue.prop_id is not None and cue.start <= frame:
            gone = gone - {cue.prop_id} | ({cue.prop_id} if cue.clip in _LEAVES else set())
    busy = [cue for cue in shot.cues if cue.start <= frame and cue.clip not in AT_REST]
    last: dict[str, Cue] = {}
    for cue in sorted(busy, key=lambda cue: cue.start):
        # Who is embraced is in the embrace, whatever they did with their hands before.
        pair = (cue.asset_id, cue.target_id) if clip_of(cue.clip).reach == "person" else (cue.asset_id,)
        last |= {who: cue for who in pair if who is not None}
    return gone - {cue.prop_id for cue in last.values()}


def telling_frames(shot: ShotContext, played: Sequence[PlayedCue] = ()) -> tuple[int, ...]:
    """Return the frames at which a shot's faces are wanted: start, the moment that is drawn, and end."""
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
        graph: With layout and blocking of the scene.
        scene_id: Of the scene.
        plan: Its set.
        measures: By asset id.
        moments: Faces of a shot.
        viewfinder: The engine's eye.
        operator: The member of the crew who decides.
        kit: mm of the lenses at hand; any lens where it is empty.
        listener: Receives the trace.
    """
    cameras: dict[int, CameraState] = {}
    cuts = SceneCuts()
    for shot in graph.shots_of(scene_id):
        view = cuts.match(shot, replace(camera_operator_view(graph, shot, plan, measures, moments(shot)), kit=kit))
        state = shot.camera or _leaving_out(operate(view, viewfinder, operator, listener), shot, view)
        cameras[shot.shot_id] = state
        cuts.follow(shot, view, state)
    return cameras


def _leaving_out(state: CameraState, shot: ShotContext, view: CameraOperatorView) -> CameraState:
    """Return the camera with whom it was meant to show and leaves out."""
    left = tuple(node for node in shot.in_frame if node not in view.in_frame)
    return state.model_copy(update={"leaves_out": left}) if left else state


def _handlings(shot: ShotContext, frame: int) -> list[Cue]:
    """Return the cues that handle things up to a frame: the last for each thing not put down again."""
    last: dict[str, Cue] = {}
    for cue in sorted(shot.cues, key=lambda cue: cue.start):
        if cue.prop_id is None or cue.start > frame:
            continue
        taken = last.get(cue.prop_id)
        if taken is None or taken.clip not in _TAKES or cue.clip in (*_TAKES, *_LEAVES):
            last[cue.prop_id] = cue
    return [cue for cue in last.values() if cue.clip not in _LEAVES]


def camera_operator_view(
    graph: ContinuityMemoryGraph,
    shot: ShotContext,
    plan: SetPlan,
    measures: Mapping[str, AssetMeasure],
    moments: Sequence[Moment],
) -> CameraOperatorView:
    """Return the Camera Operator's projection of the graph for one shot, without its cuts."""
    layout = graph.scene(shot.scene_id).layout
    props: dict[str, Box] = {}
    nodes: dict[str, str] = {}
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
        nodes.setdefault(item.asset_id, item.node_id)
        if item.asset_id in handled or item.node_id in handled:
            used.append(item.node_id)
    for state in shot.prop_states:
        holder = middle_of(moments).figure(state.held_by) if moments and state.visible else None
        measure = measures.get(state.asset_id)
        if measure is None or not state.visible:
            continue
        node = nodes.get(state.asset_id, state.asset_id)
        if holder is not None:
            props[node] = held_at(holder, state.hand, size_of(measure))
            carried[state.held_by or ""] = (*carried.get(state.held_by or "", ()), node)
        elif state.location is not None:  # brought by somebody and laid down: the layout does not know it
            props[node] = Box(*state.location, *size_of(measure), math.radians(state.rotation[2]))
    instruction, in_frame = shot.camera_instruction, shot.in_frame
    for cue in _handlings(shot, middle_of(moments).frame) if moments else ():
        node, holder = nodes.get(cue.prop_id or "", cue.prop_id or ""), middle_of(moments).figure(cue.asset_id)
        if holder is None or node in carried.get(cue.asset_id, ()):
            continue
        carried[cue.asset_id] = (*carried.get(cue.asset_id, ()), node)
        if cue.clip in _TAKES and (measure := measures.get(cue.prop_id or "")) is not None:
            props[node] = held_at(holder, cue.hand, size_of(measure))
    if moments:
        over = put_away(shot, middle_of(moments).frame)
        instruction = instruction.model_copy(
            update={"focus_on_ids": tuple(name for name in instruction.focus_on_ids if name not in over)}
        )
        together = (*(nodes.get(name, name) for name in instruction.focus_on_ids[:1]), *in_frame)
        distant = too_far_to_frame(instruction, middle_of(moments), together)
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
        detail=detail_of(shot, moments),
        used=tuple(used),
        placed=shot.camera_decision.placed if shot.camera_decision is not None else None,
    )
