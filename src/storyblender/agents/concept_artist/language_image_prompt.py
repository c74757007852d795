"""The Asset Generator's prompts written by a language model: what each thing looks like, all in one request."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, Any

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.concept_artist.image_prompt import (
    ImagePrompts,
    ImagePromptView,
    ImageView,
    RulesImagePrompts,
    image_prompt,
)
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Identifier
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy


class LooksNotes(Notes):
    """How one thing looks."""

    id: Identifier
    looks: Annotated[str, Field(min_length=20, max_length=900)]
    """One to three sentences: what it is, period, shape and parts, materials and colours."""
    view: ImageView = "three-quarter"
    """The side that shows most of it."""


class ImagePromptNotes(Notes):
    """How things look; one that is left out is described in the script's words."""

    things: tuple[LooksNotes, ...] = ()


def language_image_prompts(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[ImagePromptView, ImagePrompts]:
    """Return the Asset Generator whose prompts a model writes; what every picture has to have is added by code.

    Args:
        answerer: The model, or a person in its place.
        embedder: Not used: there is no vocabulary to choose from.
    """
    rules = RulesImagePrompts()
    return LanguagePolicy(
        Asker(answerer, "asset_generator", ImagePromptNotes),
        show=_shown,
        draft_of=lambda answer, view: rules.propose(view) | _written(answer, view),
        check=_wrong,
        subject=lambda view: "assets",
        mend=rules.refine,
    )


def _written(answer: ImagePromptNotes, view: ImagePromptView) -> ImagePrompts:
    """Return the prompts of an answer."""
    assets = {asset.asset_id: asset for asset in view.assets}
    return {each.id: image_prompt(assets[each.id], " ".join(each.looks.split()), each.view) for each in answer.things}


def _wrong(answer: ImagePromptNotes, view: ImagePromptView) -> Iterator[str]:
    """Yield a sentence for each thing that does not exist or is described twice."""
    known, given = {asset.asset_id for asset in view.assets}, [each.id for each in answer.things]
    for name in dict.fromkeys(given):
        if name not in known:
            yield f"{name!r} is not in `things`; leave it out"
        if given.count(name) > 1:
            yield f"{name} is described {given.count(name)} times; describe it once"


def _shown(view: ImagePromptView) -> dict[str, Any]:
    """Return what the model is shown of the story and its things."""
    shown = {
        "title": view.title,
        "summary": view.summary,
        "period": view.age or "",
        "things": [_shown_thing(asset, (view.lines or {}).get(asset.asset_id, ())) for asset in view.assets],
    }
    return {name: value for name, value in shown.items() if value}


def _shown_thing(asset: Asset, lines: tuple[str, ...]) -> dict[str, Any]:
    """Return what the model is shown of a thing."""
    shown: dict[str, Any] = {
        "id": asset.asset_id,
        "name": asset.name,
        "description": asset.description,
        "kind": next(iter(asset.tags), ""),
        "writing": asset.writing,
        "size": asset.stated_size.model_dump(exclude_defaults=True),
        "lines": lines,
    }
    return {name: value for name, value in shown.items() if value}
