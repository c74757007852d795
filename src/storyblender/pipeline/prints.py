"""JPEGs of the frames: one to be printed and one to be looked through, made once and named by what they show.

They keep a board of a thousand shots small, and the page of one quick to scroll.
"""

from __future__ import annotations

import hashlib
import io
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

from storyblender.outputs import Outputs
from storyblender.pipeline.run import Run

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
    outputs, path = run.outputs, run.project.path
    pairs = [_print_names(frame) for frame in frames.values()]
    missing = {pair: frame for pair, frame in zip(pairs, frames.values(), strict=True) if not _there(pair, outputs)}
    with ThreadPoolExecutor(run.engine.processes) as threads:
        printed = threads.map(lambda pair: _print(missing[pair], pair, outputs), missing)
        for step, _ in enumerate(printed, start=1):
            run.progress("prints", step, len(missing))
    small = {name: f"{THUMBNAILS}/{name}.jpg" for name in frames}
    for name, (_, thumbnail) in zip(small.values(), pairs, strict=True):
        run.place(thumbnail, name)
    outputs.keep_only(f"{PRINTS}/", {name for pair in pairs for name in pair})
    outputs.keep_only(f"{THUMBNAILS}/", small.values())
    large = {name: path(printed) for name, (printed, _) in zip(frames, pairs, strict=True)}
    return Prints(large, {name: path(thumbnail) for name, thumbnail in small.items()})


def _print_names(frame: Path) -> tuple[str, str]:
    """Return the names of the print and the thumbnail of a picture."""
    digest = hashlib.sha256(frame.read_bytes()).hexdigest()[:16]
    return f"{PRINTS}/{digest}.jpg", f"{PRINTS}/{digest}_small.jpg"


def _there(names: tuple[str, str], outputs: Outputs) -> bool:
    return all(outputs.whole(name) for name in names)


def _print(frame: Path, names: tuple[str, str], outputs: Outputs) -> None:
    with Image.open(frame) as image:
        picture = image.convert("RGB")
    for name, width in zip(names, (PRINT_WIDTH, THUMBNAIL_WIDTH), strict=True):
        outputs.write(name, _jpeg(picture, width))


def _jpeg(picture: Image.Image, width: int) -> bytes:
    """Return a picture as JPEG, made smaller where it is wider than ``width`` pixels."""
    if picture.width > width:
        picture = picture.resize(
            (width, max(1, round(picture.height * width / picture.width))), Image.Resampling.LANCZOS
        )
    buffer = io.BytesIO()
    picture.save(buffer, "JPEG", quality=JPEG_QUALITY)
    return buffer.getvalue()
