"""From a script to the board in a real browser: what cannot be read, the crew at work, stop and go on."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import RunningStudio
from tests.e2e.conftest import SCRIPT

MADE = 400_000
"""Most milliseconds that a storyboard is waited for."""


@pytest.fixture(scope="module")
def empty(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningStudio]:
    """A studio on a folder with nothing in it."""
    folder = tmp_path_factory.mktemp("empty")
    running = RunningStudio(folder, opens=folder)
    yield running
    running.kill()


@pytest.fixture(scope="module")
def start(empty: RunningStudio, chromium: Browser) -> Iterator[Page]:
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.goto(empty.address)
    page.wait_for_selector(".drop")
    yield page
    page.close()


def drop(page: Page, name: str, words: str) -> None:
    page.set_input_files(".drop input", {"name": name, "mimeType": "text/plain", "buffer": words.encode()})


def begin(page: Page, name: str, words: str) -> None:
    drop(page, name, words)
    page.get_by_role("button", name="Start", exact=True).click()


def faultless(page: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(page)
    assert not found.violations_count, found.generate_report()


def test_the_start_has_no_faults_of_access_and_fits(start: Page) -> None:
    faultless(start)
    assert start.evaluate("document.documentElement.scrollWidth") <= 1280


def test_a_script_with_nothing_in_it_is_one_sentence_and_leaves_nothing(start: Page, empty: RunningStudio) -> None:
    begin(start, "two_cups.fountain", " \n\n ")
    expect(start.locator(".bar.wrong")).to_contain_text("there is nothing to read; write at least one scene")
    assert not [path for path in Path(empty.folder).iterdir() if not path.name.startswith(".")]


def test_a_file_that_is_no_script_is_one_sentence(start: Page) -> None:
    begin(start, "cat.png", "not a picture either")
    expect(start.locator(".bar.wrong")).to_contain_text("it ends in")


def test_the_crew_is_watched_stopped_and_goes_on_at_one_click(start: Page, empty: RunningStudio) -> None:
    drop(start, "two_cups.fountain", SCRIPT)
    ready = start.get_by_role("form", name="Make two_cups.fountain")
    expect(ready.get_by_role("heading")).to_have_text("two_cups.fountain")
    faultless(start)
    assert not (empty.folder / "two_cups.fountain").exists(), "nothing begins before it is started"
    ready.get_by_label("Look").select_option("fast")
    ready.get_by_label("Crew").fill("rules")
    ready.get_by_role("button", name="Start").click()
    expect(start.locator(".stages .now")).to_have_count(1)
    expect(start.locator(".event .score").first).to_contain_text("10", timeout=MADE)
    faultless(start)
    start.get_by_role("button", name="Stop").click()
    go_on = start.get_by_role("button", name="Go on")
    expect(go_on).to_be_visible(timeout=MADE)
    go_on.click()
    expect(start.locator(".crew figure img").first).to_be_visible(timeout=MADE)
    expect(start.locator(".card.fresh")).to_have_count(4, timeout=MADE)
    assert "You came back." in start.locator(".board").inner_text()
