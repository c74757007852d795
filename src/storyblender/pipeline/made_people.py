"""A character made by services: a picture of how they look, and a model of the picture that fits our skeleton."""

from __future__ import annotations

from storyblender.agents.concept_artist.person_prompt import person_prompt
from storyblender.agents.layout_artist.dimension_estimator import estimate_dimension
from storyblender.errors import EngineError, InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import AssetJob
from storyblender.pipeline.estimating import Expected, expected_of, made_by
from storyblender.pipeline.generating import Workshop
from storyblender.pipeline.prices import makers_of, rigger_of
from storyblender.pipeline.run import Run
from storyblender.service_setting import services_in
from storyblender.services.register import IMAGE_MODELS, MODEL_MAKERS, ServiceRun
from storyblender.trace import Event

_USUAL = 1.7
"""Metres of somebody whose height is not known."""


def made_person(run: Run, person: Asset) -> str:
    """Have a model made of a character, and return the key by which an edit names it; the story stays as it is.

    What was made for the same look before is taken from the library, and a job that was begun before goes on. Where the
    settings name a service that rigs, it puts a skeleton into the model; the model is used as it came if that fails.

    Args:
        run: Its settings name the services.
        person: A character.

    Raises:
        AnswerAwaited: The picture waits to be examined; it is kept.
        Cancelled: The run was; a job goes on at the service, and with the next call.
        InputError: A setting is missing, nothing was made, or what was made is no human figure.
    """
    workshop = _workshop(run, person)
    made = workshop.made_person(person, person_prompt(person, run.graph.age))
    rigged = workshop.rigged(made, _height(person))
    if rigged is not None:
        try:
            return _fitting(run, rigged)
        except InputError as error:
            message = f"{error.problem}; it is bound without the skeleton of the service"
            run.tell(Event(kind="warning", role="asset_generator", subject=person.asset_id, message=message))
    return _fitting(run, made)


def expected_person(run: Run, person: Asset) -> Expected:
    """Return what it takes to have a model made of a character; nothing is asked for.

    Args:
        run: Its settings name the services.
        person: A character.

    Raises:
        InputError: A setting or the address of a server is missing.
    """
    services = _services(run, person)
    makers, lacking = makers_of(run.settings.services, services)
    if len(makers) < 2:
        raise InputError(f"no model can be made: {'; '.join(each.why for each in lacking)}")
    rigger = rigger_of(run.settings.services, services, _height(person))
    return expected_of(run, [made_by([*makers, *rigger], person)], lacking)


def _workshop(run: Run, person: Asset) -> Workshop:
    """Return what makes the model. Raises InputError where the settings do not allow it."""
    workshop = Workshop.of(run, _services(run, person))
    assert workshop is not None, "the settings name what it takes"
    return workshop


def _services(run: Run, person: Asset) -> ServiceRun:
    """Return what the run gives the services. Raises InputError where the settings do not allow them."""
    if person.look is not None and person.look.species:
        raise InputError(f"{person.asset_id} is a {person.look.species}", mend="services make human characters only")
    names = [choice.name for choice in services_in(run.settings.services)]
    for register, does in ((IMAGE_MODELS, "draws pictures"), (MODEL_MAKERS, "makes models of pictures")):
        if not {*names} & {*register}:
            problem = f"none of {', '.join(names)} {does}" if names else f"no service is named that {does}"
            mend = (
                f"name one that draws ({', '.join(IMAGE_MODELS)}) and one that makes models "
                f"({', '.join(MODEL_MAKERS)}), as in --services gemini,hunyuan3d; "
                "most need a key and cost money, which --dry-run tells before"
            )
            raise InputError(problem, mend=mend)
    if not run.settings.library:
        raise InputError("what services make is kept in your library, which is turned off", mend="set library = true")
    if run.settings.licences == "free":
        mend = 'set licences = "any" or "commercial"'
        raise InputError('what services make is not in the public domain, and licences = "free"', mend=mend)
    assert run.services is not None, "the settings name services"
    return run.services


def _height(person: Asset) -> float:
    """Return how tall a character is, in metres."""
    return estimate_dimension(person).height or _USUAL


def _fitting(run: Run, made: Asset) -> str:
    """Return the key of a model that can be bound to our skeleton: it is built, once. Raises InputError."""
    canonical = made.canonical
    assert canonical is not None, "it has a model"
    fitted = canonical.model_copy(update={"params": {**canonical.params, "told": True}})
    sized = made.model_copy(update={"canonical": fitted, "dimension": estimate_dimension(made)})
    try:
        run.engine.build_asset(AssetJob(asset=sized)).result()
    except EngineError as error:
        mend = "nothing is changed; another --face, or other clothes, give another picture"
        raise InputError(f"the model of {made.name or made.asset_id} cannot be used: {error}", mend=mend) from error
    return canonical.key
