"""Jobs that were paid for, recovered when the index of the library is damaged."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from storyblender.library.shared.jobs import FIELDS, JOURNAL, Job


def recovered_jobs(root: Path, damaged: Path) -> list[Job]:
    """Return the jobs of a library as its journal has them, else as far as its damaged index can be read.

    Args:
        root: The library.
        damaged: The index that was set aside.
    """
    jobs = {job.id: job for job in _in_index(damaged)}
    jobs |= {job.id: job for job in _in_journal(root / JOURNAL)}
    return [jobs[number] for number in sorted(jobs)]


def _in_journal(path: Path) -> Iterator[Job]:
    """Yield jobs step by step, the newest step last; lines that a killed process left unfinished are passed over."""
    if not path.is_file():
        return
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        with suppress(ValidationError):
            yield Job.model_validate_json(line)


def _in_index(path: Path) -> Iterator[Job]:
    """Yield the jobs on the pages that can be read: from the first and from the last one up to the damage."""
    for order in ("ASC", "DESC"):
        for row in _rows(path, order):
            with suppress(ValidationError):
                yield Job.model_validate(dict(zip(FIELDS, row, strict=True)))


def _rows(path: Path, order: str) -> Iterator[tuple[Any, ...]]:
    with suppress(sqlite3.DatabaseError), closing(sqlite3.connect(path)) as db:
        db.text_factory = lambda data: data.decode("utf-8", "replace")
        yield from db.execute(f"SELECT {', '.join(FIELDS)} FROM jobs ORDER BY id {order}")
