"""A model that is damaged, enormous or points elsewhere is one sentence, and quickly; never another exception."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from model_corpus import broken_glbs, broken_objs, glb, mutated, square

from storyblender.blender.models.blend_file import check_blend
from storyblender.blender.models.gltf import read_gltf
from storyblender.blender.models.obj import read_obj
from storyblender.blender.models.plain import PlainModel
from storyblender.errors import InputError


def is_one_sentence(error: InputError) -> bool:
    return "\n" not in str(error) and 0 < len(str(error)) < 250


@pytest.mark.parametrize("name", broken_glbs())
def test_a_broken_glb_is_one_sentence(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.glb").write_bytes(broken_glbs()[name])
    with pytest.raises(InputError) as told:
        read_gltf(tmp_path / "a.glb", tmp_path)
    assert is_one_sentence(told.value)


@pytest.mark.parametrize("name", broken_objs())
def test_a_broken_obj_is_one_sentence(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.obj").write_bytes(broken_objs()[name])
    with pytest.raises(InputError) as told:
        read_obj(tmp_path / "a.obj", tmp_path)
    assert is_one_sentence(told.value)


def test_whatever_happens_to_a_glb_is_a_model_or_one_sentence(tmp_path: Path) -> None:
    path, read, refused = tmp_path / "a.glb", 0, 0
    for seed in range(1000):
        path.write_bytes(mutated(seed))
        try:
            assert isinstance(read_gltf(path, tmp_path), PlainModel)
            read += 1
        except InputError as error:
            assert is_one_sentence(error), seed
            refused += 1
    assert min(read, refused) > 100, "both must happen"


def test_whatever_happens_to_an_obj_is_a_model_or_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    whole = (
        b"mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nvt 0 0\nusemtl x\ns 1\nf 1/1 2/1 3/1\nf 1 2 3\n"
    )
    for seed in range(500):
        chance = np.random.default_rng(seed)
        changed = bytearray(whole)
        for place in chance.integers(0, len(changed), 4):
            changed[place] = b"\n/ -.9e\\vtfx\0"[int(chance.integers(0, 13))]
        path.write_bytes(changed)
        try:
            assert isinstance(read_obj(path, tmp_path), PlainModel)
        except InputError as error:
            assert is_one_sentence(error), seed


ADDRESSES = ("../secret.bin", "../../../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd", "http://localhost/x",
             "\\\\server\\share\\x", "C:\\x.bin", "%2e%2e/secret.bin", "link.bin", "sub/../../secret.bin", "", "\0",
             "nothing.bin", ".")  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of models with a secret beside it, and a link to that."""
    _, data = square()
    (tmp_path / "secret.bin").write_bytes(data)
    models = tmp_path / "models"
    (models / "sub").mkdir(parents=True)
    (models / "link.bin").symlink_to(tmp_path / "secret.bin")
    (models / "good.bin").write_bytes(data)
    return models


@pytest.mark.parametrize("address", ADDRESSES)
def test_a_buffer_outside_the_folder_is_not_read(folder: Path, address: str) -> None:
    document, _ = square()
    document["buffers"][0]["uri"] = address
    (folder / "a.glb").write_bytes(glb(document))
    with pytest.raises(InputError) as told:
        read_gltf(folder / "a.glb", folder)
    assert is_one_sentence(told.value)
    document["buffers"][0]["uri"] = "sub/../good.bin"
    (folder / "a.glb").write_bytes(glb(document))
    assert len(read_gltf(folder / "a.glb", folder).sizes) == 2


@pytest.mark.parametrize("address", ADDRESSES)
def test_a_picture_or_library_outside_the_folder_is_left_out_with_a_note(folder: Path, address: str) -> None:
    document, data = square()
    document["images"], document["textures"] = [{"uri": address}], [{"source": 0}]
    document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    (folder / "a.glb").write_bytes(glb(document, data))
    model = read_gltf(folder / "a.glb", folder)
    assert model.materials[0].picture == b"" and len(model.notes) == 1
    if address.isprintable() and address.strip():
        (folder / "a.obj").write_text(f"mtllib {address}\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl x\nf 1 2 3\n")
        (folder / "a.mtl").write_text(f"newmtl x\nKd 1 0 0\nmap_Kd -s 1 1 1 {address}\n")
        model = read_obj(folder / "a.obj", folder)
        assert model.materials[0].color == (1, 0, 0) and model.materials[0].picture == b"" and len(model.notes) >= 1


def blend(blocks: list[tuple[bytes, bytes]], head: bytes = b"BLENDER-v405", ended: bool = True) -> bytes:
    body = b"".join(struct.pack("<4siQii", code, len(data), 1, 0, 1) + data for code, data in blocks)
    return head + body + (struct.pack("<4siQii", b"ENDB", 0, 0, 0, 0) if ended else b"")


BLENDS = {
    "empty": b"",
    "text": b"this is no blend file, whatever it is called",
    "header only": b"BLENDER-v405",
    "no end": blend([(b"DNA1", b"x" * 8)], ended=False),
    "no description": blend([(b"GLOB", b"x" * 8)]),
    "negative length": blend([]).replace(b"ENDB", b"GLOB") + struct.pack("<4siQii", b"GLOB", -5, 0, 0, 0),
    "length beyond the file": blend([])[:12] + struct.pack("<4siQii", b"GLOB", 1 << 30, 0, 0, 0),
    "newer": blend([(b"DNA1", b"")], b"BLENDER-v502"),
    "newer header": b"BLENDER17-01v0500" + b"x" * 60,
    "damaged compression": b"\x28\xb5\x2f\xfd" + b"x" * 60,
    "damaged gzip": b"\x1f\x8b" + b"x" * 60,
    "library outside": blend([(b"LI\0\0", b"LIscenes\0\0//../secret.blend\0\0"), (b"DNA1", b"")]),
    "library far outside": blend([(b"LI\0\0", b"\0/etc/secret.blend\0\0"), (b"DNA1", b"")]),
    "library missing": blend([(b"LI\0\0", b"\0//parts.blend\0\0"), (b"DNA1", b"")]),
}


@pytest.mark.parametrize("name", BLENDS)
def test_a_broken_blend_is_one_sentence_before_blender_sees_it(folder: Path, name: str) -> None:
    (folder / "a.blend").write_bytes(BLENDS[name])
    with pytest.raises(InputError) as told:
        check_blend(folder / "a.blend", folder)
    assert is_one_sentence(told.value)


def test_a_library_in_the_folder_is_let_through(folder: Path) -> None:
    (folder / "parts.blend").write_bytes(b"x")
    (folder / "a.blend").write_bytes(BLENDS["library missing"])
    check_blend(folder / "a.blend", folder)
