"""What a person sees: progress on standard error, results on standard output; or JSON lines for a machine.

Progress is bars and scores on a terminal. Everywhere else it is plain lines: as a stage begins and ends and, where it
has many steps, in between, with an estimate of what is left.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from io import TextIOWrapper
from itertools import groupby
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from storyblender.terminal_progress import StageProgress, plain

if TYPE_CHECKING:
    from storyblender.agents.director.reader.reasons import Reason
    from storyblender.catalog.registry import Entry
    from storyblender.doctor import Finding
    from storyblender.edits.dispatcher import Applied
    from storyblender.edits.pulling import Pulled
    from storyblender.errors import StoryBlenderError
    from storyblender.inspection import Inspection
    from storyblender.language_crew import CheckedAnswer
    from storyblender.memory.base import Frozen
    from storyblender.memory.graph import ContinuityMemoryGraph
    from storyblender.memory.history import Commit
    from storyblender.pipeline.estimating import Expected
    from storyblender.pipeline.reviewing import FrameReview
    from storyblender.pipeline.script_changes import ScriptChanges
    from storyblender.pipeline.shot_reasons import ShotReasons
    from storyblender.trace import Event

PLAIN_WIDTH = 240
"""Columns of a table that goes to a file or a pipe: enough that nothing is cut."""

_WHERE = {"here": "on this machine", "fetched": "to download", "made": "to be made"}
_SOURCES = {"models": "your folder", "library": "your library", "built_in": "built in"}
"""Where an asset would come from, as a table says it; services have their names."""


class Terminal:
    """Shows events live. Use as a context manager.

    Args:
        quiet: Say nothing but errors.
        json_lines: Write every event and result as JSON, one a line, to standard output.
    """

    def __init__(self, *, quiet: bool, json_lines: bool) -> None:
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, TextIOWrapper):
                stream.reconfigure(
                    errors="backslashreplace"
                )  # a name never stops a run for a terminal that lacks letters
        self._json = json_lines
        silent = quiet or json_lines
        self._console = Console(stderr=True, quiet=silent, highlight=False, emoji=False)
        width = None if sys.stdout.isatty() else PLAIN_WIDTH
        self._results = Console(file=sys.stdout, quiet=silent, highlight=False, emoji=False, width=width)
        self._progress = StageProgress(self._console, silent=silent)

    def __enter__(self) -> Terminal:
        self._progress.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._progress.stop()

    def show(self, event: Event) -> None:
        """Show one event; a stage without work is passed over.

        Warnings begin with what they are about; the role that gave them is in the trace.
        """
        if self._json:
            self._write({"event": event.model_dump(mode="json", exclude_defaults=True)})
        role = event.role.replace("_", " ")
        if event.kind == "stage" and event.total:
            self._progress.advance(event)
        elif event.kind == "score" and event.details:
            note = f"{role} {event.subject} turn {event.turn}: {event.score:g}  {event.details[0]}"
            self._progress.note(note)
        elif event.kind in ("propose", "refine"):
            self._progress.note(f"{role} {event.subject} {event.kind}s {event.message}")
        elif event.kind == "follow":
            self._console.print(f"[yellow]also changed[/] {plain(f'{event.subject} {event.message}')}", soft_wrap=True)
        elif event.kind in ("handover", "reject", "warning") and event.message:
            text = f"{event.subject}: {event.message}" if event.subject else event.message
            self._console.print(f"[yellow]{event.kind}[/] {plain(text)}", soft_wrap=True)

    def files(self, folder: Path, names: Sequence[str], followed: Sequence[str] = ()) -> None:
        """Say where everything is.

        Args:
            folder: Where the files are.
            names: Relative to it.
            followed: Shots that changed in consequence of an edit; a person has heard of them as they did.
        """
        self._progress.stop()
        if self._json:
            told: dict[str, Any] = {"folder": str(folder), "files": list(names)}
            self._write(told | ({"followed": list(followed)} if followed else {}))
        self._results.print(f"[bold]{plain(str(folder))}[/]", soft_wrap=True)
        for name in names:
            self._results.print(f"  {plain(name)}")

    def commits(self, done: str, commits: Sequence[Commit]) -> None:
        """Say what was undone or redone, and that the pictures follow.

        Args:
            done: ``undone`` or ``redone``.
            commits: The change of a person, then what the crew did in consequence.
        """
        self._progress.stop()
        if self._json:
            self._write({done: [{"author": commit.author, "reason": commit.reason} for commit in commits]})
        draws = "`storyblender render` draws what this changes"
        self._results.print(f"[bold]{done}[/] {plain(commits[0].reason)}; {draws}", soft_wrap=True)

    def applied(self, applied: Applied) -> None:
        """Say what was changed, and which shots show something else now."""
        self._progress.stop()
        if self._json:
            told = {"edited": applied.words, "revision": applied.version, "stale": list(applied.stale)}
            self._write(told | ({"warnings": list(applied.warnings)} if applied.warnings else {}))
        self._results.print(f"[bold]done[/] {plain(applied.words)}", soft_wrap=True)
        for sentence in applied.warnings:
            self._results.print(f"[yellow]note[/] {plain(sentence)}", soft_wrap=True)

    def pulled(self, pulled: Pulled) -> None:
        """Print what was changed in Blender, and what became of it."""
        self._progress.stop()
        if self._json:
            self._write(pulled.model_dump(mode="json"))
        if not pulled.files and not pulled.conflicts:
            self._results.print("story.blend is as it was compiled.")
        elif not (pulled.understood or pulled.conflicts or pulled.kept):
            self._results.print("story.blend was saved, and nothing in it was changed.")
        done = "done" if pulled.applied is not None else "changed"
        rows = (
            (done, "bold", pulled.understood),
            ("conflict", "red", [f"{each.sentence} ({each.id})" for each in pulled.conflicts]),
            ("kept", "yellow", pulled.kept),
        )
        for label, style, sentences in rows:
            for sentence in sentences:
                self._results.print(f"[{style}]{label}[/] {plain(sentence)}", soft_wrap=True)

    def plan(self, graph: ContinuityMemoryGraph) -> None:
        """Print cast and shots."""
        if self._json:
            self._write({"graph": graph.model_dump(mode="json")})
        self._progress.stop()
        names = {asset.asset_id: asset.name or asset.asset_id for asset in graph.assets}
        cast = [names[asset.asset_id] for asset in graph.assets if asset.asset_type == "character"]
        self._results.print(f"[bold]Cast[/] {plain(', '.join(cast) or 'nobody')}")
        table = Table("scene", "shots", "heading", "on stage", box=None)
        for scene in graph.outline:
            shots = graph.shots_of(scene.scene_id)
            people = dict.fromkeys(names[person] for shot in shots for person in shot.on_stage)
            table.add_row(str(scene.scene_id), str(len(shots)), plain(scene.title), plain(", ".join(people)))
        self._results.print(table)

    def changes(self, changes: ScriptChanges) -> None:
        """Print what a revised script changes, shot by shot."""
        if self._json:
            self._write(changes.model_dump(mode="json"))
        self._progress.stop()
        table = Table("", "shot", "was", "words", box=None)
        for shot in changes.shots:
            former = shot.former if shot.former != shot.shot else ""
            table.add_row(shot.kind, shot.shot, former, plain(shot.words))
        self._results.print(table if changes.shots else "No shot changes.")
        for name, decided in changes.lost:
            self._results.print(f"[yellow]not kept[/] {name} {plain(decided)}: the words under it changed")
        counted = f"{len(changes.kept_scenes)} of {changes.scenes} scenes stay as they are staged"
        self._results.print(f"{counted}; {len(changes.renamed)} shots only get another number")

    def why(self, reasons: Sequence[Reason]) -> None:
        """Print which rule decided what, on which words, unit by unit."""
        self._progress.stop()
        if self._json:
            self._write({"why": [reason._asdict() for reason in reasons]})
        for unit, group in groupby(reasons, key=lambda reason: reason.unit):
            self._results.print(f"[bold]unit {unit}[/]")
            for each in group:
                row = f"{each.rule:32}  {each.kind:8}  {each.what}  “{each.words}”"
                self._results.print(f"  {plain(row)}", soft_wrap=True)

    def shot_reasons(self, reasons: ShotReasons) -> None:
        """Print why a shot is as it is: decisions of people, of roles, and the words they stand on."""
        self._progress.stop()
        if self._json:
            self._write(reasons.model_dump(mode="json"))
        for decided in reasons.decided:
            self._results.print(f"[bold]you decided[/] {plain(decided)}", soft_wrap=True)
        for clip in reasons.clips:
            self._results.print(f"[bold]a clip of yours[/] {plain(clip)}", soft_wrap=True)
        table = Table("role", "of", "by", "score", "turns", "what its critic said", box=None)
        for role in reasons.roles:
            score = "" if role.score is None else f"{role.score:.1f}"
            said = "; ".join((*role.remarks, *role.warnings)) or (
                "mended: " + "; ".join(role.fixes) if role.fixes else ""
            )
            table.add_row(role.role.replace("_", " "), role.subject, role.by, score, str(role.turns), plain(said))
        self._results.print(table)
        for number, line in enumerate(reasons.lines):
            self._results.print(f"[bold]“{plain(line)}”[/]", soft_wrap=True)
            for word in (each for each in reasons.words if each.line == number):
                read = f"“{line[word.start : word.end]}” read as {word.kind} {word.what} ({word.rule})"
                self._results.print(f"  {plain(read)}", soft_wrap=True)

    def listed(
        self, what: str, values: Sequence[Frozen], columns: Mapping[str, Callable[[Any], str]], none: str = ""
    ) -> None:
        """Print a list of values as a table with what each column reads of them; as JSON they are told whole.

        Args:
            what: Their name in JSON.
            values: In the order to print.
            columns: Heading to what it reads of a value.
            none: What is said where there is no value; empty for a table without rows.
        """
        self._progress.stop()
        if self._json:
            self._write({what: [value.model_dump(mode="json") for value in values]})
        if none and not values:
            self._results.print(plain(none), soft_wrap=True)
            return
        table = Table(*columns, box=None)
        for value in values:
            table.add_row(*(plain(read(value)) for read in columns.values()))
        self._results.print(table)

    def expected(self, found: Expected) -> None:
        """Print what the things of a story would be made from, what that takes in all, and what could not be asked."""
        self._progress.stop()
        assets = found.assets
        megabytes, dollars = sum(each.megabytes for each in assets), sum(each.dollars for each in assets)
        if self._json:
            told: dict[str, Any] = {
                "expected": [each.model_dump(mode="json", exclude_defaults=True) for each in assets],
                "megabytes": round(megabytes, 3),
                "dollars": round(dollars, 3),
                "most_dollars": found.most_dollars,
                "not_asked": [each.model_dump(mode="json") for each in found.not_asked],
            }
            self._write(told)
        table = Table("thing", "where", "from", "made from", "licence", "MB", "$", "", box=None)
        for each in assets:
            size, price = f"{each.megabytes:.1f}" * (each.megabytes > 0), f"{each.dollars:.2f}" * (each.dollars > 0)
            what = f"{each.what}, standing in" if each.stands_in else each.what
            source = _SOURCES.get(each.source, each.source)
            texts = (each.name, _WHERE[each.how], source, what, each.licence, size, price, each.note)
            table.add_row(*map(plain, texts))
        self._results.print(table)
        if any(each.source == "poly_haven" for each in assets):
            self._results.print("Powered by Poly Haven", soft_wrap=True)
        counts = {how: sum(each.how == how for each in assets) for how in ("fetched", "made", "here")}
        limit = f" (a run may spend ${found.most_dollars:.2f})" if found.most_dollars else ""
        said = f"{counts['fetched']} would be fetched, {megabytes:.1f} MB; {counts['made']} would be made, "
        said += f"${dollars:.2f} at most{limit}; {counts['here']} are on this machine"
        if stand_ins := sum(each.stands_in for each in assets):
            said += f"; {stand_ins} only stand in for what the script means"
        if found.not_asked:
            said += f"; not asked: {', '.join(f'{each.service} ({each.why})' for each in found.not_asked)}"
        self._results.print(plain(said), soft_wrap=True)

    def facts(self, what: str, values: Mapping[str, str]) -> None:
        """Print named facts, one a line."""
        self._progress.stop()
        if self._json:
            self._write({what: dict(values)})
        table = Table("", "", box=None, show_header=False)
        for name, value in values.items():
            table.add_row(plain(name), plain(value))
        self._results.print(table)

    def stagings(self, found: Mapping[int, str]) -> None:
        """Print the stagings that stand to choose, each with what is elsewhere in it."""
        self._progress.stop()
        if self._json:
            self._write({"stagings": [{"number": number, "moved": words} for number, words in found.items()]})
        for number, words in found.items():
            self._results.print(f"[bold]staging {number}[/] {plain(words)}", soft_wrap=True)
        if not found:
            self._results.print("no other staging without a fault was found", soft_wrap=True)

    def check(self, report: Inspection) -> None:
        """Print the result of a check."""
        self._progress.stop()
        if self._json:
            self._write(report.model_dump(mode="json"))
        table = Table("check", "value", "", box=None)
        for row in report.rows:
            table.add_row(row.name, row.value, "[green]ok[/]" if row.ok else "[red]see below[/]")
        self._results.print(table)
        for finding in report.findings:
            self._results.print(f"  [yellow]{plain(finding)}[/]", soft_wrap=True)

    def reviews(self, folder: Path, reviews: Sequence[FrameReview]) -> None:
        """Print what the Frame Critic found in the frames of a project.

        Args:
            folder: The project.
            reviews: One for each frame, in the order to print.
        """
        self._progress.stop()
        if self._json:
            self._write({"folder": str(folder), "frames": [review.model_dump(mode="json") for review in reviews]})
        colors = {"pass": "green", "fix": "yellow", "reject": "red"}
        table = Table("frame", "score", "", "what is wrong", box=None, title=plain(str(folder)), title_justify="left")
        for review in reviews:
            faults = "; ".join(fault.message for fault in review.faults)
            verdict = f"[{colors[review.verdict]}]{review.verdict}[/]"
            table.add_row(review.shot, f"{review.score:.1f}", verdict, plain(faults))
        self._results.print(table)
        passed = sum(review.verdict == "pass" for review in reviews)
        self._results.print(f"{passed} of {len(reviews)} frames pass")

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
            self._results.print(f"{mark} {finding.name:18} {plain(finding.says)}")
            if finding.mend:
                self._results.print(f"    [bold]{plain(finding.mend)}[/]")

    def answers(self, checked: Sequence[CheckedAnswer]) -> None:
        """Print which requests of the crew wait, and which answers are not of the form that was asked for."""
        self._progress.stop()
        for each in checked:
            if self._json:
                self._write({"name": each.name, "answered": each.answered, "problem": each.problem or None})
            state = "[red]wrong[/]" if each.problem else "[green]there[/]" if each.answered else "waits"
            self._results.print(f"{state:5} {plain(each.name)} {plain(each.problem)}".rstrip())
        waiting, wrong = sum(not each.answered for each in checked), sum(bool(each.problem) for each in checked)
        if not checked:
            self._results.print("nothing was asked in this folder; `storyblender make SCRIPT --crew ask:FOLDER` asks")
            return
        mend = f"; {wrong} must be mended" if wrong else "" if waiting else "; run the same `make` again to go on"
        self._results.print(f"{waiting} of {len(checked)} requests wait for an answer{mend}")

    def catalog(self, catalogs: Mapping[str, Sequence[Entry]]) -> None:
        """Print catalogues."""
        self._progress.stop()
        for kind, entries in catalogs.items():
            if self._json:
                self._write({"kind": kind, "keys": [entry.key for entry in entries]})
            table = Table(f"{kind} ({len(entries)})", "name", "also", box=None)
            for entry in entries:
                table.add_row(entry.key, plain(entry.name), plain(", ".join(entry.tags[:6])))
            self._results.print(table)

    def error(self, error: StoryBlenderError) -> None:
        """Print an error to standard error; as JSON to standard output too, where a machine listens."""
        if self._json:
            file = None if error.path is None else str(error.path)
            parts = {"problem": error.problem, "file": file, "line": error.line, "mend": error.mend or None}
            self._write({"error": str(error), **parts})
        Console(stderr=True, highlight=False, emoji=False).print(
            f"[red]storyblender:[/] {plain(str(error))}", soft_wrap=True
        )

    def _write(self, value: object) -> None:
        sys.stdout.write(json.dumps(value, ensure_ascii=False) + "\n")
        sys.stdout.flush()
