"""Prop builders: small things of kitchens, baths and pockets: scoop, thermos, lunch box, sponge, wallet, lipstick."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_pinching, grips_under, two_hands
from storyblender.blender.props.ordinary_hardware import ring_of
from storyblender.blender.props.parts import bent, rectangle
from storyblender.blender.props.registry import PropSpec, prop


@prop("ice_cream_scoop")
def ice_cream_scoop(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a scoop that lies with its hollow up at -Y, and its lever."""
    (w, d, h), metal = spec.size, spec.material("metal")
    r = w / 2
    half = [(r * math.sin(a), r * (1 - math.cos(a))) for a in np.linspace(0.05, math.pi / 2, 8)]
    shell = [*half, *((x * 0.92, z + 0.06 * r) for x, z in half[::-1])]
    b.lathe(metal, shell, origin=(0, r - d / 2, 0), segments=24)
    b.tube(metal, [(0, 2 * r - d / 2 - 0.004, 0.8 * r), (0, 0, 0.7 * h), (0, 0.1 * d, 0.7 * h)], 0.006)
    curve = [(0.2, 0), (0.36, 0.1), (0.3, 0.5), (0.4, 0.9), (0.1, 1.0)]
    b.lathe(
        spec.material("handle"), bent(curve) * (w, 0.42 * d), origin=(0, 0.08 * d, 0.7 * h), axis=(0, 1, 0), segments=16
    )
    b.box(metal, (0, 0.02 * d, 0.94 * h), (0.012, 0.12 * d, 0.004), rotation=(-12, 0, 0))
    return two_hands((-0.016, 0.28 * d, 0.7 * h), (0.2, -0.6, -0.75), (1, 0.1, 0), FIST)


@prop("thermos")
def thermos(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a vacuum flask with its cup on top, a band of steel and a handle."""
    r, h, body, metal = spec.size[1] / 2, spec.size[2], spec.material("body"), spec.material("metal")
    b.lathe(metal, [(0.96 * r, 0), (r, 0.01 * h), (r, 0.07 * h)], segments=26)
    b.lathe(body, [(0.98 * r, 0.07 * h), (0.98 * r, 0.6 * h), (0.9 * r, 0.67 * h)], segments=26)
    b.lathe(metal, [(0.92 * r, 0.67 * h), (0.92 * r, 0.7 * h)], segments=26)
    cup = [(0.9 * r, 0.7 * h), (0.95 * r, 0.72 * h), (0.86 * r, 0.97 * h), (0.78 * r, h)]
    b.lathe(spec.material("cup"), cup, segments=26)
    grip = [(0.96 * r, 0, 0.56 * h), (1.7 * r, 0, 0.54 * h), (1.7 * r, 0, 0.24 * h), (0.96 * r, 0, 0.2 * h)]
    b.tube("plastic_black", bent(grip, 4), 0.13 * r, segments=8)
    return grips_around(r, 0.45 * h, (0.5, 0.55, 0.4))


@prop("lunch_box")
def lunch_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a workman's lunch box: a domed lid with clasps and a handle on top."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    low = 0.5 * h
    b.rounded_box(body, (0, 0, low / 2), (w, d, low), 0.012)
    arch = [(0.5 * d * math.cos(a), 0.36 * h * math.sin(a)) for a in np.linspace(0, math.pi, 15)]
    with b.at((-w / 2, 0, low), (90, 0, 90)):
        b.extrude(body, arch, w)
    b.box(metal, (0, 0, low), (1.01 * w, 1.02 * d, 0.014))
    for x in (-0.28, 0.28):
        b.box(metal, (x * w, -d / 2 - 0.002, low), (0.026, 0.008, 0.044), bevel=0.002)
    grip = [(-0.2 * w, 0, 0.85 * h), (-0.16 * w, 0, 0.98 * h), (0.16 * w, 0, 0.98 * h), (0.2 * w, 0, 0.85 * h)]
    b.tube(metal, bent(grip), 0.006)
    return two_hands((0.0, 0.016, 0.985 * h), (0.9, -0.3, 0), (0, -0.2, -0.97), FIST)


@prop("sponge")
def sponge(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a washing-up sponge with a rough green side on top and holes in its flanks."""
    w, d, h = spec.size
    b.rounded_box(spec.material("foam"), (0, 0, 0.38 * h), (w, d, 0.76 * h), 0.005)
    b.rounded_box(spec.material("rough"), (0, 0, 0.87 * h), (w, d, 0.26 * h), 0.003)
    for x, z in spec.rng.uniform((-0.45, 0.1), (0.45, 0.66), (14, 2)):
        b.sphere("wood_dark", (x * w, -0.497 * d, z * h), 0.0016, scale=(1.3, 0.5, 1), segments=6, rings=4)
    return two_hands((-w / 2, 0.0, 0.5 * h), (0.2, -0.9, -0.3), (1, 0, 0), (0.4, 0.5, 0.35))


@prop("toast")
def toast(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a slice of toast that lies flat, the butter melting on it."""
    (w, d, h), crumb = spec.size, spec.material("crumb")
    half = [(0.0, -0.5), (0.4, -0.49), (0.46, -0.4), (0.43, 0.1), (0.5, 0.26), (0.4, 0.46), (0.12, 0.47), (0.0, 0.45)]
    right = bent([(x * w, y * d) for x, y in half], 3)
    slice_ = np.concatenate([right, (right * (-1, 1))[-2:0:-1]])
    b.extrude(spec.material("crust"), slice_, 0.94 * h)
    b.extrude(crumb, slice_ * 0.9, 0.06 * h, base=0.93 * h)
    center = (0.08 * w, -0.06 * d, h)
    b.box(spec.material("butter"), center, (0.24 * w, 0.2 * d, 0.3 * h), bevel=0.002, rotation=(0, 0, 20))
    return two_hands((-w / 2, 0.0, h / 2), (0.2, -0.95, -0.1), (0.95, 0, -0.2), (0.4, 0.45, 0.6))


@prop("sausage")
def sausage(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build two sausages that hang together by a twist of skin."""
    (w, d, h), meat = spec.size, spec.material("meat")
    for x in (-1, 1):
        line = bent([(0.03, -0.4, 0.5), (0.16, 0.1, 0.5), (0.32, 0.1, 0.5), (0.48, -0.3, 0.5)], 5)
        share = np.sin(math.pi * np.linspace(0.02, 0.98, len(line))) ** 0.35
        b.tube(meat, [(x * i * w, j * 0.5 * d, k * h) for i, j, k in line], list(share * h / 2), segments=12)
    b.tube(meat, [(-0.04 * w, -0.2 * d, 0.5 * h), (0.04 * w, -0.2 * d, 0.5 * h)], 0.1 * h, segments=8)
    return grips_pinching(-0.1 * d, 0.3 * h)


@prop("wallet")
def wallet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folded wallet that lies flat, banknotes looking out at +Y."""
    (w, d, h), leather = spec.size, spec.material("leather")
    for z in (0.2, 0.8):
        b.rounded_box(leather, (0, -0.02 * d, z * h), (w, 0.94 * d, 0.34 * h), 0.003)
    fold = [(-w / 2, -0.48 * d, 0.5 * h), (-w / 2, 0.44 * d, 0.5 * h)]
    b.tube(leather, fold, 0.46 * h, segments=10)
    for k in range(3):
        center = (0.02 * w, (0.04 + 0.01 * k) * d, (0.42 + 0.08 * k) * h)
        b.box(spec.material("notes"), center, (0.94 * w, 0.9 * d, 0.05 * h))
    stitch = rectangle(0.9 * w, 0.84 * d, 40, 0.004)
    b.tube("linen", np.c_[stitch - (0, 0.02 * d), np.full(40, 0.97 * h)], 0.0005, segments=4, closed=True)
    return two_hands((-w / 2, 0.2 * d, h / 2), (0.3, -0.9, 0), (0.95, 0.2, 0.1), (0.45, 0.55, 0.4)) + grips_under(
        0.4 * d
    )


@prop("lipstick")
def lipstick(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open lipstick that stands, its tip cut at a slant."""
    r, h = spec.size[0] / 2, spec.size[2]
    b.lathe("plastic_black", [(0.96 * r, 0), (r, 0.02 * h), (r, 0.44 * h), (0.9 * r, 0.46 * h)], segments=20)
    b.lathe(spec.material("case"), [(0.8 * r, 0.46 * h), (0.8 * r, 0.68 * h), (0.72 * r, 0.69 * h)], segments=20)
    t = np.linspace(0, math.tau, 19)[:-1]
    circle = np.c_[0.66 * r * np.cos(t), 0.66 * r * np.sin(t)]
    slant = np.c_[circle, (0.9 + 0.1 * np.sin(t)) * h]
    b.loft(spec.material("stick"), [np.c_[circle, np.full(18, 0.66 * h)], slant])
    return grips_around(r, 0.3 * h, (0.6, 0.7, 0.5))


@prop("pill_bottle")
def pill_bottle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bottle of pills with a ribbed white cap and a label to -Y; two pills lie before it."""
    r, h, body = 0.5 * spec.size[0], spec.size[2], spec.material("body")
    b.lathe(body, [(0.86 * r, 0), (0.9 * r, 0.02 * h), (0.9 * r, 0.72 * h), (0.8 * r, 0.76 * h)], segments=24)
    b.lathe(spec.material("label"), [(0.92 * r, 0.14 * h), (0.92 * r, 0.6 * h)], segments=24, caps=False)
    for k in range(4):
        b.box("plastic_black", (0, -0.92 * r, (0.5 - 0.09 * k) * h), ((0.9 - 0.15 * (k % 2)) * r, 0.05 * r, 0.025 * h))
    b.lathe(spec.material("cap"), [(r, 0.76 * h), (r, 0.96 * h), (0.94 * r, h)], segments=24)
    for k in range(24):
        turn = math.tau * k / 24
        x, y = r * math.cos(turn), r * math.sin(turn)
        b.cylinder(spec.material("cap"), (x, y, 0.78 * h), (x, y, 0.95 * h), 0.05 * r, segments=5)
    for x in (-0.5, 0.3):
        b.sphere(spec.material("cap"), (x * r, -1.6 * r, 0.05 * h), 0.05 * h, scale=(1.4, 1.4, 1), segments=10, rings=6)
    return grips_around(r, 0.4 * h, (0.6, 0.65, 0.5))


@prop("milk_carton")
def milk_carton(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a carton with a gabled top and a coloured band."""
    (w, d, h), card = spec.size, spec.material("card")
    b.box(card, (0, 0, 0.38 * h), (w, d, 0.76 * h), bevel=0.002)
    with b.at((-w / 2, 0, 0.75 * h), (90, 0, 90)):
        b.extrude(card, [(-0.48 * d, 0), (0.48 * d, 0), (0.03 * d, 0.18 * h), (-0.03 * d, 0.18 * h)], w)
    b.box(card, (0, 0, 0.96 * h), (w, 0.05 * d, 0.08 * h))
    b.box(spec.material("band"), (0, 0, 0.56 * h), (1.01 * w, 1.01 * d, 0.1 * h))
    b.box(spec.material("band"), (0, 0, 0.16 * h), (1.01 * w, 1.01 * d, 0.2 * h))
    profile = [(0.16 * w, 0), (0.15 * w, 0.12 * w)]
    b.lathe(spec.material("band"), profile, origin=(0, -0.27 * d, 0.84 * h), axis=(0, -0.75, 0.7))
    return grips_around(w / 2, 0.45 * h, (0.35, 0.4, 0.3))


@prop("credit_card")
def credit_card(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bank card that lies flat, with its chip and number."""
    (w, d, h), body = spec.size, spec.material("body")
    b.extrude(body, rectangle(w, d, 40, 0.0035), h)
    b.box("gold", (-0.32 * w, 0.08 * d, h), (0.14 * w, 0.18 * d, 0.0004))
    for k in range(4):
        b.box("wax", ((-0.32 + 0.21 * k) * w, -0.14 * d, h), (0.17 * w, 0.07 * d, 0.0004))
    b.box("wax", (-0.2 * w, -0.33 * d, h), (0.42 * w, 0.05 * d, 0.0004))
    for x in (0.3, 0.38):
        b.lathe(
            "brass" if x < 0.35 else "fabric_red", [(0.07 * w, 0), (0.07 * w, x * 0.0016)], origin=(x * w, 0.3 * d, h)
        )
    return grips_pinching(0.2 * d, 0.0)


@prop("firework")
def firework(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a firework rocket, point up on its stick, striped, with a fuse."""
    (w, _, h), paper, stripe = spec.size, spec.material("paper"), spec.material("stripe")
    r, low = 0.42 * w, 0.56 * h
    b.cylinder("wood_light", (0.0, r + 0.003, 0), (0.0, r + 0.003, 0.86 * h), 0.0035, segments=8)
    b.cylinder(paper, (0, 0, low), (0, 0, 0.86 * h), r, segments=20)
    t = np.linspace(0, 1, 25)
    for k in range(3):
        turn = math.tau * (1.2 * t + k / 3)
        b.tube(stripe, np.c_[r * np.cos(turn), r * np.sin(turn), low + 0.3 * h * t], 0.1 * r, segments=6)
    b.lathe(stripe, [(1.12 * r, 0.86 * h), (0.01 * r, h)], segments=20)
    b.tube("linen", bent([(0, 0, low), (0.2 * r, 0, low - 0.02), (0.8 * r, 0, low - 0.04)]), 0.0014, segments=6)
    return two_hands((-0.01, r, 0.3 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("firecrackers")
def firecrackers(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plait of firecrackers that lies along Y, its fuse to +Y."""
    (w, d, h), paper = spec.size, spec.material("paper")
    fuse = bent([(0, -0.44, 0.5), (0, 0.3, 0.5), (0.2, 0.42, 0.3), (0.05, 0.5, 0.2)]) * (w, d, h)
    b.tube("linen", fuse, 0.0018, segments=6)
    for k in range(11):
        y = (-0.44 + 0.07 * k) * d
        for x in (-1, 1):
            tip = (0.47 * x * w, y - 0.03 * d, (0.32 + 0.3 * (k % 2)) * h)
            b.cylinder(paper, (0.06 * x * w, y + 0.01 * d, 0.5 * h), tip, 0.24 * h, segments=10)
            b.cylinder("brass", tip, np.add(tip, (0.01 * x * w, 0, 0)), 0.25 * h, segments=10)
    return grips_pinching(0.36 * d, 0.0)


@prop("cymbal")
def cymbal(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cymbal that lies bell up, a leather strap through it."""
    r, h, brass = spec.size[0] / 2, spec.size[2], spec.material("brass")
    dome = bent([(1.0, 0.0), (0.6, 0.2), (0.3, 0.34), (0.22, 0.5), (0.12, 0.7), (0.03, 0.76)], 4) * (r, h)
    b.lathe(brass, np.concatenate([dome, dome[::-1] - (0, 0.03 * h)]), segments=44)
    for k in range(5):
        share = 0.36 + 0.13 * k
        path = ring_of(share * r, 40, float(np.interp(share, (0.3, 0.6, 1), (0.34, 0.2, 0))) * h)
        b.tube(brass, path, 0.0008, segments=4, closed=True)
    strap = [(-0.02, 0, 0.74 * h), (-0.05, 0, 0.92 * h), (0, 0, h), (0.05, 0, 0.92 * h), (0.02, 0, 0.74 * h)]
    b.tube(spec.material("strap"), bent(strap), 0.004, segments=6)
    return two_hands((0.0, 0.0, 0.98 * h), (0, -1, 0), (0, 0, -1), FIST)
