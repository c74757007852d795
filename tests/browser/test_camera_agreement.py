"""What the page's camera shows is what Blender draws: heads and feet of everybody, in every shot of the examples."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

from storyblender.agents.visual_effects_artist.person import stature_of
from storyblender.geometry.framing import Film
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import ShotContext
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.web_studio.stage import stage_camera
from tests.browser.stage_page import in_page
from tests.stand_in_engine import StandInEngine

bpy = pytest.importorskip("bpy")
from bpy_extras.object_utils import world_to_camera_view  # noqa: E402
from mathutils import Vector  # noqa: E402

from storyblender.blender.cameras import make_camera  # noqa: E402

EXAMPLES = sorted(path for path in Path("examples").iterdir() if path.suffix in (".fountain", ".txt"))
AGREED = 0.01
"""Heights of the picture that a head or a foot may be elsewhere."""
SEEN = """
    const { stage, frame } = view.scene;
    const [camera, aspect, at, points] = values;
    Object.assign(view.scene, { stage: { ...stage, shot: camera.shot, aspect, cameras: [camera] }, frame: at });
    const seen = view.scene.pictured(points);
    Object.assign(view.scene, { stage, frame });
    return seen;
"""
FIRST = 101
"""Frame of Blender's timeline at which the shot begins."""


def planned(script: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> ContinuityMemoryGraph:
    """Return an example with its layouts, marks and cameras by the rules; no frame is drawn."""
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    studio = Studio(Settings(look="fast", animatic=False, jobs=1))
    studio.make(script, folder)
    with studio.open(folder) as session:
        return session.graph


def people(graph: ContinuityMemoryGraph, shot: ShotContext) -> list[tuple[float, float, float]]:
    """Return the feet and the heads of everybody in a shot, as it begins and as it ends."""
    found: list[tuple[float, float, float]] = []
    for blocking in shot.blocking:
        tall = stature_of(graph.asset(blocking.start.asset_id))
        for x, y, z in (blocking.start.location, blocking.end.location):
            found += [(x, y, z), (x, y, z + tall)]
    return found


def frames(shot: ShotContext) -> Iterator[int]:
    """Yield the first and the last frame of a shot, and some between, on keys of a move and off them."""
    last = shot.duration - 1
    yield from sorted({0, last, last // 2, last // 3 + 1, last // 5 + 2} & {*range(shot.duration)})


def in_blender(
    graph: ContinuityMemoryGraph, shot: ShotContext, points: list[tuple[float, float, float]]
) -> Iterator[tuple[int, NDArray[np.float64]]]:
    """Yield frames, and where Blender's camera sees points: from the left and from the top, and how far ahead."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = graph.format.width, graph.format.height
    scene.camera = make_camera(scene, scene.collection, shot, FIRST)
    for at in frames(shot):
        scene.frame_set(FIRST + at)
        seen = np.array([world_to_camera_view(scene, scene.camera, Vector(point)) for point in points])
        yield at, seen * (1, -1, 1) + (0, 1, 0)


@pytest.mark.slow
@pytest.mark.parametrize("script", EXAMPLES, ids=lambda path: path.stem)
def test_the_page_and_blender_see_the_same(
    script: Path, stage: Page, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    graph = planned(script, tmp_path / script.stem, monkeypatch)
    compared = worst = 0.0
    for shot in graph.shots:
        points = people(graph, shot)
        if shot.camera is None or not points:
            continue
        camera = stage_camera(shot, shot.camera, Film(shot.camera.sensor_width, graph.format.aspect))
        for at, blender in in_blender(graph, shot, points):
            page = np.array(in_page(stage, SEEN, camera.model_dump(), graph.format.aspect, at, points))
            ahead = (blender[:, 2] > 0.3) & (np.abs(blender[:, :2] - 0.5).max(axis=1) < 1.5)
            off = np.abs(page - blender[:, :2])[ahead] * (graph.format.aspect, 1.0)
            compared += ahead.sum()
            worst = max(worst, off.max(initial=0.0))
            assert off.max(initial=0.0) < AGREED, f"{camera.shot} at frame {at}"
    print(f"{script.stem}: {len(graph.shots)} shots, {compared:.0f} heads and feet, worst {worst:.4f} of the height")
    assert compared > 10
