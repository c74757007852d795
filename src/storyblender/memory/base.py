"""The frozen base model, identifiers and content hashes that all four layers share."""

from __future__ import annotations

import hashlib
import json
import math
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StringConstraints, model_validator

Identifier = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9_]{0,63}$")]
"""A snake_case name, safe as a file name and as a Blender name. Never a path."""

EditName = Annotated[str, Field(min_length=1, max_length=64)]
"""How an edit names a shot, a scene, a person or a thing: as an id, or as people call it."""

SceneId = Annotated[int, Field(ge=1, le=99_999)]
ShotId = Annotated[int, Field(ge=1, le=99_999)]
Frames = Annotated[int, Field(ge=0, le=432_000)]
"""A length or a moment of a shot: an hour at most, at 120 frames a second."""

Coordinate = Annotated[float, Field(ge=-1e6, le=1e6)]
"""Metres, degrees, or a part of a direction."""
Vec2 = tuple[Coordinate, Coordinate]
Vec3 = tuple[Coordinate, Coordinate, Coordinate]
"""Metres, world frame, right-handed, Z up, +X = viewer's right, unless a field says otherwise."""


def _is_rotation(value: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    if not 0.98 < math.hypot(*value) < 1.02:
        raise ValueError("should be a unit quaternion")
    return value


_Quarter = Annotated[float, Field(ge=-1.01, le=1.01)]
Quaternion = Annotated[tuple[_Quarter, _Quarter, _Quarter, _Quarter], AfterValidator(_is_rotation)]
"""A rotation: w, x, y, z of a unit quaternion."""

_Share = Annotated[float, Field(ge=0, le=1e4)]
Color = tuple[_Share, _Share, _Share]
"""Scene-linear RGB, 0 to 1; what glows may be brighter."""


Digest = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{0,64}$")]
"""A hash in hex; empty where it is not known."""


class Frozen(BaseModel):
    """An immutable value of the graph. Unknown fields are an error, so that no typo passes, and floats are finite."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Described(Frozen):
    """A value that a person's program or a model fills in: the docstrings of its fields are in its JSON schema."""

    model_config = ConfigDict(use_attribute_docstrings=True)


def is_none(value: object) -> bool:
    """Return whether a field added since older projects is unused; the graph is then written as they have it."""
    return value is None


def without_fields(value: object, *names: str) -> object:
    """Return the data of a model without fields that only older schemas have; anything but a dict as it is."""
    return {key: each for key, each in value.items() if key not in names} if isinstance(value, dict) else value


def dropping(*names: str) -> Any:
    """Return a model's validator that drops fields which only older schemas have; assign it in the class."""

    def drop(cls: type[Frozen], value: object) -> object:
        return without_fields(value, *names)

    return model_validator(mode="before")(drop)


def content_hash(*parts: BaseModel | dict[str, object] | list[object] | str | int | float | None) -> str:
    """Return 16 hex digits that identify the values of ``parts``, stable across runs and machines."""
    plain = [part.model_dump(mode="json") if isinstance(part, BaseModel) else part for part in parts]
    text = json.dumps(plain, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def seed_of(text: str) -> int:
    """Return a seed for a text, stable across runs and machines."""
    return int(content_hash(text)[:8], 16)


def scene_name(scene_id: int) -> str:
    """Return the name written on slates and in the .blend, e.g. ``SC010`` for scene 1."""
    return f"SC{scene_id * 10:03d}"


SHOT_STEP = 10
"""Between the numbers in the names of two shots of the Director."""
ADDED_FROM = 50_000
"""From here on, ids are of shots that a person split off or added: the number in the name is the rest."""


def shot_number(shot_id: int) -> int:
    """Return the number in the name of a shot: ten times its id; of one that a person added, one between those."""
    return shot_id - ADDED_FROM if shot_id >= ADDED_FROM else shot_id * SHOT_STEP


def staged_id(shot_id: int) -> int:
    """Return the id of the staged shot in whose time a shot begins: its own, but for one that a person added."""
    return shot_number(shot_id) // SHOT_STEP


def shot_name(scene_id: int, shot_id: int) -> str:
    """Return the name of a shot, its camera and its marker, e.g. ``SC010_SH020``.

    Args:
        scene_id: From 1; the name has ten times that.
        shot_id: From 1 in each scene; the name has its ``shot_number``.
    """
    return f"{scene_name(scene_id)}_SH{shot_number(shot_id):03d}"
