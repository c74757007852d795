"""Folders of the user's own motion clips: which there are, what they are called, how a project takes one in."""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path, PurePosixPath
from typing import Any, Final, Literal

import numpy as np

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.geometry.mocap import MocapPoses
from storyblender.library.mocap.bvh import read_bvh
from storyblender.library.mocap.clip_words import words_of_clip
from storyblender.library.mocap.fbx import read_fbx
from storyblender.library.mocap.retarget import retarget
from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.mocap import MocapClip, mocap_file
from storyblender.model_content import MOST_CREDIT_BYTES, credit_files, credit_lines

READERS: Final = {".bvh": read_bvh, ".fbx": read_fbx}
"""How each kind of file is read."""
SHEET: Final = "motions.toml"
"""File in a folder of clips that says more about them than their names."""
SOURCE: Final = "motions"
MOST_FILES: Final = 20_000
UPRIGHT: Final = 0.75
"""Legs over the ankles at which hips are those of a standing person."""
LEG: Final = 0.86
"""Metres at a stature of 1.7 m."""
FURTHEST: Final = 100.0
"""Metres."""
_SHEET_BYTES: Final = 1 << 20
_SEATED: Final = frozenset(("sit", "sits", "sitting", "seated"))
Needs = Literal["person", "thing"]


@dataclass(frozen=True)
class MotionFile:
    """A clip in one of the folders, as its name and the sheet beside it say.

    Attributes:
        name: Path relative to its folder, with ``/`` between the parts.
        path: Where it lies.
        folder: Its folder of motions.
        words: Lower-case, of its own name; numbers and what says nothing are left out.
        folder_words: Those of the folders that it is in.
        description: What is done, from the sheet.
        seated: Whether it is done on a seat; None where the poses say it.
        loops: Whether it may begin again.
        needs: What an action must be aimed at for this clip.
    """

    name: str
    path: Path
    folder: Path
    words: tuple[str, ...]
    folder_words: tuple[str, ...] = ()
    description: str = ""
    seated: bool | None = None
    loops: bool = False
    needs: Needs | None = None

    @property
    def called(self) -> str:
        """What it is called."""
        return " ".join(self.words)[:80] or PurePosixPath(self.name).stem[:80]

    @property
    def key(self) -> str:
        """Its name as an edit has it: ``angry_argument_02``."""
        letters = "".join(each if each.isascii() and each.isalnum() else "_" for each in PurePosixPath(self.name).stem)
        key = "_".join(part for part in letters.lower().split("_") if part)
        return (key if key[:1].isalpha() else f"clip_{key}")[:64]


@dataclass
class MotionFolders:
    """The user's folders of motion clips.

    Args:
        folders: Earlier ones win ties; a file hides those of the same relative path in later folders.
    """

    folders: Sequence[Path]
    problems: list[str] = field(default_factory=list[str])
    """A sentence for each sheet that cannot be read, and each clip that could not be taken in."""

    @cached_property
    def files(self) -> tuple[MotionFile, ...]:
        """All clips, those of a folder by path."""
        found: dict[str, MotionFile] = {}
        for folder in self.folders:
            for file in self._in(folder):
                found.setdefault(file.name, file)
                if len(found) >= MOST_FILES:
                    self.problems.append(f"{folder} has more than {MOST_FILES} clips; the others are left out")
                    return tuple(found.values())
        return tuple(found.values())

    def called(self, key: str) -> MotionFile | None:
        """Return the clip that an edit names: its key, else the one whose name has all the words; None if unclear."""
        exact = [file for file in self.files if file.key == key]
        if exact:
            return exact[0]
        said = {*key.split("_")} - {""}
        fitting = [file for file in self.files if said and said <= {*file.words, *file.folder_words}]
        return fitting[0] if len({file.key for file in fitting}) == 1 else None

    def take_in(self, file: MotionFile, files: Folder, reason: str = "") -> MocapClip:
        """Read a clip, bring it onto our skeleton, and keep it in a project.

        Args:
            file: The clip.
            files: The project folder.
            reason: Why it was chosen.

        Raises:
            InputError: It cannot be read, or is no motion of a person; with the file's path.
        """
        try:
            real = file.path.resolve()
            if not real.is_relative_to(file.folder.resolve()) or not real.is_file():
                raise InputError("it leads out of its folder")
            poses = replace(retarget(READERS[file.path.suffix.lower()](real)), loops=file.loops)
            clip = _clip(file, poses, _provenance(file, real), reason)
        except InputError as error:
            raise InputError(f"the motion cannot be used: {error.problem}", mend=error.mend, path=file.path) from error
        except OSError as error:
            raise InputError(f"the motion cannot be read ({error.strerror})", path=file.path) from error
        name = mocap_file(clip.digest)
        if not files.path(name).exists():
            files.write(name, poses.save())
        return clip

    def _in(self, folder: Path) -> Iterator[MotionFile]:
        sheets: dict[Path, Mapping[str, Any]] = {}
        for path in sorted(folder.rglob("*")):
            if path.suffix.lower() not in READERS or not path.is_file():
                continue
            if path.parent not in sheets:
                sheets[path.parent] = self._sheet(path.parent)
            told = sheets[path.parent].get(path.name, sheets[path.parent].get(path.stem, {}))
            yield _file(path, folder, told if isinstance(told, Mapping) else {})

    def _sheet(self, folder: Path) -> Mapping[str, Any]:
        """Return what the sheet of a folder says, by file name."""
        path = folder / SHEET
        if not path.is_file():
            return {}
        try:
            if path.stat().st_size > _SHEET_BYTES:
                raise ValueError("too long")
            return tomllib.loads(path.read_bytes().decode("utf-8-sig"))
        except (OSError, ValueError, RecursionError) as error:
            self.problems.append(f"{path} cannot be read ({type(error).__name__}); it is left out")
            return {}


def _file(path: Path, folder: Path, told: Mapping[str, Any]) -> MotionFile:
    """Return a clip as its name and its row of the sheet say."""
    name = path.relative_to(folder).as_posix()
    words, above = words_of_clip(path.stem), words_of_clip(PurePosixPath(name).parent.as_posix())
    description = told.get("description", "")
    posture, needs = told.get("posture"), told.get("needs")
    seated = posture == "sit" if posture in ("sit", "stand") else True if _SEATED & {*words, *above} else None
    return MotionFile(
        name=name,
        path=path,
        folder=folder,
        words=words,
        folder_words=above,
        description=" ".join(description.split())[:200] if isinstance(description, str) else "",
        seated=seated,
        loops=told.get("loop") is True,
        needs=needs if needs in ("person", "thing") else None,
    )


def _provenance(file: MotionFile, real: Path) -> Provenance:
    """Return where a clip came from, and what the credits files that apply to it say."""
    told: dict[str, str] = {}
    for credits_file in credit_files(file.path, file.folder):
        try:
            with credits_file.open("rb") as text:
                told = {**credit_lines(tomllib.loads(text.read(MOST_CREDIT_BYTES).decode("utf-8-sig"))), **told}
        except (OSError, ValueError, RecursionError):
            continue
    with real.open("rb") as content:
        digest = hashlib.file_digest(content, "sha256").hexdigest()
    return Provenance(source=SOURCE, file=file.name[-200:], digest=digest, **told)


def _clip(file: MotionFile, poses: MocapPoses, provenance: Provenance, reason: str) -> MocapClip:
    """Return what a story keeps of a clip. Raises InputError for one that ends in another posture."""
    low = poses.hips[:, 2] < UPRIGHT
    seated = bool(low.mean() > 0.5) if file.seated is None else file.seated
    if not seated and (low[0] or low[-1]):
        where = "begins" if low[0] else "ends"
        raise InputError(f"it {where} on the floor or on a seat", mend='say posture = "sit" in motions.toml, or cut it')
    if poses.travel * LEG > FURTHEST:
        raise InputError(f"it travels {poses.travel * LEG:.0f} m, which is farther than a set is wide")
    x, y = poses.root[-1, :2]
    return MocapClip(
        digest=poses.digest,
        name=file.called,
        seconds=round(poses.seconds, 3),
        travel=round(poses.travel * LEG, 3),
        way=round(float(np.degrees(np.arctan2(x, -y))), 1) if poses.travel > 0 else 0.0,
        turns=round(float(np.degrees(poses.root[-1, 2])), 1),
        seated=seated,
        loops=poses.loops,
        provenance=provenance,
        reason=reason[:200],
    )
