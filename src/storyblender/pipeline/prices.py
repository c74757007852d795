"""What services that make things would cost, and which of them cannot be asked: nothing is asked of any."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from storyblender.errors import ServiceFailure
from storyblender.memory.base import Frozen
from storyblender.service_setting import ServiceChoice, ServiceName, services_in
from storyblender.services.making import ImageModel, Maker, ModelMaker
from storyblender.services.register import IMAGE_MODELS, MODEL_MAKERS, RIGGERS, ServiceRun

Register = Mapping[ServiceName, Callable[[ServiceChoice, ServiceRun], ImageModel | ModelMaker]]


class NotAsked(Frozen):
    """A service that a dry run could not count on."""

    service: str
    why: str
    """One clause, with what to do about it."""


def makers_of(setting: str, services: ServiceRun) -> tuple[list[Maker], list[NotAsked]]:
    """Return the image model and the maker of models that are asked first, and the services that cannot be asked.

    Where none of a kind can be asked, the first whose price is known without its key stands for it.

    Args:
        setting: Names the services.
        services: What the run gives them.

    Returns:
        One maker of each kind, fewer where a kind is not named or has no price; and the services, in their order.
    """
    makers: list[Maker] = []
    lacking: dict[str, NotAsked] = {}
    registers: tuple[Register, ...] = (IMAGE_MODELS, MODEL_MAKERS)
    for register in registers:
        ready, priced = [], []
        for choice in (each for each in services_in(setting) if each.name in register):
            try:
                ready.append(register[choice.name](choice, services).maker)
            except ServiceFailure as failure:
                lacking[choice.name] = not_asked(choice.name, str(failure))
                priced += _without_key(register[choice.name], choice, services)
        makers += (ready or priced)[:1]
    return makers, list(lacking.values())


def rigger_of(setting: str, services: ServiceRun, height: float) -> list[Maker]:
    """Return the service that puts a skeleton into the model of a person; none where the setting names none.

    Args:
        setting: Names the services.
        services: What the run gives them.
        height: Of the person, in metres.
    """
    named: Iterable[ServiceChoice] = (each for each in services_in(setting) if each.name in RIGGERS)
    return [RIGGERS[each.name](each, replace(services, only_prices=True), height).maker for each in named][:1]


def not_asked(service: str, why: str) -> NotAsked:
    """Return that a service could not be asked.

    Args:
        service: Its name.
        why: The sentence of its failure, which may begin with the name.
    """
    return NotAsked(service=service, why=why.removeprefix(f"{service}: "))


def _without_key(
    make: Callable[[ServiceChoice, ServiceRun], ImageModel | ModelMaker], choice: ServiceChoice, services: ServiceRun
) -> list[Maker]:
    """Return what is known of a service that has no key; nothing where more than the key is missing."""
    try:
        return [make(choice, replace(services, only_prices=True)).maker]
    except ServiceFailure:
        return []
