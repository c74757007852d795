"""What was saved in Blender, in a real browser: told, shown, taken over; of two sides one is chosen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from storyblender.project import read_project_graph
from tests.browser.conftest import RunningStudio
from tests.e2e.test_pull import in_blender

pytestmark = pytest.mark.timeout(600)
SHOT = "SC010_SH010"
READ = 90_000
"""Most milliseconds until the page has read the file."""


def story(studio: RunningStudio) -> Path:
    return studio.folder / "two_cups.storyboard"


def lens(studio: RunningStudio) -> float | None:
    decided = read_project_graph(story(studio)).shot(1, 1).camera_decision
    return decided.lens if decided is not None else None


def save_in_blender(page: Page, studio: RunningStudio, code: str) -> None:
    """Change the file in Blender, come back to the window, and look at what the page says."""
    in_blender(story(studio) / "story.blend", code)
    page.evaluate("window.dispatchEvent(new Event('focus'))")
    page.get_by_role("button", name="Look at it").click(timeout=READ)
    expect(page.locator(".pull .primary")).to_be_visible(timeout=READ)


@pytest.fixture
def rested(page: Page, studio: RunningStudio) -> Page:
    """The page with story.blend written as the story is."""
    page.locator("nav").get_by_role("button", name="Board", exact=True).click()
    return page


def test_a_moved_thing_is_listed_taken_over_and_undone(rested: Page, studio: RunningStudio) -> None:
    from axe_playwright_python.sync_playwright import Axe

    before = read_project_graph(story(studio))
    save_in_blender(rested, studio, "thing.location.x += 0.3")
    expect(rested.locator(".pull li")).to_contain_text("is moved by 0.30")
    assert read_project_graph(story(studio)) == before, "looking changes nothing"
    found = Axe().run(rested)
    assert not found.violations_count, found.generate_report()
    rested.locator(".pull .primary").click()
    expect(rested.get_by_role("button", name="Undo")).to_be_enabled(timeout=READ)
    after = read_project_graph(story(studio)).scenes[0].layout_decision
    assert after is not None and len(after.things) == 1
    rested.get_by_role("button", name="Undo").click()
    expect(rested.locator(".bar").first).to_contain_text("Undone", timeout=READ)
    assert read_project_graph(story(studio)).scenes[0].layout_decision is None


def test_of_what_changed_on_both_sides_one_is_chosen(rested: Page, studio: RunningStudio) -> None:
    name = "next(obj for obj in scene.objects if obj.name == 'SC010_SH010')"
    in_blender(story(studio) / "story.blend", f"{name}.data.lens = 77.0")
    rested.locator(f'[data-shot="{SHOT}"]').click()
    rested.get_by_label("Lens").select_option("24")
    rested.wait_for_timeout(500)
    rested.evaluate("window.dispatchEvent(new Event('focus'))")
    rested.get_by_role("button", name="Look at it").click(timeout=READ)
    conflict = rested.locator(".conflict").first
    expect(conflict).to_contain_text("77", timeout=READ)
    assert lens(studio) == 24
    conflict.get_by_role("button").first.click()
    expect(conflict.get_by_role("button").first).to_have_attribute("aria-pressed", "true")
    rested.locator(".pull .primary").click()
    for _ in range(60):
        if lens(studio) == 77:
            break
        rested.wait_for_timeout(1000)
    assert np.isclose(lens(studio) or 0, 77)
