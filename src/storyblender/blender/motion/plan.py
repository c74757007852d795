"""Input and output of the motion solver: one shot as values, without Blender objects."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.body import RiggedBody
from storyblender.geometry.mocap import MocapPoses
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import Blocking, Cue, PropState


@dataclass(frozen=True)
class StagePerson:
    """A person of the shot.

    Attributes:
        body: Skeleton and skin.
        blocking: Marks at the start and the end of the shot.
        jacket: Whether they wear something with pockets at the breast.
    """

    body: RiggedBody
    blocking: Blocking
    jacket: bool = False


@dataclass(frozen=True)
class StageProp:
    """A movable prop.

    Attributes:
        world: (4, 4) matrix while it is untouched; the asset's frame is bottom centre, front -Y.
        dimensions: Width, depth, height in metres.
        anchors: In the asset's frame; the solver uses the grips.
        state: From the shot context, if it is held or away from its place.
        node_id: The layout object it is, if any.
    """

    world: Floats
    dimensions: tuple[float, float, float]
    anchors: tuple[Anchor, ...] = ()
    state: PropState | None = None
    node_id: str = ""


@dataclass(frozen=True)
class StageFurniture:
    """A fixed prop or piece of the set, with anchors to sit, lie, lean and put props on.

    Attributes:
        world: (4, 4) matrix of the asset's frame.
        dimensions: Width, depth, height in metres.
        anchors: In the asset's frame.
        asset_id: Its asset.
    """

    world: Floats
    dimensions: tuple[float, float, float]
    anchors: tuple[Anchor, ...] = ()
    asset_id: str = ""


@dataclass(frozen=True)
class Obstacle:
    """An oriented box that people walk around.

    Attributes:
        node_id: The furniture, wall or piece it belongs to.
        centre: World, metres.
        size: Metres along its own axes, before turning.
        yaw: Radians.
    """

    node_id: str
    centre: tuple[float, float, float]
    size: tuple[float, float, float]
    yaw: float = 0.0


@dataclass(frozen=True)
class StagePlan:
    """One shot, ready to be performed.

    Attributes:
        people: By asset id; only those on stage.
        cues: Frames count from the shot's start.
        props: By asset id.
        furniture: By node id.
        obstacles: Furniture and walls as boxes.
        frames: Length of the shot.
        bounds: The playing area in metres: x min, y min, x max, y max.
        seed: For sways, blinks and gestures.
        mocap: Recorded motions that cues name, by digest; those that cannot be read are missing.
    """

    people: dict[str, StagePerson]
    frames: int
    cues: tuple[Cue, ...] = ()
    props: dict[str, StageProp] = field(default_factory=dict)
    furniture: dict[str, StageFurniture] = field(default_factory=dict)
    obstacles: tuple[Obstacle, ...] = ()
    bounds: tuple[float, float, float, float] = (-50.0, -50.0, 50.0, 50.0)
    seed: int = 0
    mocap: Mapping[str, MocapPoses] = field(default_factory=dict[str, MocapPoses])


@dataclass(frozen=True)
class PersonTrack:
    """One person's sampled performance; N samples, B bones, K shape keys.

    Attributes:
        bone_names: As in the body.
        root: (N, 4) x, y, z in metres and yaw in radians of the armature object, unwrapped.
        hips: (N, 3) location of the hips pose bone, in its own rest axes.
        rotations: (N, B, 4) pose bone quaternions w, x, y, z; neighbours in time on one hemisphere.
        face_keys: Names of the shape keys.
        face: (N, K) their values.
        seated: (N,) weight of the clothes' ``sit`` shape key.
    """

    bone_names: tuple[str, ...]
    root: Floats
    hips: Floats
    rotations: Floats
    face_keys: tuple[str, ...]
    face: Floats
    seated: Floats


@dataclass(frozen=True)
class Problem:
    """Something that could not be staged as planned.

    Attributes:
        kind: ``no_path``, ``unreachable``, ``no_support``, ``missing``, ``late`` or ``crossing``.
        asset_id: The person concerned.
        frame: From the shot's start.
        message: One sentence for the director.
        amount: Metres or seconds, where there is a number.
    """

    kind: str
    asset_id: str
    frame: int
    message: str
    amount: float = 0.0


PlayedTimes = dict[tuple[str, str, int], tuple[float, float]]
"""Start and end of cues in seconds, by person, clip and the cue's frame."""


@dataclass(frozen=True)
class Performance:
    """The solved shot.

    Attributes:
        fps: Frames per second.
        frames: (N,) sampled frames from the shot's start; the first is 0, the last the shot's last frame.
        people: By asset id.
        props: (N, 4, 4) world matrices by asset id.
        problems: Cues that could not be performed as planned.
        ends: Second by which each person has finished all cues.
        played: Start and end of cues in seconds, by person, clip and the cue's frame.
        grasps: Second at which a hand moves a door or lid, by person and the cue's frame.
    """

    fps: int
    frames: NDArray[np.int_]
    people: dict[str, PersonTrack]
    props: dict[str, Floats]
    problems: tuple[Problem, ...]
    ends: dict[str, float]
    grasps: dict[tuple[str, int], float] = field(default_factory=dict)
    played: PlayedTimes = field(default_factory=dict)


def box_of(node_id: str, furniture: StageFurniture) -> Obstacle:
    """Return the bounding box of upright furniture as an obstacle that bears its ``node_id``."""
    width, depth, height = furniture.dimensions
    x, y, z = (float(value) for value in furniture.world[:3, 3])
    yaw = math.atan2(furniture.world[1, 0], furniture.world[0, 0])
    return Obstacle(node_id, (x, y, z + height / 2), (width, depth, height), yaw)
