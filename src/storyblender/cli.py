"""The command line. No logic: words in, Studio, words out. Exit 0 done, 1 something was found, 2 bad input."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from storyblender import __version__
from storyblender.shell import Commands, shown
from storyblender.terminal import Terminal

if TYPE_CHECKING:
    from storyblender.engine.worker import Worker
    from storyblender.studio import Studio

app = typer.Typer(
    cls=Commands,
    rich_markup_mode="rich",
    add_completion=False,
    help="From a script to an editable 3D storyboard.\n\n"
    "Start with: [bold]storyblender make SCRIPT[/bold], where SCRIPT is a Fountain (.fountain) or Final Draft (.fdx) "
    "screenplay, or prose (.txt, .md). It writes SCRIPT.storyboard beside it: a .blend, frames, board.pdf, "
    "animatic.mp4, shots.csv, timeline.otio and index.html.",
)


class ExportName(StrEnum):
    """The exchange formats."""

    GLB = "glb"
    USD = "usd"
    EDL = "edl"
    FCPXML = "fcpxml"


Script = Annotated[
    Path, typer.Argument(metavar="SCRIPT", help="A .fountain, .fdx, .txt or .md file.", show_default=False)
]
Folder = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="A project folder, NAME.storyboard.", show_default=False)
]
Out = Annotated[
    Path | None, typer.Option("--out", "-o", help="The project folder; NAME.storyboard beside the script if not given.")
]
LookOption = Annotated[str | None, typer.Option(help="board: lit and inked; fast: quicker light; pencil; render.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing but errors.")]
Json = Annotated[bool, typer.Option("--json", help="Machine-readable: events or results as JSON, one a line.")]
Jobs = Annotated[int | None, typer.Option(help="Blender processes; by default one for each processor, two at most.")]
Seed = Annotated[int | None, typer.Option(help="Same script, seed and settings: same storyboard, to the pixel.")]
Shots = Annotated[
    int | None, typer.Option("--shots-per-scene", help="About how many shots a scene may have (default 4).")
]
Aspect = Annotated[str | None, typer.Option(help="Width over height of the picture: 2.39, 1.85, 16:9, 9:16 ...")]
Width = Annotated[int | None, typer.Option(help="Pixels across (default 960).")]
Fps = Annotated[int | None, typer.Option(help="Frames a second (default 24).")]
Crew = Annotated[str | None, typer.Option(help="Who plays the roles: rules (needs no key).")]
Models = Annotated[Path | None, typer.Option(help="A folder of your own .glb and .blend files, searched first.")]


@app.command()
def make(
    script: Script,
    out: Out = None,
    look: LookOption = None,
    crew: Crew = None,
    aspect: Aspect = None,
    width: Width = None,
    fps: Fps = None,
    shots_per_scene: Shots = None,
    models: Models = None,
    animatic: Annotated[bool | None, typer.Option(help="Make the moving film as well.")] = None,
    slate: Annotated[bool | None, typer.Option(help="Burn name, lens and time into copies of the frames.")] = None,
    jobs: Jobs = None,
    seed: Seed = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Turn a script into a storyboard: everything. Run it again to go on where it was stopped."""
    settings: dict[str, Any] = dict(
        look=look, crew=crew, aspect=aspect, width=width, fps=fps, jobs=jobs, seed=seed,
        shots_per_scene=shots_per_scene, models=models, animatic=animatic, slate=slate,
    )  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal, script, **settings)
        delivery = studio.make(script, out or _folder_of(script))
        terminal.files(delivery.folder, delivery.files)


@app.command()
def plan(
    script: Script,
    out: Out = None,
    crew: Crew = None,
    shots_per_scene: Shots = None,
    aspect: Aspect = None,
    fps: Fps = None,
    seed: Seed = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Read a script into the memory graph only: cast, scenes, shots. No Blender."""
    settings: dict[str, Any] = dict(crew=crew, shots_per_scene=shots_per_scene, aspect=aspect, fps=fps, seed=seed)
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal, script, **settings)
        delivery = studio.plan(script, out or _folder_of(script))
        terminal.plan(delivery.graph)
        terminal.files(delivery.folder, delivery.files)


@app.command()
def render(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[list[str] | None, typer.Option(help="Only this shot, e.g. SC010_SH020; may be repeated.")] = None,
    look: LookOption = None,
    size: Annotated[str | None, typer.Option(help="Reframe the shot: EWS WS FS MWS MS MCU CU ECU.")] = None,
    angle: Annotated[str | None, typer.Option(help="eye-level, high angle, low angle, bird's-eye, dutch ...")] = None,
    lens: Annotated[float | None, typer.Option(help="Change the lens, in mm.")] = None,
    move: Annotated[str | None, typer.Option(help="Camera move: static, pan left, tilt up, push in ...")] = None,
    animatic: Annotated[bool, typer.Option(help="Render the moving film again where it changed.")] = False,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Render a project again: only what changed, or the shots named, with a changed camera if you say so."""
    camera = {"size": size, "angle": angle, "lens": lens, "movement": move}
    change = {key: value for key, value in camera.items() if value is not None}
    settings: dict[str, Any] = dict(look=look, jobs=jobs, animatic=animatic)
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal, project=folder, ahead=context.obj, **settings)
        delivery = studio.render(folder, shot or [], change)
        terminal.files(delivery.folder, delivery.files)


@app.command()
def undo(folder: Folder, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Take back the last change of a project. `render` then draws only what that changes."""
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal)
        terminal.commits("undone", studio.undo(folder))


@app.command()
def redo(folder: Folder, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Make the change again that was undone last."""
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal)
        terminal.commits("redone", studio.redo(folder))


@app.command()
def check(context: typer.Context, folder: Folder, json_lines: Json = False) -> None:
    """Check a project: layout, framing, continuity, collisions, people in frame. Exits 1 if something is wrong."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        studio = _studio(terminal, project=folder, ahead=context.obj)
        report = studio.check(folder)
        terminal.check(report)
    raise typer.Exit(0 if report.clean else 1)


@app.command()
def export(
    context: typer.Context,
    folder: Folder,
    to: Annotated[list[ExportName], typer.Option("--to", help="glb, usd (every scene), edl, fcpxml; repeatable.")],
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Write the scenes as glTF or USD, or the timeline as EDL or FCPXML."""
    with shown(quiet, json_lines) as terminal:
        studio = _studio(terminal, project=folder, ahead=context.obj)
        delivery = studio.export(folder, [str(name.value) for name in to])
        terminal.files(delivery.folder, delivery.files)


@app.command(name="doctor")
def examine(json_lines: Json = False) -> None:
    """Say whether this machine can run StoryBlender, and the line that mends it if not."""
    from storyblender import doctor

    findings = doctor.examine()
    with shown(quiet=False, json_lines=json_lines) as terminal:
        terminal.findings(findings)
    raise typer.Exit(0 if all(finding.healthy for finding in findings) else 1)


@app.command()
def catalog(
    kind: Annotated[
        str,
        typer.Argument(
            metavar="KIND", help="props, sets, garments, hair, materials, motions or looks; all if not given."
        ),
    ] = "",
    picture: Annotated[str | None, typer.Option(help="Render a picture of this entry.")] = None,
    out: Annotated[Path, typer.Option("--out", "-o", help="Where the picture goes.")] = Path("catalog.png"),
    json_lines: Json = False,
) -> None:
    """List what the built-in library can make, or render a picture of an entry."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        studio = _studio(terminal)
        if picture is not None:
            studio.picture(picture, out, kind)
            terminal.files(out.parent, [out.name])
        else:
            terminal.catalog(studio.catalog(kind))


@app.callback(invoke_without_command=True)
def main(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Global options."""
    if version:
        typer.echo(f"storyblender {__version__}")
        raise typer.Exit
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


def _studio(
    terminal: Terminal,
    script: Path | None = None,
    project: Path | None = None,
    ahead: Worker | None = None,
    **overrides: Any,
) -> Studio:
    """Open the studio. Imported here, because its crew takes a second to load and ``--help`` needs none of it."""
    from storyblender.settings import Settings
    from storyblender.studio import Studio

    return Studio(Settings.load(script, project, **overrides), terminal.show, ahead)


def _folder_of(script: Path) -> Path:
    return script.parent / f"{script.stem}.storyboard"
