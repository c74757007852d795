"""The normals that a normal map tells: turned with the object, and right on mirrored texture coordinates too."""

import io
import math
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import render_stage  # noqa: E402

from storyblender.blender.models.plain import PlainMaterial, PlainModel  # noqa: E402
from storyblender.blender.models.rebuild import build_mesh  # noqa: E402
from storyblender.blender.models.tangents import add_tangents  # noqa: E402
from storyblender.blender.render.passes import render_passes  # noqa: E402
from storyblender.blender.render.session import RenderSession  # noqa: E402
from storyblender.blender.tags import tag  # noqa: E402


def normal_map(leaning):
    out = io.BytesIO()
    color = tuple(round(255 * (0.5 + 0.5 * part)) for part in leaning)
    Image.new("RGB", (8, 8), color).save(out, "PNG")
    return out.getvalue()


def panel(mirrored, leaning):
    """Return a square metre that faces -Y, whose map tells one normal."""
    across = [1, 0, 0, 1] if mirrored else [0, 1, 1, 0]
    model = PlainModel(
        vertices=np.array([(-0.5, 0, 0), (0.5, 0, 0), (0.5, 0, 1), (-0.5, 0, 1)], np.float32),
        corners=np.arange(4, dtype=np.int32),
        sizes=np.array([4], np.int32),
        slots=np.array([0], np.int32),
        smooth=np.array([False]),
        layers=np.array([[(u, v) for u, v in zip(across, (0, 0, 1, 1), strict=True)]], np.float32),
        paint=np.zeros((0, 3), np.float32),
        materials=(PlainMaterial(color=(0.7, 0.2, 0.2), normal_map=normal_map(leaning)),),
    )
    mesh = build_mesh(model, "panel")
    add_tangents(mesh)
    return mesh


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("yaw", [0, 35])
def test_a_map_tells_the_world_normal(mirrored, yaw):
    scene = render_stage.build_stage()
    obj = bpy.data.objects.new("panel", panel(mirrored, (0.48, 0.36, 0.8)))
    obj.location, obj.rotation_euler = (0.2, -2, 1), (0, 0, math.radians(yaw))
    scene.collection.objects.link(obj)
    tag(obj, kind="prop", node_id="panel")
    scene.view_layers[0].update()
    with RenderSession(scene, scene.camera) as session:
        passes = render_passes(session, 320, 180)
    gid = next(index for index, node in enumerate(passes.nodes, 1) if node.node_id == "panel")
    shown = passes.gbuffer.ids == gid
    relief = passes.gbuffer.relief
    assert relief is not None and shown.sum() > 1000 and not relief[~shown].any()
    right = np.array([math.cos(math.radians(yaw)), math.sin(math.radians(yaw)), 0])
    front = np.array([right[1], -right[0], 0])
    expected = 0.48 * right * (-1 if mirrored else 1) + 0.36 * np.array([0, 0, 1]) + 0.8 * front
    assert np.median(relief[shown].astype(float), axis=0) == pytest.approx(expected, abs=0.04)
    albedo = np.median(passes.gbuffer.albedo[shown].astype(float), axis=0)
    assert albedo == pytest.approx((0.7, 0.2, 0.2), abs=0.03), "the map is never shown as the colour"


def test_without_a_map_nothing_is_drawn_again():
    scene = render_stage.build_stage()
    with RenderSession(scene, scene.camera) as session:
        assert render_passes(session, 64, 36).gbuffer.relief is None
