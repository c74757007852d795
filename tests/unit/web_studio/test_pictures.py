"""Surfaces and panoramas of the folder and of the library on the page: listed, seen, chosen, undone."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from starlette.testclient import TestClient
from tests.panoramas import write_sky
from tests.textures import write_surface
from tests.unit.web_studio.test_assets import browser, hub  # noqa: F401
from tests.unit.web_studio.test_wire import Browser

from storyblender.library.shared.entries import EntryFacts, LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit
from storyblender.project import read_project_graph

INSIDE = "SC010"


@pytest.fixture
def kept(tmp_path: Path) -> dict[str, LibraryEntry]:
    credit = Credit(author="Ann Joiner", license="CC0-1.0")
    write_surface(tmp_path / "bundle", "color").joinpath("color_diff_1k.png").rename(tmp_path / "bundle/color.png")
    (tmp_path / "sky").mkdir()
    write_sky(tmp_path / "sky/panorama.hdr")
    facts: list[dict[str, Any]] = [
        {"kind": "texture", "name": "Oak Boards", "main": "color.png", "source_id": "oak-1k"},
        {"kind": "panorama", "name": "Meadow", "main": "panorama.hdr", "source_id": "meadow-2k"},
    ]
    library = SharedLibrary.open()
    return {
        each["kind"]: library.add(EntryFacts(credit=credit, source="poly_haven", **each), tmp_path / folder)
        for each, folder in zip(facts, ("bundle", "sky"), strict=True)
    }


def seen(browser: Browser, address: str) -> tuple[int, int]:  # noqa: F811
    client: TestClient = browser.client  # type: ignore[attr-defined]
    return Image.open(io.BytesIO(client.get(address).content)).size


def test_walls_are_made_of_a_surface_of_the_library(
    browser: Browser,  # noqa: F811
    folder: Path,
    kept: dict[str, LibraryEntry],
) -> None:
    (card,) = browser.value("pictures", kind="texture", words="oak")
    assert (card["name"], card["credit"], card["source"]) == ("Oak Boards", "Ann Joiner, CC0-1.0", "your library")
    assert seen(browser, card["picture"]) == (64, 64)
    assert browser.value("library", words="oak")["cards"][0]["picture"] == card["picture"]
    before = read_project_graph(folder)
    told = browser.value("surface", scene=INSIDE, part="walls", entry=card["entry"])
    assert told["stale"]
    assert browser.value("scene", scene=INSIDE)["surfaces"]["walls"] == card["named"] == "poly_haven/oak-1k"
    browser.value("undo")
    assert read_project_graph(folder) == before
    wrong = browser.call("surface", scene=INSIDE, part="walls", entry=kept["panorama"].digest)
    assert not wrong["ok"] and "no such texture" in wrong["error"]


def test_the_ground_is_made_of_a_picture_of_the_folder(browser: Browser, folder: Path) -> None:  # noqa: F811
    write_surface(folder.parent / "woods")
    (card,) = [each for each in browser.value("pictures", kind="texture") if each["file"]]
    assert card["file"] == "woods/oak_boards_diff_1k.png", "other maps of a surface are none"
    assert card["name"] == "oak boards"
    assert seen(browser, card["picture"]) == (64, 64)
    browser.value("surface", scene=INSIDE, part="ground", file=card["file"], metres=1.5)
    scene = browser.value("scene", scene=INSIDE)
    assert (scene["surfaces"]["ground"], scene["repeats"]["ground"]) == (card["named"], 1.5)
    browser.value("surface", scene=INSIDE, part="ground", metres=0.4)
    scene = browser.value("scene", scene=INSIDE)
    assert (scene["surfaces"]["ground"], scene["repeats"]["ground"]) == (card["named"], 0.4)
    browser.value("undo")
    assert browser.value("scene", scene=INSIDE)["repeats"]["ground"] == 1.5
    assert "no picture on the walls" in browser.call("surface", scene=INSIDE, part="walls", metres=1)["error"]
    client: TestClient = browser.client  # type: ignore[attr-defined]
    for name in ("home.fountain", "..%2Fsecret.png", "p/graph.json", "woods/oak_boards_rough_1k.jpg"):
        assert client.get(f"/folder/{name}").status_code == 404
    refused = browser.call("surface", scene=INSIDE, part="ground", file="../secret.png")
    assert not refused["ok"] and "no surface" in refused["error"]


def test_an_exterior_is_lit_by_a_panorama_of_the_library(browser: Browser, kept: dict[str, LibraryEntry]) -> None:  # noqa: F811
    (card,) = browser.value("pictures", kind="panorama")
    assert card["entry"] == kept["panorama"].digest and seen(browser, card["picture"]) == (256, 128)
    scene = next(each["scene"] for each in browser.value("board")["scenes"] if is_outside(browser, each["scene"]))
    browser.value("panorama", scene=scene, entry=card["entry"])
    for hour in ("noon", "night"):
        browser.value("apply", edits=[{"kind": "light", "scene": scene, "decision": {"time_of_day": hour}}])
        told = browser.value("scene", scene=scene)
        assert told["panorama"] == card["named"] and any("panorama" in each for each in told["decided"])
        assert told["panorama_rests"] == (hour == "night")


def is_outside(browser: Browser, scene: str) -> bool:  # noqa: F811
    return browser.value("scene", scene=scene)["outdoors"]
