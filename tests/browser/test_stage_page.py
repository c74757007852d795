"""The stage in a real browser: what Blender draws is what it shows; things, people and cameras are moved by hand."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect

from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film, project
from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import (
    LOADED,
    SHOT,
    drag,
    graph_of,
    in_page,
    look,
    point_on,
    project_of,
    rested,
    said,
    shown_anew,
    undo,
)


def test_every_view_shows_a_picture_of_its_own(stage: Page) -> None:
    views = [look(stage, name) for name in ("Through the camera", "Free", "From above")]
    assert all(view.std() > 12 for view in views), "a picture, not one colour"
    assert np.abs(views[0][:300, :600] - views[2][:300, :600]).mean() > 10


def test_walls_before_the_free_camera_are_cut_away_and_come_back(stage: Page) -> None:
    look(stage, "Free")
    go = "view.scene.freeCamera.position.set(...values); view.scene.free.target.set(0, 0, 1); view.scene.free.update();"
    hidden = """const model = view.scene.model;
        return model.setPieces.filter((piece) => !model.nodes.get(piece)[0].visible);"""
    begins = in_page(stage, "return view.scene.freeCamera.position.toArray();")
    for eye in ([0, -14, 7], [13, 2, 8], [-9, 12, 4], [1, 1, 15]):
        in_page(stage, go, *eye)
        stage.wait_for_timeout(600)
        gone = in_page(stage, hidden)
        assert gone and not any(piece.startswith("floor") for piece in gone), eye
        for person in ("ada", "tom"):
            x, y = point_on(stage, person)
            ray = "view.scene.ray({clientX: values[0], clientY: values[1]})"
            assert in_page(stage, f"return view.scene.model.under({ray}, false)?.node ?? null;", x, y), (eye, person)
        assert look(stage, "Free").std() > 12
    in_page(stage, go, 0.5, -0.5, 1.6)
    stage.wait_for_timeout(600)
    assert not in_page(stage, hidden), "among the people every wall stands"
    in_page(stage, go, *begins)


def test_a_message_lies_over_the_page_and_nothing_shifts(stage: Page) -> None:
    look(stage, "From above")
    room, tom = stage.locator(".room").bounding_box(), point_on(stage, "tom")
    expect(said(stage)).to_have_count(0)
    stage.get_by_role("button", name="Warmer").click()
    expect(said(stage)).to_contain_text("warmth")
    assert stage.locator(".room").bounding_box() == room and point_on(stage, "tom") == pytest.approx(tom, abs=1)
    undo(stage)
    said(stage).get_by_role("button", name="Dismiss").click()
    expect(said(stage)).to_have_count(0)


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


def test_a_person_who_is_dragged_stands_there_and_undo_brings_them_back(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = graph_of(studio)
    end = in_page(stage, "return view.scene.stage.people.tom.now;")
    where = {block.start.asset_id: getattr(block, end).location for block in before.shot(1, 1).blocking}
    with shown_anew(stage):
        drag(stage, "tom", (30, 20))
        expect(said(stage)).to_contain_text(f"Tom {end}s")
    now = {block.start.asset_id: getattr(block, end).location for block in graph_of(studio).shot(1, 1).blocking}
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
    for label, choice, told in (("Posture", "sit", "sitting"), ("Looks", "ada", "looking at Ada")):
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
    camera = rested(studio).shot(1, 1).camera
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
