"""A shot while the Director still cuts: mutable, in ids and units, before it becomes a ShotContext."""

from __future__ import annotations

from dataclasses import dataclass, field

from storyblender.agents.director.motion_families import STRONG
from storyblender.agents.director.reading import CameraNote, Unit
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, BodyPart, CameraDirection, Movement, ShotKind


@dataclass
class Beat:
    """The part of a unit that a shot covers: all of it, or a part of a long speech."""

    unit: Unit
    start: int
    end: int

    @classmethod
    def whole(cls, unit: Unit) -> Beat:
        """Return the beat that covers all of a unit."""
        return cls(unit, unit.start, unit.end)


@dataclass
class ShotDraft:
    """A planned shot."""

    kind: ShotKind
    size: ShotSize
    focus: list[str] = field(default_factory=list)
    """Whom and what it shows, most important first."""
    beats: list[Beat] = field(default_factory=list)
    """Empty for an insert or an establishing shot that has no line of its own."""
    angle: Angle = "eye-level"
    movement: Movement = "static"
    direction: CameraDirection | None = None
    over: str | None = None
    pov: str | None = None
    axis: tuple[str, str] | None = None
    detail: BodyPart | None = None
    """An insert: which part of its person."""
    whole_body: bool = False
    """A person travels in it: it must not be tightened beyond the body."""
    note: CameraNote | None = None
    """The direction in the script that ordered it."""
    rack: tuple[str, str] | None = None
    """Rack focus: what is sharp at first and what in the end."""
    on_stage: list[str] = field(default_factory=list)
    before: Unit | None = None
    """The unit that begins when it ends, where it has no line of its own: a thing it shows is in that hand already."""

    @property
    def has_note(self) -> bool:
        """Whether a camera direction asks for this shot."""
        return self.note is not None

    @property
    def script_directed(self) -> bool:
        """Whether the script itself orders this shot; a corrected reading only advises."""
        return self.note is not None and bool(self.note.phrase)

    @property
    def picture(self) -> int | None:
        """Number of the panel, series item or table row that it draws, or of a corrected reading's picture."""
        return self.beats[0].unit.picture if self.beats else None

    @property
    def speech_only(self) -> bool:
        """Whether it covers speech and no action."""
        told = [beat.unit.kind for beat in self.beats if beat.unit.kind in ("action", "dialogue")]
        return bool(told) and all(kind == "dialogue" for kind in told)

    @property
    def motions(self) -> set[str]:
        """Motions of all deeds in it."""
        return {deed.motion for beat in self.beats for deed in beat.unit.deeds}

    @property
    def has_key_action(self) -> bool:
        """Whether it has a motion that must be seen."""
        return bool(self.motions & STRONG)

    def add_focus(self, *ids: str | None) -> None:
        """Add ids to the focus, each once."""
        self.focus += [each for each in dict.fromkeys(ids) if each and each not in self.focus]
