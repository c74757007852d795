"""Edits as data: one typed union for all that make them (command line, page, agent, another program)."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, TypeAdapter, model_validator

from storyblender.memory.asset_sheet import AdoptedModel, AssetDimension, Garment, LookDecision, ModelPose, Note
from storyblender.memory.base import Described, Digest, EditName, Frames, Identifier, is_none
from storyblender.memory.edits_of_cut import (
    AddShotEdit,
    ApproveEdit,
    JoinEdit,
    NoteEdit,
    OmitEdit,
    ReorderEdit,
    RestoreEdit,
    SplitEdit,
    TakeEdit,
)
from storyblender.memory.locks import LockName
from storyblender.memory.paint import MaterialName, PaintDecision
from storyblender.memory.picture_format import FormatDecision
from storyblender.memory.scene_decision import LightDecision, PersonMarks, SetDecision, ThingPlace
from storyblender.memory.shot_context import CameraDecision
from storyblender.memory.vocabulary import RelationKind


class CameraEdit(Described):
    """Decides about the camera of a shot; what is left out stays as it is, or is the crew's to choose."""

    kind: Literal["camera"] = "camera"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    decision: CameraDecision
    """Any of its fields; those left out stay as they are."""


class DurationEdit(Described):
    """Gives a shot a length, in frames or in seconds; the crew fits its motions to it."""

    kind: Literal["duration"] = "duration"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    frames: Annotated[Frames, Field(ge=1)] | None = None
    """Length in frames; or give seconds."""
    seconds: float | None = Field(default=None, gt=0, le=3600)
    """Length in seconds; or give frames."""

    @model_validator(mode="after")
    def _has_one_unit(self) -> Self:
        if (self.frames is None) == (self.seconds is None):
            raise ValueError("a length is given in frames or in seconds")
        return self


class LockEdit(Described):
    """Keeps parts of a shot, of a scene or of an asset as they are, against the crew and against further edits."""

    kind: Literal["lock"] = "lock"
    """Which edit this is."""
    target: EditName
    """A shot such as ``SC010_SH020``, a scene such as ``SC010``, or an asset's id."""
    parts: tuple[LockName, ...] = ()
    """Camera, blocking, duration of a shot; layout, light, set of a scene; the asset. All of them if empty."""


class UnlockEdit(Described):
    """Lifts locks, and gives back to the crew what a person decided about these parts."""

    kind: Literal["unlock"] = "unlock"
    """Which edit this is."""
    target: EditName
    """As for a lock."""
    parts: tuple[LockName, ...] = ()
    """As for a lock."""


class LightEdit(Described):
    """Decides about the light of a scene; the crew lights it so and leaves set, staging and cameras as they are."""

    kind: Literal["light"] = "light"
    """Which edit this is."""
    scene: EditName
    """Such as ``SC010``."""
    decision: LightDecision
    """Any of its fields; those left out stay as they are."""


class SetEdit(Described):
    """Decides about the set of a place, in all scenes that play there; for more than materials it is staged again."""

    kind: Literal["set"] = "set"
    """Which edit this is."""
    scene: EditName
    """Such as ``SC010``."""
    decision: SetDecision
    """Any of its fields; those left out stay as they are."""


class LayoutEdit(Described):
    """Stages a scene another way: things and people elsewhere, and cameras after them."""

    kind: Literal["layout"] = "layout"
    """Which edit this is."""
    scene: EditName
    """Such as ``SC010``."""
    staging: int | None = Field(default=None, ge=0, le=999)
    """Number of the staging, 0 for the crew's first; left out, the next one."""


class PlaceEdit(Described):
    """Moves, turns or scales a thing of a scene by hand; what is on it goes with it, and no staging moves it again."""

    kind: Literal["place"] = "place"
    """Which edit this is."""
    scene: EditName
    """Such as ``SC010``."""
    thing: EditName
    """Node id of the thing; its id or name will do where the scene has it once."""
    place: ThingPlace = ThingPlace()
    """Any of its fields; those left out stay as they are."""
    scale: float | None = Field(default=None, ge=0.02, le=50)
    """Factor on its present size: of a thing of the story in all its scenes, of furniture in those of its place."""

    @model_validator(mode="after")
    def _says_something(self) -> Self:
        if self.place == ThingPlace() and self.scale is None:
            raise ValueError("a place has a location, a height or a rotation, or a scale")
        return self


class BlockingEdit(Described):
    """Sets where and how a person is in a shot: marks, posture, look, hands; later shots go on from there."""

    kind: Literal["blocking"] = "blocking"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    person: EditName
    """Id or name of a person on stage."""
    marks: PersonMarks
    """Start, end or both; what is left out stays as it is."""

    @model_validator(mode="after")
    def _says_something(self) -> Self:
        if not self.marks.says_something:
            raise ValueError(
                "marks have a place, a rotation, a posture, a look, things held, a way, a motion or a line"
            )
        return self


class ByHandEdit(Described):
    """Lets a character or a thing move in a shot as a person animated it in Blender, or gives that back to the crew."""

    kind: Literal["by_hand"] = "by_hand"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    who: EditName
    """Id or name of a person on stage, or of a thing that is handled."""
    motion: Digest | None = None
    """Name of a file in the project's folder ``by_hand``, which a pull writes; left out, the crew acts it again."""


class AssetEdit(Described):
    """Replaces, adds, removes or renames a thing; gives it a size, its front and top, or lets the crew choose anew."""

    kind: Literal["asset"] = "asset"
    """Which edit this is."""
    action: Literal["replace", "add", "remove", "rename", "resize", "turn", "regenerate"] = "replace"
    """What is done; ``regenerate``: the crew makes a thing of the story from something else than what it is now."""
    thing: EditName | None = None
    """What is replaced or taken away: the id or name of a thing, or what a piece of furniture is, such as sofa."""
    scene: EditName | None = None
    """Such as ``SC010``; for furniture of a set, and for what is added or taken away."""
    model: EditName | None = None
    """What is wanted, as the library calls it, with a colour or a material: ``red bench``; or give a file."""
    file: Note | None = Field(default=None, exclude_if=is_none)
    """Path of a model in the user's folders, for what is replaced."""
    dimension: AssetDimension | None = Field(default=None, exclude_if=is_none)
    """Metres, to resize: of one side, and the others follow; or of several, of what the library makes."""
    pose: ModelPose | None = Field(default=None, exclude_if=is_none)
    """To turn a model of the user: which sides of it, as its file has it, are front and top."""
    relation: RelationKind | None = Field(default=None, exclude_if=is_none)
    """Where what is added stands at its ``anchor``: next_to, on, behind ...; the crew chooses if left out."""
    anchor: Identifier | None = Field(default=None, exclude_if=is_none)
    """With ``relation``: the id of a thing, or a part of the set: ``window``, ``door``, ``back_wall``."""
    place: ThingPlace | None = Field(default=None, exclude_if=is_none)
    """Where what is added stands to the millimetre, in place of a relation."""
    adopted: AdoptedModel | None = Field(default=None, exclude_if=is_none)
    """The model from Blender that is added, or that is put in place of a thing; ``model`` is then what it is called."""
    name: EditName | None = Field(default=None, exclude_if=is_none)
    """What a thing of the story is called from now on, on board and lists; its id stays."""

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        if (self.relation is None) != (self.anchor is None) or (self.anchor is not None and self.action != "add"):
            raise ValueError("a place takes a relation and an anchor, and is that of a thing that is added")
        if self.place is not None and (self.action != "add" or self.anchor is not None):
            raise ValueError("a thing that is added has a place, or a relation to an anchor")
        wanted = {
            "replace": ("thing", "model" if self.file is None else "file"), "add": ("scene", "model"),
            "remove": ("thing", "scene"),
            "rename": ("thing", "name"), "resize": ("thing", "dimension"), "turn": ("thing", "pose"),
            "regenerate": ("thing",),
        }[self.action]  # fmt: skip
        for name in wanted:
            if getattr(self, name) is None:
                raise ValueError(f"to {self.action} a thing takes a {name}")
        return self


class LookEdit(Described):
    """Decides how a person looks: body, hair, clothes; they are built anew, and the scenes that show them follow."""

    kind: Literal["look"] = "look"
    """Which edit this is."""
    person: EditName
    """Their id or name."""
    decision: LookDecision = LookDecision()
    """Any of its fields; those left out stay as they are."""
    wear: tuple[Garment, ...] = ()
    """What they put on, over what they wear or in its place; keys are of ``catalog garments``."""
    take_off: tuple[Identifier, ...] = ()
    """Keys of garments that they take off."""


class PaintEdit(Described):
    """Paints a material: of a thing or a person, of a scene, or of the whole story; no staging and no model changes."""

    kind: Literal["paint"] = "paint"
    """Which edit this is."""
    material: MaterialName | None = None
    """The material as the story has it: ``wood_dark``; left out, the one that covers most of the thing."""
    thing: EditName | None = None
    """Id or name of a thing or a person, wherever it is; with ``scene``, what stands there, or a piece of its set."""
    scene: EditName | None = None
    """Such as ``SC010``: only there; left out, in the whole story."""
    look: PaintDecision | None = None
    """How it looks then; left out, as it was before anybody painted it."""

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        if self.material is None and self.thing is None:
            raise ValueError("what is painted is a material, a thing, or both")
        if self.look is not None and not self.look.words:
            raise ValueError("a look has a color, a roughness, a metallic, a finish, or is plain")
        return self


class FormatEdit(Described):
    """Decides about the picture of the film, its shape and the sensor; all cameras but locked ones are set anew."""

    kind: Literal["format"] = "format"
    """Which edit this is."""
    decision: FormatDecision
    """Any of its fields; those left out stay as they are."""


Edit = Annotated[
    CameraEdit
    | DurationEdit
    | LightEdit
    | SetEdit
    | LayoutEdit
    | PlaceEdit
    | BlockingEdit
    | ByHandEdit
    | AssetEdit
    | LookEdit
    | PaintEdit
    | FormatEdit
    | TakeEdit
    | NoteEdit
    | ApproveEdit
    | OmitEdit
    | RestoreEdit
    | ReorderEdit
    | SplitEdit
    | JoinEdit
    | AddShotEdit
    | LockEdit
    | UnlockEdit,
    Field(discriminator="kind"),
]
EDITS: TypeAdapter[tuple[Edit, ...]] = TypeAdapter(tuple[Edit, ...])
"""Reads a batch of edits from JSON."""
