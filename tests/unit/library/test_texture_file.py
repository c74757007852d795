"""The pictures of a user's surface: told apart, prepared, refused."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.textures import BROWN, PALE, boards, write_surface

from storyblender.errors import InputError
from storyblender.library.texture_file import SIDE, read_texture, surfaces_in
from storyblender.memory.texture import Texture, TextureMap


def shown(texture: Texture, pictures: dict[str, bytes], name: TextureMap) -> Image.Image:
    return Image.open(io.BytesIO(pictures[texture.file(name)]))


def test_a_folder_holds_the_maps_of_a_surface(tmp_path: Path) -> None:
    texture, pictures = read_texture(write_surface(tmp_path / "oak"), 1.5)
    assert texture.maps == ("color", "normal", "roughness") and set(pictures) == set(texture.files)
    assert texture.metres == 1.5 and texture.upright and texture.roughness == pytest.approx(0.4, abs=0.01)
    assert texture.provenance.author == "Ann Joiner" and texture.provenance.file == "oak_boards_diff_1k.png"
    means = (np.array([BROWN, PALE]) / 255) ** 2.2
    assert texture.color == pytest.approx(means.mean(axis=0), abs=0.02)
    assert read_texture(tmp_path / "oak" / "oak_boards_diff_1k.png", 1.5) == (texture, pictures)
    assert read_texture(tmp_path / "oak")[0].metres == 2.0


@pytest.mark.parametrize(
    "names",
    [
        ("Planks012_1K-JPG_Color.jpg", "Planks012_1K-JPG_NormalGL.jpg", "Planks012_1K-JPG_Roughness.jpg"),
        ("planks-basecolor.png", "planks-normal.png", "planks-roughness.png"),
        ("planks_col.jpg", "planks_nrm.jpg", "planks_rgh.jpg"),
        ("Planks_Base_Color_2048.png", "Planks_Normal_2048.png", "Planks_Roughness_2048.png"),
        ("planks.albedo.png", "planks.nor.png", "planks.rough.png"),
    ],
)
def test_the_usual_names_are_known(tmp_path: Path, names: tuple[str, str, str]) -> None:
    color, normal, rough = names
    boards().save(tmp_path / color)
    Image.new("RGB", (64, 64), (128, 128, 255)).save(tmp_path / normal)
    Image.new("L", (64, 64), 51).save(tmp_path / rough)
    texture, _ = read_texture(tmp_path)
    assert texture.maps == ("color", "normal", "roughness") and texture.roughness == pytest.approx(0.2, abs=0.01)


def test_normals_of_directx_gloss_and_packed_maps_are_turned_into_ours(tmp_path: Path) -> None:
    boards().save(tmp_path / "a_diff.png")
    Image.new("RGB", (64, 64), (128, 160, 246)).save(tmp_path / "a_nor_dx.png")
    Image.new("RGB", (64, 64), (255, 77, 0)).save(tmp_path / "a_arm.png")
    texture, pictures = read_texture(tmp_path)
    assert np.asarray(shown(texture, pictures, "normal"))[32, 32] == pytest.approx((128, 95, 246), abs=2)
    assert texture.roughness == pytest.approx(77 / 255, abs=0.01)
    (tmp_path / "a_arm.png").unlink()
    Image.fromarray(np.full((64, 64), 65535 // 4, np.uint16)).save(tmp_path / "a_gloss.png")
    assert read_texture(tmp_path)[0].roughness == pytest.approx(0.75, abs=0.01)


def test_prepared_pictures_are_square_and_no_larger_than_needed(tmp_path: Path) -> None:
    Image.new("RGB", (3 * SIDE, SIDE), BROWN).save(tmp_path / "wide_diff.png")
    texture, pictures = read_texture(tmp_path, 6.0)
    assert shown(texture, pictures, "color").size == (SIDE, SIDE)
    assert texture.metres == 6.0, "three copies on top of each other are as high as one is wide"
    (tmp_path / "high").mkdir()
    Image.new("RGB", (100, 200), BROWN).save(tmp_path / "high" / "wall.png")
    texture, pictures = read_texture(tmp_path / "high", 1.0)
    assert shown(texture, pictures, "color").size == (200, 200) and texture.metres == 2.0
    assert texture.upright is None


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 0.95])
def test_a_picture_that_ends_too_early_is_refused(tmp_path: Path, share: float) -> None:
    noise = np.random.default_rng(0).integers(0, 255, (128, 128, 3), np.uint8)
    Image.fromarray(noise).save(path := tmp_path / "torn_diff.png")
    path.write_bytes(path.read_bytes()[: int(path.stat().st_size * share)])
    with pytest.raises(InputError, match=r"torn_diff\.png: cannot be read as a picture"):
        read_texture(path)


def test_what_is_no_surface_is_refused_with_one_sentence(tmp_path: Path) -> None:
    def refused(path: Path, says: str, metres: float | None = None) -> None:
        with pytest.raises(InputError, match=says) as found:
            read_texture(path, metres)
        assert "\n" not in str(found.value)

    refused(tmp_path / "gone", "there is no such")
    refused(tmp_path, "holds no colour picture")
    (tmp_path / "a.svg").write_text("<svg><script>alert(1)</script></svg>")
    refused(tmp_path / "a.svg", "is no picture of a surface")
    (tmp_path / "b_diff.png").write_text("<svg><script>alert(1)</script></svg>")
    refused(tmp_path / "b_diff.png", "cannot be read as a picture")
    (tmp_path / "b_diff.png").unlink()
    write_surface(tmp_path / "two", "oak")
    write_surface(tmp_path / "two", "elm")
    refused(tmp_path / "two", "several surfaces")
    refused(tmp_path / "two" / "oak_nor_gl_1k.png", "is the normal map")
    refused(tmp_path / "two" / "oak_diff_1k.png", "too small or too large", 1e-6)
    boards().save(tmp_path / "two" / "oak_nor_gl_1k.png")
    refused(tmp_path / "two" / "oak_diff_1k.png", "is no normal map")
    Image.new("RGB", (8, 8)).save(tmp_path / "tiny_diff.png")
    refused(tmp_path / "tiny_diff.png", "8 x 8 pixels")


def test_a_bomb_is_refused_by_its_header(tmp_path: Path) -> None:
    import struct
    import zlib

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", 60000, 60000, 8, 2, 0, 0, 0))
    bomb = b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(bytes(1 << 20))) + chunk(b"IEND", b"")
    (tmp_path / "bomb_diff.png").write_bytes(bomb)
    with pytest.raises(InputError, match=r"bomb_diff\.png"):
        read_texture(tmp_path / "bomb_diff.png")


def test_a_credits_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    (write_surface(tmp_path / "oak") / "credits.toml").write_text("author = [")
    with pytest.raises(InputError, match=r"credits\.toml: cannot be read as credits"):
        read_texture(tmp_path / "oak")


def test_photographs_and_pictures_of_models_are_not_offered_as_surfaces(tmp_path: Path) -> None:
    folder = write_surface(tmp_path / "things")
    for name in ("holiday.jpg", "board.png", "chair_diff.png", "cloth col_1k.png", "lamp_albedo.png"):
        boards().save(folder / name)
    (folder / "chair.fbx").write_bytes(b"")
    (folder / "table.gltf").write_text('{"images": [{"uri": "cloth%20col_1k.png"}]}')
    (tmp_path / "lamp.obj").write_text("")
    (tmp_path / "photo.jpg").write_bytes((folder / "holiday.jpg").read_bytes())
    assert [each.name for each in surfaces_in(folder, tmp_path)] == ["oak_boards_diff_1k.png"]
    assert surfaces_in(tmp_path, tmp_path) == []
    mine = write_surface(tmp_path / "My Textures")
    boards().save(mine / "brick.jpg")
    assert [each.name for each in surfaces_in(mine, tmp_path)] == ["brick.jpg", "oak_boards_diff_1k.png"]
