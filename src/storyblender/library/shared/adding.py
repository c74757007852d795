"""A person adds models and panoramas of theirs to the library: each with the files that it names and its credit."""

from __future__ import annotations

import json
import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory
from typing import Final, NamedTuple
from urllib.parse import unquote

from storyblender.errors import InputError
from storyblender.library.model_folders import MODEL_SUFFIXES
from storyblender.library.shared.entries import ADDED, EntryFacts, EntryKind, LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit
from storyblender.model_content import CREDITS, MOST_BYTES, credit_files, credit_lines

_IN_PARTS: Final = (".usd", ".usda", ".usdc")
"""Models that may take parts from any other file; a .usdz has its parts in it."""
KINDS: Final[dict[str, EntryKind]] = {
    **{suffix: "model" for suffix in MODEL_SUFFIXES if suffix not in _IN_PARTS},
    ".hdr": "panorama",
    ".exr": "panorama",
}
_MOST_NAMED: Final = 500


def works_in(path: Path) -> list[Path]:
    """Return a file to add, or those in a folder and below it.

    Raises:
        InputError: There is no such file, or none that can be added.
    """
    found = [path] if path.is_file() else sorted(each for each in path.rglob("*") if each.is_file())
    works = [each for each in found if each.suffix.lower() in KINDS]
    if not works:
        mend = f"name a file or a folder of {', '.join(KINDS)}"
        if path.is_file() and path.suffix.lower() in _IN_PARTS:
            mend = f"a {path.suffix.lower()} may take parts from other files: export it as one .usdz"
        raise InputError("has nothing that can be added" if path.exists() else "does not exist", mend=mend, path=path)
    return works


class Work(NamedTuple):
    """A file that can be added."""

    path: Path
    top: Path
    """The folder that was named: what the file names lies in it, and credits files apply from there on."""
    credit: Credit
    names: tuple[str, ...]
    """The files that it names, relative to its own folder."""


def checked_work(path: Path, top: Path, told: Credit) -> Work:
    """Return a file with what belongs to it; nothing is added yet.

    Args:
        path: The file.
        top: The folder that was named.
        told: Whose work it is, over what files beside it say.

    Raises:
        InputError: It is too large, names something that is not there, or has credits that cannot be read.
    """
    if path.stat().st_size > MOST_BYTES:
        raise InputError(f"is larger than {MOST_BYTES >> 20} MiB", path=path)
    names = tuple(named_by(path))
    for each in names:
        source = path.parent / each
        if not source.is_file() or not source.resolve().is_relative_to(top.resolve()):
            raise InputError(f"names {each!r}, which is not in its folder", mend="put it there", path=path)
    return Work(path, top, _credit(path, top, told), names)


def add_work(library: SharedLibrary, work: Work, words: tuple[str, ...] = ()) -> LibraryEntry:
    """Add a file with what it names; return its entry.

    Args:
        library: Where to.
        work: The file, as it was checked.
        words: What else it is called.

    Raises:
        InputError: It cannot be kept.
    """
    path = work.path
    with TemporaryDirectory() as name:
        part = Path(name)
        for each in (path.name, *work.names):
            (part / each).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path.parent / each, part / each)
        if lines := [f"{field} = {json.dumps(text, ensure_ascii=False)}\n" for field, text in work.credit if text]:
            (part / CREDITS).write_text("".join(lines), encoding="utf-8")
        facts = EntryFacts(
            kind=KINDS[path.suffix.lower()],
            name=path.stem[:200],
            words=words,
            main=path.name,
            credit=work.credit,
            source=ADDED,
        )
        return library.add(facts, part)


def _credit(path: Path, top: Path, told: Credit) -> Credit:
    """Return whose work a file is: as it is told, then as the nearest credits file says."""
    lines = {name: text for name, text in told if text}
    for file in credit_files(path, top):
        try:
            lines = {**credit_lines(tomllib.loads(file.read_text(encoding="utf-8-sig"))), **lines}
        except (OSError, ValueError) as error:
            mend = 'write lines such as: author = "Ann"'
            raise InputError("is not a credits file", mend=mend, path=file) from error
    return Credit.model_validate(credit_lines(lines))


def named_by(path: Path) -> list[str]:
    """Return the files that a model names, relative to its folder, in order."""
    try:
        match path.suffix.lower():
            case ".gltf":
                names = list(_named_by_gltf(json.loads(path.read_text(encoding="utf-8"))))
            case ".obj":
                names = list(_named_by_obj(path))
            case _:
                return []
    except (OSError, ValueError) as error:
        raise InputError("cannot be read", path=path) from error
    inside = [name for name in names if not {"..", "/"} & {*PurePosixPath(name).parts} and "\\" not in name]
    return list(dict.fromkeys(inside))[:_MOST_NAMED]


def _named_by_gltf(content: object) -> Iterator[str]:
    lists = [content.get(part) for part in ("buffers", "images")] if isinstance(content, dict) else []
    for each in (each for values in lists if isinstance(values, list) for each in values):
        uri = each.get("uri") if isinstance(each, dict) else None
        if isinstance(uri, str) and ":" not in uri:
            yield unquote(uri)


def _named_by_obj(path: Path) -> Iterator[str]:
    """Yield material libraries, and the pictures that are there of those that these name."""
    for name in _last_words(path, ("mtllib",)):
        if (path.parent / name).is_file():
            yield name
            pictures = _last_words(path.parent / name, ("map_", "bump", "norm", "disp"))
            yield from (each for each in pictures if (path.parent / each).is_file())


def _last_words(path: Path, beginnings: tuple[str, ...]) -> Iterator[str]:
    with path.open(encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if line.lower().startswith(beginnings) and len(words := line.split()) > 1:
                yield words[-1] if words[0].lower() != "mtllib" else line.split(maxsplit=1)[1].strip()
