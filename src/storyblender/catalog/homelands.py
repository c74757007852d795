"""Homelands: typical skin and hair of people where a story is set, used where the script does not describe them.

Only the names of countries, cities and their districts count, as headings give them; what a script says of a person
always goes before. To know another place, add its name to a line of ``_PLACES``.
"""

from __future__ import annotations

import re
from typing import Final, Literal, NamedTuple

Skin = Literal["pale", "light", "tan", "brown", "dark"]
Styles = tuple[str, ...]


class Homeland(NamedTuple):
    """What is usual among the people of a place.

    Attributes:
        skin: Complexion.
        women: Hair styles of women.
        men: Hair styles of men.
    """

    skin: Skin
    women: Styles
    men: Styles


_AFRICAN = Homeland("dark", ("braid", "afro", "crop", "bun"), ("crop", "crop", "shaved"))
_SOUTH_ASIAN = Homeland("brown", ("braid", "long", "bun"), ("short", "slick", "short"))
_EAST_ASIAN = Homeland("light", ("bun", "bob", "long"), ("short", "crop", "messy"))
_OLIVE = Homeland("tan", ("long", "wavy", "bun", "ponytail"), ("short", "curly", "crop"))

_PLACES: Final[dict[str, Homeland]] = {
    "lagos nigeria abuja ibadan kano accra ghana kumasi nairobi kenya mombasa kampala uganda kigali rwanda dakar "
    "senegal bamako mali timbuktu abidjan addis_ababa ethiopia dar_es_salaam tanzania zanzibar lusaka zambia harare "
    "zimbabwe soweto kinshasa congo luanda angola maputo mozambique namibia cameroon liberia "
    "port-au-prince haiti kingston jamaica sudan khartoum mogadishu somalia": _AFRICAN,
    "mumbai bombay delhi india kolkata calcutta chennai madras bangalore hyderabad varanasi jaipur kerala punjab goa "
    "dhaka bangladesh karachi lahore islamabad pakistan colombo sri_lanka nepal": _SOUTH_ASIAN,
    "tokyo kyoto osaka hiroshima nagasaki hokkaido okinawa japan edo seoul busan korea beijing peking shanghai "
    "guangzhou canton nanjing china hong_kong taipei taiwan mongolia ulaanbaatar": _EAST_ASIAN,
    "cairo alexandria egypt marrakech fez morocco tunis tunisia algiers algeria beirut lebanon damascus syria baghdad "
    "iraq tehran iran isfahan amman jordan riyadh yemen mexico_city mexico oaxaca guadalajara tijuana veracruz bogota "
    "medellin lima cusco peru quito ecuador la_paz bolivia guatemala honduras havana cuba manila philippines cebu "
    "bangkok thailand chiang_mai hanoi saigon vietnam cambodia jakarta indonesia bali kuala_lumpur malaysia "
    "hawaii samoa tahiti": _OLIVE,
}  # fmt: skip
_NAMED: Final = {name.replace("_", " "): homeland for names, homeland in _PLACES.items() for name in names.split()}


_PLACE_NAME: Final = re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, sorted(_NAMED, key=len, reverse=True)))})(?!\w)")


def homeland_of(words: str) -> Homeland | None:
    """Return what is usual in the last place of the world that the words name, or None where they name none."""
    names = _PLACE_NAME.findall(words.lower())
    return _NAMED[names[-1]] if names else None
