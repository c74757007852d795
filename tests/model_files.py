"""Small model files for tests, and pictures of what is in none."""

from __future__ import annotations

import io
from pathlib import Path

from PIL import Image

_FACES = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
Box = tuple[tuple[float, float, float], tuple[float, float, float]]
CABINET: Box = (-0.25, -0.4, 0.0), (0.25, 0.4, 0.6)
DIAL: Box = (0.25, -0.3, 0.4), (0.31, -0.1, 0.55)


def write_cabinet(folder: Path, name: str = "radio") -> Path:
    """Write a grey cabinet, 0.5 m wide, 0.8 m deep and 0.6 m high, whose red dial is high up on its right side.

    Args:
        folder: Of the .obj and its materials.
        name: Of the files.
    """
    colors = {"grey": "0.4 0.4 0.4", "red": "0.9 0.05 0.05"}
    (folder / f"{name}.mtl").write_text("".join(f"newmtl {key}\nKd {color}\n" for key, color in colors.items()))
    lines = [f"mtllib {name}.mtl"]
    for number, (color, (low, high)) in enumerate((("grey", CABINET), ("red", DIAL))):
        corners = ((x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2]))
        lines += [f"v {x} {z} {-y}" for x, y, z in corners]  # Y is up in the file
        lines += [f"usemtl {color}", *(f"f {' '.join(str(corner + 8 * number) for corner in face)}" for face in _FACES)]
    path = folder / f"{name}.obj"
    path.write_text("\n".join(lines) + "\n")
    return path


def tile(number: int) -> bytes:
    """Return a PNG of one colour, which the number tells."""
    png = io.BytesIO()
    Image.new("RGB", (64, 64), (40 * number, 0, 0)).save(png, "PNG")
    return png.getvalue()
