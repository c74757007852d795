"""Prop builders: linen, clothes and small things of the house."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_at_side, grips_under, two_hands
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop


def _fold(b: MeshBuilder, cloth: MaterialRef, size: tuple[float, float, float], layers: int) -> None:
    """Add folded cloth: soft layers whose fold is at the front."""
    w, d, h = size
    for k in range(layers):
        center = (0, 0.004 * (k % 2), h * (k + 0.5) / layers)
        b.cushion(cloth, center, (w - 0.006 * (k % 3), d, h / layers * 1.18), softness=0.28)


@prop("pillow")
def pillow(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pillow with pinched corners."""
    (w, d, h), cloth = spec.size, spec.material("cloth")
    rings = []
    for t in np.linspace(-1, 1, 13):
        x = np.linspace(-1, 1, 13)
        puff = h / 2 * (np.clip(1 - np.abs(x) ** 2.6, 0, 1) * max(1 - abs(t) ** 2.6, 0)) ** 0.55
        wide = w / 2 * (1 - 0.07 * (1 - x**2)) * x / np.maximum(np.abs(x), 1e-9) * np.abs(x)
        wide = wide * (1 - 0.06 * (1 - t**2))
        y = np.full(13, t * d / 2) * (1 - 0.08 * (1 - x**2))
        upper, lower = np.c_[wide, y, h / 2 + puff], np.c_[wide, y, h / 2 - puff]
        rings.append(np.r_[lower, upper[::-1]])
    b.loft(cloth, rings)
    return two_hands((-w / 2, 0.0, h * 0.5), (0.1, -0.9, -0.4), (1, 0, 0), (0.3, 0.35, 0.3)) + grips_under(d * 0.3)


@prop("blanket")
def blanket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folded blanket with stripes at its edge."""
    (w, d, h), cloth, stripe = spec.size, spec.material("cloth"), spec.material("stripe")
    _fold(b, cloth, (w, d, h), 4)
    for y in (-0.3, -0.18):
        b.cushion(stripe, (0, y * d, h * 0.98), (w * 0.985, d * 0.06, h * 0.14), softness=0.3)
    return grips_at_side(-w / 2, h * 0.35) + grips_under(d * 0.35)


@prop("cloth")
def cloth(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a small cloth, dropped in folds from where it is held."""
    (w, d, h), linen = spec.size, spec.material("cloth")
    angle = np.linspace(0, math.tau, 40, endpoint=False)
    rings = []
    for t in (1.0, 0.8, 0.55, 0.3, 0.08):
        square = 1 / np.maximum(np.abs(np.cos(angle)), np.abs(np.sin(angle))) ** 0.7
        reach = t * square * (1 + 0.09 * np.sin(7 * angle + 2 * t)) / 1.3
        z = h * (1 - t) ** 1.4 + 0.1 * h * t * (1 + np.sin(5 * angle))
        rings.append(np.c_[w / 2 * reach * np.cos(angle), d / 2 * reach * np.sin(angle), z])
    b.loft(linen, rings)
    return grips_around(0.012, h * 0.9, (0.6, 0.65, 0.5))


@prop("folded_clothes")
def folded_clothes(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folded coat or shirt: its collar and buttons on top."""
    (w, d, h), cloth = spec.size, spec.material("cloth")
    _fold(b, cloth, (w, d, h * 0.86), 3)
    top = h * 0.86
    for x in (-1, 1):
        center = (x * w * 0.13, d * 0.36, top)
        b.cushion(cloth, center, (w * 0.28, d * 0.17, h * 0.28), softness=0.5, rotation=(0, x * 8, x * -28))
    b.cushion(cloth, (0, d * 0.44, top), (w * 0.3, d * 0.09, h * 0.3), softness=0.6)
    b.box(cloth, (0.004, -d * 0.1, top + 0.001), (0.03, d * 0.74, 0.006), bevel=0.002)
    for k in range(4):
        start, end = (0.004, -d * 0.4 + k * d * 0.17, top), (0.004, -d * 0.4 + k * d * 0.17, top + 0.008)
        b.cylinder(spec.material("button"), start, end, 0.009, segments=12)
    return grips_at_side(-w / 2, h * 0.35) + grips_under(d * 0.35)


@prop("boots")
def boots(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of boots."""
    (w, d, h), skin, sole = spec.size, spec.material("leather"), spec.material("sole")
    for x in (-1, 1):
        with b.at((x * w * 0.27, 0, 0), (0, 0, x * 5)):
            half = w * 0.19
            sections = [
                (-0.5, 0.06, 0.4, 0.05), (-0.46, 0.11, 0.85, 0.1), (-0.3, 0.14, 1.0, 0.14), (-0.12, 0.2, 0.9, 0.2),
                (0.1, 0.27, 0.85, 0.27),
            ]  # fmt: skip
            angle = np.linspace(0, math.tau, 16, endpoint=False)
            foot = [
                np.c_[
                    half * k * np.cos(angle),
                    np.full(16, y * d),
                    np.maximum(z * h * 1.2 * (0.5 + 0.5 * np.sin(angle)), 0.012),
                ]
                for y, z, k, _ in [*sections, (0.3, 0.24, 0.85, 0.2), (0.42, 0.15, 0.6, 0.1)]
            ]
            b.loft(skin, foot)
            curve = np.multiply([(0.82, 0.1), (0.8, 0.3), (0.92, 0.7), (0.98, 1), (0.86, 1), (0.8, 0.8)], (half, h))
            shaft = bent(curve, 3)
            b.lathe(skin, shaft, origin=(0, d * 0.2, 0), segments=18)
            b.cushion(sole, (0, -d * 0.2, 0.009), (half * 2.1, d * 0.6, 0.018), softness=0.5)
            b.box(sole, (0, d * 0.28, 0.016), (half * 1.6, d * 0.26, 0.032), bevel=0.004)
    return two_hands((-w * 0.3, d * 0.2, h * 0.95), (0.1, -0.4, -0.9), (0.9, 0, 0.1), (0.5, 0.55, 0.4))


@prop("gloves")
def gloves(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of gloves, one on the other."""
    (w, d, h), skin = spec.size, spec.material("leather")
    for k, turn in enumerate((-14, 12)):
        with b.at((0.02 * (2 * k - 1), 0, h * (0.27 + 0.44 * k)), (0, 0, turn)):
            b.cushion(skin, (0, d * 0.05, 0), (w * 0.58, d * 0.42, h * 0.5), softness=0.5)
            b.cushion(skin, (0, d * 0.33, 0), (w * 0.52, d * 0.3, h * 0.46), softness=0.35)
            for finger, (x, long) in enumerate(((-0.2, 0.26), (-0.07, 0.31), (0.06, 0.29), (0.18, 0.22))):
                center = (x * w, -d * (0.1 + long / 2), 0)
                b.cushion(
                    skin, center, (w * 0.13, d * long, h * 0.42), softness=0.7, rotation=(0, 0, 5 * (finger - 1.5))
                )
            b.cushion(skin, (w * 0.34, -d * 0.04, 0), (w * 0.13, d * 0.26, h * 0.4), softness=0.7, rotation=(0, 0, 38))
    return two_hands((-0.012, d * 0.3, h * 0.5), (0.2, -1, 0), (1, 0.2, 0), (0.6, 0.65, 0.4))


@prop("laundry_basket")
def laundry_basket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wicker laundry basket with linen in it."""
    (w, d, h), wicker, linen = spec.size, spec.material("wicker"), spec.material("linen")
    body, angle = h * 0.78, np.linspace(0, math.tau, 40, endpoint=False)
    for inner in (1.0, 0.94):
        rings = [
            np.c_[w / 2 * k * inner * np.cos(angle), d / 2 * k * inner * np.sin(angle), np.full(40, z)]
            for k, z in ((0.8, 0.0), (0.92, body * 0.5), (0.98, body))
        ]
        b.loft(wicker, rings if inner == 1.0 else rings[::-1], caps=inner == 1.0)
    for k, z in ((0.985, body), (0.93, body * 0.55), (0.82, 0.012)):
        line = np.c_[w / 2 * k * np.cos(angle), d / 2 * k * np.sin(angle), np.full(40, z)]
        b.tube(wicker, line, 0.014, segments=6, closed=True)
    for k in range(9):
        turn, reach = 2.4 * k, 0.62 * math.sqrt((k + 0.3) / 9)
        at = (w / 2 * reach * math.cos(turn), d / 2 * reach * math.sin(turn), body * 0.9 + 0.05 * (1 - reach))
        b.cushion(
            linen if k % 3 else "fabric_blue",
            at,
            (w * 0.4, d * 0.45, h * 0.26),
            softness=0.8,
            rotation=(14 * math.sin(k), 16 * math.cos(k), 50 * k),
        )
    for x in (-1, 1):
        path = [
            (x * w * 0.485, -0.09, body),
            (x * w * 0.5, -0.06, h * 0.95),
            (x * w * 0.5, 0.06, h * 0.95),
            (x * w * 0.485, 0.09, body),
        ]
        b.tube(wicker, bent(path), 0.013)
    return two_hands((-w / 2, 0.0, h * 0.9), (0.1, -0.9, -0.2), (0.9, 0, -0.4), FIST)


@prop("candle")
def candle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a burning candle with wax that has run down it."""
    (_, _, h), wax, r = spec.size, spec.material("wax"), spec.size[0] / 2
    stand, top = h * 0.04, h * 0.74
    profile = [
        (r, 0), (r * 0.9, stand), (r * 0.62, stand * 1.6), (r * 0.58, top), (r * 0.5, top + 0.002),
        (r * 0.3, top - 0.004),
    ]  # fmt: skip
    b.lathe(wax, profile, segments=20)
    for k, long in enumerate((0.3, 0.16, 0.22, 0.1)):
        x, y = r * 0.58 * math.cos(1.7 * k), r * 0.58 * math.sin(1.7 * k)
        path = [(x * 0.9, y * 0.9, top), (x, y, top - h * 0.03), (x * 1.04, y * 1.04, top - h * long)]
        b.tube(wax, path, (0.003, 0.0035, 0.0045), segments=6)
    b.cylinder("plastic_black", (0, 0, top), (0, 0, top + h * 0.04), 0.0012, segments=5)
    flame(b, spec.material("flame"), 0, 0, top + h * 0.02, h * 0.24)
    return grips_around(r * 0.6, h * 0.35, (0.75, 0.8, 0.6))


@prop("comb")
def comb(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a comb that lies with its teeth to +X."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (-w * 0.3, 0, h / 2), (w * 0.4, d, h), h * 0.4)
    count = 24
    for k in range(count):
        y = (k + 0.5 - count / 2) * d * 0.96 / count
        b.box(body, (w * 0.2, y, h / 2), (w * 0.6, d * 0.4 / count, h * 0.7))
    for y in (-1, 1):
        b.rounded_box(body, (w * 0.2, y * (d / 2 - 0.003), h / 2), (w * 0.6, 0.006, h), 0.002)
    return two_hands((-w / 2, d * 0.2, h), (0.2, -1, 0), (0.9, 0.2, -0.3), (0.75, 0.8, 0.6))


@prop("hairbrush")
def hairbrush(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a brush that lies on its back, bristles up, its handle at +Y."""
    (w, d, h), body, hair = spec.size, spec.material("body"), spec.material("bristle")
    b.cushion(body, (0, -d * 0.25, h * 0.22), (w, d * 0.5, h * 0.44), softness=0.6)
    b.cushion(body, (0, d * 0.24, h * 0.2), (w * 0.34, d * 0.52, h * 0.36), softness=0.7)
    for i in range(5):
        for j in range(9):
            x, y = (i - 2) * w * 0.15, -d * 0.25 + (j - 4) * d * 0.046
            if (x / w * 2.3) ** 2 + ((y + d * 0.25) / d * 4.2) ** 2 < 0.85:
                b.cylinder(hair, (x, y, h * 0.36), (x, y, h), 0.0032, 0.0024, segments=5)
    return two_hands((-w * 0.16, d * 0.26, h * 0.2), (0.2, -1, 0), (1, 0.2, 0), (0.8, 0.85, 0.6))


@prop("scissors")
def scissors(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of scissors, a little open; the blades point to -Y."""
    (w, d, h), steel, grip = spec.size, spec.material("steel"), spec.material("grip")
    for side in (-1, 1):
        with b.at((0, -d * 0.05, h * (0.3 if side < 0 else 0.65)), (0, 0, side * 9)):
            outline = [(-0.006, 0.03), (0.006, 0.03), (0.007, -d * 0.1), (0.001, -d * 0.45), (-0.004, -d * 0.1)]
            b.extrude(steel, outline, h * 0.25)
            path = [(0, 0.02, 0.001), (side * -0.006, d * 0.16, 0.001), (side * -0.012, d * 0.24, 0.001)]
            b.tube(grip, bent(path), h * 0.35)
            loop = [
                (side * -w * 0.18 + w * 0.19 * math.cos(a), d * 0.37 + d * 0.14 * math.sin(a), 0.001)
                for a in np.linspace(0, math.tau, 22, endpoint=False)
            ]
            b.tube(grip, loop, h * 0.38, segments=8, closed=True)
    b.cylinder(steel, (0, -d * 0.05, 0), (0, -d * 0.05, h), 0.005, segments=12)
    return two_hands((-0.02, d * 0.32, h * 0.6), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.7, 0.8, 0.6))
