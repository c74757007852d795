"""What a person sees while the crew works: progress bars, scores, tables; or JSON lines for a machine."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType

from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TaskID, TextColumn, TimeElapsedColumn
from rich.table import Table

from storyblender.catalog.registry import Entry
from storyblender.doctor import Finding
from storyblender.inspection import Inspection
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.trace import Event

LABELS = {
    "ground": "Reading the script",
    "materialize": "Building people and props",
    "stage": "Laying out the scenes",
    "camera": "Setting the cameras",
    "frames": "Drawing the frames",
    "motion": "Shooting the animatic",
    "deliver": "Binding the board",
}


class Terminal:
    """Shows events live. Use as a context manager.

    Args:
        quiet: Say nothing but errors.
        json_lines: Write every event and result as JSON, one a line, to standard output.
    """

    def __init__(self, *, quiet: bool, json_lines: bool) -> None:
        self._quiet, self._json = quiet or json_lines, json_lines
        self._console = Console(stderr=True, quiet=self._quiet, highlight=False)
        self._progress = Progress(
            TextColumn("{task.description:28}"),
            BarColumn(bar_width=28),
            MofNCompleteColumn(),
            TimeElapsedColumn(),
            TextColumn("[dim]{task.fields[note]}"),
            console=self._console,
            disable=self._quiet,
        )
        self._tasks: dict[str, TaskID] = {}

    def __enter__(self) -> Terminal:
        self._progress.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._progress.stop()

    def show(self, event: Event) -> None:
        """Show one event."""
        if self._json:
            self._write({"event": event.model_dump(mode="json", exclude_defaults=True)})
        if event.kind == "stage" and event.total is not None:
            self._advance(event)
        elif event.kind == "score" and event.details:
            note = f"{event.role} {event.subject} turn {event.turn}: {event.score:g}  {event.details[0]}"
            self._note(note)
        elif event.kind in ("handover", "reject", "warning"):
            self._progress.print(f"[yellow]{event.kind}[/] {escape(f'{event.role} {event.subject} {event.message}')}")

    def files(self, folder: Path, names: Sequence[str]) -> None:
        """Say where everything is."""
        self._progress.stop()
        if self._json:
            self._write({"folder": str(folder), "files": list(names)})
        self._console.print(f"\n[bold]{escape(str(folder))}[/]")
        for name in names:
            self._console.print(f"  {escape(name)}")

    def plan(self, graph: ContinuityMemoryGraph) -> None:
        """Print cast and shots."""
        if self._json:
            self._write({"graph": graph.model_dump(mode="json")})
        self._progress.stop()
        cast = [asset.name or asset.asset_id for asset in graph.assets if asset.asset_type == "character"]
        self._console.print(f"[bold]Cast[/] {escape(', '.join(cast))}")
        table = Table("scene", "shots", "heading", "on stage", box=None)
        for scene in graph.outline:
            shots = graph.shots_of(scene.scene_id)
            people = dict.fromkeys(person for shot in shots for person in shot.on_stage)
            table.add_row(str(scene.scene_id), str(len(shots)), escape(scene.heading), escape(", ".join(people)))
        self._console.print(table)

    def check(self, report: Inspection) -> None:
        """Print the result of a check."""
        self._progress.stop()
        if self._json:
            self._write(report.model_dump(mode="json"))
        table = Table("check", "value", "", box=None)
        for row in report.rows:
            table.add_row(row.name, row.value, "[green]ok[/]" if row.ok else "[red]look[/]")
        self._console.print(table)
        for finding in report.findings:
            self._console.print(f"  [yellow]{escape(finding)}[/]")

    def findings(self, findings: Sequence[Finding]) -> None:
        """Print what the doctor found."""
        self._progress.stop()
        for finding in findings:
            if self._json:
                self._write(
                    {
                        "name": finding.name,
                        "healthy": finding.healthy,
                        "says": finding.says,
                        "mend": finding.mend,
                    }
                )
            mark = "[green]ok [/]" if finding.healthy else "[red]bad[/]"
            self._console.print(f"{mark} {finding.name:18} {escape(finding.says)}")
            if finding.mend:
                self._console.print(f"    [bold]{escape(finding.mend)}[/]")

    def catalog(self, catalogs: Mapping[str, Sequence[Entry]]) -> None:
        """Print catalogues."""
        self._progress.stop()
        for kind, entries in catalogs.items():
            if self._json:
                self._write({"kind": kind, "keys": [entry.key for entry in entries]})
            table = Table(f"{kind} ({len(entries)})", "name", "also", box=None)
            for entry in entries:
                table.add_row(entry.key, escape(entry.name), escape(", ".join(entry.tags[:6])))
            self._console.print(table)

    def error(self, message: str) -> None:
        """Print an error to standard error."""
        Console(stderr=True, highlight=False).print(f"[red]storyblender:[/] {escape(message)}", soft_wrap=True)

    def _advance(self, event: Event) -> None:
        if event.role not in self._tasks:
            label = LABELS.get(event.role, event.role)
            self._tasks[event.role] = self._progress.add_task(label, total=event.total, note="")
        note = event.subject or event.message
        self._progress.update(self._tasks[event.role], completed=event.step, total=event.total, note=escape(note))

    def _note(self, text: str) -> None:
        if self._tasks:
            last = list(self._tasks.values())[-1]
            self._progress.update(last, note=escape(text[: max(20, self._console.width - 70)]))

    def _write(self, value: object) -> None:
        sys.stdout.write(json.dumps(value, ensure_ascii=False) + "\n")
        sys.stdout.flush()
