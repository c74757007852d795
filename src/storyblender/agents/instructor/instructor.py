"""What the Instructor sees and answers: ``SC020_SH010: closer, shallow focus`` becomes edits of that shot.

The paper lets a person instruct each role in words; here the words become edits, which go through the one dispatcher,
so that they are checked, can be undone and hold against the crew like everything a person decides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from storyblender.agents.instructor.address import address_of
from storyblender.agents.instructor.film_phrases import format_decision
from storyblender.agents.instructor.mentions import Mentions, Present
from storyblender.agents.instructor.parsing import Phrase, read_sentences
from storyblender.agents.instructor.person_phrases import edits_of_person
from storyblender.agents.instructor.phrases import CameraWords, problem_of
from storyblender.agents.instructor.scene_faults import scene_faults
from storyblender.agents.instructor.scene_phrases import edits_of_scene
from storyblender.agents.instructor.scene_view import SceneNow, scene_now
from storyblender.agents.instructor.shot_phrases import edits_of_cut, edits_of_shot, note_on
from storyblender.memory.base import Described, Frozen, scene_name, shot_name
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction
from storyblender.memory.edits import (
    AddShotEdit,
    ApproveEdit,
    BlockingEdit,
    CameraEdit,
    DurationEdit,
    Edit,
    FormatEdit,
    JoinEdit,
    LightEdit,
    NoteEdit,
    OmitEdit,
    ReorderEdit,
    RestoreEdit,
    SetEdit,
    SplitEdit,
    TakeEdit,
)
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.picture_format import FormatDecision
from storyblender.memory.scene_decision import LightDecision, SetDecision
from storyblender.reflection import UNUSABLE, Critique, Fault

_OF_SHOTS = (
    AddShotEdit, ApproveEdit, BlockingEdit, CameraEdit, DurationEdit, JoinEdit, NoteEdit, SplitEdit, TakeEdit,
)  # fmt: skip
"""Edits that name a shot."""


class ShotNow(Frozen):
    """A shot as it is."""

    name: str
    camera: CameraInstruction
    frames: int
    lens: float
    """mm."""
    on_stage: tuple[str, ...]
    """People who are there."""


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
        genders: Gender of every person by id.
        everywhere: Whether ``all`` was said: what only some of them can do is then done there.
    """

    words: str
    shots: tuple[ShotNow, ...]
    names: Mapping[str, str]
    fps: int
    scenes: tuple[SceneNow, ...] = ()
    named: tuple[str, ...] = ()
    genders: Mapping[str, str] = field(default_factory=dict[str, str])
    everywhere: bool = False

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
        words: Names of shots or scenes and what is wanted: ``SC020_SH010: closer``, ``Scene 10 warmer``.

    Raises:
        InputError: There is no shot of that name, or nothing is said.
    """
    told = address_of(
        words,
        [shot_name(shot.scene_id, shot.shot_id) for shot in graph.shots],
        [scene_name(scene.scene_id) for scene in graph.scenes],
    )
    wanted = {*told.names}
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
    assets = [asset for asset in graph.assets if asset.origin != "dressing"]
    names = {asset.asset_id: asset.name or asset.asset_id for asset in assets}
    genders = {asset.asset_id: look.gender for asset in assets if (look := asset.decided_look) is not None}
    involved = {name.partition("_")[0] for name in wanted}
    now = tuple(scene_now(graph, scene) for scene in graph.scenes if scene_name(scene.scene_id) in involved)
    return InstructorView(
        told.said, tuple(shots), names, graph.format.fps, now, told.names, genders, everywhere=told.everywhere
    )


class RulesInstructor:
    """Knows words of cameras, lengths, light, sets, staging and things; one it does not know is said to be unclear."""

    def propose(self, view: InstructorView) -> Instruction:
        """Return the edits that the words mean, clause by clause."""
        edits: list[Edit] = [note for shot in view.shots for note in note_on(view.words, shot.name)]
        if edits:
            return Instruction(edits=tuple(edits))
        edits, unclear = read_sentences(view.words, _Phrases(view).read)
        joined = _joined(edits)
        cameras = (edit for edit in joined if isinstance(edit, CameraEdit))
        unclear += [problem for edit in cameras if (problem := problem_of(edit.decision))]
        return Instruction(edits=joined, unclear=tuple(dict.fromkeys(unclear)))

    def refine(self, draft: Instruction, critique: Critique, view: InstructorView) -> Instruction:
        """Return the draft: rules know a word or do not.

        Args:
            draft: The edits and the words that are unclear.
            critique: Its faults.
            view: The request, the shots it names and the names of the story.
        """
        return draft


class _Phrases:
    """Reads a phrase for all shots and scenes that were named.

    Args:
        view: What the Instructor sees.
    """

    def __init__(self, view: InstructorView) -> None:
        self._view, self._mentions = view, Mentions(view.names)
        present = ((shot, Present(shot.on_stage, view.genders)) for shot in view.shots)
        self._cameras = [(s, CameraWords(s.camera, s.lens, self._mentions, there)) for s, there in present]
        self._known: dict[str, Phrase | None] = {}

    def read(self, words: str) -> Phrase | None:
        """Return what words mean as one phrase; None where they are not known.

        Args:
            words: In lower case.
        """
        if words not in self._known:
            self._known[words] = self._read(words)
        return self._known[words]

    def _read(self, words: str) -> Phrase | None:
        if cut := edits_of_cut(words, self._view.targets):
            return Phrase(words, tuple(cut))
        if picture := format_decision(words):
            return self._of_film(words, picture)
        scenes = [(scene.name, edits_of_scene(words, scene)) for scene in self._view.scenes]
        of_scene = self._together(words, scenes)
        if of_scene is not None and not of_scene.problem:
            return of_scene
        of_shot = self._together(words, [*self._of_shots(words)])
        return of_shot if of_shot is not None and not of_shot.problem else of_scene or of_shot

    def _of_film(self, words: str, picture: FormatDecision | str) -> Phrase:
        """Return what is said of the picture of the film; it must be said of all of it."""
        if isinstance(picture, str):
            return Phrase(words, problem=f"{words!r} ({picture})")
        if not self._view.everywhere:
            return Phrase(words, problem=f"{words!r} (it is of the whole film: say 'all: {words}')")
        return Phrase(words, (FormatEdit(decision=picture),))

    def _of_shots(self, words: str) -> Iterator[tuple[str, list[Edit] | str]]:
        """Yield what words mean for each shot: edits, or in one sentence why they cannot be."""
        for shot, camera in self._cameras:
            if whole := edits_of_shot(words, shot.name, shot.frames / self._view.fps):
                yield shot.name, whole
                continue
            present = Present(shot.on_stage, self._view.genders)
            if posed := edits_of_person(words, shot.name, self._mentions, present, self._furniture(shot.name)):
                yield shot.name, posed
                continue
            said = camera.read(words)
            edits: list[Edit] = [CameraEdit(shot=shot.name, decision=said)] if isinstance(said, CameraDecision) else []
            yield shot.name, said if isinstance(said, str) else edits

    def _furniture(self, shot: str) -> Mapping[str, str]:
        """Return the catalogue key of each piece of furniture of a shot's scene, by node id."""
        return next((scene.furniture for scene in self._view.scenes if shot.startswith(f"{scene.name}_")), {})

    def _together(self, words: str, meant: Sequence[tuple[str, list[Edit] | str]]) -> Phrase | None:
        """Return what words mean for all; if one of those that were named cannot, that is a problem."""
        edits = [edit for _, each in meant if not isinstance(each, str) for edit in each]
        problems = [f"{words!r} ({name}: {each})" for name, each in meant if isinstance(each, str)]
        if problems and not (edits and self._view.everywhere):
            return Phrase(words, problem=problems[0])
        return Phrase(words, tuple(edits)) if edits else None


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
