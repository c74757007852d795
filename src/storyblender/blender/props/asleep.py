"""Animals that sleep: what was built standing on four legs is laid down; a cat curls up."""

from __future__ import annotations

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder

_FOLDED = 0.12
"""Of the height of the legs, what is left when they are drawn in."""
_SKULL = 0.5
"""Of the way from the nose to the fore paws, what is head; the rest is neck."""
_FORWARD = {True: 0.55, False: 0.3}
"""Metres that a paw comes forward for each metre of leg: fore, hind."""


def lie_down(mesh: bpy.types.Mesh) -> None:
    """Lay a four-legged animal that looks to -Y on its belly, paws forward, its chin on the floor. Changes ``mesh``."""
    flat = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", flat)
    points = flat.reshape(-1, 3).astype(float)
    points[:, 2] -= points[:, 2].min()
    x, y, z = points.T.copy()
    nose, middle, width = float(y.min()), float(y.min() + y.max()) / 2, float(np.ptp(x))
    trunk = (np.abs(x) < 0.1 * width) & (np.abs(y - middle) < 0.2 * np.ptp(y))
    belly = float(z[trunk].min())
    fore = float(y[z < 0.25 * belly].min())
    skull = nose + _SKULL * (fore - nose)
    leg = np.where(y > skull, np.clip(belly - z, 0.0, None), 0.0)
    points[:, 2] = np.where(z < belly, _FOLDED * z, z - (1 - _FOLDED) * belly)
    points[:, 1] -= leg * np.where(y < middle, _FORWARD[True], _FORWARD[False])
    points[:, 0] *= 1 + 0.6 * leg / belly
    down = np.clip((fore + 0.2 * (fore - nose) - y) / (fore + 0.2 * (fore - nose) - skull), 0.0, 1.0)
    down = np.where(leg > 0, 0.0, down * down * (3 - 2 * down))
    chin = float(points[(y < skull) & (leg == 0), 2].min())
    points[:, 2] -= down * chin
    points[:, 1] -= 0.35 * down * chin
    mesh.vertices.foreach_set("co", points.astype(np.float32).ravel())
    mesh.update()


def curled_cat(b: MeshBuilder, coat: MaterialRef, dark: MaterialRef) -> None:
    """Add a cat asleep in a ring, its nose by its tail; about 0.4 m across.

    Args:
        b: Receives the cat.
        coat: Material of the fur.
        dark: Of nose and closed eyes.
    """
    turns = np.radians(np.linspace(-30, 250, 15))
    ring = np.c_[0.105 * np.cos(turns), 0.105 * np.sin(turns), np.full(15, 0.075)]
    thick = np.interp(np.linspace(0, 1, 15), (0, 0.25, 0.6, 0.85, 1), (0.06, 0.085, 0.09, 0.06, 0.045))
    ring[:, 2] = thick * 0.92
    b.tube(coat, ring, tuple(float(r) for r in thick), segments=16)
    for end in (0, -1):
        b.sphere(coat, ring[end], float(thick[end]), segments=14, rings=9)
    with b.at((-0.02, -0.155, 0.05), (0, 0, 62)):
        b.sphere(coat, (0, 0, 0), 0.058, scale=(1, 0.95, 0.85), segments=16, rings=10)
        b.sphere(coat, (0, -0.048, -0.012), 0.026, scale=(1.1, 0.9, 0.8), segments=12, rings=8)
        b.sphere(dark, (0, -0.072, -0.006), 0.007, segments=8, rings=5)
        for x in (-1, 1):
            b.cushion(coat, (x * 0.034, 0.006, 0.052), (0.034, 0.02, 0.05), softness=0.9, rotation=(0, x * 14, 0))
            b.box(dark, (x * 0.026, -0.05, 0.008), (0.02, 0.006, 0.003))
    tail = np.radians(np.linspace(-40, -150, 9))
    b.tube(coat, np.c_[0.19 * np.cos(tail), 0.19 * np.sin(tail), np.full(9, 0.026)], 0.023, segments=10)
