"""One board frame: passes, light, air, exposure, grade, ink (notes: sets and light, section 0)."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.coarser import in_coarser_pictures
from storyblender.blender.render.cycles import render_cycles
from storyblender.blender.render.lamps import PanoramaImage, lit
from storyblender.blender.render.meter import SetLight, balanced
from storyblender.blender.render.passes import Passes, render_passes
from storyblender.blender.render.session import RenderSession
from storyblender.blender.render.shot_light import (
    DRAFT_SHADOWS,
    FACE_SHADOWS,
    NO_SHADOWS,
    SHADOWS,
    PersonHead,
    ShadowsCast,
    ShotLight,
)
from storyblender.blender.render.smoke import puffs_of
from storyblender.errors import InputError
from storyblender.look.atmosphere import add_fog, add_halos, add_rain, transmittance
from storyblender.look.exposure import Face, bright_half, find_faces, shadow_lift, trim, with_shadows_raised
from storyblender.look.far_textures import HALVINGS
from storyblender.look.gbuffer import GBuffer
from storyblender.look.grade import display_of, to_bytes, to_display
from storyblender.look.illumination import sky_light
from storyblender.look.ink import apply_ink, draw_ink, people_nearby
from storyblender.look.lens_blur import blurred_frame
from storyblender.look.looks import LOOKS, Look
from storyblender.look.modelling import lift_hands, model_flesh
from storyblender.look.pencil import draw_pencil, level_ground
from storyblender.look.raster import Image, luminance, shrink
from storyblender.look.relief import emboss
from storyblender.look.relight import demodulate, mean_albedo, remodulate, upsample
from storyblender.look.smoke import Puff, add_smoke, through_smoke
from storyblender.look.surface import FLESH
from storyblender.look.wet_ground import add_wet_ground, wetness
from storyblender.memory.scene_context import Fog, Light, Lighting


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
        shadows: Solve the lamps by the shadows that they cast.
        draft: Draw it in half the time: passes no larger than the picture, shadows of the strongest lamps only.
        panorama: The picture of the light plan's panorama, if it has one.
    """

    look: str = "board"
    width: int = 960
    height: int = 540
    frame: int | None = None
    seed: int = 0
    hidden_node_ids: tuple[str, ...] = ()
    supersample: int | None = None
    samples: int | None = None
    shadows: bool = True
    draft: bool = False
    panorama: Path | None = None


@dataclass(frozen=True)
class FrameStatistics:
    """What a critic wants to know of a frame.

    Attributes:
        face_luminance: Scene-linear, exposed, of the lit half of all faces; None without a visible face.
        exposure: Stops by which the whole frame was trimmed.
        shadow_lift: Stops by which its shadows were raised after that.
        void: Share of the frame that shows no object.
        visible: Share of the frame by node_id.
    """

    face_luminance: float | None
    exposure: float
    shadow_lift: float
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
        balance: The light of the set as metered for this shot.
    """

    image: NDArray[np.uint8]
    lights: tuple[Light, ...]
    set_lights: tuple[Light, ...]
    statistics: FrameStatistics
    balance: SetLight


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
    step = request.supersample or (1 if request.draft else look.supersample)
    with (
        RenderSession(scene, camera_object, request.frame, request.hidden_node_ids) as session,
        ThreadPoolExecutor(1) as aside,  # for what needs no Blender, while Blender draws
    ):
        aside.submit(display_of, look.contrast)
        puffs = puffs_of(session.smoke_objects)
        passes = render_passes(session, request.width * step, request.height * step)
        set_light = balanced(scene, lighting)
        plan = set_light.plan
        inked = aside.submit(_inked, passes.gbuffer, plan.fog, puffs, look, step)
        cast = _casting(look, request)
        shot = ShotLight(session, passes, set_light, people, step * look.light_step, shadows=cast)
        lights = shot.set_lights + shot.lights
        picture = _relit(session, passes.gbuffer, shot, look, request, step)
        lens = session.lens()
    gbuffer, (through, clear), ink = inked.result()
    depth, rays, eye = gbuffer.depth, gbuffer.view.rays(), gbuffer.view.eye
    picture = add_fog(add_smoke(picture, puffs, clear, shot.set_lights, plan.set_luminance), plan.fog, through, rays)
    picture = add_halos(picture, lights, depth, rays, eye)
    wet = wetness(plan, set_light.roofed)
    picture = add_wet_ground(picture, gbuffer, plan.sky, wet, water=look.light == "numpy")
    faces = find_faces(gbuffer, [(head.asset_id, head.location, head.scale) for head in people if head.in_frame])
    stops = trim(picture, faces, plan.face_luminance, plan.set_luminance)
    picture *= 2.0**stops
    lift = shadow_lift(picture)
    picture = with_shadows_raised(picture, lift)
    masks, sharp = _masks(passes.gbuffer, look, step), picture
    if lens is not None:
        surfaces, ink = blurred_frame(np.dstack([picture, *masks]), ink, passes.gbuffer.depth, lens, step)
        picture, masks = surfaces[..., :3], list(np.moveaxis(surfaces[..., 3:], 2, 0))
    picture = add_rain(picture, depth, plan.rain, request.seed)
    display = to_display(picture, look.contrast)
    statistics = _statistics(passes, picture if lens is None else sharp, faces, (stops, lift))
    drawing = _drawn(display, ink, masks, look)
    return FrameResult(to_bytes(drawing), shot.lights, shot.set_lights, statistics, set_light)


def _inked(
    gbuffer: GBuffer, fog: Fog | None, puffs: Sequence[Puff], look: Look, step: int
) -> tuple[GBuffer, tuple[Image, Image], Image | None]:
    """Return the G-buffer at the picture's size, the shares of light that fog and smoke let through, and the lines."""
    small = gbuffer.reduced(step)
    through = transmittance(fog, small.depth, small.view.rays(), small.view.eye)
    clear = through_smoke(puffs, small.depth, small.view.rays(), small.view.eye)
    return small, (through, clear), draw_ink(gbuffer, step, through * clear) if look.ink > 0 else None


def _masks(gbuffer: GBuffer, look: Look, step: int) -> list[Image]:
    """Return what the look's drawing wants to know of each pixel, (h, w), 0 to 1."""
    if look.ink <= 0:
        return []
    if look.style == "pencil":
        return [gbuffer.coverage(FLESH, step), level_ground(gbuffer.reduced(step))]
    return [people_nearby(gbuffer, step)]


def _drawn(display: Image, ink: Image | None, masks: Sequence[Image], look: Look) -> Image:
    """Return the display picture with the look's lines, or as the look's drawing."""
    if ink is None:
        return display
    if look.style == "pencil":
        flesh, level = masks
        return draw_pencil(display, ink, flesh, level, look.ink)
    return apply_ink(display, ink, masks[0], look.ink)


def _casting(look: Look, request: FrameRequest) -> ShadowsCast:
    """Return which lamps get a shadow map."""
    if not request.shadows:
        return NO_SHADOWS
    return DRAFT_SHADOWS if request.draft else SHADOWS if look.light == "numpy" else FACE_SHADOWS


def _look_of(request: FrameRequest) -> Look:
    if request.look not in LOOKS:
        raise InputError(f"there is no look {request.look!r}", mend=f"choose one of {', '.join(LOOKS)}")
    look = LOOKS[request.look]
    least = max(2, look.light_step)
    if request.width % least or request.height % least:
        size = f"{request.width} x {request.height}"
        raise InputError(f"a {request.look} frame of {size} cannot be divided", mend=f"use multiples of {least}")
    return look


def _relit(
    session: RenderSession, gbuffer: GBuffer, shot: ShotLight, look: Look, request: FrameRequest, step: int
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
        light = shot.illumination() * shot.patches
        lift_hands(light, shot.flesh)
        light = upsample(light, gbuffer, look.light_step)
        emboss(light, gbuffer, shot.set_lights + shot.lights)
        share = shrink(gbuffer.sky.astype(np.float32), step)[..., None]
        return mean_albedo(gbuffer, step) * light + gbuffer.emission(step) + sky * share
    cast = [obj for obj in session.visible_objects() if obj.get("kind") == "character"]
    panorama = None
    if shot.plan.panorama is not None and request.panorama is not None:
        panorama = PanoramaImage(shot.plan.panorama, request.panorama, seen=look.light == "final")
    # Light at low resolution is taken from what the coarse albedo shows.
    copies = in_coarser_pictures(list(bpy.data.materials), HALVINGS[0]) if look.light == "cycles" else nullcontext()
    with copies, lit(session.scene, shot.set_lights + shot.lights, shot.plan.sky, cast, panorama):
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
    light = (demodulate(reflected, mean_albedo(gbuffer, coarse, low_sky)) + shot.roof_light) * shot.patches
    lift_hands(light, shot.flesh)
    light = upsample(light, gbuffer, look.light_step)
    model_flesh(light, gbuffer, shot.lights)
    emboss(light, gbuffer, shot.set_lights + shot.lights)
    return remodulate(light, mean_albedo(gbuffer, step, sky)) + gbuffer.emission(step)


def _statistics(passes: Passes, picture: Image, faces: Sequence[Face], exposed: tuple[float, float]) -> FrameStatistics:
    face_luminance = None
    if faces:
        face_luminance = bright_half(luminance(picture)[np.logical_or.reduce([face.mask for face in faces])])
    return FrameStatistics(face_luminance, *exposed, float(passes.gbuffer.sky.mean()), passes.visible_shares())
