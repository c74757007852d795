"""A real Chromium on a real studio. They need the extra ``browser`` and Chromium; without them nothing is tested."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.e2e.conftest import SCRIPT, SMALL, made

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
collect_ignore_glob = [] if find_spec("playwright") and CHROMIUM else ["test_*.py"]

FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-component-update"]


@pytest.fixture(scope="session")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project as it was made; no test changes it."""
    folder = tmp_path_factory.mktemp("drawn")
    (folder / "two_cups.fountain").write_text(SCRIPT, encoding="utf-8")
    made([folder / "two_cups.fountain", "--out", folder / "two_cups.storyboard", "--no-animatic", *SMALL])
    return folder


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=60_000)  # Blender may be drawing on the same processor
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield browser
        browser.close()


class RunningStudio:
    """A studio in a process of its own.

    Attributes:
        folder: Of scripts and projects.
        address: With the key.
        library: Of the user that it runs as.

    Args:
        folder: Of scripts and projects.
        opens: What it is started with; the project in the folder if not given.
    """

    def __init__(self, folder: Path, opens: Path | None = None) -> None:
        self.folder, self.address = folder, ""
        self.library = Path(os.environ["STORYBLENDER_LIBRARY"])
        self._opens = opens or folder / "two_cups.storyboard"
        self._start()

    def _start(self, port: int = 0) -> None:
        command = [sys.executable, "-m", "storyblender", "studio", str(self._opens)]
        command += ["--no-browser", "--port", str(port)]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        assert self.process.stderr is not None
        for line in self.process.stderr:
            if found := re.search(r"http://\S+", line):
                self.address = found[0]
                return
        raise AssertionError("the studio did not start")

    def kill(self) -> None:
        """End it as a power cut would."""
        self.process.kill()
        self.process.wait()

    def restart(self) -> None:
        """Start it again after a kill."""
        self._start()


@pytest.fixture(scope="module")
def studio(drawn: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningStudio]:
    folder = tmp_path_factory.mktemp("studio") / "work"
    shutil.copytree(drawn, folder)
    running = RunningStudio(folder)
    yield running
    running.kill()


@pytest.fixture(scope="module")
def page(studio: RunningStudio, chromium: Browser) -> Iterator[Page]:
    """The studio's page with the board on it; a script error or a refused request fails its test module."""
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(studio.address)
    page.wait_for_selector(".card img", timeout=60_000)
    yield page
    page.close()
    assert not errors


@pytest.fixture(scope="module")
def stage(studio: RunningStudio, chromium: Browser) -> Iterator[Page]:
    """The stage of the first shot; a script error fails its test module."""
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(studio.address)
    page.locator('[data-shot="SC010_SH010"]').click()
    page.get_by_role("button", name="Stage", exact=True).click()
    page.wait_for_selector(".scrub", timeout=120_000)
    yield page
    page.close()
    assert not errors
