"""The tools and resources of the server. Each is one call on the open session; none runs code or leaves the folder."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Annotated, Any, Literal

from fastmcp import FastMCP
from fastmcp.exceptions import ResourceError, ToolError
from fastmcp.utilities.types import Image
from mcp.types import ToolAnnotations
from PIL import Image as Pillow
from pydantic import Field

from storyblender.edits.dispatcher import Applied
from storyblender.errors import InputError, StoryBlenderError
from storyblender.memory.edits import Edit
from storyblender.memory.plain_words import names_of
from storyblender.workplace.values import (
    CheckReport,
    Edited,
    ShotDetails,
    Status,
    Story,
    Takes,
    details_of,
    story_of,
    takes_of,
    verdict_of,
)
from storyblender.workplace.workplace import Workplace

INSTRUCTIONS = """StoryBlender turns a script into an editable 3D storyboard. Work like a director: make a storyboard
from a script (make, then status until it is done), look at its shots (open_project, look, describe_shot), change what
does not tell the story (edit, a batch is one undo), look again, and check at the end. People and sets are 3D objects:
they stay the same from shot to shot, and only what an edit changes is drawn again."""
READS = ToolAnnotations(read_only_hint=True, open_world_hint=False)
CHANGES = ToolAnnotations(read_only_hint=False, destructive_hint=False, open_world_hint=False)
_DRAW_LIMIT = 50.0
"""Seconds that a call waits for pictures; then it is for ``status`` to say that they are there."""

Shot = Annotated[str, Field(description="Name of a shot, such as SC010_SH020.")]
Wait = Annotated[float, Field(description="Seconds to wait for the end of the work, at most.", ge=0, le=50)]


@contextmanager
def _sentences(kind: type[Exception] = ToolError) -> Iterator[None]:
    """Turn the errors we raise on purpose into the protocol's, as their sentence."""
    try:
        yield
    except StoryBlenderError as error:
        raise kind(str(error)) from error


def build_server(folder: Path) -> tuple[FastMCP[None], Workplace]:
    """Return the server for the scripts and projects of a folder, and the workplace that its caller closes.

    Args:
        folder: Nothing outside it is read or written.
    """
    server, place = FastMCP[None]("storyblender", INSTRUCTIONS), Workplace(folder)
    for add in (_add_work, _add_looking, _add_changing, _add_resources):
        add(server, place)
    return server, place


def _tool(server: FastMCP[None], annotations: ToolAnnotations) -> Callable[[Callable[..., Any]], object]:
    """Return a decorator that makes a function a tool under its own name; its docstring is what an agent reads."""
    return server.tool(annotations=annotations)


def _add_work(server: FastMCP[None], place: Workplace) -> None:
    """Add what begins and follows long work."""

    @_tool(server, READS)
    def list_projects() -> dict[str, list[str]]:
        """List the scripts and the storyboard projects of the folder."""
        with _sentences():
            scripts, projects = place.names()
            return {"scripts": scripts, "projects": projects}

    @_tool(server, CHANGES)
    def make(
        script: Annotated[str, Field(description="File name of the script in the folder, such as film.fountain.")],
        text: Annotated[
            str | None, Field(description="The script itself (Fountain, or prose in .txt), if it is not there yet.")
        ] = None,
        look: Annotated[
            Literal["board", "fast", "pencil"], Field(description="How frames are drawn; fast is for trying.")
        ] = "board",
        width: Annotated[int, Field(description="Pixels of a frame.", ge=160, le=3840, multiple_of=4)] = 960,
        animatic: Annotated[bool, Field(description="Whether to make the film as well; it takes longest.")] = False,
        wait_seconds: Wait = 0,
    ) -> Status:
        """Turn a script into a storyboard: minutes of work, which status follows. A changed script keeps what it can.

        The project is SCRIPT.storyboard in the folder; it is open from now on.
        """
        with _sentences():
            if text is not None:
                place.write_script(script, text)
            place.make(script, {"look": look, "width": width, "animatic": animatic})
            return place.wait(wait_seconds)

    @_tool(server, READS)
    def status(wait_seconds: Wait = 0) -> Status:
        """Say how far the work is that make, render or export began, and how it ended."""
        return place.wait(wait_seconds)

    @_tool(server, CHANGES)
    def cancel() -> Status:
        """End the work under way; what is finished is kept, and the same call goes on from there."""
        with _sentences():
            return place.cancel()

    @_tool(server, CHANGES)
    def render(
        shots: Annotated[list[str], Field(description="Shots to draw; all that changed if empty.")] = [],  # noqa: B006
        wait_seconds: Wait = 50,
    ) -> Status:
        """Draw again what changed, for example after undo or after edits that were not drawn."""
        with _sentences():
            session = place.session
            place.begin("render", lambda: session.render(shots))
            return place.wait(wait_seconds)

    @_tool(server, CHANGES)
    def export(
        kinds: Annotated[
            list[Literal["glb", "usd", "edl", "fcpxml"]],
            Field(description="Scenes for other 3D programs (glb, usd), the timeline for editors (edl, fcpxml)."),
        ],
        wait_seconds: Wait = 50,
    ) -> Status:
        """Write the scenes or the timeline for other programs."""
        with _sentences():
            session = place.session
            place.begin(f"export {', '.join(kinds)}", lambda: session.export(kinds))
            return place.wait(wait_seconds)


def _add_looking(server: FastMCP[None], place: Workplace) -> None:
    """Add what only looks."""

    @_tool(server, READS)
    def open_project(
        project: Annotated[str, Field(description="Folder name of the project, such as film.storyboard.")],
    ) -> Story:
        """Open a project of the folder and list its people, props and shots; the one before is closed."""
        with _sentences():
            place.open(project)
            return _story(place)

    @_tool(server, READS)
    def story() -> Story:
        """List people, props and shots of the open project, with its revision."""
        with _sentences():
            return _story(place)

    @_tool(server, READS)
    def describe_shot(shot: Shot) -> ShotDetails:
        """Say everything about a shot: lines, camera, people on stage, what a person decided, what is wrong."""
        with _sentences():
            panel = place.panel(shot)
            return details_of(panel, place.session.graph)

    @_tool(server, READS)
    def takes(shot: Shot) -> Takes:
        """List the takes of a shot: kept versions of its camera. `look` shows each, `edit` chooses or drops one."""
        with _sentences():
            panel = place.panel(shot)
            return Takes(shot=panel.name, takes=takes_of(panel.shot, names_of(place.session.graph)))

    @_tool(server, READS)
    def look(
        shot: Shot,
        width: Annotated[int, Field(description="Pixels of the picture, at most.", ge=64, le=1920)] = 640,
        take: Annotated[int | None, Field(description="Number of another take than the one in the film.")] = None,
    ) -> Image:
        """Return the frame of a shot as a picture. Look at it as a director would: does it tell the lines?"""
        with _sentences():
            return _frame(place, shot, width, take)

    @_tool(server, READS)
    def check() -> CheckReport:
        """Check the project: people in people, things in things, heads cut off, lines crossed, actions nobody does."""
        with _sentences():
            found = place.session.check()
            rows = {row.name: f"{row.value}{'' if row.ok else ' (wrong)'}" for row in found.rows}
            return CheckReport(clean=found.clean, rows=rows, findings=found.findings)


def _add_changing(server: FastMCP[None], place: Workplace) -> None:
    """Add what changes a story."""

    @_tool(server, CHANGES)
    def edit(
        edits: Annotated[
            list[Edit],
            Field(description="Applied in order, all or none; one undo takes all of them back.", min_length=1),
        ],
        revision: Annotated[
            str | None, Field(description="What they were made on; refused if what they touch has changed since.")
        ] = None,
        draw: Annotated[bool, Field(description="Whether to draw what changed at once.")] = True,
    ) -> Edited:
        """Change cameras, lengths, light, set, staging, things, takes; split, join, add, omit, move shots; lock, note.

        Only what an edit changes is made and drawn again.
        """
        with _sentences():
            return _edited(place, place.session.apply(edits, revision), draw=draw)

    @_tool(server, CHANGES)
    def instruct(
        words: Annotated[
            str, Field(description="Shots or scenes, a colon, and what is wanted: 'SC010_SH020: closer, low angle'.")
        ],
        revision: Annotated[
            str | None, Field(description="What they were said of; refused if what they touch has changed since.")
        ] = None,
    ) -> Edited:
        """Change cameras, lengths, light, sets and things in the words of film people; edit does it with values."""
        with _sentences():
            return _edited(place, place.session.instruct(words, revision), draw=True)

    @_tool(server, CHANGES)
    def undo() -> Edited:
        """Take back the last change with all that followed from it; render then draws what that changes."""
        with _sentences():
            return _stepped(place, place.session.undo())

    @_tool(server, CHANGES)
    def redo() -> Edited:
        """Make the change again that was undone last; render then draws what that changes."""
        with _sentences():
            return _stepped(place, place.session.redo())


def _add_resources(server: FastMCP[None], place: Workplace) -> None:
    """Add the files of the open project that a client may read whole."""
    files = {
        "trace": ("trace.jsonl", "application/x-ndjson", "What each role of the crew proposed and how it scored."),
        "shots": ("shots.csv", "text/csv", "The shot list."),
        "board": ("board.pdf", "application/pdf", "The printed board."),
    }
    for name, (file, kind, about) in files.items():
        server.resource(f"storyblender://{name}", name=name, mime_type=kind, description=about)(
            _reader(place, file, text=kind != "application/pdf")
        )

    @server.resource("storyblender://vocabulary", mime_type="application/json")
    def vocabulary() -> str:
        """Every word that an edit can name, with a sentence: fields, sizes, angles, moves, motions, sets ..."""
        from storyblender.agents.vocabulary import vocabulary

        own = place.session.own_motions if place.is_open else {}
        return json.dumps(vocabulary(own), ensure_ascii=False)

    @server.resource("storyblender://graph", mime_type="application/json")
    def graph() -> str:
        """The continuity memory graph as it is now: everything about the story."""
        with _sentences(ResourceError):
            return place.session.graph.model_dump_json()


def _reader(place: Workplace, file: str, *, text: bool) -> Callable[[], str | bytes]:
    """Return a function that reads a file of the open project whole."""

    def read() -> str | bytes:
        with _sentences(ResourceError):
            path = place.session.folder / file
            if not path.is_file():
                raise InputError("is not there yet", mend="make the storyboard first", path=file)
            return path.read_text(encoding="utf-8-sig") if text else path.read_bytes()

    return read


def _story(place: Workplace) -> Story:
    session = place.session
    return story_of(session.graph, session.revision, session.made, place.panels())


def _edited(place: Workplace, applied: Applied, *, draw: bool) -> Edited:
    """Return what a batch of edits did, after drawing what it made stale if ``draw`` says so."""
    drawn = place.session.draw(applied) if draw else None
    cuts = tuple(flaw.message for flaw in drawn.wrong_cuts) if drawn is not None else ()
    names = names_of(place.session.graph)
    frames = tuple(verdict_of(review, names) for review in drawn.reviews.values()) if drawn is not None else ()
    told = {"revision": applied.version, "done": applied.words, "redrawn": applied.stale, "warnings": applied.warnings}
    followed = drawn.followed if drawn is not None else ()
    return Edited(**told, followed=followed, wrong_cuts=cuts, frames=frames)


def _stepped(place: Workplace, commits: Sequence[Any]) -> Edited:
    """Return what an undo or a redo did."""
    done = "; ".join(commit.reason for commit in commits if commit.author == "user")
    return Edited(revision=place.session.revision, done=done or commits[-1].reason, redrawn=())


def _frame(place: Workplace, shot: str, width: int, take: int | None) -> Image:
    """Return the frame of a shot, or of another take of it, no wider than asked for. Raises InputError."""
    panel = place.panel(shot)
    name = panel.name
    path = place.session.folder / "frames" / f"{name}.png"
    if take is not None and take != panel.shot.take:
        drawn = place.session.takes(name)
        if take not in drawn:
            raise InputError(f"take {take} of {name} is not drawn", mend="choose it with an edit of kind `take`")
        path = drawn[take]
    if not path.is_file():
        raise InputError(f"{name} is not drawn yet", mend="call render, and status until it is done")
    with Pillow.open(path) as picture:
        small = picture.convert("RGB")
        small.thumbnail((width, width))
    data = BytesIO()
    small.save(data, "PNG")
    return Image(data=data.getvalue(), format="png")
