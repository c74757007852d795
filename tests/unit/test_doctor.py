"""The doctor's findings name what is missing and the line that mends it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from storyblender import doctor


@pytest.mark.parametrize(
    ("manager", "line"),
    [
        ("apt-get", "apt-get install -y libsm6 libegl-mesa0 libgl1-mesa-dri"),
        ("dnf", "dnf install -y libSM mesa-libEGL mesa-dri-drivers"),
        ("zypper", "install what this system calls libSM, mesa-libEGL, mesa-dri-drivers"),
    ],
)
def test_missing_libraries_are_installed_by_the_line_of_this_system(
    manager: str, line: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def load(name: str) -> None:
        if name == "libSM.so.6":
            raise OSError(name)

    monkeypatch.setattr(doctor.shutil, "which", lambda name: name if name == manager else None)
    monkeypatch.setattr(doctor.platform, "system", lambda: "Linux")
    finding = doctor.check_libraries(load)
    assert (finding.healthy, finding.says, finding.mend) == (False, "missing libSM.so.6", line)


def test_another_python_is_bad() -> None:
    assert doctor.check_python((3, 11)).healthy and not doctor.check_python((3, 12)).healthy


def test_a_probe_that_draws_nothing_is_bad(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        assert command[1:3] == ["-m", "storyblender.blender.probe"]
        return subprocess.CompletedProcess(command, 1, "", "ImportError: libEGL.so.1")

    monkeypatch.setattr(subprocess, "run", fails)
    assert not doctor.check_drawing().healthy
    assert "libEGL.so.1" in doctor.check_blender().says


@pytest.mark.blender
def test_a_real_probe_imports_and_draws(tmp_path: Path) -> None:
    assert doctor.check_blender().says.startswith("bpy ")
    assert doctor.check_drawing().healthy


def test_services_without_a_key_are_told_and_are_no_fault() -> None:
    found = doctor.check_services({"SKETCHFAB_API_TOKEN": "secret", "TENCENTCLOUD_SECRET_ID": "half"}.get)
    free, has, lacks, own = found.says.split("; ")
    assert found.healthy and free == "poly_haven needs no key" and has == "there is a key for sketchfab"
    assert "openai (OPENAI_API_KEY)" in lacks and "(TENCENTCLOUD_SECRET_KEY)" in lacks and "secret" not in found.says
    assert "trellis@http://" in own
