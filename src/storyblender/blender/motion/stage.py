"""The stage of one shot: people, props and furniture together, and the order in which a frame is solved."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Channel
from storyblender.blender.motion.ease import at_ease
from storyblender.blender.motion.hands import blend_hands
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import Floats, Problem, StageFurniture, StagePlan
from storyblender.blender.motion.puppets import PropPuppet, facing_yaw
from storyblender.blender.motion.skeleton import SIDES
from storyblender.geometry.paths import SQUEEZE_RADIUS, Footprint, Track, Vec2, clearance, find_path, find_seat_access
from storyblender.geometry.seating import list_seats
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import Mark
from storyblender.memory.vocabulary import Mood

PADDING = 0.11
"""Metres between a walking body's disc and furniture; less, and rounded corners and elbows touch it."""
OVERHEAD = 1.9
"""Boxes that begin above this height stand in nobody's way."""
LOW = 0.08
"""Boxes that end below this height, rugs and kerbs, are walked over."""
GIRTH, SIDEWAYS = 0.8, 0.3
"""Shares of the radius that others take up in a way: standing, and turned aside for who has no other way."""
EMBRACE = 0.30
"""Metres between two who hug; nearer, they are in each other."""
PointOf = Callable[[float], Vector]


@dataclass(frozen=True)
class Seat:
    """A place to sit.

    Attributes:
        edge: Middle of the front edge, world.
        height: Of the sitting surface.
        depth: From front edge to backrest.
        yaw: Where the sitter faces, radians.
        node_id: Of the furniture; empty for the floor.
        width: Of the furniture.
    """

    edge: Vector
    height: float
    depth: float
    yaw: float
    node_id: str = ""
    width: float = 0.5

    @property
    def before(self) -> Vector:
        """Unit vector on the floor out of the seat."""
        return Vector((math.sin(self.yaw), -math.cos(self.yaw)))


@dataclass(frozen=True)
class Beat:
    """A cue with its names resolved: what a clip gets.

    Attributes:
        start: Seconds.
        duration: Seconds, or None for the clip's natural length.
        target: Person, prop or piece of furniture it is about.
        prop: The prop handled.
        side: The hand, L or R.
        mark: Where it ends.
        mood: How.
        expression: Facial expression from this cue on.
        frame: The cue's frame, for problems.
        seed: For gestures.
    """

    start: float
    duration: float | None = None
    target: Performer | PropPuppet | StageFurniture | None = None
    prop: PropPuppet | None = None
    side: str = "R"
    mark: Mark | None = None
    mood: Mood = "neutral"
    expression: str = "neutral"
    frame: int = 0
    seed: int = 0


class Stage:
    """Everything that moves in the shot.

    Args:
        plan: The shot.
        fps: Frames per second.
        seed_of: Seeds by asset id.
    """

    def __init__(self, plan: StagePlan, fps: int, seed_of: Callable[[str], int]) -> None:
        self.plan, self.fps = plan, fps
        self.people = {name: Performer(name, who.body, seed_of(name)) for name, who in plan.people.items()}
        self.props = {name: PropPuppet(name, prop) for name, prop in plan.props.items()}
        self.late: list[tuple[Performer, str, float, float]] = []
        """Hands that follow another person or a moving prop, with the span of time: solved last."""
        self.contacts: list[tuple[float, Performer, str, Beat]] = []
        """Moments at which a hand must be where it was sent."""
        self.grasps: dict[tuple[str, int], float] = {}
        """Seconds at which doors and lids are moved, by person and the cue's frame."""
        self.played: dict[tuple[str, str, int], tuple[float, float]] = {}
        """Start and end of cues in seconds, by person, clip and the cue's frame."""
        self.problems: list[Problem] = []
        for who in self.people.values():
            who.home = {side: at_ease(who, side) for side in SIDES}
            for side in SIDES:
                who.hands[side] = Channel(who.home[side], blend_hands)

    # --- who and where --------------------------------------------------------------------------------------------

    def subject(self, name: str | None) -> Performer | PropPuppet | StageFurniture | None:
        """Return the person, prop or piece of furniture of an asset id or node id."""
        if not name:
            return None
        found = self.people.get(name) or self.props.get(name) or self.plan.furniture.get(name)
        if found is not None:
            return found
        for prop in self.props.values():
            if prop.node_id == name:
                return prop
        return next((each for each in self.plan.furniture.values() if each.asset_id == name), None)

    def report(self, kind: str, who: Performer, beat: Beat, message: str, amount: float = 0.0) -> None:
        """Note something that cannot be staged as asked."""
        self.problems.append(Problem(kind, who.asset_id, beat.frame, message, amount))

    def expect(self, who: Performer, side: str, t: float, beat: Beat) -> None:
        """Check at second ``t`` that the hand reached its target."""
        self.contacts.append((t, who, side, beat))

    def point_of(self, subject: Performer | PropPuppet | StageFurniture) -> PointOf:
        """Return what to look at: eyes of a person, middle of a prop, face of a piece of furniture."""
        if isinstance(subject, Performer):
            return lambda t: (subject.point("eye.L") + subject.point("eye.R")) / 2
        if isinstance(subject, PropPuppet):
            return lambda t: subject.centre
        top = next((a for a in subject.anchors if a.kind in ("top", "handle")), None)
        height = subject.dimensions[2]
        local = Vector(top.location) if top else Vector((0, -subject.dimensions[1] / 2, min(1.5, 0.6 * height)))
        place = Matrix(subject.world.tolist()) @ local
        return lambda t: place

    def ground_of(self, subject: Performer | PropPuppet | StageFurniture) -> Vector:
        """Return the planned place on the floor of a subject."""
        if isinstance(subject, Performer):
            return subject.position.copy()
        if isinstance(subject, PropPuppet):
            if subject.holder is not None:
                return subject.holder.position.copy()
            return subject.matrix.translation.xy
        return Vector(subject.world[:2, 3].tolist())

    def furniture(self, node_id: str | None) -> StageFurniture | None:
        """Return a piece of furniture by node id or asset id."""
        found = self.subject(node_id)
        return found if isinstance(found, StageFurniture) else None

    def anchor(self, furniture: StageFurniture, kinds: tuple[str, ...], mark: Mark | None) -> Anchor | None:
        """Return the anchor a mark names, or the nearest of a kind to the mark."""
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

    def seat(self, node_id: str | None, mark: Mark | None) -> Seat | None:
        """Return the seat a mark means: the anchor's height, depth and facing at the mark's place along the edge."""
        furniture = self.furniture(node_id)
        anchor = None
        if furniture is not None:
            anchor = self.anchor(furniture, ("seat",), mark) or self.anchor(furniture, ("bed",), mark)
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
        return Seat(edge, place.z, anchor.size[1] or 0.4, yaw, self._name_of(furniture), furniture.dimensions[0])

    def _bedside(self, world: Matrix, bed: Anchor, mark: Mark | None, node_id: str) -> Seat:
        """Return the seat on a bed's long edge that is nearest to the mark."""
        middle = world @ Vector(bed.location)
        feet = (world.to_3x3() @ Vector(bed.direction)).xy.normalized()
        side = Vector((-feet.y, feet.x))
        width = bed.size[0] or 0.9
        if mark is not None and (Vector(mark.location).xy - middle.xy).dot(side) < 0:
            side = -side
        return Seat(middle.xy + side * (width / 2), middle.z, width, facing_yaw(Vector((*side, 0))), node_id)

    def _name_of(self, furniture: StageFurniture) -> str:
        return next((name for name, each in self.plan.furniture.items() if each is furniture), "")

    def access(self, who: Performer, seat: Seat) -> Vector:
        """Return where a person stands before sitting down on a seat."""
        boxes = [box for box in self.footprints(who) if box.name not in self.people]
        return Vector(find_seat_access(tuple(seat.edge), seat.yaw, seat.width, who.m.k, boxes, seat.node_id))

    # --- ways -----------------------------------------------------------------------------------------------------

    def footprints(self, who: Performer, skip: tuple[str, ...] = (), girth: float = GIRTH) -> list[Footprint]:
        """Return what stands in a person's way: boxes, and the others where they will be, as wide as ``girth`` says."""
        boxes = [
            Footprint(box.centre[:2], box.size[:2], box.yaw, name=box.node_id)
            for box in self.plan.obstacles
            if box.node_id not in skip
            and box.centre[2] - box.size[2] / 2 < OVERHEAD
            and box.centre[2] + box.size[2] / 2 > LOW
        ]
        others = [
            Footprint(tuple(o.position), (0.0, 0.0), 0.0, girth * o.m.radius, o.asset_id)
            for o in self.people.values()
            if o is not who and o.asset_id not in skip
        ]
        return boxes + others

    def path(self, who: Performer, goal: Vec2, skip: tuple[str, ...] = ()) -> list[Vec2] | None:
        """Return the way to ``goal`` from where a person will be: with room, or squeezing past, or sideways."""
        start = tuple(who.position)
        ways = (
            (GIRTH, who.m.radius + PADDING),
            (GIRTH, SQUEEZE_RADIUS * who.m.k),
            (SIDEWAYS, SQUEEZE_RADIUS * who.m.k),
        )
        for girth, room in ways:
            # Whoever already stands inside something (a bed, a bench with arms) may step out of it.
            obstacles = [
                box
                for box in self.footprints(who, skip, girth)
                if float(clearance(np.array([start]), [box])[0]) > -0.02
            ]
            way = find_path(start, goal, obstacles, self.plan.bounds, room)
            if way is not None:
                return way
        return None

    def others_tracks(self, who: Performer, partner: Performer | None, goal: Vec2) -> list[tuple[Track, float]]:
        """Return where everybody else goes, and how far to stay from them: whoever one goes to is let near."""
        tracks = []
        for each in self.people.values():
            if each is who or each is partner:
                continue
            beside = max(EMBRACE, (each.position - Vector(goal)).length)
            tracks.append((_track(each), min(beside, who.m.radius + each.m.radius + 0.10)))
        return tracks

    # --- solving --------------------------------------------------------------------------------------------------

    def plan_drops(self, times: Floats) -> dict[str, Floats]:
        """Return how far every pelvis must sink per sample: widened and low-passed, so that it never pops."""
        drops = {}
        for name, who in self.people.items():
            need = np.pad([who.needed_drop(float(t)) for t in times], 1, mode="edge")
            wide = np.pad(np.maximum.reduce([need[:-2], need[1:-1], need[2:]]), 1, mode="edge")
            drops[name] = np.maximum(0.25 * wide[:-2] + 0.5 * wide[1:-1] + 0.25 * wide[2:], 0.0)
        return drops

    def pose(self, t: float, drops: dict[str, float]) -> None:
        """Pose everybody and everything at a moment; hands that follow others come last."""
        for name, who in self.people.items():
            who.pose_trunk(t, drops.get(name, 0.0))
            who.pose_legs(t)
        for who in self.people.values():
            who.pose_head(t)
        late = {(id(who), side) for who, side, start, end in self.late if start <= t <= end}
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
    def at(t: float) -> Vec2:
        x, y, _ = who.root(t)
        return float(x), float(y)

    return at
