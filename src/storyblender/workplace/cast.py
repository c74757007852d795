"""People and things of a story as the page, programs and the command line are told of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from storyblender.catalog.bodies import SKIN_TONES, complexion, resolved_gender, typical_stature
from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.material_entry import hex_code
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.wardrobe import look_words, person_seed, worn_by
from storyblender.edits.targets import person_or_thing
from storyblender.memory.asset_sheet import Asset, CharacterLook, Credit
from storyblender.memory.base import Described, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.paint import Paint, PaintTarget

AssetSort = Literal["person", "thing", "furniture"]


class AssetCard(Described):
    """A person or a thing in the list of all."""

    asset: str
    """Its id; edits name it."""
    name: str
    """As the script calls it."""
    sort: AssetSort
    """Furniture is what the crew furnished a set with."""
    told: str
    """In a line: what it looks like, or what it is made from."""
    decided: bool
    """Whether a person decided anything about it."""
    locked: bool
    """Whether it is kept as it is."""
    stand_in: bool
    """Whether it is only a substitute."""


class WornGarment(Described):
    """A piece of clothing that a character wears."""

    key: str
    """As edits name it."""
    name: str
    """As people call it."""
    color: str
    """Hex code."""


class LookNow(Described):
    """How a person looks."""

    gender: str
    """``female`` or ``male``."""
    age: float
    """Years."""
    stature: float
    """Metres."""
    build: str
    """Of the body."""
    skin: str
    """Tone of the skin."""
    hair: str
    """Key of the hair style."""
    hair_color: str
    """Hex code."""
    facial_hair: str
    """``none``, ``stubble``, ``moustache`` or ``beard``."""
    glasses: bool
    """Whether they wear any."""
    face: int
    """Which of the faces that fit the rest."""
    species: str
    """Of an animal that acts; empty for people."""
    garments: tuple[WornGarment, ...]
    """From the inside out."""


class ShownIn(Described):
    """A scene that shows a person or a thing."""

    scene: str
    """Its name."""
    title: str
    """Its heading."""
    shots: tuple[str, ...]
    """Names of the shots: of people those in which they are in the picture, of things all of the scene."""


class AssetDetails(AssetCard):
    """Everything about a person or a thing that is known or can be changed."""

    description: str
    """As the script says it."""
    shown_in: tuple[ShownIn, ...]
    """In story order."""
    source: str
    """Where it comes from, in words."""
    made_from: str
    """Key of the library, or the file in the user's folder of models."""
    dimensions: tuple[float, float, float]
    """Width, depth and height in metres; zeros while it is not built."""
    match: float | None
    """How well it fits what the script says, 1 to 10."""
    credit: Credit | None
    """Whose work it is, if it is not the library's."""
    image_prompt: str
    """For services that make a picture and a model of it."""
    decisions: tuple[str, ...]
    """What a person decided, in words."""
    color: str
    """Of a thing: of what covers most of it, hex; empty where that is not known."""
    painted: bool
    """Whether a person painted it."""
    look: LookNow | None
    """Of people."""


def cards_of(graph: ContinuityMemoryGraph) -> tuple[AssetCard, ...]:
    """Return all people and things of a story: people first, then things, then what furnishes its sets."""
    order = {"person": 0, "thing": 1, "furniture": 2}
    cards = [_card(asset) for asset in graph.assets if not asset.fitted_part]
    return tuple(sorted(cards, key=lambda card: order[card.sort]))


def asset_details(graph: ContinuityMemoryGraph, name: str) -> AssetDetails:
    """Return everything about a person or a thing.

    Args:
        graph: The story.
        name: Its id or its name.

    Raises:
        InputError: There is none.
    """
    asset = graph.asset(person_or_thing(graph, name))
    made = asset.canonical
    return AssetDetails(
        **_card(asset).model_dump(),
        description=asset.description,
        shown_in=tuple(_shown_in(graph, asset)),
        source=_source(asset),
        made_from=made.key if made is not None and made.source != "person" else "",
        dimensions=made.dimensions if made is not None and made.geometry_hash else (0.0, 0.0, 0.0),
        match=made.match_score if made is not None else None,
        credit=made.provenance if made is not None else None,
        image_prompt=asset.image_prompt,
        decisions=(*_decisions(asset), *(f"painted {paint.look.words}" for paint in _paints_on(graph, asset))),
        color=_color(graph, asset),
        painted=bool(_paints_on(graph, asset)),
        look=_look_now(asset) if asset.asset_type == "character" else None,
    )


def _card(asset: Asset) -> AssetCard:
    person = asset.asset_type == "character"
    return AssetCard(
        asset=asset.asset_id,
        name=asset.name or asset.asset_id.replace("_", " "),
        sort="person" if person else "furniture" if asset.origin == "dressing" else "thing",
        told=_told(asset),
        decided=bool(_decisions(asset)),
        locked=asset.locked,
        stand_in=asset.canonical is not None and asset.canonical.is_stand_in,
    )


def _told(asset: Asset) -> str:
    if asset.asset_type != "character" or (asset.canonical is not None and asset.canonical.source == "file"):
        return _source(asset)
    look = asset.decided_look or CharacterLook()
    worn = [each.key.replace("_", " ") for each in worn_by(asset)]
    who = look.species.replace("_", " ") or resolved_gender(look, person_seed(asset))
    return f"{who}, {look.age:g}; {', '.join(worn)}"


def _source(asset: Asset) -> str:
    """Return where an asset comes from, as people say it."""
    made = asset.canonical
    if made is None:
        return "not made yet"
    match made.source:
        case "person":
            return "built by the people builder"
        case "file":
            return f"your model {made.key}"
        case "stand_in":
            return "a plain stand-in"
        case "catalog":
            name = PROPS[made.key].name if made.key in PROPS else made.key
            return f"the library's {name}{', standing in' if made.is_stand_in else ''}"


def _decisions(asset: Asset) -> tuple[str, ...]:
    said = [look_words(asset.look_decision)] if asset.look_decision is not None else []
    if asset.decision is not None:
        said.append(f"made from {asset.decision.words}")
    return tuple(said)


def _paints_on(graph: ContinuityMemoryGraph, asset: Asset) -> list[Paint]:
    """Return what a person painted on one asset wherever it is."""
    return [each for each in graph.paints if each.target == PaintTarget(asset_id=asset.asset_id)]


def _color(graph: ContinuityMemoryGraph, asset: Asset) -> str:
    """Return the colour of what covers most of a thing, hex; empty where that is not known."""
    for paint in _paints_on(graph, asset):
        finish = MATERIALS[paint.look.finish].color if paint.look.finish else None
        if (color := paint.look.color or finish) is not None:
            return hex_code(color)
    made = asset.canonical
    if made is None or made.source != "catalog" or made.key not in PROPS or not PROPS[made.key].materials:
        return ""
    told = made.params.get("material", next(iter(PROPS[made.key].materials.values())))
    return str(made.params.get("color") or hex_code(MATERIALS[str(told)].color if told in MATERIALS else (0, 0, 0)))


def _look_now(asset: Asset) -> LookNow:
    look, seed = asset.decided_look or CharacterLook(), person_seed(asset)
    gender = resolved_gender(look, seed)
    made, told = asset.canonical, asset.dimension
    height = made.dimensions[2] if made is not None and made.geometry_hash else told.height if told else None
    return LookNow(
        gender=gender,
        age=look.age,
        stature=round(height or look.stature or typical_stature(gender, look.age), 3),
        build=look.build,
        skin=look.skin,
        hair=look.hair,
        hair_color=hex_code(complexion(look, seed).hair),
        facial_hair=look.facial_hair,
        glasses=look.glasses,
        face=look.face,
        species=look.species,
        garments=tuple(
            WornGarment(key=each.key, name=GARMENTS[each.key].name, color=hex_code(each.color or (0, 0, 0)))
            for each in worn_by(asset)
        ),
    )


def _shown_in(graph: ContinuityMemoryGraph, asset: Asset) -> Iterable[ShownIn]:
    """Yield the scenes that show an asset."""
    person = asset.asset_type == "character"
    for scene in graph.scenes:
        shots = graph.shots_in_order(scene.scene_id)
        if person:
            shots = tuple(shot for shot in shots if asset.asset_id in (shot.in_frame or shot.on_stage))
        elif asset.asset_id not in {each.asset_id for each in graph.assets_of(scene.scene_id)}:
            continue
        if shots:
            outline = graph.outline_of(scene.scene_id)
            names = tuple(shot_name(shot.scene_id, shot.shot_id) for shot in shots)
            title = outline.numbered_title if outline is not None else ""
            yield ShownIn(scene=scene_name(scene.scene_id), title=title, shots=names)


class GarmentChoice(Described):
    """A garment that a character may put on."""

    key: str
    """As edits name it."""
    name: str
    """As people call it."""
    on: str
    """Where it is worn: ``upper``, ``lower``, ``feet``, ``head``; empty for the rest."""
    colors: tuple[str, ...]
    """Its usual colours, hex."""


class LookChoices(Described):
    """What a look can be."""

    skins: dict[str, str]
    """Tone and its colour, hex."""
    hair: dict[str, str]
    """Key and name of every hair style."""
    garments: tuple[GarmentChoice, ...]
    """All of the catalogue, from the inside out."""
    finishes: dict[str, str]
    """Materials that things can be painted with: key and colour, hex."""


def look_choices() -> LookChoices:
    """Return what the people builder can make."""
    return LookChoices(
        skins={tone: hex_code(color) for tone, color in SKIN_TONES.items()},
        hair={key: style.name for key, style in HAIRSTYLES.items()},
        finishes={key: hex_code(each.color) for key, each in MATERIALS.items()},
        garments=tuple(
            GarmentChoice(key=spec.key, name=spec.name, on=next(iter(spec.covers), ""), colors=spec.colors)
            for spec in sorted(GARMENTS.values(), key=lambda spec: spec.layer)
        ),
    )
