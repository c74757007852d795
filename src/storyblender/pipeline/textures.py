"""The prepared pictures of the surfaces of sets in the project, which the engine reads."""

from __future__ import annotations

from pathlib import Path

from storyblender.errors import InputError
from storyblender.memory.texture import Texture
from storyblender.pipeline.run import Run


def keep_textures(run: Run) -> None:
    """Make sure that the pictures of the story's sets are there as they were written.

    Raises:
        InputError: One is gone.
    """
    for texture in run.graph.textures:
        if all(map(run.outputs.whole, texture.files)):
            continue
        found = run.pictures.again("texture", texture.provenance, run.project.files) if run.pictures else {}
        for name in texture.files:
            if name in found:
                run.outputs.write(name, found[name])
            elif not run.outputs.whole(name):
                mend = f"choose {texture.provenance.file!r} again with `set`, or another material"
                raise InputError("this picture of a surface is gone", mend=mend, path=run.project.path(name))


def take_in_texture(run: Run, path: Path, metres: float | None = None) -> Texture:
    """Keep the pictures of a user's surface in the project, for a set that is to be made of it.

    Args:
        run: The run.
        path: A colour picture, or a folder with the maps of one surface.
        metres: Width of the picture on the wall; None for the usual.

    Returns:
        What an edit of a set names it by.

    Raises:
        InputError: It is missing, broken, or no surface.
    """
    from storyblender.library.texture_file import read_texture

    texture, pictures = read_texture(path, metres)
    for name, picture in pictures.items():
        if not run.outputs.whole(name):
            run.outputs.write(name, picture)
    return texture
