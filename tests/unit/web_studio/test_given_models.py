"""Models that a person sends from their disk: kept under a name that no other has, read, chosen; or refused."""

from __future__ import annotations

from pathlib import Path, PurePosixPath
from typing import Any

import pytest
from starlette.testclient import TestClient
from tests.model_files import box_gltf, glb_of, tile
from tests.stand_in_engine import StandInEngine
from tests.unit.web_studio.test_assets import browser, hub  # noqa: F401
from tests.unit.web_studio.test_wire import Browser

from storyblender.errors import EngineError
from storyblender.web_studio import uploads
from storyblender.web_studio.access import Door
from storyblender.web_studio.app import build_app
from storyblender.web_studio.hub import Hub

BATCH = "0123456789abcdef"
WHOLE = box_gltf((0.4, 0.3, 0.5), name="crate")
GLB = glb_of(WHOLE)
BOX = {PurePosixPath(name).name: content for name, content in WHOLE.items()}
PICTURE = next(name for name in BOX if name.endswith(".png"))


def sent(browser: Browser, name: str, content: bytes, batch: str = BATCH) -> Any:  # noqa: F811
    client: TestClient = browser.client  # type: ignore[attr-defined]
    return client.post(f"/models/{batch}/{name}", content=content)


def chosen(browser: Browser, **files: bytes) -> dict[str, Any]:  # noqa: F811
    """Send the files of a model and have the letter made from it."""
    for name, content in files.items():
        assert sent(browser, name, content).status_code == 204
    return browser.call("take_model", thing="letter", batch=BATCH)


def made_from(browser: Browser) -> str:  # noqa: F811
    return browser.value("asset", asset="letter")["made_from"]


def test_a_model_is_kept_in_the_project_chosen_and_undone(browser: Browser, folder: Path) -> None:  # noqa: F811
    before = made_from(browser)
    answer = chosen(browser, **{"old crate.glb": GLB})
    assert answer["ok"] and answer["value"]["stale"], answer
    assert made_from(browser) == "old crate.glb"
    assert (folder / "models/old crate.glb").read_bytes() == GLB
    found = browser.value("candidates", asset="letter", words="old crate")
    assert any(each["file"] == "old crate.glb" and each["source"] == "your folders" for each in found)
    browser.value("undo")
    assert made_from(browser) == before and (folder / "models/old crate.glb").is_file()


def test_no_file_is_written_over_and_the_same_is_kept_once(browser: Browser, folder: Path) -> None:  # noqa: F811
    other = glb_of(box_gltf((1.0, 1.0, 1.0)))
    assert chosen(browser, **{"crate.glb": GLB})["ok"] and made_from(browser) == "crate.glb"
    assert chosen(browser, **{"Crate.glb": other})["ok"] and made_from(browser) == "Crate_2.glb"
    assert chosen(browser, **{"crate.glb": GLB})["ok"] and made_from(browser) == "crate.glb"
    assert sorted(each.name for each in (folder / "models").iterdir()) == ["Crate_2.glb", "crate.glb"]
    assert (folder / "models/crate.glb").read_bytes() == GLB


def test_the_files_that_a_model_names_come_with_it(browser: Browser, folder: Path) -> None:  # noqa: F811
    assert b"textures/" in BOX["crate.gltf"] and chosen(browser, **BOX)["ok"]
    assert made_from(browser) == "crate/crate.gltf"
    assert (folder / "models/crate/textures" / PICTURE).read_bytes() == BOX[PICTURE]
    assert not (folder / "models/crate" / PICTURE).exists()
    answer = chosen(browser, **{"table.gltf": BOX["crate.gltf"], PICTURE: tile(2)})
    assert not answer["ok"] and "'crate.bin', which was not given" in answer["error"]
    assert not (folder / "models/table").exists()


def test_a_model_leads_out_of_no_folder(browser: Browser, folder: Path) -> None:  # noqa: F811
    for uri in ("../../graph.json", "/etc/passwd", "a%00b/crate.bin", "C:crate.bin"):
        gltf = BOX["crate.gltf"].replace(b'"crate.bin"', f'"{uri}"'.encode())
        assert gltf != BOX["crate.gltf"]
        chosen(browser, **{**BOX, "crate.gltf": gltf})
    kept = [each.name for each in (folder / "models").rglob("*.*")]
    assert {*kept} <= {*BOX} and not list(folder.parent.rglob("passwd"))


def test_what_cannot_be_read_is_not_kept(
    browser: Browser,  # noqa: F811
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(*_: object) -> None:
        raise EngineError("it is no glTF")

    before = made_from(browser)
    monkeypatch.setattr(StandInEngine, "build_asset", refuse)
    answer = chosen(browser, **{"crate.glb": b"none"})
    assert not answer["ok"] and answer["error"].startswith("crate.glb: it is no glTF")
    assert made_from(browser) == before and not list((folder / "models").iterdir())


def test_names_that_are_none_of_a_model_are_refused(browser: Browser, hub: Hub) -> None:  # noqa: F811
    bad = [
        "a.exe",
        "a",
        ".glb",
        "..glb",
        "%2e%2e%2fa.glb",
        "a%5Cb.glb",
        "a%00.glb",
        "C:a.glb",
        "graph.json",
        "a" * 200 + ".glb",
    ]
    for name in bad:
        assert sent(browser, name, GLB).status_code in (400, 404), name
    for batch in ("..%2F..", "0123", "0" * 17, BATCH.upper()):
        assert sent(browser, "crate.glb", GLB, batch).status_code in (400, 404), batch
    assert not hub.uploads.files(BATCH)


def test_what_is_too_large_is_refused(
    browser: Browser,  # noqa: F811
    hub: Hub,  # noqa: F811
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(uploads, "MOST_BYTES", len(GLB) + 10)
    assert sent(browser, "crate.glb", GLB).status_code == 204
    answer = sent(browser, "crate.png", b"x" * 11)
    assert answer.status_code == 413 and "larger than" in answer.text
    assert [*hub.uploads.files(BATCH)] == ["crate.glb"]


def test_one_model_at_a_time_and_none_that_did_not_arrive(browser: Browser) -> None:  # noqa: F811
    answer = chosen(browser, **{"a.glb": GLB, "b.glb": GLB})
    assert not answer["ok"] and "several models" in answer["error"]
    answer = browser.call("take_model", thing="letter", batch=BATCH)
    assert not answer["ok"] and "did not arrive" in answer["error"], "what was refused is forgotten"


def test_only_the_page_with_its_pass_may_send(hub: Hub) -> None:  # noqa: F811
    origin = "http://127.0.0.1:8123"
    with TestClient(Door(build_app(hub), "key", origin, "program"), base_url=origin) as client:
        address = f"/models/{BATCH}/crate.glb"
        assert client.post(address, content=GLB, headers={"origin": origin}).status_code == 403, "without a pass"
        client.get("/?token=key")
        assert client.post(address, content=GLB).status_code == 403, "not from the page"
        assert client.post(address, content=GLB, headers={"origin": "http://elsewhere"}).status_code == 403
        assert client.post(address, content=GLB, headers={"origin": origin}).status_code == 204
