"""Pictures by Google's Gemini image models (``generateContent`` of the Gemini API, v1beta)."""

from __future__ import annotations

from base64 import b64decode
from typing import Any, Final

from storyblender.errors import ServiceFailure
from storyblender.services.made_files import picture_from
from storyblender.services.making import Maker, Unusable
from storyblender.services.offers import line_of
from storyblender.services.paid import paid_answer
from storyblender.services.web import Web

ADDRESS: Final = "https://generativelanguage.googleapis.com/v1beta"
KEY_HEADER: Final = "x-goog-api-key"
USUAL: Final = "gemini-3-pro-image-preview"
PRICES: Final = {
    "gemini-3-pro-image-preview": 0.134, "gemini-3.1-flash-image-preview": 0.067, "gemini-2.5-flash-image": 0.039,
}  # fmt: skip
"""US dollars for a picture of 1024 pixels a side, as read in November 2026."""


class GeminiImages:
    """An image model of Google's.

    Args:
        web: HTTP with it.
        model: Its name; empty for the usual one.
        own: Whether the server is not Google's and costs nothing.
    """

    def __init__(self, web: Web, model: str = "", *, own: bool = False) -> None:
        self._web, name = web, model or USUAL
        price = 0.0 if own else PRICES.get(name, max(PRICES.values()))
        url = "" if own else "https://ai.google.dev/gemini-api/terms"
        self.maker = Maker("gemini", name, price, "Gemini API terms", url)

    def draw(self, prompt: str) -> bytes:
        """Return one picture of what a prompt describes, as PNG. Raises ServiceFailure."""
        asked = {
            "contents": [{"role": "user", "parts": [{"text": prompt}]}],
            "generationConfig": {"responseModalities": ["IMAGE"], "imageConfig": {"aspectRatio": "1:1"}},
        }
        answer = paid_answer(self._web, f"models/{self.maker.model}:generateContent", asked)
        try:
            return picture_from(_picture_in(answer))
        except Unusable as error:
            raise ServiceFailure(f"gemini: {error.problem}", uncertain=True) from error


def _picture_in(answer: Any) -> bytes:
    """Return the picture in an answer. Raises ServiceFailure where the model refused, Unusable where it is none."""
    try:
        candidates = answer.get("candidates") or []
        parts = (candidates[0].get("content") or {}).get("parts") or [] if candidates else []
        data = next((part["inlineData"]["data"] for part in parts if "inlineData" in part), None)
        blocked = (answer.get("promptFeedback") or {}).get("blockReason")
        reason = blocked or (candidates[0].get("finishReason") if candidates else "")
        if data is None:
            raise ServiceFailure(f"gemini: it drew no picture ({line_of(reason, 60) or 'it does not say why'})")
        return b64decode(data, validate=True)
    except (AttributeError, KeyError, TypeError, IndexError, ValueError) as error:
        raise Unusable("its answer is not of the form that it should have") from error
