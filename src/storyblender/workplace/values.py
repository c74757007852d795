"""What the tools of the server return; every field is described in the schema that an agent sees."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Literal

from storyblender.deliver.checklist import to_check
from storyblender.deliver.panel import Panel
from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import Described
from storyblender.memory.camera_decision import CameraInstruction
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.kept_takes import BlockingTakes, LayoutTakes
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.scene_decision import BlockingDecision, LayoutDecision
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.reviewing import FrameReview
from storyblender.trace import Event

WARNINGS = 30
"""Most warnings that a status lists."""


class Line(Described):
    """A line of the script that a shot shows."""

    kind: Literal["action", "dialogue"]
    """Action or speech."""
    text: str
    """Its words, verbatim."""
    speaker: str = ""
    """Id of who speaks."""


class ShotSummary(Described):
    """A shot in a line."""

    shot: str
    """Its name, as every tool takes it: SC010_SH020."""
    heading: str
    """Heading of its scene in the script."""
    camera: str
    """Size, kind, angle, lens and move."""
    seconds: float
    """Length of the shot."""
    shows: tuple[str, ...]
    """Ids of the characters it is meant to show."""
    description: str
    """What happens in it."""
    omitted: bool = False
    """Whether a person left it out of the film; the edit of kind `restore` brings it back."""


class ShotDetails(ShotSummary):
    """Everything about a shot that an edit may change or a person may ask."""

    size: str
    """How much is seen: EWS WS FS MWS MS MCU CU ECU."""
    kind: str
    """Kind of picture: single, two_shot, ots ..."""
    angle: str
    """Height and tilt of the camera."""
    movement: str
    """What the camera does."""
    lens: float
    """mm."""
    f_number: float | None
    """None while the shot has no camera yet."""
    frames: int
    """Length of the shot in frames."""
    on_stage: tuple[str, ...]
    """Ids of everybody in the place, in the picture or not."""
    lines: tuple[Line, ...]
    """Lines of the script that it shows."""
    camera_location: tuple[float, float, float] | None
    """Metres in the scene, Z up, as the shot begins; None while it has no camera yet."""
    camera_looks_at: tuple[float, float, float] | None
    """The point in the middle of the picture, likewise."""
    decided: tuple[str, ...]
    """What a person decided about the camera, and where people stand."""
    takes: tuple[TakeSummary, ...]
    """Versions of its camera that are kept, with the one that the film shows."""
    blocking_takes: tuple[TakeSummary, ...]
    """The same of its blocking: where people are and what they do."""
    layout_takes: tuple[TakeSummary, ...]
    """The same of the layout of its scene."""
    scene_decided: tuple[str, ...]
    """What a person decided about light, set and staging of its scene."""
    locked: tuple[str, ...]
    """Parts of the shot that neither the crew nor an edit may change."""
    approved: bool
    """Whether a person approved it; nothing of it may change then."""
    notes: tuple[NoteOn, ...]
    """What people wrote about it."""
    stand_ins: dict[str, str]
    """Things of its scene that no source has, by id: a prompt for a service that makes a picture or a model of it."""
    problems: tuple[str, ...]
    """What the crew could not make right."""


class NoteOn(Described):
    """A note on a shot."""

    number: int
    """The edit of kind `note` resolves it or removes it by this."""
    text: str
    """Its words."""
    author: str
    """Who wrote it; may be empty."""
    resolved: bool
    """Whether it is done."""


class TakeSummary(Described):
    """A take: a version of a shot's camera, of its blocking or of its scene's layout that is kept."""

    number: int
    """As on the slate; the edit of kind `take` chooses it or drops it."""
    in_film: bool
    """Whether it is the one that the film shows, and that edits change."""
    camera: str
    """Size, kind, angle and move; empty for a take of something else."""
    decided: tuple[str, ...]
    """What a person decided about it."""


class Takes(Described):
    """All takes of a shot."""

    shot: str
    """Its name."""
    takes: tuple[TakeSummary, ...]
    """In order of their numbers."""


class Story(Described):
    """A project."""

    title: str
    """Of the story."""
    revision: str
    """Name it in an edit: the edit is refused if what it touches has changed since."""
    made: bool
    """Whether there is something to look at; a project that is only planned has no frames."""
    aspect: float
    """Width of the picture divided by its height."""
    sensor_width: float
    """mm, of the film; lenses are those of such a camera."""
    cast: dict[str, str]
    """Id and name of every character."""
    props: dict[str, str]
    """Id and name of every object of the script, and of those that a person added."""
    shots: tuple[ShotSummary, ...]
    """All shots in order."""


class Status(Described):
    """How far the work is."""

    busy: bool
    """Whether work is under way; ask again, or wait with ``wait_seconds``."""
    work: str
    """What is done, or was done last."""
    film: bool
    """Whether a story that is made gets a film as well."""
    stage: str
    """The stage it has come to: ground, materialize, stage, pack, camera, frames, motion, deliver ..."""
    step: int
    """Steps of the stage that are done."""
    total: int
    """Steps that the stage has."""
    error: str
    """Why the last work ended, if it did not come to its end."""
    warnings: tuple[str, ...]
    """What the crew could not do as the script says it."""
    files: tuple[str, ...]
    """Files of the project that the last work wrote."""


class Seen(Described):
    """How a person or thing is in a picture. Places are shares of its width and height, from the top left."""

    who: str
    """Id of the person or thing."""
    fills: float
    """Share of the picture that it covers."""
    box: tuple[float, float, float, float] | None
    """Left, top, right, bottom of what is visible of it."""
    visible: float
    """Share of it that is in the picture and not hidden."""
    head: float
    """Height of a person's head as a share of the picture's; 0 for a thing."""
    face: tuple[float, float] | None
    """Where the middle of the face is."""
    turned: float
    """Degrees by which the face is turned from the camera: 0 is full face, 90 profile, 180 the back of the head."""


class FrameVerdict(Described):
    """What the Frame Critic says of a frame."""

    shot: str
    """Name of the shot."""
    verdict: Literal["pass", "fix", "reject"]
    """Whether the frame tells its lines, and is as it was asked for."""
    score: float
    """1 to 10; a frame passes from 8."""
    faults: tuple[str, ...]
    """What is wrong, one sentence each."""
    seen: tuple[Seen, ...]
    """Who and what is in the picture, and how large."""


class Edited(Described):
    """What a batch of edits did."""

    revision: str
    """Of the project now."""
    done: str
    """In words; empty where nothing was to be done."""
    redrawn: tuple[str, ...]
    """Shots whose frames show something else now."""
    warnings: tuple[str, ...] = ()
    """What you should know of it, such as what a thing that you placed stands in."""
    followed: tuple[str, ...] = ()
    """Other shots that changed in consequence, such as a camera that no longer saw its subject, once it is drawn."""
    wrong_cuts: tuple[str, ...] = ()
    """What is wrong now with cuts to and from the cameras that were changed."""
    frames: tuple[FrameVerdict, ...] = ()
    """The Frame Critic's judgement of each frame that was drawn again."""


class CheckReport(Described):
    """What is wrong in a finished project."""

    clean: bool
    """Whether nothing is wrong."""
    rows: dict[str, str]
    """What was checked, and how it stands."""
    findings: tuple[str, ...]
    """One sentence for each thing to look at."""


def summary_of(panel: Panel) -> ShotSummary:
    """Return a shot in a line."""
    return ShotSummary(
        shot=panel.name,
        heading=panel.scene.title,
        camera=panel.facts,
        seconds=round(panel.seconds, 2),
        shows=panel.shot.shown,
        description=panel.description,
        omitted=panel.omitted,
    )


def takes_of(shot: ShotContext, names: Mapping[str, str]) -> tuple[TakeSummary, ...]:
    """Return all takes of a shot, in order of their numbers.

    Args:
        shot: The shot.
        names: Of people and things by id, as ``names_of`` returns them.
    """
    return tuple(
        TakeSummary(
            number=take.number,
            in_film=take.number == shot.take,
            camera=described(take.camera_instruction),
            decided=tuple(plain(take.camera_decision.words, names).split(", ")) if take.camera_decision else (),
        )
        for take in sorted((*shot.takes, shot.as_take), key=lambda take: take.number)
    )


def _takes_of_decisions(
    takes: BlockingTakes | LayoutTakes | None,
    present: BlockingDecision | LayoutDecision | None,
    names: Mapping[str, str],
) -> tuple[TakeSummary, ...]:
    """Return all takes of a blocking or a layout, in order of their numbers."""
    number = takes.number if takes is not None else 1
    decided = {number: present} | {each.number: each.decision for each in (takes.others if takes is not None else ())}
    return tuple(
        TakeSummary(
            number=each,
            in_film=each == number,
            camera="",
            decided=(plain(decision.words, names),) if decision is not None and decision.words else (),
        )
        for each, decision in sorted(decided.items())
    )


def described(camera: CameraInstruction) -> str:
    """Return a camera as it is wanted in a line: ``MCU single, low angle, push in``."""
    said = (f"{camera.size} {camera.kind.replace('_', ' ')}", camera.angle, camera.movement, camera.direction or "")
    return ", ".join(filter(None, said))


def details_of(panel: Panel, graph: ContinuityMemoryGraph) -> ShotDetails:
    """Return everything about a shot.

    Args:
        panel: The shot.
        graph: The story.
    """
    scene, names = graph.scene(panel.shot.scene_id), names_of(graph)
    decisions = {part: getattr(scene, f"{part}_decision") for part in ("light", "set", "layout")}
    shot, camera = panel.shot, panel.shot.camera
    first = camera.poses[0] if camera is not None else None
    stands = Orbit(first.pivot, first.rotation, first.distance, first.lens).position if first is not None else None
    return ShotDetails(
        **summary_of(panel).model_dump(),
        size=shot.camera_instruction.size,
        kind=shot.camera_instruction.kind,
        angle=shot.camera_instruction.angle,
        movement=panel.movement,
        lens=round(panel.lens, 1),
        f_number=camera.f_number if camera is not None else None,
        frames=shot.duration,
        on_stage=shot.on_stage,
        lines=tuple(Line(kind=each.kind, text=each.text, speaker=each.speaker or "") for each in panel.outline.lines),
        camera_location=stands if stands is None else _rounded(stands),
        camera_looks_at=first and _rounded(first.pivot),
        decided=(
            *(plain(shot.camera_decision.words, names).split(", ") if shot.camera_decision is not None else ()),
            *([f"marks: {plain(shot.blocking_decision.words, names)}"] if shot.blocking_decision is not None else ()),
            *([f"animated by hand: {plain(', '.join(shot.motion_by_hand), names)}"] if shot.motion_by_hand else ()),
        ),
        takes=takes_of(shot, names),
        blocking_takes=_takes_of_decisions(shot.blocking_takes, shot.blocking_decision, names),
        layout_takes=_takes_of_decisions(scene.layout_takes, scene.layout_decision, names),
        scene_decided=tuple(
            f"{part}: {plain(each.words, names)}" for part, each in decisions.items() if each is not None
        ),
        locked=(*shot.locked, *(f"{part} of the scene" for part in scene.locked)),
        approved=shot.approved is not None,
        notes=tuple(NoteOn(**note.model_dump()) for note in shot.notes),
        stand_ins={
            asset.asset_id: asset.image_prompt for asset in graph.assets_of(scene.scene_id) if asset.image_prompt
        },
        problems=to_check(shot, names),
    )


def verdict_of(review: FrameReview, names: Mapping[str, str]) -> FrameVerdict:
    """Return the Frame Critic's review of a frame as an agent reads it; what is not in the picture is left out.

    Args:
        review: Of the frame.
        names: Of people and things by id, as ``names_of`` returns them.
    """
    seen = tuple(
        Seen(
            who=each.node_id, fills=round(each.pixels, 4), box=each.box and _shares(each.box),
            visible=round(each.visible_fraction, 2), head=round(each.head_height, 3),
            face=each.face and _shares(each.face), turned=round(each.face_angle),
        )
        for each in review.seen
        if each.pixels
    )  # fmt: skip
    faults = tuple(plain(fault.message, names) for fault in review.faults)
    return FrameVerdict(shot=review.shot, verdict=review.verdict, score=review.score, faults=faults, seen=seen)


def _shares(values: tuple[float, ...]) -> Any:
    """Return places in the picture, rounded."""
    return tuple(round(value, 2) for value in values)


def _rounded(point: Iterable[float]) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 2) for value in point)
    return x, y, z


def story_of(graph: ContinuityMemoryGraph, revision: str, made: bool, shots: tuple[Panel, ...]) -> Story:
    """Return a project in short.

    Args:
        graph: Its graph.
        revision: Of the graph.
        made: Whether it is drawn.
        shots: All shots.
    """
    named = {kind: {} for kind in ("character", "object")}
    for asset in graph.assets:
        if asset.origin != "dressing":
            named[asset.asset_type][asset.asset_id] = asset.name or asset.asset_id
    return Story(
        title=graph.title, revision=revision, made=made,
        aspect=graph.format.aspect, sensor_width=graph.format.sensor_width,
        cast=named["character"], props=named["object"], shots=tuple(map(summary_of, shots)),
    )  # fmt: skip


def warning_of(event: Event) -> str:
    """Return a warning of a run as a sentence that names what it is about."""
    return f"{event.subject}: {event.message}" if event.subject else event.message
