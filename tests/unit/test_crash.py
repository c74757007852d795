"""The power goes at any moment: writes that were not flushed are lost, renames that were not flushed come in any order.

A disk is watched while a project is worked on and stopped at every call in turn. From what was flushed by then, and a
random choice of what was not, the folder is made that is found after the crash: it opens at the last whole commit.
"""

from __future__ import annotations

import os
import random
import shutil
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.history import replace
from storyblender.project import Project


class PowerCut(BaseException):
    """Nothing that the process does from here on reaches the disk."""


@dataclass(eq=False)
class Node:
    """A file or folder.

    Attributes:
        flushed: Content that is on disk for sure; of a folder its names.
        waiting: Changes of a folder's names that are not, each all or nothing.
    """

    folder: bool
    flushed: Any = None
    waiting: list[list[tuple[str, Node | None]]] = field(default_factory=list)


class Disk:
    """Watches what is done to a folder, until the power goes.

    Args:
        top: The folder; it is on disk.
        calls: After so many calls the power goes.
    """

    def __init__(self, top: Path, calls: int) -> None:
        self.top, self.left, self.done = top, calls, 0
        self.nodes = {top: Node(True, {})}

    def watch(self, patches: pytest.MonkeyPatch) -> None:
        for name in ("open", "mkdir", "replace", "unlink", "rmdir", "fsync"):
            patches.setattr(os, name, self._watched(name, getattr(os, name)))

    def _watched(self, name: str, real: Any) -> Any:
        def call(first: Any, *rest: Any, **words: Any) -> Any:
            path = Path(f"/proc/self/fd/{first}").readlink() if isinstance(first, int) else Path(first)
            reads = name == "open" and not (rest and rest[0] & (os.O_WRONLY | os.O_RDWR))
            if reads or not path.is_relative_to(self.top):
                return real(first, *rest, **words)
            if self.done >= self.left:
                raise PowerCut
            self.done += 1
            result = real(first, *rest, **words)
            self._note(name, path, Path(rest[0]) if name == "replace" else path)
            return result

        return call

    def _note(self, name: str, path: Path, target: Path) -> None:
        parent = self.nodes[path.parent] if path != self.top else Node(True)
        if name in ("open", "mkdir") and path not in self.nodes:
            self.nodes[path] = node = Node(name == "mkdir", {} if name == "mkdir" else None)
            parent.waiting.append([(path.name, node)])
        elif name == "replace":
            assert path.parent == target.parent, "a rename stays in its folder"
            node = self.nodes[target] = self.nodes.pop(path)
            parent.waiting.append([(path.name, None), (target.name, node)])
        elif name in ("unlink", "rmdir"):
            del self.nodes[path]
            parent.waiting.append([(path.name, None)])
        elif name == "fsync":
            node = self.nodes[path]
            if node.folder:
                node.flushed = _names(node, lambda: True)
                node.waiting = []
            else:
                node.flushed = path.read_bytes()

    def crashed(self, out: Path, chance: random.Random) -> None:
        """Write what is found after the crash into a new folder."""
        live = {node: path for path, node in self.nodes.items()}
        self._restore(self.nodes[self.top], out, live, chance)

    def _restore(self, node: Node, out: Path, live: dict[Node, Path], chance: random.Random) -> None:
        if node.folder:
            out.mkdir()
            for name, below in _names(node, lambda: chance.random() < 0.5).items():
                self._restore(below, out / name, live, chance)
            return
        flushed = node.flushed or b""
        path = live.get(node)
        now = path.read_bytes() if path is not None and path.exists() else flushed
        kept = chance.randint(min(len(flushed), len(now)), len(now))
        lost = chance.choice((b"", b"\0" * (len(now) - kept)))
        out.write_bytes(flushed if now == flushed else now[:kept] + lost)


def _names(node: Node, happened: Any) -> dict[str, Node]:
    """Return the names in a folder after the changes that happened."""
    names = dict(node.flushed)
    for change in node.waiting:
        if happened():
            for name, below in change:
                names.pop(name, None) if below is None else names.update({name: below})
    return names


def names_in(project: Project) -> tuple[str, ...]:
    return tuple(asset.asset_id for asset in project.graph.assets)


def work(folder: Path, states: list[tuple[str, ...]]) -> None:
    """Commit, go back and forward, and write; ``states`` gets what stands after each step that has returned."""

    def add(project: Project, name: str) -> None:
        asset = Asset(asset_id=name, asset_type="object", description="")
        project.commit(replace(project.graph, asset), "director", name)

    states.append(())
    for round_ in ("a", "b"):
        with Project(folder) as project:
            states.append(names_in(project))
            project.outputs.write("build/frames/one.png", f"picture {round_}" * 100)
            for number in (1, 2, 3):
                add(project, f"{round_}{number}")
                states.append(names_in(project))
            for step in (-1, -1, 1):
                project.go_to(project.revision + step)
                states.append(names_in(project))
            add(project, f"{round_}4")
            states.append(names_in(project))
            project.outputs.write("build/frames/one.png", f"picture {round_} again" * 100)
        states.append(states[-1])


def cut_after(calls: int, folder: Path) -> tuple[Disk, list[tuple[str, ...]]]:
    folder.mkdir()
    disk, states = Disk(folder, calls), list[tuple[str, ...]]()
    with pytest.MonkeyPatch.context() as patches:
        disk.watch(patches)
        with suppress(PowerCut):
            work(folder / "p", states)
    return disk, states


def assert_every_crash_opens_at_a_whole_commit(folder: Path, step: int, images: int) -> None:
    _, every = cut_after(10**9, folder / "whole")
    total = cut_after(10**9, folder / "again")[0].done
    assert total > 100 and len(every) > 15
    pictures = {f"picture {word}" * 100 for word in ("a", "b", "a again", "b again")}
    for calls in range(0, total, step):
        place = folder / str(calls)
        disk, states = cut_after(calls, place)
        now = max(0, len(states) - 1)
        allowed = {every[now], every[min(now + 1, len(every) - 1)]}
        for number in range(images):
            found = folder / f"{calls}-{number}"
            disk.crashed(found, random.Random(1000 * calls + number))
            with Project(found / "p") as project:
                assert names_in(project) in allowed, (calls, number)
                if project.outputs.whole("build/frames/one.png"):
                    assert project.path("build/frames/one.png").read_text() in pictures
            shutil.rmtree(found)
        shutil.rmtree(place)


def test_after_a_crash_the_project_opens_at_a_whole_commit(tmp_path: Path) -> None:
    assert_every_crash_opens_at_a_whole_commit(tmp_path, 17, 3)


@pytest.mark.slow
@pytest.mark.timeout(1200)
def test_after_a_crash_at_any_call_the_project_opens_at_a_whole_commit(tmp_path: Path) -> None:
    assert_every_crash_opens_at_a_whole_commit(tmp_path, 1, 12)
