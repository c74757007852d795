import sys
from pathlib import Path

import numpy as np
import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import render_stage  # noqa: E402
from mathutils import Vector  # noqa: E402

from storyblender.blender.render.lamps import lit, make_lamp  # noqa: E402
from storyblender.blender.render.meter import balanced, scaled  # noqa: E402
from storyblender.blender.render.passes import render_passes  # noqa: E402
from storyblender.blender.render.session import RenderSession  # noqa: E402
from storyblender.blender.render.shadow_maps import render_shadow_map  # noqa: E402
from storyblender.blender.render.turning import turned_and_made  # noqa: E402
from storyblender.look.gbuffer import FAR, View  # noqa: E402
from storyblender.look.surface import Surface  # noqa: E402
from storyblender.memory.scene_context import Light  # noqa: E402


@pytest.fixture(scope="module")
def scene():
    return render_stage.build_stage()


@pytest.fixture(scope="module")
def passes(scene):
    with RenderSession(scene, scene.camera) as session:
        return render_passes(session, 320, 180)


def pixels(passes, node_id: str, surface: Surface | None = None) -> np.ndarray:
    gids = [gid for gid, node in enumerate(passes.nodes, 1) if node.node_id == node_id]
    mask = np.isin(passes.gbuffer.ids, gids)
    return mask if surface is None else mask & (passes.gbuffer.surface == surface)


def test_every_visible_node_is_named(passes):
    shares = passes.visible_shares()
    assert {"floor", "wall_back", "table", "lamp", "ana", "ben"} <= set(shares)
    assert 0.5 < shares["wall_back"] < 0.9
    assert sum(shares.values()) == pytest.approx(1 - passes.gbuffer.sky.mean(), abs=1e-6)


def test_parts_of_a_person_share_the_node_but_keep_their_lines(passes):
    assert sum(node.node_id == "ana" for node in passes.nodes) == 3


def test_albedo_is_exact_and_skin_comes_from_vertex_colours(passes):
    skin = passes.gbuffer.albedo[pixels(passes, "ana", Surface.SKIN)].astype(float)
    assert np.median(skin, axis=0) == pytest.approx([0.75, 0.5, 0.4], abs=0.01)
    coat = passes.gbuffer.albedo[pixels(passes, "ana", Surface.CLOTH)].astype(float)
    assert np.median(coat, axis=0) == pytest.approx([0.6, 0.05, 0.05], abs=0.01)


def test_normals_and_positions_are_in_the_world(passes):
    frame = passes.gbuffer
    floor, wall = pixels(passes, "floor"), pixels(passes, "wall_back")
    assert np.median(frame.normal[floor].astype(float), axis=0) == pytest.approx([0, 0, 1], abs=0.07)
    assert np.median(frame.normal[wall].astype(float), axis=0) == pytest.approx([0, -1, 0], abs=0.07)
    positions = frame.positions()
    assert np.abs(positions[floor][:, 2]).max() < 1e-3
    assert np.abs(positions[wall][:, 1] - 2.95).max() < 1e-3
    assert (frame.depth[frame.sky] == FAR).all()


def test_the_lamp_glows(passes):
    glow = passes.gbuffer.emission()
    assert glow[pixels(passes, "lamp")].mean(axis=0) == pytest.approx([4.0, 3.2, 2.0], rel=0.02)
    assert glow[pixels(passes, "wall_back")].max() == 0


def test_the_number_of_a_material_survives_the_filter_of_the_matcap(scene):
    view = View(np.zeros(3), np.eye(3), 64, 100, 1.0, 1.0)
    numbers = np.arange(6400, dtype=np.uint16).reshape(100, 64)
    for shift in (-1, 0, 1):
        blue = (numbers * 4 + 1024 + shift).astype(np.uint16).view(np.float16).astype(np.float32)
        channels = {"Combined.R": np.full_like(blue, 0.2), "Combined.G": np.full_like(blue, 0.2), "Combined.B": blue}
        assert (turned_and_made(channels, view)[1] == numbers).all()
    empty = {f"Combined.{name}": np.zeros((100, 64), np.float32) for name in "RGB"}
    assert not turned_and_made(empty, view)[1].any()


def test_passes_leave_no_trace(scene):
    def state():
        shading, render = scene.display.shading, scene.render
        return (
            shading.light, shading.color_type, shading.show_shadows, scene.display.render_aa, render.engine,
            render.film_transparent, render.resolution_x, render.filepath, render.image_settings.file_format,
            [tuple(obj.color) for obj in scene.objects], [tuple(m.diffuse_color) for m in bpy.data.materials],
            scene.camera.name, len(bpy.data.objects), bpy.context.window.scene.name,
        )  # fmt: skip

    before = state()
    with RenderSession(scene, scene.camera, 7, ("wall_back",)) as session:
        assert scene.frame_current == 7
        assert [obj.name for obj in session.hidden_objects] == ["wall_back"]
        hidden = render_passes(session, 64, 36)
    assert "wall_back" not in hidden.visible_shares()
    assert state() == before
    assert not any(obj.hide_render for obj in scene.objects)


def test_a_shadow_map_knows_who_stands_in_the_light(scene):
    sun = Light(name="sun", kind="SUN", role="sun", location=(0, -8, 4), target=(0, 0, 0), power=3)
    points = np.float32([[[0.6, 1.2, 0.9], [0.0, 1.2, 1.9], [-3, 0, 0.01]]])
    up = np.broadcast_to(np.float32([0, 0, 1]), points.shape)
    with RenderSession(scene, scene.camera) as session:
        shadow = render_shadow_map(session, sun, points.reshape(-1, 3), np.float32([0, -4, 1.5]))
    assert shadow.visibility(points, up)[0] == pytest.approx([0, 1, 1], abs=0.2)


def test_the_set_is_brought_to_its_level_and_the_roof_is_felt():
    open_air = render_stage.build_stage(walls=False)
    with RenderSession(open_air, open_air.camera):
        plan = render_stage.exterior()
        bright = balanced(open_air, plan)
        again = balanced(open_air, scaled(plan, 3.0))
    assert bright.roofed == 0
    assert again.plan.lights[0].power == pytest.approx(bright.plan.lights[0].power, rel=1e-3)


def test_lamps_are_made_as_planned_and_taken_away(scene):
    spot = Light(name="key", kind="SPOT", role="key", location=(0, -2, 3), target=(0, 0, 1.6), power=50, cone=40)
    lamp = make_lamp(spot, "key")
    assert lamp.data.energy == 50
    aim = lamp.rotation_quaternion.to_matrix() @ Vector((0, 0, -1))
    assert tuple(aim) == pytest.approx(Vector((0, 2, -1.4)).normalized(), abs=1e-3)
    bpy.data.lights.remove(lamp.data)
    collections, count, world = len(bpy.data.collections), len(bpy.data.lights), scene.world
    with lit(scene, [spot], render_stage.interior().sky, [obj for obj in scene.objects if obj.get("node_id") == "ana"]):
        assert len(bpy.data.lights) == count + 1 and scene.world is not world
    assert len(bpy.data.lights) == count and scene.world == world
    assert len(bpy.data.collections) == collections
