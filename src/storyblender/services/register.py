"""The register of services: name to what makes one, which imports its module only when it is asked."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from urllib.parse import urlsplit

from storyblender.errors import ServiceFailure
from storyblender.keys import TENCENT_KEYS, known_key, service_key, service_key_name
from storyblender.service_setting import LicenceFilter, ServiceChoice, ServiceName
from storyblender.services.budget import ServiceBudget
from storyblender.services.making import ImageModel, ModelMaker
from storyblender.services.offers import Catalogue
from storyblender.services.outages import Outages
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
        cancelled: Set when the run is cancelled.
        outages: The services that failed.
        only_prices: Whether services that lack their key are made all the same, for their prices: they are not asked.
    """

    budget: ServiceBudget = field(default_factory=ServiceBudget)
    licences: LicenceFilter = "any"
    shelf: Shelf = field(default_factory=Shelf)
    patience: Patience = field(default_factory=Patience)
    cancelled: threading.Event = field(default_factory=threading.Event)
    outages: Outages = field(default_factory=Outages)
    only_prices: bool = False

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


ImageModelFactory = Callable[[ServiceChoice, ServiceRun], ImageModel]
ModelMakerFactory = Callable[[ServiceChoice, ServiceRun], ModelMaker]


def _gemini(choice: ServiceChoice, run: ServiceRun) -> ImageModel:
    from storyblender.services.gemini import ADDRESS, KEY_HEADER, GeminiImages

    return GeminiImages(_slow_web(choice, run, ADDRESS, KEY_HEADER), choice.model, own=bool(choice.address))


def _openai(choice: ServiceChoice, run: ServiceRun) -> ImageModel:
    from storyblender.services.openai import ADDRESS, OpenAIImages

    web = _slow_web(choice, run, ADDRESS, "Authorization", "Bearer")
    return OpenAIImages(web, choice.model, own=bool(choice.address))


def _hunyuan3d(choice: ServiceChoice, run: ServiceRun) -> ModelMaker:
    from storyblender.services.hunyuan3d import ADDRESS, CLOUD, Hunyuan3DCloud

    if choice.address and not (urlsplit(choice.address).hostname or "").endswith(CLOUD):
        from storyblender.services.hunyuan3d_server import Hunyuan3DServer

        return Hunyuan3DServer(run.web(choice, choice.address, "Authorization", "Bearer"), choice.model)
    from storyblender.services.tencent_signature import TencentKey

    secret_id, secret_key = map(known_key, TENCENT_KEYS)
    if not (secret_id and secret_key) and not run.only_prices:
        raise ServiceFailure("there is no key for hunyuan3d", mend=f"set {' and '.join(TENCENT_KEYS)}")
    return Hunyuan3DCloud(run.web(choice, ADDRESS), TencentKey(secret_id, secret_key), choice.model)


def _trellis(choice: ServiceChoice, run: ServiceRun) -> ModelMaker:
    from storyblender.services.trellis import TrellisServer

    if not choice.address:
        mend = "name it in the setting: trellis@http://127.0.0.1:6006"
        raise ServiceFailure("trellis is a server of your own and has no address", mend=mend)
    return TrellisServer(run.web(choice, choice.address, "Authorization", "Bearer"), choice.model)


def _meshy(choice: ServiceChoice, run: ServiceRun) -> ModelMaker:
    from storyblender.services.meshy import ADDRESS, MeshyModels

    return MeshyModels(_keyed_web(choice, run, ADDRESS, "Authorization", "Bearer"), choice.model)


IMAGE_MODELS: dict[ServiceName, ImageModelFactory] = {"gemini": _gemini, "openai": _openai}
"""Services that draw pictures. A factory raises ServiceFailure where the key or the address is missing."""
MODEL_MAKERS: dict[ServiceName, ModelMakerFactory] = {"hunyuan3d": _hunyuan3d, "trellis": _trellis, "meshy": _meshy}
"""Services that make models of pictures. A factory raises ServiceFailure where the key or the address is missing."""


def _meshy_rigs(choice: ServiceChoice, run: ServiceRun, height: float) -> ModelMaker:
    from storyblender.services.meshy import ADDRESS, MeshyRigs

    return MeshyRigs(_keyed_web(choice, run, ADDRESS, "Authorization", "Bearer"), height)


RIGGERS: dict[ServiceName, Callable[[ServiceChoice, ServiceRun, float], ModelMaker]] = {"meshy": _meshy_rigs}
"""Services that put a skeleton into the model of a person of so many metres. A factory raises ServiceFailure where the
key is missing."""


def _keyed_web(choice: ServiceChoice, run: ServiceRun, usual: str, key_header: str, scheme: str = "") -> Web:
    """Return HTTP with a service that wants a key, unless the server is the user's own. Raises ServiceFailure."""
    web = run.web(choice, usual, key_header, scheme)
    if not web.headers and not choice.address and not run.only_prices:
        name = service_key_name(choice)
        mend = f"set {name} in the environment, or `keyring set storyblender {name}`"
        raise ServiceFailure(f"there is no key for {choice.name}", mend=mend)
    return web


def _slow_web(choice: ServiceChoice, run: ServiceRun, usual: str, key_header: str, scheme: str = "") -> Web:
    """Return HTTP with an image model, which says nothing for a minute while it draws. Raises ServiceFailure."""
    web = _keyed_web(choice, run, usual, key_header, scheme)
    slow = replace(run.patience, silence=6 * run.patience.silence, answer=3 * run.patience.answer)
    return replace(web, patience=slow)
