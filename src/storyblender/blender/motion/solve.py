"""The motion solver: marks, cues and props of one shot in, sampled poses out. A pure function."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.animal_moves import move_animal
from storyblender.blender.motion.clips import CLIPS, play
from storyblender.blender.motion.clips.floor import crouch, kneel, lie_down, sleep
from storyblender.blender.motion.clips.handling import take_in_hand
from storyblender.blender.motion.clips.postures import float_, hang, on_all_fours, ride, upside_down
from storyblender.blender.motion.clips.recorded import play_recording
from storyblender.blender.motion.clips.registry import Play
from storyblender.blender.motion.clips.seat import return_hands, sit, stand_up
from storyblender.blender.motion.clips.support import lean
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.on_body import attach_to_body
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import Floats, Performance, PersonTrack, PlayedTimes, Problem, StagePlan
from storyblender.blender.motion.skeleton import IDENTITY, SIDES, Skeleton
from storyblender.catalog.expressions import FACE
from storyblender.catalog.motions import AIMED, MOTIONS
from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import Cue, Mark
from storyblender.memory.vocabulary import Posture

LONG_BEFORE = -30.0
"""Second at which everything that precedes the shot was done."""
SETTLED = 2.0
"""Seconds before the shot at which a lasting motion starts."""
LEVEL = 0.02
"""Metres of height difference that are ignored."""
MISSED = 0.06
"""Metres by which a hand may miss its target before it is reported."""
ASTRAY = 0.30
"""Metres a person may end off the end mark before it is reported."""
END_POSTURES: dict[Posture, Posture] = {"asleep": "lie"}
POSTURE_CLIPS: dict[Posture, Play] = {
    "kneel": kneel, "crouch": crouch, "lean": lean, "hang": hang, "upside_down": upside_down, "float": float_,
    "ride": ride, "crawl": on_all_fours,
}  # fmt: skip
"""Posture -> clip that leads to it."""


def solve_shot(plan: StagePlan, fps: int) -> Performance:
    """Perform one shot, on every frame.

    Args:
        plan: The shot.
        fps: Frames per second.

    Returns:
        Tracks of people and props, and what could not be staged.
    """
    return SolvedShot(plan, fps).at(range(plan.frames))


class SolvedShot:
    """A solved shot: the timing of all motion is known; poses are computed at the frames that are asked for.

    Everybody starts at their start mark (already sitting, already holding) and plays the cues in order of their start
    frames. Equal plans give equal performances.

    Args:
        plan: The shot.
        fps: Frames per second.
    """

    def __init__(self, plan: StagePlan, fps: int) -> None:
        stage = self._stage = MotionStage(plan, fps, lambda name: int(content_hash(name, plan.seed), 16) % 2**32)
        for name, who in stage.people.items():
            take_start_mark(stage, who, plan.people[name].blocking.start)
        self._ends = dict.fromkeys(stage.people, 0.0)
        for index, cue in sorted(enumerate(plan.cues), key=lambda pair: (pair[1].start, pair[0])):
            end = _perform(stage, cue, index)
            if end is not None:
                self._ends[cue.asset_id] = max(self._ends[cue.asset_id], end)
        _check_ends(stage)
        self._drops = stage.plan_drops(np.arange(plan.frames) / fps)

    @property
    def played(self) -> PlayedTimes:
        """Start and end of cues in seconds, by person, clip and the cue's frame."""
        return self._stage.played

    def at(self, frames: Sequence[int]) -> Performance:
        """Return the performance at frames of the shot, ascending, the first and the last of the shot among them."""
        stage = self._stage
        found = len(stage.problems)
        rows = {name: _TrackSamples(who, len(frames)) for name, who in stage.people.items()}
        matrices = {name: np.zeros((len(frames), 4, 4)) for name in stage.props}
        contacts = sorted(stage.contacts, key=lambda contact: contact[0])
        for index, frame in enumerate(frames):
            t = frame / stage.fps
            stage.pose(t, {name: float(drop[frame]) for name, drop in self._drops.items()})
            for name, who in stage.people.items():
                rows[name].write(index, t, who)
            for name, prop in stage.props.items():
                matrices[name][index] = np.array(prop.matrix)
            while contacts and contacts[0][0] <= t:
                _, who, side, staged = contacts.pop(0)
                missed = who.missed[side]
                if missed > MISSED:
                    message = f"{who.asset_id}'s hand misses{_target_of(staged)} by {missed:.2f} m"
                    stage.report("unreachable", who, staged, message, missed)
        tracks = {name: rows[name].track(who) for name, who in stage.people.items()}
        problems = tuple(stage.problems)
        del stage.problems[found:]  # they are found again when it is asked again
        return Performance(
            stage.fps, np.array(frames), tracks, matrices, problems, self._ends, stage.grasps, stage.played
        )


def take_start_mark(stage: MotionStage, who: Performer, mark: Mark) -> None:
    """Put a person into place, posture and held props of a mark, from long before the shot.

    Args:
        stage: The stage of the shot.
        who: The person.
        mark: World place in metres and yaw in degrees, posture, what each hand holds.
    """
    x, y, z = mark.location
    who.place_at_start(x, y, math.radians(mark.yaw), z)
    staged = StagedCue(LONG_BEFORE, mark=mark)
    held = {prop: side for side, prop in mark.held}
    for name in held.keys() & stage.props.keys():
        stage.props[name].both = sum(prop == name for _, prop in mark.held) > 1
    for name, prop in stage.plan.props.items():
        if prop.state is not None and prop.state.held_by == who.asset_id and prop.state.hand is not None:
            held.setdefault(name, prop.state.hand)
    for name, prop in stage.plan.props.items():
        if prop.state is not None and prop.state.held_by == who.asset_id and prop.state.place is not None:
            attach_to_body(who, stage.props[name], prop.state.place, LONG_BEFORE)
    for name, side in held.items():
        if name in stage.props:
            take_in_hand(stage, who, side, stage.props[name], LONG_BEFORE - 1, 0.0)
    posture = mark.posture
    if posture == "sit":
        sit(stage, who, staged)
    elif posture == "lie":
        lie_down(stage, who, staged)
    elif posture == "asleep":
        _fall_asleep(stage, who, staged)
    elif posture in POSTURE_CLIPS:
        POSTURE_CLIPS[posture](stage, who, staged)
    if posture == "stand" or who.posture == "stand":
        return_hands(stage, who, LONG_BEFORE, 0.1)
    who.free = dict.fromkeys(who.free, 0.0)


def _fall_asleep(stage: MotionStage, who: Performer, staged: StagedCue) -> None:
    """Sleep in a bed if the mark's support is one, else on its seat."""
    mark = staged.mark
    furniture = stage.find_furniture(mark.support_id) if mark else None
    if furniture is None or stage.find_anchor(furniture, ("bed",), mark) is not None:
        lie_down(stage, who, staged)
    else:
        sit(stage, who, staged)
    sleep(stage, who, StagedCue(LONG_BEFORE + 20))


def _perform(stage: MotionStage, cue: Cue, index: int) -> float | None:
    """Play one cue; return the second at which it ends, or None if it has no performer."""
    who = stage.people.get(cue.asset_id)
    if who is None and cue.mark is not None and cue.asset_id in stage.props:
        move_animal(stage.props[cue.asset_id], cue.start / stage.fps, (cue.duration or stage.fps) / stage.fps, cue.mark)
        return None
    if who is None or cue.clip not in CLIPS:
        return None
    target, prop = stage.find_subject(cue.target_id), stage.props.get(cue.prop_id or "")
    start = cue.start / stage.fps
    for wanted, found in ((cue.target_id, target), (cue.prop_id, prop)):
        if wanted and found is None:
            message = f"{cue.asset_id} cannot {cue.clip}: {wanted} is not on stage"
            stage.problems.append(Problem("missing", cue.asset_id, cue.start, message))
    staged = StagedCue(
        start=start,
        duration=None if cue.duration is None else cue.duration / stage.fps,
        target=target,
        prop=prop,
        side=cue.hand or _hand_for(who, cue),
        mark=cue.mark,
        via=cue.via,
        mood=cue.mood,
        expression=cue.expression or "neutral",
        frame=cue.start,
        seed=int(content_hash(cue, stage.plan.seed, index), 16) % 2**32,
    )
    if cue.lasting or (cue.clip == "face" and cue.start == 0):
        return _play_lasting(stage, who, cue, staged)
    poses = stage.plan.mocap.get(cue.mocap or "")
    if cue.mocap is not None and poses is None:
        message = f"{cue.asset_id} does not {cue.clip} as recorded: the file {cue.mocap[:8]} is gone or damaged"
        stage.problems.append(Problem("missing", cue.asset_id, cue.start, message))
    if poses is not None:
        return play_recording(stage, who, cue.clip, staged, poses)
    allowed = MOTIONS[cue.clip].before
    if allowed and who.posture not in allowed and "stand" in allowed:
        ready = stand_up(stage, who, max(start, who.free["body"]))
        who.free["body"] = max(who.free["body"], ready)
    end = play(stage, who, cue.clip, staged)
    if cue.mark is not None and cue.mark.asset_id == who.asset_id and cue.clip not in {*POSTURE_CLIPS, *AIMED}:
        _change_level(who, staged.start, end, cue.mark.location[2])
    return end


def _change_level(who: Performer, start: float, end: float, level: float) -> None:
    """Bring a person to the ground height ``level`` (metres) between ``start`` and ``end`` seconds."""
    if abs(level - who.ground) > LEVEL:
        who.level.set(start, max(0.3, end - start), level)
        who.ground = level


def _play_lasting(stage: MotionStage, who: Performer, cue: Cue, staged: StagedCue) -> float:
    """Play a lasting motion and return its start in seconds.

    From the first frame on it starts before the shot. It blocks no part of the body for other cues; hands that another
    cue uses return to it.
    """
    clip = CLIPS[cue.clip]
    start = -SETTLED if cue.start == 0 else max([staged.start, *(who.free[part] for part in clip.parts(staged.side))])
    clip.play(stage, who, replace(staged, start=start, duration=stage.seconds - start + 1.0))
    for side in SIDES:
        if side in clip.parts(staged.side):
            who.home[side] = who.hands[side].snapshot()
            who.engaged.add(side)
    return staged.start


def _hand_for(who: Performer, cue: Cue) -> str:
    """Return the hand that holds the cue's prop, else the right if it is empty, else the left if that is."""
    for side, held in who.held.items():
        if held == cue.prop_id:
            return side
    return "L" if "R" in who.held and "L" not in who.held else "R"


def _check_ends(stage: MotionStage) -> None:
    """Report everybody who does not end on the end mark."""
    for name, who in stage.people.items():
        end = stage.plan.people[name].blocking.end
        wanted = END_POSTURES.get(end.posture, end.posture)
        if wanted != who.posture and not (end.posture == "asleep" and who.posture == "sit"):
            message = f"{name} ends with {who.posture} instead of {end.posture}"
            stage.problems.append(Problem("late", name, stage.plan.frames, message))
        elif wanted == "stand":
            off = (Vector(end.location).xy - who.position).length
            if off > ASTRAY:
                message = f"{name} ends {off:.2f} m off the mark"
                stage.problems.append(Problem("late", name, stage.plan.frames, message, off))


def _target_of(staged: StagedCue) -> str:
    """Return the asset id of what a hand reaches for, with a space before it; empty if the cue names none."""
    target = staged.prop or staged.target
    return f" {target.asset_id}" if target is not None and target.asset_id else ""


class _TrackSamples:
    """Collects the samples of one person."""

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
        """Store the current pose of ``who`` as sample ``index``, at ``t`` seconds."""
        bones = who.bones
        self.root[index] = (*who.place, who.heading)
        self.hips[index] = self.back["hips"] @ bones.offset
        self.rotations[index] = [self._local(name, bones) for name in bones.names]
        self.face[index] = who.face_at(t)
        self.seated[index] = float(who.seated(t))

    def _local(self, name: str, bones: Skeleton) -> tuple[float, ...]:
        """Return a bone's quaternion about its own rest axes."""
        turn = bones.turn[name]
        if turn is IDENTITY:
            return self.unmoved[name]
        return (self.back[name] @ turn @ bones.rest[name]).to_quaternion()[:]

    def track(self, who: Performer) -> PersonTrack:
        """Return the collected samples as a track."""
        root = self.root.copy()
        root[:, 3] = np.unwrap(root[:, 3])
        known = [key for key in FACE if key in who.body.shape_keys]
        face = self.face[:, [FACE.index(key) for key in known]]
        return PersonTrack(
            who.bones.names, root, self.hips, _one_hemisphere(self.rotations), tuple(known), face, self.seated
        )


def _one_hemisphere(rotations: Floats) -> Floats:
    """Flip quaternions (N, B, 4) so that neighbours in time interpolate the short way."""
    flips = np.sign(np.einsum("nbq,nbq->nb", rotations[1:], rotations[:-1]))
    flips[flips == 0] = 1
    signs = np.concatenate([np.ones((1, rotations.shape[1])), np.cumprod(flips, axis=0)])
    return rotations * signs[:, :, None]
