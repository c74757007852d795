"""People and things as the page is told of them, on a stand-in engine: pictures and models are made once."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from tests.unit.web_studio.test_wire import Browser

from storyblender.web_studio.app import build_app
from storyblender.web_studio.hub import Hub


@pytest.fixture
def hub(folder: Path) -> Iterator[Hub]:
    hub = Hub(folder.parent)
    hub.open(folder.name)
    yield hub
    hub.close()


@pytest.fixture
def browser(hub: Hub) -> Iterator[Browser]:
    with TestClient(build_app(hub)) as client, client.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.client = client  # type: ignore[attr-defined]
        yield browser


def card(browser: Browser, asset: str) -> dict[str, Any]:
    return next(each for each in browser.value("assets")["cards"] if each["asset"] == asset)


def test_people_come_first_and_each_is_told_where_it_is_seen(browser: Browser) -> None:
    cards = browser.value("assets")["cards"]
    assert [each["sort"] for each in cards] == sorted(
        (each["sort"] for each in cards), key=["person", "thing", "furniture"].index
    )
    tom = browser.value("asset", asset="tom")
    assert tom["name"] and tom["look"]["garments"] and {each["scene"] for each in tom["shown_in"]} == {"SC010", "SC020"}


def test_a_picture_is_drawn_once_and_anew_after_an_edit(hub: Hub, browser: Browser) -> None:
    assert card(browser, "tom")["picture"] == ""
    first = browser.value("asset_picture", asset="tom")
    assert browser.client.get(first).status_code == 200  # type: ignore[attr-defined]
    assert card(browser, "tom")["picture"] == first == browser.value("asset_picture", asset="tom")
    coat = {"kind": "look", "person": "tom", "wear": [{"key": "coat", "color": [0.6, 0, 0]}]}
    browser.value("apply", edits=[coat])
    assert card(browser, "tom")["picture"] == ""
    assert browser.value("asset_picture", asset="tom") != first
    browser.value("undo")
    assert card(browser, "tom")["picture"] == first
    assert hub.place.session._engine.calls["portrait"] == 2  # type: ignore[attr-defined]


def test_a_model_is_named_by_what_it_shows(browser: Browser) -> None:
    first = browser.value("asset_model", asset="letter")
    assert browser.client.get(first).status_code == 200  # type: ignore[attr-defined]
    assert first != browser.value("asset_model", asset="tom")
    assert not browser.call("asset_model", asset="letter", as_in_file=True)["ok"], "it is no model of the user"


def test_what_a_thing_could_be_is_offered_with_pictures_and_taken(browser: Browser) -> None:
    offered = browser.value("candidates", asset="letter", words="vase")
    assert offered[0]["model"] == "vase" and not any(each["chosen"] for each in offered)
    about = {"asset": "letter", "words": "vase"}
    picture = browser.value("asset_picture", **about, digest=offered[0]["digest"])
    assert browser.client.get(picture).status_code == 200  # type: ignore[attr-defined]
    assert browser.value("candidates", **about)[0]["picture"] == picture
    browser.value("apply", edits=[{"kind": "asset", "thing": "letter", "model": "vase"}])
    details = browser.value("asset", asset="letter")
    assert details["made_from"] == "vase" and details["decisions"] == ["made from vase"]


def test_what_is_painted_is_told_and_drawn_anew(browser: Browser) -> None:
    before = browser.value("asset_picture", asset="letter")
    browser.value("apply", edits=[{"kind": "paint", "thing": "letter", "look": {"color": [1.0, 0.0, 0.0]}}])
    details = browser.value("asset", asset="letter")
    assert details["painted"] and details["color"] == "#ff0000" and "painted" in details["decisions"][0]
    assert card(browser, "letter")["picture"] == "" and browser.value("asset_picture", asset="letter") != before
    browser.value("undo")
    assert card(browser, "letter")["picture"] == before and not browser.value("asset", asset="letter")["painted"]


def test_nothing_but_pictures_and_models_of_assets_is_served(browser: Browser) -> None:
    for name in ("..%2F..%2Fgraph.json", "graph.json", "0123456789abcdef.json", "ffffffffffffffff.png"):
        assert browser.client.get(f"/cast/{name}").status_code == 404  # type: ignore[attr-defined]
    assert not browser.call("asset", asset="nobody")["ok"]
