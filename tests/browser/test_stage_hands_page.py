"""The stage by hand: rings, surfaces, cameras, lamps, ways and numbers; what a hand has done stays where it was put."""

from __future__ import annotations

import math

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import Blocking
from tests.browser.conftest import RunningStudio
from tests.browser.stage_page import SHOT, drag, graph_of, in_page, look, point_on, rested, said, shown_anew, undo

BESIDE_LAMP = (0, 28)
"""Pixels from the middle of the table, over which a lamp hangs."""


def item(studio: RunningStudio, node: str) -> LayoutObject:
    layout = graph_of(studio).scene(1).layout
    assert layout is not None
    return next(each for each in layout.objects if node in each.node_id)


def blocking(studio: RunningStudio, person: str, shot: int = 1) -> Blocking:
    return next(each for each in graph_of(studio).shot(1, shot).blocking if each.start.asset_id == person)


def exactly(page: Page, label: str) -> Locator:
    return page.get_by_role("group", name="Exactly").get_by_label(label, exact=True).first


def choose(page: Page, node: str, aside: tuple[int, int] = (0, 0)) -> None:
    x, y = point_on(page, node)
    page.mouse.click(x + aside[0], y + aside[1])
    expect(page.get_by_role("group", name="Exactly")).to_be_visible()
    assert in_page(page, "return view.scene.chosen;") == node


def test_a_thing_is_turned_by_its_ring(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    table = item(studio, "table")
    choose(stage, table.node_id, BESIDE_LAMP)
    stage.wait_for_timeout(300)
    (x, y), (middle_x, middle_y) = point_on(stage, f"turn:{table.node_id}"), point_on(stage, table.node_id)
    quarter = middle_x + (y - middle_y), middle_y - (x - middle_x)  # counter-clockwise as the plan is seen
    with shown_anew(stage):
        stage.mouse.move(x, y)
        stage.mouse.down()
        stage.mouse.move(*quarter, steps=5)
        stage.wait_for_timeout(400)
        turned = in_page(stage, f"return view.scene.stage.placed['{table.node_id}'].rotation;")
        stage.mouse.up()
        expect(said(stage)).to_contain_text("turned")
    assert (turned - table.rotation[2]) % 360 == pytest.approx(90, abs=1)
    assert item(studio, "table").rotation[2] == pytest.approx(turned, abs=0.01)
    undo(stage)
    assert graph_of(studio) == before, "byte for byte"


def test_what_is_dropped_on_a_table_stands_on_it(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    basket = next(node for node, rests, height in _placed(stage) if rests == "surface" and height < 0.1)
    start, table = point_on(stage, basket), point_on(stage, item(studio, "table").node_id)
    away = (round(table[0] - start[0]), round(table[1] - start[1] + BESIDE_LAMP[1]))
    with shown_anew(stage):
        drag(stage, basket, away)
        height = in_page(stage, "return view.scene.stage.placed[values[0]].location[2];", basket)
        expect(said(stage)).to_contain_text(" placed")
    now = item(studio, basket)
    assert now.location[2] == pytest.approx(height, abs=0.03), "where the page has shown it"
    assert now.location[2] > 0.4
    undo(stage)
    assert graph_of(studio) == before


def _placed(page: Page) -> list[tuple[str, str, float]]:
    return in_page(page, "return Object.entries(view.stage.placed).map(([k, v]) => [k, v.rests, v.location[2]]);")


def test_nothing_snaps_back_before_the_new_scene_is_there(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    where = "return view.scene.model.box(values[0]).getCenter(view.scene.model.box(values[0]).min.clone()).toArray();"
    before = in_page(stage, where, "tom")
    with shown_anew(stage):
        drag(stage, "tom", (40, 0))
        places = []
        for _ in range(12):
            places.append(in_page(stage, where, "tom")[0])
            stage.wait_for_timeout(100)
    assert all(place > before[0] + 0.1 for place in places), places
    assert in_page(stage, where, "tom")[0] == pytest.approx(places[-1], abs=0.15), "nor when it is there"
    undo(stage)


def test_a_drop_that_is_refused_goes_back_with_a_sentence(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    stage.get_by_role("button", name="Lock the shot").click()
    expect(said(stage)).to_contain_text("locked")
    where = "return view.scene.model.box(values[0]).min.toArray();"
    stage.wait_for_timeout(500)
    before, graph = in_page(stage, where, "tom"), rested(studio)
    drag(stage, "tom", (60, 0))
    expect(said(stage)).to_contain_text("is locked")
    stage.wait_for_timeout(1500)
    assert in_page(stage, where, "tom") == pytest.approx(before, abs=1e-6)
    assert graph_of(studio) == graph
    undo(stage)


def test_a_camera_is_dragged_in_the_plan_and_keeps_what_it_looks_at(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    was = in_page(stage, "return view.scene.stage.cameras[0].keys[0];")
    with shown_anew(stage):
        drag(stage, f"camera:{SHOT}:start", (-30, 25))
        expect(said(stage)).to_contain_text("by hand")
    decision = graph_of(studio).shot(1, 1).camera_decision
    assert decision is not None and decision.placed is not None
    place = decision.placed.start
    world = np.reshape(was["world"], (4, 4))
    assert math.dist(place.location[:2], world[:2, 3]) > 0.2 and place.location[2] == pytest.approx(
        world[2, 3], abs=0.01
    )
    assert np.asarray(place.target) == pytest.approx(world[:3, 3] - world[:3, 2] * was["distance"], abs=0.01)
    undo(stage)
    assert rested(studio) == before


def test_a_lamp_is_dragged_and_dimmed(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    name = in_page(stage, "return Object.entries(view.stage.lamps).find(([, lamp]) => lamp.kind !== 'SUN')[0];")
    with shown_anew(stage):
        drag(stage, f"lamp:{name}", (25, 10))
        expect(said(stage)).to_contain_text(name.replace("_", " "))
    with shown_anew(stage):
        exactly(stage, "Power").fill("5")
        exactly(stage, "Power").press("Enter")
        expect(said(stage)).to_contain_text("5")
    decision = graph_of(studio).scene(1).light_decision
    assert decision is not None
    lamp = decision.lamps[name]
    assert lamp is not None and lamp.power == 5 and lamp.location is not None
    undo(stage)
    undo(stage)
    assert graph_of(studio) == before


def test_a_person_is_sent_somewhere_through_a_way_point(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    choose(stage, "tom")
    stage.wait_for_timeout(300)
    with shown_anew(stage):
        drag(stage, "mark:tom:end", (-20, 60))
        expect(said(stage)).to_contain_text("Tom ends")
    assert math.dist(blocking(studio, "tom").start.location, blocking(studio, "tom").end.location) > 0.3
    way = in_page(stage, "return view.scene.stage.people.tom.walks[0];")
    middle = way[len(way) // 2]
    x, y = in_page(
        stage,
        "const p = view.scene.scene.position.clone().set(values[0], values[1], 0).project(view.scene.planCamera);"
        "return [(p.x + 1) / 2, (1 - p.y) / 2];",
        *middle,
    )
    box = stage.locator(".frame canvas").bounding_box()
    assert box is not None
    with shown_anew(stage):
        stage.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"])
        stage.mouse.down()
        stage.mouse.move(box["x"] + x * box["width"] + 25, box["y"] + y * box["height"] + 5, steps=4)
        stage.mouse.up()
        expect(said(stage)).to_contain_text("Tom walks through")
    [via] = in_page(stage, "return view.stage.people.tom.via;")
    assert math.dist(via, middle) > 0.1
    with shown_anew(stage):
        stage.get_by_role("group", name="Exactly").get_by_role("button", name="Take away").click()
        expect(said(stage)).to_contain_text("crew's way")
    for _ in range(3):
        undo(stage)
    assert graph_of(studio) == before


def test_a_thing_is_moved_by_numbers_and_keys_doubled_and_taken_away(stage: Page, studio: RunningStudio) -> None:
    look(stage, "From above")
    before = rested(studio)
    table = item(studio, "table").node_id
    choose(stage, table, BESIDE_LAMP)
    with shown_anew(stage):
        exactly(stage, "X").fill(str(round(item(studio, "table").location[0] + 0.25, 3)))
        exactly(stage, "X").press("Enter")
        expect(said(stage)).to_contain_text("placed")
    stage.locator(".frame canvas").focus()
    count = len(_placed(stage))
    with shown_anew(stage):
        stage.keyboard.press("Control+d")
        expect(said(stage)).to_contain_text("added")
    assert len(_placed(stage)) == count + 1
    undo(stage)
    undo(stage)
    assert graph_of(studio) == before


def test_the_camera_has_lens_aperture_and_focus(stage: Page, studio: RunningStudio) -> None:
    look(stage, "Free")
    before = rested(studio)
    box = stage.locator(".frame canvas").bounding_box()
    assert box is not None
    stage.mouse.click(box["x"] + 4, box["y"] + 4)
    with shown_anew(stage):
        stage.get_by_role("group", name="Exactly").get_by_label("Aperture").select_option("1.4")
        expect(said(stage)).to_contain_text("f number 1.4")
    with shown_anew(stage):
        stage.get_by_role("group", name="Exactly").get_by_label("Focus", exact=True).select_option("ada")
        expect(said(stage)).to_contain_text("focus Ada")
    stage.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    stage.mouse.wheel(0, 300)
    with shown_anew(stage):
        stage.get_by_role("button", name="End here").click()
        expect(said(stage)).to_contain_text("by hand")
    camera = rested(studio).shot(1, 1).camera
    assert camera is not None and len(camera.poses) > 1 and camera.f_number == pytest.approx(1.4)
    for _ in range(3):
        undo(stage)
    assert graph_of(studio) == before


def test_the_picture_of_the_film_is_chosen_beside_the_lens(stage: Page, studio: RunningStudio) -> None:
    look(stage, "Through the camera")
    before = rested(studio)
    film = stage.get_by_role("group", name="The whole film")
    for label, wanted, field in (("Picture", 2.39, "aspect"), ("Sensor", 24.89, "sensor_width")):
        with shown_anew(stage):
            film.get_by_label(label).select_option(str(wanted))
            expect(said(stage)).to_contain_text("film: ")
        assert getattr(graph_of(studio).format, field) == wanted
    now = rested(studio)
    assert {shot.camera.sensor_width for shot in now.shots if shot.camera} == {24.89}
    box = stage.locator(".frame canvas").bounding_box()
    assert box is not None and box["width"] / box["height"] == pytest.approx(2.39, rel=0.01), "with it the safe areas"
    expect(film.get_by_label("Sensor")).to_have_value("24.89")
    for _ in range(2):
        undo(stage)
    assert graph_of(studio) == before
