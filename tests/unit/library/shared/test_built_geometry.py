"""Geometry that was built for one story is taken by the next: by all that it depends on, checked by digest, bounded."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from tests.stand_in_engine import StandInEngine

import storyblender
from storyblender.folder import Folder
from storyblender.library.shared import built_geometry
from storyblender.library.shared.builder import BUILDERS, BUILDING_MODULES, builder_version
from storyblender.library.shared.built_geometry import BuiltGeometry, key_of
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.jobs import ASSETS, AssetJob


def job(key: str = "chair", asset_id: str = "chair", **values: object) -> AssetJob:
    made = CanonicalAsset.model_validate(dict(source="catalog", key=key, dimensions=(1, 1, 1), digest="") | values)
    return AssetJob(asset=Asset(asset_id=asset_id, asset_type="object", description="", canonical=made))


@pytest.fixture
def library(tmp_path: Path) -> SharedLibrary:
    return SharedLibrary.open(tmp_path / "library")


def built(tmp_path: Path, *jobs: AssetJob) -> Folder:
    engine = StandInEngine(tmp_path / "first")
    for each in jobs:
        engine.build_asset(each)
    return engine.files


def test_what_was_built_is_taken_as_it_is(library: SharedLibrary, tmp_path: Path) -> None:
    first = built(tmp_path, job(), job("table", "table"))
    library.geometry.give([job(), job("table", "table")], first)
    second, named = Folder(tmp_path / "second"), job(asset_id="seat_7")
    taken = library.geometry.take([named, job("lamp", "lamp")], second)
    assert list(taken) == [named.digest] and taken[named.digest].asset_id == "seat_7"
    name = f"{ASSETS}/{named.digest}.blend"
    assert second.path(name).read_bytes() == first.path(name).read_bytes()
    assert second.path(f"{ASSETS}/{named.digest}.json").is_file()


@pytest.mark.parametrize("name", ["{}.blend", "{}.json"])
def test_damaged_geometry_is_not_taken_and_mended_by_what_is_built(
    name: str, library: SharedLibrary, tmp_path: Path
) -> None:
    first = built(tmp_path, job())
    library.geometry.give([job()], first)
    (kept,) = (library.files.root / built_geometry.FOLDER).rglob(name.format(job().digest))
    kept.write_bytes(kept.read_bytes()[:-1])
    assert library.geometry.take([job()], Folder(tmp_path / "second")) == {}
    assert not (tmp_path / "second" / ASSETS).exists()
    library.geometry.give([job()], first)
    assert library.geometry.take([job()], Folder(tmp_path / "second"))


def test_a_changed_builder_never_takes_old_geometry(
    library: SharedLibrary, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    library.geometry.give([job()], built(tmp_path, job()))
    monkeypatch.setattr(built_geometry, "builder_version", lambda: "another")
    assert library.geometry.take([job()], Folder(tmp_path / "second")) == {}


def test_a_change_of_any_file_that_builds_is_another_version(tmp_path: Path) -> None:
    def version(change: str = "", content: str = "x = 1") -> str:
        root = tmp_path / f"{change}{content}".replace("/", "-")
        for name in (*(f"{each}/part.py" for each in BUILDERS), *BUILDING_MODULES, "pipeline/part.py"):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(content if name == change else "x = 0")
        return builder_version(root)

    changes = [version(name) for name in ("blender/part.py", "catalog/part.py", "library/data/part.py", "outputs.py")]
    assert len({version(), *changes}) == 5 and version("pipeline/part.py") == version()


def test_all_that_the_builders_import_is_part_of_their_version() -> None:
    root = Path(storyblender.__file__).parent
    seen: set[Path] = set()
    waiting = [root / "blender" / "asset_store.py"]
    while waiting:
        path = waiting.pop()
        if path in seen or path == root / "__init__.py":
            continue
        seen.add(path)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [node.module] if isinstance(node, ast.ImportFrom) and node.module else []
            names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            for name in names:
                parts = name.split(".")
                if parts[0] == "storyblender":
                    place = root.joinpath(*parts[1:])
                    waiting += [each for each in (place.with_suffix(".py"), place / "__init__.py") if each.is_file()]
    outside = {path.relative_to(root).as_posix() for path in seen if path.name != "__init__.py"}
    outside -= {name for name in outside if name.startswith(tuple(f"{each}/" for each in BUILDERS))}
    assert outside <= {*BUILDING_MODULES}, "builder.py does not count these"
    assert len(seen) > 50


def test_people_need_the_body_data_and_models_a_digest_of_theirs(monkeypatch: pytest.MonkeyPatch) -> None:
    made = CanonicalAsset(source="person", key="person", dimensions=(1, 1, 1), digest="")
    ann = Asset(asset_id="ann", asset_type="character", description="", canonical=made)
    young = ann.model_copy(update={"reference_character": "bea"})
    monkeypatch.setattr(built_geometry, "body_pack", lambda: "the pack")
    assert key_of(AssetJob(asset=ann)) != key_of(AssetJob(asset=young)), "another's face"
    monkeypatch.setattr(built_geometry, "body_pack", lambda: "")
    assert key_of(AssetJob(asset=ann)) == ""
    one, other = ({"content": f"{number:016x}"} for number in (1, 2))
    keys = {key_of(job("a.glb", source="file", params=params)) for params in (one, other)}
    assert len(keys) == 2 and "" not in keys
    assert key_of(job("a.glb", source="file", params={"content": "300000000 bytes"})) == ""


def test_what_was_not_taken_for_longest_goes_first(library: SharedLibrary, tmp_path: Path) -> None:
    jobs = [job(key, key) for key in ("chair", "table", "lamp")]
    files = built(tmp_path, *jobs)
    size = sum(path.stat().st_size for path in (tmp_path / "first" / ASSETS).iterdir())
    geometry = BuiltGeometry(library, most=size * 5 // 6)
    for each in jobs[:2]:
        geometry.give([each], files)
    geometry.take(jobs[:1], Folder(tmp_path / "second"))
    geometry.give(jobs[2:], files)
    assert {*geometry.take(jobs, Folder(tmp_path / "third"))} == {jobs[0].digest, jobs[2].digest}
    assert len(list((library.files.root / built_geometry.FOLDER).rglob("*.blend"))) == 2
