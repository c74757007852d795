"""Layer 2, the Asset Sheet: every character and object once, under one id, for the whole story."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, StringConstraints, model_validator

from storyblender.memory.base import Color, Described, Digest, Frozen, Identifier, Vec2, Vec3, dropping, is_none
from storyblender.memory.vocabulary import AssetType, Gender, SizeWord, StatureWord

ParamValue = float | str | bool
_Length = Annotated[float, Field(ge=0, le=1e5)]
"""Metres."""
NOTE_LENGTH = 500
Note = Annotated[str, StringConstraints(max_length=NOTE_LENGTH)]
"""A line of text from outside."""
PROMPT_LENGTH = 2000
_FETCHED_WORK = re.compile(r"(?P<source>[a-z_]+)/(?P<id>[^/]+)-[0-9]k/[^/]+")
_NUMBER = re.compile(r"[0-9a-f]{16,}")


class Garment(Frozen):
    """One piece of clothing: a key of ``catalog.garments`` and its colour."""

    key: Identifier
    color: Color | None = None


BodyBuild = Literal["slim", "average", "athletic", "stocky", "heavy"]
SkinTone = Literal["pale", "light", "tan", "brown", "dark"]
FacialHair = Literal["none", "stubble", "moustache", "beard"]


class CharacterLook(Frozen):
    """How a person looks, in the words of casting; the people builder fills every gap with a plausible default."""

    gender: Gender = "unknown"
    age: float = Field(default=35.0, ge=0, le=110)
    """Years."""
    stature: float | None = Field(default=None, ge=0.4, le=2.4)
    """Metres; None lets age and gender decide."""
    build: BodyBuild = "average"
    skin: SkinTone = "light"
    hair: Identifier = "short"
    """A key of ``catalog.hair``."""
    hair_color: Color | None = None
    facial_hair: FacialHair = "none"
    garments: tuple[Garment, ...] = ()
    """From the inside out; empty lets gender, age and period decide."""
    glasses: bool = False
    species: str = ""
    """Key of ``catalog.species`` for an animal cast as a character; empty for people."""
    face: int = Field(default=0, ge=0, le=999, exclude_if=lambda value: not value)
    """Which of the faces that fit these words."""


class LookDecision(Described):
    """What a person decided about how a character looks, over the words of casting; what is left out is the crew's."""

    gender: Literal["female", "male"] | None = Field(default=None, exclude_if=is_none)
    """Of the body, and of the clothes that people usually wear."""
    age: Annotated[float, Field(ge=0, le=110)] | None = Field(default=None, exclude_if=is_none)
    """Years."""
    stature: Annotated[float, Field(ge=0.4, le=2.4)] | None = Field(default=None, exclude_if=is_none)
    """Height in metres."""
    build: BodyBuild | None = Field(default=None, exclude_if=is_none)
    """Of the body."""
    skin: SkinTone | None = Field(default=None, exclude_if=is_none)
    """Tone of the skin."""
    hair: Identifier | None = Field(default=None, exclude_if=is_none)
    """A key of ``catalog hair``: ``bob``."""
    hair_color: Color | None = Field(default=None, exclude_if=is_none)
    """Scene-linear; also of a beard."""
    facial_hair: FacialHair | None = Field(default=None, exclude_if=is_none)
    """``none``, ``stubble``, ``moustache`` or ``beard``."""
    glasses: bool | None = Field(default=None, exclude_if=is_none)
    """Whether they wear any."""
    garments: tuple[Garment, ...] | None = Field(default=None, exclude_if=is_none)
    """All that they wear."""
    face: Annotated[int, Field(ge=0, le=999)] | None = Field(default=None, exclude_if=is_none)
    """Which of the faces that fit the rest; another number, another face."""

    def then(self, later: LookDecision) -> LookDecision:
        """Return this decision with a later one on top."""
        return self.model_copy(update=later.told)

    def over(self, look: CharacterLook) -> CharacterLook:
        """Return a look with what was decided over it."""
        return look.model_copy(update=self.told)

    @property
    def told(self) -> dict[str, Any]:
        """The fields that are decided."""
        return {name: value for name, value in self if value is not None}


class Anchor(Frozen):
    """A place on an asset where something can be: a seat, a bed, a surface, a grip, a rail to lean on, a handle.

    All coordinates are in the asset's own frame: bottom-centre origin, front -Y, metres, after scaling.
    """

    kind: Literal["seat", "bed", "top", "grip", "lean", "handle", "mouth", "door", "part", "panel"]
    name: str = ""
    location: Vec3
    """seat: middle of the front edge at sitting height; door: the floor point beside it for getting in; top:
    centre of the surface; grip: palm centre; part, panel: bottom centre."""
    direction: Vec3 = (0.0, -1.0, 0.0)
    """seat: where the sitter faces; bed: from head to feet; grip: the fingers' direction."""
    normal: Vec3 = (0.0, 0.0, 1.0)
    """top: up; grip: the palm's normal, out of the palm into the object."""
    size: Vec2 = (0.0, 0.0)
    """seat: width, depth; bed: width, length; top, part, panel: extent in x, y."""
    clearance: _Length | None = None
    """top, seat: free height above it in metres; None means open. part, panel: their own height."""
    curl: Vec3 = (0.6, 0.6, 0.4)
    """grip: finger curls 0..1 of index, fingers, thumb."""


class Credit(Frozen):
    """Whose work a model is, as its file or the file beside it says; empty where nothing is said."""

    author: Note = ""
    license: Note = ""
    copyright: Note = ""
    url: Note = ""


class Provenance(Credit):
    """Where a model came from."""

    source: Note
    """Name of the asset source: ``models`` for the user's folders."""
    file: Note
    """Path of the file in its source, with ``/`` between the parts."""
    digest: Digest = ""
    """SHA-256 of the model file."""

    def credited(self, credit: Credit) -> Provenance:
        """Return the provenance with what a credit says beyond it."""
        told = {name: said for name, said in credit if said and not getattr(self, name)}
        return self.model_copy(update=told)


ModelSide = Literal["front", "back", "left", "right", "top", "bottom"]
"""A side of a model as its file has it; ``right`` is the viewer's right of one who looks at its front."""


class ModelPose(Frozen):
    """Which sides of a model, as its file has it, are the thing's own front and top."""

    front: ModelSide | None = None
    """None where it has no front: a vase."""
    top: ModelSide | None = None
    """None leaves both to the rules of the engine."""

    @classmethod
    def of(cls, params: Mapping[str, ParamValue]) -> ModelPose:
        """Return the pose in the parameters of a canonical asset. Raises ValueError."""
        return cls.model_validate({name: params[name] for name in cls.model_fields if name in params})

    @property
    def params(self) -> dict[str, ParamValue]:
        """As parameters of a canonical asset; none where rules find it."""
        return {name: side for name, side in self if side is not None}


Certainty = Literal["usual", "estimated", "told"]
"""How sure the dimension of a model is: usual for such a thing; estimated by a language model, so that it chooses the
file's unit; or told by the script or a person, so that it counts and not the file's size."""

FAR = 5.0
"""Match score below which a library asset is only a loose match for what the script means."""


class CanonicalAsset(Frozen):
    """The 3D object an asset became: shared mesh, bottom-centre origin, front -Y, metres (paper, section 3.3)."""

    source: Literal["catalog", "person", "file", "stand_in"]
    key: str
    """Catalog key, or the path of an imported file in the user's folder."""
    params: dict[str, ParamValue] = {}
    dimensions: tuple[_Length, _Length, _Length]
    """Width x, depth y, height z in metres."""
    anchors: tuple[Anchor, ...] = ()
    digest: str
    """Content hash: names the cached geometry file; same digest, same geometry."""
    geometry_hash: str = ""
    """Hash of the vertices and faces that were built; equal across runs (determinism test)."""
    match_score: float | None = None
    """How well the library entry fits the description, 1 to 10."""
    provenance: Provenance | None = Field(default=None, exclude_if=lambda value: value is None)
    """Of what does not come from the built-in library."""

    @property
    def certainty(self) -> Certainty:
        """How sure the asset's dimension is, if it is made from a file."""
        return "told" if self.params.get("told") else "estimated" if self.params.get("estimated") else "usual"

    @property
    def is_stand_in(self) -> bool:
        """Whether the asset is only a substitute: a plain shape, or a loose match from the library."""
        return self.source == "stand_in" or (self.match_score is not None and self.match_score < FAR)


class AssetDimension(Frozen):
    """The one dimension the Dimension Estimator is surest of (paper, appendix); the others follow the shape."""

    width: _Length | None = None
    depth: _Length | None = None
    height: _Length | None = None


PLAUSIBLE = (0.003, 60.0)
"""Least and most metres that a dimension of an asset may have."""


class StatedSize(Frozen):
    """What the script states about the size of an asset."""

    measure: AssetDimension | None = None
    word: SizeWord | StatureWord | None = None
    toy: bool = False
    """Whether it is a small likeness: a toy car, a plush bear."""


class AdoptedModel(Described):
    """A model that a person made or reshaped in Blender, kept in the project."""

    file: Annotated[str, StringConstraints(pattern=r"^model_[0-9a-f]{16}\.blend$")]
    """Its name in the project's folder of adopted models."""
    content: Digest = ""
    """Digest of the file; empty where it is not written yet."""
    size: tuple[_Length, _Length, _Length]
    """Width, depth and height in metres."""


class AssetDecision(Described):
    """What a person had a thing made from."""

    prop: Identifier | Literal[""] = ""
    """Key of ``catalog.props``; empty where it is made from a file."""
    file: Note = Field(default="", exclude_if=lambda value: not value)
    """Path of a model in the user's folders."""
    params: dict[str, ParamValue] = {}
    """Parameters of its builder; of a file its ``front`` and ``top``, and a size in metres that is ``told``."""
    adopted: AdoptedModel | None = Field(default=None, exclude_if=is_none)
    """The model from Blender that it is; ``prop`` then only says what it is used as."""

    @model_validator(mode="after")
    def _has_one_origin(self) -> Self:
        if self.adopted is None and bool(self.prop) == bool(self.file):
            raise ValueError("a thing is made from a prop of the library, from a file or from a model of Blender")
        return self

    @property
    def words(self) -> str:
        """What it is made from, as a person reads it."""
        if self.adopted is not None:
            return "a model from Blender"
        return file_words(self.file) if self.file else self.prop.replace("_", " ")

    def is_kept_by(self, made: CanonicalAsset | None) -> bool:
        """Return whether a thing is made from it, or is not made yet."""
        if made is None or self.file:
            return True
        if self.adopted is not None:
            return made.key == self.adopted.file
        return (made.key, made.params) == (self.prop, self.params)


def file_words(file: str) -> str:
    """Return what a model is called for people: its path, or the name and the source of a work that was fetched.

    Args:
        file: As a decision has it: ``poly_haven/wooden_table_01-1k/model.gltf``.
    """
    work = _FETCHED_WORK.fullmatch(file)
    if work is None:
        return file
    name = "a model" if _NUMBER.fullmatch(work["id"]) else work["id"].replace("_", " ")
    return f"{name} of {work['source'].replace('_', ' ').title()}"


FITTED = "fitted"
"""Tag of a part that is in one place on its vehicle; the tag after it is a key of ``catalog.parts.PART_PROPS``."""


class Asset(Frozen):
    """A single unique character or object in the story."""

    asset_id: Identifier
    asset_type: AssetType
    description: str
    reference_character: Identifier | None = None
    name: str = ""
    """As written in the script, for people to read."""
    tags: tuple[str, ...] = ()
    kind: Identifier | Literal[""] | None = Field(default=None, exclude_if=is_none)
    """What an object is: the catalog key of the prop that its noun means, empty if the catalog has none. None for
    characters, and in projects older than schema 6. Read it with ``catalog.props.prop_names.prop_of``."""
    origin: Literal["script", "dressing", "user"] = "script"
    writing: str = ""
    """Legible text on the asset: a sign, a letter, a screen."""
    liquid: str = Field(default="", exclude_if=lambda value: not value)
    """Colour in hex of the liquid that the script says it holds: a glass of milk."""
    part_of: Identifier | None = None
    """Id of the asset that this one is a part of; a part is shown on the whole asset."""
    look: CharacterLook | None = None
    """Characters only."""
    stated_size: StatedSize = StatedSize()
    dimension: AssetDimension | None = None
    """From the Dimension Estimator."""
    canonical: CanonicalAsset | None = None
    decision: AssetDecision | None = Field(default=None, exclude_if=is_none)
    """What a person had it made from, whatever the script calls it."""
    look_decision: LookDecision | None = Field(default=None, exclude_if=is_none)
    """How a person decided that a character looks, whatever the script says."""
    turned_down: tuple[Note, ...] = Field(default=(), exclude_if=lambda value: not value)
    """Keys of what a person did not want it made from."""
    image_prompt: Annotated[str, StringConstraints(max_length=PROMPT_LENGTH)] = Field(
        default="", exclude_if=lambda value: not value
    )
    """Text-to-image prompt of a thing that no source has, for services that make a picture and a model of it."""
    locked: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether a person locked its look, its size and its model."""
    _former = dropping("text_to_image_prompt")

    @property
    def decided_look(self) -> CharacterLook | None:
        """How a person looks, with what was decided over the words of casting; None for objects."""
        return self.look if self.look is None or self.look_decision is None else self.look_decision.over(self.look)

    @property
    def fitted_part(self) -> str:
        """Which part of a vehicle it is, a key of ``catalog.parts.PART_PROPS``; empty for any other thing."""
        return self.tags[self.tags.index(FITTED) + 1] if FITTED in self.tags else ""
