"""JPEGs of the frames: one to be printed and one to be looked through, made once and named by what they show.

They keep a board of a thousand shots small, and the page of one quick to scroll.
"""

from __future__ import annotations

import hashlib
import io
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from storyblender.pipeline.run import Run
from storyblender.project import write_atomic

PRINTS = "build/prints"
THUMBNAILS = "thumbnails"
JPEG_QUALITY = 88
PRINT_WIDTH, THUMBNAIL_WIDTH = 1600, 640
"""Pixels across at most: a page of its own at 150 dots an inch, a third of a page at 180."""


@dataclass(frozen=True)
class Prints:
    """The JPEGs of a story.

    Attributes:
        large: Shot name to the print for a page of its own.
        small: Shot name to the thumbnail, under the shot's name in the project.
    """

    large: dict[str, Path]
    small: dict[str, Path]


def make_prints(run: Run, frames: Mapping[str, Path]) -> Prints:
    """Return prints of the frames; only those of new pictures are made, and those of no shot are deleted.

    Args:
        run: The run.
        frames: Shot name to picture.
    """
    folder = run.project.path(PRINTS, "x").parent
    with ThreadPoolExecutor(run.engine.processes) as threads:
        pairs = list(threads.map(lambda frame: _printed(frame, folder), frames.values()))
    small: dict[str, Path] = {}
    for name, (_, thumbnail) in zip(frames, pairs, strict=True):
        small[name] = run.project.path(THUMBNAILS, f"{name}.jpg")
        content = thumbnail.read_bytes()
        if not small[name].exists() or small[name].read_bytes() != content:
            write_atomic(small[name], content)
    _delete_others(folder, {path for pair in pairs for path in pair})
    _delete_others(run.project.path(THUMBNAILS, "x").parent, small.values())
    return Prints({name: large for name, (large, _) in zip(frames, pairs, strict=True)}, small)


def _printed(frame: Path, folder: Path) -> tuple[Path, Path]:
    """Return the print and the thumbnail of a picture, made where they are missing."""
    digest = hashlib.sha256(frame.read_bytes()).hexdigest()[:16]
    large, small = folder / f"{digest}.jpg", folder / f"{digest}_small.jpg"
    if not (large.exists() and small.exists()):
        with Image.open(frame) as image:
            picture = image.convert("RGB")
        write_atomic(large, _jpeg(picture, PRINT_WIDTH))
        write_atomic(small, _jpeg(picture, THUMBNAIL_WIDTH))
    return large, small


def _jpeg(picture: Image.Image, width: int) -> bytes:
    """Return a picture as JPEG, made smaller where it is wider than ``width`` pixels."""
    if picture.width > width:
        picture = picture.resize(
            (width, max(1, round(picture.height * width / picture.width))), Image.Resampling.LANCZOS
        )
    buffer = io.BytesIO()
    picture.save(buffer, "JPEG", quality=JPEG_QUALITY)
    return buffer.getvalue()


def _delete_others(folder: Path, kept: Iterable[Path]) -> None:
    for path in set(folder.glob("*.jpg")) - set(kept):
        path.unlink()
