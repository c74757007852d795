"""``storyblender library`` as a person types it."""

from __future__ import annotations

import gc
import json
import os
import zipfile
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest
from tests.panoramas import write_sky
from tests.stand_in_engine import StandInEngine
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.errors import EngineError
from storyblender.library.shared.place import library_folder
from storyblender.library.shared.shared_library import INDEX, SharedLibrary
from storyblender.library.shared.uses import Use
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.studio import Studio


def run(*words: str | Path, code: int = 0) -> dict[str, Any]:
    """Run a command with ``--json`` and return what it told last."""
    done = CliRunner().invoke(app, ["library", *map(str, words), "--json"])
    assert done.exit_code == code, done.output
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    return lines[-1] if lines else {}


@pytest.fixture(autouse=True)
def _no_blender(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)


@pytest.fixture
def models(tmp_path: Path) -> Path:
    folder = tmp_path / "models"
    (folder / "pictures").mkdir(parents=True)
    (folder / "throne.gltf").write_text(
        json.dumps(
            {"buffers": [{"uri": "throne.bin"}], "images": [{"uri": "pictures/old%20gold.png"}, {"uri": "data:x"}]}
        )
    )
    (folder / "throne.bin").write_bytes(b"buffer")
    (folder / "pictures/old gold.png").write_bytes(b"picture")
    (folder / "vase.obj").write_text("mtllib vase.mtl\nv 0 0 0\n")
    (folder / "vase.mtl").write_text("newmtl a\nmap_Kd vase.png\nmap_Ks gone.png\n")
    (folder / "vase.png").write_bytes(b"picture")
    write_sky(folder / "sky.hdr")
    (folder / "credits.toml").write_text('author = "Ann"\nlicense = "CC-BY-4.0"\n')
    return folder


def test_a_folder_is_added_each_work_with_what_it_names_and_its_credit(models: Path) -> None:
    added = run("add", models, "--no-picture", "--also", "royal seat", "--url", "https://ann.example")["entries"]
    assert [(each["name"], each["kind"]) for each in added] == [
        ("sky", "panorama"), ("throne", "model"), ("vase", "model")
    ]  # fmt: skip
    library = SharedLibrary.open()
    throne, vase = library.told("throne"), library.told("vase")
    assert throne is not None and vase is not None
    names = {path.name for path in library.bundle_of(throne).rglob("*") if path.is_file()}
    assert names == {"throne.gltf", "throne.bin", "old gold.png", "credits.toml"}
    assert {path.name for path in library.bundle_of(vase).iterdir()} == {
        "vase.obj",
        "vase.mtl",
        "vase.png",
        "credits.toml",
    }
    told = run("show", "throne")["entry"]
    assert (told["author"], told["licence"], told["address"]) == ("Ann", "CC-BY-4.0", "https://ann.example")
    assert [each["name"] for each in run("list", "royal")["entries"]] == ["vase", "throne", "sky"]
    assert [each["name"] for each in run("list", "--kind", "panorama")["entries"]] == ["sky"]


def test_what_is_not_known_of_an_entry_is_said_to_be_so(models: Path) -> None:
    (models / "credits.toml").unlink()
    run("add", models / "vase.obj", "--no-picture")
    told = run("show", "vase")["entry"]
    assert {told[name] for name in ("author", "licence", "address")} == {"not stated"}
    assert (told["origin"], told["used in stories"]) == ("added by you", "none")
    library = SharedLibrary.open()
    uses = [Use(asset=name, model="m", name=name, category="", origin="library", entry=told["entry"]) for name in "ab"]
    library.uses.note("/films/one.storyboard", uses)
    library.uses.note("/films/two.storyboard", uses[:1])
    assert run("show", "vase")["entry"]["used in stories"] == "one.storyboard (a, b); two.storyboard (a)"


def test_a_file_that_cannot_be_read_is_refused_and_nothing_is_added(
    models: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (models / "sky.hdr").write_bytes(b"no sky")
    run("add", models, "--no-picture", code=2)
    assert run("list")["entries"] == []
    (models / "sky.hdr").unlink()

    class Refusing(StandInEngine):
        def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
            assert job.asset.canonical is not None
            if (key := job.asset.canonical.key) == "vase.obj":
                raise EngineError(f"build_asset: {models.resolve() / key}: the model cannot be used: no faces")
            return super().build_asset(job)

    monkeypatch.setattr("storyblender.studio.BlenderEngine", Refusing)
    told = run("add", models, "--no-picture", code=2)
    assert told["error"] == f"{models / 'vase.obj'}: the model cannot be used: no faces"
    assert run("list")["entries"] == []


def test_none_and_several_are_told_apart(models: Path, tmp_path: Path) -> None:
    assert str(library_folder()) in CliRunner().invoke(app, ["library", "list"]).stdout
    (tmp_path / "other").mkdir()
    (tmp_path / "other/vase.obj").write_text("v 1 2 3\n")
    run("add", models, tmp_path / "other", "--no-picture")
    digests = [each["digest"] for each in run("list", "vase")["entries"]]
    several, none = run("show", "vase", code=2)["error"], run("show", "lantern", code=2)["error"]
    assert len(digests) == 2 and all(digest[:8] in several for digest in digests)
    assert "no entry 'lantern'" in none and "several" not in none
    assert run("show", digests[0][:8])["entry"]["entry"] == digests[0]
    assert run("list", "--source", "meshy")["entries"] == []
    assert "poly_haven" in run("list", "--source", "foo", code=2)["error"]


def test_a_model_in_parts_is_refused_with_what_to_export(tmp_path: Path) -> None:
    (tmp_path / "lantern.usda").write_text("#usda 1.0")
    assert "as one .usdz" in run("add", tmp_path / "lantern.usda", code=2)["error"]


@pytest.mark.parametrize("uri", ["gone.bin", "../secret.bin", "/etc/hostname"])
def test_a_model_that_names_what_is_not_in_its_folder_is_refused(uri: str, tmp_path: Path) -> None:
    (tmp_path / "secret.bin").write_bytes(b"secret")
    (tmp_path / "models").mkdir()
    (tmp_path / "models/it.gltf").write_text(json.dumps({"buffers": [{"uri": uri}]}))
    run("add", tmp_path / "models", "--no-picture", code=2 if uri == "gone.bin" else 0)
    if uri != "gone.bin":  # what leads out of the folder is not copied; the importer says what is missing
        entry = SharedLibrary.open().find()[0]
        assert {path.name for path in SharedLibrary.open().bundle_of(entry).iterdir()} == {"it.gltf"}


def test_entries_are_removed_and_nothing_unknown_is(models: Path) -> None:
    run("add", models, "--no-picture")
    run("remove", "throne", "unknown", code=2)
    assert SharedLibrary.open().told("throne") is not None, "all or nothing"
    run("remove", "throne", "sky")
    assert [each["name"] for each in run("list")["entries"]] == ["vase"]
    run("list", "--kind", "spoon", code=2)


def test_a_pack_carries_all_to_another_library(models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for suffix in (".stl", ".ply", ".usdz"):
        (models / f"urn{suffix}").write_bytes(suffix.encode())
    run("add", models, "--no-picture")
    before = run("list")["entries"]
    assert len(before) > 3 and run("pack", tmp_path / "mine.zip")["packed"]["entries"] == str(len(before))
    monkeypatch.setenv("STORYBLENDER_LIBRARY", str(tmp_path / "other"))
    run("unpack", tmp_path / "mine.zip")
    key = lambda entry: entry["digest"]  # noqa: E731
    assert sorted(run("list")["entries"], key=key) == sorted(before, key=key)
    assert run("show", "vase")["entry"]["files"] == "as they were added"


@pytest.mark.parametrize("harm", ["traversal", "changed", "no record", "no zip", "other digest"])
def test_a_pack_that_does_harm_is_refused_whole(
    harm: str, models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run("add", models / "throne.gltf", "--no-picture")
    run("pack", tmp_path / "mine.zip")
    with zipfile.ZipFile(tmp_path / "mine.zip") as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    record = next(name for name in files if name.endswith(".json"))
    digest = record.removesuffix(".json")
    match harm:
        case "traversal":
            files["../../evil.toml"] = b"x"
        case "changed":
            files[f"{digest}/throne.bin"] = b"changed"
        case "no record":
            del files[record]
        case "other digest":
            files[record] = files[record].replace(digest.encode(), b"0" * 64)
    with zipfile.ZipFile(tmp_path / "bad.zip", "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    if harm == "no zip":
        (tmp_path / "bad.zip").write_bytes(b"PK nothing")
    monkeypatch.setenv("STORYBLENDER_LIBRARY", str(tmp_path / "other"))
    run("unpack", tmp_path / "bad.zip", code=2)
    assert run("list")["entries"] == [] and not list(tmp_path.rglob("evil*"))


def test_what_is_damaged_is_cleaned_and_only_told_in_a_dry_run(models: Path) -> None:
    run("add", models, "--no-picture")
    library = SharedLibrary.open()
    sky = library.told("sky")
    assert sky is not None
    library.path_of(sky).write_bytes(b"changed")
    lost = library.files.make_folder("incoming/of_a_killed_run")
    (lost / "it.bin").write_bytes(b"12345")
    os.utime(lost, (0, 0))
    library.files.make_folder("incoming/of_a_run_at_work")
    assert run("show", "sky")["entry"]["files"].startswith("damaged")
    for words in (("clean", "--dry-run"), ("clean",)):
        told = run(*words)["clean"]
        assert (told["damaged entries"], told["files of nothing"]) == ("1", "1")
    assert {each["name"] for each in run("list")["entries"]} == {"throne", "vase"}
    assert [path.name for path in (library_folder() / "incoming").iterdir()] == ["of_a_run_at_work"]
    assert run("clean")["clean"]["damaged entries"] == "0"


def test_an_index_that_cannot_be_read_is_made_anew_of_the_files(models: Path) -> None:
    run("add", models, "--no-picture")
    before = {each["digest"] for each in run("list")["entries"]}
    gc.collect()  # else SQLite goes on with what this process has open
    for name in (f"{INDEX}-wal", f"{INDEX}-shm"):
        (library_folder() / name).unlink(missing_ok=True)
    (library_folder() / INDEX).write_bytes(b"this is no database" * 300)
    run("list", code=2)
    told = run("clean")["clean"]
    assert (told["entries of the new index"], told["jobs of the new index"]) == ("3", "0")
    assert {each["digest"] for each in run("list")["entries"]} == before
    assert (library_folder() / f"damaged-1-{INDEX}").is_file()


def test_paid_work_of_unknown_outcome_is_listed_and_freed() -> None:
    job = SharedLibrary.open().jobs.begin("ab", "meshy", 0.2)
    assert [each["state"] for each in run("jobs")["jobs"]] == ["begun"]
    assert [each["state"] for each in run("jobs", "--ask-again", str(job.id))["jobs"]] == ["failed"]
    run("jobs", "--ask-again", str(job.id), code=2)


def test_what_a_service_refused_is_not_listed_as_paid() -> None:
    jobs = SharedLibrary.open().jobs
    jobs.failed(jobs.begin("aa", "openai", 0.04), "openai: it cannot be reached")
    jobs.failed(jobs.submitted(jobs.begin("bb", "meshy", 0.6), "task-1"), "it made no model")
    jobs.submitted(jobs.begin("cc", "meshy", 0.6), "task-2")
    jobs.ask_again(jobs.begin("dd", "gemini", 0.1).id)
    jobs.begin("ee", "gemini", 0.1)
    assert [each["paid"] for each in run("jobs")["jobs"]] == ["no", "perhaps", "yes", "perhaps", "perhaps"]
    (refused,) = (line for line in CliRunner().invoke(app, ["library", "jobs"]).stdout.splitlines() if "openai" in line)
    assert "nothing" in refused and "0.04" not in refused


def test_an_empty_library_has_figures_and_is_not_made() -> None:
    assert run("figures")["figures"]["reduction"] == "0.00 %" and run("list")["entries"] == []
    assert not library_folder().exists()


def test_a_model_that_cannot_be_drawn_is_added_with_a_warning(models: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> Path:
        raise EngineError("the model cannot be read")

    monkeypatch.setattr(Studio, "draw_entry", fails)
    assert len(run("add", models)["entries"]) == 3
