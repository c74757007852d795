"""The engine's server with two small tools that need no Blender."""

from __future__ import annotations

import os
import sys

from storyblender.blender.progress import Progress
from storyblender.blender.server import claim_standard_output, serve
from storyblender.memory.base import Frozen


class Size(Frozen):
    width: float
    height: float


def scale(size: Size, factor: float) -> Size:
    """Multiply a size."""
    os.write(1, b"as loud as a renderer\n")
    return Size(width=size.width * factor, height=size.height * factor)


def refuse() -> int:
    """Say no."""
    raise ValueError("the wall is in the way")


def count(steps: int) -> int:
    """Take so many steps, and report each."""
    for step in range(steps):
        progress(step + 1, steps)
    return steps


if __name__ == "__main__":
    wire = claim_standard_output()
    progress = Progress(wire)
    serve([scale, refuse, count], sys.stdin.buffer, wire, progress)
