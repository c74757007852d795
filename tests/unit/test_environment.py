"""The first command of a newcomer: without Python 3.11 uv is taken, and without uv the exact line is said."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts" / "environment.sh"


def run(tmp_path: Path, release: str = "", system: str = "Linux", **programs: str) -> subprocess.CompletedProcess[str]:
    """Run the script on a machine that has these programs and no others."""
    (tmp_path / "os-release").write_text(release)
    for name, body in {"uname": f"echo {system}", **programs}.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{body}\n")
        (tmp_path / name).chmod(0o755)
    command = [str(shutil.which("sh")), str(SCRIPT), "python3.11", "made", str(tmp_path / "os-release")]
    return subprocess.run(
        command, env={"PATH": str(tmp_path)}, cwd=tmp_path, capture_output=True, text=True, timeout=30, check=False
    )


def test_an_installed_python_is_taken_first(tmp_path: Path) -> None:
    done = run(tmp_path, **{"python3.11": 'echo "python $*"', "uv": "exit 1"})
    assert (done.returncode, done.stdout) == (0, "python -m venv made\n")


def test_a_python_without_venv_is_told_apart(tmp_path: Path) -> None:
    done = run(tmp_path, **{"python3.11": "exit 1"})
    assert done.returncode == 2 and "sudo apt-get install -y python3.11-venv" in done.stdout


def test_uv_is_taken_where_there_is_no_python(tmp_path: Path) -> None:
    done = run(tmp_path, uv='echo "uv $*"')
    assert (done.returncode, done.stdout) == (0, "uv venv --quiet --seed --python 3.11 made\n")


@pytest.mark.parametrize(
    ("system", "release", "line"),
    [
        ("Linux", 'ID=debian\nVERSION_ID="12"', "sudo apt-get install -y python3.11 python3.11-venv"),
        ("Linux", 'ID=ubuntu\nVERSION_ID="22.04"', "sudo apt-get install -y python3.11 python3.11-venv"),
        ("Linux", 'ID=ubuntu\nID_LIKE=debian\nVERSION_ID="24.04"', "ppa:deadsnakes/ppa"),
        ("Linux", "ID=fedora\nVERSION_ID=42", "sudo dnf install -y python3.11"),
        ("Linux", 'ID=debian\nVERSION_ID="13"', "install uv"),
        ("Linux", "", "install uv"),
        ("Darwin", "", "brew install python@3.11"),
        ("MINGW64_NT-10.0", "", "winget install Python.Python.3.11"),
    ],
)
def test_the_line_for_this_system_is_said(tmp_path: Path, system: str, release: str, line: str) -> None:
    done = run(tmp_path, release, system)
    assert done.returncode == 2 and line in done.stdout and "PYTHON=/path/to/python3.11" in done.stdout
    assert not (tmp_path / "made").exists() and done.stderr == ""
