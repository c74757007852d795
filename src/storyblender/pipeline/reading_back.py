"""The story's .blend, read back where a person saved it: what it was compiled as, and what it is now."""

from __future__ import annotations

from storyblender.errors import EngineError
from storyblender.memory.blend_values import BlendReading
from storyblender.pipeline.compiling import record_name, story_files
from storyblender.pipeline.run import Run


def changed_files(run: Run) -> list[str]:
    """Return the names of the story's .blend files that are not as the program wrote them."""
    return [name for name in story_files(run.graph) if run.outputs.known(name) and run.outputs.changed(name)]


def read_back(run: Run, name: str) -> BlendReading | None:
    """Return what a file was compiled as and what it is now; None if Blender cannot read it.

    Args:
        run: The run.
        name: Of the file in the project.
    """
    try:
        return run.engine.read_story(name).result()
    except EngineError:
        return None


def take_over(run: Run, name: str, *, whole: bool = True) -> None:
    """Let a file count as read, so that no copy of it is made when it is written.

    Args:
        run: The run.
        name: Of the file; what was not understood of it has been copied aside.
        whole: Whether it is compiled whole the next time; a file without changes need not be.
    """
    if whole:
        run.outputs.delete(record_name(name))
    run.outputs.note(name)
