"""Who plays which role."""

from __future__ import annotations

from typing import get_args

import pytest

from storyblender.crew_setting import PROVIDERS, RULES, Player, RoleName, players
from storyblender.errors import InputError
from storyblender.settings import Settings

ROLES = get_args(RoleName)


@pytest.mark.parametrize(
    ("setting", "player"),
    [
        ("rules", RULES),
        ("ask:questions", Player("ask", "questions")),
        ("replay:/tmp/a b/c=d", Player("replay", "/tmp/a b/c=d")),
        ("ollama:qwen3:8b", Player("model", "ollama", "qwen3:8b")),
        (
            "openai-chat:tiny@http://127.0.0.1:1234/v1",
            Player("model", "openai-chat", "tiny", "http://127.0.0.1:1234/v1"),
        ),
    ],
)
def test_one_player_plays_every_role(setting: str, player: Player) -> None:
    assert players(setting) == dict.fromkeys(ROLES, player)


def test_single_roles_may_have_their_own_player() -> None:
    chosen = players("rules,director=ollama:qwen3,animator=ask:here")
    assert chosen["director"] == Player("model", "ollama", "qwen3")
    assert chosen["animator"] == Player("ask", "here")
    assert {role for role, player in chosen.items() if player == RULES} == {*ROLES} - {"director", "animator"}
    assert players("director=ollama:qwen3") == players("rules,director=ollama:qwen3")


def test_a_provider_without_a_model_takes_the_papers_by_role() -> None:
    chosen = players("google")
    assert chosen["director"].model != chosen["lighting_arranger"].model


@pytest.mark.parametrize("setting", ["", "robots", "google:", "ask:", "openai", "rules,baker=rules", "mistral:x y"])
def test_what_can_play_no_role_is_refused_in_a_sentence(setting: str) -> None:
    with pytest.raises(InputError, match="setting 'crew' cannot be"):
        Settings.load(crew=setting)


@pytest.mark.parametrize("provider", PROVIDERS)
def test_every_provider_takes_the_name_of_a_model(provider: str) -> None:
    assert players(f"{provider}:some-model")["director"] == Player("model", provider, "some-model")


def test_a_recording_makes_the_same_plan_as_the_model_that_was_recorded() -> None:
    assert Settings(crew="ollama:qwen3").language_roles == Settings(crew="replay:here").language_roles == ROLES
    assert Settings().language_roles == ()
