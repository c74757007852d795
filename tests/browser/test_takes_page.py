"""Takes of blocking and layout in a real browser: kept, compared side by side, chosen, dropped."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import graph_of

SHOT = '[data-shot="SC010_SH010"]'
DRAWN = 240_000
"""Most milliseconds that a picture is waited for."""


@pytest.fixture
def inspector(page: Page) -> Iterator[Page]:
    page.keyboard.press("Escape")
    page.locator(SHOT).click()
    page.wait_for_selector(".takes")
    yield page


def row(page: Page, of: str) -> Locator:
    return page.get_by_role("group", name=f"Takes: {of}")


def test_a_blocking_is_kept_another_made_and_both_are_seen_side_by_side(inspector: Page, studio: RunningStudio) -> None:
    page, before = inspector, graph_of(studio).model_dump_json()
    row(page, "Blocking").get_by_role("button", name="Keep").click()
    expect(row(page, "Blocking").get_by_role("button", name="Take 2", exact=True)).to_be_disabled()
    page.keyboard.press("/")
    page.keyboard.type("Tom kneels")
    page.keyboard.press("Enter")
    expect(page.locator(".bar").first).to_contain_text("kneeling")
    row(page, "Blocking").get_by_role("button", name="Compare").click()
    dialog = page.get_by_role("dialog", name="Takes of SC010_SH010")
    expect(dialog.locator("img")).to_have_count(2, timeout=DRAWN)
    assert dialog.locator("img").evaluate_all("all => all.every((each) => each.complete && each.naturalWidth > 100)")
    dialog.get_by_role("button", name="Choose this take").click()
    expect(row(page, "Blocking").get_by_role("button", name="Take 1", exact=True)).to_be_disabled()
    assert graph_of(studio).shot(1, 1).blocking_decision is None
    undo = page.get_by_role("button", name="Undo")
    for _ in range(3):
        done = undo.get_attribute("title") or ""
        undo.click()
        expect(undo).not_to_have_attribute("title", done)
    expect(undo).to_be_disabled()
    assert graph_of(studio).model_dump_json() == before, "byte for byte"


def test_a_layout_is_kept_and_dropped(inspector: Page) -> None:
    page = inspector
    row(page, "Layout of the scene").get_by_role("button", name="Keep").click()
    drop = row(page, "Layout of the scene").get_by_role("button", name="Drop take 1 of the layout")
    drop.click()
    expect(drop).to_have_count(0)
    for _ in range(2):
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(".bar").first).to_contain_text("Undone")


def test_a_take_that_is_not_drawn_says_so_and_is_drawn_at_once(inspector: Page, studio: RunningStudio) -> None:
    page, before = inspector, graph_of(studio).model_dump_json()
    expect(page.locator(f"{SHOT}.fresh")).to_be_visible(timeout=DRAWN)
    row(page, "Camera").get_by_role("button", name="Keep").click()
    expect(row(page, "Camera").get_by_role("button", name="Compare")).to_be_visible()
    page.get_by_role("button", name="Warmer").click()
    expect(page.locator(".bar").first).to_contain_text("warmth")
    row(page, "Camera").get_by_role("button", name="Compare").click()
    dialog = page.get_by_role("dialog", name="Takes of SC010_SH010")
    kept, shown = dialog.locator("section").first, dialog.locator("section").last
    expect(kept.locator(".picture")).to_contain_text("Take 1 is not drawn", timeout=DRAWN)
    kept.get_by_role("button", name="Draw it now").click()
    expect(kept.locator("img")).to_have_count(1, timeout=DRAWN)
    assert kept.locator("img").evaluate("image => image.decode().then(() => image.naturalWidth)") > 100
    expect(kept.locator(".state")).to_have_text("quick preview")
    expect(shown.locator(".picture")).to_have_class(re.compile("fresh"), timeout=DRAWN)
    expect(shown.get_by_role("button", name="Draw it now")).to_have_count(0)
    dialog.get_by_role("button", name="Close").click()
    for done in ("warmth", "kept"):
        undo = page.get_by_role("button", name="Undo")
        expect(undo).to_have_attribute("title", re.compile(done))
        undo.click()
    expect(page.get_by_role("button", name="Undo")).to_be_disabled()
    assert graph_of(studio).model_dump_json() == before


def test_the_inspector_has_no_faults_of_access(inspector: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(inspector)
    assert not found.violations_count, found.generate_report()
