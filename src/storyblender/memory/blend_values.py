"""What a story's .blend says in values: as it was compiled, and as a person saved it."""

from __future__ import annotations

from typing import Literal

from storyblender.memory.asset_sheet import AdoptedModel
from storyblender.memory.base import Frozen, dropping
from storyblender.memory.motion_by_hand import HandMotionRead

Vector = tuple[float, float, float]


class CurveValues(Frozen):
    """The keys of an action, or of what a strip plays, for one object."""

    keys: int
    """How many there are, over all channels."""
    frames: str
    """Digest of channels and frames."""
    values: str
    """Digest of the values."""


class StripValues(Frozen):
    """A strip of an object's motion."""

    name: str
    """Such as ``SC010_SH020``."""
    start: float
    """Frame of the scene's timeline."""
    end: float
    """Likewise."""
    curves: CurveValues
    """What it plays."""


class PoseValues(Frozen):
    """Where a camera is at a frame."""

    frame: int
    """Of the scene's timeline."""
    location: Vector
    """Metres."""
    rotation: tuple[float, float, float, float]
    """World from camera: w, x, y, z of a unit quaternion."""
    lens: float
    """mm."""


class CameraValues(Frozen):
    """What is peculiar to a camera."""

    poses: tuple[PoseValues, ...]
    """At its first and last key; one pose if it rests."""
    between: tuple[int, ...]
    """Frames of the keys between."""
    path: str = ""
    """Digest of all keys of its move; empty for one that rests."""
    f_number: float
    """Of its depth of field."""
    blurs: bool
    """Whether that is switched on."""


class LampValues(Frozen):
    """What is peculiar to a lamp."""

    kind: Literal["POINT", "SPOT", "AREA", "SUN"] = "POINT"
    """As Blender has them."""
    size: float = 0.0
    """Metres: radius of POINT and SPOT, diameter of AREA; degrees of a SUN."""
    cone: float = 60.0
    """Of a SPOT, degrees."""

    power: float
    """As Blender has it: watts, or W/m2 of a sun."""
    color: Vector
    """Linear RGB."""


class SurfaceValues(Frozen):
    """A material."""

    name: str
    """As it was before it was painted, which is what edits call it."""
    color: Vector
    """Linear RGB; of one with a picture as the viewport shows it."""
    roughness: float
    """0 to 1."""
    metallic: float
    """0 to 1."""
    base: Literal["plain", "picture", "other"]
    """Where its colour comes from; of ``other`` nothing can be painted."""
    finish: str = ""
    """Key of the catalogue's material that it is as it was made there; else empty."""


class StripInEdit(Frozen):
    """A strip of the scene with the cut."""

    name: str
    """Such as ``SC010_SH020``."""
    start: int
    """First frame that is seen."""
    frames: int
    """How many are."""
    offset: int
    """Frames of its scene before the first that is seen."""
    muted: bool
    """Whether it is switched off."""


class NodeValues(Frozen):
    """One object of a scene; the parts of a person go with their armature."""

    name: str
    """As it is called in the file."""
    kind: Literal["character", "prop", "set", "light", "camera", ""]
    """Empty for what the program did not make."""
    node_id: str
    """In the graph."""
    asset_id: str
    """In the graph; empty for set pieces, lamps and cameras."""
    origin: str
    """Name that it was compiled with; a copy has the same, and what a person added has none."""
    animated: bool
    """Whether keys say where it is; its place at rest means nothing then."""
    location: Vector
    """Metres, of its origin."""
    rotation: Vector
    """Degrees about X, Y and Z, in this order."""
    scale: Vector
    """Factors."""
    strips: tuple[StripValues, ...] = ()
    """Of its motion."""
    action: CurveValues | None = None
    """Its own action above the strips."""
    posing: str = ""
    """Digest of what poses it besides keys: constraints, switches of its controls. Empty where there is none."""
    camera: CameraValues | None = None
    """Of a camera."""
    lamp: LampValues | None = None
    """Of a lamp."""
    materials: tuple[str, ...] = ()
    """In its slots, with those of its parts."""
    shape: str = ""
    """Digest of its mesh, with its modifiers and without its materials; empty where it has none."""
    solid: bool = False
    """Whether it, or what hangs on it, has a surface."""


class SceneValues(Frozen):
    """A scene of the file."""

    name: str
    """Such as ``SC010``."""
    nodes: tuple[NodeValues, ...]
    """By name."""
    markers: dict[str, int]
    """Frame at which each shot begins, by name of the shot."""
    end: int
    """Last frame."""
    bound: dict[str, str] = {}
    """Name of the camera that each marker switches to."""


class BlendValues(Frozen):
    """A file of the story."""

    version: str
    """Of the project that it was compiled from; edits in it were made on that."""
    scenes: tuple[SceneValues, ...]
    """By name."""
    surfaces: dict[str, SurfaceValues] = {}
    """Materials by name in the file."""
    cut: tuple[StripInEdit, ...] | None = None
    """The strips of the scene EDIT, in order; None where it has none."""
    _former = dropping("materials")


class AdoptedObject(Frozen):
    """An object of a file as a model of its own, and where that stands."""

    model: AdoptedModel
    """In the project."""
    location: Vector
    """Metres, of its bottom centre."""
    rotation: float
    """Degrees about Z."""


class BlendReading(Frozen):
    """A file as it is now, beside what it was compiled as."""

    compiled: BlendValues | None
    """None for a file of an early version, and one whose text block is gone."""
    saved: BlendValues
    """As it is in the file."""
    by_hand: tuple[HandMotionRead, ...] = ()
    """How people and things move in it otherwise than they were compiled."""
