"""The scene of a shot in 3D, as the studio tells it to the page. Metres, Z up; degrees about Z, counter-clockwise."""

from __future__ import annotations

from typing import Literal

from storyblender.edits.posing import PoseChoices
from storyblender.memory.base import Described

Point = tuple[float, float, float]
FloorPoint = tuple[float, float]


class CameraKey(Described):
    """A camera at a frame of its shot."""

    frame: int
    """From the start of the shot."""
    world: tuple[float, ...]
    """Its matrix in the scene, 4 x 4 by rows, looking along its own -Z, as Blender has it."""
    lens: float
    """mm."""
    distance: float
    """Metres to what it is turned around."""


class StageCamera(Described):
    """The camera of a shot."""

    shot: str
    """Its shot."""
    sensor_width: float
    """mm."""
    keys: tuple[CameraKey, ...]
    """In order of frames; one if it rests."""
    hidden: tuple[str, ...]
    """Node ids of set pieces taken away for it."""
    f_number: float
    """Of its aperture."""
    focus: tuple[str, ...]
    """What it is focused on: first, and last if the focus is racked; empty where everything is sharp."""


class PlacedThing(Described):
    """Something that the layout of a scene places, and a hand may move."""

    name: str
    """As people call it."""
    location: Point
    """Floor point under its middle and height of its underside."""
    rotation: float
    """As it stands."""
    rests: Literal["floor", "surface", "hangs"]
    """What it comes to stand on when it is moved: the floor, whatever is below it, or nothing."""
    carries: tuple[str, ...]
    """Node ids of all that is on it, and goes with it."""
    model: str
    """What a second one is made from, as the library calls it; empty where it has none."""


class PoseOnStage(Described):
    """How a person is at one end of a shot."""

    posture: str
    """``stand``, ``sit`` ..."""
    on: str
    """Node id of what they sit, lie or lean on; empty on the floor."""
    holding: tuple[str, ...]
    """Asset ids of what is in their hands."""
    looking_at: str
    """What a person decided that they look at; empty where the crew chooses."""


class PersonOnStage(Described):
    """A person in a shot, whose marks a hand may move."""

    name: str
    """As people call them."""
    start: Point
    """Floor point as the shot begins."""
    end: Point
    """The same as it ends."""
    rotation: float
    """As it begins."""
    walks: tuple[tuple[FloorPoint, ...], ...]
    """The ways that they walk, in order."""
    via: tuple[FloorPoint, ...]
    """Points that a person set on the first of them."""
    start_pose: PoseOnStage
    """How they are as it begins."""
    end_pose: PoseOnStage
    """How they are as it ends."""


class LampOnStage(Described):
    """A lamp of the scene's light plan, which lights all its shots."""

    kind: str
    """POINT, SPOT, AREA or SUN."""
    location: Point
    """Of a SUN only the direction to ``target`` counts."""
    target: Point
    """Where it points."""
    power: float
    """Watts; of a SUN watts a square metre."""
    color: Point
    """Red, green and blue, scene-linear."""


class Stage(Described):
    """The scene of a shot in 3D, at one moment."""

    shot: str
    """Name of the shot."""
    model: str
    """Address of the scene as glTF; its nodes carry ``node_id``, ``asset_id`` and ``kind``."""
    frame: int
    """The moment, from the start of the shot."""
    frames: int
    """Length of the shot."""
    fps: int
    """Frames a second."""
    aspect: float
    """Width of a picture divided by its height."""
    cameras: tuple[StageCamera, ...]
    """Of all shots of the scene."""
    setting: tuple[str, ...]
    """Shots whose cameras the crew is setting anew."""
    placed: dict[str, PlacedThing]
    """What the layout places, by node id."""
    people: dict[str, PersonOnStage]
    """Who is on stage, by id."""
    lamps: dict[str, LampOnStage]
    """By name."""
    poses: PoseChoices
    """What people here can sit on, lie on, hold and look at."""
    locked: tuple[str, ...]
    """Parts of the shot and of its scene that are locked: camera, blocking, layout, light ..."""
