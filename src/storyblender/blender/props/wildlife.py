"""More four-legged animals on the shared plan: badger, hedgehog, donkey, zebra, giraffe. They face -Y."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.beasts import BEAR, DARK, FOX, MOUSE, Plan, beast, scaled
from storyblender.blender.props.hoofed import DEER
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import Builder, PropSpec, prop

WHITE = "linen"
BADGER = Plan(
    trunk=0.5, chest=0.15, leg=0.1, foot=0.026, neck=(0.13, 0.0), head=0.085, snout=(0.12, 0.03), ear=(0.04, 0.045, 45),
    tail=((0.08, -0.02), (0.16, -0.06)), bushy=0.035, broad=0.95,
)  # fmt: skip
HEDGEHOG = Plan(0.14, 0.07, 0.02, 0.011, (0.03, -0.02), 0.04, (0.05, 0.009), (0.022, 0.026, 40), (), broad=0.95)
RAT = replace(
    MOUSE, trunk=0.15, chest=0.036, leg=0.02, foot=0.007, neck=(0.024, 0.004), head=0.028, snout=(0.034, 0.008),
    ear=(0.028, 0.026, 30), tail=((0.06, -0.03), (0.16, -0.04), (0.26, -0.03)), bushy=0.006,
)  # fmt: skip
DONKEY = Plan(
    trunk=0.95, chest=0.26, leg=0.6, foot=0.038, neck=(0.26, 0.4), head=0.13, snout=(0.22, 0.07), ear=(0.27, 0.075, 18),
    tail=((0.08, -0.1), (0.1, -0.45)), bushy=0.03, hooves=True,
)  # fmt: skip
ZEBRA = Plan(
    trunk=1.1, chest=0.3, leg=0.62, foot=0.042, neck=(0.3, 0.48), head=0.14, snout=(0.24, 0.075), ear=(0.17, 0.075, 18),
    tail=((0.08, -0.1), (0.1, -0.45)), bushy=0.035, hooves=True,
)  # fmt: skip
GIRAFFE = Plan(
    trunk=1.3, chest=0.42, leg=1.6, foot=0.065, neck=(0.6, 1.9), head=0.17, snout=(0.28, 0.085), ear=(0.18, 0.07, 60),
    tail=((0.1, -0.2), (0.12, -0.8)), bushy=0.03, hooves=True,
)  # fmt: skip
CAMEL = Plan(
    1.3, 0.4, 1.0, 0.06, (0.55, 0.55), 0.15, (0.22, 0.075), (0.1, 0.06, 40), ((0.08, -0.15), (0.1, -0.5)), 0.03
)
HIPPO = Plan(
    1.9, 0.58, 0.35, 0.16, (0.5, 0.1), 0.36, (0.34, 0.3), (0.12, 0.1, 30), ((0.08, -0.2),), 0.05, broad=1.0, waist=1.0
)
RHINO = Plan(
    1.9, 0.55, 0.45, 0.15, (0.5, 0.0), 0.3, (0.36, 0.18), (0.2, 0.12, 25), ((0.08, -0.3),), 0.05, broad=0.95, waist=0.98
)
OTTER = Plan(
    trunk=0.5, chest=0.1, leg=0.07, foot=0.022, neck=(0.13, 0.06), head=0.07, snout=(0.05, 0.03), ear=(0.025, 0.03, 45),
    tail=((0.14, -0.06), (0.3, -0.1), (0.42, -0.11)), bushy=0.045,
)  # fmt: skip
RACCOON = Plan(
    trunk=0.4, chest=0.13, leg=0.13, foot=0.022, neck=(0.1, 0.08), head=0.08, snout=(0.075, 0.018),
    ear=(0.06, 0.06, 25), tail=((0.1, 0.02), (0.2, 0.0), (0.3, -0.06)), bushy=0.06,
)  # fmt: skip
MOOSE = replace(
    DEER, trunk=1.4, chest=0.36, leg=0.95, foot=0.05, neck=(0.38, 0.42), head=0.17, snout=(0.32, 0.11),
    ear=(0.24, 0.1, 55),
)  # fmt: skip
MOLE = Plan(
    0.1, 0.035, 0.008, 0.008, (0.015, 0.0), 0.028, (0.03, 0.007), (0.004, 0.004, 30), ((0.02, -0.01),), 0.005, broad=1.0
)
KID = Plan(
    trunk=0.46, chest=0.13, leg=0.26, foot=0.02, neck=(0.14, 0.2), head=0.075, snout=(0.09, 0.035),
    ear=(0.09, 0.04, 80), tail=((0.04, 0.03), (0.06, 0.07)), bushy=0.018, hooves=True,
)  # fmt: skip

Extra = Callable[[MeshBuilder, PropSpec, Plan], None]


def _badger(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a badger's white face with two black bands, and dark fur on the legs."""
    (y, z), r, (long, nose) = plan.skull, plan.head, plan.snout
    tip = y - r * 0.7 - long
    for x, width, skin, out in (
        (0.0, 0.3, WHITE, 1.03),
        (-1, 0.24, DARK, 1.0),
        (1, 0.24, DARK, 1.0),
        (-2, 0.26, WHITE, 0.98),
        (2, 0.26, WHITE, 0.98),
    ):
        across = x * 0.42 * r
        curve = [
            (across, y + r * 0.55, z + r * 0.82 * out),
            (across * 1.05, y - r * 0.3, z + r * 0.92 * out),
            (across * 0.8, y - r * 0.9, z + r * 0.4),
            (across * 0.35, tip + nose, z - r * 0.32 + nose),
        ]
        path = bent(curve)
        b.tube(skin, path, tuple(np.linspace(r * width, nose * 0.35, len(path))), segments=8)


def _hedgehog(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a hedgehog's spines."""
    z = plan.middle + 0.008
    for k in range(190):
        along, turn = 1 - 2 * (k + 0.5) / 190, 2.39996 * k
        across = np.sqrt(1 - along**2)
        way = np.array((across * np.cos(turn), along * 0.9 + 0.1, across * np.sin(turn)))
        if way[2] < -0.35 or way[1] < -0.72:
            continue
        root = np.array((0, 0.01, z)) + way * (0.062, 0.095, 0.066)
        b.cylinder("leather", root, root + way * 0.03 + (0, 0.012, 0), 0.0055, 0.0006, segments=4)


def _stripes(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a zebra's stripes and mane."""
    for k in range(10):
        y = -0.5 * plan.trunk + plan.trunk * k / 9
        angle = np.linspace(-2.0, 2.0, 13)
        r = plan.chest * (1.035 if k < 6 else 0.95)
        path = np.c_[
            r * plan.broad * np.sin(angle), np.full(13, y) + 0.04 * np.abs(angle), plan.middle + r * np.cos(angle)
        ]
        b.tube(DARK, path, tuple(0.004 + 0.026 * np.cos(np.linspace(-1.4, 1.4, 13))), segments=6)
    (y, z) = plan.skull
    for k in range(6):
        t = k / 5
        at = (
            0,
            (1 - t) * -0.36 * plan.trunk + t * (y + plan.head),
            (1 - t) * (plan.middle + plan.chest * 0.9) + t * (z + plan.head),
        )
        b.cushion(DARK, at, (0.05, 0.12, 0.2), softness=0.8, rotation=(35, 0, 0))


def _giraffe(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a giraffe's spots and horns."""
    for k in range(46):
        along, turn = 1 - 2 * (k + 0.5) / 46, 2.39996 * k
        across = np.sqrt(1 - along**2)
        if np.sin(turn) * across < -0.45:
            continue
        at = (
            plan.chest * plan.broad * across * np.cos(turn),
            along * plan.trunk * 0.5,
            plan.middle + plan.chest * across * np.sin(turn),
        )
        b.sphere("leather", at, 0.1, scale=(0.7, 1, 1), segments=8, rings=5)
    y, z = plan.skull
    for k in range(9):
        t = 0.15 + 0.075 * k
        for x in (-1, 1):
            at = (
                x * 0.17 * (1 - 0.45 * t),
                (1 - t) * -plan.trunk * 0.4 + t * y + 0.02,
                (1 - t) * (plan.middle + 0.25) + t * z,
            )
            b.sphere("leather", at, 0.085, scale=(0.5, 1, 1), segments=8, rings=5)
    for x in (-1, 1):
        b.cylinder("leather", (x * 0.06, y + 0.04, z + 0.12), (x * 0.08, y + 0.06, z + 0.34), 0.025, segments=7)
        b.sphere(DARK, (x * 0.08, y + 0.06, z + 0.35), 0.035, segments=8, rings=5)


def _hump(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a camel's two humps."""
    for y in (-0.28, 0.3):
        b.cushion(spec.material("coat"), (0, y, plan.middle + plan.chest), (0.42, 0.5, 0.62), softness=0.9)


def _horns(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a rhinoceros's horns."""
    (y, z), r, (long, _) = plan.skull, plan.head, plan.snout
    for back, size in ((0.0, 0.5), (0.26, 0.28)):
        foot = (0, y - r * 0.6 - long + 0.08 + back, z - r * 0.1 + 0.2 * back)
        path = bent([np.array(foot), np.add(foot, (0, -0.08, size * 0.6)), np.add(foot, (0, -0.02, size))])
        b.tube("wax", path, tuple(np.linspace(0.1, 0.012, len(path))), segments=10)


def _mask(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a raccoon's mask and the rings of its tail."""
    (y, z), r = plan.skull, plan.head
    for x in (-1, 1):
        b.sphere(DARK, (x * r * 0.52, y - r * 0.62, z + r * 0.12), r * 0.4, scale=(1.1, 0.5, 0.7), segments=12, rings=8)
        b.sphere(WHITE, (x * r * 0.5, y - r * 0.92, z + r * 0.22), r * 0.1, segments=8, rings=5)
    for k, (dy, dz) in enumerate(plan.tail):
        at = (0, plan.trunk * 0.55 + dy, plan.middle + plan.chest * 0.35 + dz)
        b.sphere(DARK, at, plan.bushy * (1.08 - 0.2 * k), scale=(1, 0.4, 1), segments=12, rings=7)


def _panda(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a panda's black ears, eyes, shoulders and legs."""
    (y, z), r = plan.skull, plan.head
    for x in (-1, 1):
        b.sphere(DARK, (x * r * 0.8, y + r * 0.15, z + r * 0.85), r * 0.36, segments=12, rings=8)
        b.sphere(DARK, (x * r * 0.5, y - r * 0.8, z + r * 0.15), r * 0.28, scale=(1, 0.5, 1.2), segments=10, rings=7)
        for side in (-0.4, 0.42):
            center = (x * plan.chest * 0.55, side * plan.trunk, plan.leg * 0.62)
            b.cushion(DARK, center, (0.34, 0.36, plan.leg * 1.3), softness=0.7)
    b.cushion(DARK, (0, -plan.trunk * 0.36, plan.middle), (plan.chest * 1.78, 0.34, plan.chest * 2.06), softness=0.9)


def _palms(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a moose's broad antlers and the beard under its throat."""
    (y, z), r = plan.skull, plan.head
    for x in (-1, 1):
        curve = [(x * r * s, y + t, z + r * up) for s, t, up in ((0.5, 0.02, 0.6), (2, 0.05, 1.1), (3.2, 0.12, 1.9))]
        path = bent(curve)
        b.tube("wax", path, tuple(np.linspace(0.05, 0.06, len(path))), segments=8)
        b.cushion(
            "wax", (x * r * 3.5, y + 0.12, z + r * 2.5), (r * 1.1, 0.07, r * 2.4), softness=0.7, rotation=(0, x * 28, 0)
        )
        for k in range(5):
            foot = (x * (r * 3.3 + 0.1 * k), y + 0.12, z + r * (1.4 + 0.62 * k))
            b.cylinder("wax", foot, np.add(foot, (x * 0.22, 0, 0.1)), 0.04, 0.01, segments=6)
    b.cushion(spec.material("coat"), (0, y + 0.02, z - r * 1.7), (0.1, 0.12, 0.34), softness=0.9)
    b.cushion(
        spec.material("coat"), (0, -plan.trunk * 0.36, plan.middle + plan.chest * 0.75), (0.5, 0.6, 0.4), softness=0.9
    )


def _mane(b: MeshBuilder, spec: PropSpec, plan: Plan) -> None:
    """Add a donkey's dark mane and pale muzzle."""
    (y, z), r, (long, nose) = plan.skull, plan.head, plan.snout
    for k in range(6):
        t = k / 5
        at = (
            0,
            (1 - t) * -0.38 * plan.trunk + t * (y + r),
            (1 - t) * (plan.middle + plan.chest * 0.85) + t * (z + r * 0.9),
        )
        b.cushion(DARK, at, (0.04, 0.1, 0.14), softness=0.8, rotation=(35, 0, 0))
    b.sphere(WHITE, (0, y - r * 0.7 - long + nose * 0.6, z - r * 0.42), nose * 1.15, segments=14, rings=9)


PLANS: dict[str, tuple[Plan, Extra | None]] = {
    "badger": (BADGER, _badger), "hedgehog": (HEDGEHOG, _hedgehog), "rat": (RAT, None), "donkey": (DONKEY, _mane),
    "zebra": (ZEBRA, _stripes), "giraffe": (GIRAFFE, _giraffe), "camel": (CAMEL, _hump), "hippo": (HIPPO, None),
    "rhino": (RHINO, _horns), "otter": (OTTER, None), "raccoon": (RACCOON, _mask), "moose": (MOOSE, _palms),
    "panda": (BEAR, _panda), "mole": (MOLE, None), "lamb": (KID, None), "red_panda": (FOX, _mask),
}  # fmt: skip


def _builder(plan: Plan, extra: Extra | None) -> Builder:
    """Return the builder of an animal with a plan and what ``extra`` adds to it."""

    def build(b: MeshBuilder, spec: PropSpec) -> Anchors:
        with b.at(scale=scaled(spec)):
            beast(b, spec.material("coat"), plan)
            if extra is not None:
                extra(b, spec, plan)
        return ()

    return build


for _key, (_plan, _extra) in PLANS.items():
    prop(_key)(_builder(_plan, _extra))
