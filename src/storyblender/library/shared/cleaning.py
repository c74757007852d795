"""What is no longer of use in the library: damaged entries, files without a row, what killed processes left."""

from __future__ import annotations

import time
from pathlib import Path

from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.recovery import recovered_jobs
from storyblender.library.shared.shared_library import FILES, INCOMING, INDEX, SharedLibrary, read_entry
from storyblender.memory.base import Frozen

_DAY = 24 * 3600.0


class Garbage(Frozen):
    """What was, or would be, cleaned away."""

    damaged: tuple[LibraryEntry, ...] = ()
    """Entries whose files are missing or changed."""
    files: int = 0
    """Files that belong to nothing."""
    bytes: int = 0
    """Of all that goes."""


def collect_garbage(library: SharedLibrary, *, dry_run: bool = False) -> Garbage:
    """Forget damaged entries and delete files that belong to nothing.

    What is younger than a day may be of a process that is at work, and stays.

    Args:
        library: The library.
        dry_run: Only say what would be done.

    Raises:
        InputError: The library cannot be read or written.
    """
    index = library.index()
    if index is None:
        return Garbage()
    entries = library.find()
    damaged = tuple(entry for entry in entries if library.get(entry.digest) is None)
    with index.reading() as db:
        places = {row[0] for row in db.execute("SELECT place FROM geometry")}
        digests = {row[0] for row in db.execute("SELECT digest FROM entries")}
    root = library.files.root
    batches = {place.rpartition("/")[0] for place in places}
    loose = [path for path in (root / FILES).glob("*/*") if path.name.removesuffix(".json") not in digests]
    loose += [path for path in (root / "geometry").glob("*/*") if library.files.name_of(path) not in places]
    loose += [path for path in (root / "geometry").glob("*") if library.files.name_of(path) not in batches]
    loose += (root / INCOMING).glob("*")
    old = [path for path in loose if time.time() - path.lstat().st_mtime > _DAY]
    sizes = [size for path in old for size in _sizes(path)]
    if not dry_run:
        for entry in damaged:
            library.remove(entry)
        for path in old:
            library.files.delete(library.files.name_of(path))
    return Garbage(damaged=damaged, files=len(sizes), bytes=sum(sizes) + sum(entry.bytes for entry in damaged))


def rebuilt_index(library: SharedLibrary) -> tuple[int, int]:
    """Set an index that cannot be read aside and make a new one of the records beside the files.

    Args:
        library: Its index is damaged.

    Returns:
        How many entries and how many jobs it has now. What was noted of uses stays in the file that was set aside.

    Raises:
        InputError: The disk cannot take it.
    """
    files = library.files
    number = next(each for each in range(1, 1000) if not (files.root / f"damaged-{each}-{INDEX}").exists())
    damaged = f"damaged-{number}-{INDEX}"
    library.close_index()
    files.move(INDEX, damaged)
    if (files.root / f"{INDEX}-wal").exists():
        files.move(f"{INDEX}-wal", f"{damaged}-wal")
    files.delete(f"{INDEX}-shm")
    jobs = library.jobs.restore(recovered_jobs(files.root, files.root / damaged))
    count = 0
    for record in sorted((files.root / FILES).glob("*/*.json")):
        entry = read_entry(record.read_text(encoding="utf-8", errors="replace"))
        folder = record.with_suffix("")
        if entry is not None and entry.digest == folder.name and (folder / entry.main).is_file():
            library.add(entry.facts, folder)
            count += 1
    return count, jobs


def _sizes(path: Path) -> list[int]:
    files = [path] if not path.is_dir() else [each for each in path.rglob("*") if not each.is_dir()]
    return [each.lstat().st_size for each in files]
