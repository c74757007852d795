"""A short story whose five props come from Poly Haven and Sketchfab, and the sites that have them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from tests.model_files import box_gltf
from tests.services.catalogue_sites import Fab, Haven, open_poly_haven, open_sketchfab
from tests.services.site import Act, Hit, Page, Site, serving

TOKEN = "0123456789-very-secret-token"
SCRIPT = """INT. STUDY - NIGHT

ADA (60, blue cardigan) sits in an armchair. A guitar leans on the wall. A suitcase stands by the door.
A typewriter and a vase are on the desk.

ADA
Nobody plays it any more.
"""
HAVEN = (
    Haven("ArmChair_01", "Arm Chair 01", ("armchair",), files=box_gltf((0.8, 0.8, 1.0), 1)),
    Haven("ceramic_vase_03", "Ceramic Vase 03", ("vase",), files=box_gltf((0.2, 0.2, 0.4), 2)),
    Haven("vintage_suitcase", "Vintage Suitcase", ("case",), files=box_gltf((0.7, 0.25, 0.45), 3)),
)
FAB = (
    Fab(
        "aaaabbbbccccdddd0000111122223333",
        "Acoustic Guitar | low poly",
        words=("guitar",),
        files=box_gltf((0.4, 0.12, 1.0), 4),
    ),
    Fab(
        "bbbbccccddddeeee0000111122223333",
        "Old Typewriter",
        ("cc0", "CC0 Public Domain"),
        ("typewriter",),
        box_gltf((0.35, 0.35, 0.2), 5),
    ),
)
EXPECTED = {
    "armchair": "poly_haven/ArmChair_01-1k/model.gltf",
    "vase": "poly_haven/ceramic_vase_03-1k/model.gltf",
    "suitcase": "poly_haven/vintage_suitcase-1k/model.gltf",
    "guitar": "sketchfab/aaaabbbbccccdddd0000111122223333-1k/model.gltf",
    "typewriter": "sketchfab/bbbbccccddddeeee0000111122223333-1k/model.gltf",
}
MAKE = """
import sys
from storyblender import studio
from storyblender.cli import app
from tests.stand_in_engine import StandInEngine
studio.BlenderEngine = StandInEngine
app(["make", *sys.argv[1:], "--quiet", "--no-animatic", "--width", "160", "--look", "fast"])
"""


@contextmanager
def open_sites() -> Iterator[tuple[Site, Site]]:
    """Run both services."""
    with serving() as haven, serving() as fab:
        open_poly_haven(haven, HAVEN)
        open_sketchfab(fab, FAB, TOKEN)
        yield haven, fab


def services_of(haven: Site, fab: Site) -> str:
    """Return the setting that names both."""
    return f"poly_haven@{haven.address},sketchfab@{fab.address}"


def key_of(fab: Site) -> dict[str, str]:
    """Return the environment variable with the token for the second."""
    host = fab.address.removeprefix("http://").replace(".", "_").replace(":", "_")
    return {f"STORYBLENDER_KEY_{host}": TOKEN}


def downloads(haven: Site, fab: Site) -> dict[str, int]:
    """Return how often each file was downloaded, by path."""
    paths = [hit.path for site in (haven, fab) for hit in site.hits]
    return {path: paths.count(path) for path in paths if path.startswith(("/dl/", "/archives/"))}


class Killer:
    """Kills the process that makes a request, when the given number of requests has come; ``last`` is its path."""

    def __init__(self, sites: Sequence[Site], number: int) -> None:
        self.left, self.process, self.last = number, 0, ""
        for site in sites:
            site.pages = {path: self._watched(page) for path, page in site.pages.items()}

    def _watched(self, page: Page) -> Page:
        def answer(hit: Hit) -> Act:
            self.left -= 1
            if self.left == 0:
                self.last = hit.path
                os.kill(self.process, signal.SIGKILL)
            act = page(hit) if callable(page) else page
            assert not isinstance(act, tuple | list)
            return act  # type: ignore[return-value]

        return answer


def started(words: list[str]) -> subprocess.Popen[bytes]:
    """Start ``make`` without Blender in a process of its own."""
    return subprocess.Popen([sys.executable, "-c", MAKE, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def bytes_of(*folders: Path) -> Iterator[tuple[Path, bytes]]:
    """Yield every file in some folders with all its bytes."""
    for folder in folders:
        yield from ((path, path.read_bytes()) for path in folder.rglob("*") if path.is_file())
