"""What is delivered, in a real browser: the board in a chosen layout, lists and timelines written now, the film."""

from __future__ import annotations

import re

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import project_of
from tests.browser.test_board_page import pixels

WRITTEN = 180_000
"""Most milliseconds that something is waited for."""


@pytest.fixture
def deliver(page: Page) -> Page:
    page.set_viewport_size({"width": 1280, "height": 800})
    page.get_by_role("button", name="Deliver", exact=True).click()
    page.wait_for_selector(".printed .frame img")
    return page


def item(page: Page, what: str) -> Locator:
    return page.locator(f'[data-what="{what}"]')


def write(page: Page, what: str) -> None:
    item(page, what).get_by_role("button", name=re.compile("Write now|Make it")).click(timeout=WRITTEN)
    expect(item(page, what).locator(".when.fresh")).to_have_count(1, timeout=WRITTEN)


def test_the_page_that_is_shown_has_as_many_panels_as_are_chosen(deliver: Page) -> None:
    for count in (1, 2, 4):
        deliver.select_option("[data-field=panels]", str(count))
        expect(deliver.locator(".printed .frame")).to_have_count(count)
    shown = pixels(deliver, ".printed .paper")
    assert shown.std() > 20, "pictures and words on white paper"
    assert (shown[:4] > 240).all(), "the margin is white"


def test_the_page_that_is_shown_lies_as_the_paper_does(deliver: Page) -> None:
    def shape() -> float:
        box = deliver.locator(".printed .paper").bounding_box()
        assert box is not None
        return box["width"] / box["height"]

    deliver.select_option("[data-field=paper]", "a4")
    deliver.select_option("[data-field=orientation]", "portrait")
    expect(deliver.locator(".printed .paper")).to_have_attribute("style", re.compile("aspect-ratio: 595"))
    assert abs(shape() - 595 / 842) < 0.01
    deliver.select_option("[data-field=orientation]", "landscape")
    deliver.select_option("[data-field=paper]", "letter")
    expect(deliver.locator(".printed .paper")).to_have_attribute("style", re.compile("aspect-ratio: 792"))
    assert abs(shape() - 792 / 612) < 0.01


def test_frames_and_words_of_the_page_lie_on_it_and_apart(deliver: Page) -> None:
    deliver.select_option("[data-field=panels]", "4")
    expect(deliver.locator(".printed .frame")).to_have_count(4)
    paper = deliver.locator(".printed .paper").bounding_box()
    boxes = [each.bounding_box() for each in deliver.locator(".printed .frame, .printed .said").all()]
    assert paper is not None
    for box in boxes:
        assert box is not None and box["x"] >= paper["x"] and box["x"] + box["width"] <= paper["x"] + paper["width"] + 1
        assert box["y"] + box["height"] <= paper["y"] + paper["height"] + 1


def test_the_board_is_written_in_the_layout_that_is_chosen(deliver: Page, studio: RunningStudio) -> None:
    deliver.select_option("[data-field=panels]", "4")
    deliver.select_option("[data-field=paper]", "a3")
    expect(item(deliver, "board").locator(".when")).to_contain_text("another layout")
    write(deliver, "board")
    answer = deliver.request.get(f"{deliver.url}files/board.pdf")
    assert answer.body().startswith(b"%PDF") and b"/MediaBox [ 0 0 1190.551 841.8898" in answer.body()
    kept = (project_of(studio) / "settings.json").read_text("utf-8")
    assert '"panels": 4' in kept and '"paper": "a3"' in kept


def test_a_timeline_is_written_and_old_after_an_edit(deliver: Page) -> None:
    write(deliver, "edl")
    text = deliver.request.get(f"{deliver.url}files/timeline.edl").text()
    assert "TITLE" in text
    deliver.get_by_role("button", name="Board", exact=True).click()
    deliver.locator(".card").first.click()
    deliver.select_option("select[data-field=angle]", "high angle")
    expect(deliver.locator(".decided").first).to_contain_text("angle")
    deliver.keyboard.press("Escape")
    deliver.get_by_role("button", name="Deliver", exact=True).click()
    expect(item(deliver, "edl").locator(".when.old")).to_have_count(1)
    deliver.get_by_role("button", name="Undo").click()
    expect(item(deliver, "edl").locator(".when.fresh")).to_have_count(1)


def test_scenes_are_written_for_other_programs(deliver: Page) -> None:
    write(deliver, "glb")
    assert deliver.request.get(f"{deliver.url}files/export/SC010.glb").body().startswith(b"glTF")


def test_the_film_is_stopped_and_the_views_stay(deliver: Page) -> None:
    button = item(deliver, "film").get_by_role("button", name="Make it")
    button.click()
    item(deliver, "film").get_by_role("button", name="Stop").click()
    expect(button).to_be_enabled(timeout=WRITTEN)
    expect(deliver.locator(".deliver")).to_be_visible()


def test_nothing_of_it_is_hidden_from_those_who_do_not_see(deliver: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(deliver)
    assert not found.violations_count, found.generate_report()


def test_it_is_usable_on_a_telephone(deliver: Page) -> None:
    deliver.set_viewport_size({"width": 390, "height": 800})
    assert deliver.evaluate("document.documentElement.scrollWidth") <= 390
    assert np.isfinite(pixels(deliver, ".printed .paper")).all()
    deliver.set_viewport_size({"width": 1280, "height": 800})
