"""Prop builders: tableware, and a few things to eat and drink."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, grips_under, two_hands
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.parts import bent, bottle_profile
from storyblender.blender.props.registry import PropSpec, prop


@prop("cup")
def cup(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cup with a handle, on a saucer if wanted."""
    (w, _, h), body = spec.size, spec.material("body")
    foot = 0.012 if spec.flag("saucer") else 0.0
    if foot:
        b.lathe(body, [(0.03, 0), (0.045, 0.003), (w / 2, 0.014), (w / 2, 0.017), (0.045, 0.007)], segments=28)
    t = h - foot
    profile = [(0.024, 0), (0.024, 0.006), (0.034, t * 0.25), (0.04, t * 0.7), (0.042, t), (0.039, t), (0.036, t * 0.7)]
    b.lathe(body, profile, origin=(0, 0, foot), segments=24, caps=False)
    b.lathe(spec.material("drink"), [(0.02, t * 0.66), (0.037, t * 0.78)], origin=(0, 0, foot), segments=24)
    loop = [(0.04 + 0.026 * math.sin(a), 0, foot + t * 0.52 + 0.022 * math.cos(a)) for a in np.linspace(0, math.pi, 9)]
    with b.at(rotation=(0, 0, 180)):
        b.tube(body, loop, 0.004)
    return two_hands((-0.052, 0.008, foot + t * 0.5), (0.3, -1, 0), (1, 0.3, 0), (0.7, 0.75, 0.4))


@prop("glass")
def glass(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tumbler."""
    (w, _, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    b.lathe(body, [(r * 0.84, 0), (r, h), (r * 0.95, h), (r * 0.8, 0.012)], segments=24)
    fill = spec.number("fill")
    if fill > 0:
        b.lathe(spec.material("drink"), [(r * 0.86, 0.008), (r * (0.86 + 0.13 * fill), h * fill)], segments=24)
    return grips_around(w / 2, h * 0.5)


@prop("wine_glass")
def wine_glass(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stemmed glass."""
    h, body, r = spec.size[2], spec.material("body"), spec.size[0] / 2
    bowl = [(0.006, h * 0.46), (r * 0.75, h * 0.56), (r, h * 0.72), (r * 0.86, h), (r * 0.82, h), (r * 0.95, h * 0.72)]
    b.lathe(body, [(r * 0.9, 0), (r * 0.86, 0.005), (0.008, 0.014), (0.004, 0.05), *bowl], segments=24, caps=False)
    if spec.number("fill") > 0:
        level = h * (0.5 + 0.4 * spec.number("fill"))
        profile = [(0.009, h * 0.47), (r * 0.77, h * 0.562), (r * 1.015, min(level, h * 0.72))]
        b.lathe(spec.material("drink"), profile, segments=24)
    return grips_around(0.012, h * 0.36, (0.7, 0.75, 0.45))


@prop("beer_mug")
def beer_mug(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a full beer mug."""
    h, body, foam, r = spec.size[2], spec.material("body"), spec.material("foam"), 0.05
    b.lathe(body, [(r, 0), (r, 0.012), (r * 0.92, 0.02), (r * 0.92, h - 0.03), (r, h - 0.02)], segments=20)
    b.lathe(foam, [(r * 0.95, h - 0.03), (r * 1.02, h - 0.015), (r * 0.8, h), (0.004, h + 0.004)], segments=20)
    loop = [(-0.04 - 0.045 * math.sin(a), 0, h * 0.5 + 0.045 * math.cos(a)) for a in np.linspace(0, math.pi, 17)]
    b.tube(body, loop, 0.008)
    return two_hands((-0.085, 0.01, h * 0.5), (0.3, -1, 0), (1, 0.3, 0), (0.85, 0.85, 0.4))


@prop("bottle")
def bottle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a corked bottle with a label."""
    h, r = spec.size[2], spec.size[0] / 2
    b.lathe(spec.material("body"), bottle_profile(r, h * 0.97), segments=20)
    b.lathe(spec.material("label"), [(r * 1.01, h * 0.2), (r * 1.01, h * 0.46)], segments=20, caps=False)
    b.cylinder(spec.material("cork"), (0, 0, h * 0.95), (0, 0, h), r * 0.3, segments=12)
    return grips_around(r, h * 0.38, (0.6, 0.65, 0.4)) + two_hands(
        (-r * 0.4, 0.008, h * 0.82), (0.25, -1, 0), (1, 0.2, 0), (0.85, 0.85, 0.5), "neck"
    )


@prop("plate")
def plate(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plate, with a meal if wanted."""
    r = spec.size[0] / 2
    profile = [(r * 0.6, 0), (r * 0.66, 0.006), (r, 0.022), (r, 0.026), (r * 0.66, 0.011)]
    b.lathe(spec.material("body"), profile, segments=32)
    if spec.flag("food"):
        b.cushion(spec.material("food"), (-0.02, 0.02, 0.027), (r * 0.7, r * 0.5, 0.04), softness=0.7)
        for k in range(7):
            turn = 0.5 + 0.3 * k
            center = (r * 0.42 * math.cos(turn), -r * 0.42 * math.sin(turn), 0.022)
            b.sphere(spec.material("greens"), center, 0.016, segments=8, rings=5)
    return grips_under(r * 0.9)


@prop("bowl")
def bowl(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bowl of soup."""
    h, r = spec.size[2], spec.size[0] / 2
    profile = [(r * 0.45, 0), (r * 0.42, 0.01), (r * 0.75, h * 0.4), (r, h), (r * 0.95, h), (r * 0.7, h * 0.45)]
    b.lathe(spec.material("body"), profile, segments=28)
    b.lathe(spec.material("food"), [(r * 0.7, h * 0.5), (r * 0.86, h * 0.75)], segments=28)
    return grips_under(r * 0.7, (0.3, 0.35, 0.0))


@prop("teapot")
def teapot(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a teapot; its spout is at +X."""
    (w, d, h), body = spec.size, spec.material("body")
    r = d / 2
    profile = [
        (r * 0.6, 0), (r * 0.9, h * 0.15), (r, h * 0.38), (r * 0.85, h * 0.62), (r * 0.5, h * 0.72),
        (r * 0.48, h * 0.76), (r * 0.2, h * 0.86), (r * 0.08, h * 0.88), (r * 0.14, h * 0.95), (0.003, h),
    ]  # fmt: skip
    b.lathe(body, bent(profile, 3), segments=24)
    spout = [(r * 0.8, 0, h * 0.3), (w * 0.42, 0, h * 0.42), (w * 0.5, 0, h * 0.72)]
    b.tube(body, bent(spout), tuple(bent((0.024, 0.016, 0.011))))
    handle = [
        (-r * 0.75, 0, h * 0.62), (-w * 0.42, 0, h * 0.64), (-w * 0.47, 0, h * 0.45), (-w * 0.4, 0, h * 0.25),
        (-r * 0.9, 0, h * 0.24),
    ]  # fmt: skip
    b.tube(body, bent(handle), 0.009)
    return two_hands((-w * 0.47, 0.0, h * 0.45), (0.2, -1, 0), (1, 0.1, 0), (0.85, 0.85, 0.5))


@prop("tray")
def tray(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tray."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, 0.005), (w - 0.04, d, 0.01), 0.004)
    rim = [(x * (w / 2 - 0.02), y * d / 2, h * 0.55) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    b.tube(body, rim, 0.007, closed=True)
    for x in (-1, 1):
        path = [
            (x * (w / 2 - 0.02), -0.06, h * 0.5),
            (x * w / 2, -0.05, h * 0.9),
            (x * w / 2, 0.05, h * 0.9),
            (x * (w / 2 - 0.02), 0.06, h * 0.5),
        ]
        b.tube(body, path, 0.006)
    side = two_hands((-w / 2, 0.0, -0.002), (0.2, -1, 0), (0.5, 0, 0.87), (0.35, 0.4, 0.1))
    return side + grips_under(d * 0.2)


@prop("bread")
def bread(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a loaf with cuts."""
    (w, d, h), body = spec.size, spec.material("body")
    b.cushion(body, (0, 0, h / 2), (w, d, h), softness=0.6)
    for x in (-0.25, 0, 0.25):
        b.cushion("linen", (x * w, 0, h * 0.93), (0.02, d * 0.5, 0.02), softness=0.7, rotation=(0, 0, 30))
    return grips_around(d * 0.5, h * 0.5, (0.35, 0.4, 0.2))


@prop("cake")
def cake(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an iced cake with burning candles."""
    (w, _, h), r = spec.size, spec.size[0] / 2
    b.lathe("porcelain", [(r, 0), (r, 0.01), (r * 0.9, 0.014)], segments=32)
    top = h * 0.55
    profile = [(r * 0.82, 0.012), (r * 0.82, top - 0.015), (r * 0.78, top), (0.003, top)]
    b.lathe(spec.material("body"), profile, segments=32)
    for z in (0.024, top - 0.012):
        for k in range(20):
            turn = math.tau * k / 20
            center = (r * 0.82 * math.cos(turn), r * 0.82 * math.sin(turn), z)
            b.sphere(spec.material("trim"), center, 0.011, segments=8, rings=5)
    for k in range(spec.count("candles")):
        turn = math.tau * k / spec.count("candles")
        x, y = r * 0.5 * math.cos(turn), r * 0.5 * math.sin(turn)
        b.cylinder("wax", (x, y, top), (x, y, h * 0.84), 0.004, segments=8)
        flame(b, spec.material("flame"), x, y, h * 0.84, h * 0.16)
    return grips_under(w * 0.4)


@prop("apple")
def apple(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an apple."""
    h, r = spec.size[2], spec.size[0] / 2
    profile = [
        (0.004, 0.006), (r * 0.5, 0), (r * 0.92, h * 0.3), (r, h * 0.55), (r * 0.8, h * 0.82), (r * 0.4, h * 0.88),
        (0.003, h * 0.8),
    ]  # fmt: skip
    b.lathe(spec.material("body"), bent(profile), segments=20)
    b.tube(spec.material("stem"), [(0, 0, h * 0.78), (0.002, 0, h * 0.92), (0.006, 0, h)], 0.0022, segments=6)
    return grips_around(r, h * 0.45, (0.45, 0.5, 0.35))


@prop("fork")
def fork(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fork; its tines are at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.tube(body, [(0, d / 2, h * 0.4), (0, 0, h * 0.5), (0, -d * 0.18, h * 0.3)], (0.006, 0.003, 0.005))
    b.rounded_box(body, (0, -d * 0.24, h * 0.3), (w, d * 0.14, 0.003), 0.001)
    for k in range(4):
        x = (k - 1.5) * w * 0.28
        b.tube(body, [(x, -d * 0.28, h * 0.3), (x, -d * 0.42, h * 0.4), (x, -d / 2, h * 0.8)], 0.0017, segments=6)
    return two_hands((-0.012, d * 0.2, 0.006), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.8, 0.6))


@prop("pan")
def pan(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a frying pan; its handle is at +Y, to the cook."""
    (_, d, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    middle = (0, -d / 2 + r, 0)
    b.lathe(body, [(r * 0.8, 0), (r, h * 0.75), (r * 0.97, h * 0.75), (r * 0.77, 0.006)], origin=middle, segments=32)
    path = [(0, -d / 2 + 2 * r - 0.01, h * 0.6), (0, d * 0.2, h * 0.8), (0, d / 2, h * 0.85)]
    b.tube(body, path, (0.009, 0.01, 0.014))
    return two_hands((-0.016, d * 0.38, h * 0.8), (0.2, -1, 0), (1, 0.2, 0), (0.9, 0.9, 0.5))
