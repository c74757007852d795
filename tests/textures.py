"""Small synthetic surfaces for tests: boards that run up the picture, with relief and roughness."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

BROWN, PALE = (150, 90, 50), (210, 180, 140)


def boards(side: int = 64, count: int = 4) -> Image.Image:
    """Return a picture of boards side by side, brown and pale in turn."""
    striped = np.zeros((side, side, 3), np.uint8)
    for index in range(count):
        striped[:, index * side // count : (index + 1) * side // count] = (BROWN, PALE)[index % 2]
    return Image.fromarray(striped)


def write_surface(folder: Path, name: str = "oak_boards", side: int = 64) -> Path:
    """Write the maps of a surface as Poly Haven names them, with credits; return the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    boards(side).save(folder / f"{name}_diff_1k.png")
    Image.new("RGB", (side, side), (160, 128, 246)).save(folder / f"{name}_nor_gl_1k.png")
    Image.new("L", (side, side), 102).save(folder / f"{name}_rough_1k.jpg")
    (folder / "credits.toml").write_text('author = "Ann Joiner"\nlicense = "CC0-1.0"\n')
    return folder
