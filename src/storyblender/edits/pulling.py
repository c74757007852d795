"""Pull: what a person saved in ``story.blend`` becomes edits, as one undo, before the file is written anew."""

from __future__ import annotations

from typing import Literal

from storyblender.edits.adopting_objects import with_adopted
from storyblender.edits.blend_changes import changes_of
from storyblender.edits.dispatcher import Applied, apply_edits
from storyblender.edits.families import tried
from storyblender.edits.pull_conflicts import PullConflict, let_wait, waiting
from storyblender.edits.pulled_edits import edits_of
from storyblender.edits.pulled_motion import keep_motions, with_hand_changes
from storyblender.errors import InputError
from storyblender.memory.base import Frozen
from storyblender.memory.edits import Edit
from storyblender.pipeline.reading_back import changed_files, read_back, take_over
from storyblender.pipeline.run import Run
from storyblender.trace import Event

_NEWER = "cannot be read by Blender 4.5; save it there, or in 4.5's format"


class Pulled(Frozen):
    """What came of the story's files that a person had changed."""

    files: tuple[str, ...] = ()
    """Those that were changed."""
    understood: tuple[str, ...] = ()
    """Changes that became edits."""
    conflicts: tuple[PullConflict, ...] = ()
    """Changes of what was changed in the project as well; the project's stand until a person chooses."""
    kept: tuple[str, ...] = ()
    """Changes that no edit can express; a dated copy of the file has them."""
    applied: Applied | None = None
    """The edits; None where there are none, or where they were only asked for."""


class Choice(Frozen):
    """Which side of the conflicts a person takes; those that it does not tell wait."""

    prefer: Literal["blender", "project"] | None = None
    """The side for all of them."""
    take: tuple[str, ...] = ()
    """Ids of those that are as in Blender."""
    leave: tuple[str, ...] = ()
    """Ids of those that stay as in the project."""

    def side(self, conflict: PullConflict) -> Literal["blender", "project"] | None:
        """Return the side of one conflict."""
        if conflict.id in self.take:
            return "blender"
        return "project" if conflict.id in self.leave else self.prefer


UNDECIDED = Choice()


def pull(run: Run, *, apply: bool = True, choice: Choice = UNDECIDED) -> Pulled:
    """Read the story's changed files back, and make the edits that a person made in them.

    Args:
        run: On a made project.
        apply: Whether the edits are made, and the files count as read then; False only tells them.
        choice: Which side is taken where the project was changed as well, now or at an earlier pull.

    Raises:
        Rejected: The Gatekeeper refused.
        InputError: It names a conflict that there is not.
    """
    pulled = Pulled(conflicts=waiting(run.project))
    for name in changed_files(run):
        pulled = _with_file(run, name, pulled, apply=apply)
    unknown = {*choice.take, *choice.leave} - {conflict.id for conflict in pulled.conflicts}
    if unknown:
        names = ", ".join(conflict.id for conflict in pulled.conflicts) or "none"
        raise InputError(f"there is no conflict {sorted(unknown)[0]!r}", mend=f"there are: {names}")
    return _decided(run, pulled, choice) if apply else pulled


def _decided(run: Run, pulled: Pulled, choice: Choice) -> Pulled:
    """Return what came of a pull with Blender's side of the conflicts taken where a person chose that."""
    sides = {conflict.id: choice.side(conflict) for conflict in pulled.conflicts}
    understood, kept, applied = list(pulled.understood), list(pulled.kept), pulled.applied
    graph, edits = run.project.graph, list[Edit]()
    for conflict in (each for each in pulled.conflicts if sides[each.id] == "blender"):
        try:
            graph = tried(graph, conflict.edits)
        except InputError as error:
            kept.append(f"{conflict.words}: {error.problem}")
        else:
            understood.append(conflict.words)
            edits += conflict.edits
    if edits:
        chosen = apply_edits(run.project, edits)
        applied = chosen if applied is None else applied.followed_by(chosen)
    kept += [f"{each.words}: the project stands" for each in pulled.conflicts if sides[each.id] == "project"]
    left = tuple(conflict for conflict in pulled.conflicts if sides[conflict.id] is None)
    let_wait(run.project, left)
    update = {"understood": tuple(understood), "kept": tuple(kept), "conflicts": left, "applied": applied}
    return pulled.model_copy(update=update)


def _with_file(run: Run, name: str, pulled: Pulled, *, apply: bool) -> Pulled:
    reading = read_back(run, name)
    files = (*pulled.files, name)
    if reading is None or reading.compiled is None:
        why = _NEWER if reading is None else "was compiled by an early version, which wrote no values into it"
        if apply:
            run.copy_aside(name)
            take_over(run, name)
        return pulled.model_copy(update={"files": files, "kept": (*pulled.kept, f"{name} {why}")})
    changes, motions = with_hand_changes(run.project, changes_of(reading), reading)
    changes = with_adopted(run, name, changes, keep=apply)
    found = edits_of(run.project, changes, reading.compiled)
    applied = pulled.applied
    if apply:
        run.copy_aside(name)  # what the values do not tell, such as a mesh that was sculpted, is in the copy alone
        # Those of conflicts as well, which may be taken once the file has been written anew.
        waiting_edits = (edit for conflict in found.conflicts for edit in conflict.edits)
        keep_motions(run.project.files, motions, (*found.edits, *waiting_edits))
        if found.edits:
            applied = apply_edits(run.project, found.edits)
            run.tell(Event(kind="commit", role="user", subject=name, message=f"pulled: {applied.words}"))
        for sentence in (
            *(f"conflict: {each.sentence} ({each.id})" for each in found.conflicts),
            *(f"not taken over: {each}" for each in found.kept),
        ):
            run.tell(Event(kind="warning", role="project", subject=name, message=sentence))
        older = reading.compiled.version != run.project.version  # it may have been saved over a newer one
        take_over(run, name, whole=bool(changes) or older)
    return Pulled(
        files=files,
        understood=(*pulled.understood, *found.understood),
        conflicts=tuple({each.id: each for each in (*pulled.conflicts, *found.conflicts)}.values()),
        kept=(*pulled.kept, *found.kept),
        applied=applied,
    )
