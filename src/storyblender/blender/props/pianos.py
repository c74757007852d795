"""Prop builders: the upright and the grand piano."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean, seat
from storyblender.blender.props.parts import turned_leg
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.memory.asset_sheet import Anchor

WHITE_KEYS = 52
BLACK_AFTER = (0, 2, 3, 5, 6)
"""White keys of an octave starting on A that have a black key to their right."""
STOOL = 0.62
"""Depth that the player's stool adds in front of a piano, metres."""


def _stool(b: MeshBuilder, spec: PropSpec, front: float) -> Anchor:
    """Add the player's stool before a keyboard whose front is at y ``front``; the player faces the keys."""
    wood, top = spec.material("body"), spec.material("black")
    y, height = front - STOOL + 0.19, 0.49
    b.box(top, (0, y, height - 0.03), (0.58, 0.36, 0.06), bevel=0.018)
    b.box(wood, (0, y, height - 0.085), (0.5, 0.3, 0.05))
    for sx in (-1, 1):
        for sy in (-1, 1):
            turned_leg(b, wood, sx * 0.23, y + sy * 0.13, height - 0.1, 0.035)
    return seat((0, y + 0.18, height), (0.58, 0.34), (0.0, 1.0, 0.0), "stool")


def _keyboard(b: MeshBuilder, spec: PropSpec, width: float, front: float, height: float) -> None:
    """Add 88 keys over ``width`` whose front edge is at y ``front`` and top at ``height``."""
    white, black = spec.material("white"), spec.material("black")
    step = width / WHITE_KEYS
    for i in range(WHITE_KEYS):
        x = (i + 0.5) * step - width / 2
        b.box(white, (x, front + 0.075, height - 0.01), (step * 0.93, 0.15, 0.02))
        if i % 7 in BLACK_AFTER and i < WHITE_KEYS - 1:
            b.box(black, (x + step / 2, front + 0.1, height + 0.006), (step * 0.55, 0.095, 0.014), bevel=0.002)


@prop("piano")
def piano(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an upright piano."""
    (w, d, h), wood = spec.size, spec.material("body")
    d -= STOOL
    back = d / 2
    body = d * 0.52
    b.box(wood, (0, back - body / 2, h / 2 - 0.02), (w - 0.08, body, h - 0.04), bevel=0.006)
    b.box(wood, (0, back - body / 2 - 0.01, h - 0.02), (w, body + 0.04, 0.04), bevel=0.012)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.025), back - body / 2, h / 2 - 0.02), (0.05, body, h - 0.04), bevel=0.008)
        b.box(wood, (x * (w / 2 - 0.045), -d / 2 + (d - body) / 2 + 0.01, 0.7), (0.09, d - body, 0.14), bevel=0.012)
        turned_leg(b, wood, x * (w / 2 - 0.06), -d / 2 + 0.08, 0.62, 0.05)
        b.box("brass", (x * 0.08, back - body - 0.04, 0.06), (0.035, 0.12, 0.015), bevel=0.004)
    b.box(wood, (0, -d / 2 + (d - body) / 2 + 0.02, 0.64), (w - 0.1, d - body, 0.06), bevel=0.008)
    face = back - body - 0.012
    b.box(wood, (0, face, 0.33), (w - 0.24, 0.02, 0.44), bevel=0.008)
    b.box(wood, (0, face, 0.99), (w - 0.2, 0.02, 0.3), bevel=0.008)
    b.box(wood, (0, face - 0.03, 0.95), (w * 0.5, 0.018, 0.2), bevel=0.005, rotation=(-14, 0, 0))
    b.box("paper", (0.0, face - 0.045, 0.97), (0.36, 0.004, 0.25), rotation=(-14, 0, 0))
    _keyboard(b, spec, w - 0.24, -d / 2 + 0.05, 0.735)
    b.box(wood, (0, face - 0.05, 0.79), (w - 0.1, 0.02, 0.12), bevel=0.005, rotation=(-20, 0, 0))
    stool = _stool(b, spec, -d / 2)
    return (
        stool,
        handle((w / 2 - 0.1, -d / 2 + 0.08, 0.77), name="lid"),
        lean((0, -d / 2, 0.735), w - 0.24, name="keys"),
        lean((w / 2, back - body / 2, h), body, (-1, 0, 0), "end"),
    )


@prop("grand_piano")
def grand_piano(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a grand piano with its lid on the stick."""
    (w, d, _), wood, brass = spec.size, spec.material("body"), spec.material("metal")
    d -= STOOL
    rim, case = 0.98, 0.3
    plan = np.array([
        (-0.5, -0.36), (0.5, -0.36), (0.5, -0.2), (0.485, -0.08), (0.43, 0.04), (0.33, 0.12), (0.22, 0.2), (0.14, 0.3),
        (0.06, 0.42), (-0.05, 0.48), (-0.18, 0.5), (-0.32, 0.48), (-0.43, 0.41), (-0.49, 0.3), (-0.5, 0.15),
    ]) * (w, d)  # fmt: skip
    b.extrude(wood, plan, case, base=rim - case)
    b.extrude(brass, plan * 0.93, 0.01, base=rim - 0.005)
    for k in range(14):
        x = -w * 0.42 + k * w * 0.045
        start, end = (x, -d * 0.26, rim + 0.012), (x - 0.02, d * (0.36 - 0.016 * k), rim + 0.012)
        b.cylinder("steel", start, end, 0.002, segments=4, caps=False)
    b.box(wood, (0, -d * 0.43, rim - case + 0.04), (w, d * 0.14, 0.08), bevel=0.01)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.05), -d * 0.42, rim - case / 2 - 0.03), (0.1, d * 0.14, 0.22), bevel=0.02)
        turned_leg(b, wood, x * (w / 2 - 0.14), -d * 0.34, rim - case, 0.075)
    turned_leg(b, wood, -w * 0.16, d * 0.36, rim - case, 0.075)
    _keyboard(b, spec, w - 0.26, -d * 0.49, 0.745)
    b.box(wood, (0, -d * 0.4, 0.82), (w - 0.2, 0.02, 0.14), bevel=0.005)
    with b.at((0, -d * 0.3, rim + 0.02), (-18, 0, 0)):
        b.box(wood, (0, 0, 0.13), (w * 0.46, 0.015, 0.24), bevel=0.004)
        b.box("paper", (0, -0.012, 0.14), (0.4, 0.004, 0.26))
    open_angle = 33.0
    with b.at((-w / 2, 0, rim + 0.01), (0, -open_angle, 0)):
        lid = plan[plan[:, 1] > -d * 0.25] + (w / 2, 0)
        b.extrude(wood, np.r_[[(0, -d * 0.22)], [(w, -d * 0.22)], lid[lid[:, 1] > -d * 0.2]], 0.02)
    b.cylinder(wood, (w * 0.42, -d * 0.1, rim), (w * 0.28, -d * 0.1, rim + 0.5), 0.012, segments=8)
    for x in (-0.06, 0, 0.06):
        b.box(brass, (x, -d * 0.32, 0.07), (0.03, 0.12, 0.012), bevel=0.003)
    b.box(wood, (0, -d * 0.27, 0.4), (0.16, 0.05, rim - case - 0.3), bevel=0.006)
    b.box(wood, (0, -d * 0.28, 0.09), (0.24, 0.08, 0.05), bevel=0.006)
    stool = _stool(b, spec, -d * 0.49)
    return (
        stool,
        handle((w / 2 - 0.1, -d * 0.44, 0.82), name="lid"),
        lean((0, -d * 0.49, 0.745), w - 0.26, name="keys"),
        lean((w / 2, 0.0, rim), d * 0.4, (-1, 0, 0), "bend"),
    )
