"""Geometry that was built for one story, for the next one that needs the same: a cache with a bound.

It is found by all that it is built from and by the version of the builders, and checked by digest when it is taken.
"""

from __future__ import annotations

import re
import secrets
import shutil
import time
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from storyblender.catalog.props.prop_names import prop_of
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.shared.builder import body_pack, builder_version
from storyblender.memory.base import content_hash
from storyblender.memory.jobs import ASSETS, AssetJob, asset_suffixes
from storyblender.memory.measure import AssetMeasure, AssetRecord
from storyblender.outputs import digest_of

if TYPE_CHECKING:
    from sqlite3 import Connection

    from storyblender.library.shared.shared_library import SharedLibrary

MOST_BYTES = 2 << 30
"""What is kept; beyond that the geometry that was not taken for longest is deleted."""
FOLDER = "geometry"
_CONTENT = re.compile(r"[0-9a-f]{16}")


class BuiltGeometry:
    """The geometry in a library.

    Args:
        library: Keeps it.
        most: Bytes to keep.
    """

    def __init__(self, library: SharedLibrary, most: int = MOST_BYTES) -> None:
        self._library, self._most = library, most

    def take(self, jobs: Iterable[AssetJob], files: Folder) -> dict[str, AssetMeasure]:
        """Put what is here of the geometry that jobs would build into a project.

        Args:
            jobs: Of things that are not built yet.
            files: The project.

        Returns:
            Digest of the job to the measure of what was put there.

        Raises:
            InputError: The library cannot be read, or the project cannot be written.
        """
        index = self._library.index()
        if index is None:
            return {}
        wanted = {key: job for job in jobs if (key := key_of(job))}
        query = "SELECT place, content FROM geometry WHERE key = ?"
        with index.reading() as db:
            known = {key: row for key in wanted if (row := db.execute(query, (key,)).fetchone()) is not None}
        taken = {
            key: measure
            for key, (place, content) in known.items()
            if (measure := self._put(wanted[key], place, content, files)) is not None
        }
        if taken:
            with index.writing() as db:
                used = [(time.time(), key) for key in taken]
                db.executemany("UPDATE geometry SET used = ? WHERE key = ?", used)
        return {wanted[key].digest: measure for key, measure in taken.items()}

    def give(self, jobs: Iterable[AssetJob], files: Folder) -> None:
        """Keep what a project built, and what was built least lately no longer if it is too much.

        Args:
            jobs: What was built; those without files in the project are left out.
            files: The project.

        Raises:
            InputError: The library cannot be written.
        """
        given = {key: job for job in jobs if _are_there(job, files) and (key := key_of(job))}
        if not given:
            return
        index, batch = self._library.index(make=True), f"{FOLDER}/{secrets.token_hex(8)}"
        assert index is not None, "made where there was none"
        with self._library.files.writing_tree(batch, flush=False) as part:
            for key, job in given.items():
                (part / key).mkdir()
                for name in _names(job):
                    shutil.copyfile(files.path(ASSETS, name), part / key / name)
            rows = [
                (key, f"{batch}/{key}", digest_of(part / key), _size(part / key, job), time.time())
                for key, job in given.items()
            ]
        with index.writing() as db:
            db.executemany("INSERT OR REPLACE INTO geometry VALUES (?, ?, ?, ?, ?)", rows)
            beyond = self._beyond(db)
            db.executemany("DELETE FROM geometry WHERE key = ?", [(key,) for key, _ in beyond])
        for _, place in beyond:
            self._library.files.delete(place)

    def _beyond(self, db: Connection) -> list[tuple[str, str]]:
        """Return key and place of what is more than may be kept, the least lately used."""
        left, beyond = self._most, []
        for key, place, size in db.execute("SELECT key, place, bytes FROM geometry ORDER BY used DESC, key"):
            left -= size
            if left < 0:
                beyond.append((key, place))
        return beyond

    def _put(self, job: AssetJob, place: str, content: str, files: Folder) -> AssetMeasure | None:
        """Copy the files of an asset into a project; return its measure, None where they are damaged."""
        try:
            folder = self._library.files.path(place)
            if digest_of(folder) != content:
                return None
            *names, record_name = _names(job)
            record = AssetRecord.model_validate_json((folder / record_name).read_bytes())
            digests = {suffix: digest_of(folder / f"{job.digest}{suffix}") for suffix in asset_suffixes(job.asset)}
        except (OSError, ValueError, InputError):
            return None
        if record.files != digests:
            return None
        for name in names:
            with files.writing(f"{ASSETS}/{name}") as part:
                shutil.copyfile(folder / name, part)
        measure = record.measure.model_copy(update={"asset_id": job.asset.asset_id})
        files.write(f"{ASSETS}/{record_name}", record.model_copy(update={"measure": measure}).model_dump_json())
        return measure


def key_of(job: AssetJob) -> str:
    """Return all that the geometry of a job depends on, as one hash; empty where that is not known.

    Args:
        job: Builds an asset.
    """
    asset, made = job.asset, job.asset.canonical
    parts: list[str] = [builder_version(), job.digest]
    if asset.asset_type == "character":
        if not (pack := body_pack()):
            return ""
        parts += [pack, asset.reference_character or ""]
    if made is not None and made.source == "file":
        content = str(made.params.get("content", ""))
        if not _CONTENT.fullmatch(content):
            return ""
        parts += [content, prop_of(asset)]
    return content_hash(*parts)


def _names(job: AssetJob) -> Sequence[str]:
    """Return the names of the files of an asset, its record last."""
    return [f"{job.digest}{suffix}" for suffix in (*asset_suffixes(job.asset), ".json")]


def _are_there(job: AssetJob, files: Folder) -> bool:
    return all(files.path(ASSETS, name).is_file() for name in _names(job))


def _size(folder: Path, job: AssetJob) -> int:
    return sum((folder / name).stat().st_size for name in _names(job))
