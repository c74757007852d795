"""Reads the multilayer EXR files that Blender writes, with the OpenImageIO that ships inside Blender."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from storyblender.errors import EngineError
from storyblender.look.bundled import bundled_module

Channels = Mapping[str, NDArray[np.float32]]
"""(h, w) float32 by name without the view layer, e.g. ``Combined.R``, ``Depth.Z``; row 0 at the top."""


def read_channels(path: Path) -> Channels:
    """Return the channels of the first view layer in the file.

    Raises:
        EngineError: The file or the reader is missing.
    """
    oiio = bundled_module("OpenImageIO")
    if oiio is None:
        raise EngineError("Blender's own OpenImageIO could not be loaded; reinstall bpy")
    file = oiio.ImageInput.open(str(path))
    if file is None:
        raise EngineError(f"the render wrote no readable picture: {oiio.geterror()}")
    try:
        names = file.spec().channelnames
        pixels = file.read_image(format="float")
    finally:
        file.close()
    layer = names[0].split(".", 1)[0]
    return {
        name.split(".", 1)[1]: pixels[..., index]
        for index, name in enumerate(names)
        if name.split(".", 1)[0] == layer and "." in name
    }


def color(channels: Channels) -> NDArray[np.float32]:
    """Return the combined colour, (h, w, 3)."""
    return np.stack([channels[f"Combined.{name}"] for name in "RGB"], axis=2)
