"""One board frame: passes, light, air, exposure, grade, ink (notes: sets and light, section 0)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.cycles import render_cycles
from storyblender.blender.render.lamps import FACE_ROLES, lit
from storyblender.blender.render.meter import SetLight, balanced, reach_of
from storyblender.blender.render.passes import Passes, render_passes
from storyblender.blender.render.session import RenderSession
from storyblender.blender.render.shadow_maps import render_shadow_map
from storyblender.errors import InputError
from storyblender.look.atmosphere import add_fog, add_halos, add_rain, transmittance
from storyblender.look.exposure import Face, bright_half, dim_set_lamps, find_faces, solve_faces, trim
from storyblender.look.face_light import face_lights
from storyblender.look.gbuffer import GBuffer
from storyblender.look.grade import to_bytes, to_display
from storyblender.look.illumination import (
    LightField,
    ambient_light,
    bounce_light,
    light_field,
    roof_light,
    sky_light,
    soft_foliage,
    strength,
    total,
)
from storyblender.look.ink import apply_ink, draw_ink, people_nearby
from storyblender.look.looks import LOOKS, Look
from storyblender.look.occlusion import ambient_occlusion
from storyblender.look.pencil import draw_pencil
from storyblender.look.raster import Image, Mask, blur, luminance, shrink
from storyblender.look.relight import demodulate, mean_albedo, remodulate, upsample
from storyblender.look.surface import FLESH
from storyblender.look.wet_ground import add_wet_ground, wetness
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Light, Lighting

_MOST_LIT_FACES = 4
_SET_SHADOWS = 2
"""Lamps of the set that get a shadow map; the sun and the keys always do."""
_KEY_SHADOWS = 2
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


@dataclass(frozen=True)
class FrameRequest:
    """What to draw, and how.

    Attributes:
        look: Key of ``look.looks.LOOKS``.
        width: Pixels, a multiple of 2.
        height: Pixels, a multiple of 2.
        frame: Timeline frame; None stays where the scene is.
        seed: Of path tracing and rain.
        hidden_node_ids: Wild walls, taken away for this shot.
        supersample: Size of the passes over the picture; None takes the look's.
        samples: Paths a pixel; None takes the look's.
    """

    look: str = "board"
    width: int = 960
    height: int = 540
    frame: int | None = None
    seed: int = 0
    hidden_node_ids: tuple[str, ...] = ()
    supersample: int | None = None
    samples: int | None = None


@dataclass(frozen=True)
class FrameStatistics:
    """What a critic wants to know of a frame.

    Attributes:
        face_luminance: Scene-linear, exposed, of the lit half of all faces; None without a visible face.
        face_contrast: Display brightness of the faces over that of the ring around them.
        exposure: Stops by which the whole frame was trimmed.
        void: Share of the frame that shows no object.
        visible: Share of the frame by node_id.
    """

    face_luminance: float | None
    face_contrast: float | None
    exposure: float
    void: float
    visible: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class FrameResult:
    """A drawn frame.

    Attributes:
        image: uint8 (h, w, 3), sRGB.
        lights: Key, fill and rim of the shot as solved.
        set_lights: The set's lamps, balanced; those that would burn a face out are dimmed for this shot.
        statistics: Measured on the picture.
    """

    image: NDArray[np.uint8]
    lights: tuple[Light, ...]
    set_lights: tuple[Light, ...]
    statistics: FrameStatistics


def render_frame(
    scene: bpy.types.Scene,
    camera_object: bpy.types.Object,
    lighting: Lighting,
    people: Sequence[PersonHead],
    request: FrameRequest,
) -> FrameResult:
    """Draw one frame; the scene is left as it was.

    Args:
        scene: With set, props and people, tagged (``blender.tags``); its own lights do not matter.
        camera_object: A camera of the scene.
        lighting: The scene's light plan as designed; it is balanced here.
        people: Everyone whose face may show.
        request: Look, size and frame.

    Raises:
        InputError: The look is unknown or the size cannot be divided.
    """
    look = _look_of(request)
    step = request.supersample or look.supersample
    with RenderSession(scene, camera_object, request.frame, request.hidden_node_ids) as session:
        passes = render_passes(session, request.width * step, request.height * step)
        set_light = balanced(scene, lighting)
        plan = set_light.plan
        shot = _Shot(session, passes, set_light, people, step * look.light_step)
        lights = shot.set_lights + shot.lights
        picture = _relit(session, passes.gbuffer, shot, look, request, step)
    gbuffer = passes.gbuffer.reduced(step)
    depth, rays, eye = gbuffer.depth, gbuffer.view.rays(), gbuffer.view.eye
    through = transmittance(plan.fog, depth, rays, eye)
    picture = add_halos(add_fog(picture, plan.fog, through, rays), lights, depth, rays, eye)
    wet = wetness(plan, set_light.roofed)
    picture = add_wet_ground(picture, gbuffer, plan.sky, wet, water=look.light == "numpy")
    faces = find_faces(gbuffer, [(head.asset_id, head.location, head.scale) for head in people if head.in_frame])
    stops = trim(picture, faces, plan.face_luminance, plan.set_luminance)
    picture *= 2.0**stops
    picture = add_rain(picture, depth, plan.rain, request.seed)
    display = to_display(picture, look.contrast)
    statistics = _statistics(passes, picture, display, faces, stops)
    if look.ink > 0:
        ink = draw_ink(passes.gbuffer, step, through)
        if look.style == "pencil":
            display = draw_pencil(display, ink, passes.gbuffer.coverage(FLESH, step), look.ink)
        else:
            display = apply_ink(display, ink, people_nearby(passes.gbuffer, step), look.ink)
    return FrameResult(to_bytes(display), shot.lights, shot.set_lights, statistics)


def _look_of(request: FrameRequest) -> Look:
    if request.look not in LOOKS:
        raise InputError(f"there is no look {request.look!r}", mend=f"choose one of {', '.join(LOOKS)}")
    look = LOOKS[request.look]
    if request.width % look.light_step or request.height % look.light_step:
        raise InputError(f"a {request.look} frame of {request.width}x{request.height} cannot be divided",
                         mend=f"use multiples of {look.light_step}")  # fmt: skip
    return look


class _Shot:
    """The lamps of one shot, in numpy at the resolution of the light: shadows cast, faces solved.

    Args:
        session: The frame.
        passes: Its G-buffer.
        set_light: Balanced light of the set.
        people: Everyone whose face may show.
        step: Pixels of the G-buffer for one pixel of light.
    """

    def __init__(
        self, session: RenderSession, passes: Passes, set_light: SetLight, people: Sequence[PersonHead], step: int
    ) -> None:
        self.gbuffer: GBuffer = passes.gbuffer.reduced(step)
        self.plan = set_light.plan
        self.albedo = mean_albedo(passes.gbuffer, step)
        self._positions = self.gbuffer.positions()
        self._normal = soft_foliage(self.gbuffer.normal.astype(np.float32), self.gbuffer)
        self._openness = ambient_occlusion(self.gbuffer.depth, self.gbuffer.view, self._positions, self._normal)
        ambient = ambient_light(self.plan, set_light.roofed, self._normal, self._openness)
        self.roof_light = roof_light(self.plan, set_light.roofed, self._normal) * self._openness[..., None]
        lamps = self.plan.lights + _lamps_of_faces(session, people, self.plan)
        fields = [light_field(lamp, self._positions, self._normal) for lamp in lamps]
        fields = self._with_shadows(session, fields, _pixels_of(people, passes, self.gbuffer))
        from_set = total([f for f in fields if f.light.for_asset is None], ambient)
        bounce = bounce_light(self.albedo, from_set, ~self.gbuffer.sky, self._openness)
        faces = find_faces(self.gbuffer, [(head.asset_id, head.location, head.scale) for head in people])
        self._around = ambient + bounce
        target = self.plan.face_luminance
        fields = dim_set_lamps(fields, self._around, self.albedo, faces, target)
        self.fields = solve_faces(fields, self._around, self.albedo, faces, target)

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

    def _with_shadows(
        self, session: RenderSession, fields: list[LightField], bodies: Sequence[tuple[PersonHead, Mask]]
    ) -> list[LightField]:
        """Cast shadows from the lamps that matter; of the others, ask at each face whether they reach it."""
        eye = self.gbuffer.view.eye.astype(np.float32)
        solid = ~self.gbuffer.sky
        shares = [strength(field, self.albedo) for field in fields]
        whole = max(sum(shares), 1e-9)
        casting = _casting(fields, [share / whole for share in shares])
        result = []
        for index, lamp in enumerate(fields):
            if index in casting:
                receivers = self._positions[solid & (lamp.amount > 0)]
                shadow = render_shadow_map(session, lamp.light, receivers, eye)
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


def _round_face(head: PersonHead) -> list[Vec3]:
    """Return five points round a face, at the distance of a hand."""
    x, y, z = head.location
    reach = 0.12 * head.scale
    return [(x, y, z), (x + reach, y, z), (x - reach, y, z), (x, y + reach, z), (x, y - reach, z - reach)]


def _casting(fields: Sequence[LightField], shares: Sequence[float]) -> frozenset[int]:
    """Return which lamps get a shadow map: the sun, the strongest keys, the strongest lamps of the set."""
    by_share = sorted(range(len(fields)), key=lambda index: (-shares[index], index))
    chosen: list[int] = []
    for kinds, most in ((("sun",), 1), (("key",), _KEY_SHADOWS), (("set", "practical"), _SET_SHADOWS)):
        able = [index for index in by_share if fields[index].light.role in kinds and fields[index].amount.any()]
        least = 0.0 if kinds != ("set", "practical") else _LEAST_STRENGTH
        chosen += [index for index in able if shares[index] >= least][:most]
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


def _relit(
    session: RenderSession, gbuffer: GBuffer, shot: _Shot, look: Look, request: FrameRequest, step: int
) -> Image:
    """Return the linear picture without air, at the size asked for.

    Args:
        session: The frame.
        gbuffer: Supersampled.
        shot: Its lamps, solved.
        look: Says where light comes from.
        request: Size, samples and seed.
        step: Supersampling factor.
    """
    sky = sky_light(shot.plan.sky, gbuffer.view.reduced(step).rays())
    if look.light == "numpy":
        light = upsample(shot.illumination(), gbuffer, look.light_step)
        share = shrink(gbuffer.sky.astype(np.float32), step)[..., None]
        return mean_albedo(gbuffer, step) * light + gbuffer.emission(step) + sky * share
    cast = [obj for obj in session.visible_objects() if obj.get("kind") == "character"]
    with lit(session.scene, shot.set_lights + shot.lights, shot.plan.sky, cast):
        traced = render_cycles(
            session,
            request.width // look.light_step,
            request.height // look.light_step,
            samples=request.samples or look.samples,
            bounces=look.bounces,
            seed=request.seed,
            draft=look.light == "cycles",
        )
    if look.light_step == 1:
        return traced + shot.albedo * shot.roof_light
    coarse = step * look.light_step
    low_sky = sky_light(shot.plan.sky, gbuffer.view.reduced(coarse).rays())
    # What glows by itself is not light on a surface: left in, a lamp would ring what is behind it.
    reflected = np.maximum(traced - gbuffer.emission(coarse), 0)
    light = demodulate(reflected, mean_albedo(gbuffer, coarse, low_sky)) + shot.roof_light
    picture = remodulate(upsample(light, gbuffer, look.light_step), mean_albedo(gbuffer, step, sky))
    return picture + gbuffer.emission(step)


def _statistics(passes: Passes, picture: Image, display: Image, faces: Sequence[Face], stops: float) -> FrameStatistics:
    face_luminance = contrast = None
    if faces:
        mask = np.logical_or.reduce([face.mask for face in faces])
        ring = (blur(mask.astype(np.float32), max(4, round(0.04 * mask.shape[0]))) > 0) & ~mask
        face_luminance = bright_half(luminance(picture)[mask])
        tone = luminance(display)
        contrast = float((tone[mask].mean() + 0.05) / (tone[ring].mean() + 0.05))
    return FrameStatistics(face_luminance, contrast, stops, float(passes.gbuffer.sky.mean()), passes.visible_shares())
