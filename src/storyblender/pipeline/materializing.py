"""Canonical asset materialization: every entity of the sheet becomes measured geometry (paper, section 3.3)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from functools import cached_property
from typing import TYPE_CHECKING

from storyblender.agents.concept_artist.asset_retriever_view import RETRIEVAL_THRESHOLD
from storyblender.agents.concept_artist.image_prompt import ImagePrompts
from storyblender.agents.layout_artist.dimension_estimator import RulesDimensionEstimator, estimate_dimension
from storyblender.catalog.meanings import WORDS_BY_AGE
from storyblender.catalog.parts import PART_PROPS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.recipe import Recipe
from storyblender.errors import AnswerAwaited, EngineError, InputError
from storyblender.library.file_names import character_file
from storyblender.memory.asset_sheet import Asset, AssetDecision, AssetDimension, CanonicalAsset, ModelPose, file_words
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure, AssetViews
from storyblender.pipeline.asset_files import assets_to_build, note_asset
from storyblender.pipeline.asset_views import asset_views
from storyblender.pipeline.chosen_models import chosen_model
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run
from storyblender.pipeline.shared_assets import SharedBuilding
from storyblender.service_setting import MAKERS
from storyblender.trace import Event

if TYPE_CHECKING:
    from storyblender.pipeline.generating import Workshop

_LARGE = 16 << 20
"""Bytes of a model from which reading and simplifying it may take minutes."""


def materialize(run: Run, assets: Sequence[Asset] | None = None) -> None:
    """Decide, size, build and measure every asset that is not built yet or whose files are damaged; one commit.

    Args:
        run: The run.
        assets: Where to look for them; in the whole graph if not given.
    """
    missing = assets_to_build(run, run.graph.assets if assets is None else assets)
    if not missing:
        return
    draw, building = asset_views(run), SharedBuilding(run)
    concept = ConceptArtist(run, draw)
    found, prompts = concept.all_decided(missing), ImagePrompts()
    _tell_large_models(run, found)
    if concept.workshop is not None:
        found, prompts = concept.all_made(found)
    decided = all_sized(run, concept, concept.all_formatted(found), draw)
    building.prepare(decided)
    waiting = [(asset, building.build(asset)) for asset in decided]
    built: list[Asset] = []
    for step, (asset, future) in enumerate(waiting):
        run.progress("materialize", step, len(waiting), asset.asset_id)
        built.append(_built(run, concept, asset, future))
        note_asset(run, built[-1])
    run.progress("materialize", len(waiting), len(waiting))
    building.give(built)
    told = f"{len(built)} asset{'s' * (len(built) != 1)} built"
    run.commit("asset_formatter", told, *_with_prompts(run, built, prompts))


def _tell_large_models(run: Run, assets: Sequence[Asset]) -> None:
    """Say which of the user's models may take minutes, before they do."""
    models = {made.key: asset.asset_id for asset in assets if (made := asset.canonical) and made.source == "file"}
    for key, asset_id in models.items():
        file = next((path for folder in run.settings.models if (path := folder / key).is_file()), None)
        size = file.stat().st_size if file is not None else 0
        if size >= _LARGE:
            message = f"{key} has {size >> 20} MB: to read and simplify it may take minutes"
            run.tell(Event(kind="warning", role="asset_formatter", subject=asset_id, message=message))


def _with_prompts(run: Run, assets: Sequence[Asset], known: ImagePrompts) -> list[Asset]:
    """Return the assets, those that something stands in for with a text-to-image prompt, the others with none."""
    wanted = [asset for asset in assets if _is_stood_in_for(asset)]
    prompts = known | _prompts(run, [asset for asset in wanted if asset.asset_id not in known])
    given = {asset.asset_id: prompts.get(asset.asset_id, "") for asset in wanted}
    return [asset.model_copy(update={"image_prompt": given.get(asset.asset_id, "")}) for asset in assets]


def _prompts(run: Run, assets: Sequence[Asset]) -> ImagePrompts:
    """Return the text-to-image prompts of things that something stands in for."""
    return run.reflect(run.crew.asset_generator, "assets", run.graph, assets).draft if assets else {}


def _is_stood_in_for(asset: Asset) -> bool:
    """Return whether no source has what the script means."""
    made = asset.canonical
    fits = made is None or made.match_score is None or made.match_score >= RETRIEVAL_THRESHOLD
    return not fits and asset.asset_type == "object" and asset.origin != "dressing"


def _built(run: Run, concept: ConceptArtist, asset: Asset, future: Future[AssetMeasure]) -> Asset:
    """Wait for an asset; where the user's model cannot be used, say so and take what else there is."""
    canonical = asset.canonical
    assert canonical is not None, "decided before it is built"
    try:
        measure = future.result()
        for note in measure.notes:
            run.tell(Event(kind="warning", role="asset_formatter", subject=asset.asset_id, message=note))
        return _measured(asset, measure)
    except EngineError as error:
        if canonical.source != "file" or canonical.geometry_hash:
            raise
        other = concept.give_up(asset, canonical.key, error.problem)
    (other,) = concept.all_formatted([other])
    return _built(run, concept, other, run.engine.build_asset(AssetJob(asset=other)))


def all_sized(
    run: Run, concept: ConceptArtist, assets: Sequence[Asset], draw: Callable[[Asset], AssetViews]
) -> list[Asset]:
    """Return the assets with the dimension of everything that the script names; dressing comes in its catalog's size.

    A model that a service made has no scale of its own: it is as large as its stand-in, if its size is unknown.

    Args:
        run: Its Dimension Estimator is asked.
        concept: Says what would stand in for an asset.
        assets: With their canonicals.
        draw: Draws an asset. Raises NoAnswer.

    Raises:
        AnswerAwaited: An answer has to come from outside first.
    """
    named = [each for each in assets if each.origin != "dressing" and each.dimension is None and not each.fitted_part]
    if not named:
        return [*assets]
    outcome = run.reflect(run.crew.dimension_estimator, "assets", run.graph, named, draw)
    sizes, usual = dict(outcome.draft), RulesDimensionEstimator().propose(outcome.view)
    made = {asset.asset_id: asset for asset in named if _is_made(asset)}
    for asset_id, asset in made.items():
        if asset.asset_type == "object" and sizes.get(asset_id) == usual[asset_id]:
            sizes[asset_id] = estimate_dimension(concept.stood_in_for(asset), outcome.view.rooms.get(asset_id))
    return [
        _with_size(asset, size, made=asset.asset_id in made, estimated=size != usual[asset.asset_id])
        if (size := sizes.get(asset.asset_id)) is not None
        else asset
        for asset in assets
    ]


def _is_made(asset: Asset) -> bool:
    """Return whether an asset is a model that a service made."""
    made = asset.canonical
    return made is not None and made.provenance is not None and made.provenance.source in MAKERS


def _with_size(asset: Asset, dimension: AssetDimension, *, made: bool, estimated: bool) -> Asset:
    """Return an asset with its dimension; a model keeps its own size unless the script or a person tells one.

    Args:
        asset: With its canonical.
        dimension: From the Dimension Estimator.
        made: Whether it is a model that a service made, which has no size of its own.
        estimated: Whether the dimension is another than the usual one of such a thing: a language model gave it. It
            chooses the unit of a user's model.
    """
    canonical = asset.canonical
    if canonical is not None and canonical.source == "file":
        decided = asset.look_decision is not None and asset.look_decision.stature is not None
        if made or decided or asset.stated_size.measure is not None:
            canonical = canonical.model_copy(update={"params": {**canonical.params, "told": True}})
        elif estimated:
            certainty = "told" if asset.asset_type == "character" else "estimated"
            canonical = canonical.model_copy(update={"params": {**canonical.params, certainty: True}})
        elif asset.asset_type == "object" and prop_of(asset) not in PROPS:
            return asset
    return asset.model_copy(update={"dimension": dimension, "canonical": canonical})


class ConceptArtist:
    """Retriever, then Generator: what every asset is made from.

    Args:
        run: Its sources offer the assets.
        draw: Draws an asset. Raises NoAnswer.
    """

    def __init__(self, run: Run, draw: Callable[[Asset], AssetViews]) -> None:
        self._run, self._draw = run, draw
        self._rejected: set[str] = set()
        self._poses = {
            (made.key, made.params.get("content")): pose
            for asset in run.graph.assets
            if (made := asset.canonical) is not None and made.source == "file"
            if (pose := ModelPose.of(made.params)).top is not None
        }
        """Of the model files whose front and top are decided, by name and content."""
        self._means = WORDS_BY_AGE.get(run.graph.age or "today", {})
        self.workshop = workshop_of(run)
        """Makes things that no source has; None where the settings name no services that do."""
        self._standing_in: dict[str, Event] = {}
        """What is to be said of things that something stands in for, once nothing was made for them, by asset id."""

    def all_made(self, assets: Sequence[Asset]) -> tuple[list[Asset], ImagePrompts]:
        """Return the assets, stand-ins replaced by models that services made, and the prompts of the pictures.

        Raises:
            AnswerAwaited: Answers have to come from outside first; what is paid for is kept.
        """
        workshop, self.workshop = self.workshop, None
        wanted = [asset for asset in assets if _is_stood_in_for(asset)]
        prompts = _prompts(self._run, wanted)
        made = workshop.made(wanted, prompts) if workshop is not None and wanted else {}
        for asset_id, event in self._standing_in.items():
            if asset_id not in made:
                self._run.tell(event)
        return [made.get(asset.asset_id, asset) for asset in assets], prompts

    def stood_in_for(self, asset: Asset) -> Asset:
        """Return an asset as what would stand in for it, if it had no model."""
        role = self._run.crew.asset_retriever
        view = role.project(self._run.graph, asset, self._means, self._rejected, self._draw)
        return asset.model_copy(update={"canonical": role.policies[-1].propose(view).canonical()})

    def give_up(self, asset: Asset, key: str, why: str) -> Asset:
        """Return the asset with something else to be made from than a model that cannot be used, and say so.

        Args:
            asset: With the model, or not decided yet.
            key: Of the model's recipe; this artist does not take it again.
            why: Why it cannot be used, for the warning.

        Raises:
            AnswerAwaited: An answer has to come from outside first.
        """
        person = asset.asset_type == "character"
        message = f"{why}; {'they are built from their look' if person else 'something else stands in for it'}"
        self._run.tell(Event(kind="warning", role="asset_formatter", subject=asset.asset_id, message=message))
        self._rejected.add(key)
        return self.decided(asset.model_copy(update={"canonical": None}))

    def all_decided(self, assets: Sequence[Asset]) -> list[Asset]:
        """Return the assets with what they are made from.

        Raises:
            AnswerAwaited: Answers have to come from outside first; all questions are asked before the run stops.
        """
        return _each(self.decided, assets)

    def all_formatted(self, assets: Sequence[Asset]) -> list[Asset]:
        """Return the assets with the front and the top of the models that they are made from; each file is asked once.

        Raises:
            AnswerAwaited: Answers have to come from outside first; all questions are asked before the run stops.
        """
        return _each(self._formatted, assets)

    def _formatted(self, asset: Asset) -> Asset:
        made = asset.canonical
        if asset.asset_type == "character":  # whose front its shape shows
            return asset
        if made is None or made.source != "file" or made.geometry_hash or ModelPose.of(made.params).top is not None:
            return asset
        model = (made.key, made.params.get("content"))
        if model not in self._poses:
            outcome = self._run.reflect(self._run.crew.asset_formatter, made.key, asset, self._draw)
            self._poses[model] = outcome.draft
        params = {**made.params, **self._poses[model].params}
        return asset.model_copy(update={"canonical": made.model_copy(update={"params": params})})

    def decided(self, asset: Asset) -> Asset:
        """Return the asset with what it is made from, if that is not decided yet."""
        if asset.canonical is not None:
            return asset
        if asset.asset_type == "character":
            return self._cast(asset)
        if asset.fitted_part:
            recipe = Recipe(source="catalog", key=PART_PROPS[asset.fitted_part], score=10.0, reason="a vehicle's part")
            return asset.model_copy(update={"canonical": recipe.canonical()})
        decision = asset.decision
        if decision is not None and decision.file and decision.file not in self._rejected:
            return self._own_model(asset, decision)
        role, rejected = self._run.crew.asset_retriever, self._rejected | {*asset.turned_down}
        outcome = self._run.reflect(role, asset.asset_id, self._run.graph, asset, self._means, rejected, self._draw)
        try:
            recipe = fetched(self._run, outcome.draft)
        except InputError as error:
            return self.give_up(asset, outcome.draft.key, str(error))
        if outcome.critique.score < recipe.score:  # a critic looked at it
            recipe = recipe.model_copy(update={"score": outcome.critique.score})
        if recipe.score < RETRIEVAL_THRESHOLD:
            name = PROPS[recipe.key].name if recipe.source == "catalog" else file_words(recipe.key)
            message = (
                f"the library has no {asset.name or asset.asset_id}; the {name} stands in for it ({recipe.reason})"
            )
            event = Event(kind="warning", role="asset_generator", subject=asset.asset_id, message=message)
            if self.workshop is None:
                self._run.tell(event)
            else:
                self._standing_in[asset.asset_id] = event
        recipe = recipe.in_state(outcome.view.state).filled_with(asset.liquid).with_caller(asset.description)
        recipe = recipe.written(asset.writing)
        return asset.model_copy(update={"canonical": recipe.canonical()})

    @cached_property
    def _models(self) -> tuple[str, ...]:
        """Names of the models that the sources have."""
        return tuple(name for source in self._run.sources for name in source.inventory())

    def _cast(self, asset: Asset) -> Asset:
        """Return a character: from the model that a person chose or that is called like them, else built by casting."""
        file = asset.decision.file if asset.decision is not None else character_file(asset, self._models)
        if file and file not in self._rejected and file not in asset.turned_down:
            return self._own_model(asset, asset.decision or AssetDecision(file=file))
        canonical = CanonicalAsset(source="person", key="person", dimensions=(0.5, 0.4, 1.7), digest="")
        return asset.model_copy(update={"canonical": canonical})

    def _own_model(self, asset: Asset, decision: AssetDecision) -> Asset:
        """Return an asset that a person had made from a model of theirs; where that is gone, from something else."""
        reason = "a person chose it" if asset.decision is not None else "it is called like the character"
        try:
            recipe = chosen_model(self._run, decision, reason)
        except InputError as error:
            return self.give_up(asset, decision.file, str(error))
        return asset.model_copy(update={"canonical": recipe.canonical()})


def workshop_of(run: Run) -> Workshop | None:
    """Return what makes things for a run; None where the settings name no services that do."""
    if run.services is None:
        return None
    from storyblender.pipeline.generating import Workshop

    return Workshop.of(run, run.services)


def _each(decide: Callable[[Asset], Asset], assets: Sequence[Asset]) -> list[Asset]:
    """Return what is decided for each asset. Raises AnswerAwaited when all questions are asked."""
    found: list[Asset] = []
    awaited: list[AnswerAwaited] = []
    for asset in assets:
        try:
            found.append(decide(asset))
        except AnswerAwaited as error:
            awaited.append(error)
    if awaited:
        raise AnswerAwaited.of(awaited)
    return found


def _measured(asset: Asset, measure: AssetMeasure) -> Asset:
    canonical = asset.canonical
    assert canonical is not None, "decided before it is built"
    return asset.model_copy(
        update={
            "canonical": CanonicalAsset(
                source=canonical.source,
                key=canonical.key,
                params=canonical.params,
                match_score=canonical.match_score,
                dimensions=measure.dimensions,
                anchors=measure.anchors,
                digest=measure.digest,
                geometry_hash=measure.geometry_hash,
                provenance=canonical.provenance and canonical.provenance.credited(measure.credit),
            )
        }
    )
