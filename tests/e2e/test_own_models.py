"""A model of the user whose file faces another way than it should: who looks at it sees so, and it stands right."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from storyblender.project import read_project_graph
from tests.e2e.conftest import SMALL, made, storyblender
from tests.model_files import write_cabinet

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(600)]
bpy = pytest.importorskip("bpy")

SCRIPT = """INT. KITCHEN - DAY

ADA (60, blue cardigan) sits at the table. A radio stands by the wall.

ADA
Listen.
"""


def test_front_and_size_of_a_model_are_as_the_answers_see_them(tmp_path: Path) -> None:
    script, project, box = tmp_path / "radio.fountain", tmp_path / "p", tmp_path / "box"
    script.write_text(SCRIPT)
    (tmp_path / "models").mkdir()
    write_cabinet(tmp_path / "models")
    arguments = [script, "--out", project, "--models", tmp_path / "models", *SMALL, "--no-animatic"]
    arguments += ["--crew", f"rules,asset_formatter=ask:{box},dimension_estimator=ask:{box}"]
    answers: dict[str, Any] = {
        "asset_formatter": {"front": "A", "top": "E"},
        "dimension_estimator": {"sizes": [{"id": "radio", "side": "width", "metres": 0.4}]},
    }
    for role, answer in answers.items():
        assert storyblender("make", *arguments).returncode != 0
        (request,) = box.glob(f"{role}-*.request.md")
        assert len(list(box.glob(f"{role}-*.png"))) == 1
        request.with_name(request.name.replace("request.md", "answer.json")).write_text(json.dumps(answer))
    made(arguments)
    graph = read_project_graph(project)
    (radio,) = (asset for asset in graph.assets if asset.canonical and asset.canonical.key == "radio.obj")
    assert radio.canonical is not None and radio.canonical.params["front"] == "right"
    assert radio.canonical.dimensions == pytest.approx((0.4, 0.28, 0.3), abs=0.002), "its file is 0.56 x 0.8 x 0.6"

    bpy.ops.wm.open_mainfile(filepath=str(project / "story.blend"))
    things = bpy.data.scenes["SC010"].objects
    thing = next(obj for obj in things if obj.get("asset_id") == radio.asset_id and obj.type == "MESH")
    red = [
        np.array(thing.matrix_basis @ face.center)
        for face in thing.data.polygons
        if thing.data.materials[face.material_index].diffuse_color[0] > 0.5
    ]
    layout = graph.scene(1).layout
    assert layout is not None
    place = next(item for item in layout.objects if item.asset_id == radio.asset_id)
    way = np.mean(red, axis=0) - np.array(thing.matrix_basis.translation)
    yaw = math.radians(place.rotation[2])
    assert way[:2] @ (math.sin(yaw), -math.cos(yaw)) > 0.05, "its dial is on the side that it faces with"
