"""The Lighting Arranger's view of a scene, and the lamps in it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from storyblender.catalog.light_recipes import LAMPS, LampKind
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.errors import NoAnswer
from storyblender.memory.asset_sheet import Asset, ParamValue
from storyblender.memory.base import Color, Vec3, is_none
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.panorama import Panorama
from storyblender.memory.request import Picture
from storyblender.memory.scene_context import Environment, Layout, Light, Lighting, SceneContext, SceneSetup
from storyblender.memory.shot_context import LightChange

MOST_LIGHTS = 20
"""Most lights of a plan; every one costs time in every frame."""
_REACH = 26.0
"""Metres from the stage beyond which a lamp is scenery, not light."""


DrawLight = Callable[[Lighting], tuple[Picture, ...]]
"""Draws shots of a scene in a light plan. Raises NoAnswer."""


def nothing_lit(plan: Lighting) -> tuple[Picture, ...]:
    """Refuse to draw: there is no engine. Raises NoAnswer."""
    raise NoAnswer("there is no picture of the light")


class CarriedLamp(NamedTuple):
    """A lamp away from its layout position: its place, and where a person aims its beam (world metres)."""

    place: Vec3
    aim: Vec3 | None


@dataclass(frozen=True)
class LightingArrangerView:
    """What the Lighting Arranger sees of a scene.

    Attributes:
        setup: Hour, weather and light of the place.
        plan: The set with its windows and its own lamps.
        environment: Its seed decides from which side the sun comes.
        layout: Positions of lamp props; None for those of the plan's furnishings.
        assets: Assets of the scene, to know which objects are lamps.
        current: The light so far, if the script changes it.
        change: The change.
        burning: Whether a lamp burns, by asset id, if the story says so.
        carried: Lamps that have left their places, by asset id.
        panorama: The user's high-dynamic-range panorama on offer, for exteriors by day.
        sun_side: Viewer's side from which the sun comes; None lets the set's seed decide.
        outline: The words of the scene, which only a language model reads.
        shot_id: Shot in which the light changes; 0 for the light of the scene.
        draw: Draws shots of the scene in a light plan, for critics who look. Raises NoAnswer.
    """

    setup: SceneSetup
    plan: SetPlan
    environment: Environment
    layout: Layout | None = None
    assets: tuple[Asset, ...] = ()
    current: Lighting | None = None
    change: LightChange | None = None
    burning: Mapping[str, bool] = field(default_factory=dict[str, bool])
    carried: Mapping[str, CarriedLamp] = field(default_factory=dict[str, CarriedLamp])
    panorama: Annotated[Panorama | None, Field(exclude_if=is_none)] = None
    sun_side: Literal["left", "right"] | None = None
    outline: SceneOutline | None = None
    shot_id: int = 0
    draw: Annotated[DrawLight, Field(exclude=True)] = nothing_lit

    @property
    def sun_from_left(self) -> bool:
        """Whether the sun comes from the viewer's left."""
        return self.environment.seed % 2 == 1 if self.sun_side is None else self.sun_side == "left"


def lighting_arranger_view(
    graph: ContinuityMemoryGraph,
    scene_id: int,
    current: Lighting | None = None,
    change: LightChange | None = None,
    shot_id: int = 0,
    draw: DrawLight = nothing_lit,
) -> LightingArrangerView:
    """Return the Lighting Arranger's projection of the graph.

    Args:
        graph: The graph, with the scene's set and layout.
        scene_id: Number of the scene.
        current: The light so far, if the script changes it.
        change: The change.
        shot_id: Shot of the change.
        draw: Draws shots of the scene in a light plan. Raises NoAnswer.
    """
    scene = graph.scene(scene_id)
    assert scene.environment is not None, "the set comes before its light"
    plan, assets = plan_of(scene.environment), graph.assets_of(scene_id)
    return LightingArrangerView(
        scene.decided_setup, plan, scene.environment, scene.layout, assets, current, change,
        panorama=_panorama(graph, scene), outline=graph.outline_of(scene_id), shot_id=shot_id, draw=draw,
    )  # fmt: skip


def _panorama(graph: ContinuityMemoryGraph, scene: SceneContext) -> Panorama | None:
    """Return the panorama on offer to a scene: the one that a person chose for it, the story's, or the crew's."""
    chosen = scene.light_decision.panorama if scene.light_decision is not None else None
    if chosen is not None:
        return chosen if chosen != "none" else None
    return graph.panorama or scene.offered_panorama


def burning_lamps(view: LightingArrangerView, share: float) -> tuple[Light, ...]:
    """Return the lights that burn: those of the set and one in every lamp prop that is not off.

    Args:
        view: The scene.
        share: Share of their power, 0 to 1, for lamps that the story does not mention.
    """
    lights = [(light, share) for light in view.plan.lamps]
    lights += [(light, 1.0 if told else share) for light, told in _list_lamp_props(view)]
    return tuple(
        light.model_copy(update={"power": round(light.power * part, 3)})
        for light, part in lights
        if part > 0 and (math.hypot(light.location[0], light.location[1]) < _REACH or light.power > 300)
    )


def _list_lamp_props(view: LightingArrangerView) -> Iterator[tuple[Light, bool]]:
    """Yield the light of every lamp prop that is not off, and whether the story says that it burns."""
    for prop in _list_placed_props(view):
        kind, told = LAMPS.get(prop.key), view.burning.get(prop.asset_id)
        if kind is None or told is False or (told is None and (prop.unlit or kind.off_by_default)):
            continue
        carried = view.carried.get(prop.asset_id)
        place = prop.place if carried is None else carried.place
        spot, ahead = _lamp_beam(prop, kind, place)
        if carried is not None and carried.aim is not None:
            spot, ahead = (place[0], place[1], round(place[2] + kind.offset[2], 3)), carried.aim
        light = Light(
            name=f"{prop.node_id}_light",
            kind=kind.kind,
            role="practical",
            location=spot,
            target=ahead,
            power=kind.watts,
            color=kind.color,
            size=kind.size,
            cone=kind.cone,
            blend=0.6,
            glow=kind.glow,
        )
        yield light, bool(told)


def _lamp_beam(prop: _PlacedProp, kind: LampKind, place: Vec3) -> tuple[Vec3, Vec3]:
    """Return the position of a lamp's light, and the point it shines at: the floor, or 2 m ahead for a beam."""
    entry = PROPS.get(prop.key)
    at = (0.0, 0.0, 0.5) if entry is None or entry.lamp is None else entry.lamp
    usual = entry.size[2] if entry is not None else 1.0
    if entry is not None and entry.placement != "ceiling" and prop.height:
        at = (at[0], at[1], at[2] * prop.height / usual)
    turn, (dx, dy, dz) = math.radians(prop.yaw), (at[i] + kind.offset[i] for i in range(3))
    x = place[0] + dx * math.cos(turn) - dy * math.sin(turn)
    y = place[1] + dx * math.sin(turn) + dy * math.cos(turn)
    spot = (round(x, 3), round(y, 3), round(place[2] + dz, 3))
    beam = prop.key == "television" or kind.off_by_default
    return spot, (x + 2 * math.sin(turn), y - 2 * math.cos(turn), spot[2]) if beam else (x, y, 0.0)


class _PlacedProp(NamedTuple):
    """A prop of the scene: place in metres, yaw in degrees, height in metres, and whether it was built dark."""

    node_id: str
    asset_id: str
    key: str
    place: Vec3
    yaw: float
    height: float
    unlit: bool


def _list_placed_props(view: LightingArrangerView) -> Iterator[_PlacedProp]:
    """Yield every prop of the scene, and every lamp that a person brought."""
    if view.layout is None:
        for item in view.plan.furnishings:
            height = float(item.params.get("height", 0.0))
            yield _PlacedProp(
                item.node_id, item.node_id, item.prop, item.location, item.yaw, height, is_built_dark(item.params)
            )
        return
    assets = {asset.asset_id: asset for asset in view.assets}
    for placed in view.layout.objects:
        asset = assets.get(placed.asset_id)
        if asset is not None and asset.canonical is not None and (key := prop_of(asset)):
            made, dark = asset.canonical, is_built_dark(asset.canonical.params)
            yield _PlacedProp(
                placed.node_id, asset.asset_id, key, placed.location, placed.rotation[2], made.dimensions[2], dark
            )
    homes = {placed.asset_id for placed in view.layout.objects}
    for asset_id, carried in view.carried.items():
        asset = assets.get(asset_id)
        if asset_id not in homes and asset is not None and asset.canonical is not None:
            made = asset.canonical
            yield _PlacedProp(
                asset_id, asset_id, prop_of(asset), carried.place, 0.0, made.dimensions[2], is_built_dark(made.params)
            )


def is_built_dark(params: Mapping[str, ParamValue]) -> bool:
    """Return whether a prop with these parameters was built without its light."""
    return bool(params.get("unlit")) or params.get("lit") is False or params.get("on") is False


def strongest_lights(lights: tuple[Light, ...], count: int) -> tuple[Light, ...]:
    """Return the ``count`` lights that give the stage most, in their order; the sun always stays."""

    def weight(light: Light) -> float:
        if light.kind == "SUN":
            return math.inf
        return light.power * (4 if light.kind == "AREA" else 1) / (1.0 + math.dist(light.location, (0, 0, 1.4)) ** 2)

    kept = sorted(range(len(lights)), key=lambda index: -weight(lights[index]))[:count]
    return tuple(lights[index] for index in sorted(kept))


def mean_color(lights: tuple[Light, ...]) -> Color:
    """Return the mean colour of lights, weighted by their power."""
    watts = sum(light.power for light in lights) or 1.0
    red, green, blue = (sum(light.power * light.color[band] for light in lights) / watts for band in range(3))
    return (red, green, blue)
