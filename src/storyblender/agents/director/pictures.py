"""Panels, series items and two-column rows: all units of one picture become one shot."""

from __future__ import annotations

from collections.abc import Collection
from typing import Final

from storyblender.agents.director.company import unique
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.reading import Unit
from storyblender.memory.vocabulary import SHOT_SIZES, ShotSize

BESIDE: Final = frozenset({"title", "sound", "aside"})
"""Kinds of units that get no shot of their own."""
_FACES: Final = 5
"""Most faces in the focus of one picture."""


def spoken_picture(unit: Unit, widest: ShotSize) -> ShotDraft:
    """Return the shot of a picture whose units are only a speech, a caption or a sound.

    Args:
        unit: The first unit of the picture.
        widest: Shot size if no speaker is visible.
    """
    if unit.speaker in unit.on_stage and not unit.off_screen and unit.speaker:
        return ShotDraft("single", "MS", [unit.speaker])
    return ShotDraft("action", widest)


def begin_picture(draft: ShotDraft, unit: Unit) -> ShotDraft:
    """Turn a shot into the shot of a picture that begins with ``unit``, and return it."""
    draft.picture = unit.picture
    draft.beats, draft.on_stage = [Beat.whole(unit)], list(unit.on_stage)
    return draft


def add_to_picture(draft: ShotDraft, unit: Unit, people: Collection[str]) -> None:
    """Add a unit to the shot of its picture, widening the shot to everyone who acts in it.

    Args:
        draft: The shot.
        unit: A unit with the shot's picture number.
        people: Ids of people, to tell faces from things in the focus.
    """
    draft.beats.append(Beat.whole(unit))
    draft.on_stage = unique([*draft.on_stage, *unit.on_stage])
    if unit.kind in BESIDE or draft.note:
        return
    speaker = unit.speaker if not unit.off_screen else None
    acting = unique([*(deed.actor for deed in unit.deeds), speaker])
    draft.look_at(*[person for person in acting if person in unit.on_stage][:_FACES])
    draft.focus.sort(key=lambda each: each not in people)
    faces = [each for each in draft.focus if each in people]
    if faces and draft.kind == "insert":
        draft.kind, draft.size = "action", "MS"
    if len(faces) > 2:
        draft.kind, draft.size = "group", _at_least(draft.size, "MWS")
    elif len(faces) == 2:
        draft.kind, draft.size = "action", _at_least(draft.size, "MS")


def _at_least(size: ShotSize, wide: ShotSize) -> ShotSize:
    return wide if SHOT_SIZES.index(size) > SHOT_SIZES.index(wide) else size
