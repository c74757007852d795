"""A scene rehearsed after an edit looks as its pack will, but for a hair; its frames are those of a cold render."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from storyblender.edits.effect import name_of
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.memory.camera_decision import CameraDecision
from storyblender.memory.edits import CameraEdit, PlaceEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.jobs import FrameJob, PackRef, SceneJob
from storyblender.memory.paint import Paint, PaintDecision, PaintTarget
from storyblender.memory.scene_decision import ThingPlace
from storyblender.memory.shot_context import Blocking, ShotContext
from storyblender.pipeline.packing import scene_job
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]


@pytest.fixture
def engine(project: Path) -> Iterator[BlenderEngine]:
    with BlenderEngine(project, jobs=1) as engine:
        yield engine


def edited(graph: ContinuityMemoryGraph) -> Iterator[SceneJob]:
    """Yield the scene with its things turned, with a person elsewhere, and with both; each follows from the last."""
    scene, shots = graph.scenes[0], list(graph.staged_shots_of(1))
    assert scene.layout is not None
    turned = tuple(
        item.model_copy(update={"rotation": (0.0, 0.0, (item.rotation[2] + 40.0) % 360), "fixed": True})
        for item in scene.layout.objects
        if item.anchor_asset_id is None
    )
    others = tuple(item for item in scene.layout.objects if item.anchor_asset_id is not None)
    moved = scene.model_copy(update={"layout": scene.layout.model_copy(update={"objects": (*turned, *others)})})
    yield scene_job(replace(graph, moved), 1)
    stepped = [shot.model_copy(update={"blocking": tuple(map(stepping_aside, shot.blocking))}) for shot in shots]
    assert stepped != shots
    yield scene_job(replace(graph, *stepped), 1)
    yield scene_job(replace(graph, moved, *stepped), 1)


def stepping_aside(blocking: Blocking) -> Blocking:
    """Return the blocking of a person who begins a step aside, if they stand."""
    start = blocking.start
    if start.posture != "stand":
        return blocking
    x, y, z = start.location
    return blocking.model_copy(update={"start": start.model_copy(update={"location": (x + 0.25, y, z)})})


def frame_of(graph: ContinuityMemoryGraph, pack: PackRef, shot: ShotContext, out: str) -> FrameJob:
    lighting = shot.lighting or graph.scenes[0].lighting
    assert lighting is not None
    return FrameJob(
        pack=pack, shot=shot, lighting=lighting, format=graph.format, look="fast", frame=shot.duration // 2, out=out
    )


def test_each_shot_looks_as_in_the_pack_after_edits(project: Path, engine: BlenderEngine) -> None:
    graph = read_project_graph(project)
    shots = graph.staged_shots_of(1)[::-1]
    front = engine.front
    *earlier, last = edited(graph)
    for job in earlier:
        front.rehearse(job, [shots[0].shot_id]).result()
    pack = engine.pack_scene(last).result()
    for shot in shots:
        rehearsed = front.rehearse(last, [shot.shot_id]).result()
        assert (rehearsed.path, rehearsed.starts) == (pack.path, pack.starts)
        assert rehearsed.played(shot.shot_id) == pack.played(shot.shot_id)
        names = [f"build/{kind}-{shot.shot_id}.png" for kind in ("packed", "rehearsed")]
        reports = [
            room.render_frame(frame_of(graph, known, shot, name)).result()
            for room, known, name in zip((engine, front), (pack, rehearsed), names, strict=True)
        ]
        assert difference(*(project / name for name in names)) < 0.02, "at the edges of what moves"
        assert [light.role for light in reports[0].lights] == [light.role for light in reports[1].lights]


def test_scenes_that_share_things_stay_apart(project: Path, engine: BlenderEngine) -> None:
    graph = read_project_graph(project)
    first = scene_job(graph, 1)
    shot, other = first.shots[0], first.shots[0].model_copy(update={"scene_id": 2})
    table = next(asset.asset_id for asset in first.assets if "table" in asset.asset_id)
    look = PaintDecision(color=(0.8, 0.0, 0.0), plain=True)
    red = Paint(target=PaintTarget(asset_id=table, scene_id=2), look=look)
    shots = tuple(each.model_copy(update={"scene_id": 2}) for each in first.shots)
    second = first.model_copy(
        update={"scene": first.scene.model_copy(update={"scene_id": 2}), "shots": shots, "paints": (red,)}
    )
    names: list[Path] = []
    for number, (job, seen) in enumerate(((first, shot), (second, other), (first, shot), (second, other))):
        pack = engine.front.rehearse(job, [seen.shot_id]).result()
        names.append(project / f"build/turn-{number}.png")
        engine.front.render_frame(frame_of(graph, pack, seen, f"build/turn-{number}.png")).result()
    assert difference(names[0], names[2]) == 0 == difference(names[1], names[3]), "as they were left"
    assert difference(names[0], names[1]) > 0.002, "one of them is painted"


def difference(one: Path, other: Path) -> float:
    """Return the share of pixels that are clearly of another colour."""
    pictures = [np.asarray(Image.open(path), float) for path in (one, other)]
    return float((np.abs(pictures[0] - pictures[1]).max(axis=2) > 24).mean())


def test_a_draft_is_a_picture_of_the_same_with_a_name_of_its_own(project: Path, engine: BlenderEngine) -> None:
    graph = read_project_graph(project)
    job, shot = scene_job(graph, 1), graph.staged_shots_of(1)[0]
    pack = engine.front.rehearse(job, [shot.shot_id]).result()
    whole = frame_of(graph, pack, shot, "build/whole.png")
    draft = whole.model_copy(update={"draft": True, "out": "build/draft.png"})
    assert draft.digest != whole.digest
    for each in (whole, draft):
        engine.front.render_frame(each).result()
    pictures = [np.asarray(Image.open(project / name), float) for name in ("build/whole.png", "build/draft.png")]
    assert pictures[0].shape == pictures[1].shape
    assert np.abs(pictures[0] - pictures[1]).mean() < 12, "of 255: the same scene, more coarsely"


def test_frames_that_follow_previews_are_those_of_a_cold_render(untouched: Path, tmp_path: Path) -> None:
    graph = read_project_graph(untouched)
    scene, shot = graph.scenes[0], graph.shots[-1]
    assert scene.layout is not None
    chair = next(item.node_id for item in scene.layout.objects if "chair" in item.node_id)
    edits = [
        PlaceEdit(scene="SC010", thing=chair, place=ThingPlace(rotation=200.0)),
        CameraEdit(shot=name_of(shot), decision=CameraDecision(lens=50.0)),
    ]
    folders = [tmp_path / name / untouched.name for name in ("watched", "cold")]
    for folder in folders:
        shutil.copytree(untouched, folder)
    settings = Settings.load(project=folders[0])
    with Studio(settings).open(folders[0]) as session:
        for edit in edits:
            pictures = session.preview(session.apply([edit]).stale)
            assert all(picture.is_file() for picture in pictures.values())
        session.shoot(session.stale_frames())
    with Studio(settings).open(folders[1]) as session:
        for edit in edits:
            session.apply([edit])
        session.shoot(session.stale_frames())
    frames = [sorted((folder / "frames").glob("SC*.png")) for folder in folders]
    assert [path.name for path in frames[0]] == [path.name for path in frames[1]]
    for watched, cold in zip(*frames, strict=True):
        assert watched.read_bytes() == cold.read_bytes(), watched.name
