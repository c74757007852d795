"""Archives from outside: what is in them lands in its folder or nowhere, and never fills the disk."""

from __future__ import annotations

import io
import stat
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from storyblender.errors import ServiceFailure
from storyblender.services.archives import ArchiveLimits, extract

MODEL = {"scene.gltf": b"{}", "scene.bin": b"\0" * 64, "textures/wood_baseColor.png": b"png"}


def zipped(files: dict[str, bytes], change: Callable[[zipfile.ZipInfo], None] | None = None) -> bytes:
    """Return a zip archive of files by name."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            if change is not None:
                change(entry)
            archive.writestr(entry, content)
    return out.getvalue()


def unpacked(content: bytes, tmp_path: Path, **limits: int) -> tuple[str, ...]:
    archive, folder = tmp_path / "a.zip", tmp_path / "in" / "here"
    archive.write_bytes(content)
    folder.mkdir(parents=True)
    return extract(archive, folder, limits=ArchiveLimits(**limits))


def test_the_files_of_a_model_are_unpacked_and_others_are_not(tmp_path: Path) -> None:
    names = unpacked(zipped({**MODEL, "license.txt": b"by", "run.py": b"x", "a/b.SH": b"x"}), tmp_path)
    assert names == tuple(sorted(MODEL))
    for name, content in MODEL.items():
        assert (tmp_path / "in/here" / name).read_bytes() == content
    assert {path.name for path in (tmp_path / "in").rglob("*") if path.is_file()} == {
        "scene.gltf", "scene.bin", "wood_baseColor.png",
    }  # fmt: skip


ODD_NAMES = (
    "../out.png", "a/../../out.png", "/tmp/out.png", "..\\out.png", "C:/out.png", "C:out.png", "a\nb.png", "~/out.png",
    "x" * 200 + ".png", "/".join("abcdefghijk") + "/out.png", "a\x1b[31m.png", "//host/out.png",
)  # fmt: skip


@pytest.mark.parametrize("name", ODD_NAMES)
def test_a_name_that_leads_elsewhere_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(ServiceFailure):
        unpacked(zipped({"scene.gltf": b"{}", name: b"evil"}), tmp_path)
    assert not [path for path in tmp_path.rglob("*out*")]


def _link(entry: zipfile.ZipInfo) -> None:
    entry.external_attr = (stat.S_IFLNK | 0o777) << 16


def _device(entry: zipfile.ZipInfo) -> None:
    entry.external_attr = (stat.S_IFCHR | 0o666) << 16


@pytest.mark.parametrize("change", [_link, _device])
def test_links_and_devices_are_refused(change: Callable[[zipfile.ZipInfo], None], tmp_path: Path) -> None:
    with pytest.raises(ServiceFailure, match="link"):
        unpacked(zipped({"scene.gltf": b"/etc/passwd"}, change), tmp_path)


def test_a_bomb_is_refused_before_it_is_unpacked(tmp_path: Path) -> None:
    with pytest.raises(ServiceFailure, match="more than it should"):
        unpacked(zipped({f"{i}.bin": b"\0" * (10 << 20) for i in range(8)}), tmp_path)
    assert not list((tmp_path / "in").rglob("*.bin"))


def test_a_bomb_that_lies_about_its_size_is_stopped(tmp_path: Path) -> None:
    size = (5000).to_bytes(4, "little")
    content = zipped({"a.bin": b"\0" * 5000}).replace(size, (10).to_bytes(4, "little"))
    with pytest.raises(ServiceFailure):
        unpacked(content, tmp_path, bytes=1000)
    assert sum(path.stat().st_size for path in (tmp_path / "in").rglob("*.bin")) <= 1000


BROKEN = {
    "no archive": b"<html>no</html>",
    "nothing": b"",
    "cut": zipped(MODEL)[:-30],
    "two of one name": zipped({"a.png": b"1", "A.png": b"2"}),
    "a file that is a folder": zipped({"a.png": b"1", "a.png/b.png": b"2"}),
    "locked": zipped(MODEL).replace(b"PK\x01\x02\x14\x03\x14\x00\x00", b"PK\x01\x02\x14\x03\x14\x00\x01"),
}  # fmt: skip


@pytest.mark.parametrize("content", BROKEN.values(), ids=BROKEN.keys())
def test_a_broken_archive_is_one_sentence(content: bytes, tmp_path: Path) -> None:
    with pytest.raises(ServiceFailure):
        unpacked(content, tmp_path)


def test_a_flipped_bit_is_found(tmp_path: Path) -> None:
    content = bytearray(zipped({"a.bin": bytes(range(256)) * 100}))
    content[60] ^= 0xFF
    with pytest.raises(ServiceFailure, match="damaged"):
        unpacked(bytes(content), tmp_path)


def test_too_many_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ServiceFailure, match="more than 3 files"):
        unpacked(zipped({f"{i}.png": b"" for i in range(4)}), tmp_path, files=3)
