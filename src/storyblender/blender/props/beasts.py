"""Prop builders: four-legged animals built from one table of measures, a ``Plan``. They look to -Y."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.animals import Station, both_sides, limb
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

DARK = "plastic_black"
Path = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Plan:
    """The measures of a beast, in metres.

    Attributes:
        trunk: Length from shoulder to rump.
        chest: Half the height of the chest; the waist is ``waist`` of it.
        leg: Height of the belly over the ground.
        foot: Radius of a lower leg.
        neck: How far the head is before the shoulder, and how far above the middle of the trunk.
        head: Radius of the skull.
        snout: Length of the snout, and its radius at the nose.
        ear: Length of an ear, how wide it is, and how far it leans outwards in degrees.
        tail: Points behind and above the rump, (y, z).
        bushy: Radius of the tail in its middle.
        hooves: Whether it walks on hooves.
        broad: Width of the trunk for its height.
        waist: Of the chest.
    """

    trunk: float
    chest: float
    leg: float
    foot: float
    neck: tuple[float, float]
    head: float
    snout: tuple[float, float]
    ear: tuple[float, float, float]
    tail: Path
    bushy: float = 0.02
    hooves: bool = False
    broad: float = 0.8
    waist: float = 0.85

    @property
    def middle(self) -> float:
        """Height of the middle of the trunk."""
        return self.leg + self.chest

    @property
    def skull(self) -> tuple[float, float]:
        """Where the skull is, (y, z)."""
        return (-self.trunk / 2 - self.neck[0], self.middle + self.neck[1])


def beast(b: MeshBuilder, coat: MaterialRef, plan: Plan) -> None:
    """Add a standing animal of one coat, with eyes, ears, nose and tail; it looks to -Y.

    Args:
        b: Receives the parts.
        coat: Material of the whole body.
        plan: Its measures.
    """
    length, chest, z = plan.trunk, plan.chest, plan.middle
    outline = (
        (-0.6, 0.3), (-0.54, 0.78), (-0.4, 1.0), (-0.1, 1.02), (0.2, plan.waist), (0.42, 0.9), (0.54, 0.68),
        (0.6, 0.25),
    )  # fmt: skip
    limb(b, coat, [(0, y * length, z, t * chest * plan.broad, t * chest) for y, t in outline], 18)
    y, top = plan.skull
    throat = max(chest * 0.62, plan.head * 0.8)
    rings = [
        (0, -length * 0.36, z + chest * 0.1, chest * plan.broad * 0.75, chest * 0.75),
        (0, (-length * 0.4 + y) / 2, (z + chest * 0.3 + top) / 2, throat * 0.9, throat),
        (0, y + plan.head * 0.5, top, plan.head * 0.75, plan.head * 0.8),
    ]
    limb(b, coat, rings, 16)
    _head(b, coat, plan)
    _legs(b, coat, plan)
    rump = (length * 0.55, z + chest * 0.35)
    if plan.tail:
        points = np.array([(0, rump[0], rump[1]), *((0, rump[0] + dy, rump[1] + dz) for dy, dz in plan.tail)])
        radii = np.interp(np.linspace(0, 1, len(points)), (0, 0.5, 0.85, 1), np.array((0.6, 1, 0.9, 0.25)) * plan.bushy)
        b.tube(coat, bent(points), tuple(float(r) for r in bent(radii)), segments=10)


def _head(b: MeshBuilder, coat: MaterialRef, plan: Plan) -> None:
    """Add skull, snout, nose, eyes and ears."""
    (y, z), r, (long, nose) = plan.skull, plan.head, plan.snout
    b.sphere(coat, (0, y, z), r, scale=(0.92, 1.05, 0.95), segments=18, rings=11)
    tip = y - r * 0.7 - long
    rings = [
        (0, y - r * 0.3, z - r * 0.15, r * 0.72, r * 0.7),
        (0, y - r * 0.8, z - r * 0.28, (r * 0.55 + nose) / 2, (r * 0.62 + nose) / 2),
        (0, tip + nose * 0.4, z - r * 0.4, nose * 1.05, nose),
        (0, tip, z - r * 0.42, nose * 0.6, nose * 0.6),
    ]
    limb(b, coat, rings)
    center = (0, tip + nose * 0.05, z - r * 0.42 + nose * 0.5)
    b.sphere(DARK, center, nose * 0.45, scale=(1.2, 0.8, 0.8), segments=10, rings=6)
    ear, wide, lean = plan.ear
    for x in (-1, 1):
        b.sphere(DARK, (x * r * 0.5, y - r * 0.82, z + r * 0.22), r * 0.14, segments=8, rings=5)
        with b.at((x * r * 0.55, y + r * 0.1, z + r * 0.6), (0, x * lean, 0)):
            b.cushion(coat, (0, 0, ear * 0.45), (wide, wide * 0.45, ear), softness=0.9)


def _legs(b: MeshBuilder, coat: MaterialRef, plan: Plan) -> None:
    """Add four legs, with hooves where the plan has them."""
    foot, z, length, chest = plan.foot, plan.middle, plan.trunk, plan.chest
    across, knee, floor = chest * plan.broad * 0.62, plan.leg * 0.55, 0.6 * foot
    top = (across * 0.7, z + chest * 0.55, chest * 0.1, chest * 0.3)
    front: list[Station] = [
        (top[0], -length * 0.4, *top[1:]),
        (across, -length * 0.4, z, chest * 0.36, chest * 0.6),
        (across, -length * 0.4, plan.leg * 0.95, foot * 1.7, foot * 2.0),
        (across, -length * 0.41, knee, foot * 1.1, foot * 1.2),
        (across, -length * 0.41, floor * 2, foot, foot * 1.1),
        (across, -length * 0.42, floor, foot, foot),
    ]
    hind: list[Station] = [
        (top[0], length * 0.42, *top[1:]),
        (across, length * 0.4, z, chest * 0.4, chest * 0.75),
        (across, length * 0.38, plan.leg * 1.0, foot * 2.0, foot * 2.8),
        (across, length * 0.47, knee, foot * 1.1, foot * 1.3),
        (across, length * 0.45, floor * 2, foot, foot * 1.1),
        (across, length * 0.44, floor, foot, foot),
    ]
    for leg in (*both_sides(front), *both_sides(hind)):
        limb(b, coat, leg, 12)
        x, y = leg[-1][0], leg[-1][1]
        if plan.hooves:
            b.lathe(DARK, [(foot * 1.35, 0), (foot * 1.1, foot * 1.6)], origin=(x, y, 0), segments=12)
        else:
            b.cushion(coat, (x, y - foot * 0.6, foot * 0.8), (foot * 2.7, foot * 3.6, foot * 1.6), softness=0.8)


def scaled(spec: PropSpec) -> tuple[float, float, float]:
    """Return the scale from the entry's own size to the wanted one."""
    w, d, h = (want / usual for want, usual in zip(spec.size, spec.entry.size, strict=True))
    return (w, d, h)


WOLF = Plan(
    trunk=0.8, chest=0.19, leg=0.42, foot=0.03, neck=(0.2, 0.2), head=0.105, snout=(0.14, 0.036), ear=(0.13, 0.07, 14),
    tail=((0.14, -0.1), (0.22, -0.3), (0.2, -0.46)), bushy=0.062,
)  # fmt: skip
FOX = Plan(
    trunk=0.44, chest=0.09, leg=0.22, foot=0.016, neck=(0.1, 0.11), head=0.062, snout=(0.085, 0.016),
    ear=(0.1, 0.055, 16), tail=((0.12, -0.02), (0.28, -0.06), (0.42, -0.1)), bushy=0.06,
)  # fmt: skip
BEAR = Plan(
    trunk=1.25, chest=0.42, leg=0.42, foot=0.085, neck=(0.3, 0.16), head=0.2, snout=(0.16, 0.075), ear=(0.13, 0.14, 30),
    tail=((0.06, -0.04),), bushy=0.06, broad=0.85, waist=1.0,
)  # fmt: skip
LION = Plan(
    trunk=1.2, chest=0.3, leg=0.5, foot=0.06, neck=(0.26, 0.24), head=0.165, snout=(0.12, 0.085), ear=(0.1, 0.11, 35),
    tail=((0.2, -0.2), (0.32, -0.5), (0.5, -0.6)), bushy=0.028,
)  # fmt: skip
MOUSE = Plan(
    trunk=0.075, chest=0.02, leg=0.007, foot=0.0035, neck=(0.012, 0.0), head=0.0155, snout=(0.014, 0.004),
    ear=(0.02, 0.02, 35), tail=((0.03, -0.02), (0.08, -0.022), (0.13, -0.016)), bushy=0.0022, broad=1.0, waist=1.1,
)  # fmt: skip
ELEPHANT = Plan(
    trunk=2.4, chest=0.8, leg=1.05, foot=0.2, neck=(0.55, 0.35), head=0.48, snout=(0.3, 0.2), ear=(0.3, 0.1, 60),
    tail=((0.12, -0.3), (0.14, -0.9)), bushy=0.05, broad=0.8, waist=1.02,
)  # fmt: skip


@prop("wolf")
def wolf(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing wolf with a mane of longer hair about its neck."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        beast(b, coat, WOLF)
        y, z = WOLF.skull
        for k, (dy, dz, r) in enumerate(((0.1, -0.1, 0.13), (0.16, -0.15, 0.15), (0.03, -0.04, 0.1))):
            b.cushion(coat, (0, y + dy, z + dz), (r * 1.5, r, r * 2), softness=0.9, rotation=(35 + 3 * k, 0, 0))
    return ()


@prop("fox")
def fox(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing fox: white chin and tip of the tail."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("coat"), FOX)
        y, z = FOX.skull
        b.cushion("linen", (0, y - 0.05, z - 0.045), (0.06, 0.12, 0.04), softness=0.9, rotation=(-8, 0, 0))
        rump, top = FOX.trunk * 0.55, FOX.middle + FOX.chest * 0.35
        b.sphere("linen", (0, rump + 0.4, top - 0.095), 0.045, scale=(0.9, 1.5, 0.9), segments=12, rings=8)
    return ()


@prop("bear")
def bear(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bear on all fours, with its hump."""
    coat = spec.material("coat")
    with b.at(scale=scaled(spec)):
        beast(b, coat, BEAR)
        b.cushion(coat, (0, -0.36, BEAR.middle + 0.16), (0.62, 0.9, 0.64), softness=0.9)
    return ()


@prop("lion")
def lion(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lion with its mane."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("coat"), LION)
        y, z = LION.skull
        mane = spec.material("mane")
        for row, (dy, reach, count) in enumerate(((0.02, 0.19, 9), (0.14, 0.22, 9), (0.26, 0.2, 8))):
            for k in range(count):
                turn = 2 * np.pi * (k + 0.5 * row) / count
                at = (reach * np.sin(turn), y + dy, z - 0.03 - 0.05 * row + reach * np.cos(turn))
                b.cushion(mane, at, (0.17, 0.16, 0.2), softness=0.9)
        rump, top = LION.trunk * 0.55, LION.middle + LION.chest * 0.35
        b.sphere(mane, (0, rump + 0.5, top - 0.6), 0.055, scale=(0.9, 1.6, 0.9), segments=10, rings=7)
    return ()


@prop("tiger")
def tiger(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a great cat; ``stripes`` are a tiger's."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("coat"), LION)
        if spec.flag("stripes"):
            for k in range(9):
                y, bend = -0.5 + 0.125 * k, 0.9 + 0.1 * np.cos(0.7 * k)
                angle = np.linspace(-1.8, 1.8, 11) * bend
                path = np.c_[
                    0.262 * np.sin(angle), np.full(11, y) + 0.03 * np.abs(angle), LION.middle + 0.312 * np.cos(angle)
                ]
                b.tube(DARK, path, tuple(0.004 + 0.014 * np.cos(np.linspace(-1.4, 1.4, 11))), segments=6)
    return ()


@prop("mouse")
def mouse(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mouse, or a rat at its size."""
    with b.at(scale=scaled(spec)):
        beast(b, spec.material("coat"), MOUSE)
    return ()


@prop("elephant")
def elephant(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an elephant."""
    skin, tusk = spec.material("skin"), spec.material("tusk")
    with b.at(scale=scaled(spec)):
        beast(b, skin, ELEPHANT)
        y, z = ELEPHANT.skull
        trunk = [(0, y - t, z - up) for t, up in ((0.45, 0.1), (0.72, 0.5), (0.74, 1.1), (0.78, 1.55), (0.98, 1.75))]
        b.tube(skin, bent(trunk), tuple(bent((0.25, 0.19, 0.13, 0.09, 0.07))), segments=14)
        for x in (-1, 1):
            b.cushion(skin, (x * 0.66, y + 0.3, z - 0.1), (0.7, 0.1, 1.05), softness=0.9, rotation=(0, x * 12, x * -32))
            horn = bent([(x * 0.24, y - 0.4, z - 0.4), (x * 0.32, y - 0.75, z - 0.75), (x * 0.3, y - 1.1, z - 0.7)])
            b.tube(tusk, horn, tuple(np.linspace(0.07, 0.015, len(horn))), segments=10)
    return ()
