"""Shots drawn in a proposed light: from the pack that is filmed later, and for a critic who looks only."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.stand_in_engine import StandInEngine

from storyblender.errors import AnswerAwaited
from storyblender.language.answer_folder import asked
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import SceneJob
from storyblender.pipeline.light_preview import PREVIEWS
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = """INT. BAR - NIGHT

ANNA (30, red coat) sits at a table with a lamp.

ANNA
You came.

The lights go out.

ANNA
Ben?
"""
ENGINES: list[StandInEngine] = []


PACKED: dict[str, SceneJob] = {}


class Counted(StandInEngine):
    """Remembers which engines there were, and what the ones before it packed."""

    def __init__(self, root: Path, *args: Any, **given: Any) -> None:
        super().__init__(root, *args, **given)
        self._scenes = PACKED
        ENGINES.append(self)


@pytest.fixture(autouse=True)
def script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    ENGINES.clear()
    PACKED.clear()
    monkeypatch.setattr("storyblender.studio.BlenderEngine", Counted)
    path = tmp_path / "bar.fountain"
    path.write_text(SCRIPT)
    return path


def made(script: Path, folder: Path, crew: str) -> ContinuityMemoryGraph:
    Studio(Settings(width=160, look="fast", animatic=False, crew=crew)).make(script, folder)
    return read_project_graph(folder)


def calls(tool: str) -> int:
    return sum(engine.calls[tool] for engine in ENGINES)


def answered(script: Path, folder: Path, box: Path, *answers: dict[str, Any]) -> ContinuityMemoryGraph:
    """Make a storyboard whose critic of light says one thing after the other, and then that all is well."""
    said = iter(answers)
    while True:
        try:
            return made(script, folder, f"rules,light_critic=ask:{box}")
        except AnswerAwaited as waits:
            (name,) = waits.names
            (box / f"{name}.answer.json").write_text(json.dumps(next(said, {"score": 9})))


DARKER = {"score": 5, "faults": [{"message": "it is a party", "operations": ["set_darker"]}]}


def test_what_the_critic_minds_is_lit_anew_and_what_was_drawn_for_it_is_gone_at_the_end(
    script: Path, tmp_path: Path
) -> None:
    box = tmp_path / "box"
    graph = answered(script, tmp_path / "p", box, DARKER)
    packs, drawn = calls("pack_scene"), calls("render_frame")
    assert not [*(tmp_path / "p" / PREVIEWS).glob("*")]
    ENGINES.clear()
    rules = made(script, tmp_path / "rules", "rules")
    assert graph.scenes[0].lighting is not None and rules.scenes[0].lighting is not None
    assert graph.scenes[0].lighting.set_luminance < 0.8 * rules.scenes[0].lighting.set_luminance
    assert packs == calls("pack_scene") == 1, "the pack of the previews is the one that is filmed"
    assert drawn > calls("render_frame")
    assert [shot.camera for shot in graph.shots] == [shot.camera for shot in rules.shots]


def test_a_change_of_the_light_is_seen_beside_what_was_before(script: Path, tmp_path: Path) -> None:
    box = tmp_path / "box"
    graph = answered(script, tmp_path / "p", box)
    changed = [shot.shot_id for shot in graph.shots if shot.light_change is not None]
    scene, *changes = sorted((name for name, _ in asked(box)), key=len)
    assert len(changes) == len(changed) > 0
    assert sorted(box.glob(f"{scene}.*.png"))[0].name.split(".")[-2] == "shot_1"
    for name, shot_id in zip(sorted(changes), changed, strict=True):
        pictures = sorted(box.glob(f"{name}.*.png"))
        assert [path.name.split(".")[-2] for path in pictures] == ["before", f"shot_{shot_id}"]
    first = sorted(box.glob(f"{min(changes)}.*.png"))
    assert first[0].read_bytes() != first[1].read_bytes()


def test_a_recording_without_the_critic_draws_nothing_for_it(script: Path, tmp_path: Path) -> None:
    box = tmp_path / "box"
    box.mkdir()
    made(script, tmp_path / "p", f"rules,light_critic=replay:{box}")
    drawn = calls("render_frame")
    ENGINES.clear()
    made(script, tmp_path / "rules", "rules")
    assert drawn == calls("render_frame")
