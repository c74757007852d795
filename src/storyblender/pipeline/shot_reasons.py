"""Why a shot is as it is: who decided what of it, how that was judged, and which words of the script it stands on."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from pydantic import ValidationError

from storyblender.agents.director.reader.reasons import Reason, reasons_of
from storyblender.agents.director.rules import Ledger, using_ledger
from storyblender.memory.base import Frozen, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import ShotOutline
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.run import Run
from storyblender.project import TRACE
from storyblender.screenplay.source import load
from storyblender.trace import DecidedBy, Event


class RoleReason(Frozen):
    """What one role decided, the last time that it did."""

    role: str
    """Such as ``camera_operator``."""
    subject: str
    """The shot, or its scene."""
    by: DecidedBy = "rules"
    """Who played the role."""
    score: float | None = None
    """Of its critic, 1 to 10."""
    turns: int = 0
    """How often it was refined."""
    remarks: tuple[str, ...] = ()
    """What the critic still minded at the end."""
    fixes: tuple[str, ...] = ()
    """What was mended on the way, and by which numbers."""
    warnings: tuple[str, ...] = ()
    """What the role could not do as the script says it."""


class WordsRead(Frozen):
    """Words of the script, and what a rule took from them."""

    line: int
    """Number of the shot's line that they are in, from 0."""
    start: int
    """First character within the line."""
    end: int
    """After the last one."""
    kind: str
    """``deed``, ``thing``, ``look`` ..."""
    what: str
    """What was taken from them, with ids of people and things."""
    rule: str
    """Which rule decided."""


class ShotReasons(Frozen):
    """Why a shot is as it is."""

    shot: str
    """Its name."""
    decided: tuple[str, ...]
    """What a person decided of it; stronger than any role."""
    roles: tuple[RoleReason, ...]
    """In the order in which they decided: of the scene first, then of the shot."""
    lines: tuple[str, ...]
    """Its lines of the script, verbatim."""
    words: tuple[WordsRead, ...]
    """What the rules took from these lines; nothing where a model or a person read the script."""
    clips: tuple[str, ...] = ()
    """Which motions of the user's own are played, and why those."""


def shot_reasons(run: Run, shot: ShotContext) -> ShotReasons:
    """Return why a shot is as it is.

    Args:
        run: On the project; nothing is asked of a model.
        shot: Of its graph.
    """
    name, graph = shot_name(shot.scene_id, shot.shot_id), run.graph
    names = names_of(graph)
    outline = _outline_of(graph, shot)
    scene = graph.scene(shot.scene_id)
    decisions = {
        "camera": shot.camera_decision, "marks": shot.blocking_decision, "light": scene.light_decision,
        "set": scene.set_decision, "layout": scene.layout_decision,
    }  # fmt: skip
    return ShotReasons(
        shot=name,
        decided=(
            *(f"{part}: {plain(each.words, names)}" for part, each in decisions.items() if each is not None),
            *([f"animated by hand: {plain(', '.join(shot.motion_by_hand), names)}"] if shot.motion_by_hand else ()),
        ),
        roles=tuple(
            _in_words(each, names)
            for each in role_reasons(_events(run.project.path(TRACE)), (scene_name(shot.scene_id), name))
        ),
        lines=tuple(line.text for line in outline.lines),
        words=tuple(_words_of(outline, _rules_read(run))),
        clips=tuple(plain(each, names) for each in _clips_of(shot)),
    )


def _clips_of(shot: ShotContext) -> Iterator[str]:
    """Yield which clips the script's actions are played by; those that a person asked for are decisions."""
    for action in shot.character_actions:
        if (clip := action.mocap) is not None:
            moves = f"{action.asset_id} {action.action_description}"
            yield f"{moves} as in {clip.provenance.file}: {clip.reason}"


def _in_words(reason: RoleReason, names: Mapping[str, str]) -> RoleReason:
    """Return a reason as people read it: the trace has ids."""
    said = ("remarks", "fixes", "warnings")
    return reason.model_copy(
        update={field: tuple(plain(each, names) for each in getattr(reason, field)) for field in said}
    )


def role_reasons(events: Iterable[Event], subjects: tuple[str, ...]) -> list[RoleReason]:
    """Return the last decision of every role on some subjects, by subject and then in the order of their beginning.

    Args:
        events: Of the trace, in order.
        subjects: Scenes and shots, as the trace names them.
    """
    found: dict[tuple[str, str], RoleReason] = {}
    for event in events:
        key = event.subject, event.role
        if event.subject not in subjects:
            continue
        if event.kind == "propose" and event.draft:
            found[key] = RoleReason(role=event.role, subject=event.subject)
        elif key in found:
            found[key] = found[key].model_copy(update=_said(found[key], event))
    return sorted(found.values(), key=lambda reason: subjects.index(reason.subject))


def _said(reason: RoleReason, event: Event) -> dict[str, object]:
    """Return what an event adds to a reason."""
    if event.kind == "score":
        return {"score": event.score, "remarks": event.details}
    if event.kind == "refine":
        return {"fixes": (*reason.fixes, *event.details)}
    if event.kind == "accept":
        return {"turns": event.turn, "by": event.by or reason.by}
    return {"warnings": (*reason.warnings, event.message)} if event.kind == "warning" else {}


def _events(trace: Path) -> Iterator[Event]:
    """Yield the events of a trace; a line that a killed run left unfinished is none."""
    if not trace.is_file():
        return
    with trace.open(encoding="utf-8") as lines:
        for line in lines:
            try:
                yield Event.model_validate(json.loads(line))
            except (json.JSONDecodeError, ValidationError):
                continue


def _outline_of(graph: ContinuityMemoryGraph, shot: ShotContext) -> ShotOutline:
    """Return the lines of a shot; one that a person added has none of its own."""
    scene = next(each for each in graph.outline if each.scene_id == shot.scene_id)
    found = (each for each in scene.shots if each.shot_id == shot.shot_id)
    return next(found, ShotOutline(shot_id=shot.shot_id))


def _rules_read(run: Run) -> list[Reason]:
    """Return what the rules take from the project's script; nothing where a model or a person may have read it."""
    director, script = run.crew.director, run.project.path(f"script{Path(run.graph.script_name).suffix}")
    *models, rules = director.policies
    if models or not script.is_file():
        return []
    with using_ledger(Ledger()) as ledger:
        return reasons_of(rules.propose(director.project(load(script))), ledger)


def _words_of(outline: ShotOutline, reasons: Iterable[Reason]) -> Iterator[WordsRead]:
    """Yield the reasons that stand in the lines of a shot, with their place in the line."""
    for reason in reasons:
        for number, line in enumerate(outline.lines):
            if not reason.words or not line.span.start <= reason.start < line.span.end:
                continue
            at = line.text.find(reason.words)
            if at >= 0:
                yield WordsRead(
                    line=number, start=at, end=at + len(reason.words),
                    kind=reason.kind, what=reason.what, rule=reason.rule,
                )  # fmt: skip
