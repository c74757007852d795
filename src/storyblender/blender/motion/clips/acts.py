"""Plays the acts of the catalogue: turns rows of key poses into keys on a person's channels."""

from __future__ import annotations

from dataclasses import replace

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, Target, TargetOf
from storyblender.blender.motion.clips.gaze import look_at, look_at_subject, point_aside, show_mood
from storyblender.blender.motion.clips.handling import (
    approach,
    bend_to_reach,
    pick_up,
    prop_of,
    straighten_up,
    take_in_hand,
)
from storyblender.blender.motion.clips.locomotion import step_to
from storyblender.blender.motion.clips.pairs import meet, reserve_hands
from storyblender.blender.motion.clips.registry import CLIPS, Clip, Play
from storyblender.blender.motion.clips.using import table_height
from storyblender.blender.motion.clips.work import WORKING, working_point
from storyblender.blender.motion.hands import chest_yaw, hand, shoulder_rest
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, UP, other, rigid_matrix, sign
from storyblender.blender.motion.staged_props import Grip, StagedProp, carrying_hand
from storyblender.catalog.acts import ACTS
from storyblender.catalog.acts.entry import HOME_SECONDS, Act, FootPose, Gaze, HandPose, Key, Triple

AT_HAND = 1.3
"""Largest distance in metres at which a prop is picked up for an act; farther props start in the hand."""
WITHIN, BEFORE_SITTER = 0.62, 0.20
"""Metres at a stature of 1.7 m: the reach of a seated person, and how far in front of them they work on a table."""
OVER_WORK = 0.12
"""Metres between working hands and the surface, at a stature of 1.7 m."""
PLANTED = 0.85
"""Metres above the floor of a hand that leans on something unseen, at a stature of 1.7 m."""
STEP_LIFT = 0.03
"""Metres that a foot is lifted in a step, at a stature of 1.7 m."""


def _uses(act: Act) -> tuple[str, ...]:
    """Return the parts of the body that an act needs."""
    keys = act.keys
    uses = ["body"] if act.bodily or act.reach == "person" else []
    uses += {0: [], 1: ["hand"], 2: ["hands"]}[act.hands]
    return (*uses, "head") if any(key.nod or key.gaze or key.face for key in keys) else tuple(uses)


def _play_of(act: Act) -> Play:
    """Return the clip function of an act."""

    def play(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
        return _Playing(stage, who, cue, act).run()

    return play


class _Playing:
    """The performance of one act.

    Args:
        stage: The stage.
        who: The actor.
        cue: Time, prop and target.
        act: The act to perform.
    """

    def __init__(self, stage: MotionStage, who: Performer, cue: StagedCue, act: Act) -> None:
        self.stage, self.who, self.cue, self.act = stage, who, cue, act
        self.partner = cue.target if isinstance(cue.target, Performer) and cue.target is not who else None
        self.lead = self._acting_hand()
        self.spot = Vector((0, 0, 0))

    def run(self) -> float:
        """Set all keys of the act and return the end in seconds."""
        who, act = self.who, self.act
        t = self._tool_in_hand(self.cue.start)
        if self.partner is not None and act.reach == "person":
            t = meet(self.stage, who, self.partner, replace(self.cue, start=t), act.distance * who.scale)
        poses = [pose for key in act.keys for pose in (key.lead, key.far) if pose is not None]
        bent = 0.0
        if any(pose.frame == "work" for pose in poses):
            t = approach(
                self.stage, who, self.cue, working_point(self.stage, who, self.cue)[0], WORKING * who.measures.arm
            )
            self.spot = self._worked_on(working_point(self.stage, who, self.cue)[0])
            bent = bend_to_reach(who, t, 0.6, self.spot + UP * (OVER_WORK * who.scale))
        if poses:
            who.lean_after.set(t, 0, 0.0 if all(pose.frame in ("chest", "head") for pose in poses) else 1.0)
        end = t + max(act.once, (self.cue.duration or 0.0) - (0.0 if act.stays else HOME_SECONDS))
        self._steady_tool(t, end)
        if self.partner is not None and act.partner:
            _Playing(self.stage, self.partner, replace(self.cue, start=t, target=who, prop=None), act).react(t)
        now = self._keys(t, end)
        if act.stays or now > self.stage.seconds - 0.3:
            return now
        self._home(now)
        if bent:
            straighten_up(who, now, HOME_SECONDS)
        return now + HOME_SECONDS

    def _worked_on(self, place: Vector) -> Vector:
        """Return where the hands work: at ``place``, or on the table top if a seated actor cannot reach it."""
        who, k = self.who, self.who.scale
        subject = self.cue.target or self.cue.prop
        in_hand = isinstance(subject, StagedProp) and subject.holder is who
        far = (place.xy - who.position).length > WITHIN * k
        if who.posture != "sit" or not (in_hand or subject is None or far):
            return place
        ahead = who.position + who.forward * (BEFORE_SITTER * k)
        return Vector((*ahead, table_height(self.stage, who)))

    def react(self, t: float) -> None:
        """Play the partner's reaction to the act."""
        reserve_hands(self.who, SIDES, t, t + sum(key.seconds + key.stay for key in self.act.partner))
        for key in self.act.partner:
            self._key(key, t)
            t += key.seconds + key.stay
        self._home(t, list(self.act.partner))

    def _keys(self, t: float, end: float) -> float:
        """Set all keys and the repetitions until ``end``; return the second at which the last is over."""
        index, keys = 0, self.act.keys
        while index < len(keys):
            key = keys[index]
            self._key(key, t)
            t += key.seconds + key.stay
            index += 1
            if index == len(keys) and self.act.again is not None and self.act.stretches and t < end - 0.1:
                index = self.act.again
        return max(t, end) if self.act.stretches else t

    def _key(self, key: Key, t: float) -> None:
        """Set the keys of one key pose at ``t`` seconds."""
        who, s = self.who, sign(self.lead)
        for side, pose in ((self.lead, key.lead), (other(self.lead), key.far)):
            if pose is not None and self._may_move(side):
                who.hands[side].set(t, key.seconds, self._target(side, pose))
                if pose.frame == "their_hand":
                    self.stage.following_hands.append((who, side, t, t + key.seconds + key.stay + HOME_SECONDS))
        if key.spine is not None:
            who.accent.set(t, key.seconds, (key.spine[0], -s * key.spine[1], s * key.spine[2]))
        if key.nod is not None:
            who.nod.set(t, key.seconds, (key.nod[0], -s * key.nod[1], s * key.nod[2]))
        if key.hips is not None and who.posture == "stand":
            side, ahead, up, pitch = key.hips
            k = who.scale
            who.hips.set(t, key.seconds, (s * side * k, -ahead * k, who.standing_height + up * k, pitch, 0, 0))
        if who.posture == "stand":
            for foot, pose in ((self.lead, key.lead_foot), (other(self.lead), key.far_foot)):
                if pose is not None:
                    step_to(who, foot, t, key.seconds, self._planted(foot, pose), STEP_LIFT * who.scale)
        if key.face is not None:
            show_mood(who, t, key.face, key.seconds)
        if key.gaze is not None:
            self._look(key.gaze, t, key.seconds)

    def _home(self, t: float, keys: list[Key] | None = None) -> None:
        """Return the body parts that the keys moved to their rest pose."""
        who, keys = self.who, list(self.act.keys) if keys is None else keys
        for side, moved in (
            (self.lead, any(key.lead for key in keys)),
            (other(self.lead), any(key.far for key in keys) or self.act.second is not None),
        ):
            held = self.stage.props.get(who.held.get(side, ""))
            if moved and self._may_move(side):
                who.hands[side].set(t, HOME_SECONDS, carrying_hand(who, side, held) if held else who.home[side])
        if any(key.spine for key in keys):
            who.accent.set(t, HOME_SECONDS, (0, 0, 0))
        if any(key.nod for key in keys):
            who.nod.set(t, HOME_SECONDS, (0, 0, 0))
        if who.posture == "stand":
            if any(key.hips for key in keys):
                who.hips.set(t, HOME_SECONDS, (0, 0, who.standing_height, 0, 0, 0))
            feet = ((self.lead, any(k.lead_foot for k in keys)), (other(self.lead), any(k.far_foot for k in keys)))
            for foot, moved in feet:
                if moved:
                    step_to(who, foot, t, 0.4, who.plant(foot, who.position, who.yaw))
        if any(key.face for key in keys):
            show_mood(who, t, "neutral", HOME_SECONDS)
        if any(key.gaze for key in keys):
            look_at(who, t, who.ahead)
        who.lean_after.set(t + HOME_SECONDS, 0, 1.0)

    def _acting_hand(self) -> str:
        """Return the acting hand: the cue's, or the other one if that hand holds an unrelated prop."""
        side, prop = self.cue.side, prop_of(self.cue)
        held = self.who.held.get(side)
        wanted = prop is not None and held == prop.asset_id
        with_tool = any(key.lead is not None and key.lead.tool is not None for key in self.act.keys)
        if held is None or wanted or with_tool or other(side) in self.who.held:
            return side
        return other(side)

    def _may_move(self, side: str) -> bool:
        """Return whether a hand is free to move: it is empty, or holds the prop of the act."""
        held = self.who.held.get(side)
        prop = prop_of(self.cue)
        return held is None or side == self.lead or (prop is not None and held == prop.asset_id)

    def _tool_in_hand(self, t: float) -> float:
        """Take the tool of the act in hand; return the second at which it is held."""
        prop = prop_of(self.cue)
        if prop is None or prop.holder is self.who or not self.act.hands or prop is self.cue.target:
            return t
        if (prop.matrix.translation.xy - self.who.position).length < AT_HAND:
            t = pick_up(self.stage, self.who, replace(self.cue, side=self.lead))
        else:
            take_in_hand(self.stage, self.who, self.lead, prop, t)
        return t

    def _steady_tool(self, t: float, end: float) -> None:
        """Make the other hand hold the tool as well."""
        far, prop = other(self.lead), self.stage.props.get(self.who.held.get(self.lead, ""))
        if self.act.second is None or prop is None or self.who.held.get(far, prop.asset_id) != prop.asset_id:
            return
        grip = _grip_along(prop, far, self.act.second)

        def target(_: float) -> Floats:
            return grip.hand_target(prop.matrix, self.who.facing @ Vector((sign(far) * 0.8, 0.3, -0.6)))

        self.who.hands[far].set(t, 0.6, target)
        self.stage.following_hands.append((self.who, far, t, end + HOME_SECONDS))

    def _target(self, side: str, pose: HandPose) -> TargetOf:
        """Return the target of a hand in a hand pose; the tool, if the pose aims one, decides how the hand turns."""
        who = self.who

        def flip(v: Triple) -> Vector:
            return Vector((sign(side) * v[0], -v[1], v[2]))

        def target(_: float) -> Floats:
            origin, turn, scale = self._frame(side, pose)
            place = origin + turn @ flip(pose.at) * scale
            elbow = (who.facing if pose.frame == "head" else turn) @ flip(pose.elbow)
            held = self.stage.props.get(who.held.get(side, ""))
            if pose.tool is not None and held is not None:
                return _wielding(held.grip(side), place, [turn @ flip(v) for v in pose.tool], elbow)
            return hand(place, turn @ flip(pose.fingers), turn @ flip(pose.palm), elbow, pose.curl)

        return target

    def _frame(self, side: str, pose: HandPose) -> tuple[Vector, Matrix, float]:
        """Return the origin, the axes and the unit length in metres of a hand pose, at the current time."""
        who, k = self.who, self.who.scale
        match pose.frame:
            case "chest":
                turn = who.facing @ who.bones.orient["upper_chest"]
                return who.to_world(shoulder_rest(who, side)), turn, who.measures.arm
            case "upright":
                turn = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
                return who.to_world(shoulder_rest(who, side)), turn, who.measures.arm
            case "head":
                return who.point("head", who.eye_offset), who.facing @ who.bones.orient["head"], k
            case "work":
                return self.spot, who.facing, k
            case "ground":
                return who.place, who.facing, k
            case "planted":
                held = self.stage.props.get(who.held.get(side, ""))
                return who.place + UP * (PLANTED * k if held is None else held.grip(side).palm.z), who.facing, k
            case _:
                return self._of_partner(side, pose.frame), who.facing, k

    def _of_partner(self, side: str, part: str) -> Vector:
        """Return a place on the partner; without one, a place in front of the actor's face or chest."""
        them = self.partner
        if them is None:
            ahead = 0.45 if part == "their_hand" else 0.6
            height = {"their_head": 0.95, "their_hand": 0.5}.get(part, 0.82)
            return self.who.to_world(Vector((0, -ahead * self.who.scale, height * self.who.measures.eye_height)))
        if part == "their_head":
            return them.eyes_point()
        if part == "their_hand":
            near = self.who.to_world(shoulder_rest(self.who, side))
            return min((them.point("hand.L"), them.point("hand.R")), key=lambda place: (place - near).length)
        if part == "their_shoulder":
            near = self.who.to_world(shoulder_rest(self.who, side))
            places = (them.point("upper_arm.L"), them.point("upper_arm.R"))
            return min(places, key=lambda place: (place - near).length)
        return them.point("upper_chest", (0, -them.measures.chest_front, 0))

    def _planted(self, side: str, pose: FootPose) -> Floats:
        """Return the target of a foot in a foot pose."""
        who, k = self.who, self.who.scale
        left = who.left
        spot = who.position + who.forward * (pose.ahead * k) + left * (sign(side) * pose.aside * k)
        foot = who.plant(side, spot, who.yaw)
        foot[2] += pose.up * k
        foot[4] = pose.pitch
        return foot

    def _look(self, gaze: Gaze, t: float, seconds: float) -> None:
        """Look where a gaze says, from ``t`` on."""
        who = self.who
        if gaze == "target":
            look_at_subject(self.stage, who, t, self.cue)
        else:
            look_at(who, t, self._point(gaze), min(0.5, seconds))

    def _point(self, gaze: Gaze) -> Target:
        """Return the point of a gaze."""
        who, k, s = self.who, self.who.scale, sign(self.lead)
        match gaze:
            case "hands":
                return lambda _: tuple(who.point(f"hand.{self.lead}"))
            case "down":
                return lambda _: tuple(who.to_world(Vector((0, -0.9 * k, 0.1))))
            case "up":
                return lambda _: tuple(who.to_world(Vector((0, -1.6 * k, who.measures.eye_height + 1.5 * k))))
            case "left":
                return point_aside(who, 62)
            case "right":
                return point_aside(who, -62)
            case "away":
                return point_aside(who, -48.0 * s, 0.86)
            case "back":
                return point_aside(who, -118.0 * s)
            case _:
                return who.ahead


def _wielding(grip: Grip, place: Vector, axes: list[Vector], elbow: Vector) -> Floats:
    """Return the hand target at a place for a tool whose top and front point along ``axes``."""
    up, front = axes[0].normalized(), axes[1]
    back = -(front - up * front.dot(up)).normalized()
    turn = Matrix((back.cross(up), back, up)).transposed()
    return grip.hand_target(rigid_matrix(turn, place - turn @ grip.palm), elbow)


def _grip_along(prop: StagedProp, side: str, metres: float) -> Grip:
    """Return the grip of a hand moved ``metres`` along a tool, towards its top, or its front if it lies flat."""
    grip = prop.grip(side)
    axis = Vector((0, 0, 1)) if prop.size.z >= prop.size.y else Vector((0, -1, 0))
    place = grip.palm + axis * metres
    for index in (1, 2):
        low = 0.06 if index == 2 else 0.06 - prop.size.y / 2
        high = prop.size.z - 0.06 if index == 2 else prop.size.y / 2 - 0.06
        if abs(axis[index]) > 0:
            place[index] = min(max(place[index], low), max(low, high))
    return replace(grip, palm=place)


for _act in ACTS.values():
    CLIPS[_act.key] = Clip(_act.key, _uses(_act), _play_of(_act))
