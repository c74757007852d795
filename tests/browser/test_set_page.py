"""Set and light of a scene in a real browser: changed, followed by the pictures, undone."""

from __future__ import annotations

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from tests.browser.test_board_page import DRAWN, pixels

PICTURE = ".setlight figure img"


@pytest.fixture
def scene(page: Page) -> Page:
    page.set_viewport_size({"width": 1280, "height": 800})
    page.get_by_role("button", name="Set and light", exact=True).click()
    page.wait_for_selector(".setlight fieldset")
    return page


def test_the_set_and_every_lamp_are_shown(scene: Page) -> None:
    assert scene.locator("select[data-field=kit] option:checked").inner_text()
    assert scene.locator(".lamps tbody tr").count() >= 1
    assert pixels(scene, PICTURE).std() > 10, "a picture, not one colour"


def test_warmer_light_shows_in_the_picture_and_is_undone(scene: Page) -> None:
    before = pixels(scene, PICTURE)
    scene.locator("input[data-field=warmth]").fill("3")
    expect(scene.locator(".decided")).to_contain_text("warmth")
    expect(scene.locator(".setlight figure").first).to_have_class("fresh", timeout=DRAWN)
    scene.wait_for_timeout(500)
    after = pixels(scene, PICTURE)
    assert (after[..., 0] - after[..., 2]).mean() > (before[..., 0] - before[..., 2]).mean() + 3, "redder than blue"
    scene.get_by_role("button", name="Undo").click()
    expect(scene.locator(".decided")).to_have_count(0)
    expect(scene.locator("input[data-field=warmth]")).to_have_value("0")


def test_a_wall_of_another_material_is_decided_and_undone(scene: Page) -> None:
    walls = scene.locator("select[data-field=walls]")
    walls.select_option("plaster_red")
    expect(scene.locator(".decided")).to_contain_text("plaster_red")
    expect(scene.locator(".setlight figure").first).to_have_class("fresh", timeout=DRAWN)
    scene.wait_for_timeout(500)
    red = pixels(scene, PICTURE)
    scene.get_by_role("button", name="Undo").click()
    expect(walls).to_have_value("")
    expect(scene.locator(".setlight figure").first).to_have_class("fresh", timeout=DRAWN)
    scene.wait_for_timeout(500)
    assert np.abs(red - pixels(scene, PICTURE)).mean() > 1, "the wall shows"


def test_a_lamp_is_dimmed_and_taken_away(scene: Page) -> None:
    rows = scene.locator(".lamps tbody tr")
    count = rows.count()
    power = rows.first.locator("input[type=number]")
    before = power.input_value()
    power.fill(str(round(float(before) / 2, 2)))
    power.press("Tab")
    expect(scene.locator(".decided")).to_contain_text("W")
    scene.get_by_role("button", name="Undo").click()
    expect(rows.first.locator("input[type=number]")).to_have_value(before, timeout=DRAWN)
    rows.first.get_by_role("button").click()
    expect(rows).to_have_count(count - 1, timeout=DRAWN)
    scene.get_by_role("button", name="Undo").click()
    expect(rows).to_have_count(count, timeout=DRAWN)


def test_nothing_is_wrong_for_those_who_cannot_see_it(scene: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    results = Axe().run(scene)
    assert results.violations_count == 0, results.generate_report()
