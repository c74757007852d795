"""Approval of a shot needs a frame that shows the shot as it is; a missing or stale frame is refused."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from storyblender.edits.effect import Effect, name_of
from storyblender.edits.targets import shots_named
from storyblender.errors import InputError
from storyblender.memory.edits import ApproveEdit, Edit
from storyblender.pipeline.current_frames import is_drawn
from storyblender.pipeline.run import Run


def approved_by(edits: Iterable[Edit]) -> list[str]:
    """Return the names of the shots that edits approve."""
    return [edit.shot.upper() for edit in edits if isinstance(edit, ApproveEdit) and edit.approved]


def refuse_undrawn(run: Run, names: Sequence[str]) -> None:
    """Refuse to approve shots whose frames do not show them as they are.

    Args:
        run: On the project.
        names: Shots to be approved.

    Raises:
        InputError: There is no such shot, or its frame is old or missing.
    """
    for shot in shots_named(run.graph, names):
        name = name_of(shot)
        if shot.approved is None and not is_drawn(run, shot):
            there = run.project.path(f"frames/{name}.png").is_file()
            what = f"the frame of {name} does not show the shot as it is now" if there else f"{name} is not drawn yet"
            mend = f"draw it (`storyblender render DIR --shot {name}`), look at it, then approve it"
            raise InputError(what, mend=mend)


def refuse_changed(names: Collection[str], effects: Iterable[Effect]) -> None:
    """Refuse to approve shots that the same batch of edits changes: their new frames are not drawn yet.

    Args:
        names: Shots that the batch approves.
        effects: Of the whole batch.

    Raises:
        InputError: One of them is drawn anew.
    """
    for name in (name for each in effects for name in each.stale if name in names):
        raise InputError(f"{name} is to be approved as the same step changes it", mend="look at its new frame first")
