import numpy as np
import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")

from tests.every import every  # noqa: E402

from storyblender.blender.materials import material  # noqa: E402
from storyblender.blender.measure.hashing import geometry_hash  # noqa: E402
from storyblender.blender.measure.surfaces import find_tops  # noqa: E402
from storyblender.blender.mesh_builder import MeshBuilder  # noqa: E402
from storyblender.blender.props.build import build_prop  # noqa: E402
from storyblender.blender.props.parts import bent  # noqa: E402
from storyblender.blender.props.portrait import render_portrait  # noqa: E402
from storyblender.blender.props.registry import builders  # noqa: E402
from storyblender.blender.props.stand_in import build_stand_in  # noqa: E402
from storyblender.catalog.props import PROPS  # noqa: E402
from storyblender.catalog.stand_ins import STAND_INS  # noqa: E402
from storyblender.catalog.writing import SCREENS, WRITING  # noqa: E402
from storyblender.errors import InputError  # noqa: E402
from storyblender.memory.asset_sheet import AssetDimension  # noqa: E402


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def points(mesh):
    return np.array([vertex.co[:] for vertex in mesh.vertices])


def test_every_entry_has_a_builder_and_every_builder_an_entry():
    assert set(builders()) == set(PROPS)


def test_two_in_a_boat_have_room_for_their_knees():
    rower, stern = (anchor for anchor in build_prop("rowing_boat", seed=3).anchors if anchor.kind == "seat")
    assert rower.direction[1] == -stern.direction[1]
    assert 0.95 < abs(stern.location[1] - rower.location[1]) < 1.2


@every("key", PROPS)
def test_a_prop_stands_on_the_origin_with_its_anchors_on_it(key):
    build = build_prop(key, seed=3)
    cloud = points(build.mesh)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    assert low[2] == pytest.approx(0, abs=1e-5)
    assert (low + high)[:2] == pytest.approx((0, 0), abs=1e-4)
    assert high - low == pytest.approx(build.dimensions, abs=1e-4)
    usual = np.array(PROPS[key].size)
    assert (np.abs(np.array(build.dimensions) - usual) < np.maximum(0.06, 0.25 * usual)).all()
    assert len(build.mesh.polygons) < 9000
    for anchor in build.anchors:
        beside = 0.9 if anchor.kind == "door" else 0.08
        assert (np.array(anchor.location) > low - beside).all(), anchor
        assert (np.array(anchor.location) < high + beside).all(), anchor
    assert PROPS[key].holdable <= any(anchor.kind == "grip" for anchor in build.anchors)
    assert (PROPS[key].seats == 0) or sum(anchor.kind == "seat" for anchor in build.anchors) >= PROPS[key].seats


def test_an_umbrella_is_no_taller_for_being_up():
    size = PROPS["umbrella"].size
    furled, up = (build_prop("umbrella", {"up": up}, dimension=AssetDimension(height=size[2])) for up in (False, True))
    assert furled.dimensions[2] == pytest.approx(up.dimensions[2], rel=0.1)
    assert up.dimensions[0] > 0.8 > 5 * furled.dimensions[0]


@pytest.mark.parametrize("key", ["bookshelf", "tree", "rock", "armchair"])
def test_the_same_seed_builds_the_same_geometry(key):
    assert geometry_hash(build_prop(key, seed=5).mesh) == geometry_hash(build_prop(key, seed=5).mesh)


def test_another_seed_builds_another_tree():
    assert geometry_hash(build_prop("tree", seed=1).mesh) != geometry_hash(build_prop("tree", seed=2).mesh)


@pytest.mark.parametrize("seed", range(4))
def test_nothing_of_a_rock_is_higher_than_who_sits_on_it(seed):
    build = build_prop("rock", seed=seed)
    (seat,) = (anchor for anchor in build.anchors if anchor.kind == "seat")
    assert points(build.mesh)[:, 2].max() == pytest.approx(seat.location[2], abs=0.01)


def test_one_dimension_scales_the_whole():
    usual, tall = build_prop("chair"), build_prop("chair", dimension=AssetDimension(height=1.8))
    assert tall.dimensions[2] == pytest.approx(1.8)
    assert tall.dimensions[0] / usual.dimensions[0] == pytest.approx(1.8 / usual.dimensions[2], rel=1e-3)
    assert tall.anchors[0].location[2] / usual.anchors[0].location[2] == pytest.approx(1.8 / usual.dimensions[2])


def test_colour_and_material_reach_the_first_role():
    build = build_prop("armchair", {"material": "leather", "color": "#9c2622"})
    cover = build.mesh.materials[[block["key"] for block in build.mesh.materials].index("leather")]
    assert cover.diffuse_color[0] > 3 * cover.diffuse_color[1]
    assert cover.node_tree.nodes.active.image.packed_file is not None


def test_a_material_is_made_once():
    assert material("wood") is material("wood")
    assert material("wood") is not material("wood", (0.1, 0.1, 0.1))


def test_an_unknown_parameter_is_refused():
    with pytest.raises(InputError, match="no parameter 'wheels'"):
        build_prop("chair", {"wheels": 4.0})


def test_the_desk_of_a_dressing_table_is_its_first_top_not_the_mirror():
    tops = find_tops(build_prop("dressing_table").mesh)
    assert tops[0].location[2] == pytest.approx(0.75, abs=0.03)
    assert tops[0].clearance is None
    assert min(tops[0].size) > 0.3
    assert all(top.location[2] < 1.2 for top in tops)


def test_shelves_are_tops_with_little_room():
    shelf = build_prop("bookshelf", {"fill": 0.0}).mesh
    inner = [top for top in find_tops(shelf) if top.clearance is not None]
    assert len({round(top.location[2], 1) for top in inner}) >= 4
    assert all(0.1 < top.clearance < 0.5 for top in inner)


def test_planks_are_one_top_and_boards_that_stand_between_part_it():
    (top,) = find_tops(build_prop("bench").mesh)
    assert min(top.size) > 0.37
    b = MeshBuilder("boxes")
    for x in (-0.21, 0.21):
        b.box("wood", (x, 0, 0.2), (0.4, 0.4, 0.4))
    b.box("wood", (0, 0, 0.4), (0.018, 0.4, 0.8))
    sizes = [top.size[0] for top in find_tops(b.mesh()) if top.location[2] < 0.5]
    assert sizes == pytest.approx([0.4, 0.4], abs=0.03)


def test_a_bed_is_lain_on_under_its_headboard():
    bed = build_prop("bed")
    top = find_tops(bed.mesh)[0]
    assert top.location[2] == pytest.approx(0.56, abs=0.03)
    assert any(anchor.kind == "bed" for anchor in bed.anchors)


@every("key", STAND_INS)
def test_a_stand_in_is_a_plain_shape_of_one_material(key):
    build = build_stand_in(key)
    assert len(build.mesh.materials) == 1
    assert build.dimensions == pytest.approx(STAND_INS[key].size, rel=0.2)


def test_a_bent_line_goes_through_its_points_without_corners():
    points = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)])
    curve = bent(points, 8)
    assert curve[::8] == pytest.approx(points)
    ways = np.diff(curve, axis=0)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    assert (np.sum(ways[1:] * ways[:-1], axis=1) > 0.8).all(), "no turn of more than 37 degrees"


def test_a_portrait_shows_every_part_and_leaves_the_file_alone(tmp_path):
    parts = [bpy.data.objects.new(key, build_prop(key).mesh) for key in ("crate", "lamppost")]
    before = [len(data) for data in (bpy.data.objects, bpy.data.scenes, bpy.data.cameras)]
    render_portrait(parts[:1], tmp_path / "one.png", (32, 32))
    render_portrait(parts, tmp_path / "both.png", (32, 32))
    shares = []
    for name in ("one", "both"):
        pixels = np.array(bpy.data.images.load(str(tmp_path / f"{name}.png")).pixels).reshape(32, 32, 4)[..., :3]
        shares.append((np.abs(pixels - pixels[0, 0]).max(axis=2) > 0.05).mean())
    assert shares[0] > 2 * shares[1] > 0.02, "the crate is small beside the lamp post"
    assert [len(data) for data in (bpy.data.objects, bpy.data.scenes, bpy.data.cameras)] == before


def test_a_picture_of_hair_shows_the_head_only(tmp_path):
    post = bpy.data.objects.new("post", build_prop("lamppost").mesh)
    widths = []
    for head in (False, True):
        path = tmp_path / f"{head}.png"
        render_portrait([post], path, (64, 64), head=head)
        pixels = np.array(bpy.data.images.load(str(path)).pixels).reshape(64, 64, 4)[..., :3]
        widths.append((np.abs(pixels - pixels[0, 0]).max(axis=2) > 0.05).any(axis=0).sum())
    assert widths[1] > 2 * widths[0], "its top is nearer"


@every("key", [key for key, entry in PROPS.items() if "asleep" in entry.params])
def test_an_animal_that_sleeps_lies_low_with_its_head_on_the_floor(key):
    awake, asleep = build_prop(key), build_prop(key, {"asleep": True})
    assert asleep.dimensions[2] < 0.85 * awake.dimensions[2]
    points = np.array([vertex.co[:] for vertex in asleep.mesh.vertices])
    front = points[points[:, 1] < points[:, 1].min() + 0.15 * np.ptp(points[:, 1])]
    assert front[:, 2].min() < 0.2 * asleep.dimensions[2]


@every("key", WRITING)
def test_words_are_laid_on_the_side_that_is_read(key):
    plain, written = build_prop(key), build_prop(key, {"text": "HELLO THERE"})
    assert len(written.mesh.polygons) > len(plain.mesh.polygons) + 20
    assert written.dimensions == pytest.approx(plain.dimensions, abs=0.03)
    ink = [block.name for block in written.mesh.materials]
    assert any(WRITING[key].ink in name for name in ink)


@pytest.mark.parametrize("key", ["cardboard_box", "chest", "suitcase", "fridge"])
def test_what_stands_open_is_the_thing_at_the_size_of_the_closed_one(key):
    closed, opened = build_prop(key).dimensions, build_prop(key, {"open": True}).dimensions
    longest = int(np.argmax(PROPS[key].size))
    assert opened[longest] == pytest.approx(closed[longest], rel=0.1)
    assert max(opened) > 1.05 * max(closed) or np.prod(opened) > 1.1 * np.prod(closed)


@pytest.mark.parametrize("key", ["candle", "laptop", "table_lamp", "television", "neon_sign"])
def test_what_is_off_shines_no_more(key):
    on, off = build_prop(key, {"on": True} if key == "television" else {}), {"unlit": True}
    dark = build_prop(key, off)
    shining = {slot.name for slot in on.mesh.materials if slot.name.startswith(("MT_screen", "MT_lamp_", "MT_neon"))}
    left = {dark.mesh.materials[face.material_index].name for face in dark.mesh.polygons}
    assert not left & (shining - {"MT_screen_off"}) and not any("flame" in name for name in left)


@pytest.mark.parametrize("key", sorted(SCREENS))
def test_who_calls_is_on_the_screen_and_within_it(key):
    plain, calling = build_prop(key), build_prop(key, {"caller": True})
    assert len(calling.mesh.polygons) == len(plain.mesh.polygons) + 4
    assert calling.dimensions == pytest.approx(plain.dimensions, abs=0.02)


@pytest.mark.parametrize("wide", [0.5, 1.5])
def test_a_poster_is_printed_within_its_edges_unless_it_bears_writing(wide):
    size = {"width": wide, "height": 0.8}
    prints = [build_prop("poster", size, seed=seed) for seed in range(6)]
    for printed in prints:
        assert len(printed.mesh.materials) == 4
        assert np.allclose(printed.dimensions, (wide, printed.dimensions[1], 0.8)) and printed.dimensions[1] < 0.02
    assert len({geometry_hash(printed.mesh) for printed in prints}) > 1
    written = build_prop("poster", {**size, "text": "WANTED"})
    assert not {each.name for each in written.mesh.materials} & {each.name for each in prints[0].mesh.materials[1:]}
