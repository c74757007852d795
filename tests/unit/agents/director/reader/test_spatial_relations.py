"""Where people and things end up."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands.\n\n"


@pytest.mark.parametrize(
    ("action", "relation"),
    [
        ("Joe backs against the wall.", ("joe", "against", "wall")),
        ("Joe drops onto Kate's stool.", ("joe", "on", "stool")),
        ("Joe turns at the door.", ("joe", "at", "door")),
        ("A newspaper slides to the floor.", ("newspaper", "on", "floor")),
        ("Joe carries a chair in and sets it down next to Kate.", ("chair", "next_to", "kate")),
        ("Joe stacks records in a crate.", ("record", "in", "crate")),
        ("Joe sits on the hood of a car.", ("joe", "on", "car")),
        ("Joe motions Kate behind the curtain.", ("kate", "behind", "curtain")),
        ("Joe grabs the gun lying on the table.", ("gun", "on", "table")),
        ("Propped against the fridge is a broom.", ("broom", "against", "fridge")),
        ("On the desk sit a typewriter and a telephone.", ("telephone", "on", "desk")),
        ("Joe puts a cup, a spoon and a plate on the table.", ("plate", "on", "table")),
        ("A lantern swings from a hook.", ("lantern", "on", "hook")),
        ("A radio plays on the windowsill.", ("radio", "on", "windowsill")),
        ("Joe pulls a chair up to the table.", ("chair", "next_to", "table")),
        ("Joe lowers a crate to the floor.", ("crate", "on", "floor")),
        ("Joe drapes a towel over the chair.", ("towel", "on", "chair")),
        ("Joe gets into the car.", ("joe", "in", "car")),
        ("Joe lowers himself into the armchair.", ("joe", "on", "armchair")),
        ("Joe, by the stove, strikes a match.", ("joe", "next_to", "stove")),
        ("Joe squats on one of the baskets.", ("joe", "on", "basket")),
        ("Across the table from Kate sits Joe.", ("joe", "in_front_of", "kate")),
        ("Kate nods. There is a mug to her left, and behind her a radiator.", ("mug", "left_of", "kate")),
        ("Kate nods. There is a mug to her left, and behind her a radiator.", ("radiator", "behind", "kate")),
        ("A candle burns on the table, and behind it a map hangs on the wall.", ("map", "on", "wall")),
        ("A caravan is parked against the fence, a trough in front of it.", ("trough", "in_front_of", "caravan")),
        ("Joe sits, the hat on the floor in front of him.", ("hat", "in_front_of", "joe")),
        ("Joe enters with Kate at his heels.", ("kate", "behind", "joe")),
        ("The box is full of letters, and on top of the letters lies a ring.", ("ring", "on", "letter")),
        ("Kate picks up the letter that lies on the mat.", ("letter", "on", "mat")),
        ("Joe stops at the counter.", ("joe", "at", "counter")),
        ("Joe places the vase between the lamp and the clock.", ("vase", "between", "lamp")),
        ("Joe lowers his toolbox onto the rim of the nearest trough.", ("toolbox", "on", "trough")),
        ("Joe sits, a blanket round his shoulders.", ("blanket", "on", "joe")),
        ("The clipboard goes spinning into the trough.", ("clipboard", "in", "trough")),
        ("Joe puts the cup next to the bell.", ("cup", "next_to", "bell")),
        ("Joe sits on the hatbox, facing Kate.", ("joe", "facing", "kate")),
        ("Light falls on a table laid for one: a plate, an egg cup, a newspaper.", ("newspaper", "on", "table")),
        ("Kate is asleep on the couch by the doors.", ("couch", "next_to", "door")),
        ("In a chair against the wall sits Joe.", ("chair", "against", "wall")),
        ("A coat hangs on the hook behind the door.", ("hook", "behind", "door")),
        ("The book lies on the desk under the window.", ("desk", "under", "window")),
        ("Joe sits on a crate behind the counter.", ("joe", "behind", "counter")),
        ("Kate hops down to the floor.", ("kate", "on", "floor")),
        ("Joe crawls under the bed.", ("joe", "under", "bed")),
        ("By the stove stands a table with a lamp on it.", ("lamp", "on", "table")),
        ("A long table with a jug on it.", ("jug", "on", "table")),
        ("Above the bed hangs a crucifix.", ("crucifix", "over", "bed")),
        ("Kate stands behind the counter, Joe in front of it.", ("joe", "in_front_of", "counter")),
        ("Joe picks up the cup, the plate and the spoon and puts them in the sink.", ("cup", "in", "sink")),
        ("Kate enters with a tray, sets it on the counter and sits.", ("tray", "on", "counter")),
        ("Joe sits on the concrete.", ("joe", "on", "floor")),
        ("A key drops out onto the tiles.", ("key", "on", "floor")),
        ("Joe stands on the top rung of a ladder.", ("joe", "on", "ladder")),
        ("Joe and Kate face each other.", ("kate", "facing", "joe")),
        ("Joe sets the desk down against the opposite wall.", ("desk", "against", "wall")),
        ("An open coffin rests on a trolley.", ("coffin", "on", "trolley")),
        ("Joe lays the book face down on the desk.", ("book", "on", "desk")),
        ("Joe hooks his helmet over an umbrella.", ("helmet", "on", "umbrella")),
        ("Joe puts a basket on the table, takes off a glove and lays a coin beside it.", ("coin", "next_to", "basket")),
        ("Kate sits on a crate, a cat on her lap.", ("cat", "on", "kate")),
        ("Joe sits on the crate, his back against the wall.", ("joe", "against", "wall")),
        ("Kate stands guard at the door.", ("kate", "at", "door")),
        ("Kate sits bolt upright in an armchair.", ("kate", "on", "armchair")),
        ("Joe falls across the desk.", ("joe", "on", "desk")),
        ("At his feet lies a bag.", ("bag", "at", "joe")),
        ("A mug stands on the desk in front of Joe.", ("desk", "in_front_of", "joe")),
        ("They have the table at the window.", ("table", "at", "window")),
        ("Joe sits, with Kate on his left.", ("kate", "left_of", "joe")),
        ("Joe stops the tractor and drops his hat on the seat.", ("hat", "on", "tractor")),
        ("A plate of bacon in front of Joe.", ("plate", "in_front_of", "joe")),
        ("In the wall behind the desk is a safe.", ("safe", "in", "wall")),
        ("Joe jumps onto Kate's shoulders.", ("joe", "on", "kate")),
        ("Joe rides on Kate's back.", ("joe", "on", "kate")),
        ("Joe stops two steps in front of Kate.", ("joe", "in_front_of", "kate")),
        ("A ferry waits. Joe steps aboard.", ("joe", "on", "ferry")),
        ("A car stops. Kate opens the door and gets in.", ("kate", "in", "car")),
        ("Joe sits at a table under a lamp.", ("table", "under", "lamp")),
        ("A camera stands on a table at the window.", ("table", "at", "window")),
        ("There is a table. Kate sits at the head.", ("kate", "at", "table")),
        ("Joe crouches in the boat. Kate stands on the deck.", ("kate", "on", "boat")),
        ("Kate enters, Joe behind her.", ("joe", "behind", "kate")),
        ("Joe sets two glasses between them.", ("glasses", "between", "joe")),
    ],
)
def test_where_they_are_after_it(read_scene: Read, action: str, relation: tuple[str, str, str]) -> None:
    told = [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in read_scene(PEOPLE + action).relations]
    assert relation in told


@pytest.mark.parametrize(
    ("action", "thing"),
    [
        ("Joe slides the box across the table to Kate.", "box"),
        ("Joe rests both hands on top of the book.", "joe"),
        ("Joe lays Kate on the couch.", "joe"),
        ("Joe leans on his cane.", "joe"),
        ("Joe enters with a whistle round his neck.", "whistle"),
        ("Joe stoops over the ledger.", "joe"),
        ("Joe waits, wrapped in a quilt.", "joe"),
        ("Kate empties the mug into the sink.", "mug"),
        ("Joe jumps off the table onto the floor.", "table"),
        ("Joe sits across the room.", "joe"),
        ("Joe sits in the corner.", "joe"),
        ("Joe bangs his stick on the floor.", "stick"),
        ("Joe throws the ball over his shoulder.", "ball"),
        ("Joe puts the key in his pocket.", "key"),
        ("Joe presses the button on the panel.", "button"),
        ("Kate hides the letter behind her back.", "letter"),
        ("Joe presses a needle against Kate's arm.", "needle"),
        ("Joe leans close to the screen.", "joe"),
        ("Joe pours water into the cup.", "water"),
        ("Joe crawls to the locker on his elbows.", "locker"),
        ("Joe reads a message on his phone.", "joe"),
        ("A photograph of a man in a straw hat hangs there.", "photograph"),
    ],
)
def test_what_does_not_stay_there_has_no_place(read_scene: Read, action: str, thing: str) -> None:
    assert thing not in [r.asset_id for _, r in read_scene(PEOPLE + action).relations]


@pytest.mark.parametrize(
    ("action", "wrong"),
    [
        ("Kate is asleep on the couch by the doors.", ("kate", "next_to", "door")),
        ("A coat hangs on the hook behind the door.", ("coat", "behind", "door")),
        ("Joe stands to the right of the wardrobe.", ("joe", "right_of", "kate")),
        ("Kate stands behind the counter, Joe in front of it.", ("kate", "in_front_of", "counter")),
    ],
)
def test_a_place_belongs_to_one_of_them(read_scene: Read, action: str, wrong: tuple[str, str, str]) -> None:
    told = [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in read_scene(PEOPLE + action).relations]
    assert told
    assert wrong not in told


def test_what_somebody_has_with_them_has_a_place_of_its_own(read_scene: Read) -> None:
    told = [(r.asset_id, r.kind) for _, r in read_scene(PEOPLE + "Kate sits with her feet on the desk.").relations]
    assert ("kate", "on") not in told


def test_several_come_behind_somebody(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "BOB (20, a man) nods. Kate enters, Joe and Bob behind her.")
    told = {(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations}
    assert told == {("joe", "behind", "kate"), ("bob", "behind", "kate")}


def test_nobody_is_placed_by_what_is_not_there(read_scene: Read) -> None:
    reading = read_scene(
        "At rise, NORA sits in turn on the chair beside the others. TIBOR stays in a hurry by what is left."
    )
    known = {thing.id for thing in reading.things} | {person.id for person in reading.people}
    assert {spot.anchor_id for unit in reading.units for spot in unit.spots.values()} <= known | {"floor"}
