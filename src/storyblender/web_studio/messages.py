"""What a browser or a program and the studio say to each other: calls, their answers, and news for all browsers."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, TypeAdapter

from storyblender.memory.base import Described
from storyblender.memory.edits import Edit
from storyblender.trace import Event
from storyblender.web_studio.deliver import DeliverCall, WriteCall
from storyblender.web_studio.page_call import PageCall as _Call
from storyblender.web_studio.taking import PanoramaCall, SurfaceCall, TakeModelCall, TakeOfferCall
from storyblender.workplace.values import ShotDetails, Status

_Name = Annotated[str, Field(min_length=1, max_length=128)]


def _without_folders(crew: str) -> str:
    """Refuse a crew that reads or writes a folder of answers: the page names no paths. Raises ValueError."""
    if any(player in crew for player in ("ask:", "replay:")):
        raise ValueError("a folder of answers is named on the command line, with --crew")
    return crew


class OpenCall(_Call):
    """Opens a project of the folder."""

    call: Literal["open"]
    """Which call this is."""
    project: _Name
    """Folder name."""


class MakeCall(_Call):
    """Begins to turn a script into a storyboard."""

    call: Literal["make"]
    """Which call this is."""
    script: _Name
    """File name of the script in the folder."""
    text: Annotated[str, Field(max_length=4_000_000)] | None = None
    """The script itself, if it was dropped into the page."""
    look: Literal["board", "fast", "pencil"] = "board"
    """How frames are drawn."""
    animatic: bool = False
    """Whether the film is made as well."""
    crew: Annotated[str, Field(min_length=1, max_length=500), AfterValidator(_without_folders)] = "rules"
    """Who plays the roles, as ``--crew``: rules, or models; a folder of answers is named on the command line only."""


class ApplyCall(_Call):
    """Makes a batch of edits: one gesture, one undo."""

    call: Literal["apply"]
    """Which call this is."""
    edits: Annotated[tuple[Edit, ...], Field(min_length=1, max_length=500)]
    """Applied in order, all or none."""
    revision: _Name | None = None
    """What the person saw when they made them."""


class InstructCall(_Call):
    """Words for the crew about what is selected."""

    call: Literal["instruct"]
    """Which call this is."""
    words: Annotated[str, Field(min_length=1, max_length=2000)]
    """Shots or scenes, a colon, and what is wanted."""
    revision: _Name | None = None
    """What the person saw when they said it."""


class ShotCall(_Call):
    """Asks for something about a shot."""

    call: Literal["shot", "why", "takes", "draw", "draw_take"]
    """``shot``: everything that can be changed; ``why``: who decided what; ``takes``: pictures of its other takes;
    ``draw``: its frame is drawn now; ``draw_take``: a picture of one of its other takes is."""
    shot: _Name
    """Such as ``SC010_SH020``."""
    of: Literal["camera", "blocking", "layout"] = "camera"
    """What the takes are of."""
    number: Annotated[int, Field(ge=1, le=999)] | None = None
    """Of the take to draw."""


class SceneCall(_Call):
    """Asks for the set and the light of a scene."""

    call: Literal["scene"]
    """Which call this is."""
    scene: _Name
    """Such as ``SC010``."""


class PicturesCall(_Call):
    """Asks which surfaces or panoramas there are, in the folder and in the user's library; nothing is changed."""

    call: Literal["pictures"]
    """Which call this is."""
    kind: Literal["texture", "panorama"]
    """What is wanted."""
    words: Annotated[str, Field(max_length=200)] = ""
    """All of them are in its name, tags, author or licence; empty for all."""


class StageCall(_Call):
    """Asks for the scene of a shot in 3D, at one moment."""

    call: Literal["stage"]
    """Which call this is."""
    shot: _Name
    """Such as ``SC010_SH020``."""
    frame: Annotated[int, Field(ge=0, le=1_000_000)] | None = None
    """From its start; the moment that the board shows if not given."""


class AssetCall(_Call):
    """Asks for people and things: all of them, one of them, a picture, a model, what else it could be made from."""

    call: Literal["assets", "asset", "asset_picture", "asset_model", "candidates", "offers", "offer_picture"]
    """``assets``: the list; of one: ``asset``: everything about it, ``asset_picture`` and ``asset_model``: addresses of
    its picture and of it as glTF, ``candidates``: what it could be made from instead, ``offers``: the same of services,
    ``offer_picture``: the address of a picture of what a service offers."""
    asset: Annotated[str, Field(max_length=128)] = ""
    """Its id."""
    words: Annotated[str, Field(max_length=200)] = ""
    """Of candidates: what is looked for; what the script says of the thing if empty."""
    digest: Annotated[str, Field(max_length=64)] = ""
    """Of a picture: the candidate that is meant, among those for the words."""
    file: Annotated[str, Field(max_length=256)] = ""
    """Of a picture of what a service offers: its ``file``."""
    as_in_file: bool = False
    """Of a model of the user: in the pose that its file has."""


class ReviseCall(_Call):
    """Asks what a revised script would change, or takes it over."""

    call: Literal["compare", "revise"]
    """``compare``: nothing is changed; ``revise``: it is taken over, and what it changes is made."""
    script: _Name
    """File name of the revised script; in the folder if its text is not given."""
    text: Annotated[str, Field(max_length=4_000_000)] | None = None
    """The script itself, if it was dropped into the page."""


class ProposeCall(_Call):
    """Asks for other stagings of the scene of a shot; nothing is changed."""

    call: Literal["propose"]
    """Which call this is."""
    shot: _Name
    """The shot that is to be seen in them."""
    takes: Annotated[int, Field(ge=1, le=6)] = 3
    """How many."""


class TakeOverCall(_Call):
    """Takes over what was saved in Blender."""

    call: Literal["take_over"]
    """Which call this is."""
    take: tuple[_Name, ...] = ()
    """Ids of the conflicts that are as in Blender."""
    leave: tuple[_Name, ...] = ()
    """Ids of those that stay as in the project; the others wait."""


class LibraryCall(_Call):
    """Asks what is in the user's library; nothing is changed."""

    call: Literal["library", "library_picture"]
    """``library``: what fits the words; ``library_picture``: the picture of a model is drawn, its address told."""
    words: Annotated[str, Field(max_length=200)] = ""
    """What is looked for; empty for all."""
    digest: Annotated[str, Field(max_length=64)] = ""
    """Of the model whose picture is drawn."""


class PlainCall(_Call):
    """A call that needs nothing else."""

    call: Literal[
        "places", "board", "shots", "vocabulary", "undo", "redo", "cancel", "go_on", "check", "cut",
        "pull", "blender", "changes", "link",
    ]  # fmt: skip
    """``places``: scripts and projects of the folder; ``cut``: the film as a timeline;
    ``shots``: all that ``shot`` tells, of every shot; ``go_on``: work that was stopped is gone on with;
    ``pull``: what was changed and saved in Blender is taken over; ``blender``: whether anything was saved there;
    ``changes``: what that is, and nothing is taken over; ``link``: an address for one more
    browser."""


Call = Annotated[
    OpenCall
    | MakeCall
    | ApplyCall
    | InstructCall
    | ShotCall
    | SceneCall
    | PicturesCall
    | SurfaceCall
    | PanoramaCall
    | StageCall
    | AssetCall
    | TakeOfferCall
    | TakeModelCall
    | ReviseCall
    | ProposeCall
    | DeliverCall
    | WriteCall
    | TakeOverCall
    | LibraryCall
    | PlainCall,
    Field(discriminator="call"),
]
CALLS: TypeAdapter[Call] = TypeAdapter(Call)


class StagingCard(Described):
    """A staging that stands to choose."""

    number: int
    """What a layout edit calls it."""
    picture: str
    """Address of the shot's picture in it."""
    moved: str
    """What is elsewhere in it, and how far."""


class PanelCard(Described):
    """A shot on the board."""

    shot: str
    """Its name."""
    scene: str
    """Name of its scene."""
    facts: str
    """Camera in a line."""
    seconds: float
    """Length."""
    words: str
    """Action of the script."""
    script: tuple[tuple[str, str], ...]
    """Cues and words in the order of the script; action has an empty cue."""
    picture: str
    """Address of its frame; empty while there is none."""
    state: Literal["fresh", "preview", "stale", "none"]
    """Whether the picture shows the shot as it is; a preview does, small and quickly drawn."""
    omitted: bool
    """Whether a person left it, or its scene, out of the film."""
    approved: bool
    """Whether a person approved it."""
    notes: int
    """How many notes on it are open."""
    locked: bool
    """Whether any part of it is locked."""
    takes: int
    """How many takes there are."""
    problems: int
    """How many things the crew could not make right."""


class SceneCard(Described):
    """A scene on the board."""

    scene: str
    """Such as ``SC010``."""
    title: str
    """Its heading."""
    omitted: bool
    """Whether a person left it out of the film."""
    shots: tuple[PanelCard, ...]
    """In order."""


class Board(Described):
    """The open project as the page shows it."""

    project: str
    """Folder name."""
    title: str
    """Of the story."""
    revision: str
    """Edits name it."""
    made: bool
    """Whether it is staged; a plan has no pictures."""
    aspect: float
    """Width of a picture divided by its height."""
    aspects: dict[str, float]
    """Those that pictures usually have, by name."""
    sensor_width: float
    """mm, of the film; a camera that was locked before may have another."""
    sensors: dict[str, float]
    """Widths of usual sensors in mm, by name."""
    lens_kit: tuple[float, ...]
    """Lenses at hand in mm; empty allows any."""
    summary: str
    """Scenes, shots and length."""
    scenes: tuple[SceneCard, ...]
    """In order."""
    cast: dict[str, str]
    """Id and name of every character."""
    undo: str
    """What undo takes back; empty where there is nothing."""
    redo: str
    """What redo makes again."""
    film: str
    """Address of the animatic; empty while there is none."""


class Answer(Described):
    """What a call came to."""

    id: int
    """Of the call."""
    ok: bool
    """Whether it was done."""
    value: object = None
    """What it returns."""
    error: str = ""
    """Why it was not done, in a sentence."""


class News(Described):
    """Told to every browser."""

    news: Literal["board", "status", "event", "frames", "blender"]
    """``board``: something changed, ask again; ``frames``: these pictures are new; ``event``: the crew at work;
    ``blender``: story.blend was saved there."""
    revision: str = ""
    """Of the project now."""
    status: Status | None = None
    """How far long work is."""
    event: Event | None = None
    """What a role proposed, how it scored ..."""
    shots: tuple[str, ...] = ()
    """Whose pictures are new."""


__all__ = ["CALLS", "Answer", "Board", "Call", "News", "PanelCard", "SceneCard", "ShotDetails"]
