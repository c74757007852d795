"""Text-to-image prompts for the things that no source has (paper, appendix: prompt of the Asset Generator).

Something stands in for such a thing. Its prompt makes a picture in any image service, and that a model in any
image-to-3D service; an artist pastes it, or a source of assets sends it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Literal

from storyblender.memory.asset_sheet import PROMPT_LENGTH, Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.vocabulary import Age
from storyblender.reflection import Critique, Fault

ImagePrompts = dict[str, str]
"""Prompts by asset id."""
ImageView = Literal["three-quarter", "side", "front"]

PERIODS: Final[Mapping[Age, str]] = {
    "medieval": "medieval",
    "west": "from the American West of about 1880",
    "victorian": "from the nineteenth century",
    "classic": "from the middle of the twentieth century",
    "space": "from a far future",
    "today": "of today",
}
"""What comes from a time, for image models."""
_VIEWS: Final[Mapping[ImageView, str]] = {
    "three-quarter": "three-quarter view from the front, slightly from above",
    "side": "exact side view",
    "front": "exact front view",
}
_LEAST: Final = 12
"""Letters of the shortest description that says anything."""


@dataclass(frozen=True)
class ImagePromptView:
    """What the Asset Generator sees.

    Attributes:
        assets: The things that something else stands in for.
        title: Of the story.
        summary: What it is about.
        age: When it plays.
        lines: The first lines of the script with each thing, by asset id.
    """

    assets: tuple[Asset, ...]
    title: str = ""
    summary: str = ""
    age: Age | None = None
    lines: Mapping[str, tuple[str, ...]] | None = None


def image_prompt_view(graph: ContinuityMemoryGraph, assets: Sequence[Asset]) -> ImagePromptView:
    """Return the Asset Generator's projection of the graph.

    Args:
        graph: With the Director's plan.
        assets: The things that something else stands in for.
    """
    lines = {asset.asset_id: _lines_with(graph.outline, asset.name) for asset in assets}
    return ImagePromptView(tuple(assets), graph.title, graph.story_summary, graph.age, lines)


def _lines_with(outline: Sequence[SceneOutline], name: str) -> tuple[str, ...]:
    """Return the first lines of the script that have a name."""
    lines = (line.text for scene in outline for shot in scene.shots for line in shot.lines)
    return tuple(text for text in lines if name and name.lower() in text.lower())[:3]


def image_prompt(asset: Asset, looks: str, view: ImageView = "three-quarter") -> str:
    """Return the prompt for one thing: what it looks like, and what every such picture has to have.

    Args:
        asset: The thing.
        looks: What it is and looks like, in one or more sentences.
        view: The side that shows most of it.
    """
    words = " ".join(asset.writing.split())
    writing = f"The only writing on it is “{words}”." if words else "No writing and no logo on it."
    parts = [
        f"A single object: {looks.strip().rstrip('.')}.",
        f"{_VIEWS[view].capitalize()}; the whole object in the picture, centred, with a clear margin on all sides.",
        "Plain white background, no ground, no shadow, soft even light from all sides.",
        "Realistic proportions, true colours, distinct materials, clean shapes that are easy to model.",
        f"One object only: no people, no hands, nothing beside it, no smoke, no fire, no motion blur. {writing}",
    ]
    return " ".join(parts)[:PROMPT_LENGTH]


class RulesImagePrompts:
    """The prompts from the script's own words."""

    def propose(self, view: ImagePromptView) -> ImagePrompts:
        """Return a prompt for every thing: its description, or its name, and the period of the story."""
        return {asset.asset_id: image_prompt(asset, plain_looks(asset, view.age)) for asset in view.assets}

    def refine(self, draft: ImagePrompts, critique: Critique, view: ImagePromptView) -> ImagePrompts:
        """Return the draft with the prompts that are missing.

        Args:
            draft: Prompts by asset id.
            critique: Its faults.
            view: The things.
        """
        return self.propose(view) | draft


def plain_looks(asset: Asset, age: Age | None) -> str:
    """Return what a thing looks like in the script's words.

    Args:
        asset: The thing.
        age: When the story plays; None leaves the period out.
    """
    name, told = asset.name or asset.asset_id.replace("_", " "), " ".join(asset.description.split())
    looks = told if name.lower() in told.lower() else f"{name}, {told}" if told else name
    return f"{looks.rstrip('.')}, {PERIODS[age]}" if age is not None else looks


class ImagePromptCritic:
    """Checks that every thing has a prompt that says something."""

    def judge(self, draft: ImagePrompts, view: ImagePromptView) -> Critique:
        """Return the critique of prompts.

        Args:
            draft: Prompts by asset id.
            view: The things.
        """
        missing = (each.asset_id for each in view.assets if len(draft.get(each.asset_id, "")) < _LEAST)
        faults = (
            Fault(kind="missing", message=f"{name} has no prompt", subject=name, severity=3.0) for name in missing
        )
        return Critique.of(tuple(faults))
