"""Thirty random gestures in a real browser, over board, stage, inspector, cut and set: all undone, all done again."""

from __future__ import annotations

import json
import random
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from storyblender.project import read_project_graph
from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import drag, in_page, project_of

GESTURES = 30


def story(studio: RunningStudio) -> bytes:
    return read_project_graph(project_of(studio)).model_dump_json().encode()


def changes(studio: RunningStudio) -> int:
    """Return how many commits of the history are a person's."""
    commits = (json.loads(path.read_bytes()) for path in (project_of(studio) / "history").glob("*.json"))
    return sum(commit["author"] == "user" for commit in commits)


def settled(page: Page) -> None:
    """Wait until what was done is answered, and shown."""
    page.wait_for_timeout(150)
    page.evaluate("() => document.querySelector('sb-studio').edited")
    for _ in range(240):
        if in_page(page, "return !view || (!!view.stage && !view.busy);"):
            return
        page.wait_for_timeout(500)
    raise AssertionError("the stage is not shown")


def rested(page: Page) -> None:
    """Wait until the crew has done what follows from the last gesture: every frame shows the story as it is."""
    show(page, "Board")
    expect(page.locator(".card:is(.preview, .stale)")).to_have_count(0, timeout=300_000)


def show(page: Page, view: str) -> None:
    page.get_by_role("button", name=view, exact=True).click()
    settled(page)


def some(chance: random.Random, found: Locator) -> Locator:
    return found.nth(chance.randrange(found.count()))


def select(page: Page, chance: random.Random) -> None:
    show(page, "Board")
    card = some(chance, page.locator("[data-shot]"))
    shot = card.get_attribute("data-shot")
    card.click()
    for _ in range(240):
        if page.evaluate("shot => document.querySelector('sb-shot')?.details?.shot === shot", shot):
            return
        page.wait_for_timeout(250)
    raise AssertionError(f"{shot} is not in the inspector")


def on_board(page: Page, chance: random.Random) -> None:
    select(page, chance)
    act = chance.choice(["Omit", "Restore", "Approve", "Withdraw approval", "Lock the shot", "Unlock the shot", "key"])
    button = page.locator("sb-shot").get_by_role("button", name=act, exact=True)
    if act == "key":
        page.locator(".card.chosen").first.press(chance.choice(["Alt+ArrowRight", "Alt+ArrowLeft"]))
    elif button.count() and button.is_enabled():
        button.click()


def in_inspector(page: Page, chance: random.Random) -> None:
    select(page, chance)
    panel = page.locator("sb-shot")
    act = chance.choice(["Size", "Angle", "Lens", "Aperture", "note", "Keep, and try another"])
    if act == "note":
        panel.get_by_label("A note").fill(f"note {chance.random():.3f}")
        panel.get_by_label("A note").press("Enter")
    elif act.startswith("Keep"):
        if panel.get_by_role("button", name=act).is_enabled():
            panel.get_by_role("button", name=act).click()
    elif (field := panel.get_by_label(act).first).is_enabled():
        field.select_option(index=chance.randrange(field.locator("option").count()))


def on_stage(page: Page, chance: random.Random) -> None:
    select(page, chance)
    show(page, "Stage")
    page.get_by_role("button", name="From above", exact=True).click()
    page.wait_for_timeout(600)
    stage = in_page(page, "const s = view.scene.stage; return [Object.keys(s.placed), Object.keys(s.people), s.shot];")
    item = chance.choice([*stage[1], chance.choice(stage[0]), f"camera:{stage[2]}:start"])
    if chance.random() < 0.7:
        drag(page, item, (chance.randrange(-40, 40), chance.randrange(-40, 40)))
    else:
        drag(page, item, (0, 0))
        page.locator(".frame canvas").press(chance.choice(["[", "]", "ArrowLeft", "ArrowUp"]))


def in_cut(page: Page, chance: random.Random) -> None:
    show(page, "Cut")
    some(chance, page.locator(".shots .face")).click()
    button = page.get_by_role("button", name=chance.choice(["Shorter", "Longer", "Earlier", "Later"]), exact=True)
    if button.is_enabled():
        button.click()


def in_set(page: Page, chance: random.Random) -> None:
    show(page, "Set and light")
    slider = page.locator(f"input[data-field={chance.choice(['warmth', 'brightness'])}]")
    if slider.is_enabled():
        slider.press(chance.choice(["ArrowRight", "ArrowLeft"]))


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_thirty_gestures_are_undone_and_done_again(page: Page, studio: RunningStudio) -> None:
    chance = random.Random(30)
    kinds: list[Callable[[Page, random.Random], None]] = [on_board, in_inspector, on_stage, in_cut, in_set]
    first, began, tried = story(studio), changes(studio), 0
    while (made := changes(studio) - began) < GESTURES:
        tried += 1
        assert tried < 5 * GESTURES, f"only {made} of {tried} gestures could be made"
        chance.choice(kinds)(page, chance)
        settled(page)
    rested(page)
    last = story(studio)
    assert last != first
    for way, came_to in (("Undo", first), ("Redo", last)):
        for _ in range(made):
            page.get_by_role("button", name=way, exact=True).click()
            settled(page)
        for _ in range(120):
            if story(studio) == came_to:
                break
            page.wait_for_timeout(500)
        assert story(studio) == came_to, f"{way} of {made} gestures"
