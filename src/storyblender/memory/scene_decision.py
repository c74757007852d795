"""What a person decided about a scene: its light, its set, its staging. It lies over what the script and the crew say.

A field left out is the crew's to choose. A later decision lies over an earlier one, field by field.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from storyblender.memory.asset_sheet import AssetDecision
from storyblender.memory.base import Coordinate, Described, Identifier, Vec2, Vec3, is_none
from storyblender.memory.mocap import MocapClip
from storyblender.memory.panorama import Panorama
from storyblender.memory.texture import Texture
from storyblender.memory.vocabulary import LightQuality, Period, TimeOfDay, Weather

LampKind = Literal["POINT", "SPOT", "AREA", "SUN"]
"""As Blender has them."""
Share = Annotated[float, Field(ge=0, le=1)]
SetMaterial = Identifier
"""A finish of ``catalog.sets.finishes`` or a material of ``catalog.materials``."""


class _Decision(Described):
    """Fields that a person decided; None where they did not."""

    _ends: ClassVar[tuple[tuple[str, str], ...]] = ()
    """Field that puts an end to what was decided of another one before."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``time of day dusk, warmth +1``."""
        return ", ".join(f"{name.replace('_', ' ')} {_told(value)}" for name, value in self if value not in (None, {}))

    def then(self, later: Self) -> Self:
        """Return this decision with a later one on top."""
        update = {name: value for name, value in later if value not in (None, {})}
        merged = {
            name: _merged(getattr(self, name), value) for name, value in update.items() if isinstance(value, dict)
        }
        ended = {gone: None for name, gone in self._ends if name in update}
        return self.model_copy(update={**ended, **update, **merged})


class LampDecision(_Decision):
    """What a person decided about one lamp of a scene, or a lamp that they added; what is left out is the crew's."""

    kind: LampKind | None = None
    """Of a lamp that is added."""
    location: Vec3 | None = None
    """Metres, Z up; of a SUN only the direction to ``target`` counts."""
    target: Vec3 | None = None
    """Where it points."""
    power: Annotated[float, Field(ge=0, le=100_000)] | None = None
    """Watts, as Blender means them; of a SUN watts a square metre."""
    color: tuple[Share, Share, Share] | None = None
    """Red, green and blue, scene-linear, 0 to 1."""
    size: Annotated[float, Field(ge=0, le=100)] | None = None
    """Metres: radius of POINT and SPOT, diameter of AREA; degrees of a SUN."""
    cone: Annotated[float, Field(gt=0, le=180)] | None = None
    """Of a SPOT, degrees."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``at 1, 2, 2.5, 80 W``."""

        def listed(point: tuple[float, ...] | None) -> str:
            return ", ".join(f"{value:g}" for value in point or ())

        said = {
            "kind": f"{self.kind}".lower(), "location": f"at {listed(self.location)}",
            "target": f"pointing at {listed(self.target)}", "power": f"{self.power} W",
            "color": f"color {listed(self.color)}", "size": f"size {self.size}", "cone": f"cone {self.cone} degrees",
        }  # fmt: skip
        return ", ".join(words for name, words in said.items() if getattr(self, name) is not None)


class LightDecision(_Decision):
    """What a person decided about the light of a scene."""

    time_of_day: TimeOfDay | None = None
    """The hour; it moves the sun, and lights the lamps at night."""
    weather: Weather | None = None
    """In the air and in the sky."""
    qualities: tuple[LightQuality, ...] | None = None
    """Character of the light, in place of what the script says: dim, harsh, candlelight ..."""
    warmth: float | None = Field(default=None, ge=-3, le=3)
    """Steps of colour temperature from the crew's light: 1 is clearly warmer, -1 clearly cooler."""
    brightness: float | None = Field(default=None, ge=-3, le=3)
    """Stops from the crew's light: 1 is twice as bright, -1 half."""
    contrast: float | None = Field(default=None, ge=-2, le=2)
    """Stops from the crew's key to fill ratio on faces: 1 is twice as contrasty, -1 half."""
    key_side: Literal["left", "right"] | None = None
    """Side of the set, as the viewer sees it, from which faces are lit."""
    panorama: Panorama | Literal["none"] | None = Field(default=None, exclude_if=is_none)
    """Panorama that lights the place by day, in place of the story's; ``none`` is the drawn sky."""
    lamps: dict[Identifier, LampDecision | None] = Field(default={}, exclude_if=lambda value: not value)
    """What each lamp is, by name; None takes it away; a name that the crew has not, with a kind, adds one."""


SURFACES = ("walls", "ground", "wall_texture", "ground_texture")
"""Fields of a decision about a set that need no other staging."""


class SetDecision(_Decision):
    """What a person decided about the set of a place; scenes in the same place share it."""

    _ends = (("walls", "wall_texture"), ("ground", "ground_texture"))

    kit: Identifier | None = None
    """Key of a set kit: ``kitchen``."""
    options: dict[Identifier, bool] = {}
    """Options of the kit, on or off."""
    period: Period | None = None
    """When the place was furnished."""
    snow: bool | None = None
    """Whether snow lies on the ground."""
    width: Annotated[float, Field(gt=0, le=1000)] | None = None
    """Metres from left to right; the kit's limits hold."""
    depth: Annotated[float, Field(gt=0, le=1000)] | None = None
    """Metres from front to back, likewise."""
    height: Annotated[float, Field(gt=0, le=100)] | None = None
    """Metres to the ceiling, likewise."""
    walls: SetMaterial | None = None
    """Finish or material of the walls: ``brick``, ``plaster_green``."""
    ground: SetMaterial | None = None
    """Finish or material of the floor or the ground: ``parquet``, ``gravel``."""
    wall_texture: Texture | Literal["none"] | None = Field(default=None, exclude_if=is_none)
    """Pictures that the walls are made of; ``none`` is the finish."""
    ground_texture: Texture | Literal["none"] | None = Field(default=None, exclude_if=is_none)
    """The same of the floor or the ground."""

    furniture: dict[Identifier, AssetDecision | None] = Field(default={}, exclude_if=lambda value: not value)
    """What stands in place of a piece of the kit's furniture, by its node id; None: nothing does."""

    @property
    def only_finishes(self) -> bool:
        """Whether it decides about materials alone, which need no other staging."""
        return not any(value not in (None, {}) for name, value in self if name not in SURFACES)


class FloorPlace(Described):
    """A place that a person chose; what is left out is the crew's."""

    location: Vec2 | None = None
    """Floor point, metres: of a thing under its bottom centre, of a person between the feet."""
    rotation: Coordinate | None = None
    """Degrees about Z, counter-clockwise; 0 faces -Y."""

    @property
    def words(self) -> str:
        """The place as a person reads it, e.g. ``at 1.2, 0.5, turned to 90 degrees``."""
        at = [f"at {self.location[0]:g}, {self.location[1]:g}"] if self.location is not None else []
        return ", ".join([*at, *([f"turned to {self.rotation:g} degrees"] if self.rotation is not None else [])])


class ThingPlace(FloorPlace):
    """Where a person placed a thing of a scene; what is left out stays as the crew has it."""

    height: Coordinate | None = None
    """Metres from the floor to its underside; left out, a thing with a location is dropped onto what is below."""

    @property
    def words(self) -> str:
        """As of a floor place, and the height."""
        return ", ".join(filter(None, [super().words, f"{self.height:g} m up" if self.height is not None else ""]))


DecidedPosture = Literal["stand", "sit", "lie", "kneel", "crouch", "lean"]
"""Postures that can be decided about."""
_POSTURES: dict[DecidedPosture, str] = {
    "stand": "standing", "sit": "sitting", "lie": "lying",
    "kneel": "kneeling", "crouch": "crouching", "lean": "leaning",
}  # fmt: skip


class PersonPlace(FloorPlace):
    """Where and how a person is at one end of a shot, as a person decided; what is left out is the crew's."""

    posture: DecidedPosture | None = Field(default=None, exclude_if=is_none)
    """They keep it until the script, or a later decision, has them in another one."""
    on: Identifier | None = Field(default=None, exclude_if=is_none)
    """With ``posture`` sit, lie or lean: node id of the seat, the bed or the rail; left out, the nearest one."""
    looking_at: Identifier | None = Field(default=None, exclude_if=is_none)
    """A person, a thing, or a direction as the viewer has it: ``left``, ``right``, ``up``, ``down``, ``camera``."""
    holding: tuple[Identifier, ...] | None = Field(default=None, exclude_if=is_none)
    """Ids of the things in their hands, at most two; empty: nothing. What they held before is put down."""

    @model_validator(mode="after")
    def _is_on_what_carries(self) -> Self:
        if self.on is not None and self.posture not in ("sit", "lie", "lean"):
            raise ValueError("what they are on goes with the posture sit, lie or lean")
        if self.holding is not None and len(self.holding) > 2:
            raise ValueError("a person has two hands")
        return self

    @property
    def is_posed(self) -> bool:
        """Whether it decides about more than a place on the floor."""
        return any(each is not None for each in (self.posture, self.looking_at, self.holding))

    @property
    def words(self) -> str:
        """As of a floor place, and the rest: ``sitting on sofa, looking at ilsa, holding letter``."""
        posed = f"{_POSTURES[self.posture]}{f' on {self.on}' if self.on else ''}" if self.posture is not None else ""
        looks = f"looking {_WAYS.get(self.looking_at, f'at {self.looking_at}')}" if self.looking_at else ""
        holds = "" if self.holding is None else f"holding {', '.join(self.holding) or 'nothing'}"
        return ", ".join(filter(None, [super().words, posed, looks, holds]))


_WAYS = {
    "left": "left",
    "right": "right",
    "up": "up",
    "down": "down",
    "camera": "to the camera",
    "closed": "at nothing",
}


class DecidedMotion(_Decision):
    """What a person decided about a motion of a shot; what is left out is the crew's."""

    at: Annotated[float, Field(ge=0, le=3600)] | None = None
    """Second of the shot from which it begins, once the person is free for it."""
    seconds: Annotated[float, Field(gt=0, le=600)] | None = None
    """Its length, of motions that can have another one."""
    target: Identifier | None = None
    """Of a motion that is added: the person or the thing that it is aimed at."""
    prop: Identifier | None = None
    """Of a motion that is added: the thing in hand."""
    mocap: MocapClip | None = Field(default=None, exclude_if=is_none)
    """The motion of the user's own that it is; the program fills it in from the name of a clip."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``at 1.5 s, for 2 s, to ilsa``."""
        said = {"at": f"at {self.at} s", "seconds": f"for {self.seconds} s"}
        said |= {"target": f"to {self.target}", "prop": f"with {self.prop}"}
        said |= {"mocap": f"as in {self.mocap.provenance.file}" if self.mocap is not None else ""}
        return ", ".join(words for name, words in said.items() if getattr(self, name) is not None)


class DecidedLine(_Decision):
    """When a person is to say a line of a shot, as a person decided; what is left out is the crew's."""

    at: Annotated[float, Field(ge=0, le=3600)] | None = None
    """Second of the shot from which it is said; what is said after it follows."""
    seconds: Annotated[float, Field(gt=0, le=600)] | None = None
    """Its length."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``at 3.5 s, for 2 s``."""
        said = {"at": f"at {self.at} s", "seconds": f"for {self.seconds} s"}
        return ", ".join(words for name, words in said.items() if getattr(self, name) is not None)


class PersonMarks(Described):
    """The marks of one person in one shot that a person set."""

    start: PersonPlace | None = None
    """As the shot begins; left out, where they were."""
    end: PersonPlace | None = None
    """As it ends; a person who is elsewhere walks there. Left out, where their actions lead them."""
    via: Annotated[tuple[Vec2, ...], Field(max_length=12)] | None = Field(default=None, exclude_if=is_none)
    """Floor points in metres that their first walk of the shot goes through; empty: the crew finds the way."""
    motions: dict[Identifier, DecidedMotion | None] = Field(default={}, exclude_if=lambda value: not value)
    """What they do, by key of the motion; None: they do not; one that the script has not is added."""
    lines: dict[Annotated[int, Field(ge=1, le=999)], DecidedLine | None] = Field(
        default={}, exclude_if=lambda value: not value
    )
    """When they say what is theirs, by number of the line in the shot, from 1; None: as the crew has it."""

    @property
    def says_something(self) -> bool:
        """Whether anything is decided."""
        placed = any(place is not None and place.words for place in (self.start, self.end))
        return placed or bool(self.motions or self.lines) or self.via is not None


class BlockingDecision(_Decision):
    """What a person decided about where people stand in a shot; in later shots they go on from there."""

    people: dict[Identifier, PersonMarks] = {}
    """Marks by asset id."""

    @property
    def words(self) -> str:
        """The marks as a person reads them, e.g. ``rick starts at 1, 2``."""
        ends = (
            f"{name} {verb} {place.words}"
            for name, marks in self.people.items()
            for verb, place in (("starts", marks.start), ("ends", marks.end))
            if place is not None
        )
        ways = (
            f"{name} walks through {'; '.join(f'{x:g}, {y:g}' for x, y in marks.via)}"
            if marks.via
            else f"{name} walks the crew's way"
            for name, marks in self.people.items()
            if marks.via is not None
        )
        does = (
            f"{name} does not {key.replace('_', ' ')}"
            if motion is None
            else ", ".join(filter(None, [f"{name} does {key.replace('_', ' ')}", motion.words]))
            for name, marks in self.people.items()
            for key, motion in marks.motions.items()
        )
        says = (
            f"{name} says line {number} {'when the crew has it' if line is None else line.words}"
            for name, marks in self.people.items()
            for number, line in marks.lines.items()
        )
        return ", ".join((*ends, *ways, *does, *says))


class LayoutDecision(_Decision):
    """What a person decided about the staging of a scene."""

    staging: Annotated[int, Field(ge=0, le=999)] | None = None
    """Which staging, counted from 0, the crew's first."""
    added: tuple[Identifier, ...] | None = Field(default=None, exclude_if=is_none)
    """Ids of the things that a person added."""
    removed: tuple[Identifier, ...] | None = Field(default=None, exclude_if=is_none)
    """Ids of the script's things that a person took away."""
    things: dict[Identifier, ThingPlace] = Field(default={}, exclude_if=lambda value: not value)
    """Where a person placed things, by node id; they stay there in every staging."""


def _merged(before: dict[str, object], later: dict[str, object]) -> dict[str, object]:
    """Return values by name with later ones on top; a decision of a part lies over what was decided of it before."""
    parts = {
        name: was.then(value)
        for name, value in later.items()
        if isinstance(was := before.get(name), _Decision) and isinstance(value, type(was))
    }
    return {**before, **later, **parts}


def _told(value: object) -> str:
    if isinstance(value, float):
        return f"{value:+g}"
    if isinstance(value, dict):
        return ", ".join(f"{name} {_told(each)}" for name, each in value.items())
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, AssetDecision):
        return value.words
    if isinstance(value, Panorama | Texture):
        return value.provenance.file
    if isinstance(value, ThingPlace | LampDecision):
        return value.words
    return ", ".join(value) if isinstance(value, tuple) else "nothing" if value is None else str(value)
