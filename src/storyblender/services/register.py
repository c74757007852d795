"""The register of services: name to what makes one, which imports its module only when it is asked."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from storyblender.keys import service_key
from storyblender.service_setting import LicenceFilter, ServiceChoice, ServiceName
from storyblender.services.budget import ServiceBudget
from storyblender.services.offers import Catalogue
from storyblender.services.shelf import Shelf
from storyblender.services.web import Patience, Web


@dataclass(frozen=True)
class ServiceRun:
    """What a run gives the services that it asks.

    Attributes:
        budget: What may be spent in all.
        licences: Which licences works may have.
        shelf: Where catalogues keep what they answered.
        patience: How long and how often each is asked.
        cancelled: Set when nobody waits any more.
    """

    budget: ServiceBudget = field(default_factory=ServiceBudget)
    licences: LicenceFilter = "any"
    shelf: Shelf = field(default_factory=Shelf)
    patience: Patience = field(default_factory=Patience)
    cancelled: threading.Event = field(default_factory=threading.Event)

    def web(self, choice: ServiceChoice, usual: str, key_header: str = "", scheme: str = "") -> Web:
        """Return HTTP with a service.

        Args:
            choice: The service.
            usual: Its own address.
            key_header: Name of the header that has the key, if there is one: ``Authorization``.
            scheme: What stands before the key in it: ``Token``.
        """
        key = service_key(choice) if key_header else ""
        headers = {key_header: f"{scheme} {key}".strip()} if key else {}
        return Web(choice.name, choice.address or usual, headers, self.budget, self.patience, self.cancelled)


CatalogueFactory = Callable[[ServiceChoice, ServiceRun], Catalogue]


def _poly_haven(choice: ServiceChoice, run: ServiceRun) -> Catalogue:
    from storyblender.services.poly_haven import PolyHaven

    return PolyHaven(choice, run)


def _sketchfab(choice: ServiceChoice, run: ServiceRun) -> Catalogue:
    from storyblender.services.sketchfab import Sketchfab

    return Sketchfab(choice, run)


CATALOGUES: dict[ServiceName, CatalogueFactory] = {"poly_haven": _poly_haven, "sketchfab": _sketchfab}
"""Services that offer works."""


def catalogues(choices: Sequence[ServiceChoice], run: ServiceRun) -> tuple[Catalogue, ...]:
    """Return the catalogues among the services of the settings, in their order."""
    return tuple(CATALOGUES[choice.name](choice, run) for choice in choices if choice.name in CATALOGUES)
