"""A studio or a Blender that ends at once: only the open gesture is lost, and the page goes on by itself."""

from __future__ import annotations

import os
import signal
from pathlib import Path

from playwright.sync_api import Browser, expect

from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import graph_of

SHOT = '[data-shot="SC010_SH010"]'


def blenders_of(studio: RunningStudio) -> list[int]:
    """Process numbers of the studio's Blender workers."""
    found: list[int] = []
    for entry in Path("/proc").iterdir():
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0") if entry.name.isdigit() else []
        except OSError:
            continue
        if b"storyblender.blender" in words and str(studio.folder).encode() in b" ".join(words):
            found.append(int(entry.name))
    return found


def test_a_killed_studio_is_said_and_its_page_goes_on_where_it_was(chromium: Browser, studio: RunningStudio) -> None:
    page = chromium.new_page()
    page.goto(studio.address)
    page.locator(SHOT).click()
    page.select_option("select[data-field=angle]", "low angle")
    expect(page.locator(".decided").first).to_contain_text("angle")
    page.get_by_role("button", name="Cut", exact=True).click()
    edge = page.locator(".shots .bar .edge").first.bounding_box()
    assert edge is not None
    decided = graph_of(studio)
    page.mouse.move(edge["x"] + 4, edge["y"] + 10)
    page.mouse.down()
    page.mouse.move(edge["x"] + 60, edge["y"] + 10, steps=3)
    studio.kill()
    page.mouse.up()
    expect(page.locator(".bar.wrong").first).to_contain_text("does not answer")
    studio.restart()
    expect(page.locator(".bar.wrong", has_text="does not answer")).to_have_count(0)
    page.get_by_role("button", name="Board", exact=True).click()
    page.locator(SHOT).click()
    expect(page.locator(".decided").first).to_contain_text("angle")
    assert graph_of(studio) == decided, "only the drag is lost"
    page.close()


def test_a_killed_blender_is_started_again_and_the_frame_is_drawn(chromium: Browser, studio: RunningStudio) -> None:
    page = chromium.new_page()
    page.goto(studio.address)
    page.locator(f"{SHOT}.fresh").wait_for(timeout=240_000)
    page.locator(SHOT).click()
    page.select_option("select[data-field=size]", "ECU")
    page.locator(f"{SHOT}:is(.preview, .stale)").wait_for(timeout=240_000)
    for process in blenders_of(studio):
        os.kill(process, signal.SIGKILL)
    page.locator(f"{SHOT}.fresh").wait_for(timeout=240_000)
    expect(page.locator(".decided").first).to_contain_text("size")
    page.keyboard.press("Control+z")
    page.close()
