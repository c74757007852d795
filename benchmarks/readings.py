"""``python -m benchmarks readings [FOLDER...]``: the rules' reading of a page against a careful person's.

A folder holds pages and, in ``readings/``, ``PAGE.reading.json`` for each of them (see ``benchmarks/pages/README.md``).
With ``--ablate`` each rule of the reader is switched off in turn, and what that changes is printed.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from benchmarks.comparison import FACTS, Comparison, Tally

from storyblender.agents.director.places_by_meaning import choose_kits_by_meaning
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.reading_file import read_reading
from storyblender.agents.director.rules import RULES, Ledger, using_ledger
from storyblender.library.embedder import load_embedder
from storyblender.screenplay.source import load

PAGES = Path(__file__).parent / "pages"


def careful_readings(folder: Path) -> list[Reading]:
    """Return the careful reading of each page of a folder that has one."""
    found: list[Reading] = []
    for path in sorted((folder / "readings").glob("*.reading.json")):
        name = path.name.removesuffix(".reading.json")
        page = next(page for page in sorted(folder.iterdir()) if page.stem == name)
        found.append(read_reading(path, load(page)))
    return found


def compared(careful: list[Reading]) -> dict[str, Tally]:
    """Return the tallies of the rules' readings of some pages, as the program takes them."""
    total = {fact: Tally() for fact in FACTS}
    for each in careful:
        reading = read_script(each.screenplay)
        choose_kits_by_meaning(reading, load_embedder)
        for fact, tally in Comparison(reading, each).count().items():
            total[fact] += tally
    return total


def ablated(careful: list[Reading]) -> Iterator[tuple[str, dict[str, Tally]]]:
    """Return each rule with the tallies of readings that do without it."""
    for name in sorted(RULES):
        with using_ledger(Ledger(off=frozenset({name}))):
            yield name, compared(careful)


def main() -> int:
    """Print a table for each folder, and return 1 where there is nothing to compare."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("folders", nargs="*", type=Path, default=[PAGES / "working", PAGES / "sealed"])
    parser.add_argument("--ablate", action="store_true", help="switch each rule off and print the change of each F1")
    given = parser.parse_args()
    pages = {folder: careful_readings(folder) for folder in given.folders}
    if given.ablate:
        _print_ablation([each for careful in pages.values() for each in careful])
        return 0
    for folder, careful in pages.items():
        print(f"{folder.name}: {len(careful)} pages\n{'':18}precision  recall     F1   right  wrong missed")
        for fact, tally in compared(careful).items():
            shares = f"{tally.precision:9.2f} {tally.recall:7.2f} {tally.f1:6.2f}"
            print(f"{fact:18}{shares} {tally.right:7} {tally.wrong:6} {tally.missed:6}")
    return 0 if any(pages.values()) else 1


def _print_ablation(careful: list[Reading]) -> None:
    """Print a line for each rule: what all F1 together gain by it, and each that changes without it."""
    whole = compared(careful)
    for name, without in ablated(careful):
        changes = {fact: without[fact].f1 - whole[fact].f1 for fact in FACTS}
        told = "  ".join(f"{fact} {change:+.3f}" for fact, change in changes.items() if abs(change) >= 0.0005)
        print(f"{-sum(changes.values()):+.3f} {name:34}{told or 'no change'}", flush=True)


if __name__ == "__main__":
    raise SystemExit(main())
