"""Light for moving frames: the lamps of the board over one flat picture and its depth.

What stands still under a camera that stands still keeps its light, so a frame costs little more than the people in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from storyblender.look.atmosphere import add_halos, transmittance, veil
from storyblender.look.gbuffer import View, same_view
from storyblender.look.illumination import ambient_light, light_field, sky_light, total
from storyblender.look.occlusion import ambient_occlusion
from storyblender.look.raster import LUMA, Image, Mask, Window, blur, every, spread
from storyblender.look.relight import upsample_by_depth
from storyblender.memory.scene_context import Light, Lighting

_MOST_LAMPS = 6
"""Lamps of the set that are worked out, besides the sun and those of faces."""
_BOUNCE = 0.4
_SAME = 0.004
"""Change of depth, as a share of it, below which a pixel still shows the same place."""
_ROUND = 0.04
"""Range of depth in a neighbourhood, as a share of it, up to which it is one surface."""
_FOLLOW = 0.15
"""Metres a lamp may move before the light that it gave to still things is worked out anew."""


@dataclass(frozen=True)
class FlatFrame:
    """One flat picture of a moving shot.

    Attributes:
        albedo: (h, w, 3) with whatever lines and shadows were drawn on it; premultiplied by coverage.
        coverage: (h, w) 0 where the sky shows.
        depth: (h, w) metres along the camera axis; ``FAR`` where sky.
        glow: (h, w, 3) light given off.
        moving: (h, w) what may have moved since the last frame although its depth has not: the people.
        view: The camera, at this size.
        window: The part of the picture in which anything may have changed since the last frame; even numbers.
    """

    albedo: Image
    coverage: Image
    depth: Image
    glow: Image
    moving: Mask
    view: View
    window: Window


@dataclass(frozen=True)
class _Low:
    """What is lit of a frame: every second pixel each way, because light is smooth.

    Attributes:
        view: The camera, at this size.
        depth: (h, w).
        rays: (h, w, 3).
        positions: (h, w, 3) world.
        albedo: (h, w, 3).
        coverage: (h, w).
        moving: (h, w).
    """

    view: View
    depth: Image
    rays: Image
    positions: Image
    albedo: Image
    coverage: Image
    moving: Mask


@dataclass(frozen=True)
class _Held:
    """The light of a frame, kept for the next one.

    Attributes:
        view: Its camera.
        lamps: That lit it.
        depth: (h, w).
        light: (h, w, 3) illumination.
        through: (h, w, 1) share that comes through the air.
        added: (h, w, 3) light of air and sky.
    """

    view: View
    lamps: tuple[Light, ...]
    depth: Image
    light: Image
    through: Image
    added: Image


class MovingLight:
    """Lights the frames of one shot, one after the other.

    Args:
        plan: Balanced light plan: ambient light, sky, fog.
        roofed: 0 under the open sky to 1 in a closed room.
    """

    def __init__(self, plan: Lighting, roofed: float) -> None:
        self._plan, self._roofed = plan, roofed
        self._held: _Held | None = None
        self._bounce = np.zeros(3, np.float32)

    def light(self, frame: FlatFrame, lamps: Sequence[Light]) -> tuple[Window, Image]:
        """Return the part of the picture that is not as in the last frame, linear, with its air."""
        chosen = tuple(strongest(lamps, frame.view))
        low = _reduced(frame)
        window, held = frame.window, self._held
        if held is None or not same_view(held.view, low.view) or _moved(held.lamps, chosen):
            window, held = frame.view.whole, None
        step = frame.view.width // low.view.width
        part = window.reduced(step)
        normal = normals_of(low.positions[part.cut], low.depth[part.cut], low.rays[part.cut])
        self._held = held = self._worked_out(low, chosen, part, normal, held)
        contact = 0.35 + 0.65 * ambient_occlusion(low.depth, low.view, low.positions, normal, part)
        light = held.light[part.cut] * contact[..., None]
        layers = np.concatenate([light, held.through[part.cut], held.added[part.cut]], axis=2)
        if step > 1:
            planes = np.ascontiguousarray(np.moveaxis(layers, 2, 0))
            layers = np.moveaxis(upsample_by_depth(planes, low.depth[part.cut], frame.depth[window.cut]), 0, 2)
        light, through, added = layers[..., :3], layers[..., 3:4], layers[..., 4:]
        return window, (frame.albedo[window.cut] * light + frame.glow[window.cut]) * through + added

    def _worked_out(
        self, frame: _Low, lamps: tuple[Light, ...], window: Window, normal: Image, held: _Held | None
    ) -> _Held:
        """Light what has changed in the window, given its normals; take the rest from before."""
        depth = frame.depth[window.cut]
        changed = np.ones(depth.shape, bool)
        if held is not None:
            before = held.depth[window.cut]
            changed = frame.moving[window.cut] | (np.abs(depth - before) > _SAME * before)
        normal = _smooth(normal, depth)[changed][:, None]
        parts = (frame.positions[window.cut], frame.rays[window.cut], depth)
        places, rays, depth = (part[changed][:, None] for part in parts)
        fields = [light_field(lamp, places, normal) for lamp in lamps]
        open_air = np.ones(depth.shape, np.float32)
        light = total(fields, ambient_light(self._plan, self._roofed, normal, open_air))
        if held is None:
            leaving = np.minimum(frame.albedo * light.reshape(frame.albedo.shape), 4.0)
            solid = frame.coverage > 0.5
            self._bounce = leaving[solid].mean(axis=0) * np.float32(_BOUNCE) if solid.any() else self._bounce
        light += self._bounce
        open_sky = 1 - frame.coverage[window.cut][changed][:, None, None]
        through, added = self._air(open_sky, frame.view.eye, lamps, rays, depth)
        if held is None:
            size = frame.depth.shape
            lit, clear, veiled = (part.reshape(*size, -1) for part in (light, through, added))
            return _Held(frame.view, lamps, frame.depth, lit, clear, veiled)
        for whole, part in ((held.light, light), (held.through, through), (held.added, added)):
            whole[window.cut][changed] = part[:, 0]
        return replace(held, depth=frame.depth)

    def _air(
        self, open_sky: Image, eye: NDArray[np.float64], lamps: Sequence[Light], rays: Image, depth: Image
    ) -> tuple[Image, Image]:
        plan = self._plan
        through = transmittance(plan.fog, depth, rays, eye)[..., None]
        added = sky_light(plan.sky, rays) * open_sky * through + veil(plan.fog, rays) * (1 - through)
        return through, add_halos(added, lamps, depth, rays, eye)


def _reduced(frame: FlatFrame) -> _Low:
    """Return the frame at half its size, or whole where its size is odd."""
    step = 2 if frame.view.width % 2 == 0 and frame.view.height % 2 == 0 else 1
    view = frame.view.reduced(step)
    depth, albedo, coverage, moving = (
        every(part, step) for part in (frame.depth, frame.albedo, frame.coverage, frame.moving)
    )
    rays = view.rays()
    positions = rays * depth[..., None] + view.eye.astype(np.float32)
    return _Low(view, depth, rays, positions, albedo, coverage, moving)


def _moved(before: Sequence[Light], now: Sequence[Light]) -> bool:
    if len(before) != len(now):
        return True
    return any(
        a.name != b.name or float(np.linalg.norm(np.subtract(a.location, b.location))) > _FOLLOW
        for a, b in zip(before, now, strict=True)
    )


def strongest(lamps: Sequence[Light], view: View) -> list[Light]:
    """Return the lamps that matter to this camera: sun and face lamps, then the brightest near the picture's middle."""
    always = [lamp for lamp in lamps if lamp.kind == "SUN" or lamp.for_asset is not None]
    middle = view.eye - view.axes[:, 2] * 4.0
    rest = sorted(
        (lamp for lamp in lamps if lamp.kind != "SUN" and lamp.for_asset is None),
        key=lambda lamp: (-_reach(lamp, middle), lamp.name),
    )
    return always + rest[:_MOST_LAMPS]


def _reach(lamp: Light, point: np.ndarray) -> float:
    squared = float(np.sum((np.asarray(lamp.location) - point) ** 2))
    return lamp.power * float(np.dot(LUMA, np.asarray(lamp.color, np.float32))) / max(squared, 1.0)


def normals_of(positions: Image, depth: Image, rays: Image) -> Image:
    """Return unit normals from positions, each difference taken on the side where the depth jumps less."""
    across, down = _gradient(positions, depth, 1), _gradient(positions, depth, 0)
    normal = np.cross(down, across)
    normal /= np.maximum(np.linalg.norm(normal, axis=2, keepdims=True), 1e-9)
    away = np.einsum("hwc,hwc->hw", normal, rays) > 0
    normal[away] *= -1
    return normal


def _smooth(normal: Image, depth: Image) -> Image:
    """Round the facets off: mean normal over three pixels, but not across edges of depth."""
    far, near = spread(spread(depth)), -spread(spread(-depth))
    whole = (far - near < _ROUND * near)[..., None]
    soft = blur(normal, 1)
    soft /= np.maximum(np.linalg.norm(soft, axis=2, keepdims=True), 1e-6)
    return np.where(whole, soft, normal)


def _gradient(positions: Image, depth: Image, axis: int) -> Image:
    before, after = _steps(positions, axis)
    jump_before, jump_after = _steps(depth, axis)
    return np.where((np.abs(jump_before) < np.abs(jump_after))[..., None], before, after)


def _steps(values: Image, axis: int) -> tuple[Image, Image]:
    """Return the differences to the neighbour before and to the one after; edges repeat their inner one."""
    step = np.diff(values, axis=axis)
    first = step[:1] if axis == 0 else step[:, :1]
    last = step[-1:] if axis == 0 else step[:, -1:]
    return np.concatenate([first, step], axis=axis), np.concatenate([step, last], axis=axis)
