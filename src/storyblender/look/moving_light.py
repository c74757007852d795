"""Light for moving frames: the lamps of the board over one flat picture and its depth.

What stands still under a camera that stands still keeps its light, so a frame costs little more than the people in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.atmosphere import add_halos, transmittance, veil
from storyblender.look.gbuffer import View, same_view
from storyblender.look.illumination import ambient_light, light_field, sky_light, total
from storyblender.look.occlusion import ambient_occlusion
from storyblender.look.raster import LUMA, Image, Mask, Window, any_of, blur, dot, every, spread, stacked, windows_round
from storyblender.look.relight import upsample_by_depth
from storyblender.look.smoke import Puff, add_smoke, through_smoke
from storyblender.memory.scene_context import Light, Lighting

_MOST_LAMPS = 6
"""Lamps of the set that are worked out, besides the sun and those of faces."""
_BOUNCE = 0.4
_ROUND = 0.04
"""Range of depth in a neighbourhood, as a share of it, up to which it is one surface."""
_FOLLOW = 0.3
"""Metres a lamp may move before the light that it gave to still things is worked out anew."""
_CORNER = 0.02
"""Change of a corner's darkness that is seen."""
_REACH = 20
"""Pixels, of the light, over which a thing darkens what is beside it."""
_ROOM = 3
"""Pixels, of the light, round what has changed that are drawn again: lines, and the rounding of the light."""
_GAP = 16
"""Pixels, of the light, over which what has changed is drawn in two parts: each part has a price of its own."""
_CLEAR = 1e-4
"""What the air takes or gives, below which there is none."""
_EDGE = 2
"""Pixels at a window's edge whose normals lack a neighbour."""


@dataclass(frozen=True)
class FlatFrame:
    """One flat picture of a moving shot.

    Attributes:
        albedo: (h, w, 3) with whatever lines and shadows were drawn on it; premultiplied by coverage.
        coverage: (h, w) 0 where the sky shows.
        depth: (h, w) metres along the camera axis; ``FAR`` where sky.
        glow: (h, w, 3) light given off.
        changed: (h, w) where it is not as in the last frame.
        moving: (h, w) what may move, under a camera that stands still.
        view: The camera, at this size.
    """

    albedo: Image
    coverage: Image
    depth: Image
    glow: Image
    changed: Mask
    moving: Mask
    view: View


class _Held:
    """The light of a frame at half its size, because light is smooth; kept for the next one.

    Args:
        view: The camera, at this size.
        lamps: That light it.

    Attributes:
        rays: (h, w, 3) world, to a depth of one metre.
        depth: (h, w) metres.
        positions: (h, w, 3) world.
        normal: (h, w, 3) world, unit, rounded off.
        contact: (h, w) share of light that corners leave.
        bounce: (3,) light that the surfaces give each other, in the illumination.
        layers: (7, h, w) illumination, share that comes through the air, light of air and sky.
    """

    def __init__(self, view: View, lamps: tuple[Light, ...]) -> None:
        self.view, self.lamps, self.rays = view, lamps, view.rays()
        size = (view.height, view.width)
        self.depth, self.contact = np.zeros(size, np.float32), np.zeros(size, np.float32)
        self.bounce = np.zeros(3, np.float32)
        self.positions, self.normal = np.zeros_like(self.rays), np.zeros_like(self.rays)
        self.layers = np.zeros((7, *size), np.float32)


class MovingLight:
    """Lights the frames of one shot, one after the other.

    Args:
        plan: Balanced light plan: ambient light, sky, fog.
        roofed: 0 under the open sky to 1 in a closed room.
        puffs: Smoke in the air.
    """

    def __init__(self, plan: Lighting, roofed: float, puffs: Sequence[Puff] = ()) -> None:
        self._plan, self._roofed, self._puffs = plan, roofed, puffs
        self._held: _Held | None = None

    def light(self, frame: FlatFrame, lamps: Sequence[Light]) -> list[tuple[Window, Image]]:
        """Return the parts of the picture that are not as in the last frame, linear, with their air.

        Args:
            frame: The flat picture of this frame.
            lamps: Every lamp of the shot, where it is at this frame; those that are not the strongest are left out.
        """
        step = 2 if frame.view.width % 2 == 0 and frame.view.height % 2 == 0 else 1
        view, chosen = frame.view.reduced(step), tuple(strongest(lamps, frame.view))
        held, touched = self._held, any_of(frame.changed, step)
        begins = held is None or not same_view(held.view, view) or _moved(held.lamps, chosen)
        if held is None or begins:
            held, touched = _Held(view, chosen), np.ones((view.height, view.width), bool)
        held.depth = every(frame.depth, step)
        open_sky = np.float32(1) - every(frame.coverage, step)
        around = windows_round(touched, _REACH)
        for window in around:
            here, eye = window.cut, view.eye.astype(np.float32)
            held.positions[here] = held.rays[here] * held.depth[here][..., None] + eye
        fresh = spread(touched)
        for window in around:
            touched |= _shaped(held, window, fresh)
        self._work_out(held, fresh, open_sky)
        if begins:
            self._bounce(held, every(frame.albedo, step), open_sky)
        self._held = held
        return [
            (window.enlarged(step), _lit(frame, held, window, step)) for window in windows_round(touched, _ROOM, _GAP)
        ]

    def _work_out(self, held: _Held, fresh: Mask, open_sky: Image) -> None:
        """Light what is fresh.

        Args:
            held: With normals.
            fresh: (h, w).
            open_sky: (h, w) share of each pixel that shows the sky.
        """
        here = np.flatnonzero(fresh)
        positions, rays, normal = (_at(here, part) for part in (held.positions, held.rays, held.normal))
        depth = held.depth.take(here)[:, None]
        fields = [light_field(lamp, positions, normal) for lamp in held.lamps]
        light = total(fields, ambient_light(self._plan, self._roofed, normal, np.ones_like(depth)))
        through, added = self._air(open_sky.take(here)[:, None], held.view.eye, held.lamps, rays, depth)
        layers = held.layers.reshape(len(held.layers), -1)
        layers[:3, here] = light[:, 0].T + held.bounce[:, None]
        layers[3, here], layers[4:, here] = through[:, 0], added[:, 0].T

    def _bounce(self, held: _Held, albedo: Image, open_sky: Image) -> None:
        """Add the first bounce, the same everywhere: the mean light that leaves the surfaces of the picture."""
        solid = open_sky < 0.5
        if solid.any():
            leaving = np.minimum(albedo * np.moveaxis(held.layers[:3], 0, 2), 4.0)[solid].mean(axis=0)
            held.bounce = leaving * np.float32(_BOUNCE)
            held.layers[:3] += held.bounce[:, None, None]

    def _air(
        self, open_sky: Image, eye: NDArray[np.float64], lamps: Sequence[Light], rays: Image, depth: Image
    ) -> tuple[Image, Image]:
        plan = self._plan
        through = transmittance(plan.fog, depth, rays, eye)
        added = veil(plan.fog, rays) * (1 - through)[..., None]
        seen = np.flatnonzero(open_sky)
        added[seen] += sky_light(plan.sky, rays[seen]) * (open_sky * through)[seen][..., None]
        if self._puffs:
            clear = through_smoke(self._puffs, depth, rays, eye)
            added = add_smoke(added, self._puffs, clear, lamps, plan.set_luminance)
            through = through * clear
        return through, add_halos(added, lamps, depth, rays, eye)


def _shaped(held: _Held, window: Window, fresh: Mask) -> Mask:
    """Find normals and corners in the window; return the (h, w) corners that are fresh or look different now."""
    depth, rays, positions = (part[window.cut] for part in (held.depth, held.rays, held.positions))
    normal = normals_of(positions, depth, rays)
    openness = ambient_occlusion(held.depth, held.view, normal, window)
    whole = window.inner(_EDGE, held.view.height, held.view.width)
    inner = whole.within(window).cut
    held.normal[whole.cut] = _smooth(normal, depth)[inner]
    contact, before = (0.35 + 0.65 * openness)[inner], held.contact[whole.cut]
    differs = fresh[whole.cut] | (np.abs(contact - before) > _CORNER)
    before[differs] = contact[differs]
    result = np.zeros_like(fresh)
    result[whole.cut] = differs
    return result


def _lit(frame: FlatFrame, held: _Held, window: Window, step: int) -> Image:
    """Return a part of the picture; the window is the light's."""
    here = window.enlarged(step).cut
    layers = held.layers[:, window.top : window.bottom, window.left : window.right].copy()
    layers[:3] *= held.contact[window.cut]
    if layers[3].min() > 1 - _CLEAR and layers[4:].max() < _CLEAR:
        layers = layers[:3]
    if step > 1:
        layers = upsample_by_depth(layers, held.depth[window.cut], frame.depth[here])
    layers = np.moveaxis(layers, 0, 2)
    picture = frame.albedo[here] * layers[..., :3] + frame.glow[here]
    return picture if layers.shape[2] == 3 else picture * layers[..., 3:4] + layers[..., 4:]


def _at(pixels: NDArray[np.intp], picture: Image) -> Image:
    """Return some pixels of a planar picture, numbered row by row, as a picture one pixel wide."""
    planes = np.moveaxis(picture, 2, 0).reshape(3, -1)
    return np.moveaxis(planes.take(pixels, axis=1), 0, 1)[:, None]


def _moved(before: Sequence[Light], now: Sequence[Light]) -> bool:
    if len(before) != len(now):
        return True
    return any(
        a.name != b.name or float(np.linalg.norm(np.subtract(a.location, b.location))) > _FOLLOW
        for a, b in zip(before, now, strict=True)
    )


def strongest(lamps: Sequence[Light], view: View) -> list[Light]:
    """Return the lamps that matter to this camera: sun, lamps of faces in or near it, the brightest near its middle.

    Args:
        lamps: Every lamp of the shot.
        view: The camera, at any size.
    """
    always = [lamp for lamp in lamps if lamp.kind == "SUN" or (lamp.for_asset is not None and _near(lamp, view))]
    middle = view.eye - view.axes[:, 2] * 4.0
    rest = sorted(
        (lamp for lamp in lamps if lamp.kind != "SUN" and lamp.for_asset is None),
        key=lambda lamp: (-_reach(lamp, middle), lamp.name),
    )
    return always + rest[:_MOST_LAMPS]


def _near(lamp: Light, view: View) -> bool:
    """Return whether the face that the lamp is for is in the picture, or at most half a picture beside it."""
    column, row, depth = (float(value) for value in view.project(np.asarray(lamp.target)))
    return depth > 0 and abs(column / view.width - 0.5) < 1 and abs(row / view.height - 0.5) < 1


def _reach(lamp: Light, point: np.ndarray) -> float:
    squared = float(np.sum((np.asarray(lamp.location) - point) ** 2))
    return lamp.power * float(np.dot(LUMA, np.asarray(lamp.color, np.float32))) / max(squared, 1.0)


def normals_of(positions: Image, depth: Image, rays: Image) -> Image:
    """Return unit normals from positions, each difference taken on the side where the depth jumps less.

    Args:
        positions: (h, w, 3) world, metres.
        depth: (h, w) metres along the camera axis.
        rays: (h, w, 3) world, from the eye; normals are turned against them.
    """
    (ax, ay, az), (dx, dy, dz) = _gradient(positions, depth, 1), _gradient(positions, depth, 0)
    normal = stacked([dy * az - dz * ay, dz * ax - dx * az, dx * ay - dy * ax])
    length = np.maximum(np.sqrt(dot(normal, normal)), 1e-9)
    return normal / np.where(dot(normal, rays) > 0, -length, length)[..., None]


def _smooth(normal: Image, depth: Image) -> Image:
    """Round the facets off: mean normal over three pixels, but not across edges of depth."""
    far, near = spread(spread(depth)), -spread(spread(-depth))
    whole = (far - near < _ROUND * near)[..., None]
    soft = stacked([blur(normal[..., axis], 1) for axis in range(3)])
    soft /= np.maximum(np.sqrt(dot(soft, soft)), 1e-6)[..., None]
    return np.where(whole, soft, normal)


def _gradient(positions: Image, depth: Image, axis: int) -> list[Image]:
    jump_before, jump_after = _steps(depth, axis)
    earlier = np.abs(jump_before) < np.abs(jump_after)
    return [np.where(earlier, *_steps(positions[..., plane], axis)) for plane in range(3)]


def _steps(values: Image, axis: int) -> tuple[Image, Image]:
    """Return the differences to the neighbour before and to the one after; edges repeat their inner one."""
    step = np.diff(values, axis=axis)
    first = step[:1] if axis == 0 else step[:, :1]
    last = step[-1:] if axis == 0 else step[:, -1:]
    return np.concatenate([first, step], axis=axis), np.concatenate([step, last], axis=axis)
