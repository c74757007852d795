"""Image models over real sockets: a picture that was paid for arrives once, or is known to be in doubt."""

from __future__ import annotations

import base64
import io
import struct
import zlib
from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from PIL import Image

from storyblender.errors import ServiceFailure
from storyblender.services.gemini import GeminiImages
from storyblender.services.made_files import picture_from
from storyblender.services.making import ImageModel, Unusable
from storyblender.services.openai import OpenAIImages
from storyblender.services.web import Web
from tests.services.makers import SECRET, gemini_draws, openai_draws, picture
from tests.services.site import QUICK, Cut, Late, Reply, Site, said, serving

PATIENT, HASTY = replace(QUICK, silence=10, answer=20), replace(QUICK, silence=0.3, answer=0.6)


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        openai_draws(site, "")
        gemini_draws(site)
        yield site


KINDS: dict[str, tuple[Callable[[Web], ImageModel], str, str]] = {
    "openai": (OpenAIImages, "/images/generations", "authorization"),
    "gemini": (GeminiImages, "/models/gemini-3-pro-image-preview:generateContent", "x-goog-api-key"),
}


@pytest.fixture(params=KINDS)
def kind(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture
def image_model(kind: str, site: Site) -> ImageModel:
    make, _, header = KINDS[kind]
    return make(Web(kind, site.address, {header: SECRET}, patience=PATIENT))


def pixels(png: bytes) -> tuple[int, int]:
    with Image.open(io.BytesIO(png)) as image:
        assert image.format == "PNG"
        return image.size


def test_a_prompt_becomes_a_picture(kind: str, image_model: ImageModel, site: Site) -> None:
    assert pixels(image_model.draw("a samovar")) == (256, 256)
    (hit,) = site.hits
    assert (hit.path, "a samovar" in hit.body.decode()) == (KINDS[kind][1], True)
    assert hit.headers[KINDS[kind][2]] == SECRET


UNKNOWN = [Reply(status=500), Cut(share=-1), Cut(), Reply(b"no JSON"), said([]), Late(5)]


@pytest.mark.parametrize("act", UNKNOWN, ids=str)
def test_what_may_have_been_drawn_is_not_drawn_again(kind: str, site: Site, act: Reply) -> None:
    make, path, _ = KINDS[kind]
    site.pages[path] = act
    with pytest.raises(ServiceFailure, match=f"^{kind}: ") as told:
        make(Web(kind, site.address, patience=HASTY if isinstance(act, Late) else PATIENT)).draw("a samovar")
    assert told.value.uncertain
    assert len(site.hits) == 1


def test_too_many_requests_pass(kind: str, image_model: ImageModel, site: Site) -> None:
    path = KINDS[kind][1]
    good = site.pages[path]
    acts = iter([Reply(status=429), Reply(status=429)])
    site.pages[path] = lambda hit: next(acts, None) or good(hit)  # type: ignore[operator]
    assert image_model.draw("a samovar")
    assert len(site.hits) == 3


REFUSALS = {
    "openai": [
        said({"error": {"code": "moderation_blocked", "message": "rejected by the safety system"}}, 400),
        said({"error": {"code": "billing_hard_limit_reached", "message": "Billing hard limit"}}, 400),
        said({"error": {"code": "insufficient_quota", "message": "quota"}}, 429),
        said({"error": {"message": f"Incorrect API key {SECRET}"}}, 401),
    ],
    "gemini": [
        said({"promptFeedback": {"blockReason": "PROHIBITED_CONTENT"}}),
        said({"candidates": [{"finishReason": "IMAGE_SAFETY"}]}),
        said({"candidates": [{"content": {"parts": [{"text": "I can not."}]}, "finishReason": "STOP"}]}),
        said({"error": {"code": 400, "message": f"API key not valid: {SECRET}", "status": "INVALID_ARGUMENT"}}, 400),
        said({"error": {"code": 403, "message": "denied"}}, 403),
    ],
}


def test_a_refusal_is_known_to_be_one(kind: str, image_model: ImageModel, site: Site) -> None:
    for act in REFUSALS[kind]:
        site.pages[KINDS[kind][1]] = act
        with pytest.raises(ServiceFailure) as told:
            image_model.draw("a samovar")
        assert not told.value.uncertain, act
        assert SECRET not in str(told.value)
        assert "\n" not in str(told.value)


def bomb(side: int) -> bytes:
    """Return a PNG of few bytes and very many pixels."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    rows = zlib.compress(bytes(1000))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


NO_PICTURES = {
    "text": b"no picture",
    "nothing": b"",
    "a bomb": bomb(30_000),
    "a large one": bomb(6_000),
    "cut": picture()[:300],
    "tiny": picture(size=64),
    "svg": b"<svg xmlns='http://www.w3.org/2000/svg'><script>alert(1)</script></svg>",
    "gif": b"GIF89a" + bytes(100),
}


@pytest.mark.parametrize("data", NO_PICTURES.values(), ids=NO_PICTURES.keys())
def test_what_is_no_picture_is_refused(data: bytes, image_model: ImageModel, kind: str, site: Site) -> None:
    with pytest.raises(Unusable):
        picture_from(data)
    coded = base64.b64encode(data).decode()
    answers = {
        "openai": {"data": [{"b64_json": coded}]},
        "gemini": {"candidates": [{"content": {"parts": [{"inlineData": {"data": coded}}]}}]},
    }
    site.pages[KINDS[kind][1]] = said(answers[kind])
    with pytest.raises(ServiceFailure) as told:
        image_model.draw("a samovar")
    assert told.value.uncertain, "it was paid"


def test_a_picture_has_nothing_in_it_but_pixels() -> None:
    image = Image.new("RGBA", (2000, 1000), (255, 0, 0, 0))
    out = io.BytesIO()
    image.save(out, "WEBP", exif=b"Exif\x00\x00secret", lossless=True)
    png = picture_from(out.getvalue())
    assert pixels(png) == (1536, 768)
    assert b"secret" not in png
    with Image.open(io.BytesIO(png)) as opened:
        assert opened.convert("RGB").getpixel((5, 5)) == (255, 255, 255), "what is clear is white"
