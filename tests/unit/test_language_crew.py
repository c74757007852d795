"""A crew of models: a run that stops for each answer makes the same storyboard as one that has them all."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, get_args

import pytest
from tests.answering import Alike, Scripted
from tests.stand_in_engine import StandInEngine

from storyblender.agents.layout_artist.camera_operator import CAMERA_THRESHOLD
from storyblender.agents.layout_artist.language_camera_operator import LanguageCameraOperator
from storyblender.agents.vision_critic import VisionCritic
from storyblender.crew import rules_crew
from storyblender.crew_setting import RULES, RoleName, players
from storyblender.errors import AnswerAwaited
from storyblender.language.answer_folder import asked
from storyblender.language_crew import ANSWERS, check_answers, language_crew
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import TRACE, read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = """INT. BAR - NIGHT

ANNA (30, red coat) sits at a table with a lamp. BEN comes in.

BEN
You came.
"""
SHORT = frozenset({
    "asset_retriever", "dimension_estimator", "environment_designer", "set_dresser", "spatial_planner", "animator",
    "lighting_arranger",
})  # fmt: skip
"""Roles whose rules fill in whatever an answer leaves out; the Camera Operator, who asks at every shot, is not here."""


@pytest.fixture
def script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    path = tmp_path / "bar.fountain"
    path.write_text(SCRIPT)
    return path


def made(script: Path, folder: Path, crew: str) -> ContinuityMemoryGraph:
    Studio(Settings(width=160, look="fast", animatic=False, crew=crew)).make(script, folder)
    return read_project_graph(folder)


def crew_with(player: str, roles: frozenset[str] = SHORT) -> str:
    return ",".join(["rules", *(f"{role}={player}" for role in sorted(roles))])


def answered(script: Path, project: Path, box: Path, roles: frozenset[str]) -> int:
    """Make a storyboard whose requests are answered as they come, with nothing; return how often the run stopped."""
    for run in range(200):
        try:
            made(script, project, crew_with(f"ask:{box}", roles))
        except AnswerAwaited as waits:
            for name in waits.names:
                (box / f"{name}.answer.json").write_text("{}")
        else:
            return run
    raise AssertionError("the run never ends")


@pytest.mark.parametrize(
    "roles",
    [frozenset({"animator", "lighting_arranger"}), pytest.param(SHORT, marks=pytest.mark.slow)],
    ids=["halfway through a scene", "every role"],
)
def test_a_run_that_stops_for_every_answer_ends_as_one_that_has_them_all(
    script: Path, tmp_path: Path, roles: frozenset[str]
) -> None:
    box = tmp_path / "questions"
    assert answered(script, tmp_path / "asked", box, roles) == len(roles), "a role is asked once"
    assert {name.partition("-")[0] for name, _ in asked(box)} == roles
    assert not any(each.problem for each in check_answers(box))
    replayed = made(script, tmp_path / "replayed", crew_with(f"replay:{box}", roles))
    assert replayed == read_project_graph(tmp_path / "asked")


@pytest.mark.parametrize("crew", ["rules", "google:m", "google:m,camera_critic=rules", "rules,camera_critic=google:m"])
def test_a_vision_critic_judges_the_camera_where_one_is_named(crew: str) -> None:
    named = {role for role, player in players(crew).items() if player != RULES}
    made = language_crew(rules_crew(Settings(), Alike, ()), dict.fromkeys(named, Scripted(())), Alike, ())
    role = made.camera_operator(Any)
    assert isinstance(role.critic, VisionCritic) == ("camera_critic" in named)
    assert isinstance(role.policies[0], LanguageCameraOperator) == ("camera_operator" in named)
    assert (role.threshold, role.horizon) == (CAMERA_THRESHOLD, 5 if named else 3)


def test_all_scenes_are_asked_about_before_a_run_stops(script: Path, tmp_path: Path) -> None:
    script.write_text(SCRIPT + "\nEXT. STREET - DAY\n\nBEN walks to a car.\n")
    box, roles = tmp_path / "questions", frozenset({"environment_designer", "animator"})
    assert answered(script, tmp_path / "asked", box, roles) == len(roles), "once a role, not once a role and scene"
    assert len([*asked(box)]) == 2 * len(roles)
    asked_for, replayed = (
        read_project_graph(tmp_path / "asked"),
        made(script, tmp_path / "p", crew_with(f"replay:{box}", roles)),
    )
    assert (asked_for.scenes, asked_for.shots) == (replayed.scenes, replayed.shots)
    assert sorted(asked_for.assets, key=str) == sorted(replayed.assets, key=str)


def test_every_role_that_a_model_can_play_has_a_form_of_answer() -> None:
    assert {*get_args(RoleName)} == ANSWERS.keys()


@pytest.mark.slow
def test_answers_that_are_never_right_leave_the_storyboard_to_the_rules(script: Path, tmp_path: Path) -> None:
    box = tmp_path / "questions"
    for _ in range(400):
        try:
            made(script, tmp_path / "p", f"{crew_with(f'ask:{box}')},director=ask:{box},shot_director=ask:{box}")
        except AnswerAwaited as waits:
            for name in waits.names:
                (box / f"{name}.answer.json").write_text("I am sorry, I cannot do that.")
        else:
            break
    kinds = [json.loads(line)["kind"] for line in (tmp_path / "p" / TRACE).read_text().splitlines()]
    assert "handover" in kinds
    rules = made(script, tmp_path / "rules", "rules")
    ours = read_project_graph(tmp_path / "p")
    assert (ours.shots, ours.scenes) == (rules.shots, rules.scenes)
