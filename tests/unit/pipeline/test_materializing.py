"""What assets are made from: a model that cannot be used never stops a run."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import cast
from unittest.mock import MagicMock

import pytest
from tests.crew import crew_of, no_words

from storyblender.agents.concept_artist import asset_retriever_view
from storyblender.agents.concept_artist.asset_formatter import AssetFormatterView, RulesAssetFormatter
from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.agents.director.size_words import stated_size
from storyblender.agents.layout_artist.dimension_estimator import DimensionEstimatorView, RulesDimensionEstimator
from storyblender.catalog.recipe import Recipe
from storyblender.errors import EngineError
from storyblender.library.sources import asset_sources
from storyblender.memory.asset_sheet import Asset, AssetDimension, ModelPose
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.run import Run
from storyblender.reflection import Critique, reflect
from storyblender.settings import Settings
from storyblender.trace import Event


class Builder:
    """Measures every asset as a cube, but cannot read any file, or nothing at all."""

    def __init__(self, broken: tuple[str, ...], notes: tuple[str, ...] = ()) -> None:
        self.broken, self.notes = broken, notes

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        done: Future[AssetMeasure] = Future()
        canonical = job.asset.canonical
        assert canonical is not None
        if canonical.source in self.broken:
            done.set_exception(EngineError(f"{canonical.key} cannot be read"))
        else:
            done.set_result(
                AssetMeasure(
                    asset_id=job.asset.asset_id,
                    dimensions=(1, 1, 1),
                    faces=6,
                    digest="d",
                    geometry_hash="g",
                    notes=self.notes if canonical.source == "file" else (),
                )
            )
        return done


def quick_run(
    graph: ContinuityMemoryGraph,
    settings: Settings,
    broken: tuple[str, ...],
    told: list[Event],
    kept: list[Asset],
    notes: tuple[str, ...] = (),
) -> Run:
    """Return a run without a project: what it tells and commits is put into lists."""
    run = SimpleNamespace(
        graph=graph,
        settings=settings,
        services=None,
        library=None,
        engine=Builder(broken, notes),
        outputs=SimpleNamespace(note=lambda name: None),
        tell=told.append,
        progress=lambda *_: None,
        crew=crew_of(settings),
        sources=asset_sources(settings, no_words),
        project=SimpleNamespace(files=None),
        reflect=lambda role, subject, *given: reflect(role, subject, role.project(*given), told.append),
        commit=lambda author, reason, *items: kept.extend(items),
    )
    return cast(Run, run)


def materialized(
    models: Path,
    broken: tuple[str, ...],
    description: str = "a chair",
    notes: tuple[str, ...] = (),
    name: str = "chair",
) -> tuple[list[Asset], list[Event]]:
    told: list[Event] = []
    kept: list[Asset] = []
    size = stated_size(name, description, person=False)
    chair = Asset(asset_id=name, asset_type="object", description=description, name=name, stated_size=size)
    story = ContinuityMemoryGraph(assets=(chair,))
    materialize(quick_run(story, Settings(models=(models,)), broken, told, kept, notes))
    return kept, [event for event in told if event.kind == "warning"]


def test_another_thing_stands_in_for_a_model_that_cannot_be_read(tmp_path: Path) -> None:
    for name in ("chair.glb", "old chair.glb"):
        (tmp_path / name).write_bytes(b"no model")
    assets, warnings = materialized(tmp_path, ("file",))
    assert [(asset.canonical.source, asset.canonical.key) for asset in assets if asset.canonical] == [
        ("catalog", "chair")
    ]
    assert warnings and "chair.glb cannot be read" in warnings[0].message


def test_a_large_model_is_told_before_it_takes_minutes(tmp_path: Path) -> None:
    with (tmp_path / "chair.glb").open("wb") as large:
        large.truncate(40 << 20)
    _, warnings = materialized(tmp_path, ())
    assert [each.message for each in warnings] == ["chair.glb has 40 MB: to read and simplify it may take minutes"]


def test_a_library_that_cannot_be_built_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(EngineError):
        materialized(tmp_path, ("catalog",))


def test_a_model_that_was_changed_is_another_model(tmp_path: Path) -> None:
    digests = []
    for content in (b"one", b"two", b"two"):
        (tmp_path / "chair.glb").write_bytes(content)
        (asset,), _ = materialized(tmp_path, ())
        assert asset.canonical is not None and asset.canonical.source == "file"
        digests.append(AssetJob(asset=asset).digest)
    assert digests[0] != digests[1] == digests[2]


def test_dressing_of_one_more_scene_does_not_look_at_every_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    kits = MagicMock()
    kits.__getitem__.return_value.meanings = {}
    monkeypatch.setattr(asset_retriever_view, "SETS", kits)
    lamp = Asset(asset_id="set_lamp", asset_type="object", description="a lamp", name="lamp", origin="dressing")
    setup = SceneSetup(kit="room", asset_ids=("set_lamp",))
    scenes = tuple(SceneContext(scene_id=number, setup=setup) for number in range(1, 50))
    kept: list[Asset] = []
    run = quick_run(ContinuityMemoryGraph(assets=(lamp,), scenes=scenes), Settings(), (), [], kept)
    materialize(run)
    assert kits.__getitem__.call_count == 1, "only the first place where it stands says something about it"
    assert [asset.asset_id for asset in kept] == ["set_lamp"]


def test_a_model_keeps_its_size_unless_the_script_tells_one(tmp_path: Path) -> None:
    (tmp_path / "chair.glb").write_bytes(b"a model")
    (asset,), _ = materialized(tmp_path, ())
    assert asset.canonical is not None and "told" not in asset.canonical.params
    assert asset.dimension is not None, "what chairs measure tells the unit"
    (asset,), _ = materialized(tmp_path, (), "a chair, 2 m tall")
    assert asset.canonical is not None and asset.canonical.params["told"] is True


def test_what_was_changed_in_a_model_is_said(tmp_path: Path) -> None:
    (tmp_path / "chair.glb").write_bytes(b"a model")
    _, warnings = materialized(tmp_path, (), notes=("chair.glb: it is turned by 90 degrees",))
    assert [event.message for event in warnings] == ["chair.glb: it is turned by 90 degrees"]


def test_nobody_guesses_the_size_of_a_model_of_something_unknown(tmp_path: Path) -> None:
    (tmp_path / "frobnicator.glb").write_bytes(b"a model")
    (asset,), _ = materialized(tmp_path, (), "a frobnicator", name="frobnicator")
    assert asset.canonical is not None and asset.canonical.source == "file" and asset.dimension is None


def test_the_front_of_a_file_is_asked_once_and_kept_with_every_asset_of_it(tmp_path: Path) -> None:
    (tmp_path / "chair.glb").write_bytes(b"a model")
    settings = Settings(models=(tmp_path,))
    chairs = tuple(
        Asset(asset_id=name, asset_type="object", description="a chair", name="chair") for name in ("one", "two")
    )
    poses: list[str] = []

    class Formatter(RulesAssetFormatter):
        def propose(self, view: AssetFormatterView) -> ModelPose:
            poses.append(view.file)
            return ModelPose(front="left", top="top")

    kept: list[Asset] = []
    run = quick_run(ContinuityMemoryGraph(assets=chairs[:1]), settings, (), [], kept)
    role = replace(run.crew.asset_formatter, policies=(Formatter(),))
    run.crew = replace(run.crew, asset_formatter=role)
    materialize(run)
    again = quick_run(ContinuityMemoryGraph(assets=(kept[0], chairs[1])), settings, (), [], kept)
    again.crew = run.crew
    materialize(again, chairs[1:])
    assert poses == ["chair.glb"]
    made = [asset.canonical for asset in kept if asset.canonical]
    assert [(each.params["front"], each.params["top"]) for each in made] == [("left", "top")] * 2


def test_rules_leave_the_front_to_the_engine_and_draw_nothing(tmp_path: Path) -> None:
    (tmp_path / "chair.glb").write_bytes(b"a model")
    (asset,), warnings = materialized(tmp_path, ())
    assert asset.canonical is not None and not {"front", "top"} & asset.canonical.params.keys()
    assert not warnings


def test_a_size_that_a_language_model_gives_chooses_the_unit_of_the_file(tmp_path: Path) -> None:
    for name in ("frobnicator", "chair"):
        (tmp_path / f"{name}.glb").write_bytes(b"a model")
    things = tuple(
        Asset(asset_id=name, asset_type="object", description=name, name=name) for name in ("frobnicator", "chair")
    )

    class Estimator(RulesDimensionEstimator):
        def propose(self, view: DimensionEstimatorView) -> dict[str, AssetDimension]:
            return super().propose(view) | {"frobnicator": AssetDimension(height=1.25)}

    kept: list[Asset] = []
    run = quick_run(ContinuityMemoryGraph(assets=things), Settings(models=(tmp_path,)), (), [], kept)
    run.crew = replace(run.crew, dimension_estimator=replace(run.crew.dimension_estimator, policies=(Estimator(),)))
    materialize(run)
    estimated = {asset.asset_id: asset.canonical and asset.canonical.params.get("estimated") for asset in kept}
    assert estimated == {"frobnicator": True, "chair": None}
    assert kept[0].dimension == AssetDimension(height=1.25)


def test_a_likeness_that_a_critic_refused_is_told_of_as_a_stand_in(tmp_path: Path) -> None:
    (tmp_path / "chair.glb").write_bytes(b"a model")

    class Refusing:
        def judge(self, draft: Recipe, view: AssetRetrieverView) -> Critique:
            return Critique(score=3.0)

    told, kept = list[Event](), list[Asset]()
    chair = Asset(asset_id="chair", asset_type="object", description="a chair", name="chair")
    run = quick_run(ContinuityMemoryGraph(assets=(chair,)), Settings(models=(tmp_path,)), (), told, kept)
    retriever = replace(run.crew.asset_retriever, policies=run.crew.asset_retriever.policies[:1], critic=Refusing())
    run.crew = replace(run.crew, asset_retriever=retriever)
    materialize(run)
    assert [event.kind for event in told if "stands in" in event.message] == ["warning"]
    assert kept[0].canonical is not None and kept[0].canonical.match_score == 3.0
