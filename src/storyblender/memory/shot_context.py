"""Layer 4, the Shot Context: what happens, who stands where, and the camera, shot by shot."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from storyblender.memory.base import (
    Coordinate,
    Digest,
    Frames,
    Frozen,
    Identifier,
    Quaternion,
    SceneId,
    ShotId,
    Vec2,
    Vec3,
    dropping,
    is_none,
)
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction, CameraRetake
from storyblender.memory.covers import Covers
from storyblender.memory.kept_takes import BlockingTakes
from storyblender.memory.locks import ShotLock
from storyblender.memory.mocap import MocapClip
from storyblender.memory.notes import Note
from storyblender.memory.scene_context import Light, Lighting, Spot
from storyblender.memory.scene_decision import BlockingDecision
from storyblender.memory.thing_states import THING_STATES, state_values
from storyblender.memory.vocabulary import (
    BodyPlace,
    Expression,
    GazeDirection,
    Grip,
    Hand,
    LightQuality,
    ModificationType,
    Moment,
    Mood,
    Posture,
    TetherKind,
    ThingState,
    TimeOfDay,
)


class AssetModification(Frozen):
    """A change of an asset's state within a shot (the paper's; a part such as a door may be named)."""

    asset_id: Identifier
    modification_type: ModificationType
    state: ThingState | Literal[""] = ""
    """Empty where it does not look otherwise."""
    writing: str = Field(default="", exclude_if=lambda value: not value)
    """The words on it, where it is ``lettered``."""
    doors: tuple[str, ...] | None = Field(default=None, exclude_if=is_none)
    """Names of the doors of a vehicle that are open from now on; None where it is not about doors with a name."""
    _former = dropping("description")

    @model_validator(mode="before")
    @classmethod
    def _from_words(cls, value: object) -> object:
        """Older projects have words for a state, with the writing and the doors in them."""
        if not isinstance(value, dict) or value.get("state", "") in ("", *THING_STATES):
            return value
        return {**value, **state_values(str(value["state"]))._asdict()}


class CharacterAction(Frozen):
    """One action of one character, as the Director read it."""

    asset_id: Identifier
    action_description: str
    motion: str = "idle"
    """Key of ``catalog.motions``."""
    target_id: Identifier | None = None
    prop_id: Identifier | None = None
    distance: Coordinate | None = None
    """Metres travelled, where the script says so."""
    mood: Mood = "neutral"
    company: tuple[Identifier, ...] = ()
    """People it is done with."""
    gets_out: bool = False
    """Of a way: whether it begins in a vehicle."""
    flies: bool = False
    """Of an animal: whether it is off the ground."""
    line_index: int | None = None
    """Index into the shot's lines, where the action belongs to one (speech)."""
    mocap: MocapClip | None = Field(default=None, exclude_if=is_none)
    """The motion of the user's own that plays it."""


class BodyState(Frozen):
    """What a person is doing when a shot begins: carried from shot to shot until the script changes it."""

    asset_id: Identifier
    posture: Posture = "stand"
    support_id: Identifier | None = None
    """What they sit, lie or lean on."""
    held: tuple[Identifier, ...] = ()
    looking_at: Identifier | None = None
    gaze: GazeDirection | None = None
    """Direction of a gaze that rests on nothing in the set; takes precedence over ``looking_at``."""
    expression: Expression = "neutral"
    activity: str = ""
    """Key of the motion of ``catalog.motions`` that continues until it is changed: ``phone``, ``paint``."""
    grips: tuple[tuple[Identifier, Grip], ...] = ()
    """How props are carried; a held prop that is not listed gets an automatic grip."""
    spot: Spot | None = None
    """Position of the character, if the script gives one."""


class Tether(Frozen):
    """A link by which a character or prop is led or tied: a dog on its leash, a child by the hand."""

    holder: Identifier
    """The person who leads, or the object that it is tied to."""
    held: Identifier
    kind: TetherKind = "rope"


class LightChange(Frozen):
    """A change of the light of a place in a shot; the first of hour and lamps that is set counts, qualities else."""

    lamps: Literal["on", "off"] | None = None
    """Whether the lamps go on or out."""
    hour: TimeOfDay | None = None
    """Another hour: the sun rises or sets."""
    qualities: tuple[LightQuality, ...] = ()


class Flag(Frozen):
    """A decision the Director was not sure of; listed in the report for a person to check."""

    topic: str
    choice: str
    reason: str
    start: int = 0
    end: int = 0


class Mark(Frozen):
    """Where a person is at one moment of a shot."""

    asset_id: Identifier
    location: Vec3
    """Floor point under the hips while standing; the seat's front edge point while sitting."""
    yaw: Coordinate
    """Degrees; 0 faces -Y."""
    posture: Posture = "stand"
    support_id: Identifier | None = None
    """node_id of the seat, bed or rail."""
    anchor_name: str = ""
    held: tuple[tuple[Hand, Identifier], ...] = ()


class Blocking(Frozen):
    """One person's marks at the start and at the end of a shot."""

    start: Mark
    end: Mark
    visible: bool = True
    """False while the person is off stage for the whole shot."""


class Cue(Frozen):
    """One clip in a performance: who does what, when. Frames count from 0 at the shot's start."""

    asset_id: Identifier
    clip: Identifier
    """Key of ``catalog.motions``."""
    start: Frames
    duration: Frames | None = None
    """Frames; None lets the clip take its natural length."""
    target_id: Identifier | None = None
    """node_id or asset_id of a person or thing."""
    prop_id: Identifier | None = None
    hand: Hand | None = None
    mark: Mark | None = None
    """Where the clip ends, for travel and posture changes."""
    via: tuple[Vec2, ...] = Field(default=(), exclude_if=lambda value: not value)
    """Floor points that a walk goes through."""
    mood: Mood = "neutral"
    expression: Expression | None = None
    """For the clip ``face``: the facial expression from this cue on."""
    lasting: bool = False
    """Whether the motion continues underneath other cues until the shot ends."""
    mocap: Digest | None = Field(default=None, exclude_if=is_none)
    """The recorded motion that plays it in place of the clip."""


class PropState(Frozen):
    """Where a movable prop is during a shot when it is not at its place in the layout."""

    asset_id: Identifier
    visible: bool = True
    location: Vec3 | None = None
    rotation: Vec3 = (0.0, 0.0, 0.0)
    held_by: Identifier | None = None
    hand: Hand | None = None
    """None where it is held in no hand: it is in their clothes, or on their body."""
    place: BodyPlace | None = None
    """Where the prop is on its owner's body, if no hand holds it."""


class CameraPose(Frozen):
    """The orbital state at one frame (paper, appendix: pivot, rotation, distance)."""

    frame: Frames = 0
    pivot: Vec3
    rotation: Quaternion
    """World from camera; the camera looks along its -Z."""
    distance: float = Field(gt=0, le=1e6)
    """Metres."""
    lens: float = Field(gt=0, le=10_000)
    """mm."""


class Flaw(Frozen):
    """What the crew could not make right in a shot; the checklist tells a person those that matter."""

    kind: str = ""
    """The critic's word for it, e.g. ``hidden`` or ``unreachable``."""
    subject: str = ""
    """node_id or asset_id it is about."""
    weight: float = 0.0
    """Of a camera, points of ten; of the staging, metres."""
    message: str
    """The sentence of the trace."""
    shot: str = ""
    """Shot name, where the flaw is not kept with its shot."""

    @model_validator(mode="before")
    @classmethod
    def _from_sentence(cls, value: object) -> object:
        """Older projects kept the sentence alone."""
        return {"message": value} if isinstance(value, str) else value


class FocusKey(Frozen):
    """Where the lens is focused at one frame; the depth of field is flat, at the depth of the point."""

    frame: Frames = 0
    point: Vec3
    """World, metres."""
    node_id: str = ""
    """Whom or what it is focused on."""


class CameraState(Frozen):
    """The camera of a shot: one pose if static, two or more if it moves; eased between."""

    poses: tuple[CameraPose, ...]
    sensor_width: float = Field(default=36.0, ge=1, le=100)
    """mm."""
    f_number: float = Field(default=2.8, gt=0, le=1000)
    focus: tuple[FocusKey, ...] = ()
    """Where the lens is focused, in order of frames, eased between; empty where everything is sharp."""
    hidden_node_ids: tuple[Identifier, ...] = ()
    """Wild walls: set pieces taken away for this shot."""
    leaves_out: tuple[Identifier, ...] = ()
    """Characters the shot was meant to show who stand too far from the others for a picture of its size."""
    score: float = 0.0
    residual: tuple[Flaw, ...] = ()
    """What the critic still minds."""


class Take(Frozen):
    """A version of a shot's camera that was put by; fields as in ``ShotContext``."""

    number: int = Field(ge=1, le=999)
    """On the slate."""
    camera_instruction: CameraInstruction
    camera_retake: CameraRetake | None = None
    camera_decision: CameraDecision | None = None
    in_frame: tuple[Identifier, ...] = ()
    moment: Moment | None = None
    frame: Frames | None = None
    camera: CameraState | None = None
    """None where people stand elsewhere since: it is set anew when the take is chosen."""
    lights: tuple[Light, ...] = ()


TAKE_FIELDS = tuple(name for name in Take.model_fields if name != "number")
"""What a take is made of."""


class ShotContext(Frozen):
    """Everything about one shot."""

    scene_id: SceneId
    shot_id: ShotId
    on_stage: tuple[Identifier, ...] = ()
    """Characters present in the space of the scene during the shot."""
    in_frame: tuple[Identifier, ...] = ()
    """Characters the shot is meant to show."""
    states: tuple[BodyState, ...] = ()
    """At the start of the shot, one for each person on stage."""
    end_states: tuple[BodyState, ...] = ()
    """Body states at the end of the shot, for the characters whose state changes in it."""
    thing_spots: dict[Identifier, Spot] = {}
    """Positions of props at the end of the shot, if the script gives them: a cup put on the sill."""
    absent: tuple[Identifier, ...] = ()
    """Props of the scene that are not in the set during the shot: not there yet, or gone."""
    tethers: tuple[Tether, ...] = ()
    moment: Moment | None = None
    """Moment that the storyboard frame shows, if the script or the user sets it."""
    moment_line: int | None = None
    """Index into the shot's lines of the one whose actions ``moment`` is about; None if it is about the whole shot."""
    frame: Frames | None = None
    """Frame from the start of the shot that the storyboard shows; chosen by the Camera Operator with the camera."""
    asset_modifications: tuple[AssetModification, ...] = ()
    character_actions: tuple[CharacterAction, ...] = ()
    light_change: LightChange | None = None
    """What the script changes about the light."""
    sound_effect: str | None = None
    camera_instruction: CameraInstruction
    """The Director's camera plan, with ``camera_retake`` and ``camera_decision`` applied on top."""
    camera_retake: CameraRetake | None = None
    """Changes by the Frame Critic after a first take that did not show what the lines say."""
    camera_decision: CameraDecision | None = None
    """What a person decided; it stays with the words of the shot when the script changes."""
    duration: int = Field(default=48, ge=1, le=432_000)
    """Frames at the project's rate."""
    flags: tuple[Flag, ...] = ()
    blocking: tuple[Blocking, ...] = ()
    cues: tuple[Cue, ...] = ()
    prop_states: tuple[PropState, ...] = ()
    camera: CameraState | None = None
    former_camera: CameraState | None = Field(default=None, exclude_if=is_none)
    """Of a shot that was staged again, until its camera is set: the one it had, which stays where it still works."""
    lights: tuple[Light, ...] = ()
    """Key, fill and rim of this shot, solved for its camera."""
    lighting: Lighting | None = None
    """Replaces the scene's light plan from this shot on, where the script changes the light."""
    flaws: tuple[Flaw, ...] = ()
    """What could not be staged as it was read: cheats, deeds that nobody does, things left out or stood in for."""
    locked: tuple[ShotLock, ...] = ()
    """What a person locked: it stays as it is until it is unlocked."""
    decided_duration: Frames | None = Field(default=None, exclude_if=is_none)
    """Length in frames that a person gave the shot; it stays with the words of the shot when the script changes."""
    blocking_decision: BlockingDecision | None = Field(default=None, exclude_if=is_none)
    """Marks that a person set; they stay with the words of the shot when the script changes."""
    motion_by_hand: dict[Identifier, Digest] = Field(default={}, exclude_if=lambda value: not value)
    """What a person animated in Blender, by asset id: the content of a ``MotionByHand``, over what is acted."""
    take: int = Field(default=1, ge=1, le=999, exclude_if=lambda value: value == 1)
    """Number of the take that the film shows: that of the camera above."""
    takes: tuple[Take, ...] = Field(default=(), exclude_if=lambda value: not value)
    """The other takes, by number."""
    blocking_takes: BlockingTakes | None = Field(default=None, exclude_if=is_none)
    """Other blockings that a person kept; they stay with the words of the shot when the script changes."""
    stale: tuple[Literal["motion"], ...] = Field(default=(), exclude_if=lambda value: not value)
    """What an edit made stale and the crew has not made anew yet."""
    notes: tuple[Note, ...] = Field(default=(), exclude_if=lambda value: not value)
    """What people wrote about the shot; they stay with its words when the script changes."""
    approved: tuple[ShotLock, ...] | None = Field(default=None, exclude_if=is_none)
    """What was locked before a person approved the shot, which locks all of it; None where nobody did."""
    omitted: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether a person left it out of the film; its number stays."""
    covers: Covers | None = Field(default=None, exclude_if=is_none)
    """Of a shot that a person split off or added: what it shows of the time that the crew staged for another."""
    joined: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether a person joined it to the shot before it, which shows its time in the film."""
    _former = dropping("new_lighting_description")

    @property
    def motions(self) -> set[str]:
        """Keys of all motions of its actions, activities and cues."""
        activities = {state.activity for state in (*self.states, *self.end_states)} - {""}
        return activities | {action.motion for action in self.character_actions} | {cue.clip for cue in self.cues}

    @property
    def as_take(self) -> Take:
        """The camera as it is, to be put by."""
        return Take(number=self.take, **{name: getattr(self, name) for name in TAKE_FIELDS})

    def showing(self, take: Take) -> ShotContext:
        """Return the shot with the camera of one of its takes; the others stay as they are."""
        update = {field: getattr(take, field) for field in TAKE_FIELDS}
        return self.model_copy(update={"take": take.number, "former_camera": None, **update})

    @property
    def takes_to_set_anew(self) -> tuple[Take, ...]:
        """The other takes without cameras, but for those that a person placed: the people stand elsewhere now."""
        return tuple(
            take
            if take.camera_decision is not None and take.camera_decision.placed is not None
            else take.model_copy(update={"camera": None, "lights": ()})
            for take in self.takes
        )

    @property
    def shown(self) -> tuple[str, ...]:
        """Characters the shot is meant to show, without those its camera leaves out."""
        left = self.camera.leaves_out if self.camera else ()
        return tuple(asset_id for asset_id in self.in_frame if asset_id not in left)
