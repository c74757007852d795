"""Services that make things: pictures from words, models from pictures, rigs and motions on models.

A picture is one call. A model or a rig is a job: it is begun once, which costs, then polled by its id and fetched. Who
pays keeps the books (``library.shared``); an adapter only says what a step costs and what became of it.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol

from storyblender.errors import ServiceFailure
from storyblender.service_setting import ServiceName

JobStatus = Literal["waiting", "working", "done", "failed"]


class Busy(ServiceFailure):
    """A service takes no further job now; nothing was paid."""


class Unusable(ServiceFailure):
    """What a job made, and was paid for, is not what was asked for; fetching it again would not help."""


@dataclass(frozen=True)
class JobState:
    """How a job stands.

    Attributes:
        status: ``waiting`` in a queue, ``working``, ``done`` and ready to fetch, ``failed`` for good.
        percent: How much is done, 0 to 100.
        reason: Why it failed, one clause.
    """

    status: JobStatus
    percent: int = 0
    reason: str = ""


@dataclass(frozen=True)
class Maker:
    """What is known of a service that makes things before anything is asked of it.

    Attributes:
        service: Its name in the settings.
        model: Which of its models; what another one makes is another thing.
        price: Of one step, in US dollars, about; 0 for a server of one's own.
        licence: The terms under which the service gives what it makes, as credits name them.
        url: Page of these terms.
        at_once: Jobs that it works on at the same time.
    """

    service: ServiceName
    model: str
    price: float
    licence: str
    url: str
    at_once: int = 4

    @property
    def settings(self) -> str:
        """What tells its work from that of another service or model."""
        return f"{self.service}:{self.model}"


class ImageModel(Protocol):
    """Draws pictures."""

    @property
    def maker(self) -> Maker:
        """What it is and costs."""
        ...

    def draw(self, prompt: str) -> bytes:
        """Return one picture of what a prompt describes, checked to be one, as PNG. It costs, and is not asked twice.

        Args:
            prompt: What is in the picture, in English.

        Raises:
            ServiceFailure: It was refused or failed; ``uncertain`` if it may have been drawn and paid all the same.
        """
        ...


class JobService(Protocol):
    """Does work that takes minutes, in jobs."""

    @property
    def maker(self) -> Maker:
        """What it is and costs."""
        ...

    def poll(self, job: str) -> JobState:
        """Return how a job stands. Costs nothing.

        Args:
            job: Its id at the service.

        Raises:
            ServiceFailure: The service cannot be asked now.
        """
        ...

    def fetch(self, job: str, folder: Path) -> str:
        """Download what a finished job made, because the links to it soon expire. Costs nothing.

        Args:
            job: Its id at the service.
            folder: Empty, private to the caller; if this fails, what is in it is of no use.

        Returns:
            Name of the main file in the folder.

        Raises:
            Unusable: What it made is no model.
            ServiceFailure: It cannot be fetched now.
        """
        ...

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Look for a job that was begun, and whose id never arrived, in what the service lists. Costs nothing.

        Args:
            mark: What it was begun with.
            since: When, in seconds since 1970.
            known: Ids of other jobs.

        Returns:
            Its id; empty if it surely was not begun; None where that cannot be told.

        Raises:
            ServiceFailure: The service cannot be asked.
        """
        ...


class ModelMaker(JobService, Protocol):
    """Makes a textured model of a picture, or puts a skeleton into the model of a person."""

    def begin(self, source: bytes, /, mark: str) -> str:
        """Begin a model and return the id of the job. It costs, and is not asked twice.

        Args:
            source: PNG of one object before a plain background; or a textured person as .glb, arms apart.
            mark: Letters, digits and dashes by which the job can be told from others, where the service keeps them.

        Raises:
            Busy: Other jobs have to end first.
            ServiceFailure: It was refused; ``uncertain`` if it may have been begun and paid all the same.
        """
        ...
