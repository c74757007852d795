"""Services that make pictures and models, as a site on this machine: each speaks the wire format of the real one."""

from __future__ import annotations

import base64
import hashlib
import io
import json
import struct
import time
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from PIL import Image, ImageDraw

from storyblender.services.hunyuan3d import Hunyuan3DCloud
from storyblender.services.hunyuan3d_server import Hunyuan3DServer
from storyblender.services.making import ModelMaker
from storyblender.services.meshy import MeshyModels
from storyblender.services.tencent_signature import TencentKey
from storyblender.services.trellis import TrellisServer
from storyblender.services.web import Web
from tests.services.site import Act, Hit, Reply, Site, said

SECRET = "sk-very-secret-1234"
SECRET_KEY = "Gu5t9xGARNpq86cd98joQYCN3very-secret"


def picture(about: str = "a thing", size: int = 256) -> bytes:
    """Return a PNG of a round thing before white, in a colour of its own."""
    image = Image.new("RGB", (size, size), "white")
    red, green, blue = hashlib.sha256(about.encode()).digest()[:3]
    ImageDraw.Draw(image).ellipse(
        (size // 4, size // 4, 3 * size // 4, 3 * size // 4), (red // 2, green // 2, blue // 2)
    )
    out = io.BytesIO()
    image.save(out, "PNG")
    return out.getvalue()


def model(about: bytes = b"", *, linked: str = "") -> bytes:
    """Return a .glb of a box one metre wide and high, in a colour of its own.

    Args:
        about: What it is made of.
        linked: A file that it refers to.
    """
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([tri for a, b, c, d in sides for tri in ((a, b, c), (a, c, d))], np.uint16)
    data = corners.tobytes() + faces.tobytes()
    color = [each / 255 for each in hashlib.sha256(about).digest()[:3]]
    document: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [*color, 1.0]}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": faces.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": corners.nbytes},
            {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": faces.nbytes},
        ],
        "buffers": [{"byteLength": len(data)}],
    }
    if linked:
        document["images"] = [{"uri": linked}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


@dataclass
class Wire:
    """A maker of models on a site.

    Attributes:
        site: Serves it.
        polls: Looks at a job before it is done.
        file: What every job makes; the digest of the picture makes models differ if it is not given.
        failure: Why every job fails; empty if none does.
        jobs: Looks left, by id.
    """

    site: Site
    polls: int = 1
    file: bytes | None = None
    failure: str = ""
    jobs: dict[str, int] = field(default_factory=dict)
    begun: dict[str, dict[str, Any]] = field(default_factory=dict)

    name = ""
    begin_path = ""

    def adapter(self, web: Web) -> ModelMaker:
        raise NotImplementedError

    def open(self) -> None:
        """Add its pages to the site."""
        raise NotImplementedError

    def poll_path(self, job: str) -> str:
        raise NotImplementedError

    def _new(self, asked: dict[str, Any], shown: str) -> str:
        job = f"{self.name}-{len(self.jobs) + 1}"
        self.jobs[job] = self.polls
        self.begun[job] = {**asked, "file": self.file or model(shown[:4000].encode())}
        return job

    def _is_done(self, job: str) -> bool:
        self.jobs[job] -= 1
        return self.jobs[job] < 0

    def _serve_file(self, job: str) -> str:
        path = f"/files/{job}.glb"
        self.site.pages.setdefault(path, Reply(self.begun[job]["file"], kind="model/gltf-binary"))
        return self.site.address + path


class MeshyWire(Wire):
    """``POST`` and ``GET /v1/image-to-3d``, ``GET /v1/image-to-3d/{id}``."""

    name = "meshy"
    begin_path = "/v1/image-to-3d"

    def adapter(self, web: Web) -> ModelMaker:
        return MeshyModels(web)

    def open(self) -> None:
        self.site.pages[self.begin_path] = self._begin
        self.site.pages["/v1/balance"] = said({"balance": 1000})

    def poll_path(self, job: str) -> str:
        return f"{self.begin_path}/{job}"

    def _begin(self, hit: Hit) -> Act:
        if hit.headers.get("authorization") != f"Bearer {SECRET}":
            return said({"message": "Unauthorized"}, 401)
        if hit.method == "GET":
            return said([self._task(job) for job in reversed(self.jobs)])
        job = self._new(hit.json, hit.json["image_url"])
        self.begun[job]["created_at"] = int(time.time() * 1000)
        self.site.pages[self.poll_path(job)] = lambda hit: said(self._task(job, self._is_done(job)))
        return said({"result": job}, 202)

    def _task(self, job: str, done: bool = False) -> dict[str, Any]:
        state = ("FAILED" if self.failure else "SUCCEEDED") if done else "IN_PROGRESS"
        return {
            "id": job,
            "type": "image-to-3d",
            "status": state,
            "progress": 100 if done else 40,
            "created_at": self.begun[job]["created_at"],
            "model_urls": {"glb": self._serve_file(job)} if state == "SUCCEEDED" else {},
            "task_error": {"message": self.failure},
        }


class TrellisWire(Wire):
    """``POST /image_to_3d``, ``GET /my_requests``, ``GET /output/{ip}/{id}/output.glb``."""

    name = "trellis"
    begin_path = "/image_to_3d"

    def adapter(self, web: Web) -> ModelMaker:
        return TrellisServer(web)

    def open(self) -> None:
        self.site.pages[self.begin_path] = self._begin
        self.site.pages["/my_requests"] = self._list

    def poll_path(self, job: str) -> str:
        return "/my_requests"

    def _begin(self, hit: Hit) -> Act:
        job = self._new(hit.json, hit.json["image_data"])
        return said({"request_id": job, "status": "queued", "message": "Request queued successfully"})

    def _list(self, hit: Hit) -> Act:
        return said({"ip_address": "127.0.0.1", "requests": [self._entry(job) for job in reversed(self.jobs)]})

    def _entry(self, job: str) -> dict[str, Any]:
        done = self._is_done(job)
        path = f"/output/127.0.0.1/{job}/output.glb"
        self.site.pages.setdefault(path, Reply(self.begun[job]["file"]))
        return {
            "request_id": job,
            "status": ("error" if self.failure else "complete") if done else "processing",
            "output_files": [f"http://somewhere.else:6006{path}"] if done and not self.failure else None,
            "error": self.failure or None,
            "image_name": self.begun[job]["image_name"],
        }


class HunyuanWire(Wire):
    """``POST /send``, ``GET /status/{uid}`` of ``api_server.py``."""

    name = "hunyuan3d"
    begin_path = "/send"

    def adapter(self, web: Web) -> ModelMaker:
        return Hunyuan3DServer(web)

    def open(self) -> None:
        self.site.pages[self.begin_path] = self._begin

    def poll_path(self, job: str) -> str:
        return f"/status/{job}"

    def _begin(self, hit: Hit) -> Act:
        job = self._new(hit.json, hit.json["image"])
        self.site.pages[self.poll_path(job)] = lambda hit: self._status(job)
        return said({"uid": job})

    def _status(self, job: str) -> Act:
        if not self._is_done(job):
            return said({"status": "processing"})
        if self.failure:
            return said({"status": "error", "message": self.failure})
        return said({"status": "completed", "model_base64": base64.b64encode(self.begun[job]["file"]).decode()})


class TencentWire(Wire):
    """``POST /`` with ``X-TC-Action``; the signature is checked as far as its form goes."""

    name = "hunyuan3d"
    begin_path = "/"

    def adapter(self, web: Web) -> ModelMaker:
        return Hunyuan3DCloud(web, TencentKey("AKIDexample", SECRET_KEY))

    def open(self) -> None:
        self.site.pages["/"] = self._act

    def poll_path(self, job: str) -> str:
        return "/"

    def _act(self, hit: Hit) -> Act:
        signed = hit.headers["authorization"].startswith("TC3-HMAC-SHA256 Credential=AKIDexample/")
        if not signed or hit.headers["x-tc-version"] != "2025-05-13":
            return said({"Response": {"Error": {"Code": "AuthFailure.SignatureFailure", "Message": "no"}}})
        if hit.headers["x-tc-action"] == "SubmitHunyuanTo3DProJob":
            return said({"Response": {"JobId": self._new(hit.json, hit.json["ImageBase64"]), "RequestId": "r"}})
        job = hit.json["JobId"]
        if not self._is_done(job):
            return said({"Response": {"Status": "RUN", "ErrorCode": "", "ErrorMessage": "", "ResultFile3Ds": []}})
        if self.failure:
            return said({"Response": {"Status": "FAIL", "ErrorCode": "FailedOperation", "ErrorMessage": self.failure}})
        files = [
            {"Type": "OBJ", "Url": "https://elsewhere.example/a.zip"},
            {"Type": "GLB", "Url": self._serve_file(job)},
        ]
        return said({"Response": {"Status": "DONE", "ResultFile3Ds": files, "RequestId": "r"}})


WIRES: dict[str, type[Wire]] = {
    "meshy": MeshyWire, "trellis": TrellisWire, "hunyuan3d": HunyuanWire, "tencent": TencentWire,
}  # fmt: skip


def openai_draws(site: Site, prefix: str = "/v1") -> None:
    """Add OpenAI's image model to a site."""

    def draw(hit: Hit) -> Act:
        data = base64.b64encode(picture(hit.json["prompt"])).decode()
        return said({"created": 1, "data": [{"b64_json": data}], "output_format": "png"})

    site.pages[f"{prefix}/images/generations"] = draw


def gemini_draws(site: Site, name: str = "gemini-3-pro-image-preview") -> None:
    """Add Gemini's image model to a site."""

    def draw(hit: Hit) -> Act:
        data = base64.b64encode(picture(hit.json["contents"][0]["parts"][0]["text"])).decode()
        parts = [{"text": "Here it is."}, {"inlineData": {"mimeType": "image/png", "data": data}}]
        return said({"candidates": [{"content": {"role": "model", "parts": parts}, "finishReason": "STOP"}]})

    site.pages[f"/models/{name}:generateContent"] = draw
