"""A user's panorama: read, prepared, refused."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from tests.panoramas import sky, write_sky

from storyblender.errors import InputError
from storyblender.library.panorama_file import WIDEST, _decoded, radiance_file, read_panorama
from storyblender.look.raster import luminance


def exr_of(picture: np.ndarray) -> bytes:
    """Return an uncompressed EXR of 32-bit channels, written by hand from the format's own description."""
    height, width = picture.shape[:2]

    def attribute(name: str, kind: str, value: bytes) -> bytes:
        return f"{name}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value

    channels = b"".join(name + b"\0" + struct.pack("<i4xii", 2, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", channels)
    header += attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", window)
    header += attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    size = width * 12
    starts = [len(header) + 8 * height + row * (size + 8) for row in range(height)]
    rows = [
        struct.pack("<ii", row, size) + np.ascontiguousarray(line[:, ::-1].T, "<f4").tobytes()
        for row, line in enumerate(picture)
    ]
    return header + struct.pack(f"<{height}Q", *starts) + b"".join(rows)


def test_both_formats_hold_the_same_sky(tmp_path: Path) -> None:
    picture = sky(sun=None)
    assert _decoded(exr_of(picture), ".exr") == pytest.approx(picture, rel=1e-6)
    assert _decoded(radiance_file(picture), ".hdr") == pytest.approx(picture, rel=0.01, abs=0.01)
    (tmp_path / "a.exr").write_bytes(exr_of(picture))
    known, _ = read_panorama(tmp_path / "a.exr")
    other, _ = read_panorama(write_sky(tmp_path / "a.hdr", sun=None))
    assert np.array(known.irradiance) == pytest.approx(np.array(other.irradiance), abs=0.01)
    assert known.provenance.file == "a.exr" and known.provenance.digest != other.provenance.digest


@pytest.mark.parametrize("sun", [(0.6, 0.48, 0.64), (-0.64, 0.6, 0.48), None])
def test_its_sun_is_found_and_left_to_the_light_plan(tmp_path: Path, sun: tuple[float, float, float] | None) -> None:
    known, prepared = read_panorama(write_sky(tmp_path / "sky.hdr", 256, sun=sun))
    assert known.sun == (None if sun is None else pytest.approx(sun, abs=0.03))
    kept = luminance(_decoded(prepared, ".hdr"))
    assert kept.max() < 20 * np.median(kept[:64])


def test_a_wide_panorama_is_scaled_down(tmp_path: Path) -> None:
    known, prepared = read_panorama(write_sky(tmp_path / "sky.hdr", WIDEST + 512))
    small, _ = read_panorama(write_sky(tmp_path / "small.hdr", 512))
    assert _decoded(prepared, ".hdr").shape == (WIDEST // 2, WIDEST, 3)
    assert np.array(known.irradiance) == pytest.approx(np.array(small.irradiance), abs=0.01)


@pytest.mark.parametrize("suffix", [".hdr", ".exr"])
@pytest.mark.parametrize("share", [0.0, 0.001, 0.01, 0.3, 0.9])
def test_a_file_that_ends_too_early_is_refused(tmp_path: Path, suffix: str, share: float) -> None:
    whole = exr_of(sky()) if suffix == ".exr" else radiance_file(sky())
    (tmp_path / f"torn{suffix}").write_bytes(whole[: int(len(whole) * share)])
    with pytest.raises(InputError, match=r"torn.*; give an equirectangular"):
        read_panorama(tmp_path / f"torn{suffix}")


@pytest.mark.parametrize(
    ("name", "picture", "says"),
    [
        ("square.hdr", sky()[:, :64], "64 x 64 pixels"),
        ("tiny.hdr", sky(4, sun=None), "4 x 2 pixels"),
        ("black.hdr", np.zeros((16, 32, 3), np.float32), "black all over"),
        ("sky.png", sky(), "is no panorama"),
    ],
)
def test_what_is_no_panorama_is_refused(tmp_path: Path, name: str, picture: np.ndarray, says: str) -> None:
    (tmp_path / name).write_bytes(radiance_file(picture))
    with pytest.raises(InputError, match=says):
        read_panorama(tmp_path / name)
    with pytest.raises(InputError, match="cannot be read"):
        read_panorama(tmp_path / "none.hdr")


@pytest.mark.parametrize("gain", [1e-9, 1e-3, 1e4, 1e12])
def test_whatever_its_exposure_it_is_read(tmp_path: Path, gain: float) -> None:
    (tmp_path / "a.exr").write_bytes(exr_of(sky(sun=None) * np.float32(gain)))
    known, prepared = read_panorama(tmp_path / "a.exr")
    assert np.abs(known.irradiance).max() > 0 and _decoded(prepared, ".hdr").any()


def test_its_credits_lie_beside_it(tmp_path: Path) -> None:
    path = write_sky(tmp_path / "sky.hdr")
    (tmp_path / "sky.credits.toml").write_text('author = "Ann"\nlicense = "CC0-1.0"\n')
    assert read_panorama(path)[0].provenance.author == "Ann"
    (tmp_path / "sky.credits.toml").write_text("author =")
    with pytest.raises(InputError, match="credits"):
        read_panorama(path)
