"""Every word that an edit, an agent or a model can name has a sentence."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, get_args

from storyblender.agents.layout_artist.camera_operator import FIX_WORDS, OPERATION_WORDS, OPERATIONS
from storyblender.agents.layout_artist.language_camera_operator import Operation
from storyblender.agents.vocabulary import vocabulary
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.sets import SETS
from storyblender.memory.edits import Edit
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, CameraDirection, Movement, ShotKind


def _silent(words: Any, where: str = "") -> Iterator[str]:
    if isinstance(words, dict):
        for name, each in words.items():
            yield from _silent(each, f"{where}.{name}")
    elif not words:
        yield where


def test_every_word_has_a_sentence() -> None:
    assert not list(_silent(vocabulary()))


def test_it_has_every_word_that_can_be_named() -> None:
    told = vocabulary()
    kinds = get_args(get_args(Edit)[0])
    assert set(told["edits"]) == {kind.model_fields["kind"].default for kind in kinds}
    for kind in kinds:
        assert kind.model_fields.keys() <= told["edits"][kind.model_fields["kind"].default]["fields"].keys()
    camera = {"kind": ShotKind, "size": ShotSize, "angle": Angle, "movement": Movement, "direction": CameraDirection}
    for field, choices in camera.items():
        assert set(told["camera"][field]) == set(get_args(choices)), field
    assert set(told["motions"]) == set(MOTIONS) and set(told["sets"]) == set(SETS)


def test_operations_of_models_and_code_are_the_same() -> None:
    assert set(OPERATION_WORDS) == set(OPERATIONS) == set(get_args(Operation))
    assert {"azimuth", "elevation", "dolly", "pan_x", "pan_y", "roll", "ops"} == set(FIX_WORDS)
