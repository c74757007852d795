"""The picture that a model is made of: drawn, examined, drawn again with what was wrong (paper, section 3.3).

"Anchoring 3D generation on a strictly validated 2D proxy": no model is made of a picture under 8 of 10.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from storyblender.agents.asking import Asker
from storyblender.agents.concept_artist.asset_critic import AssetCriticNotes
from storyblender.agents.vision_critic import VisionCritic
from storyblender.errors import NoAnswer
from storyblender.memory.asset_sheet import PROMPT_LENGTH, Asset
from storyblender.memory.base import Frozen
from storyblender.memory.request import Picture
from storyblender.ports import Answerer
from storyblender.reflection import UNUSABLE, Critique, Fault, Role

MOST_PICTURES: Final = 3
"""Of one thing: each costs."""
_PLAIN: Final = 24
"""Most by which a value of 0 to 255 of a plain background differs from that of its middle."""
_CUT: Final = 0.12
"""Share of the picture's edge that may be covered: more, and the thing is cut off or the background is no plain one."""
_LEAST: Final = 0.01
"""Share of the picture that has to differ from its background."""


def nothing_painted(prompt: str) -> bytes:
    """Refuse to draw: there is no image model. Raises NoAnswer."""
    raise NoAnswer("there is no image model")


class ReferencePicture(Frozen):
    """A picture that was drawn; its pixels are found by the prompt."""

    prompt: str


class ReferencePictureView(Frozen):
    """What there is to draw."""

    asset: Asset
    prompt: str
    """What the Asset Generator wrote."""
    paint: Callable[[str], bytes] = Field(default=nothing_painted, exclude=True, repr=False)
    """Returns the picture of a prompt as PNG, each drawn once. Raises NoAnswer."""


def reference_picture_view(asset: Asset, prompt: str, paint: Callable[[str], bytes]) -> ReferencePictureView:
    """Return the projection of a thing that is to be drawn.

    Args:
        asset: The thing.
        prompt: What it looks like.
        paint: Draws. Raises NoAnswer.
    """
    return ReferencePictureView(asset=asset, prompt=prompt, paint=paint)


class PaintedByPrompt:
    """Draws a thing by its prompt, and again with what was wrong with the picture before."""

    def propose(self, view: ReferencePictureView) -> ReferencePicture:
        """Return the picture of the prompt. Raises NoAnswer."""
        view.paint(view.prompt)
        return ReferencePicture(prompt=view.prompt)

    def refine(self, draft: ReferencePicture, critique: Critique, view: ReferencePictureView) -> ReferencePicture:
        """Return a picture of the prompt with what it has to avoid; the draft if nothing is wrong with that.

        Args:
            draft: The picture before.
            critique: Its faults.
            view: The thing.

        Raises:
            NoAnswer: It cannot be drawn.
        """
        faults = " ".join(fault.message.rstrip(".") + "." for fault in critique.faults)
        if not faults:
            return draft
        prompt = f"{view.prompt} A picture before was wrong, avoid this: {faults}"[:PROMPT_LENGTH]
        view.paint(prompt)
        return ReferencePicture(prompt=prompt)


class ReferencePictureCritic:
    """Measures whether a picture has one thing in it, whole, before a plain background."""

    def judge(self, draft: ReferencePicture, view: ReferencePictureView) -> Critique:
        """Return the critique of a picture.

        Args:
            draft: The picture.
            view: The thing.
        """
        return Critique.of(tuple(_faults(_pixels(view.paint(draft.prompt)), view.asset.asset_id)))


def with_picture_critic(
    answerer: Answerer, role: Role[..., ReferencePictureView, ReferencePicture]
) -> Role[..., ReferencePictureView, ReferencePicture]:
    """Return the role with a vision critic beside its own, who is the one that examines assets.

    Args:
        answerer: The model, or a person in its place.
        role: That draws.
    """
    eyes = VisionCritic(
        engine=role.critic,
        asker=Asker(answerer, "asset_critic", AssetCriticNotes, instructions="picture_critic"),
        subject=lambda view: view.asset.asset_id,
        show=_shown,
        pictures=lambda draft, view: (Picture(name="drawn", png=view.paint(draft.prompt)),),
        ids=lambda view: (view.asset.asset_id,),
    )
    return replace(role, critic=eyes)


def _shown(draft: ReferencePicture, view: ReferencePictureView) -> Mapping[str, Any]:
    """Return what the critic is told."""
    what = "person" if view.asset.asset_type == "character" else "object"
    told = {what: view.asset.name or view.asset.asset_id, "description": view.asset.description}
    return {name: value for name, value in {**told, "prompt": view.prompt}.items() if value}


def _pixels(png: bytes) -> NDArray[np.int16]:
    """Return (h, w, 3) values of 0 to 255."""
    from PIL import Image

    with Image.open(io.BytesIO(png)) as image:
        return np.asarray(image.convert("RGB"), np.int16)


def _faults(pixels: NDArray[np.int16], asset_id: str) -> Iterator[Fault]:
    """Yield what is wrong with a picture, as far as it can be measured."""
    edge = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
    background = np.median(edge, axis=0)
    if (np.abs(pixels - background).max(axis=2) > _PLAIN).mean() < _LEAST:
        yield Fault(kind="empty", subject=asset_id, message="there is nothing in the picture", severity=UNUSABLE)
    elif (np.abs(edge - background).max(axis=1) > _PLAIN).mean() > _CUT:
        message = "what is drawn has to be whole in the picture, with a clear margin, before a plain white background"
        yield Fault(kind="cut", subject=asset_id, message=message, severity=2.5)
