"""Edits made on an older revision: they are let in where nothing they touch has changed since."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from typing import Any, Final

from storyblender.errors import InputError, StaleEdit
from storyblender.history_files import commit_name, read_commit
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.history import PEOPLE, Change, Commit
from storyblender.project import Project

Aspect = tuple[str, str]
"""Name of an item and what of it: ``("SC010_SH020", "camera")``."""

FILM: Final = "film"
"""Name of the whole, where the order of scenes or the picture is edited."""
_VERSION: Final = re.compile(r"(\d{1,9})(?:\.([0-9a-f]{0,16}))?")
_FIELDS: Final[dict[str, dict[str, str]]] = {
    "shots": {
        "camera_instruction": "camera", "camera_decision": "camera", "take": "camera", "takes": "camera",
        "moment": "camera", "duration": "duration",
        "decided_duration": "duration", "notes": "notes", "approved": "approval", "omitted": "cut",
        "covers": "cut", "joined": "cut",
        "blocking_decision": "blocking", "blocking_takes": "blocking",
        "motion_by_hand": "blocking",
    },
    "scenes": {
        "layout": "layout", "layout_decision": "layout", "layout_takes": "layout",
        "lighting": "light", "light_decision": "light",
        "environment": "set", "set_decision": "set", "omitted": "cut", "shot_order": "cut",
    },
    "head": {"scene_order": "cut", "format_decision": "format"},
    "assets": {"look": "asset", "dimension": "asset", "canonical": "asset", "decision": "asset", "locked": "asset",
               "look_decision": "asset", "turned_down": "asset", "name": "name"},
}  # fmt: skip
"""Which field of an item is which aspect. What the crew derives from them, such as lamps or marks, is none."""
_DERIVED: Final = frozenset(("dimension", "canonical", "layout", "lighting", "environment"))
"""Fields that follow from the others when the crew works: what it makes is no conflict, what people decide is."""


def refuse_stale(project: Project, version: str, touched: Collection[Aspect]) -> None:
    """Refuse edits made on an older version if something they touch has changed since.

    Args:
        project: As it is now.
        version: What the edits were made on: ``Project.version`` as it was then, or its number alone.
        touched: What the edits touch.

    Raises:
        StaleEdit: With what changed, one sentence each.
        InputError: There never was such a version.
    """
    commits = list(_between(project, version))
    found = {name: commit for commit in commits for name in _concerned(commit, touched)}
    if found:
        said = dict.fromkeys(f"{commit.author}: {commit.reason}" for commit in found.values())
        raise StaleEdit(tuple(sorted({name for name, _ in found})), tuple(said))


def _between(project: Project, version: str) -> Iterator[Commit]:
    """Yield the commits between a version and now, in either direction: an undo goes back behind it."""
    match = _VERSION.fullmatch(version)
    if match is None:
        raise InputError(f"there is no revision {version!r}", mend=f"the project is at {project.version}")
    number, digest = int(match[1]), match[2] or ""
    if number > 0 and version != project.version:
        there = (project.folder / commit_name(number)).exists()
        if not there or not read_commit(project.folder, number).digest.startswith(digest):
            mend = "look at the project again, then edit it"
            raise InputError(f"revision {version} was undone, and something else was done since", mend=mend)
    first, last = sorted((number, project.revision))
    for revision in range(first + 1, last + 1):
        yield read_commit(project.folder, revision)


def _concerned(commit: Commit, touched: Collection[Aspect]) -> Iterator[Aspect]:
    """Yield what a commit changed of what is touched; another reading of the script changes everything."""
    if commit.author == "director":
        yield from touched
        return
    for change in commit.changes:
        yield from {each for each in _aspects(change, commit.author) if each in touched}


def _aspects(change: Change, author: str) -> Iterator[Aspect]:
    before, after = change.before or {}, change.after or {}
    name = _name(change)
    if change.layer == "head":
        yield from _painted_otherwise(before.get("paints", ()), after.get("paints", ()))
    for field, aspect in _FIELDS.get(change.layer, {}).items():
        derived = field in _DERIVED and author not in PEOPLE
        if before.get(field) != after.get(field) and not derived:
            yield name, aspect
    if change.layer in ("shots", "scenes"):
        for lock in {*before.get("locked", ())} ^ {*after.get("locked", ())}:
            yield name, str(lock)


def paint_aspect(material: str | None) -> str:
    """Return what is touched of a thing, a scene or the film whose material is painted."""
    return f"paint {material or ''}".rstrip()


def _painted_otherwise(before: Sequence[Any], after: Sequence[Any]) -> Iterator[Aspect]:
    for paint in (each for each in (*before, *after) if (each in before) != (each in after)):
        target = paint["target"]
        where = scene_name(target["scene_id"]) if target.get("scene_id") is not None else ""
        what = target.get("node_id") or target.get("asset_id")
        yield " ".join(filter(None, [where, what])) or FILM, paint_aspect(target.get("material"))


def _name(change: Change) -> str:
    match change.layer, change.key:
        case "shots", (int(scene_id), int(shot_id)):
            return shot_name(scene_id, shot_id)
        case "scenes", (int(scene_id),):
            return scene_name(scene_id)
        case _:
            return str(change.key[0]) if change.key else FILM
