"""The routes of the studio: page, pictures and files of the open project, models sent to it, the wire, programs."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Awaitable, Callable, Mapping
from contextlib import suppress
from importlib.resources import files
from pathlib import Path

from pydantic import ValidationError
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, PlainTextResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketDisconnected

from storyblender.deliver.page import FILES
from storyblender.errors import InputError, StoryBlenderError
from storyblender.pipeline.asset_pictures import SHOWN
from storyblender.web_studio.access import PROGRAMS
from storyblender.web_studio.deliver import may_be_downloaded
from storyblender.web_studio.hub import Hub
from storyblender.web_studio.library import picture_of
from storyblender.web_studio.messages import CALLS, Answer, News
from storyblender.web_studio.pictures import picture_of_own
from storyblender.web_studio.uploads import TooLarge, Uploads

LARGEST_CALL = 4_500_000
"""Bytes: a long script that is dropped into the page."""
_SHOT = re.compile(r"SC\d{3,6}_SH\d{3,6}")
_MOMENT = re.compile(r"SC\d{3,6}-[0-9a-f]{8,64}-\d{1,9}")
_SHOWN = re.compile(r"[0-9a-f]{8,64}\.(?:png|glb)")
_ENTRY = re.compile(r"[0-9a-f]{64}")
_DELIVERED = frozenset(name for name, _ in FILES)
_LEFT = (WebSocketDisconnect, WebSocketDisconnected)
"""What receiving from a browser that has left raises, and sending to it."""
_NOT_THERE = PlainTextResponse("there is no such file", 404)
PAGE = Path(str(files("storyblender.web_studio") / "static"))


def build_app(hub: Hub) -> Starlette:
    """Return the application behind the door.

    Args:
        hub: Makes the calls.
    """

    async def page(request: Request) -> Response:
        return FileResponse(PAGE / "index.html")

    async def frame(request: Request) -> Response:
        name = request.path_params["name"]
        return _file(hub, f"frames/{name}.png") if _SHOT.fullmatch(name) else _NOT_THERE

    async def moment(request: Request) -> Response:
        name = request.path_params["name"]
        return _file(hub, f"build/moments/{name}.glb") if _MOMENT.fullmatch(name) else _NOT_THERE

    async def cast(request: Request) -> Response:
        name = request.path_params["name"]
        return _file(hub, f"{SHOWN}/{name}") if _SHOWN.fullmatch(name) else _NOT_THERE

    async def in_library(request: Request) -> Response:
        digest = request.path_params["digest"]
        path = await run_in_threadpool(picture_of, digest) if _ENTRY.fullmatch(digest) else None
        return FileResponse(path) if path is not None and path.is_file() else _NOT_THERE

    async def in_folder(request: Request) -> Response:
        try:
            picture = await run_in_threadpool(picture_of_own, hub.place, request.path_params["name"])
        except StoryBlenderError:
            return _NOT_THERE
        return Response(picture, media_type="image/png")

    async def delivered(request: Request) -> Response:
        name = request.path_params["name"]
        return _file(hub, name) if name in _DELIVERED or may_be_downloaded(name) else _NOT_THERE

    async def calls(request: Request) -> Response:
        said = bytearray()
        async for part in request.stream():
            said += part
            if len(said) > LARGEST_CALL:
                return PlainTextResponse("the call is too large", 413)
        answer = await _answered(hub, said.decode(errors="replace"))
        return Response(answer.model_dump_json(), media_type="application/json")

    async def wire(socket: WebSocket) -> None:
        await _serve(hub, socket)

    return Starlette(
        routes=[
            Route("/", page),
            Route("/frames/{name}.png", frame),
            Route("/previews/{name}.png", _one_of(lambda: hub.previews)),
            Route("/takes/{name}.png", _one_of(lambda: hub.takes)),
            Route("/moments/{name}.glb", moment),
            Route("/cast/{name}", cast),
            Route("/library/{digest}.png", in_library),
            Route("/folder/{name:path}", in_folder),
            Route("/models/{batch}/{name}", _keeping(hub.uploads), methods=["POST"]),
            Route(PROGRAMS, calls, methods=["POST"]),
            Route("/files/{name:path}", delivered),
            WebSocketRoute("/wire", wire),
            Mount("/static", StaticFiles(directory=PAGE)),
        ]
    )


def _one_of(pictures: Callable[[], Mapping[str, Path]]) -> Callable[[Request], Awaitable[Response]]:
    """Return what answers with one of some pictures by its name."""

    async def answer(request: Request) -> Response:
        path = pictures().get(request.path_params["name"])
        return FileResponse(path) if path is not None and path.is_file() else _NOT_THERE

    return answer


def _keeping(uploads: Uploads) -> Callable[[Request], Awaitable[Response]]:
    """Return what keeps a file of a model that the page sends."""

    async def answer(request: Request) -> Response:
        batch, name = request.path_params["batch"], request.path_params["name"]
        try:
            await uploads.receive(batch, name, request.stream())
        except InputError as error:
            return PlainTextResponse(str(error), 413 if isinstance(error, TooLarge) else 400)
        except ClientDisconnect:
            uploads.forget()
        return Response(status_code=204)

    return answer


def _file(hub: Hub, name: str) -> Response:
    """Return a file of the open project by its name in it."""
    try:
        path = hub.place.session.folder / name
    except StoryBlenderError:
        return _NOT_THERE
    return FileResponse(path) if path.is_file() and not path.is_symlink() else _NOT_THERE


async def _serve(hub: Hub, socket: WebSocket) -> None:
    """Talk with one browser until it leaves: its calls one by one, the news as they come."""
    await socket.accept()
    news = hub.join()
    telling = asyncio.create_task(_tell(socket, news))
    try:
        while True:
            answer = await _answered(hub, await socket.receive_text())
            await socket.send_text(answer.model_dump_json())
    except (*_LEFT, KeyError):  # Starlette has no text of a message in bytes
        pass
    finally:
        telling.cancel()
        hub.leave(news)


async def _answered(hub: Hub, text: str) -> Answer:
    try:
        call = CALLS.validate_json(text)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        where = ".".join(str(part) for part in first["loc"])
        return Answer(id=_number_in(text), ok=False, error=f"{where or 'the message'}: {first['msg']}")
    return await hub.answer(call)


def _number_in(text: str) -> int:
    """Return the number of a call that cannot be read, if that can be."""
    found = re.search(r'"id"\s*:\s*(\d{1,15})', text[:LARGEST_CALL])
    return int(found[1]) if found else 0


async def _tell(socket: WebSocket, news: asyncio.Queue[News]) -> None:
    with suppress(*_LEFT):
        while True:
            await socket.send_text((await news.get()).model_dump_json(exclude_defaults=True))
