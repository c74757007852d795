"""Cutting: neighbouring shots must differ enough, and talk alternates (notes of the director, section 2)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from typing import Final

from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.durations import shot_seconds
from storyblender.agents.director.motion_families import HANDS, TRAVEL, WHOLE_BODY
from storyblender.agents.director.reading import Deed, Unit
from storyblender.memory.outline import word_count
from storyblender.memory.shot_sizes import SHOT_SIZES, ShotSize

_SIZE_RANGES: Final[dict[str, tuple[ShotSize, ShotSize]]] = {
    "insert": ("MCU", "ECU"),
    "group": ("WS", "MS"),
    "two_shot": ("FS", "MCU"),
    "ots": ("MS", "CU"),
    "single": ("MWS", "CU"),
    "reaction": ("MWS", "CU"),
    "action": ("WS", "CU"),
}
"""Sizes a kind of shot may take."""
_LONG_SPEECH_SECONDS: Final = 9.0
"""Seconds of one speaker after which a still shot breathes: a slow push in."""


def size_steps(tighter: ShotSize, wider: ShotSize) -> int:
    """Return how many sizes ``tighter`` is tighter than ``wider``; negative if it is wider.

    Args:
        tighter: One shot size.
        wider: The other.
    """
    return SHOT_SIZES.index(tighter) - SHOT_SIZES.index(wider)


def alternate_speakers(drafts: list[ShotDraft]) -> None:
    """Turn a long conversation from face to face after the master; the last word is a close-up.

    After a move the master comes back: the audience must see the new geography. Shots are changed in place.
    """
    before: ShotDraft | None = None
    turns = 0
    for draft in drafts:
        if draft.whole_body or draft.kind == "establishing":
            before, turns = None, 0
        if not draft.speech_only or draft.kind not in ("two_shot", "ots", "group", "single"):
            continue
        if before and not draft.has_note:
            turns += 1
            _narrow_master(draft, before, "MS" if turns < 3 else "MCU")
        before = draft
    last_word = before and turns and not before.has_note and before.kind in ("ots", "single")
    if before and last_word and size_steps(before.size, "MCU") < 0:
        before.size = "MCU"


def _narrow_master(draft: ShotDraft, before: ShotDraft, size: ShotSize) -> None:
    """Narrow a master: a group to its speakers, a two-shot to the one the shot before did not favour."""
    speakers = [speaker for speaker in _speakers(draft) if speaker in draft.on_stage]
    if draft.kind == "group" and 0 < len(speakers) < 3:
        draft.focus = speakers
        draft.axis = draft.axis if draft.axis and set(draft.axis) == set(speakers) else None
        draft.kind, draft.size = ("single", "MCU") if len(speakers) == 1 else ("two_shot", "MS")
    elif draft.kind == "two_shot" and draft.axis and set(draft.axis) <= set(draft.on_stage):
        turned = [each for each in speakers if each in draft.axis and (before.kind != "ots" or each != before.focus[0])]
        if turned:
            draft.kind, draft.size, draft.focus = "ots", size, turned[:1]
            draft.over = next(person for person in draft.axis if person != turned[0])


def avoid_jump_cuts(drafts: list[ShotDraft]) -> None:
    """Put two sizes between neighbours with the same subject (the 30-degree rule), except ordered shots."""
    for index in range(1, len(drafts)):
        before, draft = drafts[index - 1], drafts[index]
        if not _is_jump_cut(before, draft):
            continue
        if _fits_over_shoulder(draft, before):
            # Two people again: the angle changes instead of the size, over the shoulder on the one who acts.
            draft.kind, draft.size, draft.axis = "ots", "MCU", before.axis
            draft.focus, draft.over = draft.focus[:1], draft.focus[1]
        elif not draft.has_note:
            following = drafts[index + 1] if index + 1 < len(drafts) else None
            _resize(draft, before, following if following and following.has_note else None)
        elif not before.has_note:
            _resize(before, draft, drafts[index - 2] if index > 1 else None)


def push_in_on_long_speeches(drafts: list[ShotDraft], text: str) -> None:
    """Let the camera of drafts in which one person speaks at length push in; ``text`` is the script."""
    for draft in drafts:
        still = draft.movement == "static" and not draft.has_note and draft.kind in ("single", "ots")
        if (
            still
            and draft.speech_only
            and len(_speakers(draft)) == 1
            and shot_seconds(draft, text) > _LONG_SPEECH_SECONDS
        ):
            draft.movement = "push in"


def _speakers(draft: ShotDraft) -> list[str]:
    """Return who speaks in a shot, most words first."""
    words: Counter[str] = Counter()
    for beat in draft.beats:
        words[beat.unit.speaker or ""] += word_count(beat.unit.text)
    return [speaker for speaker, _ in words.most_common()]


def _is_jump_cut(before: ShotDraft, draft: ShotDraft) -> bool:
    """Whether two neighbouring shots show the same subject in nearly the same size."""
    same = set(before.focus) == set(draft.focus) and (before.kind == "pov") == (draft.kind == "pov")
    cut_in = before.kind == "establishing" and draft.whole_body
    return same and not cut_in and abs(size_steps(draft.size, before.size)) < 2


def _fits_over_shoulder(draft: ShotDraft, before: ShotDraft) -> bool:
    """Whether a small action of two people who talk can be shown over a shoulder."""
    talkers = (
        before.axis is not None and set(draft.focus) == set(before.axis) and set(draft.focus) <= set(draft.on_stage)
    )
    return talkers and draft.kind == "action" and not draft.has_note and not draft.motions & (TRAVEL | WHOLE_BODY)


def _resize(draft: ShotDraft, *neighbours: ShotDraft | None) -> None:
    """Set the nearest size two steps from neighbours with the same subject; of two, the tighter."""
    limits = _SIZE_RANGES.get(draft.kind, ("EWS", "CU"))
    widest = SHOT_SIZES.index(limits[0])
    tightest = SHOT_SIZES.index("MWS" if draft.motions & (TRAVEL | WHOLE_BODY) else limits[1])
    others: list[ShotSize] = [other.size for other in neighbours if other and set(other.focus) == set(draft.focus)]
    if len(draft.focus) > 1 and draft.kind != "insert":
        tightest = min(tightest, SHOT_SIZES.index("MS"))
    allowed: list[ShotSize] = [
        size for size in SHOT_SIZES[widest : tightest + 1] if all(abs(size_steps(size, other)) >= 2 for other in others)
    ]
    if allowed:
        draft.size = min(allowed, key=lambda size: (abs(size_steps(size, draft.size)), size_steps(draft.size, size)))


def split_of_speech(text: str, unit: Unit) -> tuple[int, int] | None:
    """Return where to split a speech near its middle: end of the first part and start of the second.

    A sentence end is best, a comma will do; each part keeps at least a quarter. None where there is neither.

    Args:
        text: The script.
        unit: The speech.
    """
    words = text[unit.start : unit.end]
    for pattern in (r"[.!?…]+[\"”'’)]*\s+", r"[,;:–—]\s+"):
        gaps = [(m.start() + len(m[0].rstrip()), m.end()) for m in re.finditer(pattern, words)]
        gaps = [gap for gap in gaps if len(words) / 4 < gap[0] and gap[1] < len(words) * 3 / 4]
        if gaps:
            end, start = min(gaps, key=lambda gap: abs(gap[0] - len(words) / 2))
            return unit.start + end, unit.start + start
    return None


def size_for_motions(motions: Collection[str]) -> ShotSize:
    """Return the shot size for motions: the whole body while it travels, both hands while they work."""
    if TRAVEL & set(motions):
        return "FS"
    if WHOLE_BODY & set(motions):
        return "MWS"
    return "MS" if HANDS & set(motions) else "MCU"


def does_more_than_handle(unit: Unit, things: Sequence[str]) -> bool:
    """Whether people in a unit do more than handle the things of an insert.

    Args:
        unit: The unit.
        things: Ids of the things of the insert.
    """
    return any(deed.motion not in HANDS or not {deed.prop, deed.target} & {*things} for deed in unit.deeds)


def listener_of(unit: Unit, speaker: str) -> str | None:
    """Return the listener of a speech: its addressee, else the only other person on stage, else None.

    Args:
        unit: The speech.
        speaker: Id of its speaker.
    """
    if unit.to in unit.on_stage and unit.to != speaker:
        return unit.to
    others = [person for person in unit.on_stage if person != speaker]
    return others[0] if len(others) == 1 else None


def looked_at_prop(deeds: Sequence[Deed], props: Collection[str]) -> str | None:
    """Return the prop that a person looks at or reads in these deeds, or None.

    Args:
        deeds: The deeds.
        props: Ids of all props.
    """
    for deed in deeds:
        if deed.motion in ("look", "read"):
            return next((each for each in (deed.prop, deed.target) if each in props), None)
    return None
