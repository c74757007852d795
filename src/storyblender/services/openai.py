"""Pictures by OpenAI's image models (``/v1/images/generations``), or a server that speaks as they do."""

from __future__ import annotations

from base64 import b64decode
from typing import Final

from storyblender.errors import ServiceFailure
from storyblender.services.made_files import picture_from
from storyblender.services.making import Maker, Unusable
from storyblender.services.paid import paid_answer
from storyblender.services.web import Web

ADDRESS: Final = "https://api.openai.com/v1"
USUAL: Final = "gpt-image-1"
PRICES: Final = {"gpt-image-1": 0.042, "gpt-image-1.5": 0.034, "gpt-image-1-mini": 0.011}
"""US dollars for a picture of 1024 pixels a side in medium quality, as read in November 2026."""
_DEAREST: Final = 0.2
"""For a model whose price is not known."""


class OpenAIImages:
    """An image model of OpenAI's.

    Args:
        web: HTTP with it.
        model: Its name; empty for the usual one.
        own: Whether the server is not OpenAI's and costs nothing.
    """

    def __init__(self, web: Web, model: str = "", *, own: bool = False) -> None:
        self._web, name = web, model or USUAL
        price = 0.0 if own else PRICES.get(name, _DEAREST)
        url = "" if own else "https://openai.com/policies/services-agreement/"
        self.maker = Maker("openai", name, price, "OpenAI services agreement", url)

    def draw(self, prompt: str) -> bytes:
        """Return one picture of what a prompt describes, as PNG. Raises ServiceFailure."""
        asked = {
            "model": self.maker.model,
            "prompt": prompt,
            "n": 1,
            "size": "1024x1024",
            "quality": "medium",
            "background": "opaque",
            "output_format": "png",
        }
        answer = paid_answer(self._web, "images/generations", asked)
        try:
            return picture_from(b64decode(answer["data"][0]["b64_json"], validate=True))
        except (Unusable, LookupError, TypeError, ValueError) as error:
            problem = error.problem if isinstance(error, Unusable) else "its answer has no picture"
            raise ServiceFailure(f"openai: {problem}", uncertain=True) from error
