"""What a catalogue offers for a thing is shown on the page with our pictures of its pictures, chosen, and undone."""

from __future__ import annotations

import io
import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from starlette.testclient import TestClient

from storyblender.settings import REMEMBERED
from storyblender.web_studio.app import build_app
from storyblender.web_studio.hub import Hub
from tests.model_files import tile
from tests.services.catalogue_sites import Haven, open_poly_haven
from tests.services.site import Late, Reply, Site, serving
from tests.unit.conftest import folder, made  # noqa: F401
from tests.unit.web_studio.test_wire import Browser

VASE = "poly_haven/ceramic_vase_03-1k/model.gltf"
JUG = "poly_haven/ceramic_vase_04-1k/model.gltf"


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        pictures = {"03": Reply(tile(3)), "04": Reply(b"<script>alert(1)</script>")}
        site.pages |= {f"/{number}.png": page for number, page in pictures.items()}
        vases = [
            Haven(f"ceramic_vase_{number}", f"Ceramic Vase {number}", thumbnail=f"{site.address}/{number}.png")
            for number in pictures
        ]
        open_poly_haven(site, vases)
        yield site


@pytest.fixture
def browser(site: Site, folder: Path) -> Iterator[Browser]:  # noqa: F811
    with looking(folder, f"poly_haven@{site.address}") as browser:
        yield browser


@contextmanager
def looking(folder: Path, services: str) -> Iterator[Browser]:  # noqa: F811
    """Open a project that asks some services on the page."""
    made_with = folder / REMEMBERED
    settings = json.loads(made_with.read_text()) | {"services": services}
    made_with.write_text(json.dumps(settings))
    hub = Hub(folder.parent)
    hub.open(folder.name)
    with TestClient(build_app(hub)) as client, client.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.client = client  # type: ignore[attr-defined]
        yield browser
    hub.close()


def offers(browser: Browser, **about: str) -> dict[str, Any]:
    """Return what is offered once every service has answered or failed."""
    end = time.monotonic() + 20
    while (shown := browser.value("offers", **about))["waiting"]:
        assert time.monotonic() < end, "it is still waited for"
        time.sleep(0.05)
    return shown


def test_an_offer_is_seen_chosen_and_undone(browser: Browser, site: Site) -> None:
    about = {"asset": "letter", "words": "vase"}
    shown = offers(browser, **about)
    assert shown["services"] == ["poly_haven"]
    cards = {each["file"]: each for each in shown["cards"]}
    assert (cards[VASE]["name"], cards[VASE]["source"], cards[VASE]["credit"], cards[VASE]["picture"]) == (
        "Ceramic Vase 03", "poly_haven", "Rico Cilliers, Greg Zaal, CC0-1.0", "",
    )  # fmt: skip
    address = browser.value("offer_picture", asset="letter", file=VASE)
    answer = browser.client.get(address)  # type: ignore[attr-defined]
    assert Image.open(io.BytesIO(answer.content)).size == (64, 64)
    assert browser.value("offer_picture", asset="letter", file=JUG) == "", "what is no picture is not passed on"
    offers(browser, **about)
    assert browser.value("offer_picture", asset="letter", file=VASE) == address
    assert site.count("/03.png") == 1 and site.count("/dl/") == 0, "looking fetches no model"
    told = browser.value("take_offer", thing="letter", file=VASE)
    assert "is made from ceramic vase 03 of Poly Haven" in told["words"] and told["stale"]
    details = browser.value("asset", asset="letter")
    assert details["made_from"] == VASE and details["credit"]["license"] == "CC0-1.0"
    ours = next(each for each in browser.value("candidates", **about) if each["file"] == VASE)
    assert (ours["name"], ours["source"], ours["chosen"]) == ("Ceramic Vase 03", "your library, from Poly Haven", True)
    assert VASE not in {each["file"] for each in offers(browser, **about)["cards"]}, "it is not offered twice"
    browser.value("undo")
    assert browser.value("asset", asset="letter")["made_from"] != VASE


def test_what_was_not_offered_is_refused(browser: Browser) -> None:
    answer = browser.call("take_offer", thing="letter", file="poly_haven/../../secret-1k/model.gltf")
    assert not answer["ok"] and "not offered" in answer["error"]


def test_a_service_that_never_answers_holds_nobody_up(site: Site, folder: Path) -> None:  # noqa: F811
    site.pages["/search"] = Late(60)
    about = {"asset": "letter", "words": "vase"}
    with looking(folder, f"sketchfab@{site.address},poly_haven@{site.address}") as browser:
        begun = time.monotonic()
        assert browser.value("candidates", **about)
        browser.value("offers", **about)
        browser.value("board")
        assert time.monotonic() - begun < 4, "what is here does not wait for a service"
        shown = offers(browser, **about)
        assert time.monotonic() - begun < 12
        assert {each["source"] for each in shown["cards"]} == {"poly_haven"}
        assert shown["failures"] == ["Sketchfab: it does not answer"]
        assert browser.value("offers", **about)["failures"] == shown["failures"], "told again, not asked again"
        assert site.count("/search") == 1


def test_a_service_that_is_gone_is_told_of_in_one_line(folder: Path) -> None:  # noqa: F811
    with looking(folder, "poly_haven@http://127.0.0.1:1") as browser:
        shown = offers(browser, asset="letter", words="vase")
    assert (shown["cards"], shown["failures"]) == ([], ["Poly Haven: it cannot be reached"])
