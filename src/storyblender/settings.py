"""Settings of a run: defaults, then ``storyblender.toml`` beside the script, then the command line.

A project remembers those it was made with, so that a later ``render`` draws in the same look with the same lenses.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidationError
from pydantic_core import ErrorDetails

from storyblender.errors import InputError
from storyblender.memory.base import Frozen
from storyblender.memory.jobs import Look

Role = Literal[
    "asset_retriever", "dimension_estimator", "environment_designer", "set_dresser", "spatial_planner", "animator",
    "lighting_arranger",
]  # fmt: skip
"""Who reflects as it is told here."""
Lens = Annotated[float, Field(ge=4, le=1200)]
"""mm."""


def _ratio(value: Any) -> Any:
    """Return a ratio written as people write it, ``16:9`` or ``2.39:1``, as the number that it is."""
    wide, colon, high = value.partition(":") if isinstance(value, str) else (value, "", "")
    try:
        return float(wide) / float(high) if colon else value
    except (ValueError, ZeroDivisionError):
        return value


REMEMBERED = "settings.json"
"""In the project folder."""


class Settings(Frozen):
    """Everything a run can be told. Every field has a default that just works."""

    look: Look = "board"
    crew: Literal["rules"] = "rules"
    """Policy of every role; language models plug in here."""
    aspect: Annotated[float, BeforeValidator(_ratio)] = Field(default=16 / 9, ge=0.4, le=4)
    width: int = Field(default=960, ge=160, le=7680, multiple_of=4)
    """Pixels of a frame; the height follows the aspect ratio."""
    fps: int = Field(default=24, ge=6, le=120)
    sensor_width: float = Field(default=36.0, ge=4, le=70)
    """mm."""
    lens_kit: tuple[Lens, ...] = ()
    """Lenses at hand, mm; empty allows any. A shot takes the nearest, or a wider one where the room is short."""
    seed: int = Field(default=0, ge=0)
    shots_per_scene: int = Field(default=4, ge=1, le=60)
    """About how many shots a scene may have; explicit camera directions are always kept."""
    animatic: bool = True
    animatic_width: int = Field(default=640, ge=160, le=1920)
    on_twos: bool = True
    slate: bool = False
    """Burn the shot's name, lens and timecode into the frames."""
    start_timecode: str = Field(default="01:00:00:00", pattern=r"^([01]\d|2[0-3]):[0-5]\d:[0-5]\d:\d\d$")
    """Timecode of the first frame, ``HH:MM:SS:FF``, in the timeline, the shot list and on slates."""
    jobs: int = Field(default=0, ge=0, le=64)
    """Blender processes; 0 takes one for each processor, two at most for memory's sake."""
    models: Path | None = None
    """A folder of the user's own .glb and .blend files, searched before the built-in library."""
    thresholds: dict[Role, Annotated[float, Field(ge=0, le=10)]] = {}
    """tau by role; the paper's 8 where not given."""
    horizons: dict[Role, Annotated[int, Field(ge=1, le=100)]] = {}
    """T_max by role."""

    @classmethod
    def load(cls, script: Path | None = None, project: Path | None = None, **overrides: Any) -> Settings:
        """Read the settings for a script, or those that a project was made with.

        Args:
            script: ``storyblender.toml`` is looked for in its folder.
            project: The folder of a project, where there is no script.
            overrides: From the command line; None means not given.

        Raises:
            InputError: A setting is unknown or out of range.
        """
        path, values = None, {}
        if script is not None:
            path = script.parent / "storyblender.toml"
            values = _read(path, tomllib.loads)
        elif project is not None:
            path = project / REMEMBERED
            values = _read(path, json.loads)
        given = {key: value for key, value in overrides.items() if value is not None}
        try:
            return cls.model_validate(values | given)
        except ValidationError as error:
            first = error.errors()[0]
            raise cls._refusal(first, path=None if first["loc"][0] in given else path) from error

    @classmethod
    def _refusal(cls, fault: ErrorDetails, path: Path | None) -> InputError:
        """Say what is wrong with a setting, and in which file if it is from one."""
        name = ".".join(str(part) for part in fault["loc"] if part != "[key]")
        if fault["type"] == "extra_forbidden":
            known = ", ".join(cls.model_fields)
            return InputError(f"there is no setting {name!r}", mend=f"it is one of {known}", path=path)
        mend = fault["msg"].replace("Input should", "it should")
        return InputError(f"setting {name!r} cannot be {fault['input']!r}", mend=mend, path=path)

    def remembered(self) -> str:
        """Return what a project keeps, as JSON: all that differs from the defaults and is not of this machine."""
        return self.model_dump_json(exclude_defaults=True, exclude={"jobs", "models"}, indent=1)


def _read(path: Path, parse: Callable[[str], dict[str, Any]]) -> dict[str, Any]:
    """Return the settings in a file; none where there is no file."""
    if not path.is_file():
        return {}
    try:
        values = parse(path.read_text(encoding="utf-8"))
        if not isinstance(values, dict):
            raise ValueError("it is a list of names and values")
        return values
    except ValueError as error:
        raise InputError(f"cannot be read as settings ({error})", mend="mend or delete it", path=path) from error
