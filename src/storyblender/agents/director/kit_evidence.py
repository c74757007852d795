"""Guesses the kind of a place from the things and people in it: pews make a church, a bartender a bar."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.sets import SETS

_ENOUGH = 3
"""Points that a kit needs to be chosen over the plain fallback."""

_EVIDENCE: dict[str, str] = {
    "bar": "bar=1 bartender=3 barman=3 barmaid=3 beer=2 whisky=2 whiskey=2 jukebox=2 stool=2 counter=2 piano=1 "
    "bottle=1 glass=1 dartboard=2 tap=1 tip=1 dancer=1 pint=2 saloon=3",
    "cafe": "waiter=3 waitress=3 menu=2 coffee=2 counter=1 espresso=3 cup=1 table=1 pastry=2 cake=1 barista=3 "
    "cutlery=1 customer=1",
    "bedroom": "bed=3 pillow=2 wardrobe=2 nightstand=2 blanket=1 mattress=3 dresser=1 crib=3 cradle=2 bedside=2",
    "hospital_ward": "nurse=3 doctor=2 patient=3 gurney=3 drip=2 stretcher=2 wheelchair=1 surgeon=3 hospital=3 "
    "stethoscope=2 bed=1",
    "church": "pew=3 altar=3 priest=2 nun=2 crucifix=2 pulpit=3 organ=1 font=1 confessional=3 monk=2 hymnal=2 bishop=2",
    "kitchen": "stove=3 oven=3 sink=2 fridge=2 refrigerator=2 pan=1 pot=1 kettle=1 chef=2 cook=2 apron=1 dish=1 "
    "soup=1 knife=1",
    "bathroom": "bathtub=3 toilet=3 shower=2 basin=1 towel=1 tub=3",
    "office": "desk=2 typewriter=3 filing=2 computer=2 secretary=2 boss=2 telephone=1 fax=3 phone=1 folder=1 "
    "detective=2 printer=2 colleague=1",
    "classroom": "blackboard=3 pupil=3 teacher=2 chalk=2 student=1 chalkboard=3 professor=1 whiteboard=1",
    "courtroom": "judge=3 gavel=3 jury=3 witness=2 prosecutor=3 bailiff=3 defendant=3 attorney=1",
    "library": "bookshelf=2 librarian=3 bookcase=2 book=1",
    "laboratory": "microscope=3 flask=2 beaker=3 scientist=2 specimen=2 centrifuge=3 burette=3 petri=3 pipette=3",
    "warehouse": "crate=2 forklift=3 pallet=3 barrel=1 workbench=2 conveyor=3 mechanic=2 anvil=3 container=1",
    "theatre": "stage=3 curtain=1 spotlight=2 actor=1 audience=2 microphone=1 actress=1 usher=2 orchestra=2",
    "shop": "till=2 shopkeeper=3 register=2 shelf=1 clerk=1 counter=1 customer=1 mannequin=2 salesman=2",
    "cell": "prisoner=3 inmate=3 bunk=2 guard=1 warden=3 shackle=2",
    "great_hall": "throne=3 king=2 queen=2 courtier=2 knight=1 banner=1 chandelier=1",
    "living_room": "sofa=3 couch=3 television=2 fireplace=2 armchair=2 rug=1 carpet=1 tv=2 remote=1",
    "car": "dashboard=3 windshield=3 windscreen=3 passenger=1 steering=3 seatbelt=3 rearview=3 cabbie=3 glovebox=3 "
    "driver=1",
    "control_room": "console=3 captain=1 pilot=1 screen=1 navigator=2 viewscreen=3 cockpit=3 joystick=2",
    "gym": "punchbag=3 dumbbell=3 treadmill=3 boxer=2 hoop=2 trainer=1 coach=1",
    "cottage": "hearth=3 cauldron=3 spinning=1 lantern=1 straw=1",
    "forest": "tree=2 trunk=1 stump=2 deer=2 wolf=1 log=1 pine=2 moss=2 hunter=1",
    "street": "car=2 lamppost=2 taxi=2 pavement=2 sidewalk=3 hydrant=2 bus=1 mailbox=1 pedestrian=2 kerb=2",
    "square": "stall=2 fountain=2 statue=1 vendor=2 pigeon=1 market=2",
    "park": "bench=1 lawn=2 swing=2 pond=2 pram=1 picnic=2 bush=1 flower=1 duck=1",
    "dock": "boat=2 crane=1 fisherman=2 net=1 bollard=3 ship=2 sailor=1 anchor=2",
    "beach": "sand=2 surfboard=3 wave=2 parasol=2 shell=1 surfer=3 towel=1 deckchair=2",
    "rooftop": "chimney=2 antenna=2 ledge=1",
}
"""Kit -> points that each thing or trade gives it."""

_POINTS: Mapping[str, Mapping[str, int]] = {
    kit: {word: int(points) for word, points in (pair.split("=") for pair in told.split())}
    for kit, told in _EVIDENCE.items()
} | {kit.key: kit.told_by for kit in SETS.values() if kit.told_by}


def kit_of_things(words: Iterable[str], kits: Iterable[str]) -> str | None:
    """Return the kit with most points from the things and people of a place; None if all have too few.

    Args:
        words: Names and ids of what and who is there, in any order; each word counts once.
        kits: Keys that may be chosen.
    """
    told = (word for text in words for word in re.findall(r"[^\W\d_]+", text.lower()))
    seen = {form for word in told for form in (word, noun_key(word))}
    best, most = None, _ENOUGH - 1
    for kit in sorted(set(kits) & set(_POINTS)):
        points = sum(value for word, value in _POINTS[kit].items() if word in seen)
        if points > most:
            best, most = kit, points
    return best
