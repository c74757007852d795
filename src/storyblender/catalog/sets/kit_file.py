"""Schema of kit files: one TOML file in ``kits/`` per kind of place. See ``docs/add-a-set.md``."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, model_validator

from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets.belongings import ROOMS
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.catalog.sets.hooks import HOOKS
from storyblender.catalog.sets.room import Side, View
from storyblender.catalog.sets.terms import Term
from storyblender.memory.base import Frozen, Identifier

Backdrop = Literal["skyline", "treeline", "hills", "sea", "facades", "stars", "deep"]
Limits = tuple[float, float, float]
"""Minimum, default and maximum in metres."""


def _known_prop(key: str) -> str:
    """Return the key unchanged. Raises ValueError if there is no such prop."""
    if key not in PROPS:
        raise ValueError(f"there is no prop called {key!r}")
    return key


def _known_finish(key: str) -> str:
    """Return the key unchanged. Raises ValueError if there is no such finish."""
    if key not in FINISHES and key not in MATERIALS:
        raise ValueError(f"there is no finish or material called {key!r}")
    return key


def _known_hook(key: str) -> str:
    """Return the key unchanged. Raises ValueError if there is no such hook."""
    if key not in HOOKS:
        raise ValueError(f"there is no hook called {key!r}; there are {', '.join(HOOKS)}")
    return key


def _known_room(key: str) -> str:
    """Return the key unchanged. Raises ValueError if there is no such sort of room."""
    if key and key not in ROOMS:
        raise ValueError(f"there is no sort of room called {key!r}; there are {', '.join(ROOMS)}")
    return key


Prop = Annotated[str, AfterValidator(_known_prop)]
Skin = Annotated[str, AfterValidator(_known_finish)]


class KitHead(Frozen):
    """Top-level keys above the first table: what the catalog needs to find the kit without drawing it."""

    name: str
    description: str
    tags: tuple[str, ...]
    indoor: bool
    width: Limits
    depth: Limits
    height: Limits = (2.4, 2.8, 4.0)
    period: Period = "classic"
    options: dict[Identifier, tuple[str, ...]] = {}
    """Switches of the kit, each with the words of a heading or a description that turn it on."""
    means: dict[str, Prop] = {}
    has: tuple[str, ...] = ()
    seated: bool = False
    on_foot: tuple[str, ...] = ()
    counterpart: str = ""
    told_by: dict[str, int] = {}
    room: Annotated[str, AfterValidator(_known_room)] = ""
    """Sort of room, whose belongings fill bare walls and tops."""


class Row(Frozen):
    """Evenly spaced places: ``count`` of them, or spaced at most ``every`` metres."""

    start: Term = Field(alias="from")
    end: Term = Field(alias="to")
    count: int | None = None
    every: float | None = None

    @model_validator(mode="after")
    def _one_of(self) -> Row:
        if (self.count is None) == (self.every is None):
            raise ValueError("a row needs either count or every")
        return self


Place = Term | Row


class Conditional(Frozen):
    """A table that may be limited to some periods or options."""

    when: tuple[str, ...] = ()
    """Periods and options of which at least one must apply; empty means always."""
    unless: tuple[str, ...] = ()
    """Periods and options of which none may apply."""


class _Shell(Frozen):
    """Surfaces of a room; ``past``, ``classic`` and ``modern`` override single entries in their period."""

    wall: Skin | None = None
    floor: Skin | None = None
    ceiling: Skin | None = None
    dado: Skin | None = None
    dado_height: float | None = None
    beams: int | None = None
    outside: Skin | None = None


class ShellTable(_Shell):
    """``[shell]``: walls, floor and ceiling of an indoor set."""

    view: View = "facades"
    thickness: float = 0.15
    pit: float = 0.0
    past: _Shell = _Shell()
    classic: _Shell = _Shell()
    modern: _Shell = _Shell()


class GroundTable(Frozen):
    """``[ground]``: ground of an outdoor set."""

    material: Skin
    wet: bool = False
    relief: float = 0.0
    rise: float = 0.0
    flat: Term | None = None
    extent: tuple[Term, Term, Term, Term] | None = None
    """x and y of two opposite corners of the level ground, which ends at a quay or a cliff."""
    entrances: tuple[Literal["left", "right", "back"], ...] = ("left", "right", "back")


class DoorTable(Conditional):
    """``door``: a door in a wall."""

    side: Side
    at: Term = 0.0
    width: float = 0.95
    height: float = 2.1
    style: str = "panel"
    state: Literal["open", "closed"] = "closed"
    name: Identifier = "door"
    tags: tuple[str, ...] = ("enter", "exit", "door")


class WindowTable(Conditional):
    """``window``: a window in a wall."""

    side: Side
    at: Place = 0.0
    width: float = 1.3
    height: float = 1.45
    sill: float = 0.9
    style: str = "sash"
    mark: bool = False


class PutTable(Conditional):
    """``put``: a prop or set piece, single or in rows; free-standing, against a side, or on or by another."""

    prop: Prop | tuple[Prop, ...] = ()
    piece: Identifier | tuple[Identifier, ...] = ()
    id: Identifier | None = None
    x: Place = 0.0
    y: Place = 0.0
    z: Term | None = None
    yaw: Term = 0.0
    side: Side | None = None
    at: Place = 0.0
    off: Term | None = None
    on: Identifier | None = None
    by: Identifier | None = None
    hang: float | None = None
    vary: float = 0.0
    turn: float = 0.0
    skip: tuple[int, ...] = ()
    required: bool = False
    scale: float = 1.0
    wild: bool = False
    """Whether the piece is wild: it may be removed for a shot that it blocks."""
    footprint: tuple[Term, ...] = Field(default=(), max_length=3)
    """Width and depth in metres of a piece that people walk around, and its height if it is not a wall."""
    give: dict[str, ParamValue | tuple[ParamValue, ...]] = Field(default={}, alias="with")

    @model_validator(mode="after")
    def _one_thing(self) -> PutTable:
        if bool(self.prop) == bool(self.piece):
            raise ValueError("this needs either prop or piece")
        if self.hang is not None and not self.prop:
            raise ValueError("only a prop can hang")
        if sum(word is not None for word in (self.side, self.on, self.by, self.hang)) > 1:
            raise ValueError("side, on, by and hang exclude each other")
        return self


class SlabTable(Conditional):
    """``slab``: a rectangle of another ground: a road, a tiled area, a stage."""

    role: Literal["floor", "ground", "ceiling", "patch", "block"] = "patch"
    box: tuple[Term, Term, Term, Term]
    material: Skin
    z: Term = 0.008
    thickness: float = 0.0
    wet: bool = False


class ScatterTable(Conditional):
    """``scatter``: randomly scattered pieces such as plants."""

    pieces: tuple[Identifier, ...]
    count: int
    inner: Term
    outer: Term
    gap: float
    variants: int = 3
    scale: tuple[float, float] = (0.8, 1.2)
    sector: tuple[float, float] = (0.0, 360.0)
    lanes: tuple[tuple[Term, Term, Term, Term, Term], ...] = ()
    sunk: float = 0.05
    solid: float = 0.0
    x: Term = 0.0
    y: Term = 0.0


class BackdropTable(Conditional):
    """``backdrop``: scenery on the horizon, all around or between two azimuths; 0 is +Y, counter-clockwise."""

    kind: Backdrop
    radius: float = 70.0
    top: float
    bottom: float = -2.0
    between: tuple[float, float] = (0.0, 360.0)
    sides: int = 12


class LampTable(Conditional):
    """``lamp``: a light source without a prop."""

    name: Identifier = "lamp"
    x: Place = 0.0
    y: Place = 0.0
    z: Term
    watts: float
    color: str = "warm"
    kind: Literal["POINT", "SPOT", "AREA"] = "POINT"
    target: tuple[Term, Term, Term] | None = None
    size: float = 0.1
    cone: float = 120.0
    glow: float = 0.0
    role: Literal["set", "practical"] = "practical"


class MarkTable(Conditional):
    """``mark``: a named place where a character enters, stands or waits."""

    name: Identifier
    x: Term = 0.0
    y: Term = 0.0
    yaw: Term = 0.0
    tags: tuple[str, ...] = ()


class HookTable(Conditional):
    """``hook``: a function of ``hooks.py`` that draws what no table can express."""

    name: Annotated[str, AfterValidator(_known_hook)]
    give: dict[str, ParamValue] = Field(default={}, alias="with")


class PlanTable(Frozen):
    """``[plan]``: lists of the contents of the set, one line each."""

    centre: tuple[Term, Term] | None = None
    """Middle of the floor that stays free for people; by default the middle of the room."""
    door: tuple[DoorTable, ...] = ()
    window: tuple[WindowTable, ...] = ()
    slab: tuple[SlabTable, ...] = ()
    put: tuple[PutTable, ...] = ()
    scatter: tuple[ScatterTable, ...] = ()
    backdrop: tuple[BackdropTable, ...] = ()
    lamp: tuple[LampTable, ...] = ()
    mark: tuple[MarkTable, ...] = ()
    hook: tuple[HookTable, ...] = ()

    @model_validator(mode="after")
    def _known_neighbours(self) -> PlanTable:
        known: set[str] = set()
        for number, item in enumerate(self.put, 1):
            for name in (item.on, item.by):
                if name is not None and name not in known:
                    raise ValueError(f"put {number} is on or by {name!r}, which nothing before it has as its id")
            known |= {item.id} if item.id else set()
        return self


class KitBody(Frozen):
    """All tables of a kit file."""

    shell: ShellTable | None = None
    ground: GroundTable | None = None
    plan: PlanTable = PlanTable()

    @model_validator(mode="after")
    def _shell_or_ground(self) -> KitBody:
        if (self.shell is None) == (self.ground is None):
            raise ValueError("a kit needs [shell] where it is indoors, else [ground]")
        if self.shell is not None and (self.shell.wall is None or self.shell.floor is None):
            raise ValueError("[shell] needs wall and floor")
        return self
