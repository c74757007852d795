"""Search in a library of 10,000 entries, by words and by meaning: ms of processor a search, first and warm."""

from __future__ import annotations

import itertools
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from storyblender.catalog.props import PROPS
from storyblender.catalog.recipe import AssetQuery
from storyblender.library.embedder import load_embedder
from storyblender.library.named_models import words_told
from storyblender.library.shared.entries import EntryFacts, LibraryEntry
from storyblender.library.shared.search import LibrarySearch
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset

LOOKS = (
    "red",
    "old",
    "wooden",
    "small",
    "broken",
    "modern",
    "victorian",
    "rusty",
    "glass",
    "painted",
    "folding",
    "round",
)
ASKED = ("samovar", "red armchair", "old wooden table", "settee", "street light", "rucksack", "orrery", "kettle")


def library_of(count: int, root: Path) -> SharedLibrary:
    """Return a library with rows for models that are called as things of the catalogue, with two more words."""
    library = SharedLibrary.open(root)
    index = library.index(make=True)
    assert index is not None
    nouns = sorted({name for entry in PROPS.values() for name in (entry.name, *entry.tags)})
    names = (f"{a} {b} {noun}" for a, b in itertools.permutations(LOOKS, 2) for noun in nouns)
    with index.writing() as db:
        for number, name in enumerate(itertools.islice(names, count)):
            facts = EntryFacts(kind="model", name=name, main="it.glb", source="museum", source_id=str(number))
            entry = LibraryEntry(**facts.model_dump(), digest=f"{number:064x}", bytes=1)
            row = (entry.digest, "model", name, "[]", "", "museum", entry.model_dump_json(), time.time(), "")
            db.execute("INSERT INTO entries VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", row)
            db.executemany("INSERT INTO nouns VALUES (?, ?)", [(word, entry.digest) for word in words_told(name)])
    return library


def main() -> None:
    """Print the table; the number of entries may be given."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    with tempfile.TemporaryDirectory() as name:
        library = library_of(count, Path(name))
        load_embedder().embed(["warm"])
        took = clock(lambda: LibrarySearch(library, load_embedder).know())
        print({"entries": count, "read once by the sentence model, s": round(took / 1000)})
        for by_meaning in (False, True):
            times = _times(SharedLibrary.open(Path(name)), by_meaning)
            table = {"by": "meaning" if by_meaning else "words", "first": times[0], "worst": max(times[1:])}
            print({**table, "median": statistics.median(times[1:])})


def _times(library: SharedLibrary, by_meaning: bool) -> list[float]:
    search = LibrarySearch(library, load_embedder)
    return [clock(partial(search.matches, _query(name), by_meaning=by_meaning)) for name in ASKED * 5]


def clock(work: Callable[[], object]) -> float:
    """Return how long something takes the processor in ms."""
    began = time.process_time()
    work()
    return round(1000 * (time.process_time() - began), 1)


def _query(name: str) -> AssetQuery:
    return AssetQuery(asset=Asset(asset_id="it", asset_type="object", description="", name=name))


if __name__ == "__main__":
    main()
