"""The stage of one shot: people, props and furniture together, and the order in which a frame is solved."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Channel
from storyblender.blender.motion.hands import blend_hands
from storyblender.blender.motion.idle_hands import idle_hand
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import Floats, PlayedTimes, Problem, StageFurniture, StagePlan
from storyblender.blender.motion.skeleton import SIDES, facing_yaw
from storyblender.blender.motion.staged_props import StagedProp
from storyblender.geometry.paths import (
    SQUEEZE_RADIUS,
    Footprint,
    Track,
    Vec2,
    clearance,
    find_path,
    find_seat_access,
    walk_through,
)
from storyblender.geometry.seating import list_seats
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import Mark
from storyblender.memory.vocabulary import Mood

PADDING = 0.11
"""Metres between a walking body's disc and furniture; less, and rounded corners and elbows touch it."""
OVERHEAD = 1.9
"""Metres; boxes that begin higher are no obstacle."""
LOW = 0.08
"""Metres; boxes that end lower, rugs and kerbs, are walked over."""
GIRTH, SIDEWAYS = 0.8, 0.3
"""Shares of their radius that others take up: standing, and turned aside where there is no other path."""
EMBRACE = 0.30
"""Metres between two people who hug; nearer, their bodies overlap."""
PointOf = Callable[[float], Vector]


@dataclass(frozen=True)
class Seat:
    """A place to sit.

    Attributes:
        edge: Middle of the front edge on the floor plan, world metres.
        height: Of the sitting surface, metres.
        depth: Metres from front edge to backrest.
        yaw: Facing of the sitter, radians.
        node_id: Of the furniture; empty for the floor.
        width: Of the furniture, metres.
        headroom: Metres from the sitting surface to the roof above; None in the open.
    """

    edge: Vector
    height: float
    depth: float
    yaw: float
    node_id: str = ""
    width: float = 0.5
    headroom: float | None = None

    @property
    def before(self) -> Vector:
        """Unit vector on the floor that points out of the seat."""
        return Vector((math.sin(self.yaw), -math.cos(self.yaw)))


@dataclass(frozen=True)
class StagedCue:
    """A cue with its names resolved to people and props: the input of a clip.

    Attributes:
        start: Seconds.
        duration: Seconds; None for the clip's natural length.
        target: Person, prop or piece of furniture it is directed at.
        prop: The prop handled.
        side: The acting hand, ``L`` or ``R``.
        mark: Where it ends.
        via: Floor points that a walk goes through.
        mood: Mood in which it is played.
        expression: Facial expression from this cue on.
        frame: Start frame of the cue, for reports.
        seed: For gestures.
    """

    start: float
    duration: float | None = None
    target: Performer | StagedProp | StageFurniture | None = None
    prop: StagedProp | None = None
    side: str = "R"
    mark: Mark | None = None
    via: tuple[Vec2, ...] = ()
    mood: Mood = "neutral"
    expression: str = "neutral"
    frame: int = 0
    seed: int = 0


class MotionStage:
    """Everything that moves in the shot.

    Args:
        plan: The shot.
        fps: Frames per second.
        seed_of: Returns the seed of an asset id.
    """

    def __init__(self, plan: StagePlan, fps: int, seed_of: Callable[[str], int]) -> None:
        self.plan, self.fps = plan, fps
        self.people = {name: Performer(name, who.body, seed_of(name)) for name, who in plan.people.items()}
        self.props = {name: StagedProp(name, prop) for name, prop in plan.props.items()}
        self.following_hands: list[tuple[Performer, str, float, float]] = []
        """Hands that follow another person or a moving prop: person, side, start and end in seconds; solved last."""
        self.contacts: list[tuple[float, Performer, str, StagedCue]] = []
        """Seconds at which a hand must have reached its target."""
        self.grasps: dict[tuple[str, int], float] = {}
        """Second at which a door or lid begins to move, by person and the cue's frame."""
        self.played: PlayedTimes = {}
        """Start and end of cues in seconds, by person, clip and the cue's frame."""
        self.problems: list[Problem] = []
        for who in self.people.values():
            who.home = {side: idle_hand(who, side) for side in SIDES}
            for side in SIDES:
                who.hands[side] = Channel(who.home[side], blend_hands)

    @property
    def seconds(self) -> float:
        """Length of the shot."""
        return self.plan.frames / self.fps

    def find_subject(self, name: str | None) -> Performer | StagedProp | StageFurniture | None:
        """Return the person, prop or piece of furniture with an asset id or node id, or None."""
        if not name:
            return None
        found = self.people.get(name) or self.props.get(name) or self.plan.furniture.get(name)
        if found is not None:
            return found
        for prop in self.props.values():
            if prop.node_id == name:
                return prop
        return next((each for each in self.plan.furniture.values() if each.asset_id == name), None)

    def report(self, kind: str, who: Performer, cue: StagedCue, message: str, amount: float = 0.0) -> None:
        """Record that a cue cannot be staged as planned.

        Args:
            kind: As in ``Problem``.
            who: The person concerned.
            cue: Gives the frame.
            message: One sentence for the director.
            amount: Metres or seconds, where there is a number.
        """
        self.problems.append(Problem(kind, who.asset_id, cue.frame, message, amount))

    def expect_contact(self, who: Performer, side: str, t: float, cue: StagedCue) -> None:
        """Have a hand checked against its target when the shot is posed.

        Args:
            who: The person.
            side: ``L`` or ``R``.
            t: Second at which the hand must be at its target.
            cue: A miss is reported on it.
        """
        self.contacts.append((t, who, side, cue))

    def look_point(self, subject: Performer | StagedProp | StageFurniture) -> PointOf:
        """Return what to look at, by seconds: eyes of a person, middle of a prop, front of a piece of furniture."""
        if isinstance(subject, Performer):
            return lambda t: subject.eyes_point()
        if isinstance(subject, StagedProp):
            return lambda t: subject.centre
        top = next((a for a in subject.anchors if a.kind in ("top", "handle")), None)
        height = subject.dimensions[2]
        local = Vector(top.location) if top else Vector((0, -subject.dimensions[1] / 2, min(1.5, 0.6 * height)))
        place = Matrix(subject.world.tolist()) @ local
        return lambda t: place

    def floor_position(self, subject: Performer | StagedProp | StageFurniture) -> Vector:
        """Return the planned position (x, y) of a subject on the floor."""
        if isinstance(subject, Performer):
            return subject.position.copy()
        if isinstance(subject, StagedProp):
            if subject.holder is not None:
                return subject.holder.position.copy()
            return subject.matrix.translation.xy
        return Vector(subject.world[:2, 3].tolist())

    def find_furniture(self, node_id: str | None) -> StageFurniture | None:
        """Return the piece of furniture with a node id or asset id, or None."""
        found = self.find_subject(node_id)
        return found if isinstance(found, StageFurniture) else None

    def find_anchor(self, furniture: StageFurniture, kinds: tuple[str, ...], mark: Mark | None) -> Anchor | None:
        """Return the anchor that a mark names, else the nearest to it; None if none fits.

        Args:
            furniture: Has the anchors, in its own frame.
            kinds: Kinds of anchors that fit, such as ``seat``.
            mark: Its anchor name, else its place, decides; None for the first that fits.
        """
        fitting = [a for a in furniture.anchors if a.kind in kinds]
        if mark is not None and mark.anchor_name:
            fitting = [a for a in fitting if a.name == mark.anchor_name] or fitting
        if not fitting:
            return None
        if mark is None:
            return fitting[0]
        world = Matrix(furniture.world.tolist())
        spot = Vector(mark.location).xy
        return min(fitting, key=lambda a: ((world @ Vector(a.location)).xy - spot).length)

    def find_seat(self, node_id: str | None, mark: Mark | None) -> Seat | None:
        """Return the seat on a piece of furniture: its seat, the edge of its bed, or its top; None if it has none.

        Args:
            node_id: Node id or asset id of the furniture.
            mark: Its place tells which seat, and where along the edge; None for the middle of the first.
        """
        furniture = self.find_furniture(node_id)
        anchor = None
        if furniture is not None:
            anchor = self.find_anchor(furniture, ("seat",), mark) or self.find_anchor(furniture, ("bed",), mark)
            anchor = anchor or next(iter(list_seats(furniture.anchors, furniture.dimensions, on_top=True)), None)
        if furniture is None or anchor is None:
            return None
        world = Matrix(furniture.world.tolist())
        place = world @ Vector(anchor.location)
        if anchor.kind == "bed":
            return self._bedside(world, anchor, mark, node_id or "")
        yaw = facing_yaw(world.to_3x3() @ Vector(anchor.direction))
        edge = place.xy
        if mark is not None:
            along = Vector((math.cos(yaw), math.sin(yaw)))
            slide = (Vector(mark.location).xy - edge).dot(along)
            room = max(0.0, anchor.size[0] / 2 - 0.22)
            edge = edge + along * max(-room, min(room, slide))
        name, wide = self._name_of(furniture), furniture.dimensions[0]
        return Seat(edge, place.z, anchor.size[1] or 0.4, yaw, name, wide, anchor.clearance)

    def _bedside(self, world: Matrix, bed: Anchor, mark: Mark | None, node_id: str) -> Seat:
        """Return the seat on the long edge of a bed that is nearest to the mark."""
        middle = world @ Vector(bed.location)
        feet = (world.to_3x3() @ Vector(bed.direction)).xy.normalized()
        side = Vector((-feet.y, feet.x))
        width = bed.size[0] or 0.9
        if mark is not None and (Vector(mark.location).xy - middle.xy).dot(side) < 0:
            side = -side
        return Seat(middle.xy + side * (width / 2), middle.z, width, facing_yaw(Vector((*side, 0))), node_id)

    def _name_of(self, furniture: StageFurniture) -> str:
        """Return the node id of a piece of furniture."""
        return next((name for name, each in self.plan.furniture.items() if each is furniture), "")

    def seat_access(self, who: Performer, seat: Seat) -> Vector:
        """Return the position (world x, y in metres) where a person stands before sitting down on a seat."""
        boxes = [box for box in self.footprints(who) if box.name not in self.people]
        return Vector(find_seat_access(tuple(seat.edge), seat.yaw, seat.width, who.scale, boxes, seat.node_id))

    def footprints(self, who: Performer, skip: tuple[str, ...] = (), girth: float = GIRTH) -> list[Footprint]:
        """Return the boxes and people that a walker goes around.

        Args:
            who: The walker.
            skip: Node ids and asset ids to leave out.
            girth: Share of their radius that other people take up.
        """
        boxes = [
            Footprint(box.centre[:2], box.size[:2], box.yaw, name=box.node_id)
            for box in self.plan.obstacles
            if box.node_id not in skip
            and box.centre[2] - box.size[2] / 2 < OVERHEAD
            and box.centre[2] + box.size[2] / 2 > LOW
        ]
        others = [
            Footprint(tuple(o.position), (0.0, 0.0), 0.0, girth * o.measures.radius, o.asset_id)
            for o in self.people.values()
            if o is not who and o.asset_id not in skip
        ]
        return boxes + others

    def path_to(
        self, who: Performer, goal: Vec2, skip: tuple[str, ...] = (), via: tuple[Vec2, ...] = ()
    ) -> list[Vec2] | None:
        """Return a path from the planned position to a goal around obstacles; None if there is none.

        Args:
            who: The walker.
            goal: World x and y, metres.
            skip: Obstacles to ignore, by node id or asset id.
            via: Points that it goes through, if all of them can be reached.
        """
        start = (who.position.x, who.position.y)

        def leg(one: Vec2, other: Vec2) -> list[Vec2] | None:
            return self._path_between(who, one, other, skip)

        return walk_through(leg, (start, *via, goal)) or leg(start, goal)

    def _path_between(self, who: Performer, start: Vec2, goal: Vec2, skip: tuple[str, ...]) -> list[Vec2] | None:
        """Return a path around obstacles; narrow gaps are only used where needed."""
        ways = (
            (GIRTH, who.measures.radius + PADDING),
            (GIRTH, SQUEEZE_RADIUS * who.scale),
            (SIDEWAYS, SQUEEZE_RADIUS * who.scale),
        )
        for girth, room in ways:
            # A person who already stands inside something (a bed, a bench with arms) may step out of it.
            obstacles = [
                box
                for box in self.footprints(who, skip, girth)
                if float(clearance(np.array([start]), [box])[0]) > -0.02
            ]
            way = find_path(start, goal, obstacles, self.plan.bounds, room)
            if way is not None:
                return way
        return None

    def tracks_of_others(self, who: Performer, partner: Performer | None, goal: Vec2) -> list[tuple[Track, float]]:
        """Return the planned tracks of the other people, with the metres to keep from each.

        Args:
            who: The walker.
            partner: The person walked to; left out of the result.
            goal: World x and y, metres; people beside it may be nearer.
        """
        tracks = []
        for each in self.people.values():
            if each is who or each is partner:
                continue
            beside = max(EMBRACE, (each.position - Vector(goal)).length)
            tracks.append((_track(each), min(beside, who.measures.radius + each.measures.radius + 0.10)))
        return tracks

    def plan_drops(self, times: Floats) -> dict[str, Floats]:
        """Return by person how many metres the pelvis must sink at each of ``times`` (seconds), low-passed."""
        drops = {}
        for name, who in self.people.items():
            need = np.pad([who.needed_drop(float(t)) for t in times], 1, mode="edge")
            wide = np.pad(np.maximum.reduce([need[:-2], need[1:-1], need[2:]]), 1, mode="edge")
            drops[name] = np.maximum(0.25 * wide[:-2] + 0.5 * wide[1:-1] + 0.25 * wide[2:], 0.0)
        return drops

    def pose(self, t: float, drops: dict[str, float]) -> None:
        """Pose all people at ``t`` seconds, pelvises lower by ``drops`` (metres by asset id); following hands last."""
        for name, who in self.people.items():
            who.pose_trunk(t, drops.get(name, 0.0))
            who.pose_legs(t)
        for who in self.people.values():
            who.pose_head(t)
        late = {(id(who), side) for who, side, start, end in self.following_hands if start <= t <= end}
        for who in self.people.values():
            early = "".join(side for side in SIDES if (id(who), side) not in late)
            if early:
                who.pose_arms(t, early)
        for prop in self.props.values():
            prop.evaluate(t)
        for who in self.people.values():
            hands = "".join(side for side in SIDES if (id(who), side) in late)
            if hands:
                who.pose_arms(t, hands)
        for prop in self.props.values():
            prop.evaluate(t)
        for who in self.people.values():
            who.pose_head(t)


def _track(who: Performer) -> Track:
    """Return a person's position (x, y) as a function of seconds."""

    def at(t: float) -> Vec2:
        x, y, _ = who.root(t)
        return float(x), float(y)

    return at
