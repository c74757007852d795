"""The user's library as the page is told of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from starlette.testclient import TestClient
from tests.unit.web_studio.test_assets import browser, hub  # noqa: F401
from tests.unit.web_studio.test_wire import Browser

from storyblender.library.shared.entries import EntryFacts, LibraryEntry
from storyblender.library.shared.shared_library import THUMBNAILS, SharedLibrary
from storyblender.library.shared.uses import Use
from storyblender.memory.asset_sheet import Credit


@pytest.fixture
def chair(tmp_path: Path) -> LibraryEntry:
    (tmp_path / "it").mkdir()
    (tmp_path / "it/chair.glb").write_bytes(b"a chair")
    credit = Credit(author="Ann <b>", license="CC0-1.0", url="javascript:alert(1)")
    facts = EntryFacts(kind="model", name="Arm Chair", main="chair.glb", credit=credit, source="museum")
    return SharedLibrary.open().add(facts, tmp_path / "it")


def test_entries_are_told_with_author_licence_and_use(browser: Browser, chair: LibraryEntry) -> None:  # noqa: F811
    uses = [Use(asset="seat", model="m", name="seat", category="furniture", origin="library", entry=chair.digest)]
    SharedLibrary.open().uses.note("/home/ann/two_cups.storyboard", uses)
    told = browser.value("library")
    (card,) = told["cards"]
    assert (card["name"], card["author"], card["licence"], card["used"]) == (
        "Arm Chair",
        "Ann <b>",
        "CC0-1.0",
        ["two_cups"],
    )
    assert card["url"] == "" and card["picture"] == "", "only addresses of the web become links"
    assert "100 %" in told["figures"]
    assert browser.value("library", words="sofa") == {"cards": [], "found": 0, "figures": told["figures"]}


def test_a_picture_is_served_and_nothing_else_of_the_library(browser: Browser, chair: LibraryEntry) -> None:  # noqa: F811
    SharedLibrary.open().files.write(f"{THUMBNAILS}/{chair.digest}.png", b"a picture")
    (card,) = browser.value("library")["cards"]
    client: TestClient = browser.client  # type: ignore[attr-defined]
    assert client.get(card["picture"]).content == b"a picture"
    for address in ("/library/index.sqlite", f"/library/{'0' * 64}.png", "/library/..%2findex.png"):
        assert client.get(address).status_code == 404


def test_the_picture_of_a_model_is_drawn_once_and_kept_in_the_library(browser: Browser, chair: LibraryEntry) -> None:  # noqa: F811
    address = browser.value("library_picture", digest=chair.digest)
    assert SharedLibrary.open().picture(chair.digest).is_file()
    assert browser.value("library")["cards"][0]["picture"] == address
    assert browser.client.get(address).status_code == 200  # type: ignore[attr-defined]
    assert not browser.call("library_picture", digest="0" * 64)["ok"]
