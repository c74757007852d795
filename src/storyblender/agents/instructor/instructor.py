"""What the Instructor sees and answers: ``SC020_SH010: closer, shallow focus`` becomes edits of that shot.

The paper lets a person instruct each role in words; here the words become edits, which go through the one dispatcher,
so that they are checked, can be undone and hold against the crew like everything a person decides.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from storyblender.agents.instructor.phrases import edits_of_clause
from storyblender.agents.instructor.scene_faults import scene_faults
from storyblender.agents.instructor.scene_phrases import edits_of_scene
from storyblender.agents.instructor.scene_view import SceneNow, scene_now
from storyblender.agents.instructor.shot_phrases import edits_of_cut, note_on
from storyblender.errors import InputError
from storyblender.memory.base import Described, Frozen, scene_name, shot_name
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction
from storyblender.memory.edits import (
    ApproveEdit,
    CameraEdit,
    DurationEdit,
    Edit,
    LightEdit,
    NoteEdit,
    OmitEdit,
    ReorderEdit,
    RestoreEdit,
    SetEdit,
    TakeEdit,
)
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_decision import LightDecision, SetDecision
from storyblender.reflection import UNUSABLE, Critique, Fault

_CLAUSES = re.compile(r"\s*(?:;|,(?!\d)|\.(?=\s|$)|\bthen\b)\s*", re.IGNORECASE)
_OF_SHOTS = (CameraEdit, DurationEdit, TakeEdit, NoteEdit, ApproveEdit)
"""Edits that name a shot."""
_PLEASE = re.compile(r"[\s,]*\bplease\b[\s,]*", re.IGNORECASE)
_AND = re.compile(r"\s+(?:and|but)\s+", re.IGNORECASE)


class ShotNow(Frozen):
    """A shot as it is."""

    name: str
    camera: CameraInstruction
    frames: int
    lens: float
    """mm."""
    on_stage: tuple[str, ...]


@dataclass(frozen=True)
class InstructorView:
    """What the Instructor sees.

    Attributes:
        words: What the person says, without the names of shots.
        shots: The shots that they are about.
        names: Name of every character and object by id.
        fps: Frames a second.
        scenes: Their scenes.
        named: The shots and scenes as the person names them; empty for the shots.
    """

    words: str
    shots: tuple[ShotNow, ...]
    names: Mapping[str, str]
    fps: int
    scenes: tuple[SceneNow, ...] = ()
    named: tuple[str, ...] = ()

    @property
    def targets(self) -> tuple[str, ...]:
        """Names of the shots and scenes that the words are about."""
        return self.named or tuple(shot.name for shot in self.shots)


class Instruction(Described):
    """What a person's words mean."""

    edits: tuple[Edit, ...] = ()
    """In order; each names its shot."""
    unclear: tuple[str, ...] = ()
    """Words that no edit says; they are told to the person, and nothing is done."""


def instructor_view(graph: ContinuityMemoryGraph, words: str) -> InstructorView:
    """Return the Instructor's projection of the graph.

    Args:
        graph: A finished story.
        words: Names of shots or scenes, a colon, and what is wanted: ``SC020_SH010: closer``.

    Raises:
        InputError: There is no shot of that name, or nothing is said.
    """
    named, _, said = words.partition(":")
    listed = tuple(dict.fromkeys(name.upper() for name in re.split(r"[\s,]+", named.strip()) if name))
    wanted = {*listed}
    known = {shot_name(shot.scene_id, shot.shot_id) for shot in graph.shots}
    scenes = {scene_name(scene.scene_id) for scene in graph.scenes}
    if not wanted or not said.strip() or wanted - known - scenes:
        problem = f"{words!r} names no shot and what is wanted of it"
        raise InputError(problem, mend='say it as in "SC010_SH020: closer, shallow focus"')
    shots = (
        ShotNow(
            name=shot_name(shot.scene_id, shot.shot_id),
            camera=shot.camera_instruction,
            frames=shot.duration,
            lens=shot.camera.poses[0].lens if shot.camera is not None else shot.camera_instruction.lens or 50.0,
            on_stage=shot.on_stage,
        )
        for shot in graph.shots
        if {shot_name(shot.scene_id, shot.shot_id), scene_name(shot.scene_id)} & wanted
    )
    names = {asset.asset_id: asset.name or asset.asset_id for asset in graph.assets if asset.origin != "dressing"}
    involved = {name.partition("_")[0] for name in wanted}
    now = tuple(scene_now(graph, scene) for scene in graph.scenes if scene_name(scene.scene_id) in involved)
    return InstructorView(" ".join(said.split()), tuple(shots), names, graph.format.fps, now, listed)


class RulesInstructor:
    """Knows words of cameras, lengths, light, sets, staging and things; one it does not know is said to be unclear."""

    def propose(self, view: InstructorView) -> Instruction:
        """Return the edits that the words mean, clause by clause."""
        edits: list[Edit] = [note for shot in view.shots for note in note_on(view.words, shot.name)]
        if edits:
            return Instruction(edits=tuple(edits))
        unclear: dict[str, None] = {}
        for clause in filter(None, _CLAUSES.split(_PLEASE.sub("", view.words))):
            meant, left = _meant(clause, view)
            edits += meant
            unclear |= dict.fromkeys(left)
        return Instruction(edits=_joined(edits), unclear=tuple(unclear))

    def refine(self, draft: Instruction, critique: Critique, view: InstructorView) -> Instruction:
        """Return the draft: rules know a word or do not.

        Args:
            draft: The edits and the words that are unclear.
            critique: Its faults.
            view: The request, the shots it names and the names of the story.
        """
        return draft


def _meant(clause: str, view: InstructorView) -> tuple[list[Edit], list[str]]:
    """Return the edits of a clause, and its words that are not known; ``and`` may join people, or two wishes."""

    def edits(words: str) -> list[Edit]:
        if cut := edits_of_cut(words, view.targets):
            return cut
        told = [edit for scene in view.scenes for edit in edits_of_scene(words, scene)]
        return told or [
            edit
            for shot in view.shots
            for edit in edits_of_clause(words, shot.name, shot.camera, shot.lens, shot.frames / view.fps, view.names)
        ]

    parts = [(part, edits(part)) for part in _AND.split(clause)]
    unknown = [part for part, meant in parts if not meant]
    if unknown and (whole := edits(clause)):
        return whole, []
    return [edit for _, meant in parts for edit in meant], unknown


def _joined(edits: list[Edit]) -> tuple[Edit, ...]:
    """Return edits with those of one camera, one light and one set as one, as a person would make them."""
    cameras: dict[str, CameraDecision] = {}
    lights: dict[str, LightDecision] = {}
    sets: dict[str, SetDecision] = {}
    others: list[Edit] = []
    for edit in edits:
        match edit:
            case CameraEdit():
                cameras[edit.shot] = cameras.get(edit.shot, CameraDecision()).then(edit.decision)
            case LightEdit():
                lights[edit.scene] = lights.get(edit.scene, LightDecision()).then(edit.decision)
            case SetEdit():
                sets[edit.scene] = sets.get(edit.scene, SetDecision()).then(edit.decision)
            case _:
                others += [edit] if edit not in others else []
    return (
        *(CameraEdit(shot=shot, decision=decision) for shot, decision in cameras.items()),
        *(LightEdit(scene=scene, decision=decision) for scene, decision in lights.items()),
        *(SetEdit(scene=scene, decision=decision) for scene, decision in sets.items()),
        *others,
    )


class InstructorCritic:
    """Checks that edits are of the shots in question and name people and things of the story."""

    def judge(self, draft: Instruction, view: InstructorView) -> Critique:
        """Return the critique; a draft with an edit that cannot be is never accepted.

        Args:
            draft: The edits and the words that are unclear.
            view: The request, the shots it names and the names of the story.
        """
        shots = {shot.name for shot in view.shots}
        faults: list[Fault] = []
        if not draft.edits and not draft.unclear:
            faults.append(Fault(kind="nothing", message="nothing is changed and nothing is unclear", severity=UNUSABLE))
        for edit in draft.edits:
            if isinstance(edit, _OF_SHOTS) and edit.shot.upper() not in shots:
                message = f"{edit.shot} is not among the shots that were named"
                faults.append(Fault(kind="shot", subject=edit.shot, message=message, severity=UNUSABLE))
            if isinstance(edit, OmitEdit | RestoreEdit | ReorderEdit) and edit.target.upper() not in view.targets:
                message = f"{edit.target} is not among the shots and scenes that were named"
                faults.append(Fault(kind="shot", subject=edit.target, message=message, severity=UNUSABLE))
            for unknown in sorted(_named(edit) - view.names.keys()):
                message = f"{unknown!r} is no person or thing of the story"
                faults.append(Fault(kind="unknown", subject=unknown, message=message, severity=UNUSABLE))
            faults += scene_faults(edit, view.scenes)
        return Critique.of(tuple(faults))


def _named(edit: Edit) -> set[str]:
    """Return the people and things that an edit names."""
    if not isinstance(edit, CameraEdit):
        return set()
    said = edit.decision
    single = (said.over_id, said.pov_id, said.focus, said.focus_to)
    return {each for each in (*single, *(said.focus_on_ids or ())) if each}
