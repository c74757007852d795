"""What is read of whole models: materials in any order, lines by their number, lists checked once."""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from tests.unit.models.model_corpus import glb, square

from storyblender.blender.models.document import Document
from storyblender.blender.models.gltf import read_gltf
from storyblender.blender.models.obj import read_obj
from storyblender.blender.models.plain import PlainMaterial
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


def picture(red: int, green: int, blue: int) -> str:
    out = io.BytesIO()
    Image.new("RGB", (4, 4), (red, green, blue)).save(out, "PNG")
    return f"data:image/png;base64,{base64.b64encode(out.getvalue()).decode()}"


def level(data: bytes) -> tuple[int, ...]:
    """Return the first pixel of a picture."""
    return tuple(np.asarray(Image.open(io.BytesIO(data)))[0, 0].ravel().tolist())


def mapped(tmp_path: Path, **material: Any) -> PlainMaterial:
    """Return the material of a square with five pictures: colours, surface, normals, glow, and one that is broken."""
    document, data = square()
    document["materials"] = [{"name": "paint", **material}]
    uris = [picture(200, 100, 50), picture(7, 128, 255), picture(128, 128, 255), picture(255, 0, 0), "data:,x"]
    document["images"] = [{"uri": uri} for uri in uris]
    document["textures"] = [{"source": index} for index in range(len(uris))]
    (tmp_path / "a.glb").write_bytes(glb(document, data))
    model = read_gltf(tmp_path / "a.glb", tmp_path)
    assert bool(model.notes) == any(word in json.dumps(material) for word in ('"index": 4', '"texCoord": 1'))
    return model.materials[0]


def test_each_map_of_a_gltf_is_what_it_is_for(tmp_path: Path) -> None:
    base = {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}, "roughnessFactor": 0.5}
    found = mapped(
        tmp_path,
        pbrMetallicRoughness=base,
        normalTexture={"index": 2, "scale": 0.7},
        emissiveTexture={"index": 3},
        emissiveFactor=[1, 1, 1],
    )
    assert level(found.picture) == (200, 100, 50) and level(found.normal_map) == (128, 128, 255)
    assert level(found.roughness_map) == (64,) and level(found.metallic_map) == (255,), "green and blue, by the factors"
    assert level(found.glow_map) == (255, 0, 0) and found.relief == 0.7


@pytest.mark.parametrize("texture", [{"index": 4}, {"index": 2, "texCoord": 1}])
def test_a_map_that_cannot_be_used_is_left_out_with_a_note(tmp_path: Path, texture: dict[str, int]) -> None:
    found = mapped(
        tmp_path,
        pbrMetallicRoughness={"baseColorTexture": {"index": 0}},
        normalTexture=texture,
        emissiveTexture=texture,
        emissiveFactor=[1, 1, 1],
    )
    assert found.picture and not found.normal_map and found.emission == (0, 0, 0), "no glow is better than all aglow"


def test_the_maps_of_an_mtl_are_read_and_heights_are_no_normals(tmp_path: Path) -> None:
    for name, color in (("n", (128, 128, 255)), ("h", (90, 90, 90)), ("r", (40, 40, 40))):
        Image.new("RGB", (4, 4), color).save(tmp_path / f"{name}.png")
    (tmp_path / "a.obj").write_text(f"mtllib a.mtl\n{FACE}")
    (tmp_path / "a.mtl").write_text("newmtl paint\nmap_Pr r.png\nmap_Bump -bm 1.0 n.png\n")
    model = read_obj(tmp_path / "a.obj", tmp_path)
    assert level(model.materials[0].roughness_map) == (40,) and model.materials[0].normal_map and not model.notes
    (tmp_path / "a.mtl").write_text("newmtl paint\nmap_Bump h.png\n")
    model = read_obj(tmp_path / "a.obj", tmp_path)
    assert not model.materials[0].normal_map and "heights" in model.notes[0]
