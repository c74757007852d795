"""``graph.json`` and ``history/`` on disk: read, checked against each other, rebuilt where a part is missing.

``graph.json`` is the graph at some revision, with a digest of its text. ``history/NNNNNN.json`` are the commits, each
with its digest and that of the one before. ``history/HEAD`` names the current revision and the digest of its commit.
The rule for all three: what is missing is rebuilt from what is whole; what is damaged is refused with what to do, and
never overwritten.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pydantic import ValidationError
from pydantic_core import from_json

from storyblender.catalog.liquids import liquid_named
from storyblender.catalog.motions import motion_called
from storyblender.errors import InputError
from storyblender.memory.gatekeeper import faults_of
from storyblender.memory.graph import SCHEMA_VERSION, ContinuityMemoryGraph
from storyblender.memory.history import Commit, apply, follows

GRAPH, HISTORY, HEAD = "graph.json", "history", "history/HEAD"
FROM_COPY = "restore it from a copy of the project, or make the storyboard anew in another folder (--out)"
_REBUILD_GRAPH = "delete this file and nothing else, and it is rebuilt from history/"
_REBUILD_HEAD = "delete this file and nothing else, and it is rebuilt from the commits beside it"
_REBUILD_BOTH = "delete this file and history/HEAD and nothing else, and both are rebuilt from history/"
_DIGEST_LINE = re.compile(rb'\A\{\n "digest": "([0-9a-f]{16})",\n')
_HEAD_LINE = re.compile(rb"\A(\d{1,9})(?: ([0-9a-f]{16}))?\s*\Z")
_COMMIT_NAME = re.compile(r"\A(\d{6,9})\.json\Z")

UPGRADES: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {
    1: lambda body: body | {"schema_version": 2},
    2: lambda body: body | {"schema_version": 3},
    3: lambda body: body | {"schema_version": 4},
    4: lambda body: body | {"schema_version": 5},
    5: lambda body: (
        body
        | {
            "schema_version": 6,
            "shots": _with_motion_keys(body["shots"]),
            "assets": [_with_liquid(asset) for asset in body["assets"]],
        }
    ),
    6: lambda body: body | {"schema_version": 7},
    7: lambda body: body | {"schema_version": 8},
}
"""From schema version n to n + 1; kept forever, so that every saved project opens. 2, 3, 4, 7 and 8 added fields only;
the fields that 5 and 6 took away are dropped by the models, in old commits too; 6 has keys of the motion catalogue
where earlier ones have words, and the liquids that words name; in old commits see ``read_commit``."""


@dataclass(frozen=True)
class Saved:
    """A project's state.

    Attributes:
        graph: At ``revision``.
        revision: Of the last commit that is in the graph; 0 before the first one.
        digest: Of that commit; empty where it is not known.
        notices: What a person should know about how it was found, one sentence each.
    """

    graph: ContinuityMemoryGraph = field(default_factory=ContinuityMemoryGraph)
    revision: int = 0
    digest: str = ""
    notices: tuple[str, ...] = ()


def commit_name(revision: int) -> str:
    """Return the name of a commit's file in the project folder."""
    return f"{HISTORY}/{revision:06d}.json"


def commit_revisions(folder: Path) -> list[int]:
    """Return the revisions that have a commit file, in order."""
    try:
        matches = [_COMMIT_NAME.match(path.name) for path in (folder / HISTORY).iterdir()]
    except FileNotFoundError:
        return []
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", mend=FROM_COPY, path=folder / HISTORY) from error
    return sorted(int(match[1]) for match in matches if match)


def head_text(revision: int, digest: str) -> str:
    """Return the content of ``history/HEAD``.

    Args:
        revision: The current one; 0 before the first commit.
        digest: Of its commit; empty where it is not known.
    """
    return f"{revision} {digest}".strip()


def _with_motion_keys(value: Any) -> Any:
    """Return stored data with the key of the motion catalogue for every word that an earlier schema has instead."""
    if isinstance(value, list):
        return [_with_motion_keys(each) for each in value]
    if not isinstance(value, dict):
        return value
    return {
        key: motion_called(each) or "idle"
        if key in ("motion", "activity") and each and isinstance(each, str)
        else _with_motion_keys(each)
        for key, each in value.items()
    }


def _with_liquid(asset: Any) -> Any:
    """Return the data of an asset with the liquid that its words name, where an earlier schema has the words only."""
    if not isinstance(asset, dict) or "kind" in asset or asset.get("asset_type") != "object":
        return asset  # one of schema 6 has a kind
    liquid = liquid_named(f"{asset.get('description')} {asset.get('name')}")
    return {"liquid": liquid, **asset} if liquid else asset


_UPGRADED_LAYERS: dict[str, Callable[[Any], Any]] = {"shots": _with_motion_keys, "assets": _with_liquid}


def graph_text(saved: Saved) -> str:
    """Return the content of ``graph.json``: the digest of the rest, then the rest."""
    body = {"revision": saved.revision, "commit": saved.digest, **saved.graph.model_dump(mode="json")}
    rest = json.dumps(body, indent=1, ensure_ascii=False).removeprefix("{\n")
    return f'{{\n "digest": "{_text_digest(rest.encode())}",\n{rest}'


def read_commit(folder: Path, revision: int) -> Commit:
    """Read one commit; the motions of one of an earlier schema become keys of the motion catalogue.

    Args:
        folder: The project folder.
        revision: Number of the commit, from 1.

    Raises:
        InputError: It is missing, damaged or another one.
    """
    path = folder / commit_name(revision)
    try:
        commit = Commit.model_validate(from_json(path.read_bytes(), allow_inf_nan=False))
    except FileNotFoundError as error:
        raise InputError("this part of the history is missing", mend=FROM_COPY, path=path) from error
    except (OSError, ValueError) as error:
        raise InputError("the history is damaged here", mend=FROM_COPY, path=path) from error
    if commit.revision != revision or not commit.intact:
        raise InputError("the history is damaged here: this is not what was written", mend=FROM_COPY, path=path)
    changes = tuple(
        each.model_copy(update={"before": upgrade(each.before), "after": upgrade(each.after)})
        if (upgrade := _UPGRADED_LAYERS.get(each.layer))
        else each
        for each in commit.changes
    )
    return commit.model_copy(update={"changes": changes})


def step(saved: Saved, commit: Commit, folder: Path, *, backwards: bool = False) -> Saved:
    """Return the state after a commit, or before it.

    Args:
        saved: The state before the commit; backwards, the one after it.
        commit: What changed.
        folder: The project folder, for the messages.
        backwards: Whether to take the commit back.

    Raises:
        InputError: The commit was not made on this state, or did not lead to it.
    """
    known = commit.digest if backwards else commit.parent
    try:
        fits = not known or not saved.digest or known == saved.digest
        if fits and follows(saved.graph, commit, backwards=backwards):
            graph = apply(saved.graph, commit, backwards=backwards)
            return Saved(graph, commit.revision - backwards, commit.parent if backwards else commit.digest)
    except ValueError as error:
        raise InputError("the history is damaged here", mend=FROM_COPY, path=folder / HISTORY) from error
    problem = f"graph.json and {commit_name(commit.revision)} do not belong together"
    raise InputError(problem, mend=FROM_COPY, path=folder)


def moved(saved: Saved, revision: int, folder: Path) -> Saved:
    """Return the state at a revision, forwards or backwards from another one.

    Args:
        saved: The state at any revision.
        revision: The one to go to; 0 is before the first commit.
        folder: The project folder, with the commits.

    Raises:
        InputError: A commit between them is missing or damaged, or does not belong to the state.
    """
    try:
        return _moved(saved, revision, folder)
    except InputError as error:
        if (folder / GRAPH).exists() and _replayed(folder, revision):
            problem = "does not belong to the history beside it"
            raise InputError(problem, mend=_REBUILD_GRAPH, path=folder / GRAPH) from error
        raise


def load(folder: Path) -> Saved:
    """Read a project's state without changing anything on disk.

    Raises:
        InputError: A part is damaged, or too much is missing; the sentence says what to do.
    """
    graph, head = _graph(folder), _head(folder)
    if isinstance(graph, _Damaged) or isinstance(head, _Damaged):
        raise _refusal(folder, graph, head)
    revisions = commit_revisions(folder)
    if head is None and graph is None and not revisions:
        return Saved()
    notices: list[str] = []
    start = graph or Saved()
    if start.revision and not revisions:
        notices.append("the commits in history/ are missing; what was done before cannot be undone")
    if head is None:
        revision, digest = _last_reached(folder, start.revision, revisions), ""
        if revision:  # a run that ended before its first commit has none
            notices.append(f"history/HEAD was missing; the project is at its last change, number {revision}")
    else:
        revision, digest = head
        _refuse_missing_end(folder, start.revision, revision, revisions)
    latest = max(revisions, default=0) if graph is None else start.revision
    if revision < latest:
        later = f"change {revision} of {latest}"
        notices.append(f"the project is at {later}; `storyblender redo` makes the later ones again")
    saved = moved(start, revision, folder)
    if head is not None and saved.digest and saved.digest != digest:
        if graph is not None and (other := _replayed(folder, revision)) and other.digest == digest:
            raise InputError("does not belong to the history beside it", mend=_REBUILD_GRAPH, path=folder / GRAPH)
        raise _refusal(folder, graph, _Damaged("the history is damaged here"))
    return Saved(saved.graph, revision, saved.digest or digest, tuple(notices))


def _moved(saved: Saved, revision: int, folder: Path) -> Saved:
    """Return the state at a revision, forwards or backwards from another one."""
    while saved.revision < revision:
        saved = step(saved, read_commit(folder, saved.revision + 1), folder)
    while saved.revision > revision:
        saved = step(saved, read_commit(folder, saved.revision), folder, backwards=True)
    return saved


def _replayed(folder: Path, revision: int | None, start: Saved | None = None) -> Saved | None:
    """Return the state at a revision, or at the last one, from the commits alone; None where that is not possible."""
    start = start or Saved()
    try:
        if revision is None:
            revision = _last_reached(folder, start.revision, commit_revisions(folder))
        return _moved(start, revision, folder)
    except InputError:
        return None


def _last_reached(folder: Path, start: int, revisions: list[int]) -> int:
    """Return the revision that the commits lead to, where ``history/HEAD`` does not say it."""
    last = start
    while last + 1 in revisions:
        last += 1
    if revisions and revisions[-1] > last:
        read_commit(folder, last + 1)  # says that it is missing
    return last


def _refuse_missing_end(folder: Path, start: int, revision: int, revisions: list[int]) -> None:
    """Refuse a current revision that no commit leads to; what is there can be gone on from."""
    last = max([start, *revisions])
    if revision > last:
        raise InputError(
            f"names change {revision}, and the last one here is {last}",
            mend=f"restore history/ from a copy of the project, or delete this file to go on from change {last}",
            path=folder / HEAD,
        )


@dataclass(frozen=True)
class _Damaged:
    """What a file that cannot be used is refused with."""

    problem: str
    mend: str = ""


def _refusal(folder: Path, graph: Saved | _Damaged | None, head: tuple[int, str] | _Damaged | None) -> InputError:
    """Return the refusal of a project with damaged files, with what to do; that it will do was tried."""
    wrong, path = (graph, folder / GRAPH) if isinstance(graph, _Damaged) else (head, folder / HEAD)
    assert isinstance(wrong, _Damaged), "only called for what is damaged"
    if wrong.mend:
        return InputError(wrong.problem, mend=wrong.mend, path=path)
    if isinstance(graph, _Damaged):
        revision = head[0] if isinstance(head, tuple) else None
        again, mend = _replayed(folder, revision), _REBUILD_BOTH if isinstance(head, _Damaged) else _REBUILD_GRAPH
    else:
        again, mend = _replayed(folder, None, graph), _REBUILD_HEAD
    return InputError(wrong.problem, mend=mend if again and again.revision else FROM_COPY, path=path)


def _head(folder: Path) -> tuple[int, str] | _Damaged | None:
    """Return the current revision and the digest of its commit; None where the file is missing."""
    try:
        match = _HEAD_LINE.match((folder / HEAD).read_bytes())
    except FileNotFoundError:
        return None
    except OSError as error:
        return _Damaged(f"cannot be read ({error.strerror})", FROM_COPY)
    return (int(match[1]), (match[2] or b"").decode()) if match else _Damaged("the history is damaged here")


def _graph(folder: Path) -> Saved | _Damaged | None:
    """Return what ``graph.json`` says; None where it is missing."""
    try:
        text = (folder / GRAPH).read_bytes()
        body = from_json(text, allow_inf_nan=False)
        version = int(body.get("schema_version", 0))
        if version > SCHEMA_VERSION:
            return _Damaged("was written by a newer StoryBlender", "update StoryBlender")
        digest = _DIGEST_LINE.match(text)
        if digest and body.pop("digest") != _text_digest(text[digest.end() :]):
            return _Damaged("was changed since StoryBlender wrote it")
        revision, commit = int(body.pop("revision", 0)), str(body.pop("commit", ""))
        while version < SCHEMA_VERSION:
            body = UPGRADES[version](body)
            version += 1
        graph = ContinuityMemoryGraph.model_validate(body)
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError) as error:
        return _Damaged(f"cannot be read as a project graph{_where(error)}")
    fault = next(faults_of(graph), None)
    return _Damaged(f"is no sound project graph: {fault}") if fault else Saved(graph, revision, commit)


def _where(error: Exception) -> str:
    """Return which field is wrong, where the file can be read so far."""
    if not isinstance(error, ValidationError):
        return ""
    fault = error.errors()[0]
    place = ".".join(str(part)[:40] for part in fault["loc"])
    return f" ({place}: {fault['msg'][:1].lower()}{fault['msg'][1:]})" if place else f" ({fault['msg']})"


def _text_digest(text: bytes) -> str:
    return hashlib.sha256(text).hexdigest()[:16]
