"""Footstep plans: when and where each foot swings, so that feet do not slide and the person arrives on the mark."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, clamp, smooth, smoothstep
from storyblender.blender.motion.gait import Gait
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, facing_yaw, other
from storyblender.catalog.motions import TURN_IN_STRIDE
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2

TURN_FIRST = math.radians(TURN_IN_STRIDE)
"""Larger turns are done on the spot; smaller ones in the first or last steps."""


@dataclass(frozen=True)
class TravelStyle:
    """A way to travel on foot.

    Attributes:
        speed: Metres per second at scale 1; grows with the square root of the scale.
        step: Seconds of one step at that speed.
        stance: Share of the stride during which a foot is down.
        running: Whether there is a flight phase, with bent elbows.
        toe_off: Degrees of pitch when the foot leaves the floor.
        strike: Degrees of pitch when it lands.
        width: Factor on the standing distance of the feet.
        settle: Strides by which the plants lie behind the middle of the stance.
        rise: Steps to reach full speed.
        brake: Steps to stop.
        stoop: Degrees by which the trunk is bent forward.
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

    def slowed(self, speed: float, k: float) -> TravelStyle:
        """Return the style at ``speed`` metres per second for a person of scale ``k``; slower steps take longer."""
        ratio = clamp(speed / (self.speed * math.sqrt(k)), 0.35, 1.6)
        step = self.step if self.running else self.step * ratio**-0.45
        return TravelStyle(**{**vars(self), "speed": self.speed * ratio, "step": step})


WALK = TravelStyle(1.25, 0.54)
HURRY = TravelStyle(1.9, 0.43, 0.57, toe_off=-52, strike=24, stoop=7)
RUN = TravelStyle(3.1, 0.345, 0.36, True, -62, 6, 0.62, 0.055, 1.6, 2.2)
SNEAK = TravelStyle(0.7, 0.70, 0.62, toe_off=-30, strike=2, stoop=20)
STAGGER = TravelStyle(0.75, 0.62, 0.60, toe_off=-30, strike=8, width=1.5, stoop=12)


class WalkPath:
    """A polyline on the floor, measured along its length.

    Args:
        points: (x, y) corners, metres.
    """

    def __init__(self, points: list[Vec2]) -> None:
        self.points = np.array(points, float)
        steps = np.hypot(*np.diff(self.points, axis=0).T)
        self.at_point = np.concatenate([[0.0], np.cumsum(steps)])
        self.length = float(self.at_point[-1])
        marks = np.linspace(0, self.length, 61)
        yaws = np.unwrap([self._heading(float(mark)) for mark in marks])
        self._marks, self._yaws = marks, yaws

    def place(self, distance: float) -> Vector:
        """Return the point (x, y) at ``distance`` metres from the start."""
        d = clamp(distance, 0, self.length)
        x, y = (float(np.interp(d, self.at_point, self.points[:, axis])) for axis in (0, 1))
        return Vector((x, y))

    def heading(self, distance: float) -> float:
        """Return the smoothed yaw of travel at ``distance`` metres, radians, continuous along the path."""
        return float(np.interp(distance, self._marks, self._yaws))

    def _heading(self, distance: float) -> float:
        """Return the yaw of travel at ``distance`` metres, over 0.36 m of the path."""
        ahead = self.place(min(self.length, distance + 0.18)) - self.place(max(0.0, distance - 0.18))
        return facing_yaw(ahead)


@dataclass(frozen=True)
class Swing:
    """One foot in the air, from one plant to the next.

    Attributes:
        start: Second at which it leaves the floor.
        end: Second at which it lands.
        lifted: (9,) foot target at the start.
        planted: (9,) foot target at the end.
        size: Share of a full stride.
        last: Whether the foot stays there.
    """

    start: float
    end: float
    lifted: Floats
    planted: Floats
    size: float
    last: bool


class FootstepPlan:
    """The plan of one walk: travel of the root and swings of both feet.

    A foot lands where the body will be in the middle of the following stance; first and last steps follow from that.
    Steps are added until no landing is too far from the other foot.

    Args:
        who: The walker, at the end of everything planned so far.
        start: Seconds.
        way: Path of the root.
        style: Speed and gait.
        end_yaw: Facing at the end in radians; None keeps the heading.
    """

    def __init__(self, who: Performer, start: float, way: WalkPath, style: TravelStyle, end_yaw: float | None) -> None:
        self.who, self.start, self.way, self.style = who, start, way, style
        root_k = math.sqrt(who.scale)
        self.step = style.step * root_k
        self.swing = 2 * self.step * (1 - style.stance)
        self.accelerate, self.brake = style.rise * self.step, style.brake * self.step
        self.first_turn = shortest_turn(who.yaw, way.heading(0))
        last = way.heading(way.length)
        final = shortest_turn(last, last if end_yaw is None else end_yaw)
        self.last_turn = final if abs(final) < TURN_FIRST else 0.0
        self.leads = "L" if self.first_turn > 0 else "R"
        self.base_yaw = who.yaw + self.first_turn - way.heading(0)
        steady = style.speed * root_k
        count = max(2, round((way.length / steady + (self.accelerate + self.brake) / 2 - self.swing) / self.step) + 1)
        for _ in range(6):
            self._lay_out(count)
            if style.running or self.widest <= 0.78 * who.measures.leg + 0.02:
                break
            count += 1
        self.strength = clamp(self.pace / steady, 0.35, 1.1)

    @property
    def end(self) -> float:
        """Second of arrival."""
        return self.start + self.duration

    @property
    def final_yaw(self) -> float:
        """Facing on arrival, radians."""
        return self._yaw(self.way.length) + self.last_turn

    def travelled(self, t: float) -> float:
        """Return the metres travelled at ``t`` seconds: a trapezoid of speed."""
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
        """Return x, y and yaw of the root at ``t`` seconds."""
        gone, u = self.travelled(t), t - self.start
        place, yaw = self.way.place(gone), self._yaw(gone)
        yaw -= self.first_turn * (1 - smooth(clamp(u / (2 * self.step))))
        turning = 2.2 * self.step
        yaw += self.last_turn * smooth(clamp((u - self.duration + turning) / turning))
        return place.x, place.y, yaw

    def foot(self, side: str) -> Callable[[float], Floats]:
        """Return the foot target of a side as a function of seconds."""
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
        """Return the body's yaw after ``distance`` metres."""
        return self.way.heading(distance) + self.base_yaw

    def _lay_out(self, count: int) -> None:
        """Plan ``count`` steps: duration, speed, and the swings of both feet."""
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
                plant = who.plant(side, place, self.final_yaw)
            else:
                middle = (landing + self.start + (index + 2) * self.step) / 2
                gone = max(0.0, self.travelled(middle) - style.settle * stride)
                place = way.place(gone)
                plant = who.plant(side, place, self._yaw(gone), width=style.width, splay=4)
            plant[3] = now[side][3] + shortest_turn(now[side][3], plant[3])
            length = math.dist(plant[:2], now[side][:2])
            self.widest = max(self.widest, math.dist(plant[:2], now[other(side)][:2]))
            share = clamp(length / max(1e-6, stride))
            self.swings[side].append(Swing(begin, landing, now[side], plant, share, last))
            now[side] = plant

    def _stance(self, side: str, swing: Swing, previous: Swing | None, t: float) -> Floats:
        """Return the target of a foot that is down before ``swing``: it rolls from the heel to the toe joint."""
        since = previous.end if previous else swing.start - 0.6 * self.step
        u = clamp((t - since) / max(1e-6, swing.start - since))
        strike = self.style.strike * previous.size if previous else 0.0
        pitch = 0.0
        if u < 0.18:
            pitch = strike * (1 - u / 0.18)
        elif u > 0.45:
            pitch = self.style.toe_off * swing.size * ((u - 0.45) / 0.55) ** 1.3
        pose = swing.lifted.copy()
        pose[:3] = self.who.rolled_ankle(side, swing.lifted, swing.lifted[3], pitch)
        pose[4], pose[5] = pitch, -min(0.0, pitch)
        return pose

    def _flight(self, side: str, swing: Swing, t: float) -> Floats:
        """Return the target of a foot in the air at ``t`` seconds."""
        who, style = self.who, self.style
        u = (t - swing.start) / (swing.end - swing.start)
        leaving, landing = style.toe_off * swing.size, 0.0 if swing.last else style.strike * swing.size
        along = smoothstep(u) * (0.6 if style.running else 1.0) + (0.4 * u if style.running else 0.0)
        pitch = leaving * (1 - u) ** (1.6 if style.running else 2.5) + landing * u * u
        lift_off = who.rolled_ankle(side, swing.lifted, swing.lifted[3], leaving)
        touch_down = who.rolled_ankle(side, swing.planted, swing.planted[3], landing)
        ankle = lift_off.lerp(touch_down, along)
        ankle.z += (0.05 * swing.size + 0.015) * who.scale * math.sin(math.pi * u)
        if style.running:
            heel = math.sin(math.pi * min(1.0, 1.02 * u)) ** 1.3 * (1 - 0.55 * u)
            ankle.z += 0.42 * who.measures.leg * swing.size * heel
            pitch = leaving * (1 - u) - 38 * swing.size * math.sin(math.pi * u) * (1 - u) + landing * u * u
        pose = swing.lifted * (1 - along) + swing.planted * along
        pose[:3], pose[4], pose[5] = ankle, pitch, -min(0.0, pitch) * (1 - u) * 0.8
        pose[6:9] = math.sin(pose[3]), -math.cos(pose[3]), 0
        return pose

    def perform(self) -> float:
        """Set the plan on the person's channels and return the second of arrival."""
        who = self.who
        who.root.set(self.start, 0, self.root)
        for side in SIDES:
            who.feet[side].set(self.start - 1e-4, 0, self.foot(side))
        offset = self.style.stance + (0.5 if self.leads == "R" else 0.0)
        gait = Gait(self.start, self.end, self.step, self.strength, self.style.running, offset, self.style.stoop)
        who.gaits.append(gait)
        who.position, who.yaw = self.way.place(self.way.length), self.final_yaw
        return self.end
