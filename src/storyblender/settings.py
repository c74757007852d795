"""Settings of a run: defaults, then ``storyblender.toml`` beside the script, then the command line.

A project remembers those it was made with, so that a later ``render`` draws in the same look with the same lenses.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated, Any, Self

from pydantic import AfterValidator, BeforeValidator, ConfigDict, Field, PrivateAttr, ValidationError, model_validator
from pydantic_core import ErrorDetails

from storyblender.crew_setting import LimitName, RoleName, players
from storyblender.errors import InputError
from storyblender.memory.base import Frozen
from storyblender.memory.board_layout import BoardLayout, Orientation, PanelsPerPage, Paper
from storyblender.memory.jobs import Look
from storyblender.memory.picture_format import LARGEST, Aspect, FormatDecision, SensorWidth
from storyblender.service_setting import LicenceFilter, ServiceLimit, services_in
from storyblender.settings_file import REMEMBERED, SettingsFile, short

Lens = Annotated[float, Field(ge=4, le=1200)]
"""mm."""


def _as_list(value: Any) -> Any:
    """Return one path as a list of one."""
    return [value] if isinstance(value, str | Path) else value


def _unless_empty(value: Any) -> Any:
    """Return a path, None for an empty one: no file."""
    return None if value == "" else value


def _clock(value: str) -> str:
    if not re.fullmatch(r"([01]\d|2[0-3])(:[0-5]\d){2}:\d\d", value, re.ASCII):
        raise ValueError("it should be hours, minutes, seconds and frames, for example 01:00:00:00")
    return value


def _players(value: str) -> str:
    players(value)
    return value


def _services(value: str) -> str:
    services_in(value)
    return value


class Settings(Frozen):
    """Everything a run can be told. Every field has a default that just works."""

    model_config = ConfigDict(allow_inf_nan=False)

    look: Look = "board"
    crew: Annotated[str, AfterValidator(_players)] = "rules"
    """Who plays each role: rules, a model, a folder of requests and answers, a recording (``docs/crew.md``)."""
    limits: dict[LimitName, Annotated[float, Field(gt=0)]] = {}
    """The most that a run asks of models in all, where it is not ``crew_setting.LIMITS``."""
    aspect: Aspect = 16 / 9
    width: int = Field(default=960, ge=160, le=LARGEST, multiple_of=4)
    """Pixels of a frame; the height follows the aspect ratio."""
    fps: int = Field(default=24, ge=6, le=120)
    sensor_width: SensorWidth = 36.0
    lens_kit: Annotated[tuple[Lens, ...], Field(max_length=50)] = ()
    """Lenses at hand, mm; empty allows any. A shot takes the nearest, or a wider one where the room is short."""
    seed: int = Field(default=0, ge=0, lt=2**32)
    """Another number, another choice wherever several would do: faces, clothes, how a set is filled."""
    shots_per_scene: int = Field(default=4, ge=1, le=60)
    """About how many shots a scene may have; explicit camera directions are always kept."""
    animatic: bool = True
    animatic_width: int = Field(default=640, ge=160, le=1920)
    on_twos: bool = True
    slate: bool = False
    """Burn the shot's name, lens and timecode into the frames."""
    start_timecode: Annotated[str, AfterValidator(_clock)] = "01:00:00:00"
    """Timecode of the first frame, ``HH:MM:SS:FF``, in the timeline, the shot list and on slates."""
    panels: PanelsPerPage = 6
    """On a page of the board."""
    paper: Paper = "a4"
    """Of the board."""
    orientation: Orientation = "landscape"
    """Of the pages of the board."""
    jobs: int = Field(default=0, ge=0, le=64)
    """Blender processes; 0 takes one for each processor, two at most for memory's sake."""
    models: Annotated[tuple[Path, ...], BeforeValidator(_as_list), Field(max_length=20)] = ()
    """Folders of the user's own models (``docs/your-own-models.md``), searched before the built-in library; of equal
    matches that in the earlier folder is taken. In ``storyblender.toml`` they are named from there, one or a list."""
    services: Annotated[str, AfterValidator(_services)] = ""
    """Where assets may come from beside the user's folders and the built-in library (``docs/services.md``)."""
    licences: LicenceFilter = "any"
    """Which licences the assets that services offer may have."""
    service_limits: dict[ServiceLimit, Annotated[float, Field(gt=0)]] = {}
    """The most that a run spends on services, where it is not ``service_setting.SERVICE_LIMITS``."""
    library: bool = True
    """Whether what earlier stories brought into the user's library is used again."""
    motions: Annotated[tuple[Path, ...], BeforeValidator(_as_list), Field(max_length=20)] = ()
    """Folders of the user's own .bvh and .fbx clips. In ``storyblender.toml`` they are named from there."""
    hdri: Annotated[Path | None, BeforeValidator(_unless_empty)] = None
    """A panorama, .hdr or .exr, that lights exteriors by day; ``""`` is none. In ``storyblender.toml`` it is named from
    there."""
    build: Path | None = None
    """A folder on another disk that takes the place of ``build/`` in the project. In ``storyblender.toml`` it is named
    from there. One folder for each project."""
    thresholds: dict[RoleName, Annotated[float, Field(ge=0, le=10)]] = {}
    """tau by role; the role's own where not given, mostly the paper's 8."""
    horizons: dict[RoleName, Annotated[int, Field(ge=1, le=100)]] = {}
    """T_max by role."""
    _ordered: frozenset[str] = PrivateAttr(default=frozenset())

    @model_validator(mode="after")
    def _fit_together(self) -> Self:
        height = self.width / self.aspect
        if height > LARGEST:
            raise ValueError(
                f"a picture {self.width} wide at this aspect is {height:.0f} high, and {LARGEST} is the most"
            )
        frames = int(self.start_timecode[-2:])
        if frames >= self.fps:
            raise ValueError(f"start_timecode ends in frame {frames}, and there are {self.fps} frames a second")
        return self

    def reflection(self, role: RoleName, threshold: float = 8.0, horizon: int = 5) -> tuple[float, int]:
        """Return tau and T_max of a role: those that were given, else the role's own.

        Args:
            role: Its name.
            threshold: The role's own tau, 1 to 10.
            horizon: The role's own T_max, in refinements.
        """
        return self.thresholds.get(role, threshold), self.horizons.get(role, horizon)

    @classmethod
    def load(cls, script: Path | None = None, project: Path | None = None, **overrides: Any) -> Settings:
        """Read the settings for a script, or those that a project was made with.

        Args:
            script: ``storyblender.toml`` is looked for in its folder.
            project: The folder of a project. Where there is a script too, only the user's folders and the
                panorama are taken from it.
            overrides: From the command line; None means not given.

        Raises:
            InputError: A setting is unknown or out of range.
        """
        file = None
        if script is not None:
            file = SettingsFile.read(script.parent / "storyblender.toml")
        elif project is not None:
            file = SettingsFile.read(project / REMEMBERED)
        values = dict(file.values) if file else {}
        for name in ("models", "motions", "hdri", "build"):
            if file and values.get(name):
                values[name] = file.paths(name)
        made_with = SettingsFile.read(project / REMEMBERED) if script is not None and project is not None else None
        for name in ("models", "motions", "hdri"):
            if made_with is not None and name not in values and name in made_with.values:
                values[name] = made_with.paths(name)
        given = {key: value for key, value in overrides.items() if value is not None}
        try:
            settings = cls.model_validate(values | given)
            settings._ordered = frozenset(given).intersection(FormatDecision.model_fields)
            return settings
        except ValidationError as error:
            fault = error.errors()[0]
            ours = file is None or bool(fault["loc"] and fault["loc"][0] in given)
            raise cls._refusal(fault, None if ours else file) from error

    @classmethod
    def _refusal(cls, fault: ErrorDetails, file: SettingsFile | None) -> InputError:
        """Say what is wrong with a setting, and in which line of which file if it is from one."""
        name = ".".join(str(part) for part in fault["loc"] if part != "[key]")
        path, line = (file.path, file.line_of(name)) if file else (None, None)
        if fault["type"] == "extra_forbidden":
            known = ", ".join(cls.model_fields)
            return InputError(f"there is no setting {short(name)}", mend=f"it is one of {known}", path=path, line=line)
        mend = fault["msg"].removeprefix("Value error, ").replace("Input should", "it should").replace("tuple", "list")
        if not name:
            return InputError("the settings do not fit together", mend=mend, path=path)
        problem = f"setting {short(name)} cannot be {short(fault['input'])}"
        return InputError(problem, mend=mend, path=path, line=line)

    @property
    def ordered_format(self) -> frozenset[str]:
        """Fields of ``FormatDecision`` that the command line gave: they win over what a person decided before."""
        return self._ordered

    @property
    def language_roles(self) -> tuple[RoleName, ...]:
        """Roles that a model or a person plays, without their names: a replay makes the same plan as its recording."""
        return tuple(role for role, player in players(self.crew).items() if player.kind != "rules")

    @property
    def board_layout(self) -> BoardLayout:
        """How the pages of the board are laid out."""
        return BoardLayout(panels=self.panels, paper=self.paper, orientation=self.orientation)

    def remembered(self, project: Path) -> str:
        """Return what a project keeps, as JSON: all that differs from the defaults and is not of this machine.

        Args:
            project: Its folder. A folder of models or a panorama beside it or in it is named from there, so that both
                can be moved together; another one by its whole path.
        """
        home = project.resolve()

        def named(path: Path) -> Path:
            whole = path.resolve()
            return Path(os.path.relpath(whole, home)) if whole.is_relative_to(home.parent) else whole

        update = {
            "models": tuple(map(named, self.models)),
            "motions": tuple(map(named, self.motions)),
            "hdri": self.hdri and named(self.hdri),
        }
        kept = self.model_copy(update=update)
        return kept.model_dump_json(exclude_defaults=True, exclude={"jobs"}, indent=1)
