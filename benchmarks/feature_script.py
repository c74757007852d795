"""A screenplay of feature length, written by a seeded generator: for benchmarks and tests, in words of our own.

The story is a harbour town that loses its ferry. Twenty-six people meet in forty places which come back through the
film; scenes have from one to five people, and what they say and do is put together anew for each.
"""

from __future__ import annotations

import argparse
import random
from collections.abc import Iterator
from pathlib import Path

SCENES = 190
"""A feature; at the usual settings of the Director its scenes have about 1,200 shots."""

PEOPLE = (
    ("MARTA VOSS", "52, grey hair in a bun, dark blue coat"),
    ("ELIAS", "34, black beard, yellow oilskin jacket"),
    ("JUNE", "19, short red hair, green pullover"),
    ("KAPITAN ROWE", "61, heavy man, white beard, navy uniform"),
    ("IRIS", "41, slender, long black hair, grey suit"),
    ("TOBIAS", "27, tall, blond curls, brown leather jacket"),
    ("NELL", "66, white hair, flowered dress"),
    ("DR HALE", "48, bald, white coat"),
    ("OSKAR", "12, freckles, striped pullover"),
    ("SISTER AGNES", "57, black habit"),
    ("MAYOR PELL", "55, broad man, moustache, black suit, red tie"),
    ("LENA", "30, brown ponytail, blue overalls"),
    ("BRUNO", "44, strong, bald, dark apron"),
    ("INSPECTOR KANE", "50, grey temples, beige trench coat"),
    ("YUSUF", "38, dark-skinned, white shirt, black vest"),
    ("ANOUK", "24, dark bob, red coat"),
    ("HENRIK", "71, thin, grey cardigan"),
    ("COLE", "33, shaved head, black jacket"),
    ("MRS ABARA", "46, dark-skinned, purple dress"),
    ("PIP", "9, brown braids, yellow dress"),
    ("WALTER", "58, glasses, tweed jacket"),
    ("SONJA", "36, blonde braid, white blouse, long skirt"),
    ("DANE", "29, brown hair, grey hoodie"),
    ("RUTH", "63, silver hair, black dress"),
    ("FINN", "22, black hair, denim jacket"),
    ("COLONEL ASH", "60, grey moustache, dark green uniform"),
)
"""Name in capitals, and what is said of the person at the first entrance."""

PLACES = (
    ("INT. HARBOUR OFFICE", ("desk", "shelf", "window")),
    ("INT. NELL'S KITCHEN", ("table", "stove", "cupboard")),
    ("INT. THE ANCHOR BAR", ("bar", "table", "piano")),
    ("EXT. HARBOUR DOCK", ("crate", "barrel", "lamp post")),
    ("EXT. FERRY DECK", ("bench", "mast", "barrel")),
    ("INT. HOSPITAL WARD", ("bed", "chair", "window")),
    ("INT. CHURCH", ("altar", "pew", "door")),
    ("EXT. MARKET SQUARE", ("fountain", "cart", "bench")),
    ("INT. POLICE STATION", ("desk", "chair", "door")),
    ("INT. MARTA'S BEDROOM", ("bed", "dresser", "window")),
    ("EXT. BEACH", ("rowing boat", "rock", "basket")),
    ("INT. LIGHTHOUSE", ("table", "window", "chest")),
    ("INT. TOWN LIBRARY", ("table", "bookcase", "ladder")),
    ("EXT. CEMETERY", ("gravestone", "bench", "tree")),
    ("INT. WAREHOUSE", ("crate", "barrel", "door")),
    ("INT. COURTROOM", ("table", "chair", "door")),
    ("EXT. ALLEY BEHIND THE BAR", ("barrel", "door", "crate")),
    ("INT. HOTEL LOBBY", ("sofa", "desk", "plant")),
    ("EXT. PINE FOREST", ("tree", "rock", "log")),
    ("INT. ELIAS'S WORKSHOP", ("workbench", "stool", "shelf")),
    ("EXT. RAILWAY PLATFORM", ("bench", "suitcase", "clock")),
    ("INT. TRAIN CARRIAGE", ("seat", "window", "table")),
    ("INT. CLASSROOM", ("desk", "blackboard", "globe")),
    ("EXT. PARK", ("bench", "tree", "fountain")),
    ("INT. MAYOR'S OFFICE", ("desk", "armchair", "bookcase")),
    ("INT. CAFE PELIKAN", ("table", "counter", "chair")),
    ("EXT. COAST ROAD", ("car", "signpost", "rock")),
    ("INT. BASEMENT", ("workbench", "shelf", "barrel")),
    ("EXT. ROOFTOP", ("chimney", "chair", "door")),
    ("INT. RUTH'S LIVING ROOM", ("sofa", "fireplace", "armchair")),
    ("INT. THEATRE STAGE", ("chair", "piano", "curtain")),
    ("EXT. FISHING VILLAGE STREET", ("lamp post", "bench", "door")),
    ("INT. BARN", ("ladder", "barrel", "cart")),
    ("INT. GREENHOUSE", ("table", "plant", "bucket")),
    ("EXT. MOUNTAIN PASS", ("rock", "signpost", "tree")),
    ("INT. LABORATORY", ("table", "microscope", "shelf")),
    ("INT. ATTIC", ("chest", "chair", "window")),
    ("EXT. BRIDGE", ("lamp post", "bench", "bicycle")),
    ("INT. SHIP'S CONTROL ROOM", ("console", "chair", "screen")),
    ("INT. INTERROGATION ROOM", ("table", "chair", "door")),
)
"""Heading without its time, and what stands there."""

THINGS = (
    "letter", "envelope", "key", "lantern", "photograph", "cup", "bottle", "book", "newspaper", "suitcase", "rope",
    "knife", "gun", "pistol", "flashlight", "compass", "map", "coin", "umbrella", "hat", "bell", "radio", "basket",
    "hammer", "blanket",
)  # fmt: skip
TIMES = ("DAY", "NIGHT", "DAY", "EVENING", "MORNING", "NIGHT", "DAWN")
_WHO = ("the harbour", "my brother", "that crew", "the whole town", "the old captain", "nobody here", "the council")
_DID = ("sold", "forgot", "buried", "followed", "paid for", "lied about", "waited for", "gave up", "warned us of")
_WHAT = ("the ferry", "the last crossing", "a debt", "the winter", "every promise", "the missing cargo", "that night")
_WHEN = ("before the storm", "in nineteen days", "when the fog came", "and you know it", "for one signature", "again")
_SHORT = (
    "Not here.", "Say that once more.", "How long have you known?", "I counted them twice.", "Then who has it?",
    "You should have stayed away.", "Look at me.", "It was never yours.", "We leave at first light.", "And after that?",
)  # fmt: skip
_WAYS = ("quietly", "to {other}", "after a moment", "angry", "smiling", "tired")
_OPENINGS = (
    "{one} stands by the {here}.",
    "{one} waits next to the {here}. There is a {thing} on the {there}.",
    "{one} stands next to the {here} with a {thing} in the hand.",
    "{one} paces beside the {here}.",
    "{one} leans on the {here} and looks at the {there}.",
)
_JOINING = (
    "{other} stands by the {there}.",
    "{other} enters and walks to the {here}.",
    "{other} watches from the {there}.",
    "{other} comes in and stops beside {one}.",
)
_DEEDS = (
    "{one} walks to the {there}.",
    "{one} turns to {other}.",
    "{one} picks up the {thing}.",
    "{one} points at the {here}.",
    "{other} shakes the head slowly.",
    "{one} gives the {thing} to {other}.",
    "{other} looks at the {thing} for a long time.",
    "{one} kneels beside the {here}.",
    "{other} walks across to the {there} and waits.",
    "CLOSE ON the {thing}.",
    "{one} raises both hands.",
    "{other} nods.",
)
_ENDINGS = ("{one} leaves.", "{other} walks to the {there} and looks back.", "{one} looks at {other}.", "{other} sits.")


def feature(scenes: int = SCENES, seed: int = 11) -> str:
    """Return a Fountain screenplay.

    Args:
        scenes: How many; every number of scenes begins with the same ones.
        seed: Another seed, another story.
    """
    chance = random.Random(seed)
    met: set[str] = set()
    pages = [_scene(chance, met, number) for number in range(scenes)]
    return "Title: The Last Crossing\nAuthor: StoryBlender's bench\n\n" + "\n\n".join(pages) + "\n"


def _scene(chance: random.Random, met: set[str], number: int) -> str:
    heading, furniture = PLACES[_place(chance, number)]
    cast = _cast(chance, number)
    here, there = chance.sample(furniture, 2)
    words = {"here": here, "there": there, "thing": chance.choice(THINGS)}
    lines = [f"{heading} - {chance.choice(TIMES)}", ""]
    one, *others = cast
    lines += [" ".join(_opening(chance, met, one, others, words)), ""]
    for turn in range(chance.choice((2, 3, 3, 4, 4, 5, 6))):
        speaker, listener = (cast[turn % len(cast)], cast[(turn + 1) % len(cast)])
        if turn or len(cast) == 1:
            told = {
                **words,
                "one": _called(speaker),
                "other": _called(listener) if listener != speaker else "the window",
            }
            lines += [chance.choice(_DEEDS).format(**told), ""]
        lines += list(_speech(chance, speaker, listener))
    told = {**words, "one": _called(one), "other": _called(cast[-1])}
    lines.append(chance.choice(_ENDINGS).format(**told))
    return "\n".join(lines)


def _place(chance: random.Random, number: int) -> int:
    """A film opens its places one by one, and comes back to the first ones most."""
    known = min(len(PLACES), 4 + number // 3)
    return min(int(known * chance.random() ** 1.4), known - 1)


def _cast(chance: random.Random, number: int) -> list[str]:
    """From one to five people, of those whom the film has introduced by then."""
    known = min(len(PEOPLE), 5 + number // 5)
    return [name for name, _ in chance.sample(PEOPLE[:known], chance.choice((1, 2, 2, 2, 3, 3, 4, 5)))]


def _opening(chance: random.Random, met: set[str], one: str, others: list[str], words: dict[str, str]) -> Iterator[str]:
    yield chance.choice(_OPENINGS).format(one=_introduced(met, one), **words)
    for other in others:
        template = chance.choice(_JOINING)
        yield template.format(one=_called(one), other=_introduced(met, other), **words)


def _speech(chance: random.Random, speaker: str, listener: str) -> Iterator[str]:
    yield speaker
    if chance.random() < 0.25:
        yield f"({chance.choice(_WAYS).format(other=_called(listener))})"
    said = f"{chance.choice(_WHO).capitalize()} {chance.choice(_DID)} {chance.choice(_WHAT)} {chance.choice(_WHEN)}."
    yield chance.choice((said, said, f"{chance.choice(_SHORT)} {said}", chance.choice(_SHORT)))
    yield ""


def _introduced(met: set[str], name: str) -> str:
    if name in met:
        return _called(name)
    met.add(name)
    return f"{name} ({dict(PEOPLE)[name]})"


def _called(name: str) -> str:
    return name.title()


def main() -> None:
    """Write the screenplay into a file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--scenes", type=int, default=SCENES)
    arguments = parser.parse_args()
    arguments.out.write_text(feature(arguments.scenes), encoding="utf-8")


if __name__ == "__main__":
    main()
