"""Who plays which role, as ``--crew`` says it: rules, a model, a folder of questions and answers, a recording.

``rules`` · ``google`` (the paper's models by role) · ``openai:MODEL`` · ``ollama:MODEL`` ·
``openai-chat:MODEL@http://127.0.0.1:1234/v1`` · ``ask:FOLDER`` · ``replay:FOLDER`` · ``rules,director=ollama:MODEL``
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal, get_args

RoleName = Literal[
    "director", "shot_director", "asset_retriever", "asset_critic", "asset_generator", "asset_formatter",
    "dimension_estimator", "environment_designer", "set_dresser", "spatial_planner", "layout_critic", "animator",
    "lighting_arranger", "light_critic", "camera_operator", "camera_critic", "instructor",
]  # fmt: skip
"""The members of the crew, vision critics included."""

LimitName = Literal["requests", "tokens", "dollars"]
LIMITS: Final[dict[LimitName, float]] = {"requests": 2000, "tokens": 20_000_000, "dollars": 20}
"""The most that a run asks of models in all: requests, tokens in and out, US dollars for models of a known price."""

PROVIDERS: Final = (
    "anthropic", "google", "google-cloud", "ollama", "openai", "openai-chat", "openrouter", "vllm",
)  # fmt: skip
"""Providers by pydantic-ai's names; ``openai-chat`` is every server that speaks OpenAI's chat wire."""
_STRONG, _LIGHT = "strong", "light"
_WEIGHT: Final[dict[RoleName, str]] = {
    "director": _STRONG, "shot_director": _STRONG, "dimension_estimator": _STRONG, "set_dresser": _STRONG,
    "spatial_planner": _STRONG,
}  # fmt: skip
"""Roles that plan; the others take the light model (paper, appendix: gemini-3-pro-preview and -flash-preview)."""
_MODELS: Final = {
    "google": {_STRONG: "gemini-3-pro-preview", _LIGHT: "gemini-3-flash-preview"},
}
"""Models of a provider that was named without one."""
_PLAYER = re.compile(r"(rules)|(ask|replay):(.+)|([a-z-]+)(?::([^@\s]+)(?:@(https?://[^\s@?#]+))?)?", re.DOTALL)


@dataclass(frozen=True)
class Player:
    """Who plays a role.

    Attributes:
        kind: ``rules``, ``ask`` (a folder), ``replay`` (a recording) or ``model``.
        where: Path of the folder; for a model its provider.
        model: Name of the model.
        address: URL of the server, if it is not the provider's own. It has no password or key in it, because a project
            remembers it.
    """

    kind: Literal["rules", "ask", "replay", "model"]
    where: str = ""
    model: str = ""
    address: str = ""


RULES: Final = Player("rules")


def players(setting: str) -> Mapping[RoleName, Player]:
    """Return who plays each role.

    Args:
        setting: As ``--crew`` has it: a player for all roles, then ``ROLE=PLAYER`` for single ones, with commas.

    Raises:
        ValueError: It names no such role, or no such player.
    """
    everyone, chosen = "rules", dict[str, str]()
    for number, part in enumerate(each.strip() for each in setting.split(",")):
        role, named, player = part.partition("=")
        if named and role in get_args(RoleName):
            chosen[role] = player
        elif number == 0:
            everyone = part
        else:
            raise ValueError(f"there is no role {role!r}; it is one of {', '.join(get_args(RoleName))}")
    return {role: _player(chosen.get(role, everyone), role) for role in get_args(RoleName)}


def _player(text: str, role: RoleName) -> Player:
    """Return a player as it is written, for a role. Raises ValueError."""
    found = _PLAYER.fullmatch(text)
    rules, folder, path, provider, model, address = found.groups(default="") if found else ("",) * 6
    if rules:
        return RULES
    if folder == "ask" or folder == "replay":
        return Player(folder, path)
    if provider not in PROVIDERS:
        known = ", ".join((*(f"{each}:MODEL" for each in PROVIDERS), "ask:FOLDER", "replay:FOLDER", "rules"))
        raise ValueError(f"nothing called {text!r} can play a role; it is one of {known}")
    model = model or _MODELS.get(provider, {}).get(_WEIGHT.get(role, _LIGHT), "")
    if not model:
        raise ValueError(f"{provider} needs the name of a model: {provider}:MODEL")
    return Player("model", provider, model, address)
