"""What a person types about a camera becomes a decision; a word that is not in the vocabulary is refused."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import get_args

from pydantic import ValidationError

from storyblender.errors import InputError
from storyblender.memory.shot_context import CameraDecision
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, CameraDirection, Movement, ShotKind

Word = str | float | Sequence[str] | Mapping[str, object]
CHOICES = {
    "size": get_args(ShotSize),
    "angle": get_args(Angle),
    "movement": get_args(Movement),
    "kind": get_args(ShotKind),
}


def camera_decision(words: Mapping[str, Word]) -> CameraDecision:
    """Read what a person says about a camera.

    Args:
        words: Fields of ``CameraDecision``; ``movement`` may end in its direction, as in ``pan left``.

    Raises:
        InputError: A word is not in the vocabulary.
    """
    said = dict(words)
    move, _, way = str(words.get("movement", "")).rpartition(" ")
    if way in get_args(CameraDirection):
        said |= {"movement": move, "direction": way}
    if "kind" in said:
        said["kind"] = str(said["kind"]).lower().replace("-", "_")
    try:
        return CameraDecision.model_validate(said)
    except ValidationError as error:
        fault = error.errors()[0]
        name = str(fault["loc"][0])
        given = words.get(name, "")
        if name in CHOICES:
            mend = f"it is one of: {', '.join(CHOICES[name])}"
        elif name == "lens":
            mend = "it is a number of mm, 4 to 1200"
        else:
            mend = fault["msg"][:1].lower() + fault["msg"][1:]
        raise InputError(f"{name.replace('_', ' ')} cannot be {given!r}", mend=mend) from error
