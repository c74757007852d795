"""Where things are in descriptions of a place: chains, lists, places without a noun."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands.\n\n"


def relations(reading: Reading) -> set[tuple[str, str, str]]:
    """Who or what, how, to what; of ``between`` the first side."""
    return {(stated.asset_id, stated.kind, stated.anchor_asset_id) for _, stated in reading.relations}


@pytest.mark.parametrize(
    ("action", "relation"),
    [
        ("On the desk lies a letter, and on the letter a pair of spectacles.", ("spectacles", "on", "letter")),
        ("On the stove a kettle steams; under the table stands a bucket.", ("kettle", "on", "stove")),
        ("On the sledge, under a sheet, are crates and a tent.", ("tent", "under", "sheet")),
        ("The door opens. Joe drags in a sledge with a tree on it.", ("tree", "on", "sledge")),
        ("A camera is mounted on a tripod at the window. Joe sits beside it.", ("joe", "next_to", "camera")),
        ("Between the chair and the stove a parrot sleeps in a basket.", ("basket", "between", "chair")),
        ("There is an armchair with a shawl lying on its arm and a book lying open, face down, on the seat.",
         ("book", "on", "armchair")),
        ("Against the wall stands a wardrobe with a suitcase on top.", ("suitcase", "on", "wardrobe")),
        ("A row of lockers lines the wall. Below them, a bench.", ("bench", "under", "locker")),
        ("The lockers stand open. Below them, a row of boots.", ("boot", "under", "locker")),
        ("A rowing boat lies upside down on the sand, its oars under it.", ("oar", "under", "rowing_boat")),
        ("Joe lays his gloves on the table, his hat on top of them.", ("hat", "on", "glove")),
        ("Joe takes off his spectacles and puts them on the book.", ("spectacles", "on", "book")),
        ("Joe stuffs the money into a sock, the sock into a boot.", ("sock", "in", "boot")),
        ("Joe opens the case. Inside, on velvet, lies a violin.", ("violin", "in", "case")),
        ("Joe opens the drawer. Inside lie a tin and a compass.", ("compass", "in", "drawer")),
        ("A workbench stands by the door. Tools hang above it.", ("tool", "over", "workbench")),
        ("On the bench stands a lamp; beside the lamp a saucer full of coins.", ("saucer", "next_to", "lamp")),
        ("A backdrop leans against the fence; in front of it, coils of rope, sandbags.",
         ("sandbag", "in_front_of", "backdrop")),
        ("Joe takes a rope from a nail beside the dresser.", ("nail", "next_to", "dresser")),
        ("Kate hangs her coat on the hook by the stove.", ("hook", "next_to", "stove")),
        ("Kate kneels in front of the cabinet beside the desk.", ("cabinet", "next_to", "desk")),
        ("Joe puts the chair down beside the radiator and sits on it.", ("joe", "on", "chair")),
        ("A glass stands empty on the counter.", ("glass", "on", "counter")),
        ("A workbench fills the room. On the bench stands a lamp.", ("lamp", "on", "workbench")),
        ("A radio crackles on the shelf between a jar of pickles and a clock.", ("radio", "between", "jar")),
        ("Next to the cash register, a jar of pickles and a stack of menus.", ("jar", "next_to", "cash_register")),
        ("Joe has a plate in front of him.", ("plate", "in_front_of", "joe")),
        ("The toolbox stands by the door, a flashlight on its lid.", ("flashlight", "on", "toolbox")),
        ("Kate wheels the trolley in and parks it between the beds.", ("trolley", "between", "bed")),
        ("Joe shoves the table against the door and piles the chairs on top of it.", ("chair", "on", "table")),
        ("A violin case lies open on the floor with a few coins in it.", ("coin", "in", "violin_case")),
        ("The boots stand on the mat, the umbrella leans in the corner behind them.", ("umbrella", "behind", "boot")),
        ("A coat hangs on the hook, and a pair of muddy boots stands under the radiator.",
         ("boot", "under", "radiator")),
        ("Joe opens the stove. He throws the letter in.", ("letter", "in", "stove")),
        ("Joe and Kate stand side by side.", ("joe", "next_to", "kate")),
        ("Chisels hang from a pegboard above the bench.", ("pegboard", "over", "bench")),
        ("On the bench stand a tin, a jar of brushes and a lamp.", ("jar", "on", "bench")),
        ("On the bench stand a tin, a jar of brushes and a lamp.", ("lamp", "on", "bench")),
        ("A bus leans against the rock. Suitcases are strapped to the roof.", ("suitcase", "on", "bus")),
        ("Joe slides a coin across the bar.", ("coin", "on", "bar")),
        ("Joe sits in front of the stove on a crate.", ("joe", "in_front_of", "stove")),
        ("Joe sits in a wicker chair.", ("joe", "on", "wicker_chair")),
    ],
)  # fmt: skip
def test_a_description_tells_where_things_are(action: str, relation: tuple[str, str, str], read_scene: Read) -> None:
    assert relation in relations(read_scene(PEOPLE + action))


@pytest.mark.parametrize(
    ("action", "relation"),
    [
        ("Against the wall stands a wardrobe with a suitcase on top.", ("wardrobe", "on", "suitcase")),
        ("Kate hangs her coat on the hook by the stove.", ("coat", "next_to", "stove")),
        ("Kate kneels in front of the cabinet beside the desk.", ("kate", "next_to", "desk")),
        ("From a shelf under the counter Joe takes a bottle.", ("joe", "under", "counter")),
        ("Joe leans over the counter.", ("joe", "over", "counter")),
        ("Joe weaves between the tables.", ("joe", "between", "table")),
        ("Joe sits in front of the stove on a crate.", ("stove", "on", "crate")),
        ("Joe takes off his spectacles and puts them on the book.", ("joe", "on", "book")),
        ("A bicycle is propped against the gate with a basket of bread on the handlebars.",
         ("bicycle", "on", "handlebar")),
    ],
)  # fmt: skip
def test_what_a_description_does_not_tell(action: str, relation: tuple[str, str, str], read_scene: Read) -> None:
    assert relation not in relations(read_scene(PEOPLE + action))


def test_two_strong_acts_of_one_sentence_are_both_read(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "Kate grabs the knife and stabs the door.")
    deeds = [(deed.motion, deed.target) for deed in reading.units[-1].deeds]
    assert deeds == [("take", "knife"), ("hit", "door")]
