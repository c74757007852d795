"""An answerer for each role that is not played by rules."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from storyblender.crew_setting import LIMITS, LimitName, Player, RoleName, players
from storyblender.folder import Folder
from storyblender.language.answer_folder import AnswerFolder, Mailbox, Replay
from storyblender.ports import Answerer

ANSWERS = "answers"
"""Folder in the project where the answers of models are kept; it can be replayed."""


def answerers(crew: str, project: Path, limits: Mapping[LimitName, float]) -> Mapping[RoleName, Answerer]:
    """Return who answers, by role; a role that is not in it is played by rules.

    Args:
        crew: The setting.
        project: The project folder; what models answer is kept in it, so that a run that goes on asks nothing twice.
        limits: The most that a run asks of models in all, where it is not the usual.

    Raises:
        InputError: A recording is no folder, or the extra ``crew`` is not installed.
    """
    found: dict[Player, Answerer] = {}
    chosen: dict[RoleName, Player] = {role: player for role, player in players(crew).items() if player.kind != "rules"}
    for player in chosen.values():
        if player not in found:
            found[player] = _answerer(player, project, limits)
    return {role: found[player] for role, player in chosen.items()}


def _answerer(player: Player, project: Path, limits: Mapping[LimitName, float]) -> Answerer:
    folder = Path(player.where)
    if player.kind == "ask":
        return AnswerFolder(Folder(folder), Mailbox(folder))
    if player.kind == "replay":
        return AnswerFolder(Folder(folder), Replay(folder))
    from storyblender.language.provider import Provider

    return AnswerFolder(Folder(project / ANSWERS), Provider(player, {**LIMITS, **limits}))
