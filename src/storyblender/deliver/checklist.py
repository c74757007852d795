"""The checklist: flaws that a director would mind, in plain words, each with the command that fixes it.

The critics record every flaw, down to a few hundredths of headroom. This module selects those worth showing and words
them; the rest stays in the trace.
"""

from __future__ import annotations

import csv
import re
import shlex
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from storyblender.deliver.panel import Panel, panels
from storyblender.deliver.shot_list import inert
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.shot_context import Flag, Flaw, ShotContext
from storyblender.memory.shot_sizes import SHOT_SIZES

CHECKLIST_FILE = "checklist.csv"
CAMERA: dict[str, tuple[float, str, str]] = {
    "inside": (0.0, "the camera stands inside {who}", "above"),
    "below_floor": (0.0, "the camera is below the floor", "above"),
    "empty": (0.0, "nobody is to be seen", "wider"),
    "out_of_frame": (3.0, "{who} is not in the picture", "wider"),
    "face_out": (3.0, "{whose} face is outside the picture", "wider"),
    "missing": (1.0, "{who} belongs in the picture too", "wider"),
    "beheaded": (1.5, "the frame cuts off {whose} head", "wider"),
    "hidden": (1.6, "{who} is mostly hidden", "above"),
    "face_hidden": (1.6, "something covers {whose} face", "above"),
    "face_away": (2.0, "{who} is seen from behind", "tighter"),
    "foreground": (1.0, "something large stands in front", "tighter"),
    "void": (2.4, "the picture looks past the end of the set", "tighter"),
    "line": (0.0, "the cut jumps over the line between the two", "wider"),
    "jump": (1.0, "the cut goes to almost the same picture", "tighter"),
    "eyeline": (1.0, "the two look past each other over the cut", "wider"),
}
"""Flaw kind of the camera critic: points of ten from which it is listed, the sentence, and the fix."""

STAGING: dict[str, tuple[float, str]] = {
    "missing": (0.0, "{message}"),
    "no_path": (0.0, "{who} finds no way there and stays"),
    "no_support": (0.0, "{message}"),
    "unreachable": (0.15, "{whose} hand does not reach what it should"),
    "crossing": (0.20, "{who} walks through another person"),
    "late": (0.50, "{who} does not get there before the cut"),
}
"""Flaw kind of the animator: metres from which it is listed, and the sentence."""

PLACED = ("by_hand", "mark")
"""Flaw kinds of what a person placed."""

READING: dict[str, str] = {
    "pronoun": "{who} is meant? {reason}",
    "addressee": "{who} is spoken to? {reason}",
    "prop": "a plain stand-in is shown: {reason}",
    "camera": "{reason}",
}
"""Topic that the Director was unsure of, and the sentence."""
FRAME_FIXES: dict[str, str] = {
    "person_missing": "wider", "people_missing": "wider", "face_out": "wider", "thing_missing": "wider",
    "nothing": "wider", "person_small": "tighter", "flat": "tighter", "void": "tighter", "dark": "tighter",
    "person_hidden": "above", "face_hidden": "above", "face_away": "above", "foreground": "above",
}  # fmt: skip
"""Flaw kind of the Frame Critic, and the fix."""


@dataclass(frozen=True)
class Check:
    """One item of the checklist.

    Attributes:
        shot: Shot name.
        says: A sentence with names in place of ids.
        mend: The command that fixes it, or what to change first.
    """

    shot: str
    says: str
    mend: str


def checklist(graph: ContinuityMemoryGraph, staged: Iterable[Flaw], poor: Iterable[Flaw], folder: str) -> list[Check]:
    """Return the checklist in story order, without duplicates.

    Args:
        graph: The story; its shots and cameras hold their own flaws.
        staged: Staging flaws that the engine found, of all scenes.
        poor: The Frame Critic's flaws in frames that do not show what their lines say.
        folder: The project folder, as written in a command.
    """
    names = names_of(graph)
    flaws: dict[str, list[Flaw]] = {}
    for flaw in staged:
        flaws.setdefault(flaw.shot, []).append(flaw)
    frame_flaws: dict[str, list[Flaw]] = {}
    for flaw in poor:
        frame_flaws.setdefault(flaw.shot, []).append(flaw)
    found: list[Check] = []
    modelled = {
        each.asset_id for each in graph.assets if each.canonical is not None and each.canonical.source == "file"
    }
    for panel in panels(graph):
        found += _reading_checks(panel, modelled, graph.script_name, names)
        staging = [*flaws.get(panel.name, []), *panel.shot.flaws]
        found += _staging_checks(panel, staging, graph.script_name, folder, names)
        found += _camera_checks(panel, folder, names)
        found += _frame_checks(panel, frame_flaws.get(panel.name, []), folder, names)
    return list(dict.fromkeys(found))


def write_checklist(checks: Iterable[Check], part: Path) -> None:
    """Write the checklist as CSV. UTF-8 with a byte order mark, so that spreadsheets read names rightly.

    Args:
        checks: In story order.
        part: The CSV file.
    """
    with part.open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("shot", "to_check", "mend"))
        writer.writerows([inert(value) for value in (check.shot, check.says, check.mend)] for check in checks)


def to_check(shot: ShotContext, names: Mapping[str, str]) -> tuple[str, ...]:
    """Return what a director would mind in a shot, one sentence each: of its staging, then of its picture.

    Args:
        shot: With what its staging and its camera were left with.
        names: Display names, from ``names_of``.
    """
    staging = (_worded(says, flaw, names) for flaw, says in _staging_flaws(shot.flaws))
    picture = (_worded(CAMERA[flaw.kind][1], flaw, names) for flaw in picture_flaws(shot))
    return tuple(dict.fromkeys((*staging, *picture)))


def _reading_checks(panel: Panel, modelled: Collection[str], script: str, names: Mapping[str, str]) -> Iterator[Check]:
    """Yield checks for what was read in doubt; a thing that the reader did not know and that has a model is in none."""
    for flag in panel.shot.flags:
        if flag.topic == "prop" and flag.choice in modelled:
            continue
        says = READING.get(flag.topic, "{reason}").format(who=_display_name(flag.choice, names), reason=flag.reason)
        yield Check(panel.name, _sentence(says), _script_mend(flag, script))


def _script_mend(flag: Flag, script: str) -> str:
    again = f"storyblender make {shlex.quote(script)}"
    if flag.topic == "prop":
        return f"{again} --models FOLDER_WITH_YOUR_MODEL"
    return f"say it in the script, then: {again}"


def _staging_checks(
    panel: Panel, flaws: Iterable[Flaw], script: str, folder: str, names: Mapping[str, str]
) -> Iterator[Check]:
    for flaw, says in _staging_flaws(flaws):
        mend = f"change it in story.blend, or reword the line, then: storyblender make {shlex.quote(script)}"
        if flaw.kind in PLACED:
            where = panel.name if flaw.kind == "mark" else panel.name.partition("_")[0]
            mend = f"storyblender place {shlex.quote(folder)} {where} {flaw.subject} --at X,Y"
        yield Check(panel.name, _worded(says, flaw, names), mend)


def _staging_flaws(flaws: Iterable[Flaw]) -> Iterator[tuple[Flaw, str]]:
    """Yield the staging flaws that a director would mind, each with its sentence."""
    for flaw in flaws:
        least, says = STAGING.get(flaw.kind, (0.0, "{message}"))
        if flaw.weight >= least:
            yield flaw, says


def picture_flaws(shot: ShotContext) -> list[Flaw]:
    """Return the camera flaws that a director would mind, only the worst for each person or thing."""
    size = shot.camera_instruction.size
    worst: dict[str, Flaw] = {}
    for flaw in shot.camera.residual if shot.camera else ():
        if flaw.kind not in CAMERA or flaw.weight < CAMERA[flaw.kind][0]:
            continue
        if flaw.kind == "face_away" and SHOT_SIZES.index(size) < SHOT_SIZES.index("MWS"):
            continue
        if flaw.subject not in worst or flaw.weight > worst[flaw.subject].weight:
            worst[flaw.subject] = flaw
    return list(worst.values())


def _camera_checks(panel: Panel, folder: str, names: Mapping[str, str]) -> Iterator[Check]:
    for flaw in picture_flaws(panel.shot):
        _, says, way = CAMERA[flaw.kind]
        command = f"storyblender edit {shlex.quote(folder)} {panel.name}"
        yield Check(panel.name, _worded(says, flaw, names), f"{command} {_reframed(way, panel)}")


def _frame_checks(panel: Panel, flaws: Iterable[Flaw], folder: str, names: Mapping[str, str]) -> Iterator[Check]:
    """Yield checks for what a frame fails to show, unless the camera checks name the same person or thing."""
    listed = {flaw.subject for flaw in picture_flaws(panel.shot)}
    for flaw in flaws:
        if flaw.kind in FRAME_FIXES and (flaw.subject not in listed or not flaw.subject):
            way = _reframed(FRAME_FIXES[flaw.kind], panel)
            command = f"storyblender edit {shlex.quote(folder)} {panel.name} {way}"
            yield Check(panel.name, _worded("{message}", flaw, names), command)


def _reframed(way: str, panel: Panel) -> str:
    """Return the command line option for a fix: the next wider or tighter size, or a high angle."""
    step = {"wider": -1, "tighter": 1}.get(way)
    at = SHOT_SIZES.index(panel.shot.camera_instruction.size)
    if step is None or not 0 <= at + step < len(SHOT_SIZES):
        return '--angle "high angle"'
    return f"--size {SHOT_SIZES[at + step]}"


def _worded(says: str, flaw: Flaw, names: Mapping[str, str]) -> str:
    who = _display_name(flaw.subject, names)
    whose = f"{who}'" if who.endswith("s") else f"{who}'s"
    return _sentence(says.format(who=who, whose=whose, message=plain(flaw.message, names)))


def _display_name(code: str, names: Mapping[str, str]) -> str:
    """Return the display name of an id; a part of the set is named by its id without the number."""
    return names.get(code) or f"the {re.sub(r'[_0-9]+', ' ', code).strip() or 'set'}"


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
