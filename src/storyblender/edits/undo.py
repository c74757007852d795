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
    return undo.reason if undo is not None and undo.revision > 1 else "", redo.reason if redo is not None else ""


def redo_edit(project: Project) -> list[Commit]:
    """Make a change again that was undone, with the crew's work on it.

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
    if not redone:
        raise InputError("there is nothing to redo", mend="a change can be redone until another one is made")
    project.go_to(redone[-1].revision)
    return redone
