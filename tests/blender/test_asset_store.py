"""Assets on disk: built once, and built again when a file is damaged; a disk that fails stops a job, not the worker."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.unit.models.model_corpus import glb, square

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")

from storyblender.blender.asset_store import AssetStore  # noqa: E402
from storyblender.blender.session import BlenderSession  # noqa: E402
from storyblender.errors import InputError  # noqa: E402
from storyblender.folder import Folder  # noqa: E402
from storyblender.memory.asset_sheet import Asset, CanonicalAsset  # noqa: E402
from storyblender.memory.jobs import FETCHED, AssetJob, SceneJob  # noqa: E402
from storyblender.memory.scene_context import Environment, Layout, SceneContext, SceneSetup, SceneSize  # noqa: E402
from storyblender.model_content import content_of  # noqa: E402

CUP = CanonicalAsset(source="catalog", key="cup", dimensions=(0.1, 0.1, 0.1), digest="")
JOB = AssetJob(asset=Asset(asset_id="cup", asset_type="object", description="a cup", canonical=CUP))


@pytest.mark.parametrize("suffix", [".blend", ".json"])
@pytest.mark.parametrize("damage", [Path.unlink, lambda path: path.write_bytes(path.read_bytes()[:-9])])
def test_a_damaged_asset_is_built_again(tmp_path: Path, suffix: str, damage: Callable[[Path], object]) -> None:
    store = AssetStore(Folder(tmp_path))
    first = store.measure(JOB)
    path = tmp_path / "assets" / f"{JOB.digest}.blend"
    untouched = path.stat().st_ctime_ns
    assert store.measure(JOB) == first and path.stat().st_ctime_ns == untouched, "built once"
    damage(tmp_path / "assets" / f"{JOB.digest}{suffix}")
    assert store.measure(JOB) == first and path.stat().st_ctime_ns != untouched
    assert len(list((tmp_path / "assets").iterdir())) == 2
    assert store.append_mesh(
        JOB.asset.model_copy(update={"canonical": CUP.model_copy(update={"digest": first.digest})})
    )


def test_a_model_is_known_by_its_content_wherever_the_folders_are(tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    for folder, content in ((here, b"another"), (there, glb(*square()))):
        folder.mkdir()
        (folder / "square.glb").write_bytes(content)
    key, content = "square.glb", content_of(there / "square.glb", there)
    model = CanonicalAsset(source="file", key=key, params={"content": content}, dimensions=(1, 1, 1), digest="")
    job = AssetJob(asset=JOB.asset.model_copy(update={"canonical": model}))
    found = AssetStore(Folder(tmp_path / "a"), [here, there]).measure(job)
    moved = there.rename(tmp_path / "moved")
    assert AssetStore(Folder(tmp_path / "b"), [moved]).measure(job) == found, "a worker elsewhere builds the same"
    with pytest.raises(InputError, match="has changed"):
        AssetStore(Folder(tmp_path / "c"), [here]).measure(job)
    with pytest.raises(InputError, match="does not exist"):
        AssetStore(Folder(tmp_path / "c"), [there]).measure(job)
    fetched = Folder(tmp_path / "d")
    fetched.write(f"{FETCHED}/{key}", (moved / key).read_bytes())
    assert AssetStore(fetched).measure(job) == found, "what a source fetched is in the project"


def scene_job() -> SceneJob:
    size = SceneSize(x=3, x_negative=-3, y=3, y_negative=-3)
    room = Environment(kit="room")
    return SceneJob(
        scene=SceneContext(scene_id=1, setup=SceneSetup(), environment=room, layout=Layout(scene_size=size)),
        shots=(),
        assets=(),
    )


class FailingCall:
    """A call to the system of which one below a folder fails."""

    def __init__(self, real: Callable[..., object], folder: Path, number: int) -> None:
        self._real, self._folder, self._left = real, folder, number

    def __call__(self, target: object, *rest: object, **words: object) -> object:
        path = Path(f"/proc/self/fd/{target}").readlink() if isinstance(target, int) else Path(str(target))
        if path.is_relative_to(self._folder):
            self._left -= 1
            if self._left < 0:
                raise OSError(errno.ENOSPC, "No space left on device")
        return self._real(target, *rest, **words)


@pytest.mark.parametrize(
    "call", ["fsync", *(pytest.param(call, marks=pytest.mark.slow) for call in ("replace", "mkdir"))]
)
def test_each_call_to_the_disk_may_fail_and_the_next_job_succeeds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str
) -> None:
    session, real = BlenderSession(tmp_path), getattr(os, call)
    for job in (lambda: session.build_asset(JOB), lambda: session.pack_scene(scene_job())):
        for number in range(50):
            with monkeypatch.context() as patched:
                patched.setattr(os, call, FailingCall(real, tmp_path, number))
                try:
                    job()
                except InputError as error:
                    assert "No space left on device" in str(error)
                else:
                    break
        assert 0 < number < 49, "some calls failed, and without them the job is done"
    assert (tmp_path / scene_job().out).is_file() and not list(tmp_path.rglob(".*.part"))
