"""Walking, running, turning: footstep plans, so that feet never slide and people arrive exactly on their mark."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, clamp, smooth, smoothstep, turn_between
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.performer import Gait, Performer
from storyblender.blender.motion.skeleton import SIDES, other
from storyblender.blender.motion.stage import Beat, Stage
from storyblender.catalog.motions import TURN_IN_STRIDE, TURN_STEP, TURN_STEP_SECONDS
from storyblender.geometry.paths import Vec2, waiting_time

NEAR = 0.06
"""Metres; a mark that near is already reached."""
TURN_FIRST = math.radians(TURN_IN_STRIDE)
"""Larger turns are done on the spot; smaller ones in the first or last steps."""


@dataclass(frozen=True)
class Style:
    """A way to travel.

    Attributes:
        speed: Metres per second at k = 1; grows with the square root of k.
        step: Seconds of one step at that speed.
        stance: Share of the stride a foot is down.
        running: Flight and bent elbows.
        toe_off: Degrees of pitch when the foot leaves.
        strike: Degrees when it lands.
        width: Times the standing distance of the feet.
        settle: How far plants lie behind the middle of the stance, in strides.
        rise: Steps to reach full speed.
        brake: Steps to stop.
        stoop: Degrees of bent trunk.
    """

    speed: float
    step: float
    stance: float = 0.60
    running: bool = False
    toe_off: float = -45
    strike: float = 22
    width: float = 0.8
    settle: float = 0.06
    rise: float = 1.0
    brake: float = 1.3
    stoop: float = 0.0

    def slowed(self, speed: float, k: float) -> Style:
        """Return the same style at another speed in metres per second: slower steps are longer in time."""
        ratio = clamp(speed / (self.speed * math.sqrt(k)), 0.35, 1.6)
        step = self.step if self.running else self.step * ratio**-0.45
        return Style(**{**vars(self), "speed": self.speed * ratio, "step": step})


WALK = Style(1.25, 0.54)
RUN = Style(3.1, 0.345, 0.36, True, -62, 6, 0.62, 0.055, 1.6, 2.2)
SNEAK = Style(0.7, 0.70, 0.62, toe_off=-30, strike=2, stoop=20)
STAGGER = Style(0.75, 0.62, 0.60, toe_off=-30, strike=8, width=1.5, stoop=12)


class Way:
    """A polyline measured along its length."""

    def __init__(self, points: list[Vec2]) -> None:
        self.points = np.array(points, float)
        steps = np.hypot(*np.diff(self.points, axis=0).T)
        self.at_point = np.concatenate([[0.0], np.cumsum(steps)])
        self.length = float(self.at_point[-1])
        marks = np.linspace(0, self.length, 61)
        yaws = np.unwrap([self._heading(float(mark)) for mark in marks])
        self._marks, self._yaws = marks, yaws

    def place(self, distance: float) -> Vector:
        """Return the point at a distance from the start."""
        d = clamp(distance, 0, self.length)
        x, y = (float(np.interp(d, self.at_point, self.points[:, axis])) for axis in (0, 1))
        return Vector((x, y))

    def heading(self, distance: float) -> float:
        """Return the smoothed yaw of travel, continuous along the way."""
        return float(np.interp(distance, self._marks, self._yaws))

    def _heading(self, distance: float) -> float:
        ahead = self.place(min(self.length, distance + 0.18)) - self.place(max(0.0, distance - 0.18))
        return math.atan2(ahead.x, -ahead.y)


@dataclass(frozen=True)
class Swing:
    """One foot in the air: from one plant to the next."""

    start: float
    end: float
    lifted: Floats
    planted: Floats
    size: float
    """Share of a full stride."""
    last: bool


class Footsteps:
    """The plan of one walk: the root's travel and both feet's swings.

    The foot lands where the body will be in the middle of the following stance; the start and stop steps fall out of
    that. Steps are added until no landing is too far from the other foot.

    Args:
        who: Standing where everything planned so far leaves them.
        start: Seconds.
        way: Where to go.
        style: How.
        end_yaw: Facing at the end; None keeps the heading.
    """

    def __init__(self, who: Performer, start: float, way: Way, style: Style, end_yaw: float | None) -> None:
        self.who, self.start, self.way, self.style = who, start, way, style
        root_k = math.sqrt(who.m.k)
        self.step = style.step * root_k
        self.swing = 2 * self.step * (1 - style.stance)
        self.accelerate, self.brake = style.rise * self.step, style.brake * self.step
        self.first_turn = turn_between(who.yaw, way.heading(0))
        last = way.heading(way.length)
        final = turn_between(last, last if end_yaw is None else end_yaw)
        self.last_turn = final if abs(final) < TURN_FIRST else 0.0
        self.leads = "L" if self.first_turn > 0 else "R"
        self.base_yaw = who.yaw + self.first_turn - way.heading(0)
        steady = style.speed * root_k
        count = max(2, round((way.length / steady + (self.accelerate + self.brake) / 2 - self.swing) / self.step) + 1)
        for _ in range(6):
            self._lay_out(count)
            if style.running or self.widest <= 0.78 * who.m.leg + 0.02:
                break
            count += 1
        self.strength = clamp(self.pace / steady, 0.35, 1.1)

    @property
    def end(self) -> float:
        """Second of arrival."""
        return self.start + self.duration

    @property
    def final_yaw(self) -> float:
        """Facing on arrival."""
        return self._yaw(self.way.length) + self.last_turn

    def travelled(self, t: float) -> float:
        """Return metres gone at second ``t``: a trapezoid of speed."""
        u = clamp(t - self.start, 0, self.duration)
        ramps = self.accelerate + self.brake
        if self.duration <= ramps:
            return self.way.length * smoothstep(u / self.duration)
        if u < self.accelerate:
            return self.pace * u * u / (2 * self.accelerate)
        if u < self.duration - self.brake:
            return self.pace * (u - self.accelerate / 2)
        left = self.duration - u
        return self.way.length - self.pace * left * left / (2 * self.brake)

    def root(self, t: float) -> tuple[float, float, float]:
        """Return x, y, yaw at second ``t``."""
        gone, u = self.travelled(t), t - self.start
        place, yaw = self.way.place(gone), self._yaw(gone)
        yaw -= self.first_turn * (1 - smooth(clamp(u / (2 * self.step))))
        turning = 2.2 * self.step
        yaw += self.last_turn * smooth(clamp((u - self.duration + turning) / turning))
        return place.x, place.y, yaw

    def foot(self, side: str) -> Callable[[float], Floats]:
        """Return the foot target over time."""
        swings = self.swings[side]

        def target(t: float) -> Floats:
            previous: Swing | None = None
            for swing in swings:
                if t < swing.start:
                    return self._stance(side, swing, previous, t)
                if t < swing.end:
                    return self._flight(side, swing, t)
                previous = swing
            return previous.planted if previous is not None else self.standing[side]

        return target

    def _yaw(self, distance: float) -> float:
        return self.way.heading(distance) + self.base_yaw

    def _lay_out(self, count: int) -> None:
        who, way, style = self.who, self.way, self.style
        self.duration = (count - 1) * self.step + self.swing
        ramps = (self.accelerate + self.brake) / 2
        self.pace = way.length / (self.duration - ramps if self.duration > 2 * ramps else self.duration)
        stride = self.pace * 2 * self.step
        self.standing = {side: np.array(who.feet[side](self.start), float) for side in SIDES}
        now = {side: pose.copy() for side, pose in self.standing.items()}
        self.swings: dict[str, list[Swing]] = {side: [] for side in SIDES}
        self.widest = 0.0
        for index in range(count):
            side = self.leads if index % 2 == 0 else other(self.leads)
            begin, last = self.start + index * self.step, index + 2 >= count
            landing = begin + self.swing
            if last:
                place = way.place(way.length)
                plant = who.plant(side, place.x, place.y, self.final_yaw)
            else:
                middle = (landing + self.start + (index + 2) * self.step) / 2
                gone = max(0.0, self.travelled(middle) - style.settle * stride)
                place = way.place(gone)
                plant = who.plant(side, place.x, place.y, self._yaw(gone), width=style.width, splay=4)
            plant[3] = now[side][3] + turn_between(now[side][3], plant[3])
            length = math.dist(plant[:2], now[side][:2])
            self.widest = max(self.widest, math.dist(plant[:2], now[other(side)][:2]))
            share = clamp(length / max(1e-6, stride))
            self.swings[side].append(Swing(begin, landing, now[side], plant, share, last))
            now[side] = plant

    def _stance(self, side: str, swing: Swing, previous: Swing | None, t: float) -> Floats:
        """The foot is down before ``swing``: it rolls from the heel, then the heel rises about the toe joint."""
        since = previous.end if previous else swing.start - 0.6 * self.step
        u = clamp((t - since) / max(1e-6, swing.start - since))
        strike = self.style.strike * previous.size if previous else 0.0
        pitch = 0.0
        if u < 0.18:
            pitch = strike * (1 - u / 0.18)
        elif u > 0.45:
            pitch = self.style.toe_off * swing.size * ((u - 0.45) / 0.55) ** 1.3
        pose = swing.lifted.copy()
        pose[:3] = self.who.rolled(side, swing.lifted, swing.lifted[3], pitch)
        pose[4], pose[5] = pitch, -min(0.0, pitch)
        return pose

    def _flight(self, side: str, swing: Swing, t: float) -> Floats:
        who, style = self.who, self.style
        u = (t - swing.start) / (swing.end - swing.start)
        leaving, landing = style.toe_off * swing.size, 0.0 if swing.last else style.strike * swing.size
        along = smoothstep(u) * (0.6 if style.running else 1.0) + (0.4 * u if style.running else 0.0)
        pitch = leaving * (1 - u) ** (1.6 if style.running else 2.5) + landing * u * u
        lift_off = who.rolled(side, swing.lifted, swing.lifted[3], leaving)
        touch_down = who.rolled(side, swing.planted, swing.planted[3], landing)
        ankle = lift_off.lerp(touch_down, along)
        ankle.z += (0.05 * swing.size + 0.015) * who.m.k * math.sin(math.pi * u)
        if style.running:
            heel = math.sin(math.pi * min(1.0, 1.02 * u)) ** 1.3 * (1 - 0.55 * u)
            ankle.z += 0.42 * who.m.leg * swing.size * heel
            pitch = leaving * (1 - u) - 38 * swing.size * math.sin(math.pi * u) * (1 - u) + landing * u * u
        pose = swing.lifted * (1 - along) + swing.planted * along
        pose[:3], pose[4], pose[5] = ankle, pitch, -min(0.0, pitch) * (1 - u) * 0.8
        pose[6:9] = math.sin(pose[3]), -math.cos(pose[3]), 0
        return pose

    def perform(self) -> float:
        """Write the plan to the person's channels and return the second of arrival."""
        who = self.who
        who.root.set(self.start, 0, self.root)
        for side in SIDES:
            who.feet[side].set(self.start - 1e-4, 0, self.foot(side))
        offset = self.style.stance + (0.5 if self.leads == "R" else 0.0)
        gait = Gait(self.start, self.end, self.step, self.strength, self.style.running, offset, self.style.stoop)
        who.gaits.append(gait)
        who.position, who.yaw = self.way.place(self.way.length), self.final_yaw
        return self.end


def step_to(who: Performer, side: str, t: float, duration: float, pose: Floats, lift: float | None = None) -> float:
    """Move one foot to a target in an arc, and return the end."""
    start, goal = np.array(who.feet[side](t), float), np.array(pose, float)
    turn = turn_between(start[3], goal[3])
    height = 0.04 * who.m.k if lift is None else lift

    def target(now: float) -> Floats:
        w = clamp((now - t) / duration)
        e = smooth(w)
        values = start * (1 - e) + goal * e
        values[3] = start[3] + turn * e
        values[2] += height * math.sin(math.pi * w)
        values[4] -= 12 * math.sin(math.pi * w) * (1 - w)
        return values

    who.feet[side].set(t, 0, target)
    return t + duration


def face(who: Performer, t: float, yaw: float) -> float:
    """Turn on the spot to a yaw with footsteps, and return the end."""
    turn = turn_between(who.yaw, yaw)
    x, y = who.position
    if abs(turn) < math.radians(12):
        if abs(turn) > 1e-3:
            who.root.set(t, 0.3, (x, y, who.yaw + turn))
            who.yaw += turn
        return t
    count = max(1, math.ceil(abs(turn) / math.radians(TURN_STEP)))
    beat = TURN_STEP_SECONDS * math.sqrt(who.m.k)
    length = 2 * count * beat + 0.1
    who.root.set(t, 0.95 * length, (x, y, who.yaw + turn))
    lead = "L" if turn > 0 else "R"
    for index in range(2 * count):
        side = lead if index % 2 == 0 else other(lead)
        reached = who.yaw + turn * (index // 2 + 1) / count
        step_to(who, side, t + index * beat, 0.95 * beat, who.plant(side, x, y, reached), 0.035 * who.m.k)
    who.yaw += turn
    return t + length


def travel(
    stage: Stage,
    who: Performer,
    beat: Beat,
    goal: Vec2,
    end_yaw: float | None = None,
    *,
    style: Style = WALK,
    skip: tuple[str, ...] = (),
    partner: Performer | None = None,
) -> float:
    """Find a way to ``goal``, wait for whoever crosses it, turn, go, turn; return the end.

    Where there is no way the person stays, and the stage's problems say so.
    """
    here = (who.position.x, who.position.y)
    if math.dist(here, goal) < NEAR:
        return beat.start if end_yaw is None else face(who, beat.start, end_yaw)
    points = stage.path(who, goal, skip)
    if points is None:
        stage.report("no_path", who, beat, f"{who.asset_id} finds no way to ({goal[0]:.2f}, {goal[1]:.2f})")
        return beat.start
    way = Way(points)
    t = beat.start
    first = way.heading(0)
    turning = abs(turn_between(who.yaw, first)) > TURN_FIRST
    if beat.duration is not None:
        seconds = max(0.5, beat.duration - (0.7 if turning else 0.0))
        style = style.slowed(way.length / max(0.3, seconds - 0.5), who.m.k)
    trial = Footsteps(who, 0.0, way, style, end_yaw)
    lead = 0.6 if turning else 0.0
    wait, gap = waiting_time(lambda u: trial.root(u)[:2], trial.duration, t + lead, stage.others_tracks(who, partner))
    if gap < -0.12:
        stage.report("crossing", who, beat, f"{who.asset_id} walks through somebody by {-gap:.2f} m", -gap)
    t += wait
    if turning:
        t = face(who, t, first)
    t = Footsteps(who, t, way, style, end_yaw).perform()
    return t if end_yaw is None else face(who, t, end_yaw)


def goal_of(stage: Stage, who: Performer, beat: Beat) -> tuple[Vec2, float | None]:
    """Return where a travelling beat ends: its mark, or an arm's length before its target."""
    if beat.mark is not None:
        return (beat.mark.location[0], beat.mark.location[1]), math.radians(beat.mark.yaw)
    if beat.target is not None:
        place = stage.ground_of(beat.target)
        toward = place - who.position
        keep = 1.1 if isinstance(beat.target, Performer) else 0.75
        stop = place - toward.normalized() * min(keep, toward.length)
        return (stop.x, stop.y), math.atan2(toward.x, -toward.y)
    ahead = who.position + who.forward * 2.0
    return (ahead.x, ahead.y), None


@clip("walk", "body")
def walk(stage: Stage, who: Performer, beat: Beat) -> float:
    """Walk to the mark."""
    goal, yaw = goal_of(stage, who, beat)
    return travel(stage, who, beat, goal, yaw)


@clip("run", "body")
def run(stage: Stage, who: Performer, beat: Beat) -> float:
    """Run to the mark; a way too short for a run is walked briskly."""
    goal, yaw = goal_of(stage, who, beat)
    far = math.dist(who.position, goal) > 2.2 * who.m.k
    return travel(stage, who, beat, goal, yaw, style=RUN if far else WALK.slowed(1.8, 1.0))


@clip("sneak", "body")
def sneak(stage: Stage, who: Performer, beat: Beat) -> float:
    """Steal to the mark, bent and slow."""
    goal, yaw = goal_of(stage, who, beat)
    return travel(stage, who, beat, goal, yaw, style=SNEAK)


@clip("stagger", "body")
def stagger(stage: Stage, who: Performer, beat: Beat) -> float:
    """Stumble to the mark: wide uneven steps, the trunk rolls from side to side."""
    goal, yaw = goal_of(stage, who, beat)
    end = travel(stage, who, beat, goal, yaw, style=STAGGER)
    t, roll = beat.start, 1
    while t < end - 0.6:
        who.accent.set(t, 0.55, (6 * (roll > 0), 9 * roll, 4 * roll))
        t, roll = t + 0.6, -roll
    who.accent.set(end - 0.4, 0.6, (0, 0, 0))
    return end


@clip("turn", "body")
def turn(stage: Stage, who: Performer, beat: Beat) -> float:
    """Turn on the spot to the mark's yaw or to the target; without either, around."""
    if beat.mark is not None:
        yaw = math.radians(beat.mark.yaw)
    elif beat.target is not None:
        toward = stage.ground_of(beat.target) - who.position
        yaw = math.atan2(toward.x, -toward.y)
    else:
        yaw = who.yaw + math.pi
    return face(who, beat.start, yaw)


@clip("jump", "body")
def jump(stage: Stage, who: Performer, beat: Beat) -> float:
    """Jump up on the spot, or forward to a mark that is near."""
    t, k = beat.start, who.m.k
    goal = Vector(beat.mark.location).xy if beat.mark else who.position.copy()
    if (goal - who.position).length > 1.6 * k:
        t = travel(stage, who, beat, tuple(who.position.lerp(goal, 0.6)))
        goal = who.position.lerp(goal, min(1.0, 1.2 * k / max(0.01, (goal - who.position).length)))
    air, height = 0.42, 0.28 * k
    crouch, off, down = t + 0.35, t + 0.5, t + 0.5 + air
    stand = who.standing_height
    who.hips.set(t, 0.35, (0, 0.05 * k, stand - 0.24 * k, 20, 0, 0))
    who.spine.set(t, 0.35, (22, 0, 0))
    who.hips.set(crouch, 0.15, (0, 0, stand + 0.05 * k, 0, 0, 0))
    who.spine.set(crouch, 0.2, (-4, 0, 0))
    for side in SIDES:
        who.hands[side].set(t, 0.3, who.home[side])
    start = who.position.copy()

    def arc(now: float) -> float:
        u = clamp((now - off) / air)
        return 4 * height * u * (1 - u)

    def root(now: float) -> tuple[float, float, float]:
        place = start.lerp(goal, clamp((now - off) / air))
        return place.x, place.y, who.yaw

    who.root.set(off, 0, root)
    who.hips.set(off, 0, lambda now: (0, 0, stand + 0.04 * k + arc(now), 0, 0, 0))
    for side in SIDES:
        lifted = np.array(who.feet[side](off), float)
        landed = who.plant(side, goal.x, goal.y, who.yaw, width=1.1)

        def foot(now: float, lifted: Floats = lifted, landed: Floats = landed) -> Floats:
            u = clamp((now - off) / air)
            pose = lifted * (1 - u) + landed * u
            pose[2] += arc(now) + 0.04 * k * math.sin(math.pi * u)
            pose[4] = -35 * math.sin(math.pi * u)
            return pose

        who.feet[side].set(off, 0, foot)
    who.position = goal
    who.hips.set(down, 0.14, (0, 0.04 * k, stand - 0.16 * k, 14, 0, 0))
    who.spine.set(down, 0.16, (16, 0, 0))
    who.hips.set(down + 0.2, 0.5, (0, 0, stand, 0, 0, 0))
    who.spine.set(down + 0.2, 0.5, (0, 0, 0))
    return down + 0.6
