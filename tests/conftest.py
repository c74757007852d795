"""Which process runs which test, and the clean end of a process that used Blender."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

MADE_ONCE = {"test_make.py", "test_resume.py", "test_story_blend.py", "test_undo.py"}
"""Files of ``tests/e2e`` that look at the same made project."""


class FileByFile(LoadScopeScheduling):
    """A file stays on one process, in order: Blender is one global state, and what a module makes is made once.

    The files come as they are collected: those that take long, ``blender`` and ``e2e``, before the unit tests, which
    fill the end evenly.
    """

    def _split_scope(self, nodeid: str) -> str:
        """Return what is run on one process together: the file, or the files that share a made project."""
        file = nodeid.partition("::")[0]
        return "the made project" if Path(file).name in MADE_ONCE else file


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> FileByFile:
    config.option.loadscopereorder = False
    return FileByFile(config, log)


LIBRARY = pytest.StashKey[str]()
"""The library of what is made once for several files of tests, in a folder of this process."""


def pytest_configure(config: pytest.Config) -> None:
    config.stash[LIBRARY] = os.environ["STORYBLENDER_LIBRARY"] = tempfile.mkdtemp(prefix="storyblender-tests-")


@pytest.fixture(scope="module", autouse=True)
def _library_of_a_file(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Give what a file of tests makes once a library of its own: geometry of a stand-in engine is not Blender's."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("STORYBLENDER_LIBRARY", str(tmp_path_factory.getbasetemp() / f"library-{os.urandom(6).hex()}"))
        yield


@pytest.fixture(autouse=True)
def _own_library(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Give each test a library of its own, which is not there yet; never that of the user."""
    monkeypatch.setenv("STORYBLENDER_LIBRARY", str(tmp_path_factory.getbasetemp() / f"library-{os.urandom(6).hex()}"))


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Bpy hangs at interpreter exit after some uses: end the process once the report is out."""
    shutil.rmtree(config.stash[LIBRARY], ignore_errors=True)
    if "bpy" in sys.modules and not hasattr(config, "workerinput"):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(getattr(config, "storyblender_exit", 0))


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    session.config.storyblender_exit = int(exitstatus)  # type: ignore[attr-defined]
