"""Settings of a run: defaults, then ``storyblender.toml`` beside the script, then the command line."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any, Literal

from pydantic import Field, ValidationError

from storyblender.errors import InputError
from storyblender.memory.base import Frozen

Look = Literal["board", "fast", "pencil", "render"]


class Settings(Frozen):
    """Everything a run can be told. Every field has a default that just works."""

    look: Look = "board"
    crew: Literal["rules"] = "rules"
    """Policy of every role; language models plug in here."""
    aspect: float = Field(default=16 / 9, ge=0.4, le=4)
    width: int = Field(default=960, ge=160, le=7680)
    """Pixels of a frame; the height follows the aspect ratio."""
    fps: int = Field(default=24, ge=6, le=120)
    sensor_width: float = Field(default=36.0, ge=4, le=70)
    """mm."""
    lens_kit: tuple[float, ...] = ()
    """Lenses at hand, mm; empty allows any. A shot takes the nearest."""
    seed: int = Field(default=0, ge=0)
    shots_per_scene: int = Field(default=4, ge=1, le=60)
    """About how many shots a scene may have; explicit camera directions are always kept."""
    animatic: bool = True
    animatic_width: int = Field(default=640, ge=160, le=1920)
    on_twos: bool = True
    slate: bool = False
    """Burn the shot's name, lens and timecode into the frames."""
    jobs: int = Field(default=0, ge=0, le=64)
    """Blender processes; 0 takes one for each processor, two at most for memory's sake."""
    models: Path | None = None
    """A folder of the user's own .glb and .blend files, searched before the built-in library."""
    thresholds: dict[str, float] = {}
    """tau by role; the paper's 8 where not given."""
    horizons: dict[str, int] = {}
    """T_max by role."""

    @classmethod
    def load(cls, script: Path | None = None, **overrides: Any) -> Settings:
        """Read the settings for a script.

        Args:
            script: ``storyblender.toml`` is looked for in its folder.
            overrides: From the command line; None means not given.

        Raises:
            InputError: A setting is unknown or out of range.
        """
        path = script.parent / "storyblender.toml" if script else None
        values: dict[str, Any] = {}
        if path is not None and path.is_file():
            try:
                values = tomllib.loads(path.read_text(encoding="utf-8"))
            except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
                raise InputError(f"is not valid TOML ({error})", mend="mend or delete it", path=path) from error
        values |= {key: value for key, value in overrides.items() if value is not None}
        try:
            return cls.model_validate(values)
        except ValidationError as error:
            first = error.errors()[0]
            name = ".".join(str(part) for part in first["loc"])
            raise InputError(f"setting {name!r}: {first['msg']}", mend="see `storyblender make --help`") from error
