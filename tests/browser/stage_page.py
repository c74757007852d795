"""Hands and eyes on the stage of the studio's page."""

from __future__ import annotations

import io
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from playwright.sync_api import Locator, Page, expect

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import read_project_graph
from tests.browser.conftest import RunningStudio

SHOT = "SC010_SH010"
LOADED = 120_000
"""Most milliseconds that a scene in 3D is waited for."""


def project_of(studio: RunningStudio) -> Path:
    return studio.folder / "two_cups.storyboard"


def graph_of(studio: RunningStudio) -> ContinuityMemoryGraph:
    return read_project_graph(project_of(studio))


def rested(studio: RunningStudio) -> ContinuityMemoryGraph:
    """Return the story once the crew has set what the edits before made stale."""
    for _ in range(120):
        graph = graph_of(studio)
        time.sleep(1)
        if graph == graph_of(studio) and all(shot.camera is not None for shot in graph.shots):
            return graph
    raise AssertionError("the crew does not come to rest")


def look(page: Page, view: str) -> np.ndarray:
    """Return the pixels of a view of the stage, once it is drawn and nothing changes any more."""
    page.get_by_role("button", name=view, exact=True).click()
    before = b""
    for _ in range(60):
        page.wait_for_timeout(200)
        now = page.locator(".frame canvas").screenshot()
        if now == before and not in_page(page, "return view.scene.drawing;"):
            return np.asarray(Image.open(io.BytesIO(now)).convert("RGB"), dtype=float)
        before = now
    raise AssertionError(f"the view {view} does not come to rest")


def in_page(page: Page, script: str, *values: Any) -> Any:
    return page.evaluate(
        f"([...values]) => {{ const view = document.querySelector('sb-stage'); {script} }}", list(values)
    )


@contextmanager
def shown_anew(page: Page) -> Iterator[None]:
    """Wait until the page shows the scene as it is after what is done inside."""
    in_page(page, "window.shownBefore = view.stage;")
    yield
    for _ in range(LOADED // 500):  # the page's policy forbids what wait_for_function does
        if in_page(page, "return view.stage !== window.shownBefore && !view.busy;"):
            return
        page.wait_for_timeout(500)
    raise AssertionError(f"the stage was not shown anew: {in_page(page, 'return [view.busy, view.why];')}")


def undo(page: Page) -> None:
    with shown_anew(page):
        page.get_by_role("button", name="Undo").click()
        expect(said(page)).to_contain_text("Undone")


def said(page: Page) -> Locator:
    return page.locator(".messages .bar")


def point_on(page: Page, node: str) -> tuple[float, float]:
    """Return where a thing is on the screen in the view that is shown, once nothing shifts any more."""
    before = (0.0, 0.0)
    for _ in range(60):
        x, y = in_page(page, "return view.scene.onScreen(values[0]);", node)
        box = page.locator(".frame canvas").bounding_box()
        assert box is not None
        here = (box["x"] + x * box["width"], box["y"] + y * box["height"])
        if here == before and not in_page(page, "return view.scene.drawing;"):
            return here
        before = here
        page.wait_for_timeout(250)
    raise AssertionError(f"{node} does not come to rest")


def drag(page: Page, node: str, by: tuple[int, int], *, cancel: bool = False) -> None:
    x, y = point_on(page, node)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + by[0], y + by[1], steps=4)
    if cancel:
        page.keyboard.press("Escape")
    page.mouse.up()
