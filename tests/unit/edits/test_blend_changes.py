"""Changes in a story's file, found by its values alone: each kind is told as that kind, and nothing else."""

from __future__ import annotations

import random

import pytest

from storyblender.edits.blend_changes import changes_of
from storyblender.memory.blend_values import (
    BlendReading,
    BlendValues,
    CameraValues,
    CurveValues,
    LampValues,
    NodeValues,
    PoseValues,
    SceneValues,
    StripValues,
    SurfaceValues,
)

CURVES = CurveValues(keys=12, frames="f", values="v")
POSE = PoseValues(frame=1, location=(0, -4, 1.6), rotation=(0.7071, 0.7071, 0, 0), lens=35)


def node(node_id: str, kind: str = "prop", **more: object) -> NodeValues:
    name = f"SC010.{node_id}"
    values = {
        "name": name, "kind": kind, "node_id": node_id, "asset_id": node_id, "origin": name,
        "animated": False, "location": (1, 2, 0), "rotation": (0, 0, 30), "scale": (1, 1, 1),
    }  # fmt: skip
    return NodeValues.model_validate(values | more)


CHAIR, TABLE = node("chair", materials=("Wood",)), node("table")
LAMP = node("lamp", "light", lamp=LampValues(power=40, color=(1, 0.9, 0.8)))
CAMERA = node(
    "sh010", "camera", name="SC010_SH010", origin="SC010_SH010",
    camera=CameraValues(poses=(POSE,), between=(), path="m", f_number=4, blurs=False),
)  # fmt: skip
STRIP = StripValues(name="SC010_SH010", start=1, end=49, curves=CURVES)
ADA = node("ada", "character", animated=True, strips=(STRIP,), posing="p")
NODES = (CHAIR, TABLE, LAMP, CAMERA, ADA)
MARKERS = {"SC010_SH010": 1, "SC010_SH020": 49, "SC010_SH030": 97}


def found(*nodes: NodeValues, markers: dict[str, int] = MARKERS, paint: float = 0.5) -> list[tuple[str, str]]:
    def values(nodes: tuple[NodeValues, ...], markers: dict[str, int], paint: float) -> BlendValues:
        scene = SceneValues(name="SC010", nodes=nodes, markers=markers, end=144)
        wood = SurfaceValues(name="wood", color=(paint, 0.2, 0.1), roughness=0.5, metallic=0, base="plain")
        return BlendValues(version="3.ab", scenes=(scene,), surfaces={"Wood": wood})

    reading = BlendReading(compiled=values(NODES, MARKERS, 0.5), saved=values(nodes, markers, paint))
    return [(change.kind, change.subject) for change in changes_of(reading)]


def with_(node: NodeValues, **update: object) -> tuple[NodeValues, ...]:
    return tuple(each.model_copy(update=update) if each is node else each for each in NODES)


def test_a_file_without_an_edit_has_no_difference() -> None:
    assert found(*NODES) == []


def test_what_single_precision_leaves_is_no_difference() -> None:
    chance = random.Random(3)
    for _ in range(50):
        shifted = tuple(part + chance.uniform(-1e-5, 1e-5) for part in CHAIR.location)
        rotation = tuple(part + chance.uniform(-1e-6, 1e-6) for part in POSE.rotation)
        camera = CAMERA.camera and CAMERA.camera.model_copy(
            update={"poses": (POSE.model_copy(update={"rotation": rotation}),)}
        )
        nodes = [each.model_copy(update={"location": shifted}) if each is CHAIR else each for each in NODES]
        nodes = [each.model_copy(update={"camera": camera}) if each is CAMERA else each for each in nodes]
        assert found(*nodes) == []


CAMERA_VALUES = CAMERA.camera or CameraValues(poses=(), between=(), f_number=1, blurs=False)
NEARER = POSE.model_copy(update={"location": (0, -3, 1.6)})
KEYED = CURVES.model_copy(update={"keys": 13})


@pytest.mark.parametrize(
    ("nodes", "kind", "subject"),
    [
        (with_(CHAIR, location=(1.2, 2, 0)), "moved", "chair"),
        (with_(CHAIR, rotation=(0, 0, 75)), "turned", "chair"),
        (with_(CHAIR, scale=(1.5, 1.5, 1.5)), "scaled", "chair"),
        (with_(CHAIR, name="SC010.throne"), "renamed", "chair"),
        (tuple(each for each in NODES if each is not CHAIR), "deleted", "chair"),
        ((*NODES, CHAIR.model_copy(update={"name": "SC010.chair.001", "location": (3, 2, 0)})), "duplicated", "chair"),
        ((*NODES, node("Cube", "", name="Cube", origin="")), "added", "Cube"),
        (
            with_(CAMERA, camera=CAMERA_VALUES.model_copy(update={"poses": (POSE.model_copy(update={"lens": 50}),)})),
            "lens", "SC010_SH010",
        ),
        (with_(CAMERA, camera=CAMERA_VALUES.model_copy(update={"poses": (NEARER,)})), "camera", "SC010_SH010"),
        (with_(CAMERA, camera=CAMERA_VALUES.model_copy(update={"f_number": 1.4})), "aperture", "SC010_SH010"),
        (with_(CAMERA, camera=CAMERA_VALUES.model_copy(update={"path": "n"})), "unknown", "SC010_SH010"),
        (with_(LAMP, lamp=LampValues(power=80, color=(1, 0.9, 0.8))), "lamp", "lamp"),
        (with_(ADA, strips=(STRIP.model_copy(update={"start": 9}),)), "strip", "ada"),
        (with_(ADA, strips=(STRIP.model_copy(update={"curves": KEYED}),)), "keys added", "ada"),
        (
            with_(ADA, strips=(STRIP.model_copy(update={"curves": CURVES.model_copy(update={"frames": "g"})}),)),
            "keys retimed", "ada",
        ),
        (
            with_(ADA, strips=(STRIP.model_copy(update={"curves": CURVES.model_copy(update={"values": "w"})}),)),
            "posed", "ada",
        ),
        (with_(ADA, posing="q"), "posed", "ada"),
        (with_(ADA, location=(9, 9, 9)), "", ""),
    ],
)  # fmt: skip
def test_each_kind_of_change_is_told_as_that_alone(nodes: tuple[NodeValues, ...], kind: str, subject: str) -> None:
    assert found(*nodes) == ([(kind, subject)] if kind else [])


def test_a_marker_makes_one_shot_longer_and_the_next_shorter() -> None:
    assert found(*NODES, markers=MARKERS | {"SC010_SH020": 61}) == [("marker", "SC010_SH020")]
    assert found(*NODES, markers={"SC010_SH010": 1, "SC010_SH030": 97}) == [("unknown", "SC010")]


def test_a_colour_is_told_of_its_material() -> None:
    assert found(*NODES, paint=0.9) == [("material", "wood")]


def test_a_file_of_an_early_version_says_nothing() -> None:
    values = BlendValues(version="", scenes=())
    assert changes_of(BlendReading(compiled=None, saved=values)) == []
