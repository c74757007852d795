"""Motions of the user's own in the staging: actions get the clips that do them, before they are acted."""

from __future__ import annotations

from typing import TYPE_CHECKING

from storyblender.errors import InputError
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.mocap import MocapClip
from storyblender.memory.shot_context import CharacterAction, ShotContext
from storyblender.pipeline.run import Run
from storyblender.trace import Event

if TYPE_CHECKING:
    from storyblender.library.mocap.folders import MotionFile, MotionFolders

_TRIED = 3
"""Most clips that are tried for an action."""


def give_own_motions(run: Run, scene_id: int) -> None:
    """Give the actions of a scene the clips of the user that do them; what has one keeps it.

    Args:
        run: With the scene in the graph.
        scene_id: The scene.
    """
    if not run.settings.motions:
        return
    changed: list[ShotContext] = []
    told: list[str] = []
    taking = _Taking(run)
    for shot in run.graph.staged_shots_of(scene_id):
        if "blocking" in shot.locked:
            continue
        actions = tuple(taking.with_clip(shot, number) for number in range(len(shot.character_actions)))
        if actions != shot.character_actions:
            changed.append(shot.model_copy(update={"character_actions": actions}))
            name = shot_name(scene_id, shot.shot_id)
            told += [
                f"{name}: {new.asset_id} {old.action_description} as in {clip.provenance.file} ({clip.reason})"
                for old, new in zip(shot.character_actions, actions, strict=True)
                if (clip := new.mocap) is not None and old.mocap is None
            ]
    taking.tell_problems(scene_id)
    if changed:
        run.commit("animator", f"own motions of {scene_name(scene_id)}: {'; '.join(told)}", *changed)


class _Taking:
    """Takes clips into the project of a run, each once."""

    def __init__(self, run: Run) -> None:
        from storyblender.library.embedder import load_embedder

        self._run, self._embedder = run, load_embedder
        self._library: MotionFolders = run.own_motions
        self._taken: dict[str, MocapClip | None] = {}

    def with_clip(self, shot: ShotContext, number: int) -> CharacterAction:
        """Return an action of a shot with the clip that does it, if there is one."""
        from storyblender.library.mocap.choosing import choices_for

        action = shot.character_actions[number]
        if action.mocap is not None:
            return action
        name = f"{shot.scene_id} {shot.shot_id} {number} {action.asset_id}"
        seated = any(state.asset_id == action.asset_id and state.posture == "sit" for state in shot.states)
        found = choices_for(action, self._library.files, self._embedder, name, seated=seated)
        for choice in found[:_TRIED]:
            clip = self._take_in(choice.file)
            if clip is not None:
                clip = clip.model_copy(update={"reason": choice.reason[:200]})
                return action.model_copy(update={"mocap": clip})
        return action

    def _take_in(self, file: MotionFile) -> MocapClip | None:
        if file.name not in self._taken:
            try:
                self._taken[file.name] = self._library.take_in(file, self._run.project.files)
            except InputError as error:
                self._taken[file.name] = None
                self._library.problems.append(str(error))
        return self._taken[file.name]

    def tell_problems(self, scene_id: int) -> None:
        """Warn of what could not be read, once."""
        for message in self._library.problems:
            self._run.tell(Event(kind="warning", role="animator", subject=scene_name(scene_id), message=message))
        self._library.problems.clear()
