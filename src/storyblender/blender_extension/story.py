"""What the extension knows of the story, and how it hears of it. The file in Blender holds nothing of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy

from .connection import Program, Studio, reach
from .preferences import program
from .shots_in_file import project_of, shots
from .work import WORK


class Story:
    """The story of the open file.

    Attributes:
        project: Its folder; None for a file of no project.
        link: ``studio`` or ``alone``, as it was last reached; empty before.
        board: As the program told it last; empty before.
        told: What became of the last thing that was done, one sentence each.
        problem: Why it was not done, in a sentence; empty if it was.
    """

    def __init__(self) -> None:
        self.project: Path | None = None
        self.link = ""
        self.board: dict[str, Any] = {}
        self.told: list[str] = []
        self.problem = ""
        self._details: dict[str, dict[str, Any]] = {}
        self._cards: dict[str, dict[str, Any]] = {}
        self._written: int | None = None

    @property
    def revision(self) -> str:
        """What the person sees; edits name it."""
        return self.board.get("revision", "")

    def card(self, name: str) -> dict[str, Any]:
        """Return what the board shows of a shot; empty if it is not known."""
        return self._cards.get(name, {})

    def details(self, name: str) -> dict[str, Any]:
        """Return all that is known of a shot; empty if nothing is."""
        return self._details.get(name, {})

    def picture(self, name: str) -> Path | None:
        """Return the frame of a shot, if it is drawn."""
        path = self.project / "frames" / f"{name}.png" if self.project is not None and name else None
        return path if path is not None and path.is_file() else None

    @property
    def is_rewritten(self) -> bool:
        """Whether the file was written anew since it was opened or saved here."""
        return self._written is not None and _written(bpy.data.filepath) not in (self._written, None)

    def opened(self) -> None:
        """Begin with the file that was opened."""
        self.project, self.link, self.board = project_of(bpy.data.filepath), "", {}
        self.told, self.problem = [], ""
        self._details, self._cards = {}, {}
        self.saved()
        self._list()

    def saved(self) -> None:
        """Note when the file was written that is shown here."""
        self._written = _written(bpy.data.filepath)

    def ask(self, what: str, call: Callable[[Studio | Program], Any], then: Callable[[Any], None]) -> None:
        """Ask the program for something, and hear of the story after it.

        Args:
            what: What it is, in words; empty for what the person does not wait for.
            call: Made with the program, beside Blender.
            then: Hears what it returned, and may use Blender.
        """
        project, path, seen = self.project, program(), self.revision
        if project is None:
            self.problem = "this file is in no StoryBlender project: open its story.blend"
            return
        if what:
            self.problem, self.told = "", []

        def made() -> tuple[Any, str, dict[str, Any]]:
            link = reach(project, path)
            return call(link), link.words, link.story(seen)

        def hear(answer: tuple[Any, str, dict[str, Any]]) -> None:
            if self.project == project:  # the person may have opened another file meanwhile
                result, self.link, told = answer
                self._take(told)
                then(result)

        def fail(problem: str) -> None:
            if what:
                self.problem = problem
            else:
                self.link = ""  # the studio was ended

        WORK.begin(what, made, hear, fail)

    def refresh(self, what: str = "") -> None:
        """Hear of the story."""
        self.ask(what, lambda link: None, lambda _: None)

    def _take(self, told: dict[str, Any]) -> None:
        self.board = told["board"]
        self._cards = {card["shot"]: card for scene in self.board["scenes"] for card in scene["shots"]}
        self._details |= {shot["shot"]: shot for shot in told["shots"]}
        self._list()

    def choose(self, name: str) -> None:
        """Look at a shot; at the first one if the story has it no more."""
        listed = bpy.context.window_manager.storyblender
        names = [row.name for row in listed.shots]
        listed.active = names.index(name) if name in names else 0

    def _list(self) -> None:
        """Fill the list of the panel: with the shots that the program told; before, with those of the file."""
        names = list(self._cards) or [shot.name for shot in shots()]
        listed = bpy.context.window_manager.storyblender
        chosen = listed.chosen
        if [row.name for row in listed.shots] != names:
            listed.shots.clear()
            for name in names:
                listed.shots.add().name = name
        self.choose(chosen)


def _written(path: str) -> int | None:
    try:
        return Path(path).stat().st_mtime_ns if path else None
    except OSError:
        return None


STORY = Story()
"""Of the file that is open."""
