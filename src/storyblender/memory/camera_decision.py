"""The camera as it is wanted: the Director's instruction, and what a person or the Frame Critic changed of it."""

from __future__ import annotations

import math
from typing import Annotated, Self, get_args

from pydantic import Field, model_validator

from storyblender.memory.base import (
    Coordinate,
    Described,
    Frozen,
    Identifier,
    Quaternion,
    Vec3,
    is_none,
    without_fields,
)
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import (
    Angle,
    Aperture,
    BodyPart,
    CameraDirection,
    Moment,
    Movement,
    ShotKind,
)

FNumber = Annotated[float, Field(ge=0.5, le=64)]
"""Focal length / diameter of the aperture."""


class CameraInstruction(Frozen):
    """The camera as the Director wants it: the paper's fields; its ``distance`` follows from ``size``."""

    focus_on_ids: tuple[Identifier, ...] = ()
    kind: ShotKind = "action"
    size: ShotSize = "MS"
    angle: Angle = "eye-level"
    detail: BodyPart | None = None
    """Of the first focus person: an insert shows this part of them and nothing else."""
    movement: Movement = "static"
    direction: CameraDirection | None = None
    over_id: Identifier | None = None
    """OTS: over whose shoulder."""
    pov_id: Identifier | None = None
    """POV: through whose eyes."""
    lens: float | None = Field(default=None, gt=0, le=10_000)
    """mm; None takes the lens kit's default for the size."""
    f_number: FNumber | None = None
    """None is the crew's choice: tight shots part a face from its background, in wider ones everything is sharp."""
    focus: Identifier | None = None
    """asset_id or node_id the lens is focused on; None takes the first subject."""
    focus_to: Identifier | None = None
    """Rack focus: what the lens is focused on when the shot ends."""
    soft_focus: bool = False
    """Seen through a diffusion filter: sharp, with a glow around what is bright."""
    axis: tuple[Identifier, Identifier] | None = None
    """The pair that defines the 180-degree line."""
    order: str = ""
    """The script's words that asked for this camera."""
    explicit: bool = False
    """Written in the script: never overruled by taste."""
    through: Aperture | None = None
    """POV shots: what the camera looks through."""
    behind: bool = False
    """The script shows its people from behind: ``his back to us``."""

    @model_validator(mode="before")
    @classmethod
    def _from_schema_4(cls, value: object) -> object:
        """Older projects kept a distance beside the size, words for an aperture, and a sentence with the order."""
        if not isinstance(value, dict) or "description" not in value:
            return value
        order = str(value["description"]).partition(" (script: ")[2].removesuffix(".").removesuffix(")")
        words = str(value.get("through") or "")
        through = next((each for each in get_args(Aperture) if each in words), "panes" if "window" in words else None)
        return without_fields({"order": order, **value, "through": through}, "description", "distance")


class CameraPosition(Described):
    """Where a camera stands and what it looks at, or how it is turned."""

    location: Vec3
    """Optical centre, metres in the scene, Z up."""
    target: Vec3 | None = None
    """A point in the middle of the picture; its distance is that of the orbit's pivot. Or give a rotation."""
    roll: Coordinate = 0.0
    """Degrees, counter-clockwise as seen from behind the camera, of one that looks at a target."""
    rotation: Quaternion | None = Field(default=None, exclude_if=is_none)
    """In place of a target: world from camera, which looks along its -Z with +Y up in the picture, as in Blender."""

    @model_validator(mode="after")
    def _looks_somewhere(self) -> Self:
        if (self.target is None) == (self.rotation is None) or (self.rotation is not None and self.roll):
            raise ValueError("a camera looks at a target, with a roll if it leans, or has a rotation")
        if self.target is not None and math.dist(self.location, self.target) < 0.05:
            raise ValueError("a camera looks at a point at least 5 cm away")
        return self


class FreeCamera(Described):
    """A camera that a person placed: one position, or two for a camera that travels from the first to the second."""

    start: CameraPosition
    """Where the shot begins."""
    end: CameraPosition | None = None
    """Where it ends, if the camera travels."""


class CameraDecision(Described):
    """What a person decided about the camera of a shot; fields left out are the crew's to choose."""

    kind: ShotKind | None = None
    """Kind of picture: single, two_shot, ots (over a shoulder), pov, insert, establishing ..."""
    focus_on_ids: tuple[Identifier, ...] | None = Field(default=None, min_length=1)
    """Ids of the people or things it shows, the most important first."""
    over_id: Identifier | None = Field(default=None, exclude_if=is_none)
    """Over the shoulder: whose."""
    pov_id: Identifier | None = Field(default=None, exclude_if=is_none)
    """Point of view: whose."""
    size: ShotSize | None = None
    """How much is seen, from extreme wide (EWS) to extreme close-up (ECU)."""
    angle: Angle | None = None
    """Height and tilt of the camera."""
    movement: Movement | None = None
    """What the camera does during the shot."""
    direction: CameraDirection | None = None
    """Where a move goes; it is said with the move, as in ``pan left``."""
    lens: float | None = Field(default=None, ge=4, le=1200)
    """Focal length in mm: 24 is wide, 85 is long."""
    f_number: FNumber | None = None
    """A number blurs what is out of focus, in a shot of any size; 32 keeps nearly everything sharp."""
    focus: Identifier | None = None
    """asset_id or node_id the lens is focused on."""
    focus_to: Identifier | None = None
    """Rack focus: what it is focused on when the shot ends."""
    placed: FreeCamera | None = Field(default=None, exclude_if=is_none)
    """A camera that stands just there; the crew sets its lens if no lens is decided."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``size CU, lens 50``."""
        said = self.model_dump(exclude_none=True, exclude={"placed"}).items()
        told = ((key.removesuffix("_ids").removesuffix("_id").replace("_", " "), value) for key, value in said)
        words = [f"{key} {value:g}" if isinstance(value, float) else f"{key} {_listed(value)}" for key, value in told]
        return ", ".join([*words, *(["placed by hand"] if self.placed else [])])

    def then(self, later: CameraDecision) -> Self:
        """Return this decision with a later one on top.

        A new size drops the old lens, a new move its direction, a new focus the old rack focus, a new kind or subject
        whose shoulder or eyes it was; and whatever asks for another picture drops a place chosen by hand.
        """
        dropped = {"lens"} if later.size else set()
        dropped |= {"direction"} if later.movement else set()
        dropped |= {"focus_to"} if later.focus else set()
        dropped |= {"over_id", "pov_id"} if later.kind or later.focus_on_ids else set()
        dropped |= {"placed"} if later.reframes else set()
        kept = self.model_dump(exclude_none=True, exclude=dropped)
        return self.model_validate({**kept, **later.model_dump(exclude_none=True)})

    @property
    def reframes(self) -> bool:
        """Whether it asks the crew for another picture."""
        return any((self.kind, self.focus_on_ids, self.size, self.angle, self.movement))

    def holds(self, instruction: CameraInstruction) -> bool:
        """Return whether an instruction is as it was decided."""
        decided = self.model_dump(exclude_none=True, exclude={"moment", "placed"})
        return all(getattr(instruction, name) == value for name, value in decided.items())

    def applied(self, instruction: CameraInstruction) -> CameraInstruction:
        """Return an instruction as it was decided."""
        changes = self.model_dump(exclude_none=True, exclude={"moment", "placed"})
        if self.size is not None:
            changes = {"lens": None, **changes}
        if self.movement is not None:
            changes = {"direction": None, **changes}
        if self.focus is not None:
            changes = {"focus_to": None, **changes}
        if self.kind is not None or self.focus_on_ids is not None:
            shown = {*(self.focus_on_ids or instruction.focus_on_ids), self.over_id or ""}
            axis = instruction.axis if shown.intersection(instruction.axis or ()) else None
            changes = {"over_id": None, "pov_id": None, "detail": None, "through": None, "axis": axis, **changes}
        if self.placed is not None:
            changes |= {"movement": "static" if self.placed.end is None else "track", "direction": None}
        return CameraInstruction.model_validate({**instruction.model_dump(), **changes})


class CameraRetake(CameraDecision):
    """What the Frame Critic changed of a shot whose frame did not tell its lines; fields left out are as planned."""

    moment: Moment | None = None

    @property
    def decision(self) -> CameraDecision:
        """The part of it that a person may decide as well."""
        return CameraDecision(**{name: getattr(self, name) for name in CameraDecision.model_fields})


def _listed(value: object) -> object:
    return ", ".join(value) if isinstance(value, tuple) else value
