"""The Camera Operator's view of a shot and its draft, a take."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from storyblender.agents.layout_artist.camera_solids import is_anyone_aboard
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box, corners, distance_to_point
from storyblender.geometry.framing import Figure, Film
from storyblender.geometry.moves import ease_in_out, interpolate_cameras
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.over_shoulder import lens_over_shoulder
from storyblender.memory.camera_decision import CameraDecision
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, Flaw
from storyblender.memory.shot_sizes import SHOT_SIZES, SIZES, TIGHT, WHOLE, ShotSize

_ONE_PERSON = ("single", "reaction", "ots")
_TOGETHER = ("group", "two_shot", "action")
"""Kinds of shots that hold several people if they are near each other."""
_NEARBY = 1.3
"""Metres from a person within which a thing belongs to them: their table, their chair."""
_OVER_THEM, _TALLER = 1.0, 0.5
"""Metres from a kneeling or seated person, and metres higher, of a head that a picture of their whole body includes."""
_SHOULDERS = 1.8
"""Metres from the first person of a tight shot within which it also holds the faces of others."""
_BY_IT = 1.0
"""Metres from a thing within which a close picture of it shows another one."""
TALKS = 80.0
"""Largest angle between a subject's look and their partner, in degrees, for an over-the-shoulder."""
_BENT = 0.3
"""Metres that a face is lower than at full height when its person bends."""
TRAVEL = 0.6
"""Metres from which a move of the subject is a walk that the camera has to follow or hold."""


@dataclass(frozen=True)
class Moment:
    """Everybody in the set at one frame, counted from the shot's start."""

    frame: int
    figures: tuple[Figure, ...]

    def figure(self, node_id: str | None) -> Figure | None:
        """Return the figure of a person; None for a thing or a person off stage."""
        return next((figure for figure in self.figures if figure.node_id == node_id), None)


@dataclass(frozen=True)
class EarlierShot:
    """An earlier shot of the scene that this one has to match."""

    instruction: CameraInstruction
    state: CameraState
    people: tuple[Figure, ...] = ()
    """Its focus people and over-the-shoulder partner at its end."""


@dataclass(frozen=True)
class CameraOperatorView:
    """The Camera Operator's projection of the graph for one shot.

    Attributes:
        scene_id: Scene of the shot.
        shot_id: The shot.
        instruction: The Director's instruction.
        duration: Length of the shot in frames.
        moments: Start, middle and end of the shot, in order; at least one.
        plan: The set; None on an empty stage.
        props: Boxes of the things by node_id, as they are during the shot.
        in_frame: node_ids of the people the shot is meant to show, besides its focus.
        film: Sensor and aspect of the project.
        kit: mm of the lenses at hand; any lens where it is empty.
        previous: The shot before.
        reverse: The latest single of the partner in this conversation.
        side: Side of the instruction's axis used so far in the scene: 1 left of the line from its first to its
            second person, -1 right, 0 not settled.
        nodes: node_id by asset_id, where they differ.
        carried: node_ids of things in people's hands, by the person's node_id.
        detail: Box of the part of a person that an insert shows, such as a hand; None for any other shot.
        used: node_ids of the things that people handle; they are never hidden.
        asked: What a person decided about the camera.
        lines: The lines that the shot covers.
        panels: Boxes of the panels of vehicles that a shot can hide, by the id that hides them.
    """

    scene_id: int
    shot_id: int
    instruction: CameraInstruction
    duration: int
    moments: tuple[Moment, ...]
    plan: SetPlan | None = None
    props: Mapping[str, Box] = field(default_factory=dict)
    in_frame: tuple[str, ...] = ()
    film: Film = field(default_factory=Film)
    kit: tuple[float, ...] = ()
    previous: EarlierShot | None = None
    reverse: EarlierShot | None = None
    side: int = 0
    nodes: Mapping[str, str] = field(default_factory=dict)
    carried: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    detail: Box | None = None
    used: tuple[str, ...] = ()
    asked: CameraDecision = field(default_factory=CameraDecision)
    lines: tuple[str, ...] = ()
    panels: Mapping[str, Box] = field(default_factory=dict)

    def node(self, asset_id: str) -> str:
        """Return the node_id that shows an asset."""
        return self.nodes.get(asset_id, asset_id)

    @cached_property
    def focus(self) -> tuple[str, ...]:
        """node_ids of the subjects. A tight shot or a single has only one person.

        A tight shot of things is about the first of them and what is near it; an insert of a hand only about that hand.
        """
        if self.detail is not None:
            return ()
        away = too_far_to_frame(self.instruction, self.story_moment, self.named)
        nodes = tuple(node for node in self.named if node not in away)
        nodes += tuple(node for node in self._standing_over(nodes) if node not in nodes)
        if self.instruction.kind not in _ONE_PERSON and (
            self.instruction.size not in TIGHT or self._fits_all_faces(nodes)
        ):
            return nodes
        faces = {figure.node_id for moment in self.moments for figure in moment.figures}
        lead = next((node for node in nodes if node in faces), None)
        first = next((self.props[node] for node in nodes if node in self.props), None)
        if lead is None and first is not None:
            apart = {node: distance_to_point(first, box.x, box.y) for node, box in self.props.items()}
            return tuple(node for node in nodes if apart.get(node, math.inf) < _BY_IT)
        return tuple(node for node in nodes if node == lead or node not in faces)

    def _fits_all_faces(self, nodes: Sequence[str]) -> bool:
        """Return whether people (node_ids) stand so close together that a tight shot of them can hold all faces.

        A two-shot or a group that a person made tighter holds them in any case, from as far as it takes.
        """
        people = [figure for node in nodes if (figure := self.story_moment.figure(node)) is not None]
        near = all(math.dist(each.base[:2], people[0].base[:2]) < _SHOULDERS for each in people[1:])
        together = self.instruction.kind in ("two_shot", "group") and self.asked.reframes
        return (
            self.instruction.explicit and self.instruction.kind != "insert" and len(people) > 1 and (near or together)
        )

    def _standing_over(self, nodes: Sequence[str]) -> list[str]:
        """Return the node_ids of people whose heads a whole-body picture of the first person would cut."""
        lead = next((figure for node in nodes if (figure := self.story_moment.figure(node)) is not None), None)
        if lead is None or self.instruction.size not in WHOLE or self.instruction.kind != "action":
            return []
        near = [each for each in self.story_moment.figures if math.dist(each.base[:2], lead.base[:2]) < _OVER_THEM]
        return [each.node_id for each in near if each.crown[2] - lead.crown[2] > _TALLER]

    @cached_property
    def story_moment(self) -> Moment:
        """The moment that the board shows."""
        return self.moments[len(self.moments) // 2]

    @cached_property
    def named(self) -> tuple[str, ...]:
        """node_ids of everything that the Director's instruction names as its focus."""
        return tuple(self.node(asset_id) for asset_id in self.instruction.focus_on_ids)

    @cached_property
    def people(self) -> tuple[Figure, ...]:
        """The focus people at the story moment."""
        return tuple(figure for node in self.focus if (figure := self.story_moment.figure(node)) is not None)

    @cached_property
    def over(self) -> Figure | None:
        """The partner of an over-the-shoulder, past whose shoulder the camera looks, at the story moment.

        None, and the shot becomes a single, if the subject does not look at the partner or is too far away for the shot
        size; if the script asks for the shoulder, it is shown all the same.
        """
        over = self.story_moment.figure(self.node(self.instruction.over_id or ""))
        if self.instruction.kind != "ots" or over is None or not self.people:
            return None
        lead, size = self.people[0], self.instruction.size
        kit = (self.lens,) if self.instruction.lens else self.kit
        meets = lead.turned_from(over.face) < TALKS and lens_over_shoulder(self.film, lead, over, size, self.lens, kit)
        return over if over.node_id != lead.node_id and (meets or self.instruction.explicit) else None

    @cached_property
    def things(self) -> tuple[Box, ...]:
        """Boxes of the focus things."""
        if self.detail is not None:
            return (self.detail,)
        return tuple(self.props[node] for node in self.focus if node in self.props)

    def subjects(self, moment: Moment) -> tuple[Figure, ...]:
        """Return the focus people and the over-the-shoulder partner at a moment."""
        nodes = dict.fromkeys((*self.focus, *((self.over.node_id,) if self.over is not None else ())))
        return tuple(figure for node in nodes if (figure := moment.figure(node)) is not None)

    @cached_property
    def walker_id(self) -> str:
        """node_id of the first focus person who is present from start to end; empty if there is none."""
        first, last = self.moments[0], self.moments[-1]
        there = (node for node in self.focus if first.figure(node) is not None and last.figure(node) is not None)
        return next(there, "")

    @property
    def travel(self) -> tuple[float, float, float]:
        """Metres in x, y and z that the walker goes from start to end, on the floor they stand on."""
        first, last = self.moments[0].figure(self.walker_id), self.moments[-1].figure(self.walker_id)
        if first is None or last is None:
            return 0.0, 0.0, 0.0
        x, y, z = np.subtract(last.base, first.base)
        return float(x), float(y), float(z)

    @property
    def walks(self) -> bool:
        """Whether a lone subject walks across the floor during the shot."""
        faces = {figure.node_id for moment in self.moments for figure in moment.figures}
        alone = sum(node in faces for node in self.focus) < 2
        return alone and float(np.hypot(*self.travel[:2])) > TRAVEL

    @cached_property
    def in_stride(self) -> bool:
        """Whether a lone subject who walks is still walking at the story moment."""
        last = self.moments[-1].figure(self.people[0].node_id) if self.walks and self.people else None
        return last is not None and float(np.hypot(*np.subtract(last.base, self.people[0].base)[:2])) > TRAVEL / 2

    def upright(self, figure: Figure) -> Figure:
        """Return the figure with the face as high as it is at any moment of the shot, if the person bends now."""
        there = [each for moment in self.moments if (each := moment.figure(figure.node_id)) is not None]
        tall = max((each.face[2] - each.base[2] for each in there), default=0.0)
        if tall - (figure.face[2] - figure.base[2]) < _BENT:
            return figure
        x, y, z = figure.base
        return replace(figure, face=(x, y, z + tall))

    @property
    def people_over_time(self) -> tuple[Figure, ...]:
        """The focus people at the story moment, and again at every other place they walk to during the shot."""
        later = ((moment.figure(person.node_id), person) for moment in self.moments for person in self.people)
        far = (there for there, person in later if there and math.dist(there.base[:2], person.base[:2]) > TRAVEL)
        return (*self.people, *far)

    @cached_property
    def strangers(self) -> tuple[str, ...]:
        """node_ids of the people on stage who have no part in the shot; a person who holds its thing has one.

        Where a person asked for one of them alone, nobody else has.
        """
        instruction = self.instruction
        alone = self.asked.focus_on_ids is not None and instruction.kind in ("single", "reaction")
        own = {*self.focus, *(() if alone else self.in_frame)}
        own |= {self.node(asset_id or "") for asset_id in (instruction.over_id, instruction.pov_id)}
        own |= {*self.named, *(who for who, things in self.carried.items() if {*things} & {*self.named})}
        return tuple(figure.node_id for figure in self.story_moment.figures if figure.node_id not in own)

    @cached_property
    def removable_props(self) -> dict[str, Box]:
        """Boxes by node_id of the things that may be hidden for a picture: nobody uses, holds or sits on them."""
        kept = {*self.focus, *self.used, *(node for things in self.carried.values() for node in things)}
        return {node: box for node, box in self.props.items() if node not in kept and not self._is_occupied(box)}

    @cached_property
    def vessels(self) -> tuple[str, ...]:
        """node_ids of the boats and carriages that focus people are in: these do not stand in front of them."""
        return tuple(node for node, box in self.props.items() if is_anyone_aboard([box], self.people))

    def _is_occupied(self, box: Box) -> bool:
        """Return whether a person sits or lies on a thing, so that hiding it would leave them in the air."""
        for figure in (figure for moment in self.moments for figure in moment.figures):
            across, along = box.to_local(figure.face[0], figure.face[1])
            if abs(across) < box.width / 2 and abs(along) < box.depth / 2 and figure.face[2] > box.z:
                return True
        return False

    @property
    def axis(self) -> tuple[Figure, Figure] | None:
        """The two people of the 180-degree line; None if they are not both on stage."""
        if self.instruction.axis is None:
            return None
        first, second = (self.story_moment.figure(self.node(asset_id)) for asset_id in self.instruction.axis)
        return (first, second) if first is not None and second is not None else None

    @property
    def lens(self) -> float:
        """Focal length in mm: the instruction's, else the lens of the kit that is nearest to the shot size's."""
        wish = SIZES[self.instruction.size].lens
        return self.instruction.lens or min(self.kit, key=lambda lens: abs(math.log(lens / wish)), default=wish)

    def widened(self, lens: float) -> float:
        """Return the longest lens of the kit up to ``lens`` mm; the widest of the kit if all are longer."""
        return max((each for each in self.kit if each <= lens), default=min(self.kit, default=lens))

    def bounds(self) -> Floats:
        """Return (n, 3) world points around the people whom the shot is meant to show and the things near them.

        Without people these are the things on the playing area.
        """
        moment = self.story_moment
        shown = {*self.focus, *self.in_frame}
        people = [figure for figure in moment.figures if figure.node_id in shown] or list(moment.figures)
        points = [point for figure in people for point in (figure.base, figure.crown)]
        things = self.things or tuple(box for box in self.props.values() if self._is_near(people, box))
        points += [corner for box in things for corner in corners(box)]
        return np.array(points or [(-2.0, -2.0, 0.0), (2.0, 2.0, 2.0)], float)

    def _is_near(self, people: Sequence[Figure], box: Box) -> bool:
        """Return whether a thing is near one of the people; without people, whether it is on the playing area."""
        if people or self.plan is None:
            return not people or any(distance_to_point(box, *figure.base[:2]) < _NEARBY for figure in people)
        size = self.plan.size
        return size.x_negative < box.x < size.x and size.y_negative < box.y < size.y

    def size_steps(self, other: ShotSize) -> int:
        """Return how many shot sizes lie between this shot's and another."""
        return abs(SHOT_SIZES.index(self.instruction.size) - SHOT_SIZES.index(other))


def too_far_to_frame(instruction: CameraInstruction, drawn: Moment, nodes: Sequence[str]) -> set[str]:
    """Return the node_ids of people who are too far from the first to be in a picture of its size.

    Args:
        instruction: The Director's instruction.
        drawn: Everybody's place.
        nodes: node_ids of the people, the most important first.
    """
    people = [figure for node in nodes if (figure := drawn.figure(node)) is not None]
    if instruction.kind not in _TOGETHER or instruction.explicit:
        return set()
    reach = SIZES[instruction.size].reach
    return {each.node_id for each in people if math.dist(each.base[:2], people[0].base[:2]) > reach}


def time_share(view: CameraOperatorView, frame: int) -> float:
    """Return how much of the shot's time is over, 0 to 1, at a frame counted from the shot's start."""
    return min(frame / max(view.duration - 1, 1), 1.0)


@dataclass(frozen=True)
class CameraOperatorDraft:
    """A take: the camera at the story moment, and the start and end of its move.

    Attributes:
        camera: The composed camera.
        start: Camera at the start of the move.
        end: Camera at the end of the move.
        hidden: node_ids that are hidden for the shot, such as wild walls.
    """

    camera: Orbit
    start: Orbit
    end: Orbit
    hidden: tuple[str, ...] = ()
    span: tuple[float, float] = (0.0, 1.0)
    """Shares of the shot's time between which the camera moves."""

    @property
    def moves(self) -> bool:
        """Whether the camera moves."""
        return self.start != self.end

    def at(self, share: float) -> Orbit:
        """Return the camera at a share of the shot's time, 0 to 1."""
        if not self.moves:
            return self.start
        begins, ends = self.span
        return interpolate_cameras(self.start, self.end, ease_in_out((share - begins) / (ends - begins)))

    def state(self, duration: int, f_number: float, score: float, residual: tuple[Flaw, ...]) -> CameraState:
        """Return the take as the graph stores it.

        Args:
            duration: Length of the shot in frames.
            f_number: Aperture of the lens.
            score: The critic's score, 0 to 10.
            residual: Flaws that the critic still finds.
        """
        cameras = (self.start, self.end) if self.moves else (self.start,)
        frames = [round(share * max(duration - 1, 1)) for share in self.span]
        return CameraState(
            poses=tuple(pose_of(camera, frame) for camera, frame in zip(cameras, frames, strict=False)),
            sensor_width=self.camera.sensor_width,
            f_number=f_number,
            hidden_node_ids=self.hidden,
            score=round(score, 2),
            residual=residual,
        )


def pose_of(camera: Orbit, frame: int = 0) -> CameraPose:
    """Return a world camera as the graph's pose at a frame counted from the shot's start."""
    return CameraPose(
        frame=frame, pivot=camera.pivot, rotation=camera.rotation, distance=camera.distance, lens=camera.lens
    )
