"""The board in a real browser: looked at, gone through by keys, changed, undone."""

from __future__ import annotations

import base64
import io
import re
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect

SHOT = "SC010_SH010"
FRESH = f'[data-shot="{SHOT}"].fresh'
"""The shot's card when its frame shows the story as it is."""
DRAWN = 120_000
"""Most milliseconds that a frame is waited for."""


def card(page: Page, shot: str = SHOT) -> Any:
    return page.locator(f'[data-shot="{shot}"]')


def pixels(page: Page, selector: str) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(page.locator(selector).first.screenshot())).convert("RGB"), dtype=float)


def frame(page: Page) -> np.ndarray:
    """Return the pixels of the picture in the inspector as the browser has it, whatever its size on the screen."""
    address = page.locator(".inspector img").evaluate(
        """image => {
            const canvas = Object.assign(document.createElement("canvas"), {width: 320, height: 180});
            canvas.getContext("2d").drawImage(image, 0, 0, 320, 180);
            return canvas.toDataURL();
        }"""
    )
    picture = Image.open(io.BytesIO(base64.b64decode(address.partition(",")[2])))
    return np.asarray(picture.convert("RGB"), dtype=float)


@pytest.fixture
def inspected(page: Page) -> Page:
    page.keyboard.press("Escape")
    card(page).click()
    page.wait_for_selector(".inspector fieldset")
    return page


def test_every_shot_has_its_picture_and_its_words(page: Page) -> None:
    cards = page.locator(".card")
    assert cards.count() >= 2
    for index in range(cards.count()):
        assert cards.nth(index).locator("img").evaluate("image => image.naturalWidth") >= 300
    assert "You came back." in page.locator(".board").inner_text()
    assert pixels(page, ".card img").std() > 10, "a picture, not one colour"


def test_the_key_is_gone_from_the_address(page: Page) -> None:
    assert "token" not in page.url


def test_arrows_go_from_shot_to_shot_and_enter_opens(page: Page) -> None:
    page.keyboard.press("Escape")
    card(page).focus()
    page.keyboard.press("ArrowRight")
    chosen = page.evaluate("document.activeElement.dataset.shot")
    assert chosen not in (None, SHOT)
    page.keyboard.press("Enter")
    expect(page.locator(".inspector > .head h2")).to_have_text(chosen)
    page.keyboard.press("Escape")
    expect(page.locator(".inspector")).to_have_count(0)


def test_a_size_is_changed_its_picture_follows_and_undo_brings_it_back(inspected: Page) -> None:
    page = inspected
    page.wait_for_selector(FRESH, timeout=DRAWN)
    before, size = frame(page), page.locator("select[data-field=size]").input_value()
    page.select_option("select[data-field=size]", "ECU" if size != "ECU" else "MS")
    page.wait_for_selector(f'[data-shot="{SHOT}"]:is(.preview, .stale)', timeout=DRAWN)
    page.wait_for_selector(FRESH, timeout=DRAWN)
    page.wait_for_timeout(300)
    after = frame(page)
    assert np.abs(after - before).mean() > 8, "the picture shows something else"
    expect(page.locator(".decided")).to_contain_text("size")
    page.keyboard.press("Control+z")
    expect(page.locator("select[data-field=size]")).to_have_value(size)
    page.wait_for_selector(FRESH, timeout=DRAWN)
    page.wait_for_timeout(300)
    assert np.abs(frame(page) - before).mean() < 1, "and then what it showed at first"


def test_words_become_an_edit_and_nonsense_a_sentence(inspected: Page) -> None:
    page = inspected
    page.keyboard.press("/")
    page.keyboard.type("85 mm")
    page.keyboard.press("Enter")
    expect(page.locator(".bar")).to_contain_text("85")
    page.fill("#say", "flurbish the wug")
    page.keyboard.press("Enter")
    expect(page.locator(".bar.wrong")).to_contain_text("not understood")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+z")
    expect(page.locator(".bar")).to_contain_text("Undone")


def test_a_locked_shot_takes_no_camera_until_it_is_unlocked(inspected: Page) -> None:
    page = inspected
    page.get_by_role("button", name="Lock the shot").click()
    expect(page.locator("select[data-field=size]")).to_be_disabled()
    page.get_by_role("button", name="Unlock the shot").click()
    expect(page.locator("select[data-field=size]")).to_be_enabled()


def test_the_board_has_no_faults_of_access(inspected: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(inspected)
    assert not found.violations_count, found.generate_report()


def test_on_a_telephone_every_button_of_the_board_and_of_a_shot_is_reached(inspected: Page) -> None:
    page = inspected
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    for name in ("Approve", "Lock the shot", "Undo", "Deliver", "Close"):
        button = page.get_by_role("button", name=name, exact=True).first
        button.scroll_into_view_if_needed()
        box = button.bounding_box()
        assert box is not None and box["x"] >= 0 and box["x"] + box["width"] <= 390, name
    page.set_viewport_size({"width": 1280, "height": 800})


@pytest.mark.parametrize("width", [1280, 390])
def test_nothing_is_cut_off_at_the_side(page: Page, width: int) -> None:
    page.keyboard.press("Escape")
    page.set_viewport_size({"width": width, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.set_viewport_size({"width": 1280, "height": 800})


def test_a_shot_is_moved_by_keys_and_by_hand_and_comes_back(page: Page) -> None:
    page.keyboard.press("Escape")
    order = page.locator(".card").evaluate_all("cards => cards.map(card => card.dataset.shot)")
    first, second = page.locator(".card").nth(0), page.locator(".card").nth(1)
    first.focus()
    page.keyboard.press("Alt+ArrowRight")
    expect(first).to_have_attribute("data-shot", order[1])
    second.drag_to(first)
    expect(first).to_have_attribute("data-shot", order[0])
    for _ in range(2):
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(".bar")).to_contain_text("Undone")
    expect(first).to_have_attribute("data-shot", order[0])


def test_a_shot_that_is_omitted_stays_on_the_board_until_it_is_restored(inspected: Page) -> None:
    page = inspected
    whole = page.locator(".summary").inner_text()
    page.get_by_role("button", name="Omit", exact=True).last.click()
    expect(card(page)).to_have_class(re.compile(r"\bomitted\b"))
    expect(page.locator(".summary")).not_to_have_text(whole)
    page.get_by_role("button", name="Restore").last.click()
    expect(page.locator(".summary")).to_have_text(whole)


def test_a_note_is_written_and_done_and_a_shot_approved(inspected: Page) -> None:
    page = inspected
    page.get_by_label("A note").fill("slower here")
    page.keyboard.press("Enter")
    expect(card(page).locator(".marks")).to_contain_text("1 note")
    page.locator(".notes input[type=checkbox]").check()
    expect(card(page).locator(".marks")).not_to_contain_text("1 note")
    expect(page.locator(FRESH)).to_be_visible(timeout=DRAWN)
    page.get_by_role("button", name="Approve").click()
    expect(card(page).locator(".marks")).to_contain_text("approved")
    expect(page.locator("select[data-field=size]")).to_be_disabled()
    page.get_by_role("button", name="Withdraw approval").click()
    expect(page.locator("select[data-field=size]")).to_be_enabled()


def test_an_old_picture_is_drawn_before_its_shot_is_approved(inspected: Page) -> None:
    page = inspected
    expect(page.locator(FRESH)).to_be_visible(timeout=DRAWN)
    page.select_option("select[data-field=angle]", "low angle")
    expect(page.locator(f'[data-shot="{SHOT}"]:not(.fresh)')).to_be_visible()
    page.get_by_role("button", name="Approve").click()
    page.get_by_role("button", name="Draw it now").click()
    expect(page.locator("sb-approval [role=status]")).to_have_text("This is the shot as it is now.", timeout=DRAWN)
    expect(page.locator(FRESH)).to_be_visible()
    expect(card(page).locator(".marks")).not_to_contain_text("approved")
    page.get_by_role("button", name="Approve").click()
    expect(card(page).locator(".marks")).to_contain_text("approved")
    for done in ("approved", "low angle"):
        expect(page.get_by_role("button", name="Undo")).to_have_attribute("title", re.compile(done))
        page.get_by_role("button", name="Undo").click()
    expect(page.get_by_role("button", name="Undo")).not_to_have_attribute("title", re.compile("low angle"))
