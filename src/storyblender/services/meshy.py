"""Meshy: models from pictures, rigs for models of people, motions on rigs (its openapi/v1).

Every kind of work is a task: ``POST`` answers with its id, ``GET .../{id}`` says how it stands and, for three days,
where its files are. Models can be listed, so that one whose id got lost is found; rigs and motions cannot.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from base64 import b64encode
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any, Final

from storyblender.errors import ServiceFailure
from storyblender.services.made_files import MOST_MODEL_BYTES, check_glb
from storyblender.services.making import JobState, JobStatus, Maker, Unusable
from storyblender.services.offers import is_id, line_of
from storyblender.services.paid import job_in, paid_answer
from storyblender.services.web import Missing, Web

ADDRESS: Final = "https://api.meshy.ai/openapi"
USUAL: Final = "meshy-6"
_CREDIT: Final = 0.02
"""US dollars for a credit of the plan Pro, as read in November 2026."""
_CREDITS: Final = {"meshy-6": 30, "meshy-5": 15}
"""For a textured model, as read in June 2026."""
_RIG_CREDITS, _MOTION_CREDITS = 5, 3
_TERMS: Final = "https://www.meshy.ai/terms-of-use"
_FACES: Final = 30_000
_STATUS: Final[Mapping[str, JobStatus]] = {
    "PENDING": "waiting", "IN_PROGRESS": "working", "SUCCEEDED": "done", "FAILED": "failed", "CANCELED": "failed",
    "EXPIRED": "failed",
}  # fmt: skip
_CLOCKS_APART: Final = 600.0
"""Seconds by which its clock and ours may differ."""
SETTLED: Final = 60.0
"""Seconds after which a task that is not listed was not begun."""


class _Tasks(ABC):
    """One kind of task.

    Args:
        web: HTTP with the service.
        path: Of the kind, below the address.
        maker: What it is and costs.
    """

    def __init__(self, web: Web, path: str, maker: Maker) -> None:
        self._web, self._path, self.maker = web, path, maker

    def poll(self, job: str) -> JobState:
        """Return how a task stands. Raises ServiceFailure."""
        try:
            task = self._task(job)
        except Missing:
            return JobState("failed", reason="the service does not have the task any more")
        status = _STATUS.get(str(task.get("status")))
        if status is None:
            raise ServiceFailure(f"meshy: it knows no state {line_of(task.get('status'), 40)!r}")
        error, percent = task.get("task_error"), task.get("progress")
        reason = line_of(error.get("message")) if isinstance(error, dict) else ""
        share = min(100, max(0, percent)) if isinstance(percent, int) else 0
        return JobState(status, share, (reason or "it does not say why") if status == "failed" else "")

    def fetch(self, job: str, folder: Path) -> str:
        """Download what a finished task made, and return the name of the file. Raises ServiceFailure.

        Args:
            job: Its id.
            folder: Empty.
        """
        url = self._url_in(self._task(job))
        if not isinstance(url, str) or not url:
            raise Unusable("meshy: it made no .glb")
        part = folder / "model.glb"
        self._web.download(url, part, most=MOST_MODEL_BYTES)
        check_glb(part)
        return part.name

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Return None: tasks of this kind are not listed."""
        return None

    @abstractmethod
    def _url_in(self, task: Mapping[str, Any]) -> Any:
        """Return where the result of a task is."""

    def _begun(self, asked: Mapping[str, Any]) -> str:
        """Begin a task and return its id. Raises ServiceFailure."""
        return job_in(paid_answer(self._web, self._path, asked), "result", self._web)

    def _task(self, job: str) -> dict[str, Any]:
        answer = self._web.get(f"{self._path}/{job}").json
        if not isinstance(answer, dict):
            raise ServiceFailure("meshy: its answer is not of the form that it should have")
        return answer


class MeshyModels(_Tasks):
    """Models from pictures.

    Args:
        web: HTTP with the service.
        model: ``meshy-6`` or another; empty for the usual one.
    """

    def __init__(self, web: Web, model: str = "") -> None:
        name = model or USUAL
        price = _CREDITS.get(name, 2 * max(_CREDITS.values())) * _CREDIT
        super().__init__(web, "v1/image-to-3d", Maker("meshy", name, price, "Meshy terms of use", _TERMS))

    def begin(self, picture: bytes, mark: str) -> str:
        """Begin a model and return the id of the task. Raises ServiceFailure.

        Args:
            picture: PNG.
            mark: Not used: the service keeps no word of ours.
        """
        return self._begun(
            {
                "image_url": f"data:image/png;base64,{b64encode(picture).decode()}",
                "ai_model": self.maker.model,
                "should_texture": True,
                "should_remesh": True,
                "topology": "triangle",
                "target_polycount": _FACES,
                "target_formats": ["glb"],
            }
        )

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Return the one task that was begun since then and belongs to no other job; None if that cannot be told.

        Args:
            mark: Not used.
            since: Seconds since 1970.
            known: Ids of other jobs.
        """
        listed = self._web.get(self._path, {"page_num": 1, "page_size": 50, "sort_by": "-created_at"}).json
        if not isinstance(listed, list):
            raise ServiceFailure("meshy: its answer is not of the form that it should have")
        found = [
            str(each["id"])
            for each in listed
            if isinstance(each, dict) and is_id(each.get("id")) and each["id"] not in known
            if isinstance(begun := each.get("created_at"), int) and begun / 1000 >= since - _CLOCKS_APART
        ]
        if found:
            return found[0] if len(found) == 1 else None
        return "" if time.time() - since >= SETTLED else None

    def balance(self) -> int:
        """Return how many credits the account has left. Raises ServiceFailure."""
        answer = self._web.get("v1/balance").json
        left = answer.get("balance") if isinstance(answer, dict) else None
        if not isinstance(left, int):
            raise ServiceFailure("meshy: its answer is not of the form that it should have")
        return left

    def _url_in(self, task: Mapping[str, Any]) -> Any:
        urls = task.get("model_urls")
        return urls.get("glb") if isinstance(urls, dict) else None


class MeshyRigs(_Tasks):
    """Skeletons for models of people.

    Args:
        web: HTTP with the service.
        height: Of the person, in metres.
    """

    def __init__(self, web: Web, height: float) -> None:
        self._height = height
        maker = Maker("meshy", "rigging", _RIG_CREDITS * _CREDIT, "Meshy terms of use", _TERMS)
        super().__init__(web, "v1/rigging", maker)

    def begin(self, model: bytes, /, mark: str) -> str:
        """Begin to rig a model and return the id of the task. Raises ServiceFailure.

        Args:
            model: A textured person as .glb.
            mark: Not used.
        """
        url = f"data:application/octet-stream;base64,{b64encode(model).decode()}"
        return self._begun({"model_url": url, "height_meters": self._height})

    def _url_in(self, task: Mapping[str, Any]) -> Any:
        result = task.get("result")
        return result.get("rigged_character_glb_url") if isinstance(result, dict) else None


class MeshyMotions(_Tasks):
    """Motions of Meshy's library on models that it rigged.

    Args:
        web: HTTP with the service.
    """

    def __init__(self, web: Web) -> None:
        maker = Maker("meshy", "animation", _MOTION_CREDITS * _CREDIT, "Meshy terms of use", _TERMS)
        super().__init__(web, "v1/animations", maker)

    def begin(self, rig: str, action: int, mark: str) -> str:
        """Begin to put a motion on a rig and return the id of the task. Raises ServiceFailure.

        Args:
            rig: Id of the task that rigged it.
            action: Number of the motion in Meshy's library.
            mark: Not used.
        """
        return self._begun({"rig_task_id": rig, "action_id": action})

    def _url_in(self, task: Mapping[str, Any]) -> Any:
        result = task.get("result")
        return result.get("animation_glb_url") if isinstance(result, dict) else None
