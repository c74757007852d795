"""Motion by hand as data: named by its content, whole or refused, a later one on top."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from storyblender.memory.motion_by_hand import HandChannel, MotionByHand, by_hand_file

NOD = HandChannel(frames=(0, 12), values=((1, 0, 0, 0), (0.99, 0.14, 0, 0)))
STEP = HandChannel(frames=(3,), values=((1.5, -2, 0, 0.3),))


def test_it_is_named_by_its_content() -> None:
    one = MotionByHand(channels={"head": NOD, "root": STEP})
    other = MotionByHand(channels={"root": STEP, "head": NOD})
    assert one.digest == other.digest == MotionByHand.model_validate_json(one.model_dump_json()).digest
    assert one.digest != MotionByHand(channels={"head": NOD}).digest
    assert by_hand_file(one.digest) == f"by_hand/{one.digest}.json"


def test_a_later_one_lies_over_it_channel_by_channel() -> None:
    shake = NOD.model_copy(update={"values": ((1, 0, 0, 0), (0.99, 0, 0.14, 0))})
    both = MotionByHand(channels={"head": NOD, "root": STEP}).then(MotionByHand(channels={"head": shake}))
    assert both.channels == {"head": shake, "root": STEP}


@pytest.mark.parametrize(
    "channels",
    [
        {},
        {"../head": {"frames": [0], "values": [[1, 0, 0, 0]]}},
        {"head": {"frames": [], "values": []}},
        {"head": {"frames": [0, 0], "values": [[1, 0, 0, 0]] * 2}},
        {"head": {"frames": [0, 4], "values": [[1, 0, 0, 0]]}},
        {"head": {"frames": [0], "values": [[1, 0, 0]]}},
        {"hips_place": {"frames": [0], "values": [[1, 0, 0, 0]]}},
        {"root": {"frames": [0], "values": [[float("nan"), 0, 0, 0]]}},
        {"root": {"frames": [-1], "values": [[0, 0, 0, 0]]}},
    ],
)
def test_what_is_not_whole_is_refused(channels: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        MotionByHand.model_validate({"channels": channels})
