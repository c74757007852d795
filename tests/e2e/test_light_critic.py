"""The vision critic of light looks at real pictures: darker is darker, and the pack is not built twice."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.e2e.conftest import SMALL, made, storyblender

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(600)]

SCRIPT = """INT. CAFE - DAY

ANNA (30, grey coat) sits at a table.

ANNA
You came alone.
"""


def test_the_next_picture_is_as_the_critic_asked(tmp_path: Path) -> None:
    script, project, box = tmp_path / "bar.fountain", tmp_path / "p", tmp_path / "box"
    script.write_text(SCRIPT)
    arguments = [script, "--out", project, *SMALL, "--no-animatic", "--crew", f"rules,light_critic=ask:{box}"]
    darker = {"score": 4, "faults": [{"message": "as light as a shop", "operations": ["set_darker", "cooler"]}]}
    lighter = {"score": 6, "faults": [{"message": "too dark now", "operations": ["set_lighter", "warmer"]}]}
    levels: list[float] = []
    blue: list[float] = []
    seen: set[Path] = set()
    for answer in (darker, lighter, {"score": 9}):
        assert storyblender("make", *arguments).returncode != 0
        (request,) = (path for path in box.glob("*.request.md") if path not in seen)
        picture = np.asarray(Image.open(request.with_name(request.name.replace("request.md", "1.shot_1.png"))), float)
        levels.append(float(picture.mean()))
        blue.append(float(picture[..., 2].mean() / picture[..., 0].mean()))
        request.with_name(request.name.replace("request.md", "answer.json")).write_text(json.dumps(answer))
        seen.add(request)
    made(arguments)
    assert levels[0] > 1.1 * levels[1], levels
    assert levels[2] == pytest.approx(levels[0], rel=0.02), levels
    assert blue[0] < 0.9 * blue[1]
    assert len([*(project / "build/scenes").glob("*.blend")]) == 1
