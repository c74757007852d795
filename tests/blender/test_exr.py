"""The reader of Blender's uncompressed EXR files."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from storyblender.blender.render.exr import color, read_channels
from storyblender.errors import EngineError

HALF, FLOAT = 1, 2


def written(path: Path, channels: dict[str, np.ndarray], compression: bytes = b"\0") -> Path:
    """Write channels, sorted by name as the format wants them, the way Blender does."""

    def attribute(name: str, kind: str, value: bytes) -> bytes:
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    names = sorted(channels)
    height, width = channels[names[0]].shape
    kinds = {name: HALF if channels[name].dtype == np.float16 else FLOAT for name in names}
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iiii", kinds[name], 0, 1, 1) for name in names) + b"\0"
    header = b"v/1\x01" + struct.pack("<i", 2)
    header += attribute("channels", "chlist", listed) + attribute("compression", "compression", compression)
    header += attribute("dataWindow", "box2i", struct.pack("<4i", 5, 3, 5 + width - 1, 3 + height - 1))
    header += attribute("lineOrder", "lineOrder", b"\0") + b"\0"
    rows = [b"".join(channels[name][row].tobytes() for name in names) for row in range(height)]
    starts = [len(header) + 8 * height + row * (8 + len(rows[0])) for row in range(height)]
    body = b"".join(struct.pack("<ii", 3 + row, len(data)) + data for row, data in enumerate(rows))
    path.write_bytes(header + struct.pack(f"<{height}q", *starts) + body)
    return path


def test_halves_and_floats_come_back_without_the_name_of_their_layer(tmp_path: Path) -> None:
    random = np.random.default_rng(0)
    shades = {name: random.random((4, 6)).astype(np.float16) for name in "RGBA"}
    depth = random.random((4, 6)).astype(np.float32) * 100
    stored = {f"View Layer.Combined.{name}": shade for name, shade in shades.items()} | {"View Layer.Depth.Z": depth}
    channels = read_channels(written(tmp_path / "a.exr", stored))
    assert set(channels) == {"Combined.R", "Combined.G", "Combined.B", "Combined.A", "Depth.Z"}
    np.testing.assert_array_equal(channels["Depth.Z"], depth)
    np.testing.assert_array_equal(color(channels)[..., 1], shades["G"].astype(np.float32))


def test_what_is_no_picture_or_a_packed_one_is_told(tmp_path: Path) -> None:
    (tmp_path / "text.exr").write_bytes(b"no picture")
    stored = {"Layer.Combined.R": np.zeros((2, 2), np.float16)}
    packed = written(tmp_path / "packed.exr", stored, b"\3")
    (tmp_path / "short.exr").write_bytes(written(tmp_path / "whole.exr", stored).read_bytes()[:-3])
    (tmp_path / "head.exr").write_bytes((tmp_path / "whole.exr").read_bytes()[:40])
    names = ("none.exr", "text.exr", "short.exr", "head.exr")
    for path in (packed, *(tmp_path / name for name in names)):
        with pytest.raises(EngineError):
            read_channels(path)
