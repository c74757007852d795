"""What lies on disk: damage is repaired, a person's files are kept, and nothing outside the project is touched."""

from __future__ import annotations

import errno
import hashlib
import io
import json
import os
import re
import resource
import shutil
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

import av
import pytest
from PIL import Image
from tests.stage import SETTINGS, Stage

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.project import Project
from storyblender.studio import Studio

DATED = re.compile(r" \d{4}-\d\d-\d\d \d\d\.\d\d( \(\d+\))?\.\w+$")
DAMAGES: dict[str, Callable[[Path], object]] = {
    "gone": lambda path: path.unlink(),
    "empty": lambda path: path.write_bytes(b""),
    "cut short": lambda path: path.write_bytes(path.read_bytes()[: path.stat().st_size // 2]),
    "a bit flipped": lambda path: flip(path),
}
NOT_REBUILT = ("script.fountain", "settings.json")
"""What a person gave, not what is made from it."""


def flip(path: Path) -> None:
    """Change one bit and leave no trace of it in size and time."""
    seen, content = path.stat(), bytearray(path.read_bytes())
    content[len(content) // 2] ^= 4
    path.write_bytes(content)
    os.utime(path, ns=(seen.st_atime_ns, seen.st_mtime_ns))


def outputs(stage: Stage) -> dict[str, object]:
    """Return what the program made, without copies of what was changed by hand; of a film the number of its pictures.

    A film is encoded anew to the same pictures, but not to the same bytes.
    """
    found = {name: content for name, content in stage.content().items() if not DATED.search(name)}
    return {name: pictures(content) if name.endswith(".mp4") else content for name, content in found.items()}


def pictures(film: bytes) -> int:
    try:
        with av.open(io.BytesIO(film)) as content:
            return sum(1 for _ in content.decode(video=0))
    except av.FFmpegError:
        return -1


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    stage = Stage(tmp_path / "p", monkeypatch)
    stage.render()
    return stage


@pytest.mark.parametrize("damage", DAMAGES)
def test_whatever_can_be_rebuilt_is_rebuilt(stage: Stage, damage: str) -> None:
    whole = outputs(stage)
    for name in whole:
        if name not in NOT_REBUILT:
            DAMAGES[damage](stage.folder / name)
    stage.render()
    assert outputs(stage) == whole
    assert not stage.render(), "nothing is left to do"


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("damage", DAMAGES)
def test_each_file_by_itself_is_rebuilt(stage: Stage, damage: str) -> None:
    whole = outputs(stage)
    for name in whole:
        if name not in NOT_REBUILT:
            DAMAGES[damage](stage.folder / name)
            stage.render()
            assert outputs(stage) == whole, name


@pytest.mark.parametrize("folders", [("assets",), ("build",), ("frames", "thumbnails", "clips"), ("assets", "build")])
def test_folders_may_be_deleted(stage: Stage, folders: tuple[str, ...]) -> None:
    whole = outputs(stage)
    for folder in folders:
        shutil.rmtree(stage.folder / folder)
    stage.render()
    assert outputs(stage) == whole and not stage.told


@pytest.mark.parametrize(
    "content", [None, b"", b"\0" * 5000, b"[" * 100_000, b'{"name": "../../etc", "digest": "x"}\n{']
)
def test_without_a_record_of_what_was_written_all_is_made_again(stage: Stage, content: bytes | None) -> None:
    whole, record = outputs(stage), stage.folder / "outputs.jsonl"
    record.unlink() if content is None else record.write_bytes(content)
    stage.render()
    assert outputs(stage) == whole and not stage.render()


def test_of_a_project_without_a_record_only_what_a_person_changed_is_kept_aside(stage: Stage) -> None:
    """A version that kept no record wrote the digest of the Blender file beside what it was compiled from."""
    story, record = stage.folder / "story.blend", stage.folder / "build" / "story.json"
    kept = json.loads(record.read_text()) | {"file": hashlib.sha256(story.read_bytes()).hexdigest()[:16]}
    painted = stage.folder / "frames" / "SC020_SH010.png"
    Image.new("RGB", (64, 36), (255, 0, 0)).save(painted)
    (stage.folder / "outputs.jsonl").unlink()
    record.write_text(json.dumps(kept))
    stage.render(wide=320)
    copies = [path.name for path in stage.folder.rglob("*") if DATED.search(path.name)]
    assert len(copies) == 1 and copies[0].startswith("SC020_SH010 ")


def test_a_thumbnail_that_a_person_changed_is_kept_aside(stage: Stage) -> None:
    mine = stage.folder / "thumbnails" / "SC020_SH010.jpg"
    mine.write_bytes(b"mine")
    stage.render(wide=320)
    assert [path.read_bytes() for path in mine.parent.glob("* *.jpg")] == [b"mine"]


def test_a_folder_in_the_place_of_a_frame_is_refused_and_stays(stage: Stage) -> None:
    frame = stage.folder / "frames" / "SC020_SH010.png"
    frame.unlink()
    frame.mkdir()
    (frame / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match=r"SC020_SH010\.png: cannot be written"):
        stage.render()
    assert (frame / "mine.txt").read_text() == "mine"


def test_a_damaged_frame_of_another_shot_is_drawn_with_the_one_asked_for(stage: Stage) -> None:
    whole = outputs(stage)
    DAMAGES["cut short"](stage.folder / "frames" / "SC020_SH010.png")
    stage.render("SC010_SH010")
    assert outputs(stage) == whole


def test_a_persons_own_files_stay(stage: Stage) -> None:
    mine = ["frames/notes.txt", "frames/SC010_SH010 v2.png", "build/frames/mine.png", "build/motion/mine/a.jpg"]
    mine += [
        "build/scenes/SC010-old.blend",
        "build/prints/a.jpg",
        "build/film/a.mp4",
        "thumbnails/a.jpg",
        "clips/a.mp4",
    ]
    for name in mine:
        (stage.folder / name).parent.mkdir(exist_ok=True)
        (stage.folder / name).write_text(name)
    before = set(stage.content())
    stage.render(wide=320)
    stage.render(wide=320)
    after = stage.content()
    assert [after[name].decode() for name in mine] == mine
    gone = before - set(after)
    assert any(name.startswith("build/frames/") for name in gone), "what is ours and of no use is deleted"


def test_what_is_painted_stays_until_the_shot_looks_otherwise_and_then_beside_it(stage: Stage) -> None:
    frame = stage.folder / "frames" / "SC010_SH010.png"
    Image.new("RGB", (64, 36), (255, 0, 0)).save(frame)
    painted = frame.read_bytes()
    stage.render()
    assert frame.read_bytes() == painted and not stage.told
    stage.render(wide=320)
    copies = [path for path in frame.parent.iterdir() if DATED.search(path.name)]
    assert frame.read_bytes() != painted and [path.read_bytes() for path in copies] == [painted]
    assert len(stage.told) == 1 and f"frames/{copies[0].name}" in stage.told[0]
    stage.render()
    assert copies[0].exists(), "nor is it ever deleted"


def test_a_frame_that_found_no_room_beside_its_former_one_takes_its_place_next_time(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.render(wide=320)
    wanted = outputs(stage)
    stage.render()
    write = Folder.write

    def full(folder: Folder, name: str, content: str | bytes) -> Path:
        if name.startswith("frames/"):
            raise InputError("cannot be written")
        return write(folder, name, content)

    with monkeypatch.context() as patched, pytest.raises(InputError):
        patched.setattr(Folder, "write", full)
        stage.render(wide=320)
    stage.render(wide=320)
    assert outputs(stage) == wanted and not stage.told


def test_a_list_that_a_person_wrote_in_is_kept_beside_the_new_one(stage: Stage) -> None:
    (stage.folder / "shots.csv").write_text("my notes")
    stage.render()
    copies = [path for path in stage.folder.iterdir() if DATED.search(path.name)]
    assert [path.read_text() for path in copies] == ["my notes"] and copies[0].name in stage.told[0]


def folders_of(stage: Stage) -> list[str]:
    names = (path for path in stage.folder.rglob("*") if path.is_dir())
    return sorted(path.relative_to(stage.folder).as_posix() for path in names)


def replaced_by_link(stage: Stage, name: str, target: Path) -> None:
    path = stage.folder / name
    shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.symlink_to(target)


def assert_nothing_outside_is_touched(stage: Stage, names: list[str]) -> None:
    outside = stage.folder.parent / "outside"
    (outside / "deep").mkdir(parents=True)
    for name in ("a.png", "deep/b.txt", "SC010_SH010.png", "engine.log"):
        (outside / name).write_text("mine")
    seen = {path: path.lstat().st_mtime_ns for path in (outside, *outside.rglob("*"))}
    whole = stage.folder.with_name("whole")
    shutil.copytree(stage.folder, whole, symlinks=True)
    for name in names:
        shutil.rmtree(stage.folder)
        shutil.copytree(whole, stage.folder, symlinks=True)
        target = outside if (whole / name).is_dir() else outside / "a.png"
        replaced_by_link(stage, name, target)
        with pytest.raises(InputError) as refusal:
            stage.render(wide=320)
        if name not in READ_FIRST:
            assert refusal.value.path == stage.folder / name and "is a link" in refusal.value.problem
        assert {path: path.lstat().st_mtime_ns for path in (outside, *outside.rglob("*"))} == seen, name
        assert {path.read_text() for path in outside.rglob("*") if path.is_file()} == {"mine"}, name


LINKED = [
    "frames", "build", "build/frames", "build/motion", "build/scenes", "build/prints", "build/film", "assets", "clips",
    "thumbnails", "history", "index.html", "board.pdf", "story.blend", "graph.json", "history/HEAD", "outputs.jsonl",
    ".lock", "frames/SC010_SH010.png", "animatic.mp4", "build/story.json",
]  # fmt: skip


READ_FIRST = ("graph.json", "history", "history/HEAD")
"""What is read before anything is written; what is found behind the link is no project."""


def test_links_in_an_untrusted_project_are_refused(stage: Stage) -> None:
    assert_nothing_outside_is_touched(stage, LINKED)


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_a_link_in_place_of_any_file_or_folder_is_refused(stage: Stage) -> None:
    unused = re.compile(r"script|settings|trace|history/0|build/(frames|motion|prints|film)/|/0000\d\.jpg")
    names = [*stage.content(), *folders_of(stage), *(f"history/{n:06d}.json" for n in (1, 2, 3))]
    assert_nothing_outside_is_touched(stage, [name for name in names if not unused.search(name)])


@contextmanager
def failing(number: int, fault: int = errno.ENOSPC) -> Iterator[list[str]]:
    """Let the n-th call that changes the disk fail, and every one after it; yield the calls.

    With ``errno.ENOMEM`` it is the memory for the call that cannot be had, as Python says it.
    """
    calls: list[str] = []
    patches = pytest.MonkeyPatch()

    def counted(name: str) -> None:
        real = getattr(os, name)

        def call(*arguments: object, **words: object) -> object:
            writes = name != "open" or (len(arguments) > 1 and int(str(arguments[1])) & (os.O_WRONLY | os.O_RDWR))
            if writes:
                calls.append(name)
                if len(calls) >= number:
                    raise MemoryError if fault == errno.ENOMEM else OSError(fault, os.strerror(fault))
            return real(*arguments, **words)

        patches.setattr(os, name, call)

    for name in ("open", "fsync", "replace", "mkdir"):
        counted(name)
    try:
        yield calls
    finally:
        patches.undo()


def refused(fault: int) -> AbstractContextManager[object]:
    """Expect one sentence about the disk; the command line turns a lack of memory into its sentence."""
    if fault == errno.ENOMEM:
        return pytest.raises(MemoryError)
    return pytest.raises(InputError, match=re.escape(os.strerror(fault)))


def assert_failures_heal(stage: Stage, count: int, fault: int) -> None:
    """Let ``count`` calls, spread over a run that draws all anew, fail in turn; every time the next run heals."""
    wanted: dict[int, dict[str, object]] = {}
    total = 0
    for wide in (320, 160):
        with failing(10**9) as calls:
            stage.render(wide=wide)
        wanted[wide], total = outputs(stage), len(calls)
    assert total > 100
    for turn, number in enumerate(range(1, total, max(1, total // count))):
        wide = (320, 160)[turn % 2]
        with failing(number, fault), refused(fault):
            stage.render(wide=wide)
        stage.render(wide=wide)
        assert outputs(stage) == wanted[wide], number
        assert not list(stage.folder.rglob(".*.part"))
        assert not [path for path in stage.folder.rglob("*") if DATED.search(path.name)], "nobody changed anything"


@pytest.mark.parametrize("fault", [errno.ENOSPC, errno.EIO, errno.ENOMEM])
def test_a_run_that_the_disk_stopped_goes_on_to_the_same_end(stage: Stage, fault: int) -> None:
    assert_failures_heal(stage, 3, fault)


@pytest.mark.slow
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("fault", [errno.ENOSPC, errno.ENOMEM])
def test_a_run_that_was_stopped_anywhere_goes_on_to_the_same_end(stage: Stage, fault: int) -> None:
    assert_failures_heal(stage, 10**6, fault)


@contextmanager
def files_no_larger_than(size: int) -> Iterator[None]:
    """Let the system refuse to write past a size, whichever library writes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("size", [0, 700, 9000])
def test_a_write_that_the_system_refuses_is_one_sentence(stage: Stage, size: int) -> None:
    stage.render(wide=320)
    wanted = outputs(stage)
    stage.render(wide=160)
    with files_no_larger_than(size), pytest.raises(InputError, match="cannot be written"):
        stage.render(wide=320)
    stage.render(wide=320)
    assert outputs(stage) == wanted


def test_check_says_that_the_blender_file_was_changed(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    from storyblender import viewed_project
    from storyblender.inspection import Inspection

    monkeypatch.setattr(viewed_project, "inspect", lambda *_: Inspection(rows=()))
    assert Studio(SETTINGS).check(stage.folder).rows[-1].value == "as compiled"
    with (stage.folder / "story.blend").open("ab") as file:
        file.write(b"a camera moved")
    report = Studio(SETTINGS).check(stage.folder)
    assert report.rows[-1].value == "1 changed by hand" and "story.blend" in report.findings[-1]


def test_a_left_part_file_is_cleared_and_nothing_else(stage: Stage) -> None:
    left = [stage.folder / "frames" / ".a.png.77-1.part", stage.folder / "build" / "motion" / ".b.77-2.part"]
    left[0].write_text("half")
    left[1].mkdir()
    with Project(stage.folder):
        assert not any(path.exists() for path in left)
