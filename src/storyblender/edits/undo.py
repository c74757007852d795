"""Undo and redo: a person's change with all that the crew did in consequence."""

from __future__ import annotations

from storyblender.errors import InputError
from storyblender.memory.history import CAUSED_BY_PERSON, Commit
from storyblender.project import Project


def undo_edit(project: Project) -> list[Commit]:
    """Take back a person's last change with all that the crew did in consequence; the first reading of a script stays.

    Returns:
        What was undone, oldest first: the change itself, then the crew's commits.

    Raises:
        InputError: Nothing was changed since the script was read.
    """
    undone: list[Commit] = []
    for commit in project.backwards():
        if commit.revision == 1:
            break
        undone.insert(0, commit)
        if commit.author in CAUSED_BY_PERSON:
            project.go_to(commit.revision - 1)
            return undone
    raise InputError("there is nothing to undo", mend="nothing was changed since the script was read")


def next_steps(project: Project) -> tuple[str, str]:
    """Return what undo would take back and what redo would make again, in words; empty where there is nothing."""
    undo = next((each for each in project.backwards() if each.author in CAUSED_BY_PERSON or each.revision == 1), None)
    redo = next(project.forwards(), None)
    if redo is None and (place := _set_aside_at(project)) is not None:
        redo = project.set_aside.after(place[1], by_person=True)
    return undo.reason if undo is not None and undo.revision > 1 else "", redo.reason if redo is not None else ""


def redo_edit(project: Project) -> list[Commit]:
    """Make a change again that was undone, with the crew's work on it.

    What the crew did on the story as it was meanwhile is taken back: it is as if nothing had been undone.

    Returns:
        What was done again, oldest first.

    Raises:
        InputError: Nothing was undone, or something else was changed since.
    """
    redone: list[Commit] = []
    for commit in project.forwards():
        if redone and commit.author in CAUSED_BY_PERSON:
            break
        redone.append(commit)
    if redone:
        project.go_to(redone[-1].revision)
        return redone
    place = _set_aside_at(project)
    if place is None:
        raise InputError("there is nothing to redo", mend="a change can be redone until another one is made")
    base, digest = place
    redone = project.set_aside.step(digest)
    project.bring_back(base, redone)
    return redone


def _set_aside_at(project: Project) -> tuple[int, str] | None:
    """Return the commit, by number and digest, that a change was undone to before the crew went on from it."""
    for commit in project.backwards():
        if project.set_aside.after(commit.digest, by_person=True) is not None:
            return commit.revision, commit.digest
        if commit.author in CAUSED_BY_PERSON:
            break
    return None
