"""Poly Haven over its wire format: what it offers, what is fetched, and what is refused."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from storyblender.errors import ServiceFailure
from storyblender.folder import Folder
from storyblender.service_setting import services_in
from storyblender.services.offers import Need
from storyblender.services.poly_haven import PolyHaven
from storyblender.services.register import ServiceRun, catalogues
from storyblender.services.shelf import Shelf
from tests.model_files import box_gltf, tile
from tests.services.catalogue_sites import Haven, open_poly_haven
from tests.services.site import QUICK, Cut, Endless, Late, Reply, Site, moved, said, serving

CHAIR = Haven("ArmChair_01", "Arm Chair 01", ("armchair", "Seat", "leather"))
BRICK = Haven("brick_floor_003", "Brick Floor 003", ("floor",), "textures")
SKY = Haven("abandoned_canteen", "Abandoned Canteen", ("hall",), "hdris")


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        open_poly_haven(site, [CHAIR, BRICK, SKY])
        yield site


def opened(site: Site, shelf: Path | None = None, **given: Any) -> PolyHaven:
    run = ServiceRun(patience=QUICK, shelf=Shelf(Folder(shelf) if shelf else None), **given)
    (found,) = catalogues(services_in(f"poly_haven@{site.address}"), run)
    assert isinstance(found, PolyHaven)
    return found


def fetched(site: Site, folder: Path, need: Need | None = None) -> Any:
    haven = opened(site)
    (offer,) = haven.find("chair", "model")
    folder.mkdir(exist_ok=True)
    return haven.fetch(offer, folder, need or Need())


def test_an_offer_says_what_the_list_says(site: Site) -> None:
    (offer,) = opened(site).find("chair", "model")
    assert (offer.id, offer.name, offer.author) == ("ArmChair_01", "Arm Chair 01", "Rico Cilliers, Greg Zaal")
    assert offer.words == ("armchair", "seat", "leather", "furniture", "seating")
    assert offer.faces == 5626 and offer.size == (0.848, 0.766, 1.065)
    assert offer.licence.name == "CC0-1.0" and offer.url == "https://polyhaven.com/a/ArmChair_01"


def test_a_model_comes_with_all_its_files(site: Site, tmp_path: Path) -> None:
    came = fetched(site, tmp_path / "a")
    (main, text), *others = CHAIR.files.items()
    assert main == "scene.gltf" and came.main == "model.gltf" and came.faces == 12
    assert (tmp_path / "a/model.gltf").read_bytes() == text
    assert all((tmp_path / "a" / name).read_bytes() == content for name, content in others)
    assert came.digest == hashlib.sha256(text).hexdigest()
    assert came.bytes == sum(map(len, CHAIR.files.values()))


@pytest.mark.parametrize(("pixels", "size"), [(1024, "1k"), (2048, "2k")])
def test_the_resolution_is_that_of_the_need(site: Site, tmp_path: Path, pixels: Any, size: str) -> None:
    fetched(site, tmp_path / "a", Need(pixels=pixels))
    assert site.count(f"/dl/{size}/") == 3 == site.count("/dl/")


def test_a_texture_comes_as_its_maps(site: Site, tmp_path: Path) -> None:
    haven = opened(site)
    (offer,) = haven.find("", "texture")
    came = haven.fetch(offer, tmp_path, Need())
    assert came.maps == {"color": "color.png", "normal": "normal.png", "roughness": "roughness.png"}
    assert (tmp_path / "normal.png").read_bytes() == tile(len("nor_gl1k")) and came.main == "color.png"
    assert haven.size_of(offer, Need()) == came.bytes == sum(path.stat().st_size for path in tmp_path.iterdir())


def test_a_panorama_is_one_file(site: Site, tmp_path: Path) -> None:
    haven = opened(site)
    (offer,) = haven.find("", "panorama")
    came = haven.fetch(offer, tmp_path, Need(pixels=2048))
    assert came.main == "panorama.hdr" and (tmp_path / came.main).read_bytes() == b"#?RADIANCE\n2k"


def test_the_list_is_asked_for_once_a_day(site: Site, tmp_path: Path) -> None:
    for _ in range(2):
        haven = opened(site, tmp_path / "shelf")
        assert haven.find("a", "model") == haven.find("b", "model") != ()
    assert site.count("/assets") == 1


def age(shelf: Path) -> None:
    """Make what is kept a day older."""
    for path in shelf.rglob("*.json"):
        kept = json.loads(path.read_text())
        path.write_text(json.dumps({**kept, "asked": kept["asked"] - 86401}))


def test_an_old_list_that_is_still_right_is_not_sent_again(site: Site, tmp_path: Path) -> None:
    first = opened(site, tmp_path).find("", "model")
    age(tmp_path)
    assert opened(site, tmp_path).find("", "model") == first
    assert site.hits[-1].headers["if-none-match"] == 'W/"1"'
    assert opened(site, tmp_path).find("", "model") == first and site.count("/assets") == 2


def test_an_old_list_serves_where_the_service_does_not(site: Site, tmp_path: Path) -> None:
    first = opened(site, tmp_path).find("", "model")
    age(tmp_path)
    site.pages["/assets"] = Reply(status=500)
    assert opened(site, tmp_path).find("", "model") == first


def test_a_damaged_list_is_asked_for_anew(site: Site, tmp_path: Path) -> None:
    first = opened(site, tmp_path).find("", "model")
    for path in tmp_path.rglob("*.json"):
        path.write_text("{" * 9)
    assert opened(site, tmp_path).find("", "model") == first and site.count("/assets") == 2


def test_a_shelf_that_cannot_be_written_is_no_fault(site: Site, tmp_path: Path) -> None:
    (tmp_path / "shelf").write_text("a file")
    assert opened(site, tmp_path / "shelf").find("", "model")


FAULTS = {
    "too many requests": Reply(status=429), "an error": Reply(status=500), "no answer": Late(3), "cut": Cut(),
    "a web page": Reply(b"<html>", kind="text/html"), "too large": Endless(), "not there": Reply(status=404),
    "moved to a file": moved("file:///etc/passwd"), "not JSON": Reply(b"{"), "deep": Reply(b"[" * 90_000),
    "a list": said([1, 2]), "a number": said(7), "huge numbers": Reply(b"9" * 9999),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS.keys())
@pytest.mark.parametrize("where", ["/assets", "/files/ArmChair_01", "/dl/1k/ArmChair_01/scene.bin"])
def test_every_fault_is_a_sentence(site: Site, tmp_path: Path, where: str, fault: Reply) -> None:
    if where.startswith("/dl") and isinstance(fault, Endless):
        fault = Endless(0.01, b"x")
    site.pages[where] = fault
    with pytest.raises(ServiceFailure):
        fetched(site, tmp_path / "a")


def _changed(change: Callable[[dict[str, Any]], None]) -> Callable[[Site], None]:
    """Return what changes the list of files of the chair."""

    def apply(site: Site) -> None:
        page = site.pages["/files/ArmChair_01"]
        assert isinstance(page, Reply)
        tree = json.loads(page.body)
        change(tree["gltf"]["1k"]["gltf"])
        site.pages["/files/ArmChair_01"] = said(tree)

    return apply


def _named(name: str) -> Callable[[Site], None]:
    return _changed(lambda main: main["include"].update({name: main["include"]["scene.bin"]}))


MALICIOUS: dict[str, Callable[[Site], None]] = {
    "a path up": _named("../../evil.bin"),
    "a path from the root": _named("/tmp/evil.bin"),
    "a path of Windows": _named("..\\evil.bin"),
    "a script": _named("evil.py"),
    "the model again": _named("model.gltf"),
    "another checksum": _changed(lambda main: main.update(md5="0" * 32)),
    "no checksum": _changed(lambda main: main.update(md5=None)),
    "a file of this machine": _changed(lambda main: main.update(url="file:///etc/passwd")),
    "a computer of the network": _changed(lambda main: main.update(url="https://192.168.1.1/a.gltf")),
    "http elsewhere": _changed(lambda main: main.update(url="http://example.org/a.gltf")),
    "no address": _changed(lambda main: main.update(url={"a": 1})),
    "no files": _changed(lambda main: main.clear()),
    "larger than told": _changed(lambda main: main.update(size=10**12)),
    "thousands of files": _changed(
        lambda main: main["include"].update({f"{n}.bin": main["include"]["scene.bin"] for n in range(300)})
    ),
}


@pytest.mark.parametrize("change", MALICIOUS.values(), ids=MALICIOUS.keys())
def test_a_malicious_list_of_files_is_refused(site: Site, tmp_path: Path, change: Callable[[Site], None]) -> None:
    change(site)
    with pytest.raises(ServiceFailure):
        fetched(site, tmp_path / "a")
    assert not [path for path in tmp_path.rglob("*evil*")]


@pytest.mark.parametrize(
    "uri", ["../../../etc/passwd", "/etc/passwd", "https://evil.example/a.bin", "%2e%2e/a.bin", "no.bin"]
)
def test_a_model_that_names_files_elsewhere_is_refused(tmp_path: Path, uri: str) -> None:
    files = box_gltf((1, 1, 1))
    model = json.loads(files["scene.gltf"])
    model["buffers"][0]["uri"] = uri
    with serving() as site:
        open_poly_haven(
            site, [Haven("ArmChair_01", "Arm Chair", files={**files, "scene.gltf": json.dumps(model).encode()})]
        )
        with pytest.raises(ServiceFailure):
            fetched(site, tmp_path / "a")


def test_odd_records_are_left_out_and_odd_texts_are_cut(site: Site) -> None:
    good = {"name": "<script>alert(1)</script>\n" + "x" * 500, "authors": {"A\x1b[31m": "All"}, "tags": ["a", 7, None]}
    site.pages["/assets"] = said(
        {"../x": good, "a/b": good, "": good, "ok": good, "n": None, "f": 7, "z" * 99: good, "bare": {}}
    )
    offers = opened(site).find("", "model")
    assert [offer.id for offer in offers] == ["bare", "ok"]
    assert len(offers[1].name) <= 120 and "\n" not in offers[1].name and offers[1].author == "A[31m"
    assert offers[1].words == ("a",) and offers[0].name == "bare"
