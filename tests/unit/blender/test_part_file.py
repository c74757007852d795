"""A file that several workers write at once is whole, whoever ends last."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from storyblender.blender.part_file import part_file

OTHER = """
import sys
from pathlib import Path
from storyblender.blender.part_file import part_file
with part_file(Path(sys.argv[1])) as part:
    part.write_text("the other worker's")
"""


def test_another_process_has_another_part_file(tmp_path: Path) -> None:
    path = tmp_path / "0123456789abcdef.blend"
    with part_file(path) as part:
        part.write_text("half")
        subprocess.run([sys.executable, "-c", OTHER, str(path)], check=True, timeout=60)
        assert path.read_text() == "the other worker's"
        part.write_text("whole")
    assert path.read_text() == "whole"
    assert part.suffix == ".blend", "Blender adds it where it is missing"
    assert list(tmp_path.iterdir()) == [path]


def test_what_fails_leaves_the_former_file_and_no_part(tmp_path: Path) -> None:
    path = tmp_path / "body.npz"
    path.write_text("former")
    with pytest.raises(OSError, match="full"), part_file(path) as part:
        part.write_text("ha")
        raise OSError("full")
    assert path.read_text() == "former"
    assert list(tmp_path.iterdir()) == [path]
