"""Cast and assets in a real browser: everybody has a picture, one turns in 3D, clothes change what is seen."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect

from tests.browser.test_board_page import DRAWN
from tests.model_files import box_gltf, glb_of

PEOPLE = ".faces.person .face"


@pytest.fixture
def cast(page: Page) -> Page:
    page.set_viewport_size({"width": 1280, "height": 800})
    page.get_by_role("button", name="Cast and assets", exact=True).click()
    page.wait_for_selector(".sheet", timeout=DRAWN)
    expect(page.locator(".assets .wait")).to_have_count(0, timeout=DRAWN)
    return page


def seen(page: Page) -> np.ndarray:
    """What the viewer shows, as floats."""
    page.wait_for_timeout(300)
    picture = Image.open(io.BytesIO(page.locator(".assets canvas").screenshot()))
    return np.asarray(picture.convert("RGB"), float)


def choose(page: Page, card: int, sort: str = "person") -> None:
    page.locator(f".faces.{sort} .face").nth(card).click()
    expect(page.locator(f".faces.{sort} .face").nth(card)).to_have_class("face chosen ", timeout=DRAWN)
    page.wait_for_selector(".sheet", timeout=DRAWN)
    expect(page.locator(".assets .wait")).to_have_count(0, timeout=DRAWN)


def test_everybody_has_a_picture_and_the_first_stands_in_the_viewer(cast: Page) -> None:
    expect(cast.locator(".face.stale")).to_have_count(0, timeout=2 * DRAWN)
    assert cast.locator(PEOPLE).count() >= 2
    assert seen(cast).std() > 10, "not one colour"


def test_another_one_looks_otherwise_and_keys_turn_it(cast: Page) -> None:
    first = seen(cast)
    choose(cast, 1)
    second = seen(cast)
    assert np.abs(first - second).mean() > 1
    cast.locator(".assets canvas").focus()
    for _ in range(6):
        cast.keyboard.press("ArrowLeft")
    turned = seen(cast)
    assert np.abs(second - turned).mean() > 1
    cast.keyboard.press("Home")
    assert np.abs(seen(cast) - second).mean() < np.abs(turned - second).mean() / 4, "the whole view again"


def test_who_is_clicked_twice_in_haste_is_seen(cast: Page) -> None:
    choose(cast, 0)
    first = seen(cast)
    cast.locator(PEOPLE).nth(1).click()
    cast.locator(PEOPLE).nth(1).click()
    expect(cast.locator(".assets .wait")).to_have_count(0, timeout=DRAWN)
    second = seen(cast)
    assert second.std() > 10 and np.abs(first - second).mean() > 1


def test_a_red_coat_is_seen_and_undone(cast: Page) -> None:
    choose(cast, 0)
    before = seen(cast)
    cast.locator("select[data-field=wear]").select_option("coat")
    coat = cast.locator("[data-garment=coat] input[type=color]")
    expect(coat).to_be_visible(timeout=DRAWN)
    coat.fill("#d01010")
    coat.dispatch_event("change")
    expect(cast.locator(".decided")).to_contain_text("red coat", timeout=DRAWN)
    expect(cast.locator(".assets .wait")).to_have_count(0, timeout=DRAWN)
    red = seen(cast)
    assert ((red[..., 0] - red[..., 2]) > 60).sum() > ((before[..., 0] - before[..., 2]) > 60).sum() + 2000
    cast.get_by_role("button", name="Undo").click()
    cast.get_by_role("button", name="Undo").click()
    expect(cast.locator("[data-garment=coat]")).to_have_count(0, timeout=DRAWN)
    expect(cast.locator(".assets .wait")).to_have_count(0, timeout=DRAWN)
    assert np.abs(seen(cast) - before).mean() < np.abs(red - before).mean() / 4


def test_a_thing_is_made_larger_and_from_something_else(cast: Page) -> None:
    choose(cast, 0, "thing")
    width = cast.locator("input[data-field=width]")
    before = float(width.input_value())
    width.fill(str(round(before * 1.5, 3)))
    width.press("Tab")
    expect(cast.locator(".decided")).to_be_visible(timeout=DRAWN)
    cast.get_by_label("What to look for").fill("vase")
    cast.get_by_role("button", name="Show others").click()
    offered = cast.locator("[data-candidate=vase]")
    expect(offered.locator("img")).to_be_visible(timeout=2 * DRAWN)
    offered.click()
    expect(cast.locator(".decided")).to_contain_text("made from vase", timeout=DRAWN)
    cast.get_by_role("button", name="Undo").click()
    cast.get_by_role("button", name="Undo").click()
    expect(cast.locator(".decided")).to_have_count(0, timeout=DRAWN)


def test_a_model_from_the_disk_is_chosen_and_a_wrong_one_refused(cast: Page, tmp_path: Path) -> None:
    choose(cast, 0, "thing")
    disk = cast.locator("sb-own-model input[type=file]")
    (tmp_path / "notes.txt").write_text("no model")
    disk.set_input_files(tmp_path / "notes.txt")
    expect(cast.locator("sb-own-model .wrong")).to_contain_text("notes.txt is no file of a model")
    (tmp_path / "crate.glb").write_bytes(glb_of(box_gltf((0.4, 0.3, 0.5))))
    disk.set_input_files(tmp_path / "crate.glb")
    expect(cast.locator(".decided")).to_contain_text("made from crate.glb", timeout=DRAWN)
    expect(cast.locator("sb-own-model .wrong")).to_have_count(0)
    cast.get_by_role("button", name="Undo").click()
    expect(cast.locator(".decided")).to_have_count(0, timeout=DRAWN)


def test_a_shot_is_gone_to_from_whom_it_shows(cast: Page) -> None:
    choose(cast, 0)
    shot = cast.locator(".seen button").first
    name = shot.inner_text()
    shot.click()
    expect(cast.locator("sb-shot h2").first).to_have_text(name)
    cast.keyboard.press("Escape")


def test_nothing_is_wrong_for_those_who_cannot_see_it(cast: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    results = Axe().run(cast)
    assert results.violations_count == 0, results.generate_report()


def test_it_fits_wide_and_narrow_windows(cast: Page) -> None:
    for width, height in ((1280, 800), (390, 844)):
        cast.set_viewport_size({"width": width, "height": height})
        cast.wait_for_timeout(300)
        assert cast.evaluate("document.documentElement.scrollWidth") <= width
