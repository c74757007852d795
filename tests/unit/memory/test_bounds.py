"""Every stored number has bounds: what Blender cannot take is refused where the graph is read, in one sentence."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

import pytest
from pydantic import BaseModel, ValidationError

from storyblender.errors import InputError, Rejected
from storyblender.memory.base import Frozen
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraInstruction, CameraPose, ShotContext
from storyblender.project import Project, read_project_graph

RELEASED = Path(__file__).parents[2] / "data" / "projects" / "schema-1" / "graph.json"


def models(root: type[BaseModel], seen: set[type[BaseModel]]) -> set[type[BaseModel]]:
    if root not in seen:
        seen.add(root)
        for field in root.model_fields.values():
            for model in _models_in(field.annotation):
                models(model, seen)
    return seen


def _models_in(kind: Any) -> Iterator[type[BaseModel]]:
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        yield kind
    for part in get_args(kind):
        yield from _models_in(part)


def test_no_number_of_the_graph_is_infinite() -> None:
    for model in models(ContinuityMemoryGraph, set()):
        assert issubclass(model, Frozen) and model.model_config.get("allow_inf_nan") is False, model


@pytest.mark.parametrize("field", ["fps", "aspect", "width", "sensor_width"])
@pytest.mark.parametrize("value", [0, -1, 10**9, math.nan, math.inf])
def test_no_picture_has_such_a_format(field: str, value: float) -> None:
    with pytest.raises(ValidationError):
        ContinuityMemoryGraph.model_validate({"format": {field: value}})


@pytest.mark.parametrize(
    "change",
    [
        {"duration": 0}, {"duration": 10**9}, {"scene_id": 0}, {"scene_id": 10**6}, {"shot_id": -1},
        {"shot_id": True, "duration": "long"}, {"cues": [{"asset_id": "a", "clip": "walk", "start": 10**9}]},
    ],
)  # fmt: skip
def test_no_shot_is_like_that(change: dict[str, Any]) -> None:
    shot = ShotContext(scene_id=1, shot_id=1, camera_instruction=CameraInstruction()).model_dump()
    with pytest.raises(ValidationError):
        ShotContext.model_validate(shot | change)


@pytest.mark.parametrize("rotation", [(0, 0, 0, 0), (2, 0, 0, 0), (1, 1, 0, 0)])
def test_a_camera_is_turned_by_a_unit_quaternion(rotation: tuple[float, ...]) -> None:
    pose = {"pivot": (0, 0, 1), "rotation": (1, 0, 0, 0), "distance": 2, "lens": 50}
    assert CameraPose.model_validate(pose)
    with pytest.raises(ValidationError):
        CameraPose.model_validate(pose | {"rotation": rotation})


def _twice(body: dict[str, Any], layer: str) -> dict[str, Any]:
    return body | {layer: [*body[layer], body[layer][0]]}


@pytest.mark.parametrize(
    ("layer", "says"),
    [
        ("shots", "shot '1/1' exists twice"),
        ("scenes", "scene '1' exists twice"),
        ("assets", "asset 'ada' exists twice"),
        ("outline", "outline of scene '1' exists twice"),
    ],
)
def test_nothing_is_there_twice(tmp_path: Path, layer: str, says: str) -> None:
    (tmp_path / "graph.json").write_text(json.dumps(_twice(json.loads(RELEASED.read_text()), layer)))
    with pytest.raises(InputError, match=says):
        read_project_graph(tmp_path)


def test_every_shot_of_the_outline_exists(tmp_path: Path) -> None:
    body = json.loads(RELEASED.read_text())
    body["outline"][0]["shots"][1]["shot_id"] = 77
    (tmp_path / "graph.json").write_text(json.dumps(body))
    with pytest.raises(InputError, match="the outline has shot 1/77, which does not exist"):
        read_project_graph(tmp_path)


def test_what_is_out_of_bounds_never_enters_the_history(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        body = json.loads(RELEASED.read_text())
        graph = ContinuityMemoryGraph.model_validate(
            {key: body[key] for key in ("outline", "assets", "scenes", "shots")}
        )
        project.commit(graph, "director", "plans")
        bad = graph.shots[0].model_copy(update={"duration": 10**9})
        with pytest.raises(Rejected):
            project.commit(replace(project.graph, bad), "animator", "nonsense")
        assert project.revision == 1
    assert read_project_graph(tmp_path / "p").shots == graph.shots


def test_the_sentence_names_the_field(tmp_path: Path) -> None:
    body = json.loads(RELEASED.read_text())
    body["shots"][2]["duration"] = 10**9
    (tmp_path / "graph.json").write_text(json.dumps(body))
    with pytest.raises(
        InputError, match=r"graph.json: cannot be read .*shots.2.duration: .*less than or equal to 432000"
    ):
        read_project_graph(tmp_path)
