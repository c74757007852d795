"""The shot in the cut, in a real browser: split, joined, one more added, parts of it locked; undo takes each back."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

SHOT = "SC010_SH010"


@pytest.fixture
def opened(page: Page) -> Iterator[Page]:
    page.locator(f'[data-shot="{SHOT}"]').click()
    expect(page.locator(".inspector > .head h2")).to_have_text(SHOT)
    page.locator("sb-parts summary").click()
    yield page
    page.keyboard.press("Escape")


def shots(page: Page) -> list[str]:
    return page.locator(".card").evaluate_all("cards => cards.map((card) => card.dataset.shot)")


def undone(page: Page, count: int) -> None:
    page.get_by_role("button", name="Undo").click()
    expect(page.locator(".bar")).to_contain_text("Undone")
    expect(page.locator(".card")).to_have_count(count)


def test_a_shot_is_split_at_a_time(opened: Page) -> None:
    before = shots(opened)
    second = opened.locator("sb-parts input[name=seconds]").first
    split = opened.locator("sb-parts").get_by_role("button", name="Split")
    second.fill("0.3")
    split.click()
    assert not second.evaluate("field => field.checkValidity()"), "no shot of a third of a second is made by mistake"
    second.fill(str(second.get_attribute("min")))
    split.click()
    expect(opened.locator(".card")).to_have_count(len(before) + 1)
    assert shots(opened)[1] == "SC010_SH015"
    undone(opened, len(before))
    assert shots(opened) == before


def test_a_shot_is_joined_with_the_next(opened: Page) -> None:
    before = shots(opened)
    opened.locator("sb-parts").get_by_role("button", name="Join with").click()
    expect(opened.locator(".card")).to_have_count(len(before) - 1)
    undone(opened, len(before))
    assert shots(opened) == before


def test_a_reaction_is_added_after_it(opened: Page) -> None:
    before = shots(opened)
    opened.select_option("sb-parts select[name=kind]", "reaction")
    opened.locator("sb-parts").get_by_role("button", name="Add after this").click()
    expect(opened.locator(".card")).to_have_count(len(before) + 1)
    undone(opened, len(before))


def test_a_part_is_locked_alone(opened: Page) -> None:
    duration = opened.locator("sb-parts").get_by_label("duration")
    duration.check()
    expect(opened.locator(".bar")).to_contain_text("duration")
    expect(opened.locator("select[data-field=size]")).to_be_enabled()
    duration.uncheck()
    expect(opened.locator("sb-parts").get_by_label("duration")).not_to_be_checked()


def test_it_has_no_faults_of_access(opened: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(opened)
    assert not found.violations_count, found.generate_report()
