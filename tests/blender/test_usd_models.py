"""A user's models in USD: the same thing comes in however the file has it, and nothing from outside the folder."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from storyblender.blender.props.build import build_prop  # noqa: E402
from storyblender.blender.props.imported import build_from_file, read_model  # noqa: E402
from storyblender.errors import InputError  # noqa: E402

pytestmark = pytest.mark.blender
BOX = """#usda 1.0
( defaultPrim = "box"
  metersPerUnit = 1
  upAxis = "Z" )
def Xform "box" {
def Mesh "sides" {
  int[] faceVertexCounts = [4, 4, 4, 4, 4]
  int[] faceVertexIndices = [0,3,2,1, 0,1,5,4, 1,2,6,5, 2,3,7,6, 3,0,4,7]
  point3f[] points = [(0,0,0), (1,0,0), (1,1,0), (0,1,0), (0,0,1), (1,0,1), (1,1,1), (0,1,1)]
  color3f[] primvars:displayColor = [(1, 0, 0)]
}
}
"""
HEAD = '#usda 1.0\n( defaultPrim = "top"\n metersPerUnit = 1\n upAxis = "Z"\n %s )\n'


@pytest.fixture(autouse=True)
def empty_file() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def written(mesh: bpy.types.Mesh, path: Path, scale: float = 1.0, **options: object) -> Path:
    """Write a mesh as a USD file and empty the open file."""
    obj = bpy.data.objects.new(path.stem, mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.scale = (scale,) * 3
    bpy.ops.wm.usd_export(filepath=str(path), **options)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return path


def pictured(folder: Path) -> bpy.types.Mesh:
    """Return a crate with a picture that lies in a folder."""
    image = bpy.data.images.new("planks", 8, 8)
    image.generated_color = (0.8, 0.1, 0.1, 1)
    image.filepath_raw, image.file_format = str(folder / "planks.png"), "PNG"
    image.save()
    material = bpy.data.materials.new("planks")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    shader = material.node_tree.nodes["Principled BSDF"]
    material.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    mesh = build_prop("crate").mesh
    mesh.materials.clear()
    mesh.materials.append(material)
    return mesh


@pytest.mark.parametrize(
    ("suffix", "up", "unit"),
    [(".usd", "Y", "CENTIMETERS"), (".usda", "Z", "METERS"), (".usdc", "Y", "METERS"), (".usdz", "Z", "CENTIMETERS")],
)
def test_a_thing_is_the_same_in_any_unit_and_with_any_axis_up(tmp_path: Path, suffix: str, up: str, unit: str) -> None:
    build = build_prop("armchair")
    ways = {"export_global_up_selection": up, "export_global_forward_selection": "NEGATIVE_Z" if up == "Y" else "Y"}
    path = written(
        build.mesh, tmp_path / f"armchair{suffix}", convert_orientation=True, convert_scene_units=unit, **ways
    )
    size = build_prop("armchair").dimensions
    found = build_from_file(path)
    assert found.dimensions == pytest.approx(size, rel=0.01)
    assert found.anchors[0].direction[1] < -0.99
    assert {material.name for material in found.mesh.materials} and len(found.mesh.materials) == 2
    assert not any("times" in note for note in found.notes), "it says its unit"


def test_the_unit_of_a_file_that_does_not_say_it_is_found_by_the_size(tmp_path: Path) -> None:
    size = build_prop("armchair").dimensions
    path = written(build_prop("armchair").mesh, tmp_path / "armchair.usda")
    path.write_text(path.read_text().replace("metersPerUnit = 1", ""))
    assert build_from_file(path).dimensions == pytest.approx(size, rel=0.01)


def test_parts_of_a_model_may_lie_in_other_files_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "box.usda").write_text(BOX)
    twice = "".join(
        f'def Xform "{name}" ( {kind} = @../parts/box.usda@\n instanceable = true ) {{\n'
        f" double3 xformOp:translate = ({x}, 0, 0)\n"
        ' uniform token[] xformOpOrder = ["xformOp:translate"]\n}\n'
        for name, kind, x in (("a", "references", 0), ("b", "payload", 3))
    )
    (tmp_path / "whole").mkdir()
    path = tmp_path / "whole" / "boxes.usda"
    path.write_text(HEAD % "" + f'def Xform "top" {{\n{twice}}}\n')
    model = read_model(path, tmp_path)
    assert np.ptp(model.vertices, axis=0) == pytest.approx((4, 1, 1))
    assert len(model.materials) == 1 and model.paint == pytest.approx(np.tile((1.0, 0, 0), (len(model.paint), 1)))


@pytest.mark.parametrize(
    ("of_layer", "of_prim"),
    [
        ("subLayers = [@../outside.usda@]", ""),
        ("", "references = @../outside.usda@"),
        ("", "payload = @ABSOLUTE@"),
        ("", "prepend references = @https://models.example/outside.usda@"),
        ("", "references = @./missing.usda@"),
        ("", 'references = @`"../outside.usda"`@'),
        ("", "references = @./box.usdz[box.usda]@"),
        ("", "references = @./box.usda:SDF_FORMAT_ARGS:target=x@"),
        ("", 'variantSets = "v"\n variants = { string v = "a" }'),
        ("", "references = @./step.usda@"),
        ("", "clips = { dictionary default = { asset[] assetPaths = [@./box.usda@] } }"),
    ],
)
def test_what_a_file_composes_from_elsewhere_refuses_it(tmp_path: Path, of_layer: str, of_prim: str) -> None:
    folder = tmp_path / "models"
    folder.mkdir()
    (tmp_path / "outside.usda").write_text(BOX)
    (folder / "box.usda").write_text(BOX)
    (folder / "step.usda").write_text(HEAD % "subLayers = [@../outside.usda@]")
    variant = ' variantSet "v" = { "a" ( references = @../outside.usda@ ) { } }\n' if "variants" in of_prim else ""
    prim = of_prim.replace("ABSOLUTE", str(tmp_path / "outside.usda"))
    (folder / "box_1.usda").write_text(HEAD % of_layer + f'def Mesh "top" ( {prim} ) {{\n{variant}}}\n')
    with pytest.raises(InputError, match=r"names|takes parts|value clips") as caught:
        build_from_file(folder / "box_1.usda", folder=folder)
    assert "\n" not in str(caught.value)


def test_a_link_does_not_lead_out_of_the_folder(tmp_path: Path) -> None:
    folder = tmp_path / "models"
    (folder / "deep" / "er").mkdir(parents=True)
    (folder / "link").symlink_to(folder / "deep" / "er")
    (folder / "deep" / "box.usda").write_text(BOX)
    (tmp_path / "outside.usda").write_text(BOX)
    (folder / "box.usda").symlink_to(tmp_path / "outside.usda")
    path = folder / "top.usda"
    path.write_text(HEAD % "subLayers = [@./link/../box.usda@]")
    with pytest.raises(InputError, match="outside the folder"):
        build_from_file(path, folder=folder)


def test_a_picture_outside_the_folder_is_left_out_with_a_note(tmp_path: Path) -> None:
    folder = tmp_path / "models"
    folder.mkdir()
    path = written(pictured(tmp_path), folder / "crate.usda", export_textures_mode="KEEP", relative_paths=True)
    assert "../planks.png" in path.read_text()
    found = build_from_file(path, folder=folder)
    assert [note for note in found.notes if "planks.png" in note and "left out" in note] and len(found.notes) == 1
    assert not any(each.name.startswith("TX_") for each in bpy.data.images)


def test_a_package_brings_its_picture(tmp_path: Path) -> None:
    (tmp_path / "pictures").mkdir()
    path = written(pictured(tmp_path / "pictures"), tmp_path / "crate.usdz", export_textures_mode="NEW")
    with zipfile.ZipFile(path) as package:
        assert any(name.endswith("planks.png") for name in package.namelist())
    (tmp_path / "pictures" / "planks.png").unlink()
    model = read_model(path, tmp_path)
    assert model.materials[0].picture and not model.notes


@pytest.mark.parametrize(
    ("name", "compression", "problem"),
    [
        ("../box.png", zipfile.ZIP_STORED, "leads out"),
        ("/box.png", zipfile.ZIP_STORED, "leads out"),
        ("box.png", zipfile.ZIP_DEFLATED, "compressed"),
    ],
)
def test_a_package_that_is_none_is_refused(tmp_path: Path, name: str, compression: int, problem: str) -> None:
    path = tmp_path / "box.usdz"
    with zipfile.ZipFile(path, "w") as package:
        package.writestr("box.usda", BOX)
        package.writestr(zipfile.ZipInfo(name), "x" * 99, compression)
    with pytest.raises(InputError, match=problem):
        build_from_file(path)


@pytest.mark.parametrize("suffix", [".usda", ".usdc", ".usdz"])
def test_a_broken_file_is_one_sentence(tmp_path: Path, suffix: str) -> None:
    whole = written(build_prop("crate").mesh, tmp_path / f"crate{suffix}").read_bytes()
    damaged = bytearray(whole)
    for place in np.random.default_rng(4).integers(0, len(whole), 300):
        damaged[place] ^= 85
    for number, data in enumerate((b"", b"PXR-USDC", b"#usda 1.0\n", whole[: len(whole) // 2], bytes(damaged))):
        path = tmp_path / f"crate_{number}{suffix}"
        path.write_bytes(data)
        with pytest.raises(InputError) as caught:
            build_from_file(path)
        assert "\n" not in str(caught.value)


def test_a_face_that_names_a_missing_corner_is_dropped(tmp_path: Path) -> None:
    path = tmp_path / "box.usda"
    path.write_text(BOX.replace("0,3,2,1", "0,3,2,999999"))
    model = read_model(path, tmp_path)
    assert len(model.vertices) == 8 and model.corners.max() < 8
