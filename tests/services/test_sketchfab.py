"""Sketchfab over its wire format: what it offers, what is fetched, and what is refused."""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from storyblender.errors import ServiceFailure
from storyblender.folder import Folder
from storyblender.service_setting import services_in
from storyblender.services.offers import Need
from storyblender.services.register import ServiceRun, catalogues
from storyblender.services.shelf import Shelf
from storyblender.services.sketchfab import Sketchfab
from tests.model_files import glb_of
from tests.services.catalogue_sites import Fab, open_sketchfab, result_of, zipped
from tests.services.site import QUICK, Cut, Endless, Late, Reply, Site, moved, said, serving

TOKEN = "0123456789abcdef-secret"
UID = "4737a3b84e00415b9d8bb42ae44285b2"
LAMP = Fab(UID, "Brass Lamp", words=("lamp", "brass"))


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    with serving() as site:
        open_sketchfab(site, [LAMP], TOKEN)
        host = site.address.removeprefix("http://").replace(".", "_").replace(":", "_")
        monkeypatch.setenv(f"STORYBLENDER_KEY_{host}", TOKEN)
        yield site


def opened(site: Site, shelf: Path | None = None, **given: Any) -> Sketchfab:
    run = ServiceRun(patience=QUICK, shelf=Shelf(Folder(shelf) if shelf else None), **given)
    (found,) = catalogues(services_in(f"sketchfab@{site.address}"), run)
    assert isinstance(found, Sketchfab)
    return found


def fetched(site: Site, folder: Path) -> Any:
    fab = opened(site)
    (offer,) = fab.find("lamp", "model")
    folder.mkdir(exist_ok=True)
    return fab.fetch(offer, folder, Need())


def test_an_offer_says_what_the_search_says(site: Site) -> None:
    (offer,) = opened(site).find("lamp", "model")
    assert (offer.id, offer.name, offer.author, offer.faces, offer.bytes) == (UID, "Brass Lamp", "A. Maker", 12, 2000)
    assert (offer.licence.name, offer.url) == ("CC-BY-4.0", f"https://sketchfab.com/3d-models/thing-{UID}")
    assert offer.words == ("lamp", "brass", "furniture & home")
    asked = site.hits[0].query
    assert (asked["q"], asked["downloadable"], asked["max_face_count"]) == ("lamp", "true", "200000")


def test_a_model_comes_with_all_its_files(site: Site, tmp_path: Path) -> None:
    came = fetched(site, tmp_path / "a")
    names = {path.relative_to(tmp_path / "a").as_posix() for path in (tmp_path / "a").rglob("*") if path.is_file()}
    assert names == {"model.gltf", "scene.bin", "textures/scene_diff_1k.png"}
    assert came.main == "model.gltf" and came.faces == 12
    assert (tmp_path / "a/model.gltf").read_bytes() == LAMP.files["scene.gltf"]


def test_the_token_goes_to_the_service_and_not_to_the_host_of_the_files(site: Site, tmp_path: Path) -> None:
    with serving({"/lamp.zip": Reply(zipped(LAMP.files))}) as other:
        site.pages[f"/models/{UID}/download"] = said({"gltf": {"url": f"{other.address}/lamp.zip", "size": 1}})
        fetched(site, tmp_path / "a")
        assert all(hit.headers["authorization"] == f"Token {TOKEN}" for hit in site.hits)
        assert other.hits and "authorization" not in other.hits[0].headers


@pytest.mark.parametrize("below", ["", "a/b/"])
@pytest.mark.parametrize("single", [False, True], ids=["gltf", "glb"])
def test_archives_of_all_forms_become_the_same_model(site: Site, tmp_path: Path, below: str, single: bool) -> None:
    files = {"scene.glb": glb_of(LAMP.files)} if single else LAMP.files
    site.pages[f"/archives/{UID}.zip"] = Reply(zipped({below + name: content for name, content in files.items()}))
    came = fetched(site, tmp_path / "a")
    assert came.main == "model.gltf" and came.faces == 12 and (tmp_path / "a" / came.main).is_file()


def test_a_model_that_is_one_file_is_taken_where_there_is_no_archive(site: Site, tmp_path: Path) -> None:
    site.pages["/lamp.glb"] = Reply(glb_of(LAMP.files))
    site.pages[f"/models/{UID}/download"] = said({"glb": {"url": f"{site.address}/lamp.glb"}, "usdz": {}})
    assert fetched(site, tmp_path / "a").faces == 12
    names = {path.name for path in (tmp_path / "a").iterdir()}
    assert names == {"model.gltf", "model.bin"}


LICENCES = {
    "any": {"cc0", "by", "by-sa", "by-nc", "st"}, "commercial": {"cc0", "by", "by-sa", "st"}, "free": {"cc0"},
}  # fmt: skip


@pytest.mark.parametrize("wanted", LICENCES)
def test_only_works_of_a_wanted_licence_are_offered(site: Site, wanted: Any) -> None:
    slugs = ("cc0", "by", "by-sa", "by-nc", "by-nd", "by-nc-nd", "st", "ed", "odd")
    open_sketchfab(site, [Fab(f"a{n}", f"lamp {slug}", (slug, "")) for n, slug in enumerate(slugs)])
    found = opened(site, licences=wanted).find("lamp", "model")
    assert {offer.name.removeprefix("lamp ") for offer in found} == LICENCES[wanted]
    assert site.hits[0].query.get("license") == ("cc0" if wanted == "free" else None)


def test_the_answer_is_checked_though_the_question_had_the_filter(site: Site) -> None:
    heavy = {"archives": {"gltf": {"faceCount": 10**7, "size": 5}}}
    shy, shut = {"isAgeRestricted": True}, {"isDownloadable": False}
    odd = [Fab("a1", "lamp", more=heavy), Fab("a2", "lamp", more=shy), Fab("a3", "lamp", more=shut)]
    site.pages["/search"] = said({"results": [result_of(each) for each in odd]})
    assert opened(site).find("lamp", "model") == ()


def test_the_same_words_are_asked_once_a_day(site: Site, tmp_path: Path) -> None:
    for _ in range(2):
        fab = opened(site, tmp_path)
        assert fab.find("lamp", "model") == fab.find("lamp", "model") != ()
    assert site.count("/search") == 1
    opened(site, tmp_path).find("chair", "model")
    assert site.count("/search") == 2
    assert not [path for path in tmp_path.rglob("*") if path.is_file() and TOKEN.encode() in path.read_bytes()]


def test_without_a_key_it_is_said_and_nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SKETCHFAB_API_TOKEN", raising=False)
    monkeypatch.setattr("keyring.get_password", lambda *_: None)
    (fab,) = catalogues(services_in("sketchfab"), ServiceRun(patience=QUICK))
    with pytest.raises(ServiceFailure, match="SKETCHFAB_API_TOKEN"):
        fab.find("lamp", "model")


FAULTS = {
    "too many requests": Reply(status=429), "an error": Reply(status=500), "no answer": Late(3), "cut": Cut(),
    "a web page": Reply(b"<html>", kind="text/html"), "endless": Endless(), "not there": Reply(status=404),
    "key refused": Reply(status=401), "moved to a file": moved("file:///etc/passwd"), "not JSON": Reply(b"{"),
    "a list": said([1, 2]), "odd links": said({"gltf": {"url": 7}}), "odd results": said({"results": {"a": 1}}),
    "a link to a file": said({"gltf": {"url": "file:///etc/passwd"}}),
    "a link into the network": said({"gltf": {"url": "https://10.0.0.1/a.zip"}}),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS.keys())
@pytest.mark.parametrize("where", ["/search", f"/models/{UID}/download", f"/archives/{UID}.zip"])
def test_every_fault_is_a_sentence_without_the_key(site: Site, tmp_path: Path, where: str, fault: Reply) -> None:
    if where.startswith("/archives") and isinstance(fault, Endless):
        fault = Endless(0.01, b"x")
    site.pages[where] = fault
    with pytest.raises(ServiceFailure) as failure:
        fetched(site, tmp_path / "a")
    assert TOKEN not in str(failure.value)


def huge_png() -> bytes:
    """Return a PNG that says it is 60 000 pixels a side."""
    png = bytearray(LAMP.files["textures/scene_diff_1k.png"])
    png[16:24] = struct.pack(">II", 60_000, 60_000)
    png[29:33] = struct.pack(">I", zlib.crc32(bytes(png[12:29])))
    return bytes(png)


def _text(**changes: Any) -> Mapping[str, bytes]:
    model = json.loads(LAMP.files["scene.gltf"])
    return {**LAMP.files, "scene.gltf": json.dumps({**model, **changes}).encode()}


MALICIOUS: dict[str, Mapping[str, bytes]] = {
    "a path up": {**LAMP.files, "../../evil.png": b"x"},
    "a path from the root": {**LAMP.files, "/tmp/evil.png": b"x"},
    "a bomb": {**LAMP.files, **{f"{n}.bin": b"\0" * (20 << 20) for n in range(4)}},
    "no model": {"evil.png": b"x"},
    "a model elsewhere": _text(buffers=[{"uri": "../../../../etc/passwd", "byteLength": 4}]),
    "a picture of the web": _text(images=[{"uri": "https://evil.example/a.png"}]),
    "a picture that is none": {**LAMP.files, "textures/scene_diff_1k.png": b"<script>"},
    "a picture that is a bomb": {**LAMP.files, "textures/scene_diff_1k.png": huge_png()},
    "a model that is none": {"scene.gltf": b"MZ"},
    "another version": _text(asset={"version": "1.0"}),
    "a glb that lies": {"scene.glb": glb_of(LAMP.files)[:-8]},
    "a glb that is none": {"scene.glb": b"glTF"},
}


@pytest.mark.parametrize("files", MALICIOUS.values(), ids=MALICIOUS.keys())
def test_a_malicious_archive_is_refused(site: Site, tmp_path: Path, files: Mapping[str, bytes]) -> None:
    site.pages[f"/archives/{UID}.zip"] = Reply(zipped(files))
    with pytest.raises(ServiceFailure):
        fetched(site, tmp_path / "a")
    assert not [path for path in tmp_path.rglob("*evil*")]


def test_odd_results_are_left_out_and_odd_texts_are_cut(site: Site) -> None:
    results: list[Any] = [
        *({**result_of(LAMP), "uid": uid} for uid in ("../../x", "a/b", 7, "")), 7, None,
        *({**result_of(LAMP), "license": licence} for licence in ("all mine", None, [])),
        {**result_of(LAMP), "name": ""},
        {
            **result_of(LAMP), "name": "Lamp\n<b>" + "x" * 900, "user": {"displayName": "A\x1b[31m"}, "tags": "no",
            "viewerUrl": "javascript:alert(1)", "archives": [], "faceCount": "12", "thumbnails": 7,
        },
    ]  # fmt: skip
    site.pages["/search"] = said({"results": results})
    (offer,) = opened(site).find("lamp", "model")
    assert len(offer.name) <= 120 and "\n" not in offer.name and offer.author == "A[31m"
    assert offer.url == f"https://sketchfab.com/3d-models/{UID}" and offer.faces == 0 and offer.thumbnail == ""


def test_what_it_has_none_of_is_not_asked_for(site: Site) -> None:
    assert opened(site).find("bricks", "texture") == () and opened(site).find(" ", "model") == ()
    assert not site.hits
