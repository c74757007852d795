"""The Asset Formatter played by a language model: it looks at six views and says which are the front and the top."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final, Literal

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.concept_artist.asset_formatter import AssetFormatterView, pose_problem
from storyblender.agents.side_views import side_sheet
from storyblender.memory.asset_sheet import ModelPose, ModelSide
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

_Letter = Literal["A", "B", "C", "D", "E", "F"]
_SIDES: Final[Mapping[str, ModelSide]] = {
    "A": "right", "B": "left", "C": "back", "D": "front", "E": "top", "F": "bottom",
}  # fmt: skip
"""Side of the file by the letter of its view (paper, appendix: prompt of the Asset Formatter)."""


class PoseNotes(Notes):
    """Which views show the front and the top of a model."""

    front: _Letter | Literal["ambiguous"] = "ambiguous"
    """The view that shows its front; `ambiguous` if it has none, as a vase."""
    top: _Letter
    """The view that shows what is up when it stands, lies or hangs as it is used."""


def language_asset_formatter(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[AssetFormatterView, ModelPose]:
    """Return the Asset Formatter played by a model.

    Args:
        answerer: The model, or a person in its place.
        embedder: Not used: there is no long vocabulary to choose from.
    """
    return LanguagePolicy(
        Asker(answerer, "asset_formatter", PoseNotes),
        show=_shown,
        draft_of=lambda answer, view: _pose(answer),
        check=_wrong,
        subject=lambda view: view.file,
        pictures=lambda view: (side_sheet(view.look(), _SIDES, "six_views"),),
        pictures_needed=True,
    )


def _shown(view: AssetFormatterView) -> dict[str, Any]:
    return {"file": view.file} | ({"thing": view.thing} if view.thing else {})


def _wrong(answer: PoseNotes, view: AssetFormatterView) -> Iterator[str]:
    if problem := pose_problem(_pose(answer)):
        yield f"{problem}: {answer.front} and {answer.top}"


def _pose(answer: PoseNotes) -> ModelPose:
    return ModelPose(front=_SIDES.get(answer.front), top=_SIDES[answer.top])
