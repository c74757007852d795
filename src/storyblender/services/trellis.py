"""Models by a TRELLIS server of one's own, as https://github.com/FishWoWater/TRELLIS serves it (``trellis_api``).

``POST /image_to_3d`` queues a picture, ``GET /my_requests`` lists what this computer asked for, with the files that
were made. The name of the picture comes back in that list: so a job whose id got lost is found again.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

from storyblender.errors import ServiceFailure
from storyblender.services.made_files import MOST_MODEL_BYTES, check_glb
from storyblender.services.making import JobState, JobStatus, Maker, Unusable
from storyblender.services.offers import is_id, line_of
from storyblender.services.paid import job_in, paid_answer
from storyblender.services.web import Web

_STATUS: Final[Mapping[str, JobStatus]] = {
    "queued": "waiting", "processing": "working", "complete": "done", "error": "failed",
}  # fmt: skip
_FILE: Final = re.compile(r"/output/[0-9A-Za-z.:_-]+/[0-9A-Za-z-]+/[0-9A-Za-z_-]+\.glb")
"""Path of a model on the server. Its host is whatever the server takes itself for, and is not used."""
_FULL_HISTORY: Final = 10
"""Entries from which on a list may have lost its oldest."""


class TrellisServer:
    """A TRELLIS server of one's own.

    Args:
        web: HTTP with it.
        model: What the user calls the model that it runs.
    """

    def __init__(self, web: Web, model: str = "") -> None:
        self._web = web
        terms = "https://github.com/microsoft/TRELLIS/blob/main/LICENSE"
        self.maker = Maker("trellis", model or "server", 0.0, "MIT (TRELLIS)", terms)

    def begin(self, picture: bytes, mark: str) -> str:
        """Begin a model and return the id of the job. Raises ServiceFailure.

        Args:
            picture: PNG.
            mark: Becomes the name of the picture.
        """
        asked = {"image_data": b64encode(picture).decode(), "image_name": f"{mark}.png"}
        return job_in(paid_answer(self._web, "image_to_3d", asked), "request_id", self._web)

    def poll(self, job: str) -> JobState:
        """Return how a job stands. Raises ServiceFailure."""
        found = self._request(job)
        if found is None:
            return JobState("failed", reason="the server does not know the job any more")
        status = _STATUS.get(str(found.get("status")))
        if status is None:
            raise ServiceFailure(f"trellis: it knows no state {line_of(found.get('status'), 40)!r}")
        percents: Mapping[JobStatus, int] = {"working": 50, "done": 100}
        reason = line_of(found.get("error")) or "it does not say why"
        return JobState(status, percents.get(status, 0), reason if status == "failed" else "")

    def fetch(self, job: str, folder: Path) -> str:
        """Download what a finished job made, and return the name of the file. Raises ServiceFailure.

        Args:
            job: Its id.
            folder: Empty.
        """
        files = (self._request(job) or {}).get("output_files") or []
        paths = [urlsplit(each).path for each in files if isinstance(each, str)]
        path = next((each for each in paths if _FILE.fullmatch(each)), None)
        if path is None:
            raise Unusable("trellis: it made no .glb")
        part = folder / "model.glb"
        self._web.download(self._web.address.rstrip("/") + path, part, most=MOST_MODEL_BYTES)
        check_glb(part)
        return part.name

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Return the job whose picture has that name; empty if there is none, None if the list may be cut.

        Args:
            mark: Name of the picture.
            since: Not used: the name tells.
            known: Ids of other jobs.
        """
        listed = self._requests()
        for each in listed:
            job = each.get("request_id")
            if each.get("image_name") == f"{mark}.png" and is_id(job) and job not in known:
                return str(job)
        return "" if len(listed) < _FULL_HISTORY else None

    def _request(self, job: str) -> dict[str, Any] | None:
        return next((each for each in self._requests() if each.get("request_id") == job), None)

    def _requests(self) -> list[dict[str, Any]]:
        """Return what the server lists. Raises ServiceFailure."""
        answer = self._web.get("my_requests").json
        listed = answer.get("requests") if isinstance(answer, dict) else None
        if not isinstance(listed, list):
            raise ServiceFailure("trellis: its answer is not of the form that it should have")
        return [each for each in listed if isinstance(each, dict)]
