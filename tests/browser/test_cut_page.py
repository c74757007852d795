"""The cut in a real browser: played, trimmed, put in another order, all of it undone; usable on a telephone."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from tests.browser.test_board_page import pixels


def widths(page: Page) -> list[float]:
    return [box["width"] for bar in page.locator(".shots .bar").all() if (box := bar.bounding_box())]


def first(page: Page) -> Any:
    return page.locator(".shots .bar").first


@pytest.fixture
def cut(page: Page) -> Page:
    page.set_viewport_size({"width": 1280, "height": 800})
    page.get_by_role("button", name="Cut", exact=True).click()
    page.wait_for_selector(".cut .shots .bar")
    page.keyboard.press("Home")
    return page


def test_shots_are_as_wide_as_they_are_long(cut: Page) -> None:
    lengths = [float(re.search(r"([\d.]+) s", bar.inner_text())[1]) for bar in cut.locator(".shots .face").all()]  # type: ignore[index]
    found = widths(cut)
    assert len(found) == len(lengths) >= 2
    shares = np.array(found) / sum(found) - np.array(lengths) / sum(lengths)
    assert np.abs(shares).max() < 0.02


def test_it_plays_and_the_picture_and_the_words_change(cut: Page) -> None:
    before = pixels(cut, ".cut .screen")
    timecode = cut.get_by_label("Timecode")
    expect(timecode).to_have_text("00:00:00:00")
    cut.keyboard.press(" ")
    expect(timecode).not_to_have_text("00:00:00:00")
    cut.keyboard.press(" ")
    stopped = timecode.inner_text()
    cut.wait_for_timeout(300)
    assert timecode.inner_text() == stopped
    cut.keyboard.press("Shift+ArrowRight")
    expect(cut.locator(".shots .bar").nth(1)).to_have_class(re.compile("here"))
    assert np.abs(before - pixels(cut, ".cut .screen")).mean() > 5, "another shot is on the screen"
    assert cut.locator(".speeches span").count() >= 1
    cut.locator(".speeches span").first.evaluate("said => said.offsetLeft")


def test_a_frame_back_and_forth_and_to_both_ends(cut: Page) -> None:
    timecode = cut.get_by_label("Timecode")
    cut.keyboard.press("ArrowRight")
    expect(timecode).to_have_text("00:00:00:01")
    cut.keyboard.press("ArrowLeft")
    expect(timecode).to_have_text("00:00:00:00")
    cut.keyboard.press("End")
    expect(cut.locator(".shots .bar").last).to_have_class(re.compile("here"))


def test_the_edge_of_a_shot_is_dragged_and_undone(cut: Page) -> None:
    before = first(cut).inner_text()
    edge = first(cut).locator(".edge").bounding_box()
    assert edge is not None
    x, y = edge["x"] + edge["width"] / 2, edge["y"] + edge["height"] / 2
    cut.mouse.move(x, y)
    cut.mouse.down()
    cut.mouse.move(x + 60, y, steps=4)
    expect(first(cut)).not_to_have_text(before)
    cut.keyboard.press("Escape")
    expect(first(cut)).to_have_text(before)
    cut.mouse.up()
    expect(cut.get_by_role("button", name="Undo")).to_have_attribute("title", re.compile("."))
    cut.mouse.move(x, y)
    cut.mouse.down()
    cut.mouse.move(x + 60, y, steps=4)
    cut.mouse.up()
    expect(first(cut)).not_to_have_text(before)
    expect(cut.get_by_role("button", name="Undo")).to_have_attribute("title", re.compile("length"))
    cut.get_by_role("button", name="Undo").click()
    expect(first(cut)).to_have_text(before)


def test_shots_are_shortened_by_keys_and_moved_by_keys(cut: Page) -> None:
    before = [bar.get_attribute("data-bar") for bar in cut.locator(".shots .bar").all()]
    cut.keyboard.press("Alt+ArrowRight")
    expect(first(cut)).to_have_attribute("data-bar", str(before[1]))
    cut.get_by_role("button", name="Undo").click()
    expect(first(cut)).to_have_attribute("data-bar", str(before[0]))
    length = first(cut).inner_text()
    cut.keyboard.press("Home")
    cut.get_by_role("button", name="Shorter").click()
    expect(first(cut)).not_to_have_text(length)
    cut.get_by_role("button", name="Undo").click()
    expect(first(cut)).to_have_text(length)


def test_a_locked_shot_shows_its_lock_and_says_why_it_is_not_trimmed(cut: Page) -> None:
    name = first(cut).get_attribute("data-bar")
    expect(cut.locator(".inspector")).to_have_count(0)
    cut.get_by_role("button", name="Open SH").click()
    expect(cut.locator(".inspector > .head h2")).to_have_text(str(name))
    cut.locator("sb-parts").get_by_label("duration").check()
    cut.get_by_role("button", name="Cut", exact=True).click()
    expect(first(cut).locator(".lock")).to_be_visible()
    length = first(cut).inner_text()
    edge = first(cut).locator(".edge").bounding_box()
    assert edge is not None
    cut.mouse.move(edge["x"] + 4, edge["y"] + 20)
    cut.mouse.down()
    cut.mouse.move(edge["x"] + 64, edge["y"] + 20, steps=4)
    cut.mouse.up()
    refusal = cut.locator(".bar.wrong").first
    expect(refusal).to_contain_text(f"the duration of {name} is locked; unlock it first")
    expect(first(cut)).to_have_text(length)
    cut.keyboard.press("Home")
    cut.get_by_role("button", name="Earlier").click()
    expect(refusal).to_contain_text("a shot stays in its scene")
    cut.get_by_role("button", name="Longer").click()
    expect(refusal).to_contain_text("is locked")
    cut.get_by_role("button", name="Undo").click()
    expect(first(cut).locator(".lock")).to_have_count(0)


def test_nothing_is_wrong_for_those_who_cannot_see_it(cut: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    results = Axe().run(cut)
    assert results.violations_count == 0, results.generate_report()


def test_it_is_usable_on_a_telephone(cut: Page) -> None:
    cut.set_viewport_size({"width": 390, "height": 800})
    expect(cut.locator(".cut .shots .bar").first).to_be_visible()
    wide = cut.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert wide <= 0, "no scroll sideways"
    for name in ("Play", "Shorter", "Longer", "Later"):
        box = cut.get_by_role("button", name=name).bounding_box()
        assert box is not None and box["x"] >= 0 and box["x"] + box["width"] <= 390
    cut.set_viewport_size({"width": 1280, "height": 800})
