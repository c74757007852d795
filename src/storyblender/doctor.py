"""The doctor: is this machine able to run StoryBlender, do the models of a crew answer, and if not, what mends it."""

from __future__ import annotations

import ctypes
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from threading import Event as Signal
from typing import TYPE_CHECKING, Final, get_args

from pydantic import BaseModel

from storyblender.agents.asking import Asker
from storyblender.catalog.bodies import body_pack_path
from storyblender.crew_setting import Player, players
from storyblender.deliver.fonts import font_file
from storyblender.errors import InputError, NoAnswer
from storyblender.keys import key_names, known_key
from storyblender.language.answerers import provider_class
from storyblender.language.budget import Budget
from storyblender.memory.request import Picture
from storyblender.service_setting import ServiceName

if TYPE_CHECKING:
    from storyblender.language.provider import Provider

SYSTEM_LIBRARIES = {
    "libX11.so.6": ("libx11-6", "libX11"),
    "libXext.so.6": ("libxext6", "libXext"),
    "libXrender.so.1": ("libxrender1", "libXrender"),
    "libXfixes.so.3": ("libxfixes3", "libXfixes"),
    "libXi.so.6": ("libxi6", "libXi"),
    "libxkbcommon.so.0": ("libxkbcommon0", "libxkbcommon"),
    "libSM.so.6": ("libsm6", "libSM"),
    "libICE.so.6": ("libice6", "libICE"),
    "libGL.so.1": ("libgl1", "libglvnd-glx"),
    "libEGL.so.1": ("libegl1", "libglvnd-egl"),
}
"""What bpy loads on Linux, and the packages of Debian and of Fedora that have it."""

DRIVERS = (("libegl-mesa0", "mesa-libEGL"), ("libgl1-mesa-dri", "mesa-dri-drivers"))
"""What draws without a graphics card, as Debian and Fedora call it."""
LEAST_DISK = 2 * 1024**3


@dataclass(frozen=True)
class Finding:
    """One check.

    Attributes:
        name: What was checked.
        healthy: Whether it is as it should be.
        says: What was found.
        mend: The command that mends it.
    """

    name: str
    healthy: bool
    says: str
    mend: str = ""


def examine(folder: Path | None = None) -> list[Finding]:
    """Run every check.

    Args:
        folder: Where projects will be written; the current folder if not given.
    """
    libraries = check_libraries()
    findings = [check_python(), libraries]
    if libraries.healthy:
        findings.append(check_blender())
        findings.append(check_drawing())
    return [*findings, check_people(), check_fonts(), check_disk(folder or Path.cwd()), check_services()]


def examine_crew(setting: str) -> list[Finding]:
    """Ask every player of a crew for something small.

    Args:
        setting: As ``--crew`` has it.

    Raises:
        InputError: It is no such setting, or the extra ``crew`` is not installed.
    """
    try:
        found = players(setting)
    except ValueError as error:
        raise InputError(f"--crew cannot be {setting!r}", mend=str(error)) from error
    return [check_player(player) for player in dict.fromkeys(found.values())]


def check_player(player: Player) -> Finding:
    """Whether a player answers; of a model also in which form, how fast, for how many tokens, and if it can see.

    Raises:
        InputError: The extra ``crew`` is not installed.
    """
    name = ":".join(part for part in (player.kind, player.where) if part)
    if player.kind == "rules":
        return Finding(name, True, "play without a model")
    if player.kind == "ask":
        return Finding(name, True, f"`storyblender answer {player.where}` will list what waits for an answer")
    if player.kind == "replay":
        there = Path(player.where).is_dir()
        return Finding(name, there, "the recording is there" if there else "there is no such folder")
    make, budget, name = provider_class(), Budget({}), f"{player.where}:{player.model}"
    try:
        provider = make(player, budget, Signal(), pause=2.0, timeout=120.0)
        began = time.monotonic()
        _asked_for_color(provider, ())
        took, tokens = time.monotonic() - began, budget.spent["tokens"]
    except (InputError, NoAnswer) as error:
        mend = "" if isinstance(error, NoAnswer) else error.mend
        says = error.problem.removeprefix(f"{name} did not answer: ").removeprefix("doctor question: ")
        wrong = says.startswith("no answer of the right form")
        return Finding(name, False, says, "take a larger model: small ones cannot direct" if wrong else mend)
    says = f"answers in the {provider.form} form, {took:.1f} s, {tokens:.0f} tokens"
    return Finding(name, True, f"{says}, {'sees' if _sees(provider) else 'does not see'} pictures")


_COLORS: Final = {"teal": (0, 128, 128), "orange": (255, 140, 0)}
"""What pictures show a model that may be able to see."""


class _Counted(BaseModel):
    """What a model is asked for."""

    number: int
    color: str = ""
    """Of the picture: teal, orange, violet, black, white or none."""


def _asked_for_color(provider: Provider, pictures: tuple[Picture, ...]) -> str:
    """Return the colour that a model sees. Raises NoAnswer."""
    question = {"question": "A house has two doors and a shed has one. How many doors are there?"}
    return Asker(provider, "doctor", _Counted).ask("question", question, pictures=pictures).color.lower()


def _sees(provider: Provider) -> bool:
    """Whether a model knows the colours of pictures."""
    from PIL import Image

    for name, color in _COLORS.items():
        png = BytesIO()
        Image.new("RGB", (64, 64), color).save(png, "PNG")
        try:
            seen = _asked_for_color(provider, (Picture(name="picture", png=png.getvalue()),))
        except NoAnswer:
            return False
        if name not in seen:
            return False
    return True


def check_python(version: tuple[int, int] = sys.version_info[:2]) -> Finding:
    """bpy is built for exactly one Python."""
    says = f"Python {version[0]}.{version[1]}"
    return Finding("Python", version == (3, 11), says, "" if version == (3, 11) else "use Python 3.11")


def check_libraries(load: Callable[[str], object] = ctypes.CDLL) -> Finding:
    """The shared libraries that Blender needs.

    Args:
        load: Loads a library by its name, raising OSError if it is missing.
    """
    if platform.system() != "Linux":
        return Finding("System libraries", True, f"{platform.system()} brings its own")
    missing = []
    for library in SYSTEM_LIBRARIES:
        try:
            load(library)
        except OSError:
            missing.append(library)
    if not missing:
        return Finding("System libraries", True, f"all {len(SYSTEM_LIBRARIES)} found")
    return Finding("System libraries", False, f"missing {', '.join(missing)}", install_line(missing))


def check_blender() -> Finding:
    """Blender's module, imported in a process of its own."""
    done = _probe()
    if done.returncode == 0:
        return Finding("Blender", True, f"bpy {done.stdout.strip().splitlines()[-1]}")
    reason = (done.stderr.strip().splitlines() or ["no reason given"])[-1]
    return Finding("Blender", False, f"bpy cannot be imported: {reason}", install_line(SYSTEM_LIBRARIES))


def check_drawing() -> Finding:
    """A real picture in a process of its own: without EGL Blender aborts instead of raising."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "probe.png"
        done = _probe(str(picture))
        if done.returncode == 0 and picture.exists():
            return Finding("Drawing", True, "Workbench draws without a window")
    return Finding("Drawing", False, f"Workbench failed ({done.returncode})", install_line(["libEGL.so.1"]))


def check_people() -> Finding:
    """The data that people are built from."""
    pack = body_pack_path(os.environ, Path.home())
    if pack.is_file():
        return Finding("Body data", True, str(pack))
    return Finding("Body data", False, "not fetched yet", f"{sys.executable} -m storyblender.library.body_data")


def check_services(key: Callable[[str], str] = known_key) -> Finding:
    """Which services have their key, and how a server of one's own is named; none is asked.

    Args:
        key: Returns a key by its name, empty if there is none.
    """
    if find_spec("httpx2") is None or find_spec("tenacity") is None:
        mend = 'pip install "storyblender[services]"'
        return Finding("Services", True, "what services need is not installed", mend)
    names = [name for name in get_args(ServiceName) if name != "trellis"]
    missing = {name: [each for each in key_names(name) if not key(each)] for name in names}
    free = [name for name in names if not key_names(name)]
    ready = [name for name, keys in missing.items() if not keys and name not in free]
    lacks = [f"{name} ({', '.join(keys)})" for name, keys in missing.items() if keys]
    said = [
        f"{', '.join(free)} needs no key",
        *([f"there is a key for {', '.join(ready)}"] if ready else []),
        *([f"there is no key for {', '.join(lacks)}"] if lacks else []),
        "trellis is a server of your own, named with its address: trellis@http://127.0.0.1:6006",
    ]
    return Finding("Services", True, "; ".join(said))


def check_fonts() -> Finding:
    """The font of boards and slates."""
    path = font_file()
    return Finding("Fonts", path.is_file(), path.name, "" if path.is_file() else "pip install fontpkg-noto-sans")


def check_disk(folder: Path) -> Finding:
    """Room for frames."""
    free = shutil.disk_usage(folder).free
    says = f"{free / 1024**3:.1f} GiB free"
    return Finding("Disk", free >= LEAST_DISK, says, "" if free >= LEAST_DISK else "free at least 2 GiB")


def install_line(libraries: Iterable[str]) -> str:
    """Return the exact line that installs libraries, and the drivers, on this system."""
    packages = [*(SYSTEM_LIBRARIES[library] for library in libraries), *DRIVERS]
    if shutil.which("apt-get"):
        return f"apt-get install -y {' '.join(debian for debian, _ in packages)}"
    if shutil.which("dnf"):
        return f"dnf install -y {' '.join(fedora for _, fedora in packages)}"
    return f"install what this system calls {', '.join(fedora for _, fedora in packages)}"


def _probe(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "storyblender.blender.probe", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
