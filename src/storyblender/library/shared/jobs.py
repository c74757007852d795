"""The ledger of work that is paid for: every step is on disk before the next one, so that nothing is paid twice."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Literal, get_args

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import NOTE_LENGTH
from storyblender.memory.base import Frozen

if TYPE_CHECKING:
    from storyblender.library.shared.index import Index

JOURNAL = "jobs.jsonl"
"""In the library: every step of every job, a line each, written before the index has it. It outlives the index."""
JobState = Literal["begun", "submitted", "finished", "failed"]
FIELDS = ("id", "request", "service", "price", "state", "remote_id", "entry", "reason", "began")
"""Of a job, as the index names them."""
_FIELDS = ", ".join(FIELDS)


Paid = Literal["yes", "no", "perhaps"]
_GIVEN_UP = "given up by a person, to be asked again"


class OutcomeUnknown(InputError):
    """The same work was sent before and its outcome is unknown; it is not sent again unasked."""


class Job(Frozen):
    """Paid work at a service."""

    id: int
    request: str
    """Digest of all that was asked for."""
    service: str
    price: float
    """US dollars."""
    state: JobState
    """``begun`` before it is sent, ``submitted`` once the service has named it."""
    remote_id: str = ""
    """What the service calls it; empty until that is known."""
    entry: str = ""
    """Digest of the entry that came of it."""
    reason: str = ""
    """Why it failed."""
    began: float
    """Seconds since 1970."""


class AccountedJob(Job):
    """A job as lists show it."""

    paid: Paid

    @classmethod
    def of(cls, job: Job) -> AccountedJob:
        """Return a job with whether it was paid.

        What a service took on is paid. What it refused is not; what failed there, or was never answered, may be.
        """
        refused = job.state == "failed" and not job.remote_id and job.reason != _GIVEN_UP
        paid: Paid = "yes" if job.state in ("submitted", "finished") else "no" if refused else "perhaps"
        return cls(**job.model_dump(), paid=paid)


class JobLedger:
    """The jobs of a library.

    Args:
        index: Opens the index: with True it is made if there is none, else None is returned then.
        files: The library's folder; it has the journal.
    """

    def __init__(self, index: Callable[[bool], Index | None], files: Folder) -> None:
        self._index, self._files = index, files

    def begin(self, request: str, service: str, price: float) -> Job:
        """Note that work is about to be sent; one that was submitted before is returned to go on with.

        Args:
            request: Digest of all that is asked for.
            service: Its name.
            price: US dollars.

        Raises:
            OutcomeUnknown: It was sent before, and the run ended before it knew what the service called it.
        """
        index = self._index(True)
        assert index is not None, "made where there was none"
        now = time.time()
        with index.writing() as db:
            query = f"SELECT {_FIELDS} FROM jobs WHERE request = ? AND service = ? AND state IN ('begun', 'submitted')"
            row = db.execute(query, (request, service)).fetchone()
            if row is None:
                values = (request, service, price, "begun", now, now)
                fields = "request, service, price, state, began, changed"
                made = db.execute(f"INSERT INTO jobs ({fields}) VALUES (?, ?, ?, ?, ?, ?)", values).lastrowid
                job = Job(id=made or 0, request=request, service=service, price=price, state="begun", began=now)
                self._write_down(job)
                return job
        job = _job(row)
        if job.state == "begun":
            raise OutcomeUnknown(
                f"{service} was asked for this before, and what became of it is not known",
                mend=f"`storyblender library jobs --ask-again {job.id}` lets it be asked and paid for again",
            )
        return job

    def submitted(self, job: Job, remote_id: str) -> Job:
        """Note what the service calls the work; return the job as it is now.

        Args:
            job: As ``begin`` returned it.
            remote_id: With it the service can be asked how far the work is.
        """
        return self._become(job, "submitted", remote_id=remote_id)

    def finished(self, job: Job, entry: str = "") -> Job:
        """Note that the work is done and kept; return the job as it is now.

        Args:
            job: Submitted, or begun where the service answers at once.
            entry: Digest of what came of it in the library.
        """
        return self._become(job, "finished", entry=entry)

    def failed(self, job: Job, reason: str) -> Job:
        """Note that the service will not do the work, so that it may be asked again; return the job as it is now.

        Args:
            job: In any state.
            reason: For people.
        """
        return self._become(job, "failed", reason=" ".join(reason.split())[:NOTE_LENGTH])

    def unfinished(self) -> list[Job]:
        """Return the jobs that are begun or submitted, the oldest first."""
        return [job for job in self.all() if job.state in ("begun", "submitted")]

    def all(self) -> list[Job]:
        """Return every job, the oldest first."""
        index = self._index(False)
        if index is None:
            return []
        with index.reading() as db:
            rows = db.execute(f"SELECT {_FIELDS} FROM jobs ORDER BY id").fetchall()
        return [_job(row) for row in rows if row[4] in get_args(JobState)]

    def ask_again(self, number: int) -> Job:
        """Give up an unfinished job, so that the same work may be sent, and paid for, again.

        Args:
            number: Of the job.

        Raises:
            InputError: No unfinished job has that number.
        """
        job = next((each for each in self.unfinished() if each.id == number), None)
        if job is None:
            raise InputError(f"there is no unfinished job {number}", mend="see `storyblender library jobs`")
        return self.failed(job, _GIVEN_UP)

    def restore(self, jobs: Iterable[Job]) -> int:
        """Put jobs into an index that was made anew, with their numbers; return how many.

        Args:
            jobs: As they were recovered; the numbers must be free.
        """
        index = self._index(True)
        assert index is not None, "made where there was none"
        rows = [(*(getattr(job, name) for name in FIELDS), job.began) for job in jobs]
        with index.writing() as db:
            marks = ", ".join("?" * (len(FIELDS) + 1))
            db.executemany(f"INSERT INTO jobs ({_FIELDS}, changed) VALUES ({marks})", rows)
        return len(rows)

    def _write_down(self, job: Job) -> None:
        """Add a job to the journal as it is now; on disk when this returns."""
        self._files.append(JOURNAL, f"\n{job.model_dump_json()}\n")  # after a line that a killed process left torn
        with self._files.log(JOURNAL) as file:
            os.fsync(file.fileno())

    def _become(self, job: Job, state: JobState, **values: str) -> Job:
        """Put a job into a state, on disk when this returns."""
        index = self._index(True)
        assert index is not None, "made where there was none"
        changed = job.model_copy(update={"state": state, **values})
        with index.writing() as db:
            told: dict[str, Any] = {"state": state, "changed": time.time(), **values}
            fields = ", ".join(f"{name} = ?" for name in told)
            db.execute(f"UPDATE jobs SET {fields} WHERE id = ?", (*told.values(), job.id))
            self._write_down(changed)
        return changed


def _job(row: tuple[Any, ...]) -> Job:
    return Job.model_validate(dict(zip(FIELDS, row, strict=True)))
