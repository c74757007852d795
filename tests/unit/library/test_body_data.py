"""Fetching the body data fails with one clear sentence."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.library import body_data


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("STORYBLENDER_BODY_DATA", raising=False)


def test_a_wrong_wheel_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wheel = tmp_path / "other.whl"
    wheel.write_bytes(b"not the wheel")
    monkeypatch.setenv("STORYBLENDER_BODY_DATA", str(wheel))
    with pytest.raises(InputError, match="not the expected"):
        body_data.ensure_body_pack()
    assert not (tmp_path / "cache").exists()


def test_a_missing_wheel_and_a_missing_pack_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("gone.whl", "gone.npz.xz"):
        monkeypatch.setenv("STORYBLENDER_BODY_DATA", str(tmp_path / name))
        with pytest.raises(InputError, match=name):
            body_data.ensure_body_pack()


def test_offline_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess([], 1, "", "ERROR: No matching distribution found")

    monkeypatch.setattr(body_data.subprocess, "run", fail)
    with pytest.raises(InputError, match="go online once"):
        body_data.ensure_body_pack()


def test_a_pack_that_is_there_is_not_fetched_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise AssertionError("fetched again")

    path = body_data.body_pack_path({"XDG_CACHE_HOME": str(tmp_path / "cache")}, tmp_path)
    path.parent.mkdir(parents=True)
    path.write_bytes(b"a pack")
    monkeypatch.setattr(body_data.subprocess, "run", fail)
    assert body_data.ensure_body_pack() == path


def test_the_mesh_reader_takes_points_and_quads() -> None:
    text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.3 0.4\nf 1/1 2/2 3/1 4/2\n"
    points, coordinates, faces = body_data._read_obj(text)
    assert points.shape == (4, 3)
    assert faces.tolist() == [[0, 1, 2, 3]]
    assert coordinates[1].tolist() == pytest.approx([0.3, 0.4])
