"""Layer 3, the Scene Context: setup, layout, set and light of one scene."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field, model_validator

from storyblender.memory.asset_sheet import AssetDecision, ParamValue
from storyblender.memory.base import Color, Coordinate, Frozen, Identifier, SceneId, ShotId, Vec3, dropping, is_none
from storyblender.memory.kept_takes import LayoutTakes
from storyblender.memory.locks import SceneLock, StaleWork
from storyblender.memory.panorama import Panorama, PanoramaLight
from storyblender.memory.scene_decision import LayoutDecision, LightDecision, SetDecision
from storyblender.memory.texture import Texture
from storyblender.memory.thing_states import Condition
from storyblender.memory.vocabulary import (
    Crowd,
    Facing,
    LightQuality,
    RelationKind,
    Relationship,
    SceneType,
    Side,
    TimeOfDay,
    Weather,
)


class Relation(Frozen):
    """A spatial relation stated by the script, e.g. jewel box *on* dressing table."""

    asset_id: Identifier
    kind: RelationKind
    anchor_asset_id: Identifier
    second_anchor_asset_id: Identifier | None = None
    """For ``between``."""


class Spot(Frozen):
    """Position of a person or prop as the script gives it; fields left empty are chosen automatically."""

    relation: RelationKind = "at"
    anchor_id: Identifier | None = None
    """The prop, person or set fixture (``door``, ``window``) that the position refers to."""
    side: Side | None = None
    """Side of the anchor; for a vehicle, which seat or door."""
    distance: float | None = Field(default=None, ge=0, le=1000)
    """Metres from the anchor."""
    height: float | None = Field(default=None, ge=-100, le=1000)
    """Metres from the floor to the feet of a person, or to the underside of a prop."""
    facing: Identifier | None = None
    """Facing direction: towards an id, ``away`` from the anchor, or towards the ``camera``."""


class SceneSetup(Frozen):
    """What the scene starts with (the paper's SceneSetup, extended)."""

    reference_scene_id: SceneId | None = None
    """An earlier scene in the same place: its set and furniture are reused."""
    asset_ids: tuple[Identifier, ...] = ()
    """Characters and objects present in the scene at any time, in order of appearance."""
    scene_type: SceneType = "indoor"
    place: str = ""
    """As written in the heading, e.g. ``RICK'S CAFE``."""
    kit: str = ""
    """Key of the set kit; empty only in scenes of schema 5 and older that are not staged."""
    set_options: tuple[Identifier, ...] = ()
    """Options of the kit that are turned on, e.g. ``palms``."""
    snow: bool = False
    """Whether snow lies on the ground."""
    crowd: Crowd | None = None
    """How full of background people the place is; None if there are only those of the story."""
    time_of_day: TimeOfDay = "day"
    weather: Weather = "clear"
    light: tuple[LightQuality, ...] = ()
    """Qualities of the light."""
    relations: tuple[Relation, ...] = ()
    scenery: tuple[Identifier, ...] = ()
    """Objects that are the place itself or a part of its set: no prop is added for them."""
    found: dict[Identifier, Condition] = {}
    """States in which things and doors are as the scene opens, left so by earlier scenes: ``broken``, ``open``."""
    _former = dropping(
        "place_kind", "layout_description", "ground_description", "wall_description", "lighting_description"
    )


class SceneSize(Frozen):
    """Extent of the playing area in metres; walls stand on these lines indoors."""

    x: Coordinate
    x_negative: Coordinate
    y: Coordinate
    y_negative: Coordinate


class LayoutObject(Frozen):
    """Where one thing stands (the paper's LayoutObject). ``node_id`` names the instance, ``asset_id`` its asset."""

    node_id: Identifier
    asset_id: Identifier
    location: Vec3
    """Bottom centre of the object."""
    rotation: Vec3 = (0.0, 0.0, 0.0)
    """Euler XYZ, degrees; yaw 0 faces -Y, counter-clockwise."""
    anchor_asset_id: Identifier | None = None
    """node_id of the anchor."""
    relationship: Relationship | None = None
    contact: bool | None = None
    direction: Facing | None = None
    fixed: bool = False
    """Placed by the set kit or by the user: solvers move others around it."""


class Layout(Frozen):
    """All static objects of the scene, and the marks of the people at its start."""

    scene_size: SceneSize
    objects: tuple[LayoutObject, ...] = ()


class Environment(Frozen):
    """The set: a kit of ``catalog.sets`` and its parameters; the kit's plan is a pure function of these."""

    kit: Identifier
    params: dict[str, ParamValue] = {}
    seed: int = 0
    walls: Identifier | None = Field(default=None, exclude_if=is_none)
    """Finish or material that a person gave the walls; None leaves those of the kit."""
    ground: Identifier | None = Field(default=None, exclude_if=is_none)
    """The same of the floor or the ground."""
    wall_texture: Texture | None = Field(default=None, exclude_if=is_none)
    """Pictures that the walls are made of, in place of their finish."""
    ground_texture: Texture | None = Field(default=None, exclude_if=is_none)
    """The same of the floor or the ground."""
    furniture: dict[Identifier, AssetDecision | None] = Field(default={}, exclude_if=lambda value: not value)
    """Prop that a person put in place of a piece of the kit's furniture, by node id; None where they took it away."""

    @property
    def decided(self) -> bool:
        """Whether its surfaces or its furniture are other than the kit has them."""
        return bool(self.walls or self.ground or self.furniture or self.textures)

    @property
    def textures(self) -> tuple[Texture, ...]:
        """The pictures of its surfaces."""
        return tuple(each for each in (self.wall_texture, self.ground_texture) if each is not None)


class Light(Frozen):
    """One lamp. Power in watts as Blender means it (sun: W/m2)."""

    name: Identifier
    kind: Literal["POINT", "SPOT", "AREA", "SUN"]
    role: Literal["set", "practical", "sun", "key", "fill", "rim"] = "set"
    location: Vec3 = (0.0, 0.0, 3.0)
    target: Vec3 = (0.0, 0.0, 0.0)
    """Where it points; for SUN only the direction location -> target counts."""
    power: float = Field(ge=0, le=1e9)
    color: Color = (1.0, 1.0, 1.0)
    size: float = Field(default=0.3, ge=0, le=1e4)
    """Metres: radius of POINT and SPOT, diameter of AREA; degrees of angular diameter for SUN."""
    cone: float = Field(default=60.0, ge=0, le=180)
    """SPOT: full cone in degrees."""
    blend: float = Field(default=0.5, ge=0, le=1)
    glow: float = Field(default=0.0, ge=0, le=1e4)
    """Strength of its halo in the air, 0 to 1."""
    for_asset: Identifier | None = None
    """key and rim: the person it lights."""


class Sky(Frozen):
    """A gradient dome over sin(elevation), scene-linear."""

    zenith: Color
    horizon: Color
    ground: Color


class Fog(Frozen):
    """Exponential fog with height falloff, composited after rendering."""

    color: Color
    density: float = Field(ge=0, le=1e4)
    start: Coordinate = 0.0
    height: float = Field(default=50.0, gt=0, le=1e6)
    sun_direction: Vec3 | None = None
    sun_color: Color = (0.0, 0.0, 0.0)


class Lighting(Frozen):
    """The light plan of a scene: every set light, the air, and the two luminance budgets (notes: sets and light)."""

    lights: tuple[Light, ...] = ()
    sky: Sky
    panorama: PanoramaLight | None = Field(default=None, exclude_if=is_none)
    """The user's panorama that lights the scene where the sky would; the drawn looks still show the sky."""
    ambient: Color = (0.02, 0.02, 0.02)
    fog: Fog | None = None
    rain: float = Field(default=0.0, ge=0, le=1)
    """0 none, 1 downpour."""
    face_luminance: float = Field(default=0.2, ge=0, le=1e4)
    set_luminance: float = Field(default=0.05, ge=0, le=1e4)
    key_color: Color = (1.0, 0.86, 0.68)
    fill_color: Color = (0.62, 0.75, 1.0)
    rim_color: Color = (0.75, 0.85, 1.0)
    key_fill_ratio: float = Field(default=4.0, gt=0, le=1e4)
    key_side: Literal["left", "right"] | None = Field(default=None, exclude_if=is_none)
    """Side of the set, as the viewer sees it, from which faces get their key light; None lets each camera decide."""


class SceneContext(Frozen):
    """Everything static about one scene. Fields that an agent has not reached yet are None."""

    scene_id: SceneId
    setup: SceneSetup
    environment: Environment | None = None
    layout: Layout | None = None
    lighting: Lighting | None = None
    locked: tuple[SceneLock, ...] = Field(default=(), exclude_if=lambda value: not value)
    """What a person locked: it stays as it is until it is unlocked."""
    offered_panorama: Panorama | None = Field(default=None, exclude_if=is_none)
    """That the crew found for its hour, weather and place; the Lighting Arranger may light it by that."""
    light_decision: LightDecision | None = Field(default=None, exclude_if=is_none)
    """What a person decided about the light; it stays with the words of the scene when the script changes."""
    set_decision: SetDecision | None = Field(default=None, exclude_if=is_none)
    """The same of the set, in every scene of the place."""
    layout_decision: LayoutDecision | None = Field(default=None, exclude_if=is_none)
    """The same of the staging."""
    layout_takes: LayoutTakes | None = Field(default=None, exclude_if=is_none)
    """Other layouts that a person kept; they stay with the words of the scene when the script changes."""
    stale: tuple[StaleWork, ...] = Field(default=(), exclude_if=lambda value: not value)
    """What an edit made stale and the crew has not made anew yet; a set takes layout and light with it."""

    omitted: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether a person left the scene out of the film."""
    shot_order: tuple[ShotId, ...] = Field(default=(), exclude_if=lambda value: not value)
    """The order that a person gave its shots in the film; empty for that of the script."""

    @property
    def decided_setup(self) -> SceneSetup:
        """The setup with what a person decided about hour, weather, light and set on top of the script's words."""
        light, place = self.light_decision, self.set_decision
        told: dict[str, Any] = {}
        if light is not None:
            told |= {"time_of_day": light.time_of_day, "weather": light.weather, "light": light.qualities}
        if place is not None:
            told |= {"kit": place.kit, "snow": place.snow}
            told["set_options"] = () if place.kit not in (None, self.setup.kit) else None
        told = {name: value for name, value in told.items() if value is not None}
        return self.setup.model_copy(update=told) if told else self.setup

    @model_validator(mode="before")
    @classmethod
    def _from_schema_5(cls, value: Any) -> object:
        """Older projects chose the kit with the set; a scene that is not staged has none, and is read again."""
        match value:
            case {"setup": {"place_kind": _, **setup}, "environment": {"kit": kit}, "lighting": {}}:
                return {**value, "setup": {**setup, "kit": kit}}
            case {"setup": {"place_kind": _, **setup}}:
                return {**value, "setup": {**setup, "kit": ""}}
            case _:
                return value
