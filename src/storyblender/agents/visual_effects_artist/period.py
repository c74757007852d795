"""When a set is furnished: the period that words, years and the age of a story tell, and what places were before it."""

from __future__ import annotations

import re

from storyblender.catalog.sets import SetKit
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.years import years_in

BEFORE: dict[Period, dict[str, str]] = {
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
"""What a place is before its time: knights meet on a field, and a flat of the forties has no kitchen along a wall."""
PERIOD_OF_AGE: dict[str, Period] = {
    "medieval": "past", "west": "past", "victorian": "past", "classic": "classic", "space": "modern",
}  # fmt: skip
"""Period of the ages that a story's own words tell for sure."""
_PERIOD_WORDS: dict[Period, str] = {
    "past": "medieval knight king queen prince princess castle viking victorian sword samurai pirate sheriff saloon "
    "cowboy western frontier gunslinger outlaw stagecoach ancient roman wizard peasant monk inn marshal gunfight",
    "modern": "laptop smartphone cellphone iphone computer monitor internet drone wifi tablet robot spaceship future "
    "email selfie hoodie sneakers cctv app video trawler winch",
    "classic": "fedora typewriter radio gramophone telephone noir wartime trolley jukebox",
}
_TODAY = re.compile(
    r"\b(?:laptops?|smart ?phones?|cell ?phones?|i(?:phone|pad|mac)s?|wi-?fi|e-?mails?|selfies?|emojis?|hash ?tags?"
    r"|apps?|text(?:s|ed|ing)? (?:message|him|her|them|me|back)|touch ?screens?|hoodies?|usb|drones?|google|youtube"
    r"|instagram|tiktok|netflix|uber|face ?time|zoom call|suvs?|microwaves?|dvds?|webcams?|gps|sat ?nav"
    r"|podcasts?|bluetooth|earbuds|vap(?:e|ing)|barcodes?|cctv|atm|voice ?mail)\b",
    re.IGNORECASE,
)
"""What only today has."""
_SURE_OF_TODAY = 2


def is_today(story: str) -> bool:
    """Return whether the words of a story name several things that only today has."""
    return len({word.lower() for word in _TODAY.findall(story)}) >= _SURE_OF_TODAY


_PERIOD_YEARS: dict[Period, tuple[int, int]] = {"past": (1000, 1899), "classic": (1900, 1979), "modern": (1980, 2099)}
"""First and last year of a period."""


def period_of(words: str, kit: SetKit, otherwise: Period | None = None) -> Period:
    """Return the period that the words speak of most, or else the given one, or the kit's own."""
    tokens = [token.rstrip("s") for token in re.findall(r"[a-z]+", words.lower())]
    years = years_in(words)
    best, most = otherwise or kit.period, 0
    for period, listed in _PERIOD_WORDS.items():
        known = {word.rstrip("s") for word in listed.split()}
        first, last = _PERIOD_YEARS[period]
        count = sum(token in known for token in tokens) + 3 * sum(first <= year <= last for year in years)
        if count > most:
            best, most = period, count
    return best
