"""Projects of versions that kept no record of what they wrote: what can be told from a person's work is noted once."""

from __future__ import annotations

import json
from pathlib import Path

from storyblender.outputs import digest_of
from storyblender.pipeline.compiling import STORY, record_name
from storyblender.pipeline.run import Run


def adopt_earlier_outputs(run: Run) -> None:
    """Note the frames that are copies of a cached picture, and the Blender file if it is as it was compiled."""
    if run.outputs.recorded:
        return
    cached = {digest_of(path) for path in _files(run.project.path("build/frames"))}
    for path in _files(run.project.path("frames")):
        if digest_of(path) in cached:
            run.outputs.note(run.project.files.name_of(path))
    story = run.project.path(STORY)
    if story.is_file() and digest_of(story)[:16] == _compiled(run.project.path(record_name(STORY))):
        run.outputs.note(STORY)


def _files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.glob("*.png") if path.is_file() and not path.is_symlink())


def _compiled(record: Path) -> str:
    """Return the digest of the Blender file in the record that was kept of it; empty if there is none."""
    try:
        kept = json.loads(record.read_bytes())
    except (OSError, ValueError, RecursionError):
        return ""
    return str(kept.get("file", "")) if isinstance(kept, dict) else ""
