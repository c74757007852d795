"""A panorama in the settings, or chosen for a scene: which scenes it lights, what it leaves alone, what is refused."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter
from tests.panoramas import write_sky
from tests.stand_in_engine import StandInEngine

from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    LightingArrangerView,
    lighting_arranger_view,
)
from storyblender.errors import InputError
from storyblender.look.illumination import direction_of
from storyblender.look.irradiance import irradiance_at
from storyblender.look.raster import luminance
from storyblender.memory.edits import LightEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.panorama import PanoramaLight, panorama_file
from storyblender.memory.scene_context import Lighting
from storyblender.memory.scene_decision import LightDecision
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = """EXT. MEADOW - DAY

ANN (40) waits.

INT. KITCHEN - DAY

ANN waits.

EXT. MEADOW - NIGHT

ANN waits.
"""
QUICK = {"width": 160, "look": "fast", "animatic": False}


@pytest.fixture(autouse=True)
def _without_blender(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)


def made(folder: Path, hdri: Path | None = None) -> ContinuityMemoryGraph:
    script, project = folder / "a.fountain", folder / "a.storyboard"
    script.write_text(SCRIPT)
    Studio(Settings.model_validate({**QUICK, "hdri": hdri})).make(script, project)
    return read_project_graph(project)


def plans(graph: ContinuityMemoryGraph) -> list[Lighting]:
    return [scene.lighting for scene in graph.scenes if scene.lighting is not None]


def test_an_exterior_by_day_is_lit_by_it_and_nothing_else_changes(tmp_path: Path) -> None:
    sky = write_sky(tmp_path / "sky.hdr")
    (tmp_path / "sky.credits.toml").write_text('author = "Ann Light"')
    (tmp_path / "plain").mkdir()
    day, room, night = plans(made(tmp_path, sky))
    plain = plans(made(tmp_path / "plain"))
    assert day.panorama is not None and room.panorama is None and night.panorama is None
    assert [day.model_copy(update={"panorama": None}), room, night] == plain
    toward = -direction_of(next(light for light in day.lights if light.role == "sun"))
    assert math.degrees(math.atan2(toward[1], toward[0])) == pytest.approx(
        (math.degrees(math.atan2(0.48, 0.6)) + day.panorama.yaw + 180) % 360 - 180, abs=1.0
    )
    normals = np.random.default_rng(0).normal(size=(1, 4000, 3)).astype(np.float32)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    mean = luminance(irradiance_at(day.panorama.irradiance, normals)).mean()
    assert mean == pytest.approx(float(luminance((np.array(day.ambient) + np.array(day.sky.ground)) / 2)), rel=0.05)
    project = tmp_path / "a.storyboard"
    assert (project / panorama_file(day.panorama.digest)).is_file()
    assert "sky.hdr" in (project / "credits.md").read_text() and "Ann Light" in (project / "credits.md").read_text()


def test_a_view_without_one_has_the_digest_that_it_had_before_there_were_panoramas(tmp_path: Path) -> None:
    graph = made(tmp_path)
    view = TypeAdapter(LightingArrangerView).dump_python(lighting_arranger_view(graph, 1), mode="json")
    assert "panorama" not in view and "current" in view


def test_without_one_no_file_mentions_it(tmp_path: Path) -> None:
    made(tmp_path)
    project = tmp_path / "a.storyboard"
    for name in ("graph.json", "trace.jsonl", "drafts.jsonl", "settings.json"):
        assert "panorama" not in (text := (project / name).read_text()) and "hdri" not in text
    assert not (project / "credits.md").exists()


def test_the_project_keeps_its_picture_and_asks_for_the_users_file_only_when_it_is_lost(tmp_path: Path) -> None:
    sky, project = write_sky(tmp_path / "sky.hdr"), tmp_path / "a.storyboard"
    graph = made(tmp_path, sky)
    assert json.loads((project / "settings.json").read_text())["hdri"] == "../sky.hdr"
    assert made(tmp_path, sky) == graph
    content = sky.read_bytes()
    sky.unlink()
    settings = Settings.load(project=project)
    Studio(settings).render(project)
    assert graph.panorama is not None
    kept = project / panorama_file(graph.panorama.provenance.digest)
    kept.unlink()
    with pytest.raises(InputError, match=r"sky\.hdr"):
        Studio(settings).render(project)
    sky.write_bytes(content)
    Studio(settings).render(project)
    assert kept.is_file()
    write_sky(sky, sun=None)
    kept.unlink()
    with pytest.raises(InputError, match="not the panorama that the project was made with"):
        Studio(settings).render(project)


def test_a_broken_one_is_refused_before_there_is_a_folder(tmp_path: Path) -> None:
    sky = write_sky(tmp_path / "sky.hdr")
    sky.write_bytes(sky.read_bytes()[:5000])
    with pytest.raises(InputError, match=r"sky\.hdr: cannot be read as a panorama"):
        made(tmp_path, sky)
    assert not (tmp_path / "a.storyboard").exists()


def test_it_is_named_from_the_settings_file_and_can_be_left_out_again(tmp_path: Path) -> None:
    script, file = tmp_path / "a.fountain", tmp_path / "storyblender.toml"
    file.write_text('hdri = "skies/sky.exr"')
    assert Settings.load(script).hdri == tmp_path / "skies" / "sky.exr"
    project = tmp_path / "a.storyboard"
    project.mkdir()
    (project / "settings.json").write_text('{"hdri": "../sky.hdr"}')
    file.write_text("fps = 25")
    assert Settings.load(script, project).hdri == project / ".." / "sky.hdr"
    file.write_text('hdri = ""')
    assert Settings.load(script, project).hdri is None


def test_a_brighter_one_is_brighter_in_every_way() -> None:
    light = PanoramaLight(digest="ab", strength=0.5, irradiance=((1.0, 2.0, 3.0),) * 9)
    assert light.scaled(2) == PanoramaLight(digest="ab", strength=1.0, irradiance=((2.0, 4.0, 6.0),) * 9)


def test_another_one_lights_the_project_anew_and_undo_brings_the_first_back(tmp_path: Path) -> None:
    first = made(tmp_path, write_sky(tmp_path / "sky.hdr"))
    second = made(tmp_path, write_sky(tmp_path / "clouds.hdr", sun=None))
    one, other = plans(first)[0].panorama, plans(second)[0].panorama
    assert one is not None and other is not None and other.digest != one.digest and other.yaw == 0.0
    Studio(Settings.model_validate(QUICK)).undo(tmp_path / "a.storyboard")
    assert plans(read_project_graph(tmp_path / "a.storyboard"))[0].panorama == one
    without = made(tmp_path)
    assert without.panorama is None and not any(plan.panorama for plan in plans(without))


def test_a_person_lights_one_scene_by_another_one(tmp_path: Path) -> None:
    graph = made(tmp_path)
    project, before = tmp_path / "a.storyboard", plans(graph)
    sky = write_sky(tmp_path / "sky.hdr")
    (tmp_path / "sky.credits.toml").write_text('author = "Ann Light"')
    with Studio(Settings.model_validate(QUICK)).open(project) as session:
        by_it = LightDecision(panorama=session.take_in_panorama(sky))
        applied = session.apply([LightEdit(scene="SC010", decision=by_it)])
        assert applied.stale == ("SC010_SH010",) and "sky.hdr" in applied.words and not applied.warnings
        session.draw(applied)
        lit = plans(session.graph)
        assert lit[0].panorama is not None and lit[1:] == before[1:]
        assert "Ann Light" in (project / "credits.md").read_text()
        with pytest.raises(InputError, match="SC020 is inside"):
            session.apply([LightEdit(scene="SC020", decision=by_it)])
        assert session.apply([LightEdit(scene="SC030", decision=by_it)]).warnings
        session.undo()
        sky.unlink()
        session.apply([LightEdit(scene="SC010", decision=LightDecision(panorama="none"))])
        session.render()
        assert plans(session.graph) == before
        session.undo()
        session.render()
        assert plans(session.graph) == lit, "its picture is in the project"
        session.undo()
        assert session.graph == graph
    kept = project / panorama_file(lit[0].panorama.digest)
    kept.unlink()
    with Studio(Settings.model_validate(QUICK)).open(project) as session:
        session.redo()
        with pytest.raises(InputError, match="picture of this panorama is gone"):
            session.render()
