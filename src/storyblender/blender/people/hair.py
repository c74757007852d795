"""Hair."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.figure import Figure
from storyblender.blender.people.sheet import Sheet, clip, normals, smoothed

Floats = NDArray[np.float64]

HAIRLINE = np.array([[-1, 6.55], [-0.1, 6.62], [0.15, 6.9], [0.35, 7.25], [0.6, 7.38], [0.80, 7.10], [0.90, 7.15],
                     [0.97, 7.70], [1.15, 7.95], [1.35, 8.02], [2, 8.05]])  # fmt: skip


def cap(figure: Figure, top: float, side: float) -> Sheet:
    pack = figure.pack
    sheet = figure.part("skin")
    base = sheet.base
    ok = (base[:, 1] > 6.3) & (base[:, 2] < 1.6) & ~pack.ears
    sheet = sheet.keep_faces(ok[sheet.faces].all(1))
    base = sheet.base
    sheet = clip(sheet, base[:, 1] - np.interp(base[:, 2], HAIRLINE[:, 0], HAIRLINE[:, 1]))
    base = sheet.base
    h = base[:, 1] - np.interp(base[:, 2], HAIRLINE[:, 0], HAIRLINE[:, 1])
    up = np.clip((base[:, 1] - 7.4) / 0.9, 0, 1)
    thick = 0.0015 + (side * (1 - up) + top * up) * np.clip(h / 0.22, 0, 1) ** 0.6
    return sheet.moved(smoothed(sheet, 3) + normals(sheet) * (thick * figure.head_scale)[:, None])
