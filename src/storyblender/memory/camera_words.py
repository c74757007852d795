"""A camera in one sentence, for the lists that are delivered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from storyblender.memory.shot_context import CameraInstruction
from storyblender.memory.shot_sizes import SIZES
from storyblender.memory.vocabulary import Movement

_KINDS: Final = {"two_shot": "two-shot", "group": "group shot"}
_MOVES: Final[dict[Movement, str]] = {
    "push in": "slow push in",
    "pull out": "slow pull out",
    "pan": "panning",
    "tilt": "tilting",
}
_SHALLOW: Final = 2.0
_DEEP: Final = 16.0
"""f-numbers up to which focus is called shallow, and from which it is called deep."""


def camera_sentence(instruction: CameraInstruction, names: Mapping[str, str], place: str) -> str:
    """Return one sentence, e.g. ``A static medium close-up of Ilsa over Rick's shoulder, eye-level.``

    Args:
        instruction: The camera.
        names: Asset id to what people call it.
        place: What the shot shows if no person is in focus.
    """
    form = SIZES[instruction.size].words
    if instruction.kind in _KINDS:
        form = form.removesuffix(" shot") + " " + _KINDS[instruction.kind]
    elif instruction.kind in ("insert", "establishing"):
        form = f"{instruction.kind} {form}"
    still = instruction.movement == "static"
    form = f"static {form}" if still else form
    shown = listed([names.get(each, each) for each in instruction.focus_on_ids]) or place or "the place"
    shown = f"{shown}'s {instruction.detail}" if instruction.detail else shown
    sentence = f"{'An' if form[0] in 'aeiou' else 'A'} {form} of {shown}"
    if instruction.over_id:
        sentence += f" over {names.get(instruction.over_id, instruction.over_id)}'s shoulder"
    if instruction.behind:
        sentence += " from behind"
    if instruction.pov_id:
        sentence += f" as {names.get(instruction.pov_id, instruction.pov_id)} sees it"
    move = "" if still else _MOVES.get(instruction.movement, instruction.movement)
    details = [f"{move} {instruction.direction or ''}".strip(), instruction.angle, *_focus_words(instruction, names)]
    sentence += ", ".join(["", *filter(None, details)])
    return sentence + (f" (script: {instruction.order})" if instruction.order else "") + "."


def _focus_words(instruction: CameraInstruction, names: Mapping[str, str]) -> list[str]:
    """Return what is special about the focus, e.g. ``shallow focus on Ana`` or ``rack focus from Ana to Ben``."""
    first, last = (names.get(each or "", each or "") for each in (instruction.focus, instruction.focus_to))
    f_number = instruction.f_number
    words: list[str] = []
    if last:
        words.append(f"rack focus from {first} to {last}" if first else f"rack focus to {last}")
    elif f_number is not None or first:
        depth = "" if f_number is None else "shallow " if f_number <= _SHALLOW else "deep " if f_number >= _DEEP else ""
        words.append(f"{depth}focus on {first}" if first else f"{depth}focus" if depth else f"f/{f_number:g}")
    return words + (["soft focus"] if instruction.soft_focus else [])


def listed(names: Sequence[str]) -> str:
    """Return names as a phrase: ``Rick, Ilsa and Sam``."""
    return names[0] if len(names) == 1 else " and ".join([", ".join(names[:-1]), names[-1]]) if names else ""
