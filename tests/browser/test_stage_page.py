"""The stage in a real browser: what Blender draws is what it shows; things, people and cameras are moved by hand."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Locator, Page, expect

from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film, project
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import read_project_graph
from tests.browser.conftest import RunningStudio

SHOT = "SC010_SH010"
LOADED = 120_000
"""Most milliseconds that a scene in 3D is waited for."""


@pytest.fixture(scope="module")
def stage(studio: RunningStudio, chromium: Browser) -> Iterator[Page]:
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(studio.address)
    page.locator(f'[data-shot="{SHOT}"]').click()
    page.get_by_role("button", name="Stage", exact=True).click()
    page.wait_for_selector(".scrub", timeout=LOADED)
    yield page
    page.close()
    assert not errors


def project_of(studio: RunningStudio) -> Path:
    return studio.folder / "two_cups.storyboard"


def graph_of(studio: RunningStudio) -> ContinuityMemoryGraph:
    return read_project_graph(project_of(studio))


def look(page: Page, view: str) -> np.ndarray:
    page.get_by_role("button", name=view, exact=True).click()
    page.wait_for_timeout(1200)
    return np.asarray(Image.open(io.BytesIO(page.locator(".frame canvas").screenshot())).convert("RGB"), dtype=float)


def in_page(page: Page, script: str, *values: Any) -> Any:
    return page.evaluate(
        f"([...values]) => {{ const view = document.querySelector('sb-stage'); {script} }}", list(values)
    )


@contextmanager
def shown_anew(page: Page) -> Iterator[None]:
    """Wait until the page shows the scene as it is after what is done inside."""
    in_page(page, "window.shownBefore = view.stage;")
    yield
    for _ in range(LOADED // 500):  # the page's policy forbids what wait_for_function does
        if in_page(page, "return view.stage !== window.shownBefore && !view.busy;"):
            return
        page.wait_for_timeout(500)
    raise AssertionError(f"the stage was not shown anew: {in_page(page, 'return [view.busy, view.why];')}")


def undo(page: Page) -> None:
    with shown_anew(page):
        page.get_by_role("button", name="Undo").click()
        expect(said(page)).to_contain_text("Undone")


def said(page: Page) -> Locator:
    return page.locator("header ~ .bar")


def test_every_view_shows_a_picture_of_its_own(stage: Page) -> None:
    views = [look(stage, name) for name in ("Through the camera", "Free", "From above")]
    assert all(view.std() > 12 for view in views), "a picture, not one colour"
    assert np.abs(views[0][:300, :600] - views[2][:300, :600]).mean() > 10


def test_what_the_camera_shows_is_what_blender_draws(stage: Page, studio: RunningStudio) -> None:
    look(stage, "Through the camera")
    graph = graph_of(studio)
    shot = graph.shot(1, 1)
    assert shot.camera is not None and shot.frame is not None
    film = Film(shot.camera.sensor_width, graph.format.aspect)
    points = [
        list(point)
        for block in shot.blocking
        for point in (block.start.location, np.add(block.start.location, (0, 0, 1.7)).tolist())
    ]
    assert len(points) >= 4
    blender = project(camera_at(shot.camera, shot.frame, film), points)[0]
    page = in_page(stage, "return view.scene.pictured(values);", *points)
    assert np.abs(np.asarray(page) - np.asarray(blender)).max() < 0.01


def test_the_frame_that_was_drawn_has_the_same_picture(stage: Page, studio: RunningStudio) -> None:
    shown = look(stage, "Through the camera")
    with Image.open(project_of(studio) / f"frames/{SHOT}.png") as frame:
        drawn = np.asarray(frame.convert("L").resize((64, 36)), dtype=float)
    seen = np.asarray(Image.fromarray(shown.astype(np.uint8)).convert("L").resize((64, 36)), dtype=float)
    assert np.corrcoef(drawn.ravel(), seen.ravel())[0, 1] > 0.5


def point_on(page: Page, node: str) -> tuple[float, float]:
    """Return where a thing is on the screen in the view that is shown."""
    x, y = in_page(page, "return view.scene.onScreen(values[0]);", node)
    box = page.locator(".frame canvas").bounding_box()
    assert box is not None
    return box["x"] + x * box["width"], box["y"] + y * box["height"]


def drag(page: Page, node: str, by: tuple[int, int], *, cancel: bool = False) -> None:
    x, y = point_on(page, node)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + by[0], y + by[1], steps=4)
    if cancel:
        page.keyboard.press("Escape")
    page.mouse.up()


def test_a_person_who_is_dragged_stands_there_and_undo_brings_them_back(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = graph_of(studio)
    where = {block.start.asset_id: block.start.location for block in before.shot(1, 1).blocking}
    with shown_anew(stage):
        drag(stage, "tom", (30, 20))
        expect(said(stage)).to_contain_text("tom starts")
    now = {block.start.asset_id: block.start.location for block in graph_of(studio).shot(1, 1).blocking}
    assert now["tom"][0] > where["tom"][0] + 0.1 and now["tom"][1] < where["tom"][1] - 0.05
    assert now["ada"] == pytest.approx(where["ada"], abs=0.01)
    undo(stage)
    assert graph_of(studio) == before, "byte for byte"


def test_a_drag_that_is_given_up_changes_nothing(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = graph_of(studio)
    drag(stage, "tom", (60, 40), cancel=True)
    stage.wait_for_timeout(500)
    assert graph_of(studio) == before


def test_a_thing_is_turned_by_a_key(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    layout = graph_of(studio).scene(1).layout
    assert layout is not None
    table = next(item for item in layout.objects if "table" in item.node_id)
    x, y = point_on(stage, table.node_id)
    stage.mouse.click(x, y)
    stage.locator(".frame canvas").focus()
    chosen = in_page(stage, "return view.scene.chosen;")
    with shown_anew(stage):
        stage.keyboard.press("[")
        expect(said(stage)).to_contain_text("turned")
    turned = graph_of(studio).scene(1).layout
    assert turned is not None
    was, now = (next(item for item in each.objects if item.node_id == chosen) for each in (layout, turned))
    assert (now.rotation[2] - was.rotation[2]) % 360 == pytest.approx(15)
    undo(stage)


def test_a_person_is_seated_made_to_look_and_given_a_thing(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = graph_of(studio)
    stage.mouse.click(*point_on(stage, "tom"))
    pose = stage.get_by_role("group", name="Pose of")
    expect(pose).to_be_visible()
    for label, choice, told in (("Posture", "sit", "sitting"), ("Looks", "ada", "looking at ada")):
        with shown_anew(stage):
            pose.get_by_label(label).select_option(choice)
            expect(said(stage)).to_contain_text(told)
    [tom] = [each for each in graph_of(studio).shot(1, 1).blocking if each.start.asset_id == "tom"]
    assert tom.start.posture == "sit" and tom.start.support_id in stage.get_by_label("On").locator(
        "option"
    ).evaluate_all("options => options.map((option) => option.value)")
    assert pose.get_by_label("Posture").input_value() == "sit" and pose.get_by_label("Looks").input_value() == "ada"
    with shown_anew(stage):
        pose.get_by_label("Does from here").fill("wave")
        pose.get_by_label("Does from here").press("Enter")
        expect(said(stage)).to_contain_text("does wave")
    assert "wave" in {cue.clip for cue in graph_of(studio).shot(1, 1).cues if cue.asset_id == "tom"}
    for _ in range(3):
        undo(stage)
    assert graph_of(studio) == before, "byte for byte"


def test_a_camera_is_taken_by_hand(stage: Page, studio: RunningStudio) -> None:
    look(stage, "Free")
    box = stage.locator(".frame canvas").bounding_box()
    assert box is not None
    stage.mouse.move(box["x"] + 20, box["y"] + 20)
    stage.mouse.wheel(0, 400)
    stage.wait_for_timeout(500)
    pose = in_page(stage, "return view.scene.freePose;")
    with shown_anew(stage):
        stage.get_by_role("button", name="Shoot from here").click()
        expect(said(stage)).to_contain_text("by hand")
    camera = graph_of(studio).shot(1, 1).camera
    assert camera is not None
    orbit = camera_at(camera, 0, Film(camera.sensor_width))
    assert np.asarray(orbit.position) == pytest.approx(np.asarray(pose["location"]), abs=1e-3)
    undo(stage)


def test_another_staging_is_chosen_among_pictures(stage: Page, studio: RunningStudio) -> None:
    before = graph_of(studio)
    stage.get_by_role("button", name="Other stagings").click()
    dialog = stage.get_by_role("dialog", name="Stagings of")
    pictures = dialog.locator("img")
    expect(pictures.first).to_be_visible(timeout=2 * LOADED)
    assert graph_of(studio) == before, "nothing is changed by looking"
    assert all(pictures.evaluate_all("all => all.map((each) => each.complete && each.naturalWidth > 100)"))
    with shown_anew(stage):
        dialog.get_by_role("button", name="Choose staging").first.click()
        expect(said(stage)).to_contain_text("staging")
    assert graph_of(studio).scene(1).layout != before.scene(1).layout
    undo(stage)
    assert graph_of(studio) == before, "byte for byte"


def test_a_lost_context_comes_back(stage: Page) -> None:
    before = look(stage, "From above")
    in_page(
        stage,
        "const lost = view.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');"
        "lost.loseContext(); setTimeout(() => lost.restoreContext(), 300);",
    )
    stage.wait_for_timeout(2500)
    assert np.abs(look(stage, "From above") - before).mean() < 3


def test_the_stage_has_no_faults_of_access(stage: Page) -> None:
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(stage)
    assert not found.violations_count, found.generate_report()
