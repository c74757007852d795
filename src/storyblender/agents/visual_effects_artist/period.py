"""The period in which a set is furnished, from the age of the story, and the older kits of places."""

from __future__ import annotations

from storyblender.catalog.sets.drawing import Period
from storyblender.memory.vocabulary import Age

OLDER_KITS: dict[Period, dict[str, str]] = {
    "past": {
        "trench": "open_ground", "apartment": "living_room", "motel_room": "bedroom", "hospital_room": "bedroom",
        "open_office": "office", "meeting_room": "dining_room", "coffee_shop": "cafe", "diner": "bar",
        "supermarket": "shop", "restaurant_kitchen": "kitchen", "nightclub": "ballroom", "garage": "stable",
        "parking_garage": "stable", "server_room": "archive", "caravan": "cottage", "gas_station": "stable",
        "parking_lot": "square", "highway": "country_road", "bus_stop": "country_road", "suburb": "village",
        "construction_site": "village", "playground": "park", "coach": "horse_carriage", "car": "horse_carriage",
        "housing_estate": "street", "phone_box": "closet",
    },
    "classic": {
        "apartment": "living_room", "open_office": "office", "coffee_shop": "cafe", "supermarket": "shop",
        "server_room": "archive",
    },
}  # fmt: skip
"""Kit of a place before its time, by period: knights meet on open ground, a flat of the forties is a living room."""
PERIOD_OF_AGE: dict[Age, Period] = {
    "medieval": "past", "west": "past", "victorian": "past", "classic": "classic", "space": "modern", "today": "modern",
}  # fmt: skip
"""Period of each age; a story without one has each place furnished as usual."""
