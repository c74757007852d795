"""Eight short stories made against one library, one after the other: how much of what they ask for is used again.

The stories are the first eight pages, by name, that no rule of the reader quotes. They are planned and staged in full;
an engine without Blender stands for building, which changes nothing in what is asked for and what is taken.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from tests.stand_in_engine import StandInEngine

from storyblender import studio
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.settings import Settings

PAGES = Path(__file__).parent.parent / "tests" / "data" / "director"
STORIES = 8


def scripts(folder: Path, count: int) -> list[Path]:
    """Write the scripts of the first pages into a folder, without their annotations."""
    made: list[Path] = []
    for page in sorted([*PAGES.glob("fresh_*.gold"), *PAGES.glob("unseen_*.gold")])[:count]:
        lines = page.read_text(encoding="utf-8").splitlines(keepends=True)
        suffix = ".txt" if page.stem.endswith("_prose") else ".fountain"
        made.append(folder / f"{page.stem}{suffix}")
        made[-1].write_text("".join(line for line in lines if not line.startswith("|")), encoding="utf-8")
    return made


def main() -> None:
    """Print the figures after each story; scripts of one's own may be named instead."""
    studio.BlenderEngine = StandInEngine  # type: ignore[assignment, misc]
    with tempfile.TemporaryDirectory() as name:
        os.environ["STORYBLENDER_LIBRARY"] = f"{name}/library"
        scenes = shots = 0
        for script in [Path(each) for each in sys.argv[1:]] or scripts(Path(name), STORIES):
            settings = Settings(width=160, look="fast", animatic=False)
            made = studio.Studio(settings).make(script, Path(name) / f"{script.stem}.storyboard")
            scenes, shots = scenes + len(made.graph.scenes), shots + len(made.graph.shots)
            told = SharedLibrary.open().uses.figures()
            print(f"{told.stories} stories, {scenes} scenes, {shots} shots: {told.requests} requests", end="")
            print(f", {told.unique} models, {told.avoided} avoided ({told.avoided_in_story} in one story)", end="")
            print(f", {told.reduction:.2f} %, {told.references:.3f} references a model", flush=True)
        print(dict(told.categories))


if __name__ == "__main__":
    main()
