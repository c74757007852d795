"""The error tree: one class per cause; the message is the sentence the user reads."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path


class StoryBlenderError(Exception):
    """Base of every error raised on purpose. ``str(error)`` is the sentence that the user reads.

    Args:
        problem: What is wrong, one clause.
        mend: What to do about it, one clause.
        path: The file at fault.
        line: 1-based line in that file.
    """

    def __init__(
        self, problem: str, *, mend: str = "", path: Path | str | None = None, line: int | None = None
    ) -> None:
        where = "" if path is None else f"{path}:{line}: " if line is not None else f"{path}: "
        super().__init__(f"{where}{problem}" + (f"; {mend}" if mend else ""))
        self.problem, self.mend, self.path, self.line = problem, mend, path, line


class InputError(StoryBlenderError):
    """What the user gave cannot be used; the CLI exits with code 2."""


class Rejected(StoryBlenderError):
    """The Gatekeeper refused a commit (V = 0).

    Args:
        violations: One sentence per violated constraint.
    """

    def __init__(self, violations: tuple[str, ...]) -> None:
        super().__init__("rejected: " + "; ".join(violations))
        self.violations = violations


class EngineError(StoryBlenderError):
    """Blender failed at a job, after restarts.

    Args:
        problem: What is wrong, one clause.
        job: Name of the job, which ``str(error)`` begins with.
    """

    def __init__(self, problem: str, *, job: str = "") -> None:
        super().__init__(f"{job}: {problem}" if job else problem)
        self.problem = problem


class NoAnswer(StoryBlenderError):
    """A language model gave no answer that can be used; rules take over."""


class AnswerAwaited(StoryBlenderError):
    """A request waits in a folder for its answer; the run stops, and goes on when it is there.

    Args:
        problem: What is missing.
        mend: What to do.
        names: Names of the requests.
    """

    def __init__(self, problem: str, *, mend: str, names: tuple[str, ...]) -> None:
        super().__init__(problem, mend=mend)
        self.names = names

    @classmethod
    def of(cls, awaited: Sequence[AnswerAwaited]) -> AnswerAwaited:
        """Return several as one; there is at least one."""
        first, names = awaited[0], tuple(name for each in awaited for name in each.names)
        more = f", and {len(names) - 1} more wait" if len(names) > 1 else ""
        return cls(f"{first.problem}{more}", mend=first.mend, names=names)


class ServiceFailure(StoryBlenderError):
    """A service failed for good at what it was asked for; another source takes over.

    Args:
        problem: What is wrong, one clause, with no key in it.
        mend: What to do about it, one clause.
        uncertain: Whether what was asked for may have been done, and paid, all the same.
    """

    def __init__(self, problem: str, *, mend: str = "", uncertain: bool = False) -> None:
        super().__init__(problem, mend=mend)
        self.uncertain = uncertain


class ProjectLocked(StoryBlenderError):
    """Another run is writing to the project folder."""


class Cancelled(StoryBlenderError):
    """A call was cancelled between two steps. Everything finished is kept, nothing is half-written."""

    def __init__(self) -> None:
        super().__init__("cancelled", mend="what is finished is kept; the same call again goes on from there")


class StaleEdit(InputError):
    """An edit was made on an older revision, and what it touches has changed since.

    Args:
        names: Of the shots, scenes or assets.
        changes: What was done to them since, one sentence each.
    """

    def __init__(self, names: tuple[str, ...], changes: tuple[str, ...]) -> None:
        problem = f"{', '.join(names)} changed since: {'; '.join(changes)}"
        super().__init__(problem, mend="look at it as it is now, then edit it")
        self.changes = changes
