"""Motions of files of the user: a recording is played in place of a clip, or over a speech."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.clips.gaze import show_mood
from storyblender.blender.motion.clips.locomotion import step_to
from storyblender.blender.motion.clips.registry import play
from storyblender.blender.motion.mocap import FADE, MocapLayer, MocapWay, way_of
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES
from storyblender.blender.motion.staged_props import carrying_hand
from storyblender.geometry.mocap import RATE, MocapPoses

STEP = 0.28
"""Seconds of a step that brings a foot to where a recording has it."""
LIFT = 0.05
"""Metres, times the scale."""
SLOWEST, FASTEST = 0.7, 1.4
"""Bounds of the pace at which a recording fits the length of its cue."""
VOICED = frozenset({"talk", "whisper", "shout", "laugh", "cry"})
"""Clips with a voice, whose mouth goes on."""
ASIDE = 0.10
"""Metres, times the scale, that a foot may end from where it stands at ease."""


def play_recording(stage: MotionStage, who: Performer, key: str, cue: StagedCue, poses: MocapPoses) -> float:
    """Play a recording in place of a clip, as soon as the person is free; return the second at which it is over.

    What has a voice is spoken as the clip does it, with the recording over it. Who does not stand keeps legs and hips
    as they are, and whoever holds something else than the cue's prop keeps holding it.

    Args:
        stage: The stage of the shot.
        who: The person.
        key: Of the clip.
        cue: When, how long, and where it leads.
        poses: The recording; one that loops begins again where the cue is longer.
    """
    parts = ("body", "head", *SIDES) if who.posture == "stand" else ("head", *SIDES)
    if key in VOICED:
        end = play(stage, who, key, cue)
        start, _ = stage.played[who.asset_id, key, cue.frame]
        over = end if poses.loops else min(end, start + poses.seconds / SLOWEST)
        if over - start > 2 * FADE:
            _play(stage, who, poses, (start, over), cue, turned=False)
    else:
        start = max([cue.start, *(who.free[part] for part in parts)])
        end = start + (cue.duration or poses.seconds)
        show_mood(who, start, cue.mood)
        _play(stage, who, poses, (start, end), cue, turned=True)
        stage.played[who.asset_id, key, cue.frame] = (start, end)
    for part in parts:
        who.free[part] = max(who.free[part], end)
    return end


def _play(
    stage: MotionStage,
    who: Performer,
    poses: MocapPoses,
    span: tuple[float, float],
    cue: StagedCue,
    *,
    turned: bool,
) -> None:
    start, end = span
    pace = 1.0 if poses.loops else min(FASTEST, max(SLOWEST, poses.seconds / (end - start)))
    cut = end > stage.seconds - 0.3  # the shot ends in the midst of it
    layer = MocapLayer(who, poses, start, end + (2 * FADE if cut else 0.0), pace=pace)
    who.overlays.append(layer)
    who.lean_after.set(start, 0, 0.0)
    free = [side for side in SIDES if side not in who.engaged and _may_move(who, side, cue)]
    for side in free:
        held = who.held.get(side)
        who.hands[side].remove_from(start)
        who.hands[side].set(start, layer.fade, layer.hand(side, joined=len(free) > 1))
        if not cut:
            home = carrying_hand(who, side, stage.props[held]) if held in stage.props else who.home[side]
            who.hands[side].set(end - layer.fade, layer.fade, home)
    if not cut:
        who.lean_after.set(end, 0, 1.0)
    if who.posture == "stand":
        mark = cue.mark
        goal = None if mark is None or mark.asset_id != who.asset_id else Vector(mark.location[:2])
        _move(who, layer, way_of(layer, goal, turned=turned), (start, end), cut=cut)


def _may_move(who: Performer, side: str, cue: StagedCue) -> bool:
    """Return whether a hand is empty, or holds what the cue is done with."""
    held = who.held.get(side)
    return held is None or (cue.prop is not None and held == cue.prop.asset_id)


def _move(who: Performer, layer: MocapLayer, way: MocapWay, span: tuple[float, float], *, cut: bool) -> None:
    """Have root, hips and feet follow a recording, and stand at ease after it."""
    (start, end), fade = span, layer.fade
    who.life.set(start, fade, 0.0)
    who.root.set(start, 0, _sampled(way.root, start))
    who.hips.set(start, fade, _sampled(way.hips, start))
    first = _step_in(who, way, start)
    for side, index in zip(SIDES, (0, 1), strict=True):
        late = first.index(side) * STEP if side in first else 0.0
        away = side in first
        bump = (0.0, 0.0, LIFT * who.scale) if away else None
        who.feet[side].set(start + late, STEP if away else 0.1, _sampled(way.feet[index], start), bump=bump)
    x, y, yaw = way.root[-1]
    who.position, who.yaw = Vector((x, y)), float(yaw)
    if cut:
        return
    who.root.set(end, 0, way.root[-1])
    who.life.set(end - fade, fade, 1.0)
    who.hips.set(end - fade, fade, (0, 0, who.standing_height, 0, 0, 0))
    now = end
    for index, side in enumerate(SIDES):
        home, last = who.plant(side, who.position, who.yaw), way.feet[index, -1]
        if way.down[index] and math.dist(home[:2], last[:2]) < ASIDE * who.scale:
            stands = np.r_[last[:2], who.measures.ankle, last[3], 0, 0, last[6:9]]
            who.feet[side].set(end - 0.2, 0.2, stands)
        else:
            now = step_to(who, side, now, STEP, home)


def _step_in(who: Performer, way: MocapWay, start: float) -> Sequence[str]:
    """Return the feet that have to step to where the recording has them, the farther one first."""
    far = {side: math.dist(who.feet[side](start)[:2], way.feet[index, 0, :2]) for index, side in enumerate(SIDES)}
    return sorted((side for side in SIDES if far[side] > 0.02 * who.scale), key=lambda side: -far[side])


def _sampled(values: Floats, start: float) -> TargetOf:
    """Return samples (K, C), ``RATE`` a second from ``start`` on, as a function of seconds."""

    def at(t: float) -> Floats:
        row = min(max(0.0, (t - start) * RATE), len(values) - 1.0)
        low = min(int(row), len(values) - 2)
        return values[low] + (values[low + 1] - values[low]) * (row - low)

    return at
