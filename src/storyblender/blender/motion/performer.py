"""One person on the stage: channels of targets, and the solve of a pose from them at a moment.

World frame in metres; at yaw 0 a person faces -Y, and +X is to their left. Angles are degrees, yaws radians. The root
(x, y, yaw) places the person on the floor; hips, spine and head are in the root's frame, feet and hands are targets in
the world (notes: motion, sections 1 and 2).
"""

from __future__ import annotations

import math
from bisect import bisect_right

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Channel, Floats, TargetOf, clamp, smooth
from storyblender.blender.motion.gait import Gait
from storyblender.blender.motion.liveliness import angles_of, lid_at, moments_of, mouth_at
from storyblender.blender.motion.measures import measure
from storyblender.blender.motion.overlay import Overlay, lay_over
from storyblender.blender.motion.skeleton import IDENTITY, SIDES, Skeleton, about, frame, sign
from storyblender.blender.people.body import RiggedBody
from storyblender.catalog.expressions import FACE, values_of

FloorPoint = Vector | tuple[float, float]
"""x and y, metres."""
MOUTH, BLINK = FACE.index("mouth_open"), FACE.index("blink")
NEAREST = 0.42
"""Arm lengths between shoulder and wrist; nearer hands make a detour around the shoulder."""
SHIFTING = 1.1
"""Seconds of a weight shift from one leg to the other."""
SHORT_REACH = 0.004
"""Metres, times the scale, that a hand may miss before the trunk leans after it."""


class Performer:
    """A person who can be posed at any moment of the shot.

    Clips plan ahead: ``position``, ``yaw``, ``posture``, ``support``, ``held`` (side -> asset id), ``home`` (side ->
    target of the free hand) and ``free`` (part of the body -> second from which it may be used) describe the end of
    everything planned so far. ``pose_...`` methods solve the body at one moment; ``point`` and others read that pose.

    Args:
        asset_id: Asset of the person.
        body: Measured skeleton and skin.
        seed: For sways, blinks and glances.
    """

    def __init__(self, asset_id: str, body: RiggedBody, seed: int) -> None:
        self.asset_id, self.body = asset_id, body
        self.measures = measure(body)
        self.scale = self.measures.scale
        self.bones = Skeleton(body)
        self.eye_offset = (self.bones.head["eye.L"] + self.bones.head["eye.R"]) / 2 - self.bones.head["head"]
        """From the joint of the head to the middle of the eyes, in rest axes."""
        self.rng = np.random.default_rng(seed)
        self.breathing = self.rng.uniform(0, 2 * math.pi)
        self.root = Channel((0, 0, 0))
        self.level = Channel(0.0)
        """Height of the ground under the person in metres; feet are relative to it."""
        self.ground = 0.0
        """Value of ``level`` at the end of everything planned so far."""
        self.engaged: set[str] = set()
        """Hands that a lasting motion keeps busy."""
        self.hips = Channel((0, 0, self.standing_height, 0, 0, 0))
        """x, y and height of the middle of the hip joints in the root's frame, metres; rotation x, y, z, degrees."""
        self.pinned = Channel(0.0)
        """1 while a seat, the floor or a bed carries the pelvis, 0 while the legs do."""
        self.spine = Channel((0, 0, 0))
        """Bend, side bend and twist of the posture in degrees, shared by three bones."""
        self.accent = Channel((0, 0, 0))
        """The same, added by gestures."""
        self.nod = Channel((0, 0, 0))
        """Pitch, roll, yaw of the head on top of the gaze."""
        self.gaze, self.eyes = Channel(self.ahead), Channel(self.ahead)
        self.expression = "neutral"
        """Base expression of the person in this shot."""
        self.face = Channel(values_of({}))
        self.life = Channel(1.0)
        """Amount of idle sway."""
        self.lean_after = Channel(1.0)
        """1: the trunk leans after hands that cannot reach; 0 for hands that move with the chest."""
        self.seated = Channel(0.0)
        """Weight of the ``sit`` shape key of clothes."""
        self.home: dict[str, TargetOf] = {}
        self.feet = {side: Channel(self.plant(side, (0, 0), 0)) for side in SIDES}
        self.hands = {side: Channel((0,) * 15) for side in SIDES}
        self.gaits: list[Gait] = []
        self.overlays: list[Overlay] = []
        """Recorded motions that lie over trunk and head."""
        self.speeches: list[tuple[float, float, float, float]] = []
        """Start, end, opening of the mouth, syllables per second."""
        self.blinks = moments_of(self.rng, 0.8, 2.0, 5.5)
        glances = moments_of(self.rng, 0.0, 0.5, 2.4)
        self.glances = [(t, self.rng.normal(0, 2.2), self.rng.normal(0, 1.2)) for t in glances]
        way = self.rng.choice((-1.0, 1.0))
        starts = moments_of(self.rng, -self.rng.uniform(2, 6), 4.0, 9.0)
        self.shifts = [(t, way * (-1) ** n * self.rng.uniform(0.5, 1.3)) for n, t in enumerate(starts)]
        """Second and amount of each weight shift."""
        self.position, self.yaw = Vector((0, 0)), 0.0
        self.posture, self.support = "stand", ""
        self.bedside: object | None = None
        """The seat from which they lay down and to which they get up."""
        self.held: dict[str, str] = {}
        self.table: dict[str, Vector] = {}
        """Where each hand can lie on the table they sit at; empty without a table."""
        self.free: dict[str, float] = dict.fromkeys(("body", "head", "L", "R"), 0.0)
        self.place, self.heading = Vector((0, 0, 0)), 0.0
        self.facing, self.facing_inverse = IDENTITY, IDENTITY
        self.missed = {side: 0.0 for side in SIDES}

    @property
    def standing_height(self) -> float:
        """Height of the hip joints while standing at ease, metres."""
        return self.measures.hip_height - 0.006 * self.scale

    def place_at_start(self, x: float, y: float, yaw: float, level: float = 0.0) -> None:
        """Stand at ``x``, ``y`` (metres) with ``yaw`` (radians), ground ``level`` metres high, before the first cue."""
        self.level, self.ground = Channel(level), level
        self.position, self.yaw = Vector((x, y)), yaw
        self.root = Channel((x, y, yaw))
        self.feet = {side: Channel(self.plant(side, (x, y), yaw)) for side in SIDES}

    @property
    def forward(self) -> Vector:
        """Unit vector on the floor in the planned facing."""
        return Vector((math.sin(self.yaw), -math.cos(self.yaw)))

    @property
    def left(self) -> Vector:
        """Unit vector on the floor to the person's left, in the planned facing."""
        return Vector((math.cos(self.yaw), math.sin(self.yaw)))

    def hand_holding(self, asset_id: str) -> str | None:
        """Return the hand, ``L`` or ``R``, that holds a prop, or None."""
        return next((side for side, held in self.held.items() if held == asset_id), None)

    def facing_at(self, t: float) -> Matrix:
        """Return the 3x3 rotation of the root at ``t`` seconds."""
        return Matrix.Rotation(float(self.root(t)[2]), 3, "Z")

    def point_above_place(self, height: float) -> Vector:
        """Return the world point above the planned position at a share of the shoulders' height."""
        return Vector((*self.position, self.ground + height * self.measures.shoulder_height))

    def ahead(self, t: float) -> tuple[float, float, float]:
        """Return a world point 8 m straight ahead at ``t`` seconds, a little below the eyes."""
        x, y, yaw = self.root(t)
        level = float(self.level(t))
        return x + 8 * math.sin(yaw), y - 8 * math.cos(yaw), level + self.measures.eye_height * 0.93

    def plant(
        self, side: str, place: FloorPoint, yaw: float, *, width: float = 1.0, splay: float = 7.0, back: float = 0.0
    ) -> Floats:
        """Return the target of a standing foot: (9,) ankle x, y, z, yaw, pitch, toe pitch, knee direction.

        The person is at ``place``, facing ``yaw`` (radians); the foot is ``side``, ``L`` or ``R``. ``width`` is a
        factor on the normal distance of the feet, ``splay`` the degrees that the toes point outwards, ``back`` the
        metres that the foot is behind its normal place. The target has its yaw in radians, its pitches in degrees.
        """
        (x, y), cos, sin = place[:2], math.cos(yaw), math.sin(yaw)
        aside, behind = sign(side) * self.measures.stance * width, self.measures.foot_y + back
        turned = yaw + sign(side) * math.radians(splay)
        ankle = (x + cos * aside - sin * behind, y + sin * aside + cos * behind, self.measures.ankle)
        return np.array([*ankle, turned, 0, 0, math.sin(turned), -math.cos(turned), 0])

    def rolled_ankle(self, side: str, ankle: Floats, yaw: float, pitch: float) -> Vector:
        """Return the ``ankle`` of a flat foot at ``yaw`` radians after a roll by ``pitch`` degrees, > 0 on the heel."""
        flat = about("Z", math.degrees(yaw - self.measures.toe_out[side]))
        tilted = flat @ self.bones.pitch(side, pitch)
        along = self.bones.head[f"toe.{side}"] - self.bones.head[f"foot.{side}"]
        if pitch < 0:
            pivot = along
        else:
            back = Vector((along.x, along.y, 0)).normalized() * (-0.052 * self.scale)
            pivot = back + Vector((0, 0, -self.measures.ankle))
        return Vector(ankle[:3]) + flat @ pivot - tilted @ pivot

    def is_free(self, side: str) -> bool:
        """Return whether a hand holds nothing and no lasting motion keeps it busy."""
        return side not in self.held and side not in self.engaged

    def look_freely(self, t: float) -> None:
        """Look straight ahead from ``t`` seconds on, head level."""
        self.eyes.set(t, 0.1, self.ahead)
        self.gaze.set(t, 0.5, self.ahead)
        self.nod.set(t, 0.5, (0, 0, 0))

    def to_body(self, point: Vector) -> Vector:
        """Convert a world point to armature space, in the current pose."""
        return self.facing_inverse @ (point - self.place)

    def to_world(self, point: Vector) -> Vector:
        """Convert a point in armature space to the world, in the current pose."""
        return self.facing @ point + self.place

    def point(self, bone: str, offset: tuple[float, float, float] | Vector = (0, 0, 0)) -> Vector:
        """Return the world point ``offset`` metres (rest axes) from a bone's joint, in the current pose."""
        return self.to_world(self.bones.point(bone, Vector(offset)))

    def eyes_point(self) -> Vector:
        """Return the world point between the eyes, in the current pose."""
        return (self.point("eye.L") + self.point("eye.R")) / 2

    def breast_point(self) -> Vector:
        """Return the world point between the shoulders, in the current pose; not above the feet of a seated person."""
        return (self.point("upper_arm.L") + self.point("upper_arm.R")) / 2

    def direction(self, bone: str, vector: Vector) -> Vector:
        """Return the world direction of a rest-pose direction ``vector`` that turns with a bone."""
        return self.facing @ (self.bones.orient[bone] @ vector)

    def palm_offset(self, side: str, fingers: Vector, palm: Vector) -> Vector:
        """Return wrist to palm centre (metres) of a hand with these directions, in the frame they are given in."""
        along = fingers.normalized()
        out = (palm - along * palm.dot(along)).normalized()
        return along * (0.72 * self.measures.hand) + out * self.measures.palm[side]

    def gait_at(self, t: float) -> tuple[float, float, Gait | None]:
        """Return swing strength, stride phase 0..1 and gait at ``t`` seconds; 0, 0, None while not travelling."""
        for gait in self.gaits:
            if gait.start <= t <= gait.end:
                return gait.strength(t), gait.phase(t), gait
        return 0.0, 0.0, None

    def pose_trunk(self, t: float, drop: float = 0.0) -> None:
        """Pose root, pelvis and spine at ``t`` seconds, the pelvis lowered by ``drop`` metres to reach the feet."""
        swing, phase, gait, sway = self._pose_pelvis(t, drop)
        self._pose_spine(t, swing, phase, gait, sway)
        self.bones.update_all()

    def _pose_pelvis(self, t: float, drop: float = 0.0) -> tuple[float, float, Gait | None, float]:
        """Pose root and pelvis, everything else at rest; return swing strength, stride phase, gait and sway."""
        x, y, yaw = (float(value) for value in self.root(t))
        self.place, self.heading = Vector((x, y, float(self.level(t)))), yaw
        self.facing = Matrix.Rotation(yaw, 3, "Z")
        self.facing_inverse = self.facing.transposed()
        bones, k = self.bones, self.scale
        bones.turn = dict.fromkeys(bones.names, IDENTITY)
        dx, dy, height, rx, ry, rz = self.hips(t)
        swing, phase, gait = self.gait_at(t)
        sway = self._weight(t) * float(self.life(t)) * max(0.0, 1 - swing)
        if swing > 0 and gait is not None:
            dx, height = self._pelvis_swing(swing, phase, gait, dx, height)
        pinned = float(self.pinned(t)) > 0.5
        if not pinned:
            dx, ry = dx + 0.020 * k * sway, ry - 1.8 * sway
        bones.turn["hips"] = about("Z", rz) @ about("Y", ry) @ about("X", rx) @ bones.turn["hips"]
        middle = (bones.head["thigh.L"] + bones.head["thigh.R"]) / 2
        to_hips = bones.head["hips"] - middle
        bones.offset = Vector((dx, middle.y + dy, height - drop)) + bones.turn["hips"] @ to_hips - bones.head["hips"]
        return swing, phase, gait, sway

    def _weight(self, t: float) -> float:
        """Return how much of the weight is on the left leg (> 0) or the right (< 0), about -1.3..1.3."""
        newest = bisect_right(self.shifts, t, key=lambda each: each[0]) - 1
        start, there = self.shifts[max(newest, 0)]
        before = self.shifts[newest - 1][1] if newest > 0 else there
        return before + (there - before) * smooth(clamp((t - start) / SHIFTING))

    def _pelvis_swing(self, swing: float, phase: float, gait: Gait, dx: float, height: float) -> tuple[float, float]:
        """Turn the pelvis with the gait; return the changed sideways offset and height of the hips."""
        turn, k = 2 * math.pi * phase, self.scale
        if gait.running:
            self.bones.rotate("hips", x=5 * swing, z=-9 * swing * math.cos(turn))
            self.bones.rotate("hips", y=2 * swing * math.sin(turn))
            rise = swing * self.measures.leg * (-0.036 + 0.030 * math.cos(2 * turn))
            return dx + 0.006 * k * math.sin(turn) * swing, height + rise
        self.bones.rotate("hips", x=2 * swing, y=2.5 * swing * math.sin(turn), z=-5 * swing * math.cos(turn))
        low = 0.0025 * gait.stoop
        return (dx + 0.018 * k * math.sin(turn) * swing, height - (0.018 * math.cos(2 * turn) + 0.02 + low) * k * swing)

    def _pose_spine(self, t: float, swing: float, phase: float, gait: Gait | None, sway: float) -> None:
        """Turn the three spine bones: posture, accents, breath, gait and sway."""
        bend, side, twist = self.spine(t) + self.accent(t)
        breath = 0.5 * math.sin(2 * math.pi * 0.27 * t + self.breathing) * float(self.life(t))
        if gait is not None:
            twist += (9 if gait.running else 8) * swing * math.cos(2 * math.pi * phase)
            bend += swing * (10 if gait.running else gait.stoop)
        for bone, share in (("spine", 0.32), ("chest", 0.36), ("upper_chest", 0.32)):
            self.bones.rotate(bone, x=(bend + breath) * share, y=(side + 1.6 * sway) * share, z=twist * share)
        lay_over(self.bones, self.overlays, ("spine", "chest", "upper_chest"), t)

    def needed_drop(self, t: float) -> float:
        """Return the metres by which the pelvis must sink at ``t`` seconds for both legs to reach their feet."""
        self._pose_pelvis(t)
        self.bones.update("hips", "thigh.L", "thigh.R")
        need = 0.0
        for side in SIDES:
            ankle, hip = self._on_level(self.feet[side](t)), self.bones.joint[f"thigh.{side}"]
            across = (hip.x - ankle.x) ** 2 + (hip.y - ankle.y) ** 2
            need = max(need, hip.z - ankle.z - math.sqrt(max(1e-6, (0.994 * self.measures.leg) ** 2 - across)))
        return need * (1 - float(self.pinned(t)))

    def _on_level(self, foot: Floats) -> Vector:
        """Return the ankle of a foot target in armature space, in the current pose."""
        return self.to_body(Vector((foot[0], foot[1], foot[2] + self.place.z)))

    def pose_legs(self, t: float) -> None:
        """Solve both legs to their foot targets at ``t`` seconds; the trunk must be posed."""
        bones = self.bones
        for side in SIDES:
            foot = self.feet[side](t)
            pole = self.facing_inverse @ Vector(foot[6:9])
            ankle = self._on_level(foot)
            bones.reach(f"thigh.{side}", f"shin.{side}", f"foot.{side}", ankle, pole)
            flat = about("Z", math.degrees(foot[3] - self.heading - self.measures.toe_out[side]))
            bones.set_orient(f"foot.{side}", flat @ bones.pitch(side, foot[4]))
            bones.turn[f"toe.{side}"] = bones.pitch(side, foot[5])
            bones.update(f"toe.{side}")

    def pose_arms(self, t: float, sides: str = "LR") -> None:
        """Solve the arms of ``sides`` (``LR``: both) at ``t`` seconds; the trunk leans once if a hand falls short."""
        for attempt in (0, 1):
            worst, missing = 0.0, Vector((0, 0, 0))
            for side in sides:
                short, gap = self._pose_arm(side, self.hands[side](t))
                self.missed[side] = max(0.0, short)
                worst = max(worst, short)
                if short > SHORT_REACH * self.scale:
                    missing = missing + gap
            if attempt or worst < SHORT_REACH * self.scale or float(self.lean_after(t)) < 0.5:
                return
            self._lean(worst, missing)

    def _pose_arm(self, side: str, hand: Floats) -> tuple[float, Vector]:
        """Solve one arm to a hand target; return how many metres it falls short, and shoulder to wrist."""
        bones, m = self.bones, self.measures
        fingers, palm, pole = (self.facing_inverse @ Vector(hand[i : i + 3]) for i in (3, 6, 9))
        wrist = self.to_body(Vector(hand[:3])) - self.palm_offset(side, fingers, palm)
        shoulder = f"shoulder.{side}"
        bones.turn[shoulder] = IDENTITY
        bones.update(shoulder, f"upper_arm.{side}")
        away = bones.orient["upper_chest"].transposed() @ (wrist - bones.joint[f"upper_arm.{side}"])
        cramped = NEAREST * m.arm - away.length
        if cramped > 0:  # on its way past the shoulder the hand makes a detour, or the arm would flip over
            detour = Vector((sign(side) * 0.6, -1.0, 0)).normalized() * (1.2 * cramped)
            wrist, away = wrist + bones.orient["upper_chest"] @ detour, away + detour
        raised = clamp(away.z / m.arm) * 22
        forth = clamp(-away.y / max(away.length, 0.01) + 0.1)
        protracted = clamp(away.length / m.arm - 0.72, 0, 0.35) * forth * 60
        bones.rotate(shoulder, y=sign(side) * (5 * (1 - raised / 22) - raised), z=-sign(side) * protracted)
        bones.update(shoulder)
        short = bones.reach(f"upper_arm.{side}", f"forearm.{side}", f"hand.{side}", wrist, pole)
        bones.set_hand(side, fingers, palm)
        bones.curl(side, *hand[12:15])
        return short, wrist - bones.joint[f"upper_arm.{side}"]

    def _lean(self, short: float, missing: Vector) -> None:
        """Lean the spine by at most 26 degrees towards what a hand misses by ``short`` metres."""
        flat = Vector((missing.x, missing.y, 0))
        if flat.length < 0.02:
            return
        torso = (self.bones.joint["neck"] - self.bones.joint["spine"]).length
        degrees = math.degrees(min(0.45, 1.15 * short / torso))
        axis = Vector((0, 0, 1)).cross(flat.normalized())
        for bone in ("spine", "chest", "upper_chest"):
            self.bones.turn[bone] = about(axis, degrees / 3) @ self.bones.turn[bone]
        self.bones.update_upper()

    def pose_head(self, t: float) -> None:
        """Turn head and eyes to the points looked at: the head takes most of the yaw, the eyes the rest."""
        bones = self.bones
        bones.update("neck", "head")
        chest_back = bones.orient["upper_chest"].transposed()
        between = (bones.head["eye.L"] - bones.head["head"]) * 0.5
        yaw, pitch = angles_of(chest_back @ (self.to_body(Vector(self.gaze(t))) - bones.point("head", between)))
        yaw = clamp(0.82 * clamp(yaw, -88, 88), -75, 75)
        pitch = clamp(0.70 * clamp(pitch, -60, 55), -34, 30)
        nod, roll, shake = self.nod(t)
        bones.turn["neck"] = about("Z", 0.4 * yaw) @ about("X", 0.3 * nod - 0.35 * pitch) @ about("Y", 0.3 * roll)
        turned = about("Z", 0.6 * yaw + shake) @ about("X", 0.7 * nod - 0.65 * pitch)
        bones.turn["head"] = turned @ about("Y", 0.7 * roll)
        lay_over(bones, self.overlays, ("neck", "head"), t)
        bones.update("neck", "head")
        head_back = bones.orient["head"].transposed()
        newest = bisect_right(self.glances, t, key=lambda each: each[0]) - 1
        glance = self.glances[newest][1:] if newest >= 0 else (0.0, 0.0)
        for side in SIDES:
            eye = f"eye.{side}"
            bones.update(eye)
            x, y = angles_of(head_back @ (self.to_body(Vector(self.eyes(t))) - bones.joint[eye]))
            x, y = clamp(x + glance[0], -30, 30), clamp(y + glance[1], -22, 20)
            bones.turn[eye] = about("Z", x) @ about("X", -y)
        bones.update("jaw", "eye.L", "eye.R")

    def face_at(self, t: float) -> Floats:
        """Return the ``FACE`` values at ``t`` seconds, with blinks and the mouth movement of speech."""
        values = np.array(self.face(t), float)
        values[BLINK] = max(values[BLINK], lid_at(t, self.blinks, self.speeches))
        values[MOUTH] = max(values[MOUTH], mouth_at(t, self.speeches))
        return np.clip(values, 0, 1)

    def hand_matrix(self, side: str) -> tuple[Matrix, Vector]:
        """Return the axes (fingers, palm, across) and the palm centre of the posed hand, world."""
        rest_fingers, rest_palm = self.bones.hand_axes(side)
        fingers = self.direction(f"hand.{side}", rest_fingers)
        axes = frame(fingers, self.direction(f"hand.{side}", rest_palm))
        palm = Vector(axes.col[1])
        return axes, self.point(f"hand.{side}") + self.palm_offset(side, Vector(axes.col[0]), palm)
