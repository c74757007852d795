"""The frozen base model, identifiers and content hashes that all four layers share."""

from __future__ import annotations

import hashlib
import json
from typing import Annotated

from pydantic import BaseModel, ConfigDict, StringConstraints

Identifier = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9_]{0,63}$")]
"""A snake_case name, safe as a file name and as a Blender name. Never a path."""

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]
"""Metres, world frame, right-handed, Z up, +X = viewer's right, unless a field says otherwise."""
Color = tuple[float, float, float]
"""Scene-linear RGB, 0 to 1."""


class Frozen(BaseModel):
    """An immutable value of the graph; unknown fields are an error, so a typo never passes silently."""

    model_config = ConfigDict(frozen=True, extra="forbid")


def content_hash(*parts: BaseModel | dict[str, object] | list[object] | str | int | float | None) -> str:
    """Return 16 hex digits that identify the values of ``parts``, stable across runs and machines."""
    plain = [part.model_dump(mode="json") if isinstance(part, BaseModel) else part for part in parts]
    text = json.dumps(plain, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def scene_name(scene_id: int) -> str:
    """Return the name written on slates and in the .blend, e.g. ``SC010`` for scene 1."""
    return f"SC{scene_id * 10:03d}"


def shot_name(scene_id: int, shot_id: int) -> str:
    """Return the name of a shot, its camera and its marker, e.g. ``SC010_SH020``."""
    return f"{scene_name(scene_id)}_SH{shot_id * 10:03d}"
