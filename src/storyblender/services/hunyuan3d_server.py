"""Models by a Hunyuan3D server of one's own: ``api_server.py`` of Hunyuan3D-2 and 2.1 (``/send``, ``/status/{uid}``).

The server answers with the whole model in base64. It says nothing of a job that failed, or that it does not know: such
a job stays in work for ever, and the limits of the run end it.
"""

from __future__ import annotations

import json
import tempfile
from base64 import b64decode, b64encode
from collections.abc import Collection
from pathlib import Path
from typing import Any, Final

from storyblender.errors import ServiceFailure
from storyblender.services.made_files import MOST_MODEL_BYTES, check_glb
from storyblender.services.making import JobState, Maker, Unusable
from storyblender.services.offers import line_of
from storyblender.services.paid import job_in, paid_answer
from storyblender.services.web import Web

SHAPE: Final = "shape"
"""Model of the setting for a Hunyuan3D-2 server that was started without textures: ``hunyuan3d:shape@http://...``."""


class Hunyuan3DServer:
    """A Hunyuan3D server of one's own.

    Args:
        web: HTTP with it.
        model: ``shape`` for models without textures.
    """

    def __init__(self, web: Web, model: str = "") -> None:
        self._web, self._textured = web, model != SHAPE
        terms = "https://github.com/Tencent-Hunyuan/Hunyuan3D-2/blob/main/LICENSE"
        self.maker = Maker("hunyuan3d", model or "server", 0.0, "Tencent Hunyuan community license", terms, at_once=1)

    def begin(self, picture: bytes, mark: str) -> str:
        """Begin a model and return the id of the job. Raises ServiceFailure.

        Args:
            picture: PNG.
            mark: Not used: the server keeps no word of ours.
        """
        asked = {"image": b64encode(picture).decode(), "texture": self._textured, "seed": 1234}
        return job_in(paid_answer(self._web, "send", asked), "uid", self._web)

    def poll(self, job: str) -> JobState:
        """Return how a job stands. Raises ServiceFailure."""
        answer = self._status(job)
        match answer.get("status"):
            case "completed":
                return JobState("done", 100)
            case "texturing":
                return JobState("working", 50)
            case "processing":
                return JobState("working")
            case _:
                return JobState("failed", reason=line_of(answer.get("message")) or "it does not say why")

    def fetch(self, job: str, folder: Path) -> str:
        """Download what a finished job made, and return the name of the file. Raises ServiceFailure.

        Args:
            job: Its id.
            folder: Empty.
        """
        try:
            model = b64decode(self._status(job)["model_base64"], validate=True)
        except (KeyError, TypeError, ValueError) as error:
            raise Unusable("hunyuan3d: what came back is no model") from error
        part = folder / "model.glb"
        part.write_bytes(model)
        check_glb(part)
        return part.name

    def lost_job(self, mark: str, since: float, known: Collection[str]) -> str | None:
        """Return None: the server lists no jobs."""
        return None

    def _status(self, job: str) -> dict[str, Any]:
        """Return what the server says of a job, which may be as large as a model. Raises ServiceFailure."""
        with tempfile.TemporaryDirectory() as folder:
            part = Path(folder) / "status.json"
            self._web.download(f"{self._web.address.rstrip('/')}/status/{job}", part, most=2 * MOST_MODEL_BYTES)
            try:
                answer = json.loads(part.read_bytes())
            except (ValueError, RecursionError) as error:
                raise ServiceFailure("hunyuan3d: its answer is not JSON") from error
        if not isinstance(answer, dict):
            raise ServiceFailure("hunyuan3d: its answer is not of the form that it should have")
        return answer
