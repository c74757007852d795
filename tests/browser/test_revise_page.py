"""Why a shot is as it is, takes side by side, and a revised script, in a real browser."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from playwright.sync_api import Page, expect

from tests.browser.conftest import RunningStudio
from tests.browser.test_board_page import DRAWN, FRESH, card, pixels


def inspect(page: Page) -> None:
    page.keyboard.press("Escape")
    card(page).click()
    page.wait_for_selector(".inspector fieldset")


def test_a_shot_says_who_decided_it_and_marks_the_words(page: Page) -> None:
    inspect(page)
    page.get_by_text("Why is it like this?").click()
    expect(page.locator(".why tbody")).to_contain_text("camera operator")
    expect(page.locator(".why tbody tr").first).to_contain_text("rules")
    assert page.locator(".why mark").count() >= 1


def test_two_takes_are_compared_and_one_is_chosen(page: Page) -> None:
    inspect(page)
    page.get_by_role("button", name="Keep, and try another").first.click()
    expect(page.locator(".inspector").get_by_role("button", name="Take 2", exact=True)).to_be_visible()
    size = page.locator("select[data-field=size]")
    other = "ECU" if size.input_value() != "ECU" else "WS"
    size.select_option(other)
    expect(card(page).locator(".facts")).to_contain_text(other)
    expect(page.locator(FRESH)).to_be_visible(timeout=DRAWN)
    page.get_by_role("button", name="Compare").click()
    shown = page.locator("dialog.compare section img")
    expect(shown).to_have_count(2)
    for index in range(2):
        expect(shown.nth(index)).to_have_js_property("complete", True)
    left, right = (pixels(page, f"dialog.compare section:nth-child({side}) img") for side in (1, 2))
    assert np.abs(left - right[: left.shape[0], : left.shape[1]]).mean() > 3, "the takes look different"
    page.get_by_label("One over the other").check()
    half = pixels(page, "dialog.compare .over")
    page.get_by_label("Wipe").fill("100")
    assert np.abs(half - pixels(page, "dialog.compare .over")).mean() > 1, "the wipe shows the other take"
    page.get_by_label("One over the other").uncheck()
    page.get_by_role("button", name="Choose this take").click()
    expect(page.locator("sb-compare dialog").first).to_be_hidden()
    expect(page.locator(".inspector").get_by_role("button", name="Take 1", exact=True)).to_have_class("chosen")


def test_a_revised_script_is_listed_before_it_is_taken_over(page: Page, studio: RunningStudio, tmp_path: Path) -> None:
    page.keyboard.press("Escape")
    cards = page.locator(".card").count()
    revised = tmp_path / "two_cups.fountain"
    text = (studio.folder / "two_cups.fountain").read_text(encoding="utf-8")
    revised.write_text(text + "\nINT. CELLAR - NIGHT\n\nA lamp burns on a table.\n", encoding="utf-8")
    page.get_by_role("button", name="Revised script").click()
    page.get_by_label("Choose the revised script").set_input_files(revised)
    expect(page.locator(".revise tbody tr.new").first).to_be_visible()
    assert page.locator(".revise tbody tr.changed").count() == 0
    page.get_by_role("button", name="Take it over").click()
    expect(page.locator(".card")).to_have_count(cards + 1, timeout=DRAWN)
    page.get_by_role("button", name="Undo").click()
    expect(page.locator(".card")).to_have_count(cards, timeout=DRAWN)
