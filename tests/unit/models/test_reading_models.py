"""What is read of whole models: materials in any order, lines by their number, lists checked once."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from storyblender.blender.models.document import Document
from storyblender.blender.models.obj import read_obj
from storyblender.errors import InputError

FACE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n"


@pytest.mark.parametrize("lines", ["Kd 1 0 0\nmap_Kd p.png", "map_Kd p.png\nKd 0 0 0"])
def test_a_picture_is_not_tinted_wherever_the_color_stands(tmp_path: Path, lines: str) -> None:
    Image.new("RGB", (4, 4), (9, 90, 200)).save(tmp_path / "p.png")
    (tmp_path / "a.mtl").write_text(f"newmtl paint\n{lines}\n")
    (tmp_path / "a.obj").write_text(f"mtllib a.mtl\n{FACE}")
    paint = read_obj(tmp_path / "a.obj", tmp_path).materials[0]
    assert paint.picture and paint.color == (1.0, 1.0, 1.0)


def test_a_bad_line_is_named_by_its_number_in_the_file(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text(f"# made by hand\n\n# with comments\n{FACE}v 1 two 3\n")
    with pytest.raises(InputError, match="its line 9 is no 'v'"):
        read_obj(tmp_path / "a.obj", tmp_path)


class CountedList(list[Any]):
    """A list that counts how often all of it is looked through."""

    looked_through = 0

    def __iter__(self) -> Iterator[Any]:
        self.looked_through += 1
        return super().__iter__()


def test_a_list_of_a_gltf_is_checked_once(tmp_path: Path) -> None:
    nodes = CountedList({} for _ in range(100))
    document = Document(json={"nodes": nodes}, folder=tmp_path, base=tmp_path, binary=b"")
    for index in range(100):
        document.item("nodes", index)
    assert nodes.looked_through == 1
