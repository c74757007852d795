"""Readings made by hand, so that the tests of the breakdown do not hang on the reader."""

from __future__ import annotations

from storyblender.agents.director.reading import Deed, Person, Reading, SceneReading, Thing, Unit
from storyblender.screenplay.model import Screenplay


class Script:
    """Builds a one-scene reading line by line."""

    def __init__(self, *people: str, things: tuple[str, ...] = (), scene_type: str = "indoor") -> None:
        self.text = ""
        scene = SceneReading(1, "INT. ROOM - DAY", "ROOM", "", scene_type, "day")  # type: ignore[arg-type]
        self.reading = Reading(Screenplay(format="fountain", text=""), scenes=[scene])
        self.reading.people = [Person(name.lower(), name.upper(), (name,)) for name in people]
        self.reading.things = [Thing(name, name) for name in things]
        self.on_stage = [name.lower() for name in people]

    def action(self, text: str, *deeds: tuple[str, ...], **fields: object) -> Script:
        """Add a sentence; a deed is actor, motion, target, prop."""
        self._unit(
            "action", text, deeds=[Deed(*deed, at=len(self.text) + text.index(" ") + 1) for deed in deeds], **fields
        )  # type: ignore[arg-type]
        return self

    def say(self, speaker: str, text: str, to: str | None = None, **fields: object) -> Script:
        """Add a speech."""
        self._unit("dialogue", text, speaker=speaker, speaker_name=speaker.upper(), to=to, **fields)
        return self

    def _unit(self, kind: str, text: str, **fields: object) -> None:
        start = len(self.text)
        self.text += text + "\n\n"
        fields = {"on_stage": list(self.on_stage), "element": len(self.reading.units)} | fields
        self.reading.units.append(Unit(kind, 0, start=start, end=start + len(text), text=text, **fields))  # type: ignore[arg-type]

    def read(self) -> Reading:
        """Return the reading."""
        self.reading.screenplay = Screenplay(format="fountain", text=self.text)
        self.reading.scenes[0].end = len(self.text)
        return self.reading
