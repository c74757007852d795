"""Models by Hunyuan3D on Tencent Cloud: ``SubmitHunyuanTo3DProJob`` and ``QueryHunyuanTo3DProJob``.

China's site has them at ``ai3d.tencentcloudapi.com``, the international one at ``hunyuan.intl.tencentcloudapi.com``
under an older version; the fields are the same. The links to a result hold for 24 hours.
"""

from __future__ import annotations

import json
import time
from base64 import b64encode
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

from storyblender.errors import ServiceFailure
from storyblender.services.archives import extract
from storyblender.services.made_files import MOST_MODEL_BYTES, check_glb
from storyblender.services.making import Busy, JobState, JobStatus, Maker, Unusable
from storyblender.services.offers import line_of
from storyblender.services.paid import job_in, paid_answer
from storyblender.services.tencent_signature import CONTENT_TYPE, TencentKey, authorization
from storyblender.services.web import Web

ADDRESS: Final = "https://ai3d.tencentcloudapi.com"
CLOUD: Final = ".tencentcloudapi.com"
"""End of the hosts that the cloud has; every other address is a server of one's own."""
PRICE: Final = 0.40
"""US dollars for a textured model: 20 credits of CNY 0.12, as read in July 2026, and some room."""
_STATUS: Final[Mapping[str, JobStatus]] = {"WAIT": "waiting", "RUN": "working", "DONE": "done", "FAIL": "failed"}
_REASONS: Final = {
    "AuthFailure": "it refuses the key",
    "UnauthorizedOperation": "it refuses the key",
    "OperationDenied": "its moderation refuses the picture",
    "ResourceInsufficient": "its account has no credit left",
    "ResourceUnavailable": "its account has no credit left, or the service is not switched on",
}
"""Beginnings of error codes, and what they mean."""


class Hunyuan3DCloud:
    """Hunyuan3D on Tencent Cloud.

    Args:
        web: HTTP with it.
        key: Of the account.
        model: ``3.0`` or ``3.1``; empty for the usual one.
    """

    def __init__(self, web: Web, key: TencentKey, model: str = "") -> None:
        self._web, self._key, self._host = web, key, urlsplit(web.address).netloc
        self._service = "hunyuan" if self._host.startswith("hunyuan.") else "ai3d"
        self._model = model
        terms = "https://www.tencentcloud.com/document/product/301/9248"
        self.maker = Maker("hunyuan3d", model or "pro", PRICE, "Tencent Cloud terms of service", terms, at_once=3)

    def begin(self, picture: bytes, mark: str) -> str:
        """Begin a model and return the id of the job. Raises Busy and ServiceFailure.

        Args:
            picture: PNG.
            mark: Not used: the service keeps no word of ours.
        """
        wanted = {"ImageBase64": b64encode(picture).decode(), "GenerateType": "Normal"}
        answer = self._call("SubmitHunyuanTo3DProJob", {**wanted, **({"Model": self._model} if self._model else {})})
        return job_in(answer, "JobId", self._web)

    def poll(self, job: str) -> JobState:
        """Return how a job stands. Raises ServiceFailure."""
        answer = self._call("QueryHunyuanTo3DProJob", {"JobId": job})
        status = _STATUS.get(str(answer.get("Status")))
        if status is None:
            raise ServiceFailure(f"hunyuan3d: it knows no state {line_of(answer.get('Status'), 40)!r}")
        reason = line_of(answer.get("ErrorMessage")) or line_of(answer.get("ErrorCode")) or "it does not say why"
        percents: Mapping[JobStatus, int] = {"working": 50, "done": 100}
        return JobState(status, percents.get(status, 0), reason if status == "failed" else "")

    def fetch(self, job: str, folder: Path) -> str:
        """Download what a finished job made, and return the name of the main file. Raises ServiceFailure.

        Args:
            job: Its id.
            folder: Empty.
        """
        listed = self._call("QueryHunyuanTo3DProJob", {"JobId": job}).get("ResultFile3Ds")
        files = [each for each in listed if isinstance(each, dict)] if isinstance(listed, list) else []
        urls = {str(each.get("Type")).upper(): each.get("Url") for each in files}
        if isinstance(url := urls.get("GLB"), str):
            part = folder / "model.glb"
            self._web.download(url, part, most=MOST_MODEL_BYTES)
            check_glb(part)
            return part.name
        if isinstance(url := urls.get("OBJ"), str):
            return self._unpacked(url, folder)
        raise Unusable("hunyuan3d: it made neither a .glb nor an .obj")

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Return None: the service lists no jobs."""
        return None

    def _unpacked(self, url: str, folder: Path) -> str:
        """Fetch the archive with an .obj and return its name."""
        part = folder / "model.zip"
        self._web.download(url, part, most=MOST_MODEL_BYTES)
        try:
            names = extract(part, folder)
        except ServiceFailure as error:
            raise Unusable(f"hunyuan3d: {error.problem}") from error
        part.unlink()
        main = next((name for name in names if name.lower().endswith(".obj")), None)
        if main is None:
            raise Unusable("hunyuan3d: the archive has no .obj in it")
        return main

    def _call(self, action: str, wanted: Mapping[str, str]) -> dict[str, Any]:
        """Return what an action answers. Raises Busy and ServiceFailure."""
        body, now = json.dumps(wanted).encode(), int(time.time())
        international = self._service == "hunyuan"
        headers = {
            "content-type": CONTENT_TYPE,
            "authorization": authorization(self._key, self._service, self._host, body, now),
            "x-tc-action": action,
            "x-tc-version": "2023-09-01" if international else "2025-05-13",
            "x-tc-timestamp": str(now),
            "x-tc-region": "ap-singapore" if international else "ap-guangzhou",
        }
        if action.startswith("Submit"):
            answer = paid_answer(self._web, "", content=body, headers=headers)
        else:
            answer = self._web.post("", content=body, headers=headers).json
        said = answer.get("Response") if isinstance(answer, dict) else None
        if not isinstance(said, dict):
            raise ServiceFailure("hunyuan3d: its answer is not of the form that it should have", uncertain=True)
        error = said.get("Error")
        if isinstance(error, dict):
            raise _refusal(line_of(error.get("Code"), 80), line_of(error.get("Message")))
        return said


def _refusal(code: str, message: str) -> ServiceFailure:
    """Return what an error of the service means for us."""
    if code.startswith("RequestLimitExceeded") or code.startswith("LimitExceeded"):
        return Busy("hunyuan3d: it takes no further job now")
    reason = _REASONS.get(code.partition(".")[0], "it refuses the request")
    return ServiceFailure(f"hunyuan3d: {reason} ({code}{': ' if message else ''}{message})")
