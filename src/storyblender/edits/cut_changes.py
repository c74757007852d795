"""The strips of the scene EDIT that a person trimmed, moved, muted or deleted, as edits of the cut."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from storyblender.edits.blend_change import BlendChange
from storyblender.memory.blend_values import StripInEdit
from storyblender.memory.edits import DurationEdit, OmitEdit, ReorderEdit


def cut_changes(compiled: Sequence[StripInEdit], saved: Sequence[StripInEdit]) -> Iterator[BlendChange]:
    """Yield what was changed of the cut, strip by strip.

    Args:
        compiled: The strips as they were written, in order.
        saved: As they are.
    """
    there = {strip.name: strip for strip in saved}
    for strip in compiled:
        now = there.get(strip.name)
        if now is None or (now.muted and not strip.muted):
            how = "deleted" if now is None else "muted"
            words = f"the strip of {strip.name} is {how} in EDIT"
            yield BlendChange(kind="cut", subject=strip.name, words=words, edits=(OmitEdit(target=strip.name),))
        elif now.offset != strip.offset:
            words = f"the strip of {strip.name} begins {now.offset - strip.offset:+d} frames into its shot in EDIT"
            yield BlendChange(kind="unknown", subject=strip.name, words=words)
        elif now.frames != strip.frames:
            words = f"the strip of {strip.name} has {now.frames} frames in EDIT"
            edit = DurationEdit(shot=strip.name, frames=now.frames)
            yield BlendChange(
                kind="cut", subject=strip.name, words=words, edits=(edit,),
                compiled=f"{strip.frames} frames", saved=f"{now.frames} frames",
            )  # fmt: skip
    known = {strip.name for strip in compiled}
    for strip in (each for each in saved if each.name not in known):
        words = f"the strip {strip.name!r} is new in EDIT"
        yield BlendChange(kind="unknown", subject="EDIT", words=words)
    yield from _moves(
        [each.name for each in compiled if each.name in there],
        [each.name for each in saved if each.name in known],
    )


def _moves(was: list[str], now: list[str]) -> Iterator[BlendChange]:
    """Yield the fewest moves, each of a shot behind the one that it follows, that bring one order into another."""
    stays = _longest_common(was, now)
    for index, name in enumerate(now):
        if name in stays:
            continue
        before, after = (None, now[index - 1]) if index else (was[0], None)
        side = f"before {before}" if before is not None else f"after {after}"
        edit = ReorderEdit(target=name, before=before, after=after)
        yield BlendChange(
            kind="cut", subject=name, words=f"the strip of {name} is moved {side} in EDIT", edits=(edit,)
        )  # fmt: skip


def _longest_common(was: Sequence[str], now: Sequence[str]) -> set[str]:
    """Return the names of a longest run that is in the same order in both."""
    place = {name: index for index, name in enumerate(was)}
    best: list[list[str]] = []
    for name in now:
        before = max((run for run in best if place[run[-1]] < place[name]), key=len, default=[])
        best.append([*before, name])
    return set(max(best, key=len, default=[]))
