"""The picture that a model is made of: what is measured of it, who looks at it, and when it is drawn again."""

from __future__ import annotations

import io
import json
from collections.abc import Callable

import pytest
from PIL import Image, ImageDraw
from tests.answering import Scripted
from tests.crew import RULES

from storyblender.agents.concept_artist.reference_picture import (
    ReferencePicture,
    ReferencePictureView,
    with_picture_critic,
)
from storyblender.errors import AnswerAwaited, NoAnswer
from storyblender.memory.asset_sheet import Asset
from storyblender.reflection import Outcome, reflect

SAMOVAR = Asset(asset_id="samovar", asset_type="object", description="a brass samovar", name="samovar")
PROMPT = "A single object: a brass samovar."


def drawn(*places: tuple[int, int, int, int], paper: str = "white") -> bytes:
    """Return a PNG of 200 pixels a side with brown boxes in it."""
    image = Image.new("RGB", (200, 200), paper)
    for place in places:
        ImageDraw.Draw(image).rectangle(place, "saddlebrown")
    out = io.BytesIO()
    image.save(out, "PNG")
    return out.getvalue()


WHOLE, CUT, EMPTY = drawn((60, 40, 140, 160)), drawn((0, 40, 199, 199)), drawn()


class Painter:
    """Returns pictures one after the other, each once for a prompt."""

    def __init__(self, *pictures: bytes) -> None:
        self._left, self.prompts = list(pictures), dict[str, bytes]()

    def __call__(self, prompt: str) -> bytes:
        if prompt not in self.prompts:
            if not self._left:
                raise NoAnswer("the limit of 5 dollars is reached")
            self.prompts[prompt] = self._left.pop(0)
        return self.prompts[prompt]


def outcome(
    paint: Callable[[str], bytes], *answers: str | Exception
) -> Outcome[ReferencePictureView, ReferencePicture]:
    role = RULES.reference_picture
    if answers:
        role = with_picture_critic(Scripted(answers), role)
    return reflect(role, "samovar", role.project(SAMOVAR, PROMPT, paint))


def said(score: float, *faults: str) -> str:
    return json.dumps({"score": score, "faults": [{"message": fault} for fault in faults]})


def test_a_sound_picture_is_drawn_once() -> None:
    painter = Painter(WHOLE)
    assert outcome(painter).draft.prompt == PROMPT
    assert len(painter.prompts) == 1


@pytest.mark.parametrize("paper", ["white", "black", "lightgrey"])
def test_the_background_need_not_be_white(paper: str) -> None:
    assert outcome(Painter(drawn((60, 40, 140, 160), paper=paper))).critique.score == 10


def test_what_is_cut_off_is_drawn_again_with_what_was_wrong() -> None:
    painter = Painter(CUT, WHOLE)
    found = outcome(painter)
    assert found.critique.score == 10
    assert found.draft.prompt.startswith(PROMPT) and "whole in the picture" in found.draft.prompt


def test_of_nothing_no_model_is_made() -> None:
    assert outcome(Painter(EMPTY, EMPTY, EMPTY)).critique.score < 8


def test_the_lower_of_two_scores_counts_and_three_pictures_are_the_most() -> None:
    painter = Painter(WHOLE, WHOLE, WHOLE, WHOLE)
    faults = ("it has no tap", "it has two taps", "its tap floats")
    found = outcome(painter, *(said(score, fault) for score, fault in zip((5, 7, 6), faults, strict=True)))
    assert (found.critique.score, found.turns) == (7, 1)
    assert len(painter.prompts) == 3
    assert "it has no tap" in list(painter.prompts)[1]


def test_who_looks_is_shown_the_picture_and_told_what_it_should_be() -> None:
    critic = Scripted([said(9)])
    role = with_picture_critic(critic, RULES.reference_picture)
    reflect(role, "samovar", role.project(SAMOVAR, PROMPT, Painter(WHOLE)))
    (request,) = critic.asked
    assert (request.role, request.pictures[0].png, request.pictures_needed) == ("asset_critic", WHOLE, True)
    assert json.loads(request.view) == {"object": "samovar", "description": "a brass samovar", "prompt": PROMPT}
    assert "image-to-3D" in request.instructions


def test_without_an_answer_the_measurements_decide() -> None:
    assert outcome(Painter(WHOLE), NoAnswer("nobody is there")).critique.score == 10


def test_an_answer_that_is_awaited_stops_the_run() -> None:
    with pytest.raises(AnswerAwaited):
        outcome(Painter(WHOLE), AnswerAwaited("it waits", mend="answer", names=("a",)))


def test_a_limit_ends_it_with_the_best_picture() -> None:
    assert outcome(Painter(CUT)).draft.prompt == PROMPT
