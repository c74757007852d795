"""The prepared picture of the story's panorama in the project, which the engine reads."""

from __future__ import annotations

from storyblender.errors import InputError
from storyblender.memory.panorama import panorama_file
from storyblender.pipeline.run import Run


def keep_panorama(run: Run) -> None:
    """Write the picture of the story's panorama where it is not there as it was written.

    Raises:
        InputError: The user's file is gone, or is another one by now.
    """
    known = run.graph.panorama
    if known is None or run.outputs.whole(name := panorama_file(known.provenance.digest)):
        return
    if run.panorama is None or run.panorama[0].provenance.digest != known.provenance.digest:
        mend = "put it back, or run `storyblender make` with another one"
        raise InputError("is not the panorama that the project was made with", mend=mend, path=run.settings.hdri)
    run.outputs.write(name, run.panorama[1])
