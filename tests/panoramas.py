"""Small synthetic panoramas for tests."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from storyblender.library.panorama_file import radiance_file
from storyblender.look.irradiance import panorama_directions
from storyblender.look.raster import Image


def sky(width: int = 128, *, sun: tuple[float, float, float] | None = (0.6, 0.48, 0.64), glare: float = 3e4) -> Image:
    """Return a blue dome over brown ground, brighter on the side of +Y, with a small sun in it."""
    toward = panorama_directions(width // 2, width)
    above = toward[..., 2:] > 0
    picture = np.where(above, (0.3, 0.5, 0.9), (0.2, 0.14, 0.08)) * (1.2 + toward[..., 1:2])
    if sun is not None:
        picture += glare * (toward @ np.array(sun) > 0.9985)[..., None]
    return picture.astype(np.float32)


def write_sky(path: Path, width: int = 128, *, sun: tuple[float, float, float] | None = (0.6, 0.48, 0.64)) -> Path:
    """Write such a panorama as a Radiance file."""
    path.write_bytes(radiance_file(sky(width, sun=sun)))
    return path
