"""The prepared pictures of the story's panoramas in the project, which the engine reads."""

from __future__ import annotations

from pathlib import Path

from storyblender.errors import InputError
from storyblender.memory.panorama import Panorama, panorama_file
from storyblender.pipeline.run import Run


def keep_panoramas(run: Run) -> None:
    """Write the pictures of the story's panoramas where they are not there as they were written.

    Raises:
        InputError: The user's file is gone, or is another one by now.
    """
    for known in run.graph.panoramas:
        if run.outputs.whole(name := panorama_file(known.provenance.digest)):
            continue
        found = run.pictures.again("panorama", known.provenance, run.project.files) if run.pictures else {}
        if name in found:
            run.outputs.write(name, found[name])
            continue
        if known != run.graph.panorama:
            mend = "choose it again for its scenes, or give their light back to the crew with `unlock`"
            raise InputError("the picture of this panorama is gone", mend=mend, path=run.project.path(name))
        if run.panorama is None or run.panorama[0].provenance.digest != known.provenance.digest:
            mend = "put it back, or run `storyblender make` with another one"
            raise InputError("is not the panorama that the project was made with", mend=mend, path=run.settings.hdri)
        run.outputs.write(name, run.panorama[1])


def take_in_panorama(run: Run, file: Path) -> Panorama:
    """Keep the picture of a user's panorama in the project, for a scene that is to be lit by it.

    Args:
        run: The run.
        file: An .hdr or .exr.

    Returns:
        What an edit of light names it by.

    Raises:
        InputError: It is missing, broken or of another shape.
    """
    from storyblender.library.panorama_file import read_panorama

    known, picture = read_panorama(file)
    if not run.outputs.whole(name := panorama_file(known.provenance.digest)):
        run.outputs.write(name, picture)
    return known
