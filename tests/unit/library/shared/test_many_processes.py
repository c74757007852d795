"""Many processes write at once, and any of them may die at any moment."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from storyblender.library.shared.shared_library import SharedLibrary

WRITER = """
import sys
from pathlib import Path
from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
root, number = Path(sys.argv[1]), int(sys.argv[2])
library = SharedLibrary.open(root / "library")
for each in range(12):
    own = each % 3 > 0  # every third bundle is the same in all processes
    name = f"chair {number if own else 'shared'} {each}"
    folder = root / f"fetched-{number}-{each}"
    folder.mkdir()
    (folder / "chair.glb").write_text(name)
    library.add(EntryFacts(kind="model", name=name, main="chair.glb", source="museum", source_id=name), folder)
    if own:
        library.jobs.submitted(library.jobs.begin(f"{number:02x}{each:02x}", "meshy", 0.1), name)
"""
DYING = """
import os, sys
from pathlib import Path
from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
left = int(sys.argv[2])
def step(*args):  # dies before the step of that number that is seen outside this process
    global left
    left -= 1
    if left < 0:
        os._exit(9)
SEEN = ("os.rename", "os.mkdir", "shutil.copyfile", "os.remove")
sys.addaudithook(lambda name, args: step() if name in SEEN else None)
library = SharedLibrary.open(Path(sys.argv[1]) / "library")
index = library.index(make=True)
index._connection.set_trace_callback(lambda statement: step())
folder = Path(sys.argv[1]) / "fetched"
library.add(EntryFacts(kind="model", name="chair", main="chair.glb", source="museum", source_id="7"), folder)
print("done")
"""


def started(code: str, *words: object) -> subprocess.Popen[str]:
    command = [sys.executable, "-c", code, *map(str, words)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_eight_processes_write_at_once_without_loss(tmp_path: Path) -> None:
    processes = [started(WRITER, tmp_path, number) for number in range(8)]
    for process in processes:
        _, said = process.communicate(timeout=300)
        assert process.returncode == 0, said[-2000:]
    library = SharedLibrary.open(tmp_path / "library")
    entries = library.find()
    assert len(entries) == 8 * 8 + 4
    for entry in entries:
        assert library.get(entry.digest) == entry == library.by_source("museum", entry.name)
        assert library.path_of(entry).read_text() == entry.name
    assert len({job.id for job in library.jobs.unfinished()}) == 8 * 8
    assert {job.state for job in library.jobs.unfinished()} == {"submitted"}
    assert not list((tmp_path / "library/incoming").iterdir())


@pytest.mark.slow
def test_a_process_that_dies_at_any_step_leaves_a_library_that_can_be_used(tmp_path: Path) -> None:
    (tmp_path / "fetched").mkdir()
    (tmp_path / "fetched/chair.glb").write_text("a chair")
    for step in range(200):
        (tmp_path / str(step)).mkdir()
        (tmp_path / str(step) / "fetched").symlink_to(tmp_path / "fetched")
        process = started(DYING, tmp_path / str(step), step)
        said, trouble = process.communicate(timeout=60)
        library = SharedLibrary.open(tmp_path / str(step) / "library")
        for entry in library.find():
            assert library.get(entry.digest) == entry, f"a row without its files, killed at step {step}"
        if said.strip() == "done":
            break
        assert process.returncode == 9, trouble[-2000:]
        done = started(DYING, tmp_path / str(step), 10**6)
        assert done.communicate(timeout=60)[0].strip() == "done", f"not usable after a kill at step {step}"
        (entry,) = library.find()
        assert library.by_source("museum", "7") == library.get(entry.digest) == entry
    assert 15 < step < 199
