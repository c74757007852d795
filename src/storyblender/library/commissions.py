"""Work that services are paid for: asked for once, noted at every step, kept in the user's library.

A request is known by what is asked, of which service and model. What was made for it before is taken from the library;
a job that was begun before goes on, also one that another process began: while that sends it, this one waits. A job
that may or may not have begun is looked for at the service, and never begun again by itself.
"""

from __future__ import annotations

import json
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Literal

from filelock import FileLock, Timeout

from storyblender.errors import Cancelled, InputError, ServiceFailure
from storyblender.library.shared.entries import EntryFacts, EntryKind, LibraryEntry
from storyblender.library.shared.jobs import Job
from storyblender.library.shared.shared_library import INCOMING, SharedLibrary
from storyblender.memory.asset_sheet import Credit
from storyblender.memory.base import content_hash
from storyblender.model_content import CREDITS, credit_lines
from storyblender.services.budget import ServiceBudget
from storyblender.services.making import ImageModel, JobService, JobState, Maker, ModelMaker, Unusable

LONGEST: Final = 24 * 3600.0
"""Seconds from the beginning of a job to when a service has forgotten it."""
_DRAWN_AT_ONCE: Final = 4
_PAUSE: Final = 0.5
"""Seconds between two looks whether another process has sent what is wanted here too."""
_PROMPT: Final = "prompt.txt"
_ASK_AGAIN: Final = (
    "it may be paid for, so it is not asked again; `storyblender library jobs` lists it, `--ask-again` gives it up"
)


@dataclass(frozen=True)
class Wanted:
    """What is to be made.

    Attributes:
        name: What the story calls it.
        prompt: What it looks like, as it is sent to an image model.
        category: For lists.
        kind: Of the model: one of a ``character`` stands in for no thing of that name.
        made_of: Whose work the model is that it is made of, if it is not made of a picture.
    """

    name: str
    prompt: str
    category: str = ""
    kind: Literal["model", "character"] = "model"
    made_of: Credit = field(default_factory=Credit)


class Commissions:
    """Asks services to make things, for a library.

    Args:
        library: Keeps what was made, and the ledger.
        budget: Of the run.
        cancelled: Ends waiting for another process.
    """

    def __init__(self, library: SharedLibrary, budget: ServiceBudget, cancelled: threading.Event | None = None) -> None:
        self._library, self._budget = library, budget
        self._cancelled = cancelled or threading.Event()

    def pictures(self, model: ImageModel, wanted: Sequence[Wanted]) -> Mapping[str, LibraryEntry | ServiceFailure]:
        """Draw pictures, several at the same time; what is paid for is kept, whatever becomes of the others.

        Args:
            model: Draws them.
            wanted: What is in them.

        Returns:
            By prompt: the picture, or why there is none.
        """
        made: dict[str, LibraryEntry | ServiceFailure] = {}
        drawing: dict[Future[bytes], tuple[Job, Wanted, ExitStack]] = {}
        by_prompt = {each.prompt: each for each in wanted}
        with ThreadPoolExecutor(_DRAWN_AT_ONCE) as pool, ExitStack() as all_held:
            for prompt in sorted(by_prompt):  # all processes in the same order, so that no two wait for each other
                held = all_held.enter_context(ExitStack())
                try:
                    held.enter_context(self._alone("picture", model.maker, prompt))
                    found = self._begun("picture", model.maker, prompt)
                except Cancelled:
                    made[prompt] = ServiceFailure("cancelled before it was sent")
                    continue
                except ServiceFailure as error:
                    made[prompt] = error
                    held.close()
                    continue
                if isinstance(found, Job):
                    drawing[pool.submit(model.draw, prompt)] = found, by_prompt[prompt], held
                else:
                    made[prompt] = found
                    held.close()
            for future in as_completed(drawing):
                job, each, held = drawing[future]
                with held:
                    made[each.prompt] = self._drawn(future, model.maker, job, each)
        return made

    def model(self, maker: ModelMaker, picture: LibraryEntry) -> LibraryEntry | Job:
        """Begin a model of a picture, or return what was made or begun of it before.

        Args:
            maker: Makes it.
            picture: In the library; of what rigs a model, that model.

        Raises:
            Busy: Other jobs have to end first.
            Cancelled: Before anything was sent.
            ServiceFailure: The service will not, or it is unknown whether it was asked before.
        """
        with self._alone("model", maker.maker, picture.digest):
            return self._model(maker, picture)

    def _model(self, maker: ModelMaker, picture: LibraryEntry) -> LibraryEntry | Job:
        """As ``model``, while no other process sends the same."""
        try:
            found = self._begun("model", maker.maker, picture.digest)
        except ServiceFailure as error:
            if not error.uncertain:
                raise
            return self._found_again(maker, picture, error)
        if not isinstance(found, Job) or found.state != "begun":
            return found
        try:
            data = self._library.path_of(picture).read_bytes()
            return self._library.jobs.submitted(found, maker.begin(data, _mark(found)))
        except Cancelled:
            self._refused(found, maker.maker, ServiceFailure("cancelled before it was sent"))
            raise
        except (ServiceFailure, OSError) as error:
            unread = ServiceFailure(f"the {picture.kind} cannot be read")
            failure = error if isinstance(error, ServiceFailure) else unread
            job = self._looked_for(maker, found) if failure.uncertain else None
            if job is not None and job.state == "submitted":
                return job
            certain = ServiceFailure(failure.problem, mend=failure.mend)
            raise self._refused(found, maker.maker, failure if job is None else certain) from error

    def look(self, maker: JobService, job: Job, wanted: Wanted) -> LibraryEntry | JobState:
        """Return what a job made, once it is done, else how it stands; the ledger is told how it ended.

        Args:
            maker: Works on it.
            job: Submitted.
            wanted: What is made.

        Raises:
            ServiceFailure: The service cannot be asked now; the job goes on.
            InputError: The disk cannot take what was made.
        """
        late = time.time() - job.began > LONGEST
        try:
            state = maker.poll(job.remote_id)
            if state.status == "done":
                return self._fetched(maker, job, wanted)
        except Unusable as error:
            state = JobState("failed", reason=error.problem)
        except ServiceFailure:
            if not late:
                raise
            state = JobState("working")
        if late and state.status != "failed":
            state = JobState("failed", reason="nothing came of it within a day, which is how long services keep it")
        if state.status == "failed":
            self._library.jobs.failed(job, state.reason)
        return state

    @contextmanager
    def _alone(self, kind: str, maker: Maker, asked: str) -> Iterator[None]:
        """Be the only process that sends a request; the system frees it when a process dies.

        Raises:
            Cancelled: While another process was waited for.
            ServiceFailure: The limit of minutes is reached, or the library cannot be written.
        """
        name = f"{content_hash(kind, maker.settings, asked)}.lock"
        try:
            lock = FileLock(self._library.files.make_folder(INCOMING) / name, timeout=0, thread_local=False)
            while not _taken(lock):
                self._budget.spend("minutes", _PAUSE / 60)
                if self._cancelled.wait(_PAUSE):
                    raise Cancelled
        except (InputError, OSError) as error:
            raise ServiceFailure(f"the library cannot be written ({error})") from error
        try:
            yield
        finally:
            lock.release()

    def made_meanwhile(self, maker: ModelMaker, picture: LibraryEntry, wanted: Wanted) -> LibraryEntry | None:
        """Return the model of a picture that an earlier run had begun; None where there is none yet. Costs nothing.

        Args:
            maker: Was asked for it.
            picture: In the library.
            wanted: What is made.

        Raises:
            ServiceFailure: The service cannot be asked now; the job goes on.
            InputError: The disk cannot take what was made.
        """
        request = content_hash("model", maker.maker.settings, picture.digest)
        if (known := self._library.by_request(request)) is not None:
            return known
        begun = [job for job in self._library.jobs.unfinished() if job.request == request and job.remote_id]
        found = self.look(maker, begun[0], wanted) if begun else None
        return found if isinstance(found, LibraryEntry) else None

    def pictures_of(self, prompt: str) -> list[LibraryEntry]:
        """Return the pictures that were drawn of a prompt, also those that were to avoid a fault, the newest first.

        Args:
            prompt: What the first picture was drawn of.
        """
        return [entry for entry in self._library.find(kind="image") if self._prompt_of(entry).startswith(prompt)]

    def _prompt_of(self, entry: LibraryEntry) -> str:
        try:
            return (self._library.bundle_of(entry) / _PROMPT).read_text(encoding="utf-8", errors="replace")
        except OSError:
            return ""

    def _begun(self, kind: str, maker: Maker, asked: str) -> LibraryEntry | Job:
        """Return what was made before, or a job: submitted before, or to be sent now. Raises ServiceFailure."""
        request, jobs = content_hash(kind, maker.settings, asked), self._library.jobs
        if (known := self._library.by_request(request)) is not None:
            for job in jobs.unfinished():
                if job.request == request:
                    jobs.finished(job, known.digest)
            return known
        self._budget.spend("dollars", maker.price)
        try:
            job = jobs.begin(request, maker.service, maker.price)
        except InputError as error:
            self._budget.give_back("dollars", maker.price)
            raise ServiceFailure(error.problem, mend=_ASK_AGAIN, uncertain=True) from error
        if job.state != "begun":
            self._budget.give_back("dollars", maker.price)
        return job

    def _refused(self, job: Job, maker: Maker, failure: ServiceFailure) -> ServiceFailure:
        """Note that what was asked failed, and return why, with what to do where it may have been paid."""
        if not failure.uncertain:
            self._library.jobs.failed(job, failure.problem)
            self._budget.give_back("dollars", maker.price)
            return failure
        return ServiceFailure(failure.problem, mend=_ASK_AGAIN, uncertain=True)

    def _found_again(self, maker: ModelMaker, picture: LibraryEntry, failure: ServiceFailure) -> LibraryEntry | Job:
        """Go on with a job that was begun before and has no id, if the service can tell. Raises ServiceFailure."""
        request = content_hash("model", maker.maker.settings, picture.digest)
        lost = next((job for job in self._library.jobs.unfinished() if job.request == request), None)
        if lost is None:
            raise failure
        job = self._looked_for(maker, lost)
        if job is None:
            raise failure
        return job if job.state == "submitted" else self._model(maker, picture)

    def _looked_for(self, maker: ModelMaker, lost: Job) -> Job | None:
        """Return a job whose id got lost: with its id, or failed if it surely was not begun; None if unknown."""
        jobs = self._library.jobs
        known = [job.remote_id for job in jobs.all() if job.remote_id]
        try:
            remote_id = maker.lost_job(_mark(lost), lost.began, known)
        except ServiceFailure:
            return None
        if remote_id is None:
            return None
        return jobs.submitted(lost, remote_id) if remote_id else jobs.failed(lost, "it never arrived at the service")

    def _drawn(self, future: Future[bytes], maker: Maker, job: Job, wanted: Wanted) -> LibraryEntry | ServiceFailure:
        """Keep a picture that was drawn, or note why it was not."""
        try:
            data = future.result()
        except ServiceFailure as error:
            return self._refused(job, maker, error)
        except Cancelled:
            return self._refused(job, maker, ServiceFailure("cancelled before it was sent"))
        try:
            with tempfile.TemporaryDirectory() as name:
                part = Path(name) / "picture.png"
                part.write_bytes(data)
                return self._kept("image", job, maker, wanted, part.parent, part.name)
        except (InputError, OSError) as error:
            return self._refused(job, maker, ServiceFailure(f"the picture cannot be kept ({error})", uncertain=True))

    def _fetched(self, maker: JobService, job: Job, wanted: Wanted) -> LibraryEntry:
        """Download what a job made and keep it. Raises ServiceFailure and InputError."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            return self._kept(wanted.kind, job, maker.maker, wanted, folder, maker.fetch(job.remote_id, folder))

    def _kept(self, kind: EntryKind, job: Job, maker: Maker, wanted: Wanted, folder: Path, main: str) -> LibraryEntry:
        """Add what was made to the library, with its prompt and its terms beside it, and close the job."""
        authors = filter(None, (wanted.made_of.author, f"{maker.service} ({maker.model})"))
        licences = dict.fromkeys(filter(None, (wanted.made_of.license, maker.licence)))
        credit = Credit(**credit_lines({"author": ", ".join(authors), "license": "; ".join(licences)}))
        credit = credit.model_copy(update={"url": maker.url})
        for name, text in ((CREDITS, _toml(credit)), (_PROMPT, f"{wanted.prompt}\n")):
            part = folder / name
            part.write_text(text, encoding="utf-8")
        facts = EntryFacts(
            kind=kind,
            name=wanted.name[:200],
            category=wanted.category,
            main=main,
            credit=credit,
            source=maker.service,
            source_id=job.remote_id,
            request=job.request,
        )
        entry = self._library.add(facts, folder)
        self._library.jobs.finished(job, entry.digest)
        return entry


def _taken(lock: FileLock) -> bool:
    """Take a lock if no other process has it, and return whether it is taken."""
    try:
        lock.acquire()
    except Timeout:
        return False
    return True


def _mark(job: Job) -> str:
    """Return the word by which a service can tell a job from others."""
    return f"storyblender-{job.request}-{job.id}"


def _toml(credit: Credit) -> str:
    return "".join(f"{name} = {json.dumps(text)}\n" for name, text in credit if text)
