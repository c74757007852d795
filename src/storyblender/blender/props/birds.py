"""Birds from one parametric plan: body, neck, head, beak, tail and legs. They face -Y."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around
from storyblender.blender.props.animals import limb
from storyblender.blender.props.beasts import DARK, scaled
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import Builder, PropSpec, prop


@dataclass(frozen=True)
class Bird:
    """Dimensions of a bird, in metres.

    Attributes:
        body: Half the length of the body, and its radius.
        leg: Height of the belly above the ground.
        neck: Offset of the head from the centre of the body: forward, and up.
        throat: Radius of the neck at its middle.
        head: Radius of the head.
        beak: Length and radius at its root.
        bill: ``cone``, ``hook`` or ``flat``.
        tail: Length, width, and rise in degrees.
        upright: Backward tilt of the body in degrees.
        webbed: Whether the feet are webbed.
    """

    body: tuple[float, float]
    leg: float
    neck: tuple[float, float]
    throat: float
    head: float
    beak: tuple[float, float]
    bill: Literal["cone", "hook", "flat"] = "cone"
    tail: tuple[float, float, float] = (0.1, 0.06, 0.0)
    upright: float = 0.0
    webbed: bool = False

    @property
    def middle(self) -> float:
        """Height of the centre of the body in metres."""
        return self.leg + self.body[1]


def bird_of(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add a bird, standing or, with the parameter ``flying``, in flight with spread wings.

    Args:
        b: Receives the parts.
        spec: Its material roles are coat, wing and beak.
        plan: Its measures.
    """
    coat, beak = spec.material("coat"), spec.material("beak")
    wing = coat if spec.entry.materials["wing"] == spec.entry.materials["coat"] else spec.material("wing")
    (long, thick), z = plan.body, plan.middle
    flying = spec.flag("flying")
    with b.at((0, 0, z), (0 if flying else -plan.upright, 0, 0)):
        outline = [(-1.06, 0.05), (-0.98, 0.4), (-0.8, 0.75), (-0.35, 1.0), (0.15, 0.98), (0.6, 0.66), (1.0, 0.25)]
        limb(b, coat, [(0, y * long, 0.1 * thick * (y > 0), r * thick * 0.92, r * thick) for y, r in outline], 18)
        span, width, rise = plan.tail
        with b.at((0, long * 0.85, thick * 0.15), (rise, 0, 0)):
            b.cushion(wing, (0, span * 0.45, 0), (width, span, thick * 0.16), softness=0.7)
        for x in (-1, 1):
            if flying:
                _spread(b, wing, x, long, thick)
            else:
                fold = (x * thick * 0.86, long * 0.16, thick * 0.12)
                b.cushion(wing, fold, (thick * 0.3, long * 1.55, thick * 1.05), softness=0.9, rotation=(12, 0, x * 4))
    ahead, above = plan.neck
    at = np.array((0.0, -ahead, z + above))
    root = np.array((0.0, -long * 0.55, z + thick * (0.25 + 0.012 * plan.upright)))
    path = bent([root, (root + at) / 2 + (0, -0.15 * ahead, 0.1 * above), at], 4)
    radii = np.interp(np.linspace(0, 1, len(path)), (0, 0.5, 1), (thick * 0.62, plan.throat, plan.head * 0.8))
    b.tube(coat, path, tuple(float(r) for r in radii), segments=14)
    b.sphere(coat, at, plan.head, scale=(0.95, 1.08, 1.0), segments=16, rings=10)
    _face(b, plan, at, beak)
    if not flying:
        _legs(b, plan, beak)


def _face(b: MeshBuilder, plan: Bird, at: np.ndarray, beak: MaterialRef) -> None:
    """Add beak and eyes to a head whose centre is ``at``."""
    (long, thick), r = plan.beak, plan.head
    root = np.add(at, (0, -r * 0.8, -r * 0.1))
    match plan.bill:
        case "cone":
            b.cylinder(beak, root, np.add(root, (0, -long, -long * 0.15)), thick, thick * 0.1, segments=10)
        case "hook":
            path = bent(
                [
                    np.add(root, (0, 0, thick * 0.2)),
                    np.add(root, (0, -long * 0.6, thick * 0.1)),
                    np.add(root, (0, -long * 0.8, -long * 0.55)),
                ]
            )
            b.tube(beak, path, tuple(np.linspace(thick, thick * 0.15, len(path))), segments=10)
        case "flat":
            center = np.add(root, (0, -long * 0.45, -thick * 0.2))
            b.cushion(beak, center, (thick * 2.1, long * 1.1, thick * 0.9), softness=0.8)
    for x in (-1, 1):
        b.sphere(DARK, np.add(at, (x * r * 0.78, -r * 0.45, r * 0.2)), r * 0.17, segments=8, rings=5)


def _spread(b: MeshBuilder, wing: MaterialRef, x: int, long: float, thick: float) -> None:
    """Add a spread wing on the side ``x``, -1 or 1; ``long`` and ``thick`` are half the body's length and width."""
    span = long * 3.2
    rings = []
    for t, chord, up in ((0.0, 0.9, 0.0), (0.35, 1.0, 0.16), (0.7, 0.8, 0.14), (1.0, 0.2, 0.02)):
        ahead = -long * 0.55 + long * 0.35 * t * t
        base = np.array((x * (thick * 0.6 + span * t), ahead, thick * 0.5 + span * up))
        deep, high = long * 1.2 * chord, thick * 0.12
        rings.append(
            [
                base,
                np.add(base, (0, deep * 0.3, high)),
                np.add(base, (0, deep, 0)),
                np.add(base, (0, deep * 0.3, -high * 0.4)),
            ]
        )
    b.loft(wing, [np.array(ring) for ring in rings])


def _legs(b: MeshBuilder, plan: Bird, beak: MaterialRef) -> None:
    """Add two legs with toes, webbed where the plan says so."""
    apart, thin = plan.body[1] * 0.45, max(0.0035, plan.leg * 0.05)
    y = 0.0
    for x in (-1, 1):
        top = (x * apart * 0.9, y + 0.02 * plan.body[0], plan.leg + plan.body[1] * 0.5)
        b.tube(beak, [top, (x * apart, y + plan.leg * 0.12, plan.leg * 0.5), (x * apart, y, thin)], thin, segments=7)
        reach = max(0.025, plan.body[1] * 0.62)
        for turn in (-0.5, 0.0, 0.5):
            tip = (x * apart + reach * np.sin(turn), y - reach * np.cos(turn), thin * 0.7)
            b.cylinder(beak, (x * apart, y, thin), tip, thin * 0.8, thin * 0.4, segments=6)
        if plan.webbed:
            foot = [(x * apart + reach * s, y - reach * z) for s, z in ((0, 0), (0.5, 0.9), (-0.5, 0.9))]
            b.extrude(beak, foot, thin * 0.8)


Extra = Callable[[MeshBuilder, PropSpec, Bird], None]


def _comb(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add a red comb and wattle."""
    y, z, r = -plan.neck[0], plan.middle + plan.neck[1], plan.head
    for k, size in enumerate((0.42, 0.55, 0.48, 0.36)):
        center = (0, y - r * 0.5 + k * r * 0.42, z + r * 1.0)
        b.sphere("fabric_red", center, r * size, scale=(0.3, 0.7, 1), segments=10, rings=6)
    b.cushion("fabric_red", (0, y - r * 1.0, z - r * 0.85), (r * 0.35, r * 0.5, r * 0.9), softness=0.9)


def _plumes(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add a cock's comb and the sickles of his tail."""
    _comb(b, spec, plan)
    (long, thick), z = plan.body, plan.middle
    for k in range(5):
        side = (k - 2) * thick * 0.18
        curve = [
            (side * 0.5, long * 0.8, z + thick * 0.3),
            (side, long * 1.25, z + thick * (2.6 - 0.2 * k)),
            (side * 1.6, long * 1.95, z + thick * (2.3 - 0.3 * k)),
            (side * 1.8, long * 2.1, z + thick * 1.1),
        ]
        path = bent(curve)
        b.tube("plastic_black", path, tuple(np.linspace(thick * 0.16, thick * 0.04, len(path))), segments=7)


def _owl(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add an owl's facial discs, large eyes and ear tufts."""
    y, z, r = -plan.neck[0], plan.middle + plan.neck[1], plan.head
    for x in (-1, 1):
        profile = [(r * 0.48, 0), (r * 0.4, r * 0.1)]
        b.lathe("linen", profile, origin=(x * r * 0.42, y - r * 0.82, z + r * 0.1), axis=(x * 0.2, -1, 0))
        b.sphere("brass", (x * r * 0.42, y - r * 0.9, z + r * 0.1), r * 0.27, segments=12, rings=8)
        b.sphere(DARK, (x * r * 0.44, y - r * 1.08, z + r * 0.1), r * 0.15, segments=10, rings=6)
        center = (x * r * 0.55, y - r * 0.1, z + r * 0.95)
        b.cushion(spec.material("wing"), center, (r * 0.3, r * 0.25, r * 0.6), softness=0.9, rotation=(0, x * 22, 0))


def _belly(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add a white breast and belly."""
    (long, thick), z = plan.body, plan.middle
    with b.at((0, 0, z), (-plan.upright, 0, 0)):
        center = (0, -long * 0.1, -thick * 0.22)
        b.sphere("linen", center, thick * 0.9, scale=(0.86, long / thick * 0.86, 0.95), segments=16, rings=10)


def _train(b: MeshBuilder, spec: PropSpec, plan: Bird) -> None:
    """Add a peacock's tail fan."""
    z = plan.middle
    for k in range(15):
        turn = np.radians(-78 + 156 * k / 14)
        tip = np.array((0.75 * np.sin(turn), 0.32, z + 0.75 * np.cos(turn)))
        b.tube("leaves", [np.array((0, 0.15, z)), tip], (0.02, 0.035), segments=6)
        b.sphere("fabric_blue", np.add(tip, (0, -0.03, 0)), 0.05, scale=(0.8, 0.3, 1), segments=10, rings=6)


PLANS: dict[str, tuple[Bird, Extra | None]] = {
    "hen": (Bird((0.17, 0.105), 0.13, (0.17, 0.18), 0.045, 0.042, (0.035, 0.015), tail=(0.16, 0.1, 48)), _comb),
    "rooster": (Bird((0.19, 0.115), 0.19, (0.18, 0.25), 0.05, 0.045, (0.04, 0.016), tail=(0.12, 0.1, 48)), _plumes),
    "duck": (Bird((0.2, 0.1), 0.07, (0.19, 0.16), 0.04, 0.048, (0.07, 0.022), "flat", (0.12, 0.09, 22), webbed=True),
        None),
    "goose": (Bird((0.3, 0.15), 0.14, (0.3, 0.42), 0.042, 0.058, (0.08, 0.026), "flat", (0.16, 0.13, 14),
        webbed=True), None),
    "swan": (Bird((0.42, 0.2), 0.1, (0.4, 0.62), 0.045, 0.06, (0.09, 0.025), "flat", (0.2, 0.18, 12), webbed=True),
        None),
    "owl": (Bird((0.17, 0.11), 0.05, (0.06, 0.2), 0.085, 0.088, (0.035, 0.014), "hook", (0.14, 0.1, -20), 48), _owl),
    "crow": (Bird((0.15, 0.068), 0.09, (0.14, 0.085), 0.042, 0.042, (0.058, 0.016), tail=(0.17, 0.075, -4),
        upright=12), None),
    "pigeon": (Bird((0.12, 0.065), 0.06, (0.1, 0.1), 0.032, 0.031, (0.024, 0.009), tail=(0.11, 0.06, -4),
        upright=10), None),
    "songbird": (Bird((0.058, 0.036), 0.035, (0.05, 0.045), 0.026, 0.028, (0.03, 0.01), tail=(0.06, 0.026, 8),
        upright=18), None),
    "parrot": (Bird((0.13, 0.062), 0.04, (0.09, 0.13), 0.045, 0.05, (0.05, 0.022), "hook", (0.26, 0.06, -30), 50),
        None),
    "eagle": (Bird((0.28, 0.15), 0.16, (0.22, 0.28), 0.075, 0.075, (0.09, 0.034), "hook", (0.26, 0.18, -14), 34),
        None),
    "seagull": (Bird((0.17, 0.08), 0.1, (0.15, 0.11), 0.045, 0.046, (0.055, 0.013), tail=(0.14, 0.08, 0), upright=8,
        webbed=True), None),
    "penguin": (Bird((0.3, 0.15), 0.03, (0.08, 0.36), 0.1, 0.09, (0.13, 0.026), tail=(0.08, 0.1, -40), upright=76,
        webbed=True), _belly),
    "turkey": (Bird((0.3, 0.2), 0.2, (0.3, 0.32), 0.05, 0.05, (0.05, 0.02), tail=(0.3, 0.5, 62)), _comb),
    "peacock": (Bird((0.24, 0.12), 0.24, (0.22, 0.32), 0.04, 0.04, (0.05, 0.014), tail=(0.2, 0.1, 20)), _train),
    "flamingo": (Bird((0.22, 0.12), 0.75, (0.2, 0.42), 0.03, 0.045, (0.1, 0.022), "hook", (0.12, 0.1, -10)), None),
    "ostrich": (Bird((0.5, 0.34), 1.0, (0.45, 0.95), 0.07, 0.1, (0.12, 0.04), "flat", (0.34, 0.4, 30)), None),
}  # fmt: skip


def _builder(plan: Bird, extra: Extra | None) -> Builder:
    """Return the builder of a bird with a plan and, unless it flies, what ``extra`` adds."""

    def build(b: MeshBuilder, spec: PropSpec) -> Anchors:
        with b.at(scale=scaled(spec)):
            bird_of(b, spec, plan)
            if extra is not None and not spec.flag("flying"):
                extra(b, spec, plan)
        size = spec.size[0]
        return grips_around(min(0.08, size / 2), spec.size[2] / 2, (0.4, 0.45, 0.3)) if spec.entry.holdable else ()

    return build


for _key, (_plan, _extra) in PLANS.items():
    prop(_key)(_builder(_plan, _extra))
