"""A user's models in Blender: what comes in is a surface and nothing else, where it can be used and as it was made."""

from typing import get_args

import numpy as np
import pytest
from tests.model_files import write_cabinet

bpy = pytest.importorskip("bpy")

from storyblender.blender.measure.surfaces import level_field  # noqa: E402
from storyblender.blender.merge import merge_duplicates  # noqa: E402
from storyblender.blender.props.build import build_prop  # noqa: E402
from storyblender.blender.props.imported import build_from_file  # noqa: E402
from storyblender.blender.session import BlenderSession  # noqa: E402
from storyblender.errors import InputError  # noqa: E402
from storyblender.geometry.resting import find_bed, find_seats  # noqa: E402
from storyblender.memory.asset_sheet import Asset, AssetDimension, CanonicalAsset, ModelPose, ModelSide  # noqa: E402
from storyblender.memory.jobs import AssetJob  # noqa: E402


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def points(mesh):
    return np.array([vertex.co[:] for vertex in mesh.vertices])


def placed(mesh, yaw=0.0, scale=1.0):
    """Put a mesh into the scene as the only thing that is selected."""
    obj = bpy.data.objects.new("thing", mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.rotation_euler[2], obj.scale = np.radians(yaw), (scale,) * 3
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def written(path):
    """Write the scene as a model and empty the open file."""
    if path.suffix in (".glb", ".gltf"):
        kind = "GLB" if path.suffix == ".glb" else "GLTF_SEPARATE"
        bpy.ops.export_scene.gltf(filepath=str(path), export_format=kind)
    elif path.suffix == ".obj":
        bpy.ops.wm.obj_export(filepath=str(path), path_mode="COPY")
    else:
        bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return path


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".obj", ".blend"])
def test_a_turned_model_in_centimetres_comes_back_canonical(tmp_path, suffix):
    build = build_prop("armchair")
    before = points(build.mesh)
    placed(build.mesh, 180, 100)
    found = build_from_file(written(tmp_path / f"chair{suffix}"))
    assert found.dimensions == pytest.approx(build.dimensions, rel=0.01)
    after = points(found.mesh)
    high = before[:, 2] > 0.7 * build.dimensions[2], after[:, 2] > 0.7 * build.dimensions[2]
    assert after[high[1], 1].mean() == pytest.approx(before[high[0], 1].mean(), abs=0.05)
    assert any("centimetres" in note for note in found.notes) and any("180 degrees" in note for note in found.notes)
    (sat,) = (anchor for anchor in found.anchors if anchor.kind == "seat")
    (made,) = (anchor for anchor in build.anchors if anchor.kind == "seat")
    assert sat.location == pytest.approx(made.location, abs=0.08) and sat.direction[1] < -0.99


def test_a_compressed_model_is_unpacked_by_blender_and_its_addresses_are_checked_all_the_same(tmp_path):
    build = build_prop("armchair")
    placed(build.mesh)
    for name, kind in (("a.glb", "GLB"), ("b.gltf", "GLTF_SEPARATE")):
        bpy.ops.export_scene.gltf(
            filepath=str(tmp_path / name), export_format=kind, export_draco_mesh_compression_enable=True
        )
    found = build_from_file(tmp_path / "a.glb")
    assert found.dimensions == pytest.approx(build.dimensions, rel=0.02)
    assert any(anchor.kind == "seat" for anchor in found.anchors) and len(found.mesh.materials) == 2
    (tmp_path / "models").mkdir()
    (tmp_path / "models/b.gltf").write_text((tmp_path / "b.gltf").read_text().replace('"b.bin"', '"../b.bin"'))
    with pytest.raises(InputError, match="outside the folder"):
        build_from_file(tmp_path / "models/b.gltf")


def dial(mesh):
    """Return the middle of the red faces of a cabinet."""
    (red,) = (i for i, each in enumerate(mesh.materials) if shown_color(each)[0] > 0.5)
    return np.mean([each.center[:] for each in mesh.polygons if each.material_index == red], axis=0)


def shown_color(material):
    return material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value


@pytest.mark.parametrize(
    ("front", "top", "dimensions", "place"),
    [
        (None, None, (0.56, 0.8, 0.6), (0.25, -0.2, 0.475)),
        ("right", "top", (0.8, 0.56, 0.6), (-0.2, -0.25, 0.475)),
        ("left", "top", (0.8, 0.56, 0.6), (0.2, 0.25, 0.475)),
        ("back", "top", (0.56, 0.8, 0.6), (-0.25, 0.2, 0.475)),
        ("top", "left", (0.8, 0.6, 0.56), (-0.2, -0.175, 0.03)),
        (None, "bottom", (0.56, 0.8, 0.6), (-0.25, -0.2, 0.125)),
        (None, "back", (0.56, 0.6, 0.8), (0.25, -0.175, 0.2)),
    ],
)
def test_the_front_and_the_top_of_a_model_may_be_decided(tmp_path, front, top, dimensions, place):
    """The rules see nothing in a cabinet that tells its front."""
    found = build_from_file(write_cabinet(tmp_path, "thing"), pose=ModelPose(front=front, top=top))
    assert found.dimensions == pytest.approx(dimensions)
    assert dial(found.mesh) == pytest.approx(place, abs=0.04)


def test_a_model_whose_front_is_decided_is_not_turned_by_its_seat(tmp_path):
    placed(build_prop("armchair").mesh, 90)
    path = written(tmp_path / "chair.glb")
    as_it_is = build_from_file(path, pose=ModelPose(front="front", top="top"))
    assert as_it_is.anchors[0].direction[0] == pytest.approx(1)
    turned = build_from_file(path, pose=ModelPose(front="right", top="top"))
    assert turned.anchors[0].direction[1] == pytest.approx(-1)


def test_every_side_of_a_model_is_drawn_at_one_scale(tmp_path):
    session = BlenderSession(tmp_path / "project", (tmp_path,))
    write_cabinet(tmp_path)
    params = ModelPose(front="front", top="top").params
    canonical = CanonicalAsset(source="file", key="radio.obj", params=params, dimensions=(1, 1, 1), digest="")
    asset = Asset(asset_id="radio", asset_type="object", description="", canonical=canonical)
    assert session.draw_sides(AssetJob(asset=asset), "build/views/1") == pytest.approx((0.56, 0.8, 0.6))
    shares, sizes = {}, {}
    for path in (tmp_path / "project/build/views/1").iterdir():
        image = bpy.data.images.load(str(path))
        pixels = np.array(image.pixels).reshape(image.size[1], image.size[0], 4)[..., :3]
        shares[path.stem] = (pixels[..., 0] > pixels[..., 1] + 0.3).mean()
        thing = np.abs(pixels - pixels[0, 0]).max(axis=2) > 0.08
        sizes[path.stem] = thing.any(axis=0).sum() / 256 * 0.864, thing.any(axis=1).sum() / 256 * 0.864
    assert shares.keys() == {*get_args(ModelSide), "portrait"}
    assert max(shares, key=shares.__getitem__) == "right" and not shares["left"]
    assert sizes["front"] == pytest.approx((0.56, 0.6), abs=0.02)
    assert sizes["right"] == pytest.approx((0.8, 0.6), abs=0.02)
    assert sizes["top"] == pytest.approx((0.56, 0.8), abs=0.02)
    assert not (tmp_path / "project/assets").exists(), "nothing is kept"


@pytest.mark.parametrize("key", ["desk", "bicycle", "table_lamp", "car"])
def test_what_has_no_back_keeps_its_pose_and_size(tmp_path, key):
    build = build_prop(key)
    before = points(build.mesh)
    low, high = before.min(axis=0), before.max(axis=0)
    heavy = (np.median(before, axis=0) - low) / (high - low)
    placed(build.mesh)
    found = build_from_file(written(tmp_path / f"{key}.glb"), AssetDimension(width=1.2 * (high - low)[:2].max()))
    after = points(found.mesh)
    assert found.dimensions == pytest.approx(tuple(high - low), rel=0.01) and found.notes == ()
    assert (np.median(after, axis=0) - after.min(axis=0)) / np.ptp(after, axis=0) == pytest.approx(heavy, abs=0.15)


@pytest.mark.parametrize("key", ["chair", "sofa", "office_chair", "rocking_chair", "park_bench", "throne"])
def test_seats_are_found_where_the_library_has_them(key):
    build = build_prop(key)
    found = find_seats(level_field(build.mesh), "seat")
    made = [anchor for anchor in build.anchors if anchor.kind == "seat"]
    assert found.backed and abs(len(found.anchors) - len(made)) <= 1
    for seat in found.anchors:
        assert seat.direction[1] < -0.99
        assert seat.location[2] == pytest.approx(made[0].location[2], abs=0.04)
        assert seat.location[1] == pytest.approx(made[0].location[1], abs=0.08)


def test_a_bed_is_found_where_the_library_has_it():
    build = build_prop("bed")
    (bed, *_), made = find_bed(level_field(build.mesh), "bed").anchors, build.anchors[0]
    assert bed.kind == "bed" and bed.location == pytest.approx(made.location, abs=0.06)
    assert bed.direction == pytest.approx(made.direction, abs=1e-6) and bed.size[1] > 1.8


def test_a_lamp_can_be_taken_by_its_stem(tmp_path):
    placed(build_prop("table_lamp").mesh)
    found = build_from_file(written(tmp_path / "lamp.glb"))
    right, left = (anchor for anchor in found.anchors if anchor.kind == "grip")
    assert right.location[0] == pytest.approx(-left.location[0], abs=1e-6) and -0.06 < right.location[0] < 0
    assert 0.1 < right.location[2] < 0.35


def test_nothing_but_the_surface_of_a_blend_comes_in(tmp_path):
    obj = placed(build_prop("crate").mesh)
    text = bpy.data.texts.new("start.py")
    text.write(f"open({str(tmp_path / 'ran')!r}, 'w')")
    text.use_module = True
    obj["expression"], obj["text"] = "__import__('os')", text
    driver = obj.driver_add("location", 0).driver
    driver.type, driver.expression = "SCRIPTED", f"len(open({str(tmp_path / 'ran')!r}, 'w').name) * 0"
    material = obj.data.materials[0]
    script = material.node_tree.nodes.new("ShaderNodeScript")
    script.mode, script.filepath = "EXTERNAL", str(tmp_path / "evil.osl")
    picture = bpy.data.images.new("outside", 4, 4)
    picture.filepath_raw, picture.file_format = str(tmp_path / "secret.png"), "PNG"
    picture.save()
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = picture
    material.node_tree.links.new(node.outputs[0], material.node_tree.nodes["Principled BSDF"].inputs[0])
    sound = bpy.data.sounds.load(str(tmp_path / "secret.png"))
    obj["sound"] = sound
    bpy.ops.rigidbody.object_add()
    folder = tmp_path / "models"
    folder.mkdir()
    found = build_from_file(written(folder / "crate.blend"), folder=folder)
    assert any("outside the folder" in note for note in found.notes)
    out = bpy.data.objects.new("crate", found.mesh)
    bpy.data.libraries.write(str(tmp_path / "asset.blend"), {out}, fake_user=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "asset.blend"))
    kinds = [name for name in dir(bpy.data) if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection)]
    there = {name for name in kinds if len(getattr(bpy.data, name))}
    assert {"meshes", "materials"} <= there
    assert not there & {"texts", "sounds", "libraries", "actions", "node_groups", "curves", "armatures", "worlds"}
    assert all(not block.animation_data for block in (*bpy.data.objects, *bpy.data.materials))
    assert {node.type for each in bpy.data.materials for node in each.node_tree.nodes} <= {
        "BSDF_PRINCIPLED", "OUTPUT_MATERIAL", "TEX_IMAGE"}  # fmt: skip
    assert all(set(block.keys()) <= {"digest"} for block in (*bpy.data.meshes, *bpy.data.materials, *bpy.data.objects))
    assert not (tmp_path / "ran").exists()


def test_materials_of_one_name_from_two_files_stay_two(tmp_path):
    for name, color in (("red", (1, 0, 0, 1)), ("blue", (0, 0, 1, 1)), ("red too", (1, 0, 0, 1))):
        mesh = build_prop("crate").mesh
        mesh.materials.clear()
        block = bpy.data.materials.new("Material")
        block.use_nodes = True
        block.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = color
        mesh.materials.append(block)
        placed(mesh)
        written(tmp_path / f"{name}.glb")
    built = [build_from_file(tmp_path / f"{name}.glb") for name in ("red", "blue", "red too")]
    for index, build in enumerate(built):
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(str(index), build.mesh))
    merge_duplicates()
    red, blue, again = ([block.name for block in build.mesh.materials] for build in built)
    assert red == again != blue


@pytest.mark.parametrize("suffix", [".glb", ".blend"])
def test_vertex_colours_are_a_picture_that_every_renderer_shows(tmp_path, suffix):
    mesh = build_prop("crate").mesh
    mesh.materials.clear()
    layer = mesh.color_attributes.new("Color", "FLOAT_COLOR", "CORNER")
    height = points(mesh)[[loop.vertex_index for loop in mesh.loops], 2]
    colors = np.where(height[:, None] > height.mean(), (1.0, 0, 0, 1), (0, 0, 1.0, 1)).astype(np.float32)
    layer.data.foreach_set("color", colors.ravel())
    block = bpy.data.materials.new("painted")
    block.use_nodes = True
    node = block.node_tree.nodes.new("ShaderNodeVertexColor")
    node.layer_name = "Color"
    block.node_tree.links.new(node.outputs[0], block.node_tree.nodes["Principled BSDF"].inputs[0])
    mesh.materials.append(block)
    placed(mesh)
    found = build_from_file(written(tmp_path / f"box{suffix}"))
    (made,) = found.mesh.materials
    image = made.node_tree.nodes.active.image
    assert image.packed_file is not None
    pixels = np.array(image.pixels).reshape(image.size[1], image.size[0], 4)
    layout = np.array([loop.uv[:] for loop in found.mesh.uv_layers.active.data])
    shown = pixels[(layout[:, 1] * image.size[1]).astype(int), (layout[:, 0] * image.size[0]).astype(int), :3]
    z = points(found.mesh)[[loop.vertex_index for loop in found.mesh.loops], 2]
    assert shown[z < 0.05].mean(axis=0)[2] > 0.6 and shown[z > z.max() - 0.05].mean(axis=0)[0] > 0.6


def test_a_file_without_a_mesh_is_refused(tmp_path):
    with pytest.raises(InputError, match="no mesh"):
        build_from_file(written(tmp_path / "empty.blend"))
    with pytest.raises(InputError, match="no model"):
        build_from_file(tmp_path / "notes.txt")


@pytest.mark.slow
def test_a_blend_that_is_damaged_inside_is_one_sentence_and_no_crash(tmp_path):
    placed(build_prop("armchair").mesh)
    bpy.context.preferences.filepaths.use_file_compression = False
    whole = written(tmp_path / "whole.blend").read_bytes()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    outcomes = []
    for seed in range(12):
        chance = np.random.default_rng(seed)
        data = bytearray(whole)
        for place in chance.integers(200, len(data), 400):
            data[place] = int(chance.integers(0, 256))
        path = tmp_path / f"{seed}.blend"
        path.write_bytes(bytes(data))
        try:
            build_from_file(path)
            outcomes.append("read")
        except InputError as error:
            assert "\n" not in str(error)
            outcomes.append(error.problem)
    assert len(outcomes) == 12


def test_the_credit_of_a_blend_is_that_of_its_asset(tmp_path):
    obj = placed(build_prop("crate").mesh)
    collection = bpy.data.collections.new("crate")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(obj)
    collection.asset_mark()
    collection.asset_data.author, collection.asset_data.license = "Ann", "CC0-1.0"
    path = written(tmp_path / "crate.blend")
    assert (build_from_file(path).credit.author, build_from_file(path).credit.license) == ("Ann", "CC0-1.0")
    (tmp_path / "credits.toml").write_text('author = "Bob"')
    assert (build_from_file(path).credit.author, build_from_file(path).credit.license) == ("Bob", "CC0-1.0")


def a_textured_crate():
    """Return a mesh whose material has maps for colour, roughness, metal and normals."""
    mesh = build_prop("crate").mesh
    if not mesh.uv_layers:
        mesh.uv_layers.new(name="UVMap")
    rng = np.random.default_rng(1)
    mesh.uv_layers[0].uv.foreach_set("vector", rng.random(len(mesh.loops) * 2).astype(np.float32))
    material = bpy.data.materials.new("wood")
    material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes["Principled BSDF"]
    for name, color in (("Base Color", (0.8, 0.2, 0.1)), ("Roughness", (0.9, 0.3, 0.1)), ("Normal", (0.5, 0.5, 1.0))):
        image = bpy.data.images.new(name, 8, 8)
        image.colorspace_settings.name = "sRGB" if name == "Base Color" else "Non-Color"
        image.pixels.foreach_set(np.tile(np.array([*color, 1], np.float32), 64))
        image.pack()
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        out = node.outputs["Color"]
        if name == "Roughness":
            parted = tree.nodes.new("ShaderNodeSeparateColor")
            tree.links.new(out, parted.inputs["Color"])
            out = parted.outputs["Green"]
        if name == "Normal":
            bumps = tree.nodes.new("ShaderNodeNormalMap")
            tree.links.new(out, bumps.inputs["Color"])
            out = bumps.outputs["Normal"]
        tree.links.new(out, shader.inputs[name])
    mesh.materials.clear()
    mesh.materials.append(material)
    return mesh


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".blend"])
def test_the_maps_of_a_model_survive(tmp_path, suffix):
    placed(a_textured_crate())
    mesh = build_from_file(written(tmp_path / f"crate{suffix}")).mesh
    tree = mesh.materials[0].node_tree
    shader = tree.nodes["Principled BSDF"]
    assert tree.nodes.active == shader.inputs["Base Color"].links[0].from_node
    color = shader.inputs["Base Color"].default_value
    assert tuple(color)[:3] == pytest.approx((0.8**2.2, 0.2**2.2, 0.1**2.2), abs=0.03)
    rough = shader.inputs["Roughness"].links[0].from_node.image
    normals = shader.inputs["Normal"].links[0].from_node.inputs["Color"].links[0].from_node.image
    assert rough.pixels[0] == pytest.approx(0.3, abs=0.02) and rough.colorspace_settings.name == "Non-Color"
    assert normals.pixels[2] > 0.9 and all(image.packed_file for image in (rough, normals))


@pytest.mark.parametrize(("name", "height"), [("wall_bracket", 0.3), ("bracket", 0.22)])
def test_what_hangs_on_a_wall_is_not_laid_on_its_back(tmp_path, name, height):
    lines = []
    for number, (low, high) in enumerate(
        (((-0.1, 0, 0.0), (0.1, 0.3, 0.02)), ((-0.03, 0.26, 0.02), (0.03, 0.3, 0.22)))
    ):
        lines += [f"v {x} {y} {z}" for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
        faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
        lines += [f"f {' '.join(str(corner + 8 * number) for corner in face)}" for face in faces]
    path = tmp_path / f"{name}.obj"
    path.write_text("\n".join(lines) + "\n")
    build = build_from_file(path, prop="")
    assert build.dimensions[2] / build.dimensions[0] == pytest.approx(height / 0.2, rel=0.02)
