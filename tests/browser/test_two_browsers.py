"""Two pages on one project: each sees the other's edits, and one that is behind is refused politely."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

SHOT = '[data-shot="SC010_SH010"]'
OTHER = '[data-shot="SC010_SH020"]'


@pytest.fixture
def second(page: Page) -> Iterator[Page]:
    """A page of another browser window, which has the cookie."""
    assert page.context.browser is not None
    window = page.context.browser.new_context(storage_state=page.context.storage_state())
    other = window.new_page()
    other.goto(page.url)
    other.wait_for_selector(".card img")
    yield other
    window.close()


def test_an_edit_in_one_page_arrives_in_the_other(page: Page, second: Page) -> None:
    page.locator(SHOT).click()
    page.get_by_label("A note").fill("for both of us")
    page.keyboard.press("Enter")
    expect(second.locator(SHOT).locator(".marks")).to_contain_text("1 note")
    second.get_by_role("button", name="Undo").click()
    expect(page.locator(SHOT).locator(".marks")).not_to_contain_text("1 note")


def test_edits_of_different_shots_from_both_pages_are_kept(page: Page, second: Page) -> None:
    page.locator(SHOT).click()
    second.locator(OTHER).click()
    for shot in (SHOT, OTHER):
        expect(page.locator(f"{shot}.fresh")).to_be_visible()
    page.get_by_role("button", name="Approve").click()
    second.get_by_role("button", name="Approve").click()
    for each in (page, second):
        for shot in (SHOT, OTHER):
            expect(each.locator(shot).locator(".marks")).to_contain_text("approved")
    for _ in range(2):
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(".bar").first).to_contain_text("Undone")
    expect(page.locator(".approved")).to_have_count(0)


def test_the_page_gives_an_address_for_another_browser(page: Page, chromium: Browser) -> None:
    page.get_by_role("button", name="Another browser").click()
    dialog = page.get_by_role("dialog", name="Another browser")
    expect(dialog.get_by_label("Address")).to_have_value(re.compile(r"^http://127\.0\.0\.1:\d+/\?token=.{20,}"))
    address = dialog.get_by_label("Address").input_value()
    from axe_playwright_python.sync_playwright import Axe

    faults = Axe().run(page)
    assert not faults.violations_count, faults.generate_report()
    dialog.get_by_role("button", name="Close").click()
    other = chromium.new_context().new_page()
    other.goto(address)
    other.wait_for_selector(".card img")
    third = chromium.new_context().new_page()
    answer = third.goto(address)
    assert answer is not None and answer.status == 403 and "--link" in third.inner_text("body")
    other.context.close()
    third.context.close()


def test_a_page_that_is_behind_is_told_what_has_changed(page: Page, second: Page) -> None:
    second.locator(SHOT).click()
    second.wait_for_selector("select[data-field=angle]")
    second.evaluate("() => { document.querySelector('sb-studio').wire.news = () => {}; }")
    page.locator(SHOT).click()
    page.select_option("select[data-field=angle]", "low angle")
    expect(page.locator(".bar").first).to_contain_text("low angle")
    second.select_option("select[data-field=angle]", "high angle")
    expect(second.locator(".bar.wrong").first).to_contain_text("changed")
    expect(second.locator(".bar.wrong").first).to_contain_text("low angle")
    page.get_by_role("button", name="Undo").click()
