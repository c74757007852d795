"""Prop builders: shoes and what is worn or hung: shoe, pump, sandal, sock, garment on a hanger, dress form, ties."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_under, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

_HALF = ((-0.46, 0.27), (-0.38, 0.42), (-0.22, 0.49), (-0.05, 0.45), (0.12, 0.36), (0.3, 0.36), (0.43, 0.28))
"""Half widths of a foot's sole along its length, from the toes at -Y; shares of width and length."""
_HEEL_GRIP = ((0.1, -0.85, 0.3), (1.0, 0.0, 0.0), (0.6, 0.65, 0.45))


def sole_of(width: float, length: float) -> Floats:
    """Return (n, 2) points around the sole of a shoe, counter-clockwise, its toes at -Y.

    Args:
        width: At its widest, metres.
        length: From heel to toes, metres.
    """
    right = [(x * width, y * length) for y, x in _HALF]
    loop = [(0, -0.5 * length), *right, (0, 0.5 * length), *((-x, y) for x, y in right[::-1]), (0, -0.5 * length)]
    return bent(loop, 3)[:-1]


def _pair(b: MeshBuilder, spec: PropSpec, build: Callable[[], None]) -> Anchors:
    """Build one shoe, or with the parameter ``pair`` two of them side by side; return the grips at the heel."""
    w, d, h = spec.size
    sides = (-1, 1) if spec.flag("pair") else (0,)
    for x in sides:
        with b.at((0.6 * x * w, 0.04 * x * d, 0), (0, 0, -5 * x)):
            build()
    reach = -(1.1 if spec.flag("pair") else 0.42) * w
    fingers, palm, curl = _HEEL_GRIP
    return two_hands((reach, 0.25 * d, 0.6 * h), fingers, palm, curl) + grips_under(0.4 * d)


def _upper(
    b: MeshBuilder,
    material: MaterialRef,
    sole: Floats,
    mouth: tuple[float, float, float],
    back: float,
    front: float,
    lift: Callable[[Floats], Floats],
) -> None:
    """Add the upper of a shoe, open at its mouth.

    Args:
        b: The builder.
        material: Of the upper; its lining is dark.
        sole: (n, 2) outline it rises from.
        mouth: Middle along y, half width and half length of the opening.
        back: Height of the opening at the heel.
        front: Height of the opening at the instep.
        lift: From places along y to how high the sole lies there.
    """
    turn = np.arctan2(sole[:, 1] - mouth[0], sole[:, 0])
    opening = np.c_[mouth[1] * np.cos(turn), mouth[0] + mouth[2] * np.sin(turn)]
    rise = front + (back - front) * (0.5 + 0.5 * np.sin(turn))
    rings = []
    for t in np.linspace(0, math.pi / 2, 8):
        flat = sole + (opening - sole) * (1 - math.cos(t))
        rings.append(np.c_[flat, lift(flat[:, 1]) + rise * math.sin(t)])
    b.loft(material, rings, caps=False)
    inside = [rings[-1]]
    for scale, across, depth in ((0.93, 0.93, 0.0), (0.86, 0.8, 0.5), (0.8, 0.02, 0.6)):
        flat = (opening - (0, mouth[0])) * (across, scale) + (0, mouth[0])
        inside.append(np.c_[flat, lift(flat[:, 1]) + rise * (1 - depth)])
    b.loft(material, inside[:2], caps=False)
    b.loft("plastic_black", inside[1:], caps=False)


def _flat(y: Floats) -> Floats:
    """Return 0 for every y: a shoe that stands flat, without a heel."""
    return np.full(len(y), 0.0)


@prop("shoe")
def shoe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a laced shoe, or a pair."""
    (w, d, h), leather, tread = spec.size, spec.material("leather"), spec.material("sole")
    sole = sole_of(w, d)
    thick = 0.13 * h

    def build() -> None:
        b.extrude(tread, sole, thick)
        b.extrude(tread, [(x, y) for x, y in sole if y > 0.12 * d], 0.06 * h, base=-0.06 * h)
        with b.at((0, 0, thick)):
            _upper(b, leather, sole * 0.96, (0.22 * d, 0.25 * w, 0.17 * d), h - thick, 0.74 * h - thick, _flat)
        for k in range(4):
            y = (-0.18 + 0.06 * k) * d
            z = thick + (0.74 * h - thick) * math.sqrt(1 - ((0.05 * d - y) / (0.55 * d)) ** 2)
            lace = [
                (x, y + d * t, z + h * up)
                for x, t, up in ((-0.2, 0, -0.06), (-0.1, 0, 0.02), (0.1, 0.03, 0.03), (0.2, 0.03, -0.05))
            ]
            b.tube("linen", [(x * w, *rest) for x, *rest in lace], 0.0024, segments=6)
        for x in (-1, 1):
            bow = [(0, 0.02, 0.82), (0.2 * x, 0.0, 0.9), (0.26 * x, -0.06, 0.8), (0, 0.01, 0.82)]
            b.tube("linen", bent([(i * w, j * d, k * h) for i, j, k in bow]), 0.002, segments=6)

    return _pair(b, spec, build)


@prop("high_heel")
def high_heel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pump on a high heel, or a pair."""
    (w, d, h), leather = spec.size, spec.material("leather")
    sole, high = sole_of(w, d), 0.56 * h

    def lift(y: Floats) -> Floats:
        t = np.clip((y / d + 0.2) / 0.5, 0, 1)
        return high * t * t * (3 - 2 * t)

    def build() -> None:
        under_foot = [(0.02, 0.0), (1.0, 0.0), (1.0, 0.02 * h)]
        rings = [np.c_[sole * (across, 1), lift(sole[:, 1]) + up] for across, up in under_foot]
        b.loft("plastic_black", rings, caps=False)
        with b.at((0, 0, 0.02 * h)):
            _upper(b, leather, sole, (0.13 * d, 0.29 * w, 0.29 * d), 0.42 * h, 0.2 * h, lift)
        b.cylinder(leather, (0, 0.42 * d, 0), (0, 0.38 * d, high), 0.06 * w, 0.24 * w, segments=16)

    return _pair(b, spec, build)


@prop("sandal")
def sandal(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat sandal with a strap from between the toes to both sides, or a pair."""
    (w, d, h), strap = spec.size, spec.material("strap")
    sole = sole_of(w, d)

    def build() -> None:
        b.extrude(spec.material("sole"), sole, 0.32 * h)
        b.extrude("cardboard", sole * 0.95, 0.02 * h, base=0.32 * h)
        for x in (-1, 1):
            band = [(0, -0.3, 0.34), (0.02 * x, -0.27, 0.75), (0.24 * x, -0.12, 0.95), (0.42 * x, 0.06, 0.3)]
            b.tube(strap, bent([(i * w, j * d, k * h) for i, j, k in band], 5), 0.055 * w, segments=8)

    return _pair(b, spec, build)


@prop("sock")
def sock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sock that lies flat, its leg to +Y, with a ribbed top, heel and toe in another colour; or a pair."""
    (w, d, h), wool, trim = spec.size, spec.material("wool"), spec.material("trim")
    line = bent([(-0.34, -0.38), (-0.1, -0.36), (0.12, -0.3), (0.22, -0.12), (0.22, 0.14), (0.22, 0.36)], 4)
    radii = bent([(0.1,), (0.18,), (0.19,), (0.2,), (0.19,), (0.21,)], 4)[:, 0] * w
    path = np.c_[line[:, 0] * w, line[:, 1] * d, np.zeros(len(line))]

    def build() -> None:
        with b.at((0, 0, 0.5 * h), scale=(1, 1, 0.5 * h / (0.22 * w))):
            b.tube(wool, path, list(radii), segments=16)
            b.sphere(trim, path[1], 0.15 * w, scale=(1.1, 1, 1.1))
            b.sphere(trim, (0.22 * w, -0.31 * d, 0), 0.19 * w)
            for k in range(4):
                b.cylinder(trim, (0.22 * w, (0.36 + 0.036 * k) * d, 0), (0.22 * w, (0.39 + 0.036 * k) * d, 0), 0.22 * w)

    return _pair(b, spec, build)


def dress_form_of(b: MeshBuilder, cover: MaterialRef, wood: MaterialRef, linen: MaterialRef) -> None:
    """Add a tailor's torso on a turned stand, 1.66 m high, facing -Y.

    Args:
        b: Receives the parts.
        cover: Material of the torso.
        wood: Material of the stand.
        linen: Material of the neck.
    """
    b.lathe(wood, [(0.22, 0), (0.2, 0.04), (0.03, 0.07), (0.025, 0.8)], segments=18)
    sections = [(0.72, 0.17, 0.12, 0), (0.8, 0.185, 0.13, 0), (0.92, 0.18, 0.125, 0), (1.08, 0.13, 0.1, 0)]
    sections += [(1.26, 0.165, 0.125, 0.015), (1.36, 0.18, 0.115, 0.01), (1.46, 0.19, 0.085, 0), (1.52, 0.09, 0.065, 0)]
    t = np.linspace(0, 2 * math.pi, 25)[:-1]
    rings = [
        np.c_[w * np.cos(t), d * np.sin(t) - ahead * (np.sin(t) < 0), np.full(24, z)]
        for z, w, d, ahead in bent(sections, 3)
    ]
    b.loft(cover, rings)
    b.cylinder(linen, (0, 0, 1.5), (0, 0, 1.6), 0.055, segments=16)
    b.lathe(wood, bent([(0.06, 1.6), (0.05, 1.61), (0.016, 1.62), (0.03, 1.64), (0.0, 1.66)], 3), segments=16)
    for x in (-1, 1):
        b.lathe(wood, [(0.05, 0), (0.045, 0.01), (0.01, 0.014)], origin=(0.17 * x, 0, 1.42), axis=(x, 0, 0.3))


@prop("dress_form")
def dress_form(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tailor's dummy on its stand."""
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        dress_form_of(b, spec.material("cover"), spec.material("wood"), spec.material("cover"))
        b.box("linen", (0, -0.14, 1.1), (0.006, 0.012, 0.72), rotation=(0, 0, 0))
    return ()


@prop("hanging_garment")
def hanging_garment(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a garment with sleeves on a hanger, facing -Y, its hook on top."""
    (w, d, h), cloth = spec.size, spec.material("cloth")
    top = 0.88 * h
    t = np.linspace(0, math.tau, 37)[:-1]
    body = [(0.0, 0.34, 0.42), (0.35, 0.3, 0.36), (0.62, 0.27, 0.34), (0.82, 0.3, 0.32), (0.94, 0.26, 0.26)]
    rings = []
    for z, across, deep in [*body, (1.0, 0.09, 0.16)]:
        fold = 1 + 0.12 * (1 - z) * np.sin(9 * t)
        rings.append(np.c_[across * w * np.cos(t), deep * d * fold * np.sin(t), np.full(36, z * top)])
    b.loft(cloth, rings)
    for x in (-1, 1):
        arm = [(0.24, 0, 0.93), (0.33, 0, 0.84), (0.41, -0.02, 0.62), (0.43, -0.06, 0.42)]
        path = bent([(x * i * w, j * d, k * top) for i, j, k in arm])
        b.tube(cloth, path, list(np.linspace(0.065, 0.085, len(path)) * w), segments=12)
        collar = [(0.02 * x, -0.19, 0.8), (0.1 * x, -0.2, 0.9), (0.11 * x, 0.05, 1.0), (0, 0.17, 1.01)]
        b.tube(cloth, bent([(i * w, j * d, k * top) for i, j, k in collar]), 0.012, segments=6)
        b.tube("wood_light", [(0, 0, top + 0.02), (0.25 * x * w, 0, 0.95 * top)], 0.008)
    for k in range(5):
        b.sphere("plastic_black", (0, -0.4 * d, (0.12 + 0.15 * k) * top), 0.008, segments=8, rings=5)
    hook = [(0, 0, top), (0, 0, 0.93 * h), (0.03, 0, 0.955 * h), (0.026, 0, 0.99 * h), (-0.01, 0, h - 0.003)]
    b.tube("steel", bent(hook), 0.0025, segments=6)
    return two_hands((0.0, 0.012, 0.93 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)
