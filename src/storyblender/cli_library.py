"""``storyblender library``: what stories brought in is listed, added to, cleaned, carried elsewhere, and counted."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from storyblender.cli_options import Json, examples, open_studio
from storyblender.errors import InputError
from storyblender.shell import shown

if TYPE_CHECKING:
    from storyblender.library.shared.entries import LibraryEntry
    from storyblender.library.shared.shared_library import SharedLibrary

Named = Annotated[
    str,
    typer.Argument(
        metavar="ENTRY", help="Its name, its path as credits.md has it, or the first column of `library list`."
    ),
]
Words = Annotated[str, typer.Argument(metavar="[WORDS]", help="All of them are in name, tags, author or licence.")]
Kind = Annotated[str | None, typer.Option(help="model, texture, panorama, motion, image or character.")]
Source = Annotated[str, typer.Option(help="Where it came from: poly_haven, meshy ..., files for what you added.")]
_COLUMNS: dict[str, Callable[[Any], str]] = {
    "entry": lambda entry: entry.digest[:8],
    "kind": lambda entry: entry.kind,
    "name": lambda entry: entry.name,
    "from": lambda entry: entry.source,
    "author": lambda entry: entry.credit.author,
    "licence": lambda entry: entry.credit.license or "not stated",
    "MB": lambda entry: f"{entry.bytes / 1e6:.1f}",
}
_JOB_COLUMNS: dict[str, Callable[[Any], str]] = {
    "job": lambda job: str(job.id),
    "service": lambda job: job.service,
    "state": lambda job: "sent, not known" if job.state == "begun" else job.state,
    "$ paid": lambda job: {"yes": f"{job.price:.2f}", "no": "nothing", "perhaps": f"{job.price:.2f} perhaps"}[job.paid],
    "its name there": lambda job: job.remote_id,
    "why it failed": lambda job: job.reason,
}
app = typer.Typer(
    no_args_is_help=True,
    rich_markup_mode="rich",
    help="Your library: what stories brought in or you added, shared by all your projects.",
)


@app.command(name="list", epilog=examples("library list", "library list armchair", "library list --kind panorama"))
def list_entries(words: Words = "", kind: Kind = None, source: Source = "", json_lines: Json = False) -> None:
    """List what is in the library, the newest first.

    It lies in the folder that `STORYBLENDER_LIBRARY` names, else in `~/.local/share/storyblender/library`.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        found, root = _found(words, kind, source), _library().files.root
        none = f"nothing in the library in {root} is like that" if words or kind or source else ""
        terminal.listed("entries", found, _COLUMNS, none or f"the library is empty; it is in {root}")


@app.command(epilog=examples("library show 'Arm Chair 01'", "library show 3f9a11c0 --picture chair.png"))
def show(
    entry: Named,
    picture: Annotated[Path | None, typer.Option(help="Also write a picture of it, a PNG, here.")] = None,
    json_lines: Json = False,
) -> None:
    """Show all that is known of an entry: licence, author, origin, file, and which stories it is used in."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        library = _library()
        found = _entry(library, entry)
        drawn: dict[str, str] = {}
        if picture is not None:
            from storyblender.folder import Folder

            png = open_studio(terminal).draw_entry(library, found).read_bytes()
            Folder(picture.parent).write(picture.name, png)
            drawn = {"picture": str(picture)}
        terminal.facts("entry", _facts(library, found) | drawn)


@app.command(
    epilog=examples("library add chairs/", "library add throne.glb --author 'Ann Example' --license CC-BY-4.0")
)
def add(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH...", help="Models, panoramas, or folders of them.")],
    also: Annotated[list[str] | None, typer.Option(help="What else it is called; may be given again.")] = None,
    author: Annotated[str, typer.Option(help="Whose work it is.")] = "",
    license: Annotated[str, typer.Option(help="CC0-1.0, CC-BY-4.0 ...")] = "",
    url: Annotated[str, typer.Option(help="Its address.")] = "",
    picture: Annotated[bool, typer.Option("--picture/--no-picture", help="Draw a picture of each model.")] = True,
    json_lines: Json = False,
) -> None:
    """Add models and panoramas with the files that they name; a story finds them by the words of their file's name.

    Whose work they are is read from the options, then from `chair.credits.toml` or `credits.toml` beside them. Without
    a licence they count as your own. Of USD files only .usdz is taken: others may have parts elsewhere. Each file is
    read first: if one cannot be, it is named and nothing is added.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.library.embedder import load_embedder
        from storyblender.library.shared.adding import add_work, checked_work, works_in
        from storyblender.library.shared.search import LibrarySearch
        from storyblender.memory.asset_sheet import Credit
        from storyblender.model_content import credit_lines

        library = _library()
        credit = Credit.model_validate(credit_lines({"author": author, "license": license, "url": url}))
        found = [(file, path if path.is_dir() else path.parent) for path in paths for file in works_in(path)]
        works = [checked_work(file, top, credit) for file, top in found]
        studio = open_studio(terminal)
        studio.check_readable(works)
        added = [add_work(library, work, tuple(also or ())) for work in works]
        LibrarySearch(library, load_embedder).know()
        if picture:
            studio.draw_entries(library, added)
        terminal.listed("entries", added, _COLUMNS)


@app.command(epilog=examples("library remove 'Arm Chair 01'"))
def remove(entries: Annotated[list[str], typer.Argument(metavar="ENTRY...")], json_lines: Json = False) -> None:
    """Remove entries with their files. Finished projects keep theirs; the figures keep what was used."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        library = _library()
        found = [_entry(library, entry) for entry in entries]
        for entry in found:
            library.remove(entry)
        terminal.listed("removed", found, _COLUMNS)


@app.command(epilog=examples("library figures"))
def figures(json_lines: Json = False) -> None:
    """Tell how much was used again over all stories, as the paper counts it.

    A request is one thing of one story. It is avoided if nothing was built, downloaded or made for it: the library had
    it, or another thing of the story is the same.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        told = _library().uses.figures()
        rows = {
            "stories": str(told.stories),
            "raw model requests": str(told.requests),
            "globally unique models": str(told.unique),
            "builds or downloads avoided": str(told.avoided),
            "of these in one story": str(told.avoided_in_story),
            "of these downloads": str(told.downloads_avoided),
            "reduction": f"{told.reduction:.2f} %",
            "references per model": f"{told.references:.3f}",
        }
        terminal.facts("figures", rows | {name: f"{count} models" for name, count in told.categories.items()})


@app.command(epilog=examples("library jobs", "library jobs --ask-again 12"))
def jobs(
    ask_again: Annotated[
        int | None, typer.Option(metavar="JOB", help="Give it up, so that it is asked for, and paid for, again.")
    ] = None,
    json_lines: Json = False,
) -> None:
    """List work that services were asked for: how far it is, and what was paid.

    A job that was sent when its run was ended, so that nobody knows what became of it, is never sent again unasked.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.library.shared.jobs import AccountedJob

        ledger = _library().jobs
        if ask_again is not None:
            ledger.ask_again(ask_again)
        terminal.listed(
            "jobs",
            [AccountedJob.of(job) for job in ledger.all()],
            _JOB_COLUMNS,
            "no service was asked to make anything",
        )


@app.command(epilog=examples("library clean --dry-run", "library clean"))
def clean(
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Only say what would go.")] = False,
    json_lines: Json = False,
) -> None:
    """Forget entries whose files are damaged, delete files that belong to nothing, make a damaged index anew."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.library.shared.cleaning import collect_garbage, rebuilt_index
        from storyblender.library.shared.index import DamagedIndex

        library, rows = _library(), {}
        try:
            if (index := library.index()) is not None:
                index.check()
        except DamagedIndex:
            if dry_run:
                raise
            entries, jobs = rebuilt_index(library)
            rows |= {"entries of the new index": str(entries), "jobs of the new index": str(jobs)}
        found = collect_garbage(library, dry_run=dry_run)
        rows |= {"damaged entries": str(len(found.damaged)), "files of nothing": str(found.files)}
        rows |= {f"damaged {entry.digest[:8]}": entry.name for entry in found.damaged}
        terminal.facts("clean", rows | {"MB that would go" if dry_run else "MB freed": f"{found.bytes / 1e6:.1f}"})


@app.command(epilog=examples("library pack mine.zip", "library pack chairs.zip chair"))
def pack(
    out: Annotated[Path, typer.Argument(metavar="OUT.zip")],
    words: Words = "",
    kind: Kind = None,
    source: Source = "",
    json_lines: Json = False,
) -> None:
    """Write entries with their files, licences and origins into one .zip, for another library."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.library.shared.packs import pack as write_pack

        count = write_pack(_library(), _found(words, kind, source), out)
        terminal.facts("packed", {"file": str(out), "entries": str(count)})


@app.command(epilog=examples("library unpack mine.zip"))
def unpack(archive: Annotated[Path, typer.Argument(metavar="FILE.zip")], json_lines: Json = False) -> None:
    """Add what a pack holds; a pack that is damaged or would write elsewhere is refused whole."""
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.library.shared.packs import unpack as read_pack

        terminal.listed("entries", read_pack(_library(), archive), _COLUMNS)


def _library() -> SharedLibrary:
    from storyblender.library.shared.shared_library import SharedLibrary

    return SharedLibrary.open()


def _found(words: str, kind: str | None, source: str) -> list[LibraryEntry]:
    from typing import get_args

    from storyblender.library.shared.entries import ADDED, EntryKind
    from storyblender.service_setting import ServiceName

    known = next((each for each in get_args(EntryKind) if each == kind), None)
    if kind is not None and known is None:
        raise InputError(f"there is no kind {kind!r}", mend=f"it is one of {', '.join(get_args(EntryKind))}")
    library = _library()
    sources = {ADDED, *get_args(ServiceName)}
    if source and source not in sources and not library.find(source=source):
        raise InputError(f"nothing comes from {source!r}", mend=f"it is one of {', '.join(sorted(sources))}")
    return library.find(words, known, source)


def _facts(library: SharedLibrary, entry: LibraryEntry) -> dict[str, str]:
    """Return what is known of an entry, for people: whose work it is and where it is used are told in any case."""
    from storyblender.library.shared.entries import ADDED

    stories: dict[str, list[str]] = {}
    for story, thing in library.uses.of_entry(entry.digest):
        stories.setdefault(Path(story).name, []).append(thing)
    used = "; ".join(f"{story} ({', '.join(things)})" for story, things in stories.items())
    whole = library.get(entry.digest) is not None
    facts = {
        "entry": entry.digest,
        "name": entry.name,
        "kind": entry.kind,
        "also called": ", ".join(entry.words),
        "category": entry.category,
        "author": entry.credit.author or "not stated",
        "licence": entry.credit.license or "not stated",
        "copyright": entry.credit.copyright,
        "origin": "added by you" if entry.source == ADDED else entry.source or "not stated",
        "its name there": entry.source_id,
        "address": entry.credit.url or "not stated",
        "used in stories": used or "none",
        "faces": "" if entry.faces is None else str(entry.faces),
        "MB": f"{entry.bytes / 1e6:.1f}",
        "file": str(library.path_of(entry)),
        "files": "as they were added"
        if whole
        else "damaged: missing or changed; `storyblender library clean` forgets it",
    }
    return {name: text for name, text in facts.items() if text}


def _entry(library: SharedLibrary, told: str) -> LibraryEntry:
    """Return the entry that a person means. Raises InputError."""
    found = library.all_told(told)
    if not found:
        raise InputError(f"the library has no entry {told!r}", mend="see `storyblender library list`")
    if len(found) > 1:
        mend = f"name one of them: {', '.join(entry.digest[:8] for entry in found)}"
        raise InputError(f"the library has {len(found)} entries {told!r}", mend=mend)
    return found[0]
