"""The doctor's findings name what is missing and the line that mends it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from storyblender import doctor


def test_missing_libraries_are_named_by_their_packages() -> None:
    def load(name: str) -> None:
        if name == "libSM.so.6":
            raise OSError(name)

    finding = doctor.check_libraries(load)
    assert not finding.healthy and "libsm6" in finding.mend and "libx11-6" not in finding.mend


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
