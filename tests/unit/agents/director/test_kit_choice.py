"""Places of scripts and the kits they get, by their headings, contents and age."""

from __future__ import annotations

import pytest

from storyblender.agents.director import lexicon
from storyblender.agents.director.kit_choice import choose_kit, find_kit
from storyblender.agents.director.kit_evidence import kit_of_things
from storyblender.agents.director.reading import SceneReading
from storyblender.catalog.sets import SETS
from storyblender.memory.vocabulary import Age, SceneType


def kit_of(
    place: str, things: tuple[str, ...] = (), where: SceneType = "indoor", age: Age | None = None, kit: str = ""
) -> str:
    kind = lexicon.place_kind(place)
    scene = SceneReading(id=1, heading="", place=place, place_kind=kind, scene_type=where, kit=kit)
    return choose_kit(scene, things, place, age)


@pytest.mark.parametrize(
    ("words", "where", "kit"),
    [
        ("RICK'S CAFE AMERICAIN", "indoor", "cafe"),
        ("HOSPITAL CORRIDOR", "indoor", "corridor"),
        ("KITCHEN OF THE RESTAURANT", "indoor", "kitchen"),
        ("RESTAURANT KITCHEN", "indoor", "restaurant_kitchen"),
        ("CASTLE - THRONE ROOM", "indoor", "great_hall"),
        ("CASTLE HALL", "indoor", "great_hall"),
        ("SCHOOL HALL", "indoor", "corridor"),
        ("TOM'S HOUSE - LIVING ROOM", "indoor", "living_room"),
        ("TOM'S HOUSE", "indoor", "room"),
        ("PALACE HOTEL RM 412", "indoor", "hotel_room"),
        ("HOTEL ROOM 412", "indoor", "hotel_room"),
        ("POLICE STATION", "indoor", "police_station"),
        ("MOTEL ROOM", "indoor", "motel_room"),
        ("POPPY'S NURSERY", "indoor", "nursery"),
        ("TEA HOUSE, KYOTO", "indoor", "tatami_room"),
        ("CHANGING ROOM", "indoor", "locker_room"),
        ("OBSERVATION ROOM", "indoor", "control_room"),
        ("FISHING BOAT - DECK", "outdoor", "ship_deck"),
        ("SPACE STATION - HULL", "outdoor", "space_hull"),
        ("ALLEY BEHIND THE MARKET", "outdoor", "alley"),
        ("STREET OUTSIDE THE CHURCH", "outdoor", "street"),
        ("INTERROGATION ROOM", "indoor", "interrogation"),
        ("POLICE STATION - CELL", "indoor", "cell"),
        ("ASHCOMBE MANOR, LIBRARY", "indoor", "library"),
        ("AIRPORT", "indoor", "airport_gate"),
        ("AIRPORT RUNWAY", "outdoor", "airfield"),
        ("HOSPITAL - PARKING LOT", "outdoor", "parking_lot"),
        ("HIGHWAY", "outdoor", "highway"),
        ("WOODS", "outdoor", "forest"),
        ("HARBOUR", "outdoor", "dock"),
        ("MARKET SQUARE", "outdoor", "square"),
        ("PIRATE SHIP - DECK", "outdoor", "ship_deck"),
        ("SNOWY MOUNTAIN PASS", "outdoor", "mountain"),
        ("STATION WAITING ROOM", "indoor", "waiting_room"),
        ("TRAIN STATION", "indoor", "lobby"),
        ("TRAIN PLATFORM", "outdoor", "platform"),
        ("PLATFORM 4", "outdoor", "platform"),
        ("SUBWAY PLATFORM", "indoor", "subway"),
        ("SUBWAY CAR", "indoor", "carriage"),
        ("SPACESHIP BRIDGE", "indoor", "control_room"),
        ("STARSHIP - BRIDGE", "indoor", "control_room"),
        ("MISSION CONTROL", "indoor", "control_room"),
        ("DARK BASEMENT", "indoor", "basement"),
        ("SUPERMARKET", "indoor", "supermarket"),
        ("BOOKSHOP", "indoor", "library"),
        ("SCHOOL GYM", "indoor", "gym"),
        ("TAXI - MOVING", "indoor", "car"),
        ("TOM'S CAR - PARKING LOT", "indoor", "car"),
        ("TRAIN CAR", "indoor", "carriage"),
        ("COURTROOM", "indoor", "courtroom"),
        ("ATTIC", "indoor", "attic"),
        ("RESEARCH LAB", "indoor", "laboratory"),
        ("STAIRWELL", "indoor", "stairwell"),
        ("CAVE", "indoor", "cave"),
        ("GENERAL'S TENT", "indoor", "tent"),
        ("FRONT PORCH", "outdoor", "porch"),
        ("SUBMARINE", "indoor", "submarine"),
        ("NIGHT BUS", "indoor", "coach"),
        ("AIRPLANE CABIN", "indoor", "coach"),
        ("ELEVATOR", "indoor", "elevator"),
        ("ART MUSEUM", "indoor", "gallery"),
        ("GREENHOUSE", "indoor", "greenhouse"),
        ("CHURCH GRAVEYARD", "outdoor", "cemetery"),
        ("HOTEL - SWIMMING POOL", "outdoor", "pool"),
        ("FOOTBALL STADIUM", "outdoor", "stadium"),
        ("HOTEL BALCONY", "outdoor", "balcony"),
        ("TRENCH", "outdoor", "trench"),
        ("AUBRY VINEYARD", "outdoor", "vineyard"),
        ("FARMHOUSE, DINING ROOM", "indoor", "dining_room"),
        ("TOY WORKSHOP", "indoor", "workshop"),
        ("DUGGAN'S GARAGE", "indoor", "garage"),
        ("DUGGAN'S GARAGE", "outdoor", "street"),
        ("OLD BARN", "indoor", "barn"),
        ("OLD BARN", "outdoor", "farm_yard"),
        ("FREIGHTER MERIDIAN, BRIDGE", "indoor", "control_room"),
        ("FERRY LANDING", "outdoor", "dock"),
        ("JETTY BY THE LAKE", "outdoor", "dock"),
        ("CABIN BY THE LAKE", "outdoor", "lakeside"),
        ("DESERT ROAD", "outdoor", "desert"),
        ("COUNTRY ROAD", "outdoor", "country_road"),
        ("HYDROPONICS BAY", "indoor", "greenhouse"),
        ("HOTEL - CORRIDOR", "indoor", "hotel_corridor"),
        ("BOARDROOM", "indoor", "meeting_room"),
    ],
)
def test_the_heading_chooses_the_kit(words: str, where: str, kit: str) -> None:
    assert find_kit("", words, where) == kit  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("words", "kit"), [("CAFE", "street"), ("COTTAGE", "cottage_garden"), ("ZORG NEBULA", "open_ground")]
)
def test_outside_of_a_place_is_under_the_sky(words: str, kit: str) -> None:
    assert find_kit("", words, "outdoor") == kit


@pytest.mark.parametrize("words", ["FOREST", "CAVE", "BEACH", "STREET", "QWERTY"])
def test_an_indoor_scene_always_has_a_ceiling(words: str) -> None:
    assert SETS[find_kit("", words, "indoor")].indoor


def test_a_heading_that_names_a_kit_and_nothing_else_counts_more_than_the_directors_key() -> None:
    assert find_kit("cottage", "LIGHTHOUSE", "indoor") == "lighthouse"
    assert find_kit("cottage", "lighthouse", "outdoor") == "beach"


def test_the_directors_key_counts_more_than_other_words() -> None:
    assert find_kit("bar", "THE BLUE PARROT OFFICE", "indoor") == "bar"


def test_no_word_means_two_kits_alike() -> None:
    words = [tag for kit in SETS.values() for tag in kit.tags]
    assert sorted({word for word in words if words.count(word) > 1}) == []


@pytest.mark.parametrize(
    ("things", "kit"),
    [
        (("nuno", "glasses", "counter", "piano", "table"), "bar"),
        (("bed", "letter", "wardrobe"), "bedroom"),
        (("ana", "pews", "candle"), "church"),
        (("judge_okoro", "gavel"), "courtroom"),
        (("throne", "curtain", "stage", "piano_stool"), "theatre"),
        (("bed", "armchair", "bar"), "bedroom"),
        (("microscope", "flasks"), "laboratory"),
        (("letter", "table"), "room"),
    ],
)
def test_where_no_word_is_known_the_things_tell_the_place(things: tuple[str, ...], kit: str) -> None:
    assert kit_of('zorgblat "la esquina"', things) == kit


def test_a_known_heading_counts_more_than_things() -> None:
    assert kit_of("kitchen", ("bed", "pillow")) == "kitchen"


@pytest.mark.parametrize(
    ("place", "kit"),
    [
        ("graveyard on the ridge", "cemetery"),
        ("hill", "open_ground"),
        ("hill of the nine stones", "open_ground"),
        ("ridge", "mountain"),
    ],
)
def test_open_ground_that_is_named_is_no_fallback(place: str, kit: str) -> None:
    assert kit_of(place, where="outdoor") == kit


def test_things_tell_only_kits_that_may_be_chosen() -> None:
    assert kit_of_things(("bed", "pillow"), ("bar", "church")) is None


@pytest.mark.parametrize(
    ("place", "where", "kit"),
    [
        ('milonga "la esquina"', "indoor", "bar"),
        ("cucina", "indoor", "kitchen"),
        ("küche", "indoor", "kitchen"),
        ("kuche", "indoor", "kitchen"),
        ("chambre", "indoor", "bedroom"),
        ("iglesia", "indoor", "church"),
        ("calle", "outdoor", "street"),
        ("rue de rivoli", "outdoor", "street"),
        ("wald", "outdoor", "forest"),
        ("praia", "outdoor", "beach"),
        ("voiture", "indoor", "car"),
        ("estación", "indoor", "lobby"),
    ],
)
def test_places_of_other_languages_are_known(place: str, where: str, kit: str) -> None:
    assert find_kit(lexicon.place_kind(place), place, where) == kit  # type: ignore[arg-type]


def test_the_last_part_of_a_heading_is_where_we_are() -> None:
    place = "precinct, interview room"
    assert lexicon.place_kind(place) == "police_station"
    assert find_kit("police_station", place, "indoor") == "interrogation"


@pytest.mark.parametrize(
    ("place", "things", "kit"),
    [
        ("hall", ("stage", "curtain", "piano"), "theatre"),
        ("hall", ("coat", "mat"), "corridor"),
        ("natural history museum, great hall", ("desk", "bench"), "gallery"),
        ("castle, great hall", ("desk", "bench"), "great_hall"),
        ("ashdown park, great hall", (), "great_hall"),
    ],
)
def test_a_hall_is_what_stands_in_it_and_whose_it_is(place: str, things: tuple[str, ...], kit: str) -> None:
    assert kit_of(place, things) == kit


@pytest.mark.parametrize(
    ("place", "where", "kit"),
    [
        ("SUPPLY CLOSET", "indoor", "closet"),
        ("PHONE BOOTH", "indoor", "phone_box"),
        ("POOL KIOSK", "indoor", "kiosk"),
        ("BATHROOM STALL", "indoor", "toilet_stall"),
        ("CONFESSIONAL", "indoor", "confessional"),
        ("BANK VAULT", "indoor", "vault"),
        ("CAPTAIN'S CABIN", "indoor", "ship_cabin"),
        ("INSIDE OF A MAIL COACH", "indoor", "horse_carriage"),
        ("LIFT", "indoor", "elevator"),
        ("PRISON CELL", "indoor", "cell"),
        ("APARTMENT BUILDING", "outdoor", "housing_estate"),
        ("CAMPSITE", "outdoor", "campsite"),
    ],
)
def test_a_small_place_is_no_living_room(place: str, where: SceneType, kit: str) -> None:
    assert find_kit("", place, where) == kit
    width, depth = SETS[kit].width, SETS[kit].depth
    assert where == "outdoor" or width.usual * depth.usual < 26


@pytest.mark.parametrize(
    ("place", "where", "age", "kit"),
    [
        ("APARTMENT", "indoor", "classic", "living_room"),
        ("APARTMENT", "indoor", "today", "apartment"),
        ("APARTMENT", "indoor", None, "apartment"),
        ("KITCHEN", "indoor", "victorian", "kitchen"),
        ("SUPERMARKET", "indoor", "victorian", "shop"),
        ("SERVER ROOM", "indoor", "classic", "archive"),
        ("BATTLEFIELD", "outdoor", "medieval", "open_ground"),
        ("BATTLEFIELD", "outdoor", "classic", "trench"),
    ],
)
def test_a_place_gets_the_kit_of_the_storys_age(place: str, where: SceneType, age: Age | None, kit: str) -> None:
    assert kit_of(place, where=where, age=age) == kit


def test_a_kit_that_was_chosen_by_name_stays_in_any_age() -> None:
    assert kit_of("FLAT", age="victorian", kit="apartment") == "apartment"
