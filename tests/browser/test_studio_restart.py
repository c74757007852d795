"""A studio that ends at once: the page says so, and what was decided is there when it is started again."""

from __future__ import annotations

from playwright.sync_api import Browser, expect

from tests.browser.conftest import RunningStudio

SHOT = '[data-shot="SC010_SH010"]'


def test_a_killed_studio_is_said_and_what_was_decided_is_there_again(chromium: Browser, studio: RunningStudio) -> None:
    page = chromium.new_page()
    page.goto(studio.address)
    page.locator(SHOT).click()
    page.select_option("select[data-field=angle]", "low angle")
    expect(page.locator(".decided")).to_contain_text("angle")
    studio.kill()
    expect(page.locator(".bar.wrong").first).to_contain_text("does not answer")
    studio.restart()
    page.goto(studio.address)
    page.locator(SHOT).click()
    expect(page.locator(".decided")).to_contain_text("angle")
