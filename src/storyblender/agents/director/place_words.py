"""What a place looks like in words: light by the hour, ground and walls by the kind of place (notes, 4.4 and 4.5)."""

from __future__ import annotations

from typing import Final

from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import TimeOfDay, Weather

_LIGHT: Final[dict[TimeOfDay, tuple[str, str]]] = {
    "dawn": ("first cold daylight at the windows, lamps still lit", "cold blue dawn, the sun on the horizon"),
    "morning": ("clear morning light through the windows", "low clear morning sun, long soft shadows"),
    "day": ("daylight through the windows, soft and even", "bright daylight, the sun half high"),
    "noon": ("bright daylight from outside, little shadow", "hard noon sun from above, short shadows"),
    "afternoon": ("warm afternoon light slanting through the windows", "warm afternoon sun from the side"),
    "sunset": ("low golden light through the windows", "golden sunset, the sun almost on the horizon"),
    "dusk": ("blue dusk outside, the first lamps lit", "blue dusk with a last orange rim of sky"),
    "evening": ("warm lamps against dark windows", "warm street lamps under a dark blue sky"),
    "night": ("warm lamps, deep shadows, dark windows", "moonlight and a few warm lamps in the dark"),
}
"""Indoors and outdoors."""
_WEATHER: Final[dict[Weather, str]] = {
    "clear": "",
    "cloudy": "an overcast sky",
    "fog": "fog that swallows the distance and glows around lamps",
    "rain": "rain, wet reflecting ground",
    "storm": "a storm with flashes of lightning",
    "snow": "falling snow and a pale bounce from the ground",
}
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


def light_words(scene: SceneReading) -> str:
    """Return the light of a scene in words."""
    indoor, outdoor = _LIGHT[scene.time]
    weather = _WEATHER[scene.weather]
    if scene.scene_type == "indoor":
        return f"{indoor}; outside, {weather}" if weather else indoor
    return f"{outdoor}; {weather}" if weather else outdoor


def ground_words(scene: SceneReading) -> str:
    """Return the ground of a scene in words."""
    plain = _GROUND.get(scene.place_kind, "boards" if scene.scene_type == "indoor" else "trodden earth")
    cover = {"rain": ", wet", "storm": ", wet", "snow": " under snow"}.get(scene.weather, "")
    return plain + (cover if scene.scene_type == "outdoor" else "")


def wall_words(scene: SceneReading) -> str | None:
    """Return the walls of a scene in words; None outdoors."""
    return _WALLS.get(scene.place_kind, "painted plaster") if scene.scene_type == "indoor" else None
