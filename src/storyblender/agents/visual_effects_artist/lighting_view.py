"""What the Lighting Arranger's rules look at, and the lamps they find there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from storyblender.catalog.light_recipes import LAMPS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.called import called
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Color, Vec3
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Environment, Layout, Light, Lighting, SceneSetup

MOST_LIGHTS = 20
"""Lamps a plan may have; every one costs time in every frame."""
_REACH = 26.0
"""Metres from the stage beyond which a lamp is scenery, not light."""


@dataclass(frozen=True)
class LightingView:
    """What the Lighting Arranger sees.

    Attributes:
        setup: Time, weather and the words on light.
        plan: The set with its windows and its own lamps.
        environment: Its seed decides which side the sun comes from.
        layout: Where lamp props stand; without it the plan's furnishings count.
        assets: To know which of the layout's objects are lamps.
        current: The light until now, where the script changes it.
        change: The words of the change, e.g. ``The lights go out``.
    """

    setup: SceneSetup
    plan: SetPlan
    environment: Environment
    layout: Layout | None = None
    assets: tuple[Asset, ...] = ()
    current: Lighting | None = None
    change: str = ""


def lighting_view(
    graph: ContinuityMemoryGraph, scene_id: int, current: Lighting | None = None, change: str = ""
) -> LightingView:
    """Return the Lighting Arranger's projection of the graph.

    Args:
        graph: With the scene's set and layout.
        scene_id: Of the scene.
        current: The light until now, where the script changes it.
        change: The words of the change.
    """
    scene = graph.scene(scene_id)
    assert scene.environment is not None, "the set comes before its light"
    plan, assets = plan_of(scene.environment), graph.assets_of(scene_id)
    return LightingView(scene.setup, plan, scene.environment, scene.layout, assets, current, change)


def burning_lamps(view: LightingView, share: float) -> tuple[Light, ...]:
    """Return the burning lamps: those of the architecture and one inside every lamp prop."""
    if share <= 0:
        return ()
    lights = [*view.plan.lamps, *_lamp_props(view)]
    near = [light for light in lights if math.hypot(light.location[0], light.location[1]) < _REACH or light.power > 300]
    return tuple(light.model_copy(update={"power": round(light.power * share, 3)}) for light in near)


def _lamp_props(view: LightingView) -> Iterator[Light]:
    for node_id, key, place, yaw, height in _standing_props(view):
        kind, entry = LAMPS.get(key), PROPS.get(key)
        if kind is None:
            continue
        at = (0.0, 0.0, 0.5) if entry is None or entry.lamp is None else entry.lamp
        usual = entry.size[2] if entry is not None else 1.0
        if entry is not None and entry.placement != "ceiling" and height:
            at = (at[0], at[1], at[2] * height / usual)
        turn, (dx, dy, dz) = math.radians(yaw), (at[i] + kind.offset[i] for i in range(3))
        x = place[0] + dx * math.cos(turn) - dy * math.sin(turn)
        y = place[1] + dx * math.sin(turn) + dy * math.cos(turn)
        spot = (round(x, 3), round(y, 3), round(place[2] + dz, 3))
        ahead = (x + 2 * math.sin(turn), y - 2 * math.cos(turn), spot[2]) if key == "television" else (x, y, 0.0)
        yield Light(
            name=f"{node_id}_light",
            kind=kind.kind,
            role="practical",
            location=spot,
            target=ahead,
            power=kind.watts,
            color=kind.color,
            size=kind.size,
            cone=140.0,
            blend=0.6,
            glow=kind.glow,
        )


def _standing_props(view: LightingView) -> Iterator[tuple[str, str, Vec3, float, float]]:
    """Yield node_id, prop key, location, yaw and height of every prop of the scene."""
    if view.layout is None:
        for item in view.plan.furnishings:
            yield item.node_id, item.prop, item.location, item.yaw, float(item.params.get("height", 0.0))
        return
    assets = {asset.asset_id: asset for asset in view.assets}
    for placed in view.layout.objects:
        asset = assets.get(placed.asset_id)
        if asset is None or asset.canonical is None:
            continue
        made, entry = asset.canonical, called(asset.name) if asset.canonical.source == "file" else None
        key = made.key if made.source == "catalog" else entry.key if entry is not None else ""
        if key:
            yield placed.node_id, key, placed.location, placed.rotation[2], made.dimensions[2]


def strongest(lights: tuple[Light, ...], count: int) -> tuple[Light, ...]:
    """Return the ``count`` lamps that give the stage most, in their order; the sun always stays."""

    def weight(light: Light) -> float:
        if light.kind == "SUN":
            return math.inf
        return light.power * (4 if light.kind == "AREA" else 1) / (1.0 + math.dist(light.location, (0, 0, 1.4)) ** 2)

    kept = sorted(range(len(lights)), key=lambda index: -weight(lights[index]))[:count]
    return tuple(lights[index] for index in sorted(kept))


def mean_color(lights: tuple[Light, ...]) -> Color:
    """Return the colour of the lamps together, by their watts."""
    watts = sum(light.power for light in lights) or 1.0
    red, green, blue = (sum(light.power * light.color[band] for light in lights) / watts for band in range(3))
    return (red, green, blue)
