"""Spectacles: two rims, a bridge and the temples, fitted to brow, cheek and ears."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.people.face import Pin, bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet, join, rigid_sheet
from storyblender.geometry.solids import Floats, skin_faces

WIRE = 0.0016
"""Radius of the frame's wire on a grown-up's head, metres."""


def build_glasses(figure: BodyFigure) -> Sheet:
    """Return the frame of a pair of glasses on the head bone, fitted to a figure."""
    scale = figure.head_scale
    pins = {name: Pin(figure.pack, *place).on(figure.points) for name, place in {
        "brow": (0.31, 7.47), "cheek": (0.31, 7.06), "bridge": (0.0, 7.25),
    }.items()}  # fmt: skip
    front = min(float(pins["brow"][1]), float(pins["cheek"][1])) - 0.002 * scale
    front = min(front, float(pins["bridge"][1]) + 0.006 * scale)
    wires = []
    inner = []
    for side in "LR":
        sign = 1.0 if side == "L" else -1.0
        eye = figure.joint(f"{side.lower()}-eye")
        center = np.array((eye[0] + sign * 0.002 * scale, front, eye[2] - 0.003 * scale))
        turns = np.linspace(0, 2 * math.pi, 19)
        rim = center + np.stack([0.0225 * np.cos(turns), np.zeros(19), 0.019 * np.sin(turns)], 1) * scale
        wires.append(_wire(rim, WIRE * scale))
        inner.append(center + np.array((-sign * 0.0225 * scale, 0.0, 0.004 * scale)))
        ears = figure.points[: len(figure.pack.ears)][figure.pack.ears]
        ear = ears[ears[:, 0] * sign > 0]
        top = ear[ear[:, 2].argmax()] + np.array((0.0, 0.004, 0.0)) * scale
        hinge = center + np.array((sign * 0.0225 * scale, 0.0, 0.006 * scale))
        wide = sign * max(abs(float(top[0])), abs(float(hinge[0])) + 0.012 * scale)
        corner = np.array((wide * 0.97, front + 0.006 * scale, hinge[2]))
        wires.append(_wire(np.array([hinge, corner, (wide, top[1], top[2])]), WIRE * scale))
    nose = (inner[0] + inner[1]) / 2 + np.array((0.0, -0.002, 0.003)) * scale
    wires.append(_wire(np.array([inner[0], nose, inner[1]]), WIRE * scale))
    return join(wires)


def _wire(line: Floats, radius: float) -> Sheet:
    """Return a four-sided tube along ``line``."""
    along = np.gradient(line, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.cross(along, (0.0, 1.0, 0.05))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, along)
    ring = np.stack([line + side * radius, line + up * radius, line - side * radius, line - up * radius], 1)
    return rigid_sheet(ring.reshape(-1, 3), skin_faces(len(line), 4, True), bone_weights("head"))
