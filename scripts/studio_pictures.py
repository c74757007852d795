"""Takes the pictures of docs/studio.md: every view of the studio, in a real browser, on a copy of a finished project.

Usage: python scripts/studio_pictures.py out/casablanca.storyboard examples/casablanca.fountain docs/pictures
It needs the extra ``browser`` and Chromium on the path.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import FilePayload, Page, sync_playwright

SIZE = {"width": 1280, "height": 800}
QUALITY = 72
"""Of the JPEGs."""
FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader"]
SOON, DRAWN = 2_500, 240_000
"""Milliseconds that a view takes to settle, and that Blender takes at most."""


@contextmanager
def studio(place: Path) -> Iterator[str]:
    """Run a studio and give its address."""
    command = [sys.executable, "-m", "storyblender", "studio", str(place), "--no-browser"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    try:
        yield next(found[0] for line in process.stderr if (found := re.search(r"http://\S+", line)))
    finally:
        process.terminate()
        process.wait()


def go_to(page: Page, view: str) -> None:
    """Show a view."""
    page.get_by_role("button", name=view, exact=True).click()


def views(page: Page) -> Iterator[str]:
    """Go from view to view; yield the name of each picture when it can be taken."""
    page.locator(".card").nth(2).click()
    page.wait_for_selector(".inspector fieldset")
    yield "studio_board"
    page.get_by_text("Why is it like this?").click()
    page.locator(".why table").scroll_into_view_if_needed()
    yield "studio_why"
    page.locator(".inspector > .head").scroll_into_view_if_needed()
    go_to(page, "Stage")
    page.wait_for_selector(".frame canvas", timeout=DRAWN)
    page.wait_for_selector(".stage .wait", state="detached", timeout=DRAWN)
    yield "studio_stage"
    go_to(page, "From above")
    yield "studio_plan"
    go_to(page, "Cast and assets")
    page.wait_for_selector(".assets canvas", timeout=DRAWN)
    page.wait_for_selector(".person", timeout=DRAWN)
    for _ in range(DRAWN // SOON):  # portraits are drawn one by one
        if page.locator(".person").evaluate_all("all => all.every((each) => each.querySelector('img')?.naturalWidth)"):
            break
        page.wait_for_timeout(SOON)
    yield "studio_cast"
    go_to(page, "Set and light")
    page.wait_for_selector(".lamps")
    yield "studio_set"
    go_to(page, "Cut")
    page.wait_for_selector(".shots .bar")
    yield "studio_cut"
    go_to(page, "Deliver")
    page.wait_for_selector(".printed .frame img")
    yield "studio_deliver"


def revised(page: Page, script: str) -> None:
    """Show what a revised script would change."""
    go_to(page, "Revised script")
    longer = script.replace("Play the old one, Sam.", "Play it, Sam. Play the old one.")
    script_file: FilePayload = {"name": "casablanca.fountain", "mimeType": "text/plain", "buffer": longer.encode()}
    page.set_input_files(".revise input[type=file]", script_file)
    page.wait_for_selector(".revise table", timeout=DRAWN)


def first_scene(script: str) -> FilePayload:
    """Return the first scene of a script as a file, which is made sooner than the whole."""
    begins = [found.start() for found in re.finditer(r"^(INT|EXT)\.", script, re.MULTILINE)]
    return {"name": "first_scene.fountain", "mimeType": "text/plain", "buffer": script[: begins[1]].encode()}


def take(page: Page, out: Path, name: str) -> None:
    """Take a picture of what the page shows."""
    page.wait_for_timeout(SOON)
    page.screenshot(path=out / f"{name}.jpg", type="jpeg", quality=QUALITY)


def main(project: Path, script: Path, out: Path) -> None:
    """Take all pictures."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as play:
        browser = play.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        page = browser.new_page(viewport=SIZE)
        page.set_default_timeout(DRAWN)
        copy = Path(shutil.copytree(project, Path(name) / "film" / project.name))
        with studio(copy) as address:
            page.goto(address)
            page.wait_for_selector(".card img")
            for view in views(page):
                take(page, out, view)
            revised(page, script.read_text(encoding="utf-8"))
            take(page, out, "studio_revise")
        empty = Path(name) / "new"
        empty.mkdir()
        with studio(empty) as address:
            page.goto(address)
            page.wait_for_selector(".drop")
            page.set_input_files(".drop input", first_scene(script.read_text(encoding="utf-8")))
            page.select_option(".ready select", "fast")
            take(page, out, "studio_start")
            page.get_by_role("button", name="Start", exact=True).click()
            page.wait_for_selector(".crew figure:nth-of-type(2) img", timeout=4 * DRAWN)
            take(page, out, "studio_crew")
        browser.close()


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:4]))
