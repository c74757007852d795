"""The command line. No logic: words in, Studio, words out. Exit 0 done, 1 something was found, 2 bad input."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any

import typer

from storyblender import (
    __version__,
    cli_asset,
    cli_blender_extension,
    cli_cast,
    cli_crew,
    cli_deliver,
    cli_edits,
    cli_format,
    cli_lamp,
    cli_library,
    cli_mcp,
    cli_paint,
    cli_pose,
    cli_propose,
    cli_pull,
    cli_revise,
    cli_scene,
    cli_shots,
    cli_studio,
    cli_why,
)
from storyblender.cli_options import Aspect, Folder, Jobs, Json, LookOption, Quiet, Services, examples, open_studio
from storyblender.shell import Commands, shown

app = typer.Typer(
    cls=Commands,
    rich_markup_mode="rich",
    add_completion=False,
    help="From a script to an editable 3D storyboard.\n\n"
    "Start with [bold]storyblender make SCRIPT[/bold], where SCRIPT is a Fountain (.fountain) or Final Draft (.fdx) "
    "screenplay, or prose (.txt, .md). It writes a folder SCRIPT.storyboard beside it; open its "
    "[bold]index.html[/bold] first. In it are the frames, the board to print (board.pdf), a film with subtitles "
    "(animatic.mp4), the shot list "
    "(shots.csv), a timeline for editors (timeline.otio) and the scenes for Blender (story.blend).\n\n"
    "Then look at it with [bold]check[/bold], change a camera or a length with [bold]edit[/bold], keep what is good "
    "with [bold]lock[/bold], take a change back with [bold]undo[/bold], or change the script and run "
    "[bold]make[/bold] again: only what changed is drawn.",
    epilog="storyblender COMMAND --help explains a command, with examples. A file storyblender.toml beside the script "
    "holds settings for it; docs/settings.md lists them all.",
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
Out = Annotated[
    Path | None, typer.Option("--out", "-o", help="The project folder; NAME.storyboard beside the script if not given.")
]
Seed = Annotated[
    int | None,
    typer.Option(
        help="Another number, other faces and sets; the same one, the same storyboard to the pixel (default 0)."
    ),
]
Shots = Annotated[
    int | None, typer.Option("--shots-per-scene", help="About how many shots a scene may have (default 4).")
]
Width = Annotated[int | None, typer.Option(help="Pixels across (default 960).")]
Fps = Annotated[int | None, typer.Option(help="Frames a second (default 24).")]
Crew = Annotated[
    str | None,
    typer.Option(
        help="Who plays the roles of the crew: rules (the default, no key), a model (google:MODEL, openai:MODEL, "
        "anthropic:MODEL, ollama:MODEL), ask:FOLDER (you, or any chat model), replay:FOLDER; or by role: "
        "rules,director=ollama:MODEL."
    ),
]
Paper = Annotated[
    str | None, typer.Option(help="Size of the board's pages: a4 (the default), letter, a3, legal or tabloid.")
]
Reading = Annotated[
    Path | None, typer.Option(help="A reading of the script that you corrected, from `plan --write-reading FILE`.")
]
Models = Annotated[
    list[Path] | None,
    typer.Option(
        help="A folder of your own 3D models (.glb, .gltf, .blend, .obj, .fbx, .stl, .ply, .usd, .usdz), searched "
        "before the built-in library; may be given again."
    ),
]

Hdri = Annotated[
    Path | None, typer.Option(help="A panorama of high dynamic range (.hdr, .exr) that lights exteriors by day.")
]

Motions = Annotated[
    list[Path] | None, typer.Option(help="A folder of your own motion clips (.bvh, .fbx); may be given again.")
]


@app.command(
    epilog=examples(
        "make my_film.fountain",
        "make my_film.fdx --look pencil --aspect 2.39",
        "make my_film.fountain --look fast --no-animatic",
        "make my_film.fountain --services poly_haven",
    )
)
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
    hdri: Hdri = None,
    motions: Motions = None,
    services: Services = None,
    animatic: Annotated[
        bool | None, typer.Option(help="Make the animatic too, a film of the moving board (on by default).")
    ] = None,
    reading: Reading = None,
    slate: Annotated[
        bool | None, typer.Option(help="Burn shot name, lens and timecode into copies of the frames, as on a slate.")
    ] = None,
    paper: Paper = None,
    jobs: Jobs = None,
    seed: Seed = None,
    dry_run: Annotated[
        bool,
        typer.Option(
            "--dry-run",
            help="Only say what each thing would be made from: what --services would fetch, under which licence and of "
            "which size, and what would be made for how many dollars. Catalogues are searched, nothing else is done.",
        ),
    ] = False,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Turn a script into a storyboard: everything. Run it again to go on where it was stopped, or after a revision."""
    settings: dict[str, Any] = dict(
        look=look, crew=crew, aspect=aspect, width=width, fps=fps, jobs=jobs, seed=seed,
        shots_per_scene=shots_per_scene, models=models or None, hdri=hdri, animatic=animatic,
        motions=motions or None, services=services, slate=slate, paper=paper,
    )  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        project = out or _folder_of(script)
        studio = open_studio(terminal, script, project, **settings)
        if dry_run:
            terminal.expected(studio.estimate(script, reading))
            return
        delivery = studio.make(script, project, reading)
        terminal.files(delivery.folder, delivery.files)


@app.command(
    epilog=examples("plan my_film.fountain", "plan my_film.fountain --shots-per-scene 8", "plan my_film.fountain --why")
)
def plan(
    script: Script,
    out: Out = None,
    crew: Crew = None,
    shots_per_scene: Shots = None,
    aspect: Aspect = None,
    fps: Fps = None,
    seed: Seed = None,
    reading: Reading = None,
    write_reading: Annotated[
        Path | None, typer.Option(help="Write what was understood as a JSON file that you can correct.")
    ] = None,
    why: Annotated[
        bool, typer.Option("--why", help="Say of each person, thing and deed which rule read it, on which words.")
    ] = False,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Read a script and list its cast, scenes and shots; quick, nothing is drawn.

    What was read is kept in the project folder, where `make` goes on from it.
    """
    settings: dict[str, Any] = dict(crew=crew, shots_per_scene=shots_per_scene, aspect=aspect, fps=fps, seed=seed)
    with shown(quiet, json_lines) as terminal:
        project = out or _folder_of(script)
        studio = open_studio(terminal, script, project, **settings)
        delivery = studio.plan(script, project, reading, write_reading, why=why)
        terminal.plan(delivery.graph)
        if why:
            terminal.why(delivery.reasons)
        terminal.files(delivery.folder, delivery.files)


@app.command(
    epilog=examples(
        "render my_film.storyboard --shot SC010_SH020",
        "render my_film.storyboard --animatic",
        "render my_film.storyboard --look pencil",
    )
)
def render(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[list[str] | None, typer.Option(help="Only this shot, e.g. SC010_SH020; may be repeated.")] = None,
    look: LookOption = None,
    animatic: Annotated[bool, typer.Option(help="Render the moving film again where it changed.")] = False,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Render a project again: only what changed, or the shots named. A camera is changed with `edit`."""
    settings: dict[str, Any] = dict(look=look, jobs=jobs, animatic=animatic)
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal, project=folder, ahead=context.obj, **settings)
        delivery = studio.render(folder, shot or [])
        terminal.files(delivery.folder, delivery.files, delivery.followed)


cli_edits.add_to(app)
cli_pose.add_to(app)
cli_propose.add_to(app)
cli_lamp.add_to(app)
cli_scene.add_to(app)
cli_cast.add_to(app)
cli_paint.add_to(app)
cli_format.add_to(app)
cli_asset.add_to(app)
app.add_typer(cli_shots.app, name="shot")
app.add_typer(cli_library.app, name="library")
cli_crew.add_to(app)
cli_deliver.add_to(app)
cli_mcp.add_to(app)
cli_studio.add_to(app)
cli_pull.add_to(app)
cli_blender_extension.add_to(app)
cli_revise.add_to(app)
cli_why.add_to(app)


@app.command(epilog=examples("check my_film.storyboard"))
def check(context: typer.Context, folder: Folder, json_lines: Json = False) -> None:
    """Check a project: layout, framing, continuity, collisions, people in frame, story.

    Below the table each thing to look at is a sentence. Exits 1 if there is any. Frames are scored as `evaluate` does.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        studio = open_studio(terminal, project=folder, ahead=context.obj)
        report = studio.check(folder)
        terminal.check(report)
    raise typer.Exit(0 if report.clean else 1)


@app.command(epilog=examples("evaluate my_film.storyboard", "evaluate *.storyboard --json"))
def evaluate(
    folders: Annotated[
        list[Path], typer.Argument(metavar="FOLDER...", help="Project folders, NAME.storyboard.", show_default=False)
    ],
    json_lines: Json = False,
) -> None:
    """Say of every frame how well it tells its lines, 1 to 10, and what is wrong with it.

    From 8 on a frame passes, under 5 it is rejected. This only reports and exits 0; `check` exits 1 if a frame fails.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        for folder in folders:
            terminal.reviews(folder, open_studio(terminal, project=folder).evaluate(folder))


@app.command(epilog=examples("export my_film.storyboard --to glb", "export my_film.storyboard --to edl --to fcpxml"))
def export(
    context: typer.Context,
    folder: Folder,
    to: Annotated[
        list[ExportName],
        typer.Option("--to", help="glb or usd: a file a scene; edl or fcpxml: the timeline. May be repeated."),
    ],
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Write scenes for other 3D programs (glTF, USD) or the timeline for other editors (EDL, FCPXML)."""
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal, project=folder, ahead=context.obj)
        delivery = studio.export(folder, [str(name.value) for name in to])
        terminal.files(delivery.folder, delivery.files)


@app.command(name="doctor", epilog=examples("doctor", "doctor --crew rules,director=ollama:qwen3:14b"))
def examine(
    crew: Annotated[
        str | None, typer.Option(help="Ask every model of this crew for something small instead; see `make --crew`.")
    ] = None,
    json_lines: Json = False,
) -> None:
    """Say whether this machine can run StoryBlender, and the line that mends it if not. Exits 1 if not."""
    from storyblender import doctor

    with shown(quiet=False, json_lines=json_lines) as terminal:
        findings = doctor.examine() if crew is None else doctor.examine_crew(crew)
        terminal.findings(findings)
    raise typer.Exit(0 if all(finding.healthy for finding in findings) else 1)


@app.command(epilog=examples("catalog props", "catalog sets --picture cafe --out cafe.png"))
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
        studio = open_studio(terminal)
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


def _folder_of(script: Path) -> Path:
    return script.parent / f"{script.stem}.storyboard"
