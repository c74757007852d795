"""A bare stage for the motion tests: marks, cues, simple furniture, a solved shot and its playback."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from mathutils import Matrix, Quaternion, Vector

from storyblender.blender.motion.plan import Performance, StageFurniture, StagePerson, StagePlan, StageProp, box_of
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.body import RiggedBody
from storyblender.blender.people.person import build_person
from storyblender.memory.asset_sheet import Anchor, CharacterLook
from storyblender.memory.shot_context import Blocking, Cue, Mark
from storyblender.memory.vocabulary import Posture

FPS = 24


def build_bodies(*who: str) -> dict[str, RiggedBody]:
    """A man and a girl, or who is asked for of man, woman and girl."""
    return {name: _body(name) for name in who or ("man", "girl")}


@cache
def _body(name: str) -> RiggedBody:
    cast = {"man": (40, "male"), "woman": (28, "female"), "girl": (8, "female")}
    age, gender = cast[name]
    return build_person(name, CharacterLook(age=age, gender=gender), 1).body


def mark_at(who: str, x: float, y: float, yaw: float = 0.0, posture: Posture = "stand", **fields: object) -> Mark:
    """A mark on the floor."""
    values = {"asset_id": who, "location": (x, y, 0.0), "yaw": yaw, "posture": posture, **fields}
    return Mark.model_validate(values)


def cue_of(who: str, clip: str, start: int = 0, **fields: object) -> Cue:
    """A cue at a frame."""
    return Cue.model_validate({"asset_id": who, "clip": clip, "start": start, **fields})


def world_at(x: float, y: float, z: float = 0.0, yaw: float = 0.0) -> np.ndarray:
    """The matrix of a thing that stands upright."""
    return np.array(Matrix.Translation((x, y, z)) @ Matrix.Rotation(math.radians(yaw), 4, "Z"))


def chair_at(x: float, y: float, yaw: float = 0.0) -> StageFurniture:
    """A chair whose seat faces -Y."""
    seat = Anchor(kind="seat", name="seat", location=(0, -0.24, 0.45), size=(0.46, 0.42))
    return StageFurniture(world_at(x, y, 0, yaw), (0.46, 0.48, 0.9), (seat,), "chair")


def table_at(x: float, y: float) -> StageFurniture:
    """A table."""
    top = Anchor(kind="top", name="top", location=(0, 0, 0.75), size=(1.2, 0.7))
    return StageFurniture(world_at(x, y), (1.2, 0.7, 0.75), (top,), "table")


def perform(
    bodies: dict[str, RiggedBody],
    marks: tuple[Mark, ...],
    cues: tuple[Cue, ...],
    seconds: float,
    *,
    ends: tuple[Mark, ...] = (),
    furniture: dict[str, StageFurniture] | None = None,
    props: dict[str, StageProp] | None = None,
    jackets: bool = False,
) -> Performance:
    """A solved shot on this stage."""
    last = {mark.asset_id: mark for mark in (*marks, *ends)}
    furniture = furniture or {}
    plan = StagePlan(
        people={
            m.asset_id: StagePerson(bodies[m.asset_id], Blocking(start=m, end=last[m.asset_id]), jackets) for m in marks
        },
        frames=round(seconds * FPS),
        cues=cues,
        props=props or {},
        furniture=furniture,
        obstacles=tuple(box_of(node, each) for node, each in furniture.items()),
        seed=3,
    )
    return solve_shot(plan, FPS)


class Playback:
    """Forward kinematics from the solved track alone, as Blender will play it."""

    def __init__(self, body: RiggedBody, performance: Performance, who: str) -> None:
        self.body, self.track = body, performance.people[who]
        self.index = {name: i for i, name in enumerate(body.bone_names)}

    def matrices(self, frame: int) -> dict[str, Matrix]:
        """World matrices of the posed bones."""
        body, track = self.body, self.track
        x, y, z, yaw = track.root[frame]
        world = Matrix.Translation((x, y, z)) @ Matrix.Rotation(yaw, 4, "Z")
        posed: dict[int, Matrix] = {}
        for i in sorted(range(len(body.bone_names)), key=self._depth):
            rest = Matrix(body.rest[i].tolist())
            local = Quaternion(track.rotations[frame, i].tolist()).to_matrix().to_4x4()
            parent = body.parents[i]
            if parent < 0:
                posed[i] = rest @ Matrix.Translation(Vector(track.hips[frame].tolist())) @ local
            else:
                posed[i] = posed[parent] @ Matrix(body.rest[parent].tolist()).inverted() @ rest @ local
        return {body.bone_names[i]: world @ matrix for i, matrix in posed.items()}

    def joint(self, bone: str, frame: int) -> Vector:
        return self.matrices(frame)[bone].translation

    def skin(self, frame: int) -> np.ndarray:
        """Skinned vertices, world."""
        posed = self.matrices(frame)
        moves = np.array(
            [np.array(posed[n] @ Matrix(self.body.rest[i].tolist()).inverted()) for n, i in self.index.items()]
        )
        blended = np.einsum("vb,bij->vij", self.body.weights, moves)
        points = np.c_[self.body.vertices, np.ones(len(self.body.vertices))]
        return np.einsum("vij,vj->vi", blended, points)[:, :3]

    def _depth(self, i: int) -> int:
        parent = self.body.parents[i]
        return 0 if parent < 0 else 1 + self._depth(parent)
