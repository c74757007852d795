"""A shot is a pure function: marks, cues and things in, sampled poses out."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.clips import CLIPS, play
from storyblender.blender.motion.clips.floor import crouch, kneel, lie_down, sleep
from storyblender.blender.motion.clips.handling import take_in_hand
from storyblender.blender.motion.clips.postures import float_, hang, on_all_fours, ride, upside_down
from storyblender.blender.motion.clips.registry import Play
from storyblender.blender.motion.clips.seat import refill_hands, sit, stand_up
from storyblender.blender.motion.clips.support import lean
from storyblender.blender.motion.going import send
from storyblender.blender.motion.on_body import put_on
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import Floats, Performance, PersonTrack, Problem, StagePlan
from storyblender.blender.motion.skeleton import IDENTITY, SIDES, Skeleton
from storyblender.blender.motion.stage import Beat, Stage
from storyblender.catalog.expressions import FACE
from storyblender.catalog.motions import AIMED, MOTIONS
from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import Cue, Mark
from storyblender.memory.vocabulary import Posture

LONG_BEFORE = -30.0
"""Seconds: what is already so when the shot begins was done back then."""
SETTLED = 2.0
"""Seconds before the shot at which a lasting motion starts."""
LEVEL = 0.02
"""Metres of height difference that are ignored."""
MISSED = 0.06
"""Metres a hand may miss what it reaches for before it is reported."""
ASTRAY = 0.30
"""Metres the end of a performance may lie off its end mark."""
POSTURES: dict[Posture, Posture] = {"asleep": "lie"}
TAKEN: dict[Posture, Play] = {
    "kneel": kneel, "crouch": crouch, "lean": lean, "hang": hang, "upside_down": upside_down, "float": float_,
    "ride": ride, "crawl": on_all_fours,
}  # fmt: skip
"""Posture to the clip that leads to it."""


def solve_shot(plan: StagePlan, fps: int, step: int = 1) -> Performance:
    """Perform one shot.

    Everybody starts as the start marks say (already sitting, already holding), plays the cues in order of their
    start frames, and is posed on every ``step``-th frame. Same plan, same performance.

    Args:
        plan: The shot.
        fps: Frames per second.
        step: 1 poses on every frame; 2 on twos, for animatics that are rendered so (feet slide between twos).

    Returns:
        Tracks of people and props, and what could not be staged.
    """
    stage = Stage(plan, fps, lambda name: int(content_hash(name, plan.seed), 16) % 2**32)
    for name, who in stage.people.items():
        take_place(stage, who, plan.people[name].blocking.start)
    ends = dict.fromkeys(stage.people, 0.0)
    for index, cue in sorted(enumerate(plan.cues), key=lambda pair: (pair[1].start, pair[0])):
        end = _perform(stage, cue, index)
        if end is not None:
            ends[cue.asset_id] = max(ends[cue.asset_id], end)
    _check_ends(stage)
    frames = np.unique([*range(0, plan.frames, step), plan.frames - 1])
    return _record(stage, frames, ends)


def take_place(stage: Stage, who: Performer, mark: Mark) -> None:
    """Be where a mark says, as it says, from long before the shot."""
    x, y, z = mark.location
    who.put(x, y, math.radians(mark.yaw), z)
    beat = Beat(LONG_BEFORE, mark=mark)
    held = {prop: side for side, prop in mark.held}
    for name in held.keys() & stage.props.keys():
        stage.props[name].both = sum(prop == name for _, prop in mark.held) > 1
    for name, prop in stage.plan.props.items():
        if prop.state is not None and prop.state.held_by == who.asset_id and prop.state.hand is not None:
            held.setdefault(name, prop.state.hand)
    for name, prop in stage.plan.props.items():
        if prop.state is not None and prop.state.held_by == who.asset_id and prop.state.place is not None:
            put_on(who, stage.props[name], prop.state.place, LONG_BEFORE)
    for name, side in held.items():
        if name in stage.props:
            take_in_hand(stage, who, side, stage.props[name], LONG_BEFORE - 1, 0.0)
    posture = mark.posture
    if posture == "sit":
        sit(stage, who, beat)
    elif posture == "lie":
        lie_down(stage, who, beat)
    elif posture == "asleep":
        _fall_asleep(stage, who, beat)
    elif posture in TAKEN:
        TAKEN[posture](stage, who, beat)
    if posture == "stand" or who.posture == "stand":
        refill_hands(stage, who, LONG_BEFORE, 0.1)
    who.free = dict.fromkeys(who.free, 0.0)


def _fall_asleep(stage: Stage, who: Performer, beat: Beat) -> None:
    """Asleep in a bed if the support is one, else in its seat."""
    mark = beat.mark
    furniture = stage.furniture(mark.support_id) if mark else None
    if furniture is None or stage.anchor(furniture, ("bed",), mark) is not None:
        lie_down(stage, who, beat)
    else:
        sit(stage, who, beat)
    sleep(stage, who, Beat(LONG_BEFORE + 20))


def _perform(stage: Stage, cue: Cue, index: int) -> float | None:
    who = stage.people.get(cue.asset_id)
    if who is None and cue.mark is not None and cue.asset_id in stage.props:
        send(stage.props[cue.asset_id], cue.start / stage.fps, (cue.duration or stage.fps) / stage.fps, cue.mark)
        return None
    if who is None or cue.clip not in CLIPS:
        return None
    target, prop = stage.subject(cue.target_id), stage.props.get(cue.prop_id or "")
    start = cue.start / stage.fps
    for wanted, found in ((cue.target_id, target), (cue.prop_id, prop)):
        if wanted and found is None:
            message = f"{cue.asset_id} cannot {cue.clip}: {wanted} is not on stage"
            stage.problems.append(Problem("missing", cue.asset_id, cue.start, message))
    beat = Beat(
        start=start,
        duration=None if cue.duration is None else cue.duration / stage.fps,
        target=target,
        prop=prop,
        side=cue.hand or _hand_for(who, cue),
        mark=cue.mark,
        mood=cue.mood,
        expression=cue.expression or "neutral",
        frame=cue.start,
        seed=int(content_hash(cue, stage.plan.seed, index), 16) % 2**32,
    )
    if cue.lasting or (cue.clip == "face" and cue.start == 0):
        return _go_on(stage, who, cue, beat)
    allowed = MOTIONS[cue.clip].before
    if allowed and who.posture not in allowed and "stand" in allowed:
        ready = stand_up(stage, who, max(start, who.free["body"]))
        who.free["body"] = max(who.free["body"], ready)
    end = play(stage, who, cue.clip, beat)
    if cue.mark is not None and cue.mark.asset_id == who.asset_id and cue.clip not in {*TAKEN, *AIMED}:
        _change_level(who, beat.start, end, cue.mark.location[2])
    return end


def _change_level(who: Performer, start: float, end: float, level: float) -> None:
    """Bring a person to the height of a mark while moving there."""
    if abs(level - who.ground) > LEVEL:
        who.level.set(start, max(0.3, end - start), level)
        who.ground = level


def _go_on(stage: Stage, who: Performer, cue: Cue, beat: Beat) -> float:
    """Play a lasting motion.

    A motion from the first frame on starts before the shot. It blocks no part of the body for other cues; hands
    that another cue uses return to it.
    """
    clip = CLIPS[cue.clip]
    start = -SETTLED if cue.start == 0 else max([beat.start, *(who.free[part] for part in clip.parts(beat.side))])
    clip.play(stage, who, replace(beat, start=start, duration=stage.plan.frames / stage.fps - start + 1.0))
    for side in SIDES:
        if side in clip.parts(beat.side):
            who.home[side] = who.hands[side].as_planned()
            who.engaged.add(side)
    return beat.start


def _hand_for(who: Performer, cue: Cue) -> str:
    """Return the hand that holds the cue's prop, else the right if it is empty, else the left if that is."""
    for side, held in who.held.items():
        if held == cue.prop_id:
            return side
    return "L" if "R" in who.held and "L" not in who.held else "R"


def _check_ends(stage: Stage) -> None:
    """Report who does not end on the end mark."""
    for name, who in stage.people.items():
        end = stage.plan.people[name].blocking.end
        wanted = POSTURES.get(end.posture, end.posture)
        if wanted != who.posture and not (end.posture == "asleep" and who.posture == "sit"):
            message = f"{name} ends with {who.posture} instead of {end.posture}"
            stage.problems.append(Problem("late", name, stage.plan.frames, message))
        elif wanted == "stand":
            off = (Vector(end.location).xy - who.position).length
            if off > ASTRAY:
                message = f"{name} ends {off:.2f} m off the mark"
                stage.problems.append(Problem("late", name, stage.plan.frames, message, off))


def _record(stage: Stage, frames: np.ndarray, ends: dict[str, float]) -> Performance:
    times = frames / stage.fps
    drops = stage.plan_drops(times)
    count = len(frames)
    rows = {name: _Rows(who, count) for name, who in stage.people.items()}
    matrices = {name: np.zeros((count, 4, 4)) for name in stage.props}
    contacts = sorted(stage.contacts, key=lambda contact: contact[0])
    for index, t in enumerate(times):
        stage.pose(float(t), {name: float(drop[index]) for name, drop in drops.items()})
        for name, who in stage.people.items():
            rows[name].write(index, float(t), who)
        for name, prop in stage.props.items():
            matrices[name][index] = np.array(prop.matrix)
        while contacts and contacts[0][0] <= t:
            _, who, side, beat = contacts.pop(0)
            missed = who.missed[side]
            if missed > MISSED:
                told = f"{who.asset_id}'s hand misses{_target_of(beat)} by {missed:.2f} m"
                stage.report("unreachable", who, beat, told, missed)
    tracks = {name: rows[name].track(who) for name, who in stage.people.items()}
    return Performance(stage.fps, frames, tracks, matrices, tuple(stage.problems), ends, stage.grasps, stage.played)


def _target_of(beat: Beat) -> str:
    """Return what a hand was sent to, with a space before it; nothing where the cue names none."""
    target = beat.prop or beat.target
    return f" {target.asset_id}" if target is not None and target.asset_id else ""


class _Rows:
    """The samples of one person as they are collected."""

    def __init__(self, who: Performer, count: int) -> None:
        bones = len(who.bones.names)
        self.root, self.hips = np.zeros((count, 4)), np.zeros((count, 3))
        self.rotations, self.face = np.zeros((count, bones, 4)), np.zeros((count, len(FACE)))
        self.seated = np.zeros(count)
        self.back = {name: rest.transposed() for name, rest in who.bones.rest.items()}
        self.unmoved = {
            name: (self.back[name] @ IDENTITY @ rest).to_quaternion()[:] for name, rest in who.bones.rest.items()
        }

    def write(self, index: int, t: float, who: Performer) -> None:
        bones = who.bones
        self.root[index] = (*who.place, who.heading)
        self.hips[index] = self.back["hips"] @ bones.offset
        self.rotations[index] = [self._local(name, bones) for name in bones.names]
        self.face[index] = who.face_at(t)
        self.seated[index] = float(who.seated(t))

    def _local(self, name: str, bones: Skeleton) -> tuple[float, ...]:
        """The bone's quaternion about its own rest axes."""
        turn = bones.turn[name]
        if turn is IDENTITY:
            return self.unmoved[name]
        return (self.back[name] @ turn @ bones.rest[name]).to_quaternion()[:]

    def track(self, who: Performer) -> PersonTrack:
        root = self.root.copy()
        root[:, 3] = np.unwrap(root[:, 3])
        known = [key for key in FACE if key in who.body.shape_keys]
        face = self.face[:, [FACE.index(key) for key in known]]
        return PersonTrack(
            who.bones.names, root, self.hips, _one_hemisphere(self.rotations), tuple(known), face, self.seated
        )


def _one_hemisphere(rotations: Floats) -> Floats:
    """Flip quaternions so that neighbours in time are near each other and interpolate the short way."""
    flips = np.sign(np.einsum("nbq,nbq->nb", rotations[1:], rotations[:-1]))
    flips[flips == 0] = 1
    signs = np.concatenate([np.ones((1, rotations.shape[1])), np.cumprod(flips, axis=0)])
    return rotations * signs[:, :, None]
