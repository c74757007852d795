"""The Asset Generator with services: prompt, picture, model for the things that no source has (paper, section 3.3).

All pictures are drawn at the same time, each is examined, all models are begun and then looked at together. A service
that fails hands over to the next of the setting, and after the last one the thing keeps its stand-in. A character is
made likewise where a person asks for it.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from storyblender.catalog.recipe import Recipe
from storyblender.errors import AnswerAwaited, Cancelled, InputError, NoAnswer, ServiceFailure
from storyblender.library.commissions import Commissions, Wanted
from storyblender.library.library_source import placed_model
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.jobs import Job
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset
from storyblender.pipeline.run import Run
from storyblender.service_setting import ServiceChoice, services_in
from storyblender.services.making import Busy, ImageModel, JobState, Maker, ModelMaker
from storyblender.services.register import IMAGE_MODELS, MODEL_MAKERS, RIGGERS, ServiceRun
from storyblender.trace import Event

_UNSEEN, _SEEN = 8.0, 9.0
"""Match scores of a model that was made for a thing: without a look at its picture; at most, with one."""
_LOOKS = 5
"""First pause between two looks at the jobs, in first pauses of a request; it grows to five times that."""
_MISSES = 3
"""Looks at a job that may fail one after the other."""


@dataclass
class _Order:
    """A thing that is being made.

    Attributes:
        asset: The thing.
        wanted: What it is for the library.
        picture: That was drawn and examined.
        score: Of the match, if the model comes.
        makers: Services that have not failed yet, in order.
        job: Begun at the first of them.
        misses: Looks that failed one after the other.
        percent: How much of it is done.
    """

    asset: Asset
    wanted: Wanted
    picture: LibraryEntry
    score: float
    makers: deque[ModelMaker]
    job: Job | None = None
    misses: int = 0
    percent: int = 0

    @property
    def stands(self) -> str:
        """How it stands, for people: ``samovar: meshy, 40 %``."""
        service = f": {self.makers[0].maker.service}, {self.percent} %" if self.makers else ""
        return f"{self.wanted.name}{service}"


@dataclass
class Workshop:
    """Makes things for one run.

    Attributes:
        run: Its settings name the services.
        services: Budget and patience.
        library: Where everything is kept that was paid for.
    """

    run: Run
    services: ServiceRun
    library: SharedLibrary
    _images: list[ImageModel] = field(default_factory=list)
    _makers: list[ModelMaker] = field(default_factory=list)
    _riggers: list[ServiceChoice] = field(default_factory=list)
    _painted: dict[str, LibraryEntry | ServiceFailure] = field(default_factory=dict)
    _failed: dict[str, str] = field(default_factory=dict)
    """Why a thing keeps its stand-in, by asset id."""
    _missing: list[str] = field(default_factory=list)
    """Why services of the setting cannot be asked."""

    @classmethod
    def of(cls, run: Run, services: ServiceRun) -> Workshop | None:
        """Return the workshop of a run; None where the settings name no image model, or nothing that makes models.

        Args:
            run: Its settings name the services.
            services: What it gives them.
        """
        choices = services_in(run.settings.services)
        names = {choice.name for choice in choices}
        if not names & {*IMAGE_MODELS} or not names & {*MODEL_MAKERS}:
            return None
        if run.settings.licences == "free":
            message = "only works given to the public domain are wanted, so services make nothing"
            run.tell(Event(kind="warning", role="asset_generator", message=message))
            return None
        workshop = cls(run, services, SharedLibrary.open())
        for choice in choices:
            workshop._engage(choice)
        return workshop

    def _engage(self, choice: ServiceChoice) -> None:
        """Take a service on; one that has no key is told and left out."""
        try:
            if choice.name in IMAGE_MODELS:
                self._images.append(IMAGE_MODELS[choice.name](choice, self.services))
            if choice.name in MODEL_MAKERS:
                self._makers.append(MODEL_MAKERS[choice.name](choice, self.services))
            if choice.name in RIGGERS:
                self._riggers.append(choice)
        except ServiceFailure as error:
            self._missing.append(str(error))
            self._warn(str(error))

    def asked_first(self) -> tuple[Maker, Maker]:
        """Return the image model and the maker of models that are asked first.

        Raises:
            InputError: None of one kind can be asked.
        """
        if not self._images or not self._makers:
            raise InputError(f"no model can be made: {'; '.join(self._missing)}")
        return self._images[0].maker, self._makers[0].maker

    @cached_property
    def _commissions(self) -> Commissions:
        return Commissions(self.library, self.services.budget, self.services.cancelled)

    def made(self, assets: Sequence[Asset], prompts: Mapping[str, str]) -> dict[str, Asset]:
        """Return the things for which services made a model, with that, by asset id.

        Args:
            assets: Things that something stands in for.
            prompts: Of their pictures, by asset id.

        Raises:
            AnswerAwaited: Pictures wait to be examined; they are kept.
            Cancelled: The run was; jobs go on at the services, and with the next run.
        """
        if not self._images or not self._makers:
            return {}
        wanted = {each.asset_id: _wanted(each, prompts[each.asset_id]) for each in assets if each.asset_id in prompts}
        models = self._made([each for each in assets if each.asset_id in wanted], wanted)
        for reason in dict.fromkeys(self._failed.values()):
            names = [wanted[each].name for each in wanted if self._failed.get(each) == reason]
            self._warn(f"nothing was made for {_listed(names)}, which keeps what stands in: {reason}")
        return models

    def made_person(self, person: Asset, prompt: str) -> Asset:
        """Return a character with the model that services made of their picture.

        Args:
            person: A character.
            prompt: Of their picture.

        Raises:
            AnswerAwaited: The picture waits to be examined; it is kept.
            Cancelled: The run was; a job goes on at the service, and with the next call.
            InputError: No service can be asked, or nothing was made.
        """
        self.asked_first()
        wanted = replace(_wanted(person, prompt), kind="character")
        made = self._made([person], {person.asset_id: wanted})
        if person.asset_id not in made:
            paid = self.services.budget.spent("dollars") > 0
            mend = "nothing is changed" + ", and what is paid for is kept for the next time" * paid
            raise InputError(f"no model of {wanted.name} was made: {self._failed[person.asset_id]}", mend=mend)
        return made[person.asset_id]

    def riggers(self, height: float) -> list[ModelMaker]:
        """Return what puts a skeleton into the model of a person.

        Args:
            height: Of the person, in metres.
        """
        return [RIGGERS[choice.name](choice, self.services, height) for choice in self._riggers]

    def rigged(self, made: Asset, height: float) -> Asset | None:
        """Return a character with their model that a service put a skeleton into; None where none did, which is told.

        Args:
            made: With the model.
            height: Of the person, in metres.

        Raises:
            Cancelled: The run was; a job goes on at the service, and with the next call.
        """
        riggers, model = deque(self.riggers(height)), self.library.told(made.canonical.key) if made.canonical else None
        if not riggers or model is None:
            return None
        wanted = replace(_wanted(made, ""), kind="character", made_of=model.credit)
        rigged = self._modelled([_Order(made, wanted, model, _UNSEEN, riggers)]).get(made.asset_id)
        if rigged is None:
            self._warn(f"the model of {wanted.name} is bound without a service: {self._failed[made.asset_id]}")
        return rigged

    def _made(self, assets: Sequence[Asset], wanted: Mapping[str, Wanted]) -> dict[str, Asset]:
        """Return the assets that got a model; why others did not is in ``_failed``. Raises AnswerAwaited, Cancelled."""
        self.run.progress("generate", 0, len(wanted), "the pictures")
        self._paint([*wanted.values()])
        return self._modelled(self._examined(assets, wanted))

    def made_meanwhile(self, asset: Asset) -> Asset | None:
        """Return a thing with the model that an earlier run had begun and did not wait for; None where there is none.

        Nothing is begun and nothing paid; a service that cannot be asked now is told of.

        Args:
            asset: Something stands in for it.
        """
        wanted = _wanted(asset, asset.image_prompt)
        for picture in self._commissions.pictures_of(asset.image_prompt):
            for maker in self._makers:
                try:
                    entry = self._commissions.made_meanwhile(maker, picture, wanted)
                except (ServiceFailure, InputError) as error:
                    self._warn(f"what was begun for the {wanted.name} cannot be fetched now: {error}")
                    continue
                if entry is not None:
                    found = self._with_model(_Order(asset, wanted, picture, _UNSEEN, deque()), entry)
                    if isinstance(found, Asset):
                        return found
        return None

    def paint(self, prompt: str) -> bytes:
        """Return the picture of a prompt as PNG, drawn once. Raises NoAnswer."""
        if prompt not in self._painted:
            self._paint([Wanted("picture", prompt)])
        found = self._painted[prompt]
        if isinstance(found, ServiceFailure):
            raise NoAnswer(str(found))
        try:
            return self.library.path_of(found).read_bytes()
        except OSError as error:
            raise NoAnswer(f"a picture in the library cannot be read ({error.strerror})") from error

    def _paint(self, wanted: Sequence[Wanted]) -> None:
        """Have pictures drawn by the first image model, those that fail by the next."""
        for model in self._images:
            left = [each for each in wanted if not isinstance(self._painted.get(each.prompt), LibraryEntry)]
            if left:
                self._painted |= self._commissions.pictures(model, left)

    def _examined(self, assets: Sequence[Asset], wanted: Mapping[str, Wanted]) -> list[_Order]:
        """Return orders for the things whose picture is sound. Raises AnswerAwaited when all are examined."""
        orders: list[_Order] = []
        awaited: list[AnswerAwaited] = []
        role = self.run.crew.reference_picture
        for asset in assets:
            each = wanted[asset.asset_id]
            first = self._painted[each.prompt]
            if isinstance(first, ServiceFailure):
                self._failed[asset.asset_id] = str(first)
                continue
            try:
                outcome = self.run.reflect(role, asset.asset_id, asset, each.prompt, self.paint)
            except AnswerAwaited as error:
                awaited.append(error)
                continue
            picture, critique = self._painted[outcome.draft.prompt], outcome.critique
            if critique.score < role.threshold or isinstance(picture, ServiceFailure):
                faults = "; ".join(fault.message for fault in critique.faults)
                self._failed[asset.asset_id] = f"its picture is only {critique.score:.0f} of 10 ({faults})"
                continue
            seen = any(" gives " in remark for remark in critique.remarks)
            score = min(_SEEN, critique.score) if seen else _UNSEEN
            orders.append(_Order(asset, each, picture, score, deque(self._makers)))
        if awaited:
            raise AnswerAwaited.of(awaited)
        return orders

    def _modelled(self, orders: Sequence[_Order]) -> dict[str, Asset]:
        """Return the things that got a model, by asset id. Raises Cancelled."""
        made: dict[str, Asset] = {}
        left, pause = list(orders), _LOOKS * self.services.patience.first_pause
        longest = _LOOKS * pause
        while left:
            for order in list(left):
                told = self._advanced(order, Counter(id(each.makers[0]) for each in left if each.job is not None))
                if isinstance(told, Asset):
                    made[told.asset_id] = told
                if told is not None:
                    left.remove(order)
                self.run.progress("generate", len(orders) - len(left), len(orders), order.stands)
            if left and not self._waited(pause, left):
                break
            pause = min(longest, 1.3 * pause)
        return made

    def _waited(self, pause: float, left: Sequence[_Order]) -> bool:
        """Wait before the next looks, and return whether there is time for them. Raises Cancelled."""
        try:
            self.services.budget.spend("minutes", pause / 60)
        except ServiceFailure as error:
            self._failed |= dict.fromkeys((order.asset.asset_id for order in left), str(error))
            return False
        if self.services.cancelled.wait(pause):
            raise Cancelled
        return True

    def _advanced(self, order: _Order, working: Counter[int]) -> Asset | str | None:
        """Begin a job or look at it; return the thing with its model, why there is none, or None while it goes on."""
        while order.makers:
            maker = order.makers[0]
            try:
                found = self._asked(order, maker, working)
                if isinstance(found, LibraryEntry):
                    return self._with_model(order, found)
                if found is None or found.status != "failed":
                    return None
                reason = f"{maker.maker.service}: {found.reason}"
            except ServiceFailure as error:
                order.misses += order.job is not None
                if 0 < order.misses < _MISSES:
                    return None
                if order.misses and maker.maker.price:
                    return self._refused(order, f"{error}; what it was paid for goes on there")
                reason = str(error)
            except InputError as error:
                return self._refused(order, str(error))
            order.makers.popleft()
            order.job, order.misses, order.percent = None, 0, 0
            self._failed[order.asset.asset_id] = reason
            if order.makers:
                message = f"{reason}; {order.makers[0].maker.service} takes over"
                subject = order.asset.asset_id
                self.run.tell(Event(kind="handover", role="asset_generator", subject=subject, message=message))
        return self._failed[order.asset.asset_id]

    def _asked(self, order: _Order, maker: ModelMaker, working: Counter[int]) -> LibraryEntry | JobState | None:
        """Return what a maker has, how far it is, or None if it could not be begun yet. Raises ServiceFailure."""
        if order.job is None:
            if working[id(maker)] >= maker.maker.at_once:
                return None
            try:
                found = self._commissions.model(maker, order.picture)
            except Busy:
                return None
            if isinstance(found, LibraryEntry):
                return found
            order.job = found
        found = self._commissions.look(maker, order.job, order.wanted)
        order.misses = 0
        order.percent = found.percent if isinstance(found, JobState) else 100
        return found

    def _with_model(self, order: _Order, entry: LibraryEntry) -> Asset | str:
        """Return a thing with a model of the library, or why it cannot be used."""
        if entry.key in order.asset.turned_down:
            return self._refused(order, "a person turned down what was made for it")
        reason = f"made by {entry.source} of a picture"
        recipe = Recipe(source="file", key=entry.key, score=order.score, reason=reason)
        try:
            recipe = placed_model(self.library, entry, recipe, self.run.project.files)
        except InputError as error:
            return self._refused(order, str(error))
        self._failed.pop(order.asset.asset_id, None)
        return order.asset.model_copy(update={"canonical": recipe.canonical()})

    def _refused(self, order: _Order, reason: str) -> str:
        self._failed[order.asset.asset_id] = reason
        return reason

    def _warn(self, message: str) -> None:
        self.run.tell(Event(kind="warning", role="asset_generator", message=message))


def _wanted(asset: Asset, prompt: str) -> Wanted:
    name = asset.name or asset.asset_id.replace("_", " ")
    return Wanted(name, prompt, next(iter(asset.tags), ""))


def _listed(names: Sequence[str]) -> str:
    """Return names as people list them."""
    return " and ".join(filter(None, (", ".join(f"the {name}" for name in names[:-1]), f"the {names[-1]}")))
