"""Prop builders: the parts of a car that people handle, as they are in it and loose. Their front is -Y.

Each is added about the middle of its own box, a seat about the middle of its front edge at sitting height.
"""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.registry import PropSpec, prop

DARK = "plastic_black"
_COVER = "leather_black"


def steering_wheel(b: MeshBuilder) -> None:
    """Add a steering wheel before its driver, with the end of its column."""
    turn = np.linspace(0, 2 * np.pi, 29)[:-1]
    rim = 0.18 * np.c_[np.cos(turn), -0.47 * np.sin(turn), 0.88 * np.sin(turn)]
    b.tube(DARK, rim, 0.016, segments=8, closed=True)
    b.sphere(DARK, (0, 0, 0), 0.045, segments=12, rings=8)
    b.tube(DARK, [(0, 0, 0), (0, -0.2, -0.1)], 0.03, segments=8)
    for end in ((-0.17, 0, 0.02), (0.17, 0, 0.02), (0, 0.06, -0.13)):
        b.tube(DARK, [(0, 0, 0), end], 0.014, segments=6)


def mirror(b: MeshBuilder) -> None:
    """Add a rear-view mirror, its glass to the driver behind it."""
    b.box(DARK, (0, 0, 0), (0.24, 0.03, 0.075), bevel=0.014)
    b.box("chrome", (0, 0.016, 0), (0.215, 0.004, 0.056))
    b.cylinder(DARK, (0, 0, 0.03), (0, -0.04, 0.12), 0.01, segments=6)


def lever(b: MeshBuilder) -> None:
    """Add the bar under the front edge of a seat by which it slides."""
    b.tube("chrome", [(-0.16, 0.04, 0), (-0.16, -0.03, 0), (0.16, -0.03, 0), (0.16, 0.04, 0)], 0.012, segments=8)


def pedals(b: MeshBuilder) -> None:
    """Add clutch, brake and accelerator."""
    for x, wide, low in ((-0.13, 0.07, 0.0), (0.0, 0.09, 0.0), (0.13, 0.05, -0.03)):
        b.box("rubber", (x, 0.02, low), (wide, 0.02, 0.09), bevel=0.006)
        b.tube("chrome", [(x, 0.0, low), (x, -0.06, 0.1)], 0.009, segments=6)


def seat_cushions(b: MeshBuilder, wide: float, high: float) -> None:
    """Add a seat on its base.

    Args:
        b: Receives the parts.
        wide: Metres across.
        high: Metres from the floor to sitting height.
    """
    b.box(DARK, (0, 0.24, -high / 2 - 0.03), (wide * 0.9, 0.4, high - 0.06))
    b.cushion(_COVER, (0, 0.25, -0.06), (wide, 0.52, 0.16), softness=0.25)
    b.cushion(_COVER, (0, 0.56, 0.3), (wide, 0.15, 0.66), softness=0.25, rotation=(-12, 0, 0))


@prop("steering_wheel")
def loose_steering_wheel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a steering wheel."""
    steering_wheel(b)
    return ()


@prop("rear_view_mirror")
def loose_mirror(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rear-view mirror."""
    mirror(b)
    return ()


@prop("seat_lever")
def loose_lever(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lever."""
    lever(b)
    return ()


@prop("car_pedals")
def loose_pedals(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a set of pedals."""
    pedals(b)
    return ()


@prop("car_mat")
def loose_mat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rubber mat."""
    w, d, h = spec.size
    b.box(spec.material("cover"), (0, 0, h / 2), (w, d, h), bevel=0.004)
    return ()
