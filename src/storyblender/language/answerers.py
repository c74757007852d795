"""An answerer for each role that is not played by rules."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from threading import Event as Signal
from typing import TYPE_CHECKING, Final

from storyblender.crew_setting import LimitName, Player, RoleName, players
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.language.answer_folder import AnswerFolder, Mailbox
from storyblender.language.budget import Budget
from storyblender.language.replay import Replay
from storyblender.ports import Answerer
from storyblender.trace import Listener

if TYPE_CHECKING:
    from storyblender.language.provider import Provider

ANSWERS = "answers"
"""Folder in the project where the answers of models are kept; it can be replayed."""
_ADDED: Final[frozenset[RoleName]] = frozenset({
    "asset_generator", "asset_critic", "layout_critic", "light_critic", "camera_critic",
})  # fmt: skip
"""Roles that a recording may have been made without: nothing is drawn for them in vain."""


def answerers(
    crew: str, project: Path, limits: Mapping[LimitName, float], cancelled: Signal, listener: Listener
) -> Mapping[RoleName, Answerer]:
    """Return who answers, by role; a role that is not in it is played by rules.

    Args:
        crew: The setting.
        project: The project folder; what models answer is kept in it, so that a run that goes on asks nothing twice.
        limits: The most that a run asks of models in all, where it is not the usual.
        cancelled: Set to end the request under way.
        listener: Receives warnings.

    Raises:
        InputError: There is no such model, its key is missing, or the extra ``crew`` is not installed.
    """
    budget = Budget(limits)

    @cache
    def answerer(player: Player) -> Answerer:
        folder = Path(player.where)
        if player.kind == "ask":
            return AnswerFolder(Folder(folder), Mailbox(folder))
        if player.kind == "replay":
            return Replay(folder, listener)
        return AnswerFolder(Folder(project / ANSWERS), provider_class()(player, budget, cancelled))

    found: dict[RoleName, Answerer] = {
        role: answerer(player) for role, player in players(crew).items() if player.kind != "rules"
    }
    return {role: each for role, each in found.items() if not _was_left_out(role, each)}


def _was_left_out(role: RoleName, answerer: Answerer) -> bool:
    """Return whether a recording was made without a role that a storyboard can do without."""
    return role in _ADDED and isinstance(answerer, Replay) and not answerer.knows(role)


def provider_class() -> type[Provider]:
    """Return what asks models.

    Raises:
        InputError: The extra ``crew`` is not installed.
    """
    try:
        from storyblender.language.provider import Provider
    except ModuleNotFoundError as error:
        mend = 'run `make crew`, or `pip install "storyblender[crew]"`'
        raise InputError(f"models need the extra `crew`, and {error.name} is not installed", mend=mend) from error
    return Provider
