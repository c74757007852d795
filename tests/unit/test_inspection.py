"""The rows of a check that need no Blender: layout by kind, framing, cuts."""

from __future__ import annotations

from concurrent.futures import Future
from typing import TypeVar, cast

from storyblender.inspection import REACH, Inspection, inspect
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.memory.scene_context import (
    Environment,
    Layout,
    LayoutObject,
    SceneContext,
    SceneSetup,
    SceneSize,
)
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, Flaw, ShotContext
from storyblender.pipeline.reviewing import FrameReview
from storyblender.ports import Engine
from storyblender.reflection import Fault

T = TypeVar("T")
POSE = CameraPose(pivot=(0, 0, 0), rotation=(1, 0, 0, 0), distance=2, lens=35)
DESK = CanonicalAsset(source="catalog", key="desk", dimensions=(1.6, 0.8, 0.76), digest="d", geometry_hash="g")


def report(*flaws: Flaw, second: tuple[float, float, float] = (1, 0, 0)) -> Inspection:
    """Inspect two desks and one shot, whose camera left these flaws."""
    desks = (
        LayoutObject(node_id="desk_1", asset_id="desk", location=(-1, 0, 0)),
        LayoutObject(node_id="desk_2", asset_id="desk", location=second),
    )
    size = SceneSize(x=4, x_negative=-4, y=4, y_negative=-4)
    scene = SceneContext(
        scene_id=1,
        setup=SceneSetup(asset_ids=("desk",)),
        environment=Environment(kit="room"),
        layout=Layout(scene_size=size, objects=desks),
    )
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        camera_instruction=CameraInstruction(size="MS", kind="single"),
        camera=CameraState(poses=(POSE,), residual=flaws),
    )
    desk = Asset(asset_id="desk", asset_type="object", name="desk", description="a desk", canonical=DESK)
    graph = ContinuityMemoryGraph(assets=(desk,), scenes=(scene,), shots=(shot,))
    return inspect(graph, cast(Engine, None), [], {})


def staged(*problems: Flaw) -> Inspection:
    """Inspect a story of nothing but a pack with these problems."""
    pack = PackRef(scene_id=1, path="build/scenes/SC010-0.blend", starts=((1, 1),), problems=problems)
    return inspect(ContinuityMemoryGraph(), cast(Engine, Blind()), [pack], {})


class Blind:
    """An engine that sees nothing wrong."""

    def look(self, *_: object) -> Future[list[object]]:
        return self._answer([])

    read_figures = look

    def find_collisions(self, pack: PackRef) -> Future[list[object]]:
        return self._answer([])

    def measure_drift(self, pack: PackRef) -> Future[float]:
        return self._answer(0.0)

    def _answer(self, value: T) -> Future[T]:
        future: Future[T] = Future()
        future.set_result(value)
        return future


def value(inspection: Inspection, name: str) -> tuple[str, bool]:
    return next((row.value, row.ok) for row in inspection.rows if row.name == name)


def test_a_long_story_says_how_many_scenes_are_checked() -> None:
    packs = [PackRef(scene_id=number, path="build/scenes/a.blend", starts=((1, 1),)) for number in (1, 2)]
    told: list[tuple[int, int, str]] = []
    inspect(ContinuityMemoryGraph(), cast(Engine, Blind()), packs, {}, lambda *step: told.append(step))
    assert told == [(0, 2, "SC010"), (1, 2, "SC020"), (2, 2, "")]


def test_layout_violations_are_counted_by_kind() -> None:
    assert value(report(), "layout violations") == ("0", True)
    crowded = report(second=(-0.5, 0.2, 0))
    assert value(crowded, "layout violations") == ("1 (penetration 1)", False)
    assert not crowded.clean and "the desk" in crowded.findings[0]


def test_framing_and_cuts_are_told_where_a_director_would_mind() -> None:
    minded = (Flaw(kind="void", weight=4, message="40% shows nothing"), Flaw(kind="jump", weight=0.5, message="like"))
    assert value(report(*minded), "framing") == ("1", False)
    assert report(*minded).findings == ("SC010_SH010: 40% shows nothing",)
    assert value(report(*minded), "jump cuts and eyelines") == ("0", True)
    apart = report(Flaw(kind="eyeline", weight=1.5, message="both look left"))
    assert (value(apart, "jump cuts and eyelines"), value(apart, "framing")) == (("1", False), ("0", True))


def test_a_hand_that_misses_by_half_a_metre_is_not_ok() -> None:
    def miss(metres: float) -> Flaw:
        message = f"ada's hand misses cup by {metres:.2f} m"
        return Flaw(kind="unreachable", subject="ada", weight=metres, message=message, shot="SC010_SH030")

    near, far = staged(miss(REACH - 0.01)), staged(miss(REACH - 0.01), miss(0.5))
    assert value(near, "hands off their target") == ("0", True)
    assert (value(far, "hands off their target"), far.clean) == (("1 (up to 0.50 m)", False), False)
    assert "SC010_SH030: ada's hand misses cup by 0.50 m" in far.findings
    assert len(far.findings) == 2, "each is told once"


def test_a_frame_that_does_not_tell_its_lines_is_a_finding() -> None:
    fault = Fault(kind="person_missing", subject="ada", severity=4, message="ada is not seen")
    poor = FrameReview(shot="SC010_SH010", judged="", score=6.0, faults=(fault,))
    good = FrameReview(shot="SC010_SH020", judged="", score=10.0)
    reviews = {review.shot: review for review in (poor, good)}
    report = inspect(ContinuityMemoryGraph(), cast(Engine, Blind()), [], reviews)
    row = next(row for row in report.rows if row.name == "frames that tell their lines")
    assert (row.value, row.ok) == ("1 of 2", False)
    assert any("ada is not seen" in finding for finding in report.findings)
