"""What a place looks like: qualities of its light by the hour; ground and walls by its kind (notes, 4.4 and 4.5)."""

from __future__ import annotations

from typing import Final

from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import LightQuality, TimeOfDay

_LIGHT: Final[dict[TimeOfDay, tuple[tuple[LightQuality, ...], tuple[LightQuality, ...]]]] = {
    "dawn": (("cold",), ("cold",)), "morning": ((), ("soft",)), "day": (("soft",), ("bright",)),
    "noon": (("bright",), ()), "afternoon": (("warm",), ("warm",)), "sunset": (("warm",), ("warm",)),
    "dusk": ((), ()), "evening": (("warm",), ("warm",)), "night": (("warm",), ("cold", "warm")),
}  # fmt: skip
"""Indoors and outdoors."""
_GROUND: Final = {
    "kitchen": "worn tiles", "bathroom": "small tiles", "diner": "chequered linoleum", "cafe": "patterned tiles",
    "bar": "dark boards", "office": "parquet", "ward": "pale linoleum", "warehouse": "stained concrete",
    "throne_room": "stone flags with a runner", "castle": "stone flags", "cottage": "rough boards", "house": "boards",
    "living_room": "boards with a rug", "bedroom": "boards with a rug", "dining_room": "parquet",
    "lab": "grey linoleum", "restaurant_kitchen": "terracotta tiles", "attic": "rough boards",
    "tent": "trodden grass", "cave": "gravel and rock", "stairwell": "chequered tiles",
    "security_room": "grey carpet tiles", "control_room": "steel plates", "spaceship": "panelled deck",
    "corridor": "polished linoleum", "lobby": "marble", "museum": "marble", "theater": "stage boards",
    "library": "parquet", "shop": "worn boards", "bank": "marble", "market": "cobbles", "alley": "wet asphalt",
    "forest": "moss and leaves", "bridge": "planks", "street": "asphalt and kerbs", "park": "lawn and gravel",
    "porch": "boards", "dock": "wet planks", "parking_lot": "asphalt", "classroom": "linoleum", "church": "stone flags",
    "prison": "bare concrete", "court": "parquet", "beach": "sand", "desert": "sand", "mountain": "rock and scree",
    "field": "grass", "gate": "cobbles", "garden": "lawn", "cemetery": "grass", "rooftop": "tar paper",
    "car": "asphalt", "police_station": "worn linoleum", "motel_room": "worn carpet",
    "nursery": "pale boards with a rug",
    "tatami_room": "straw mats", "locker_room": "small tiles", "ship_deck": "planks of a deck",
    "space_hull": "steel plates",
    "train": "worn carpet", "plane": "concrete", "sea": "wet sand",
}  # fmt: skip
_WALLS: Final = {
    "kitchen": "painted plaster with a tiled dado", "bathroom": "white tiles", "diner": "panelled dado, large windows",
    "cafe": "ornate plaster with arches", "bar": "dark wood panelling", "office": "painted plaster",
    "ward": "pale green plaster", "warehouse": "bare brick", "throne_room": "dressed stone", "castle": "rough stone",
    "cottage": "whitewashed stone", "corridor": "painted plaster", "lobby": "panelled plaster", "museum": "plain white",
    "theater": "dark drapes", "library": "shelves to the ceiling", "shop": "shelves and plaster", "lab": "white panels",
    "prison": "bare concrete", "church": "stone", "security_room": "grey panels", "control_room": "steel panels",
    "spaceship": "curved white panels", "classroom": "painted plaster with a board", "bank": "marble panels",
    "train": "wood panels and windows", "attic": "boards under sloping rafters", "tent": "canvas", "cave": "rough rock",
    "restaurant_kitchen": "white tiles", "car": "doors and windows",
    "police_station": "painted plaster with a dado", "motel_room": "panelling", "nursery": "pale wallpaper",
    "tatami_room": "paper screens", "locker_room": "tiles and lockers", "court": "panelled dado, plaster above",
}  # fmt: skip


def usual_light(scene: SceneReading) -> tuple[LightQuality, ...]:
    """Return the qualities that the light of a scene has by its hour."""
    indoor, outdoor = _LIGHT[scene.time]
    return indoor if scene.scene_type == "indoor" else outdoor


def ground_words(scene: SceneReading) -> str:
    """Return the ground of a scene in words."""
    plain = _GROUND.get(scene.place_kind, "boards" if scene.scene_type == "indoor" else "trodden earth")
    cover = {"rain": ", wet", "storm": ", wet", "snow": " under snow"}.get(scene.weather, "")
    return plain + (cover if scene.scene_type == "outdoor" else "")


def wall_words(scene: SceneReading) -> str | None:
    """Return the walls of a scene in words; None outdoors."""
    return _WALLS.get(scene.place_kind, "painted plaster") if scene.scene_type == "indoor" else None
