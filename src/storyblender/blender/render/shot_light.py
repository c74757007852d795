"""The lamps of one shot in numpy: shadows cast, practicals held back, every face solved (notes: sets and light, 1)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from storyblender.blender.render.lamps import FACE_ROLES
from storyblender.blender.render.meter import SetLight, reach_of
from storyblender.blender.render.passes import Passes
from storyblender.blender.render.session import RenderSession
from storyblender.blender.render.shadow_maps import render_shadow_map
from storyblender.look.exposure import Face, dim_set_lamps, find_faces, solve_faces
from storyblender.look.face_light import face_lights
from storyblender.look.gbuffer import GBuffer
from storyblender.look.illumination import (
    LightField,
    ambient_light,
    bounce_light,
    light_field,
    roof_light,
    soft_foliage,
    strength,
    total,
)
from storyblender.look.modelling import Flesh
from storyblender.look.occlusion import ambient_occlusion
from storyblender.look.patches import ground_patches
from storyblender.look.raster import Image, Mask, blur
from storyblender.look.relight import mean_albedo
from storyblender.look.surface import Surface
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting

_MOST_LIT_FACES = 4


@dataclass(frozen=True)
class ShadowsCast:
    """Which lamps get a shadow map; of the others it is asked at each face whether they reach it.

    Attributes:
        most: Lamps by role, at most; practicals count with the set.
        fineness: Factor on the pixels across each map.
    """

    most: Mapping[str, int]
    fineness: float = 1.0


SHADOWS = ShadowsCast(MappingProxyType({"sun": 1, "key": 2, "set": 2}))
FACE_SHADOWS = ShadowsCast(MappingProxyType({"sun": 1, "key": 2}))
"""Enough to solve the faces, where a path tracer draws the shadows that are seen."""
DRAFT_SHADOWS = ShadowsCast(MappingProxyType({"sun": 1, "key": 1, "set": 1}), 0.5)
"""Enough for a preview: each map costs as much as a pass."""
NO_SHADOWS = ShadowsCast(MappingProxyType({}))
_LEAST_STRENGTH = 0.08
"""Share of the frame's light below which a lamp's shadow would not be seen."""


@dataclass(frozen=True)
class PersonHead:
    """Where a person's face is.

    Attributes:
        asset_id: Whose.
        location: Centre of the face, world, metres.
        yaw: Where the face looks, degrees; 0 is -Y, counter-clockwise.
        scale: Size of the person; 1 for a grown-up.
        in_frame: Whether the shot is meant to show them; others get no light of their own.
    """

    asset_id: str
    location: Vec3
    yaw: float
    scale: float = 1.0
    in_frame: bool = True


class ShotLight:
    """The lamps of one shot, in numpy at the resolution of the light: shadows cast, faces solved.

    Args:
        session: The frame.
        passes: Its G-buffer.
        set_light: Balanced light of the set.
        people: Everyone whose face may show.
        step: Pixels of the G-buffer for one pixel of light.
        shadows: Which lamps cast them.
    """

    def __init__(
        self,
        session: RenderSession,
        passes: Passes,
        set_light: SetLight,
        people: Sequence[PersonHead],
        step: int,
        *,
        shadows: ShadowsCast = SHADOWS,
    ) -> None:
        self.gbuffer: GBuffer = passes.gbuffer.reduced(step)
        self.plan = set_light.plan
        self.albedo = mean_albedo(passes.gbuffer, step)
        self._positions = self.gbuffer.positions()
        self.patches = ground_patches(self.gbuffer, self._positions)
        self._normal = soft_foliage(self.gbuffer.normal.astype(np.float32), self.gbuffer)
        self._openness = ambient_occlusion(self.gbuffer.depth, self.gbuffer.view, self._normal)
        ambient = ambient_light(self.plan, set_light.roofed, self._normal, self._openness)
        self.roof_light = roof_light(self.plan, set_light.roofed, self._normal) * self._openness[..., None]
        bodies = _pixels_of(people, passes, self.gbuffer)
        lamps = self.plan.lights + _lamps_of_faces(session, self._by_hands(people, bodies), self.plan)
        fields = [light_field(lamp, self._positions, self._normal) for lamp in lamps]
        casting = self._casting(fields, shadows.most)
        fields = self._with_shadows(session, fields, casting, bodies, shadows.fineness)
        from_set = total([f for f in fields if f.light.for_asset is None], ambient)
        bounce = bounce_light(self.albedo, from_set, ~self.gbuffer.sky, self._openness)
        faces = find_faces(self.gbuffer, [(head.asset_id, head.location, head.scale) for head in people])
        self._around = ambient + bounce
        target = self.plan.face_luminance
        fields = dim_set_lamps(fields, self._around, self.albedo, faces, target)
        self.fields = solve_faces(fields, self._around, self.albedo, faces, target)
        self.flesh = _flesh_of(self.gbuffer, bodies, faces)

    @property
    def set_lights(self) -> tuple[Light, ...]:
        """The lamps of the set as they burn in this shot."""
        return tuple(field.light for field in self.fields[: len(self.plan.lights)])

    @property
    def lights(self) -> tuple[Light, ...]:
        """Key, fill and rim of the shot."""
        return tuple(field.light for field in self.fields[len(self.plan.lights) :])

    def illumination(self) -> Image:
        """Return the (h, w, 3) illumination by every lamp."""
        return total(self.fields, self._around)

    def _by_hands(
        self, people: Sequence[PersonHead], bodies: Sequence[tuple[PersonHead, Mask]]
    ) -> tuple[PersonHead, ...]:
        """Return the people; whose face is outside the picture is placed where their skin is seen: the hands get light.

        The lamps then stand round the hands as they stand round the face in other shots.
        """
        view, skin = self.gbuffer.view, self.gbuffer.surface == Surface.SKIN
        placed = {head.asset_id: head for head in people}
        for head, body in bodies:
            column, row, depth = view.project(np.array(head.location))
            seen = self._positions[body & skin]
            if len(seen) and not (depth > 0 and 0 <= column < view.width and 0 <= row < view.height):
                x, y, z = (float(part) for part in np.median(seen, axis=0))
                placed[head.asset_id] = replace(head, location=(x, y, z))
        return tuple(placed.values())

    def _casting(self, fields: Sequence[LightField], most: Mapping[str, int]) -> frozenset[int]:
        """Return which lamps matter enough to cast shadows."""
        shares = [strength(field, self.albedo) for field in fields]
        whole = max(sum(shares), 1e-9)
        return _casting(fields, [share / whole for share in shares], most)

    def _with_shadows(
        self,
        session: RenderSession,
        fields: list[LightField],
        casting: frozenset[int],
        bodies: Sequence[tuple[PersonHead, Mask]],
        fineness: float,
    ) -> list[LightField]:
        """Cast shadows from the lamps that matter; of the others, ask at each face whether they reach it."""
        eye = self.gbuffer.view.eye.astype(np.float32)
        solid = ~self.gbuffer.sky
        result = []
        for index, lamp in enumerate(fields):
            if index in casting:
                receivers = self._positions[solid & (lamp.amount > 0)]
                shadow = render_shadow_map(session, lamp.light, receivers, eye, fineness)
                result.append(lamp.shadowed(blur(shadow.visibility(self._positions, self._normal), 1)))
            elif lamp.light.role in FACE_ROLES:
                result.append(lamp)
            else:
                reach = 0.45 + 0.55 * self._openness
                for head, body in bodies:
                    reach[body] *= np.float32(reach_of(session.scene, lamp.light, _round_face(head)))
                result.append(lamp.shadowed(reach))
        return result


def _pixels_of(people: Sequence[PersonHead], passes: Passes, gbuffer: GBuffer) -> list[tuple[PersonHead, Mask]]:
    """Return the visible people and their pixels."""
    owners = np.array(["", *(node.node_id for node in passes.nodes)])
    bodies = [(head, (owners == head.asset_id)[gbuffer.ids]) for head in people]
    return [(head, body) for head, body in bodies if body.any()]


def _flesh_of(gbuffer: GBuffer, bodies: Sequence[tuple[PersonHead, Mask]], faces: Sequence[Face]) -> tuple[Flesh, ...]:
    skin: Mask = gbuffer.surface == Surface.SKIN
    shown, unseen = {face.asset_id: face.mask for face in faces}, np.zeros_like(skin)
    return tuple(Flesh(body & skin, body & shown.get(head.asset_id, unseen)) for head, body in bodies)


def _round_face(head: PersonHead) -> list[Vec3]:
    """Return five points round a face, at the distance of a hand."""
    x, y, z = head.location
    reach = 0.12 * head.scale
    return [(x, y, z), (x + reach, y, z), (x - reach, y, z), (x, y + reach, z), (x, y - reach, z - reach)]


def _casting(fields: Sequence[LightField], shares: Sequence[float], most: Mapping[str, int]) -> frozenset[int]:
    """Return which lamps get a shadow map: the sun, the strongest keys, the strongest lamps of the set."""
    by_share = sorted(range(len(fields)), key=lambda index: (-shares[index], index))
    chosen: list[int] = []
    for kind, roles in (("sun", ("sun",)), ("key", ("key",)), ("set", ("set", "practical"))):
        able = [index for index in by_share if fields[index].light.role in roles and fields[index].amount.any()]
        least = _LEAST_STRENGTH if kind == "set" else 0.0
        chosen += [index for index in able if shares[index] >= least][: most.get(kind, 0)]
    return frozenset(chosen)


def _lamps_of_faces(session: RenderSession, people: Sequence[PersonHead], plan: Lighting) -> tuple[Light, ...]:
    """Return key, fill and rim of the people meant to be seen, the nearest first."""
    eye = np.array(session.camera.matrix_world.translation)
    shown = sorted(
        (head for head in people if head.in_frame),
        key=lambda head: (float(np.linalg.norm(np.asarray(head.location) - eye)), head.asset_id),
    )[:_MOST_LIT_FACES]
    camera = (float(eye[0]), float(eye[1]), float(eye[2]))
    return tuple(lamp for head in shown for lamp in face_lights(head.location, head.yaw, camera, plan, head.asset_id))
