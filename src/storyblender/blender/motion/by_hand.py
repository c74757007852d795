"""Motion that a person animated by hand, laid over a solved shot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from storyblender.blender.motion.baked import rotation_matrices
from storyblender.blender.motion.plan import Floats, Performance, PersonTrack
from storyblender.memory.motion_by_hand import HIPS_PLACE, PLACE, ROOT, TURN, HandChannel, MotionByHand


def with_motion_by_hand(performance: Performance, motions: Mapping[str, MotionByHand]) -> Performance:
    """Return a performance in which people and things move as a person animated them, where one did.

    Args:
        performance: Solved.
        motions: By asset id; those of characters that are not in the shot are left out.
    """
    frames = performance.frames.astype(float)
    people, props = dict(performance.people), dict(performance.props)
    for name, motion in motions.items():
        if name in people:
            people[name] = _person(people[name], motion, frames)
        if name in props:
            props[name] = _thing(props[name], motion, frames)
    return replace(performance, people=people, props=props)


def _person(track: PersonTrack, motion: MotionByHand, frames: Floats) -> PersonTrack:
    channels, rotations = motion.channels, track.rotations.copy()
    for index, bone in enumerate(track.bone_names):
        if bone in channels:
            turns = _sampled(channels[bone], frames)
            rotations[:, index] = turns / np.linalg.norm(turns, axis=1, keepdims=True)
    return replace(
        track,
        rotations=rotations,
        root=_sampled(channels[ROOT], frames) if ROOT in channels else track.root,
        hips=_sampled(channels[HIPS_PLACE], frames) if HIPS_PLACE in channels else track.hips,
    )


def _thing(matrices: Floats, motion: MotionByHand, frames: Floats) -> Floats:
    moved = matrices.copy()
    if PLACE in motion.channels:
        moved[:, :3, 3] = _sampled(motion.channels[PLACE], frames)
    if TURN in motion.channels:
        moved[:, :3, :3] = rotation_matrices(_sampled(motion.channels[TURN], frames))
    return moved


def _sampled(channel: HandChannel, frames: Floats) -> Floats:
    """Return the values (N, C) of a channel at frames (N,)."""
    values = np.array(channel.values)
    return np.stack([np.interp(frames, channel.frames, column) for column in values.T], axis=1)
