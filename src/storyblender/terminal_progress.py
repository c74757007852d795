"""How far a run has come: bars on a terminal, a line now and then in a log."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from rich.console import Console
from rich.markup import escape
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

if TYPE_CHECKING:
    from storyblender.trace import Event

_CONTROLS = {code: "\N{REPLACEMENT CHARACTER}" for code in (*range(32), *range(127, 160)) if chr(code) not in "\t\n"}
LABELS = {
    "ground": "Reading the script",
    "generate": "Having things made",
    "materialize": "Building people and props",
    "stage": "Laying out the scenes",
    "pack": "Building the scenes",
    "camera": "Setting the cameras",
    "frames": "Drawing the frames",
    "motion": "Shooting the animatic",
    "deliver": "Binding the board",
    "prints": "Printing the frames",
    "encode": "Encoding the film",
    "story": "Compiling the Blender files",
    "export": "Writing the scenes",
    "check": "Checking the scenes",
}
LINES, LEAST_STEPS = 50, 5
"""A log says of a stage how far it has come this many times at most, and never before so many steps more are done."""


class StageProgress:
    """Shows stages of a run.

    Args:
        console: Standard error.
        silent: Show nothing.
    """

    def __init__(self, console: Console, *, silent: bool) -> None:
        self._console = console
        self._bars = Progress(
            TextColumn("{task.description:28}"),
            BarColumn(bar_width=28),
            MofNCompleteColumn(),
            TimeElapsedColumn(),
            TimeRemainingColumn(),
            TextColumn("[dim]{task.fields[note]}"),
            console=console,
            disable=silent or not console.is_terminal,
        )
        self._tasks: dict[str, TaskID] = {}
        self._begun: dict[str, tuple[float, int]] = {}  # when a stage began, and the step that is told next

    def start(self) -> None:
        """Begin to show bars."""
        self._bars.start()

    def stop(self) -> None:
        """Leave the bars as they are, so that other text can follow."""
        self._bars.stop()

    def advance(self, event: Event) -> None:
        """Show how far a stage has come."""
        self._move_bar(event) if self._console.is_terminal else self._say_stage(event)

    def note(self, text: str) -> None:
        """Say beside the last bar what is being done."""
        if self._tasks:
            last = list(self._tasks.values())[-1]
            self._bars.update(last, note=plain(text[: max(20, self._console.width - 70)]))

    def _move_bar(self, event: Event) -> None:
        label = _label(event)
        if label not in self._tasks:
            self._tasks[label] = self._bars.add_task(plain(label), total=event.total, note="")
        task = self._tasks[label]
        self._bars.update(task, completed=event.step, total=event.total, note=plain(event.subject))

    def _say_stage(self, event: Event) -> None:
        """One line as a stage begins, one as it ends, and one now and then between."""
        label, step, total = _label(event), event.step or 0, event.total or 0
        note = f" ({event.subject})" if event.subject else ""
        period = max(LEAST_STEPS, -(-total // LINES))
        if label not in self._begun:
            self._begun[label] = monotonic(), step
            self._console.print(f"{label} ...", soft_wrap=True)
        then, told = self._begun[label]
        if step == total:
            del self._begun[label]
            self._console.print(f"{label}: {step} of {total}{plain(note)}", soft_wrap=True)
        elif step >= told + period:
            now = monotonic()
            self._begun[label] = now, step
            left = roughly((now - then) / (step - told) * (total - step))
            self._console.print(f"{label}: {step} of {total}{plain(note)}, {left} left", soft_wrap=True)


def _label(event: Event) -> str:
    """Return what a stage is called."""
    return event.message or LABELS.get(event.role, event.role)


def roughly(seconds: float) -> str:
    """Return a length of time as people say it: ``about 40 seconds``, ``about 3 hours 20 minutes``."""
    minutes, hours = round(seconds / 60), round(seconds / 60) // 60
    if minutes < 2:
        return f"about {max(1, round(seconds))} second{'s' * (round(seconds) > 1)}"
    if hours < 1:
        return f"about {minutes} minutes"
    return f"about {hours} hour{'s' * (hours > 1)} {minutes % 60} minutes"


def plain(text: str) -> str:
    """Return text for rich, in which nothing is markup and nothing steers the terminal."""
    return escape(text.translate(_CONTROLS))
