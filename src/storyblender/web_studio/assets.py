"""People and things as the page shows them: the list of all, one of them large, what it could be made from instead."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path, PurePosixPath
from typing import Any, Literal

from storyblender.agents.concept_artist.asset_formatter import AS_IN_FILE
from storyblender.catalog.props import PROPS
from storyblender.edits.targets import person_or_thing
from storyblender.errors import InputError
from storyblender.library.library_source import LibrarySource
from storyblender.library.model_folders import ModelFolders
from storyblender.library.shared.entries import ADDED
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset, Provenance
from storyblender.memory.base import Described
from storyblender.memory.jobs import AssetJob
from storyblender.pipeline.asset_pictures import view_name
from storyblender.session import Session
from storyblender.web_studio.messages import AssetCall
from storyblender.workplace.cast import AssetCard, AssetDetails, LookChoices, asset_details, cards_of, look_choices


class PicturedCard(AssetCard):
    """A person or a thing in the list, with its picture."""

    picture: str
    """Address; empty while it is not drawn."""


class Cast(Described):
    """All people and things of the story."""

    cards: tuple[PicturedCard, ...]
    """People first."""
    choices: LookChoices
    """What people can look like."""


class Candidate(Described):
    """What a thing could be made from instead."""

    digest: str
    """Its picture is asked for by it."""
    model: str
    """As an edit names it: of the library."""
    file: str
    """As an edit names it: a model in the user's folders."""
    name: str
    """As people call it."""
    source: str
    """Where it is from."""
    credit: str
    """Author and licence; empty where none is stated."""
    score: float
    """How well it fits what the script says, 1 to 10."""
    chosen: bool
    """Whether the thing is made from it now."""
    picture: str
    """Address; empty while it is not drawn."""


class OfferedCard(Described):
    """What a service offers for a thing; it is fetched when it is chosen."""

    file: str
    """As ``take_offer`` names it."""
    name: str
    """What the service calls it."""
    source: str
    """The service."""
    credit: str
    """Author and licence."""
    url: str
    """Page of the work; empty unless it is an address of the web."""
    megabytes: float
    """Of the download; 0 where it is not known yet."""
    score: float
    """How well it fits what is looked for, 1 to 10."""
    chosen: bool
    """Whether the thing is made from it now."""
    picture: str
    """Address; empty while it is not asked for."""


class ShownOffers(Described):
    """What services offer for a thing."""

    services: tuple[str, ...]
    """Those that were asked; empty where the settings name none."""
    waiting: tuple[str, ...]
    """Those that have not answered yet: asked again in a moment, there may be more."""
    failures: tuple[str, ...]
    """What is wrong with those that cannot be asked, a sentence each."""
    cards: tuple[OfferedCard, ...]
    """Best first."""


class ShownAsset(AssetDetails):
    """A person or a thing, large."""

    front: str
    """Side of a model of the user, as its file has it, that is its front; empty where rules found it."""
    top: str
    """The same of its top."""


def answer_about_assets(session: Session, call: AssetCall, pause: Callable[[], None]) -> Any:
    """Return what the page asks about people and things; what is there already needs no engine, and no waiting for it.

    Args:
        session: Open.
        call: What it asks.
        pause: Ends what is being drawn, so that the engine is free.

    Raises:
        InputError: There is no such person or thing.
    """
    if call.call == "assets":
        return _cast(session).model_dump()
    asset = session.graph.asset(person_or_thing(session.graph, call.asset))
    match call.call:
        case "asset":
            return _shown(session, _built(session, asset, pause)).model_dump()
        case "asset_picture":
            shown = _offered(session, asset, call) if call.digest else _built(session, asset, pause)
            return _view(session, shown, "png", pause)
        case "asset_model":
            built = _built(session, asset, pause)
            return _view(session, _as_in_file(built) if call.as_in_file else built, "glb", pause)
        case "offers":
            pause()
            return _offers(session, asset, call.words).model_dump()
        case "offer_picture":
            pause()
            picture = session.offer_picture(call.file)
            return _address(picture) if picture is not None else ""
        case _:
            pause()
            offered = session.candidates(asset.asset_id, call.words)
            return [_candidate(session, asset, each).model_dump() for each in offered]


def _built(session: Session, asset: Asset, pause: Callable[[], None]) -> Asset:
    """Return an asset of the story, built."""
    if asset.canonical is not None and asset.canonical.geometry_hash:
        return asset
    pause()
    return session.built_asset(asset.asset_id)


def _view(session: Session, asset: Asset, kind: Literal["png", "glb"], pause: Callable[[], None]) -> str:
    """Return the address of an asset as a picture or as glTF."""
    path = session.folder / view_name(session.graph, asset, kind)
    if not path.is_file():
        pause()
        path = session.asset_view(asset, kind)
    return _address(path)


def _cast(session: Session) -> Cast:
    graph = session.graph
    pictures = {asset.asset_id: _drawn(session, asset) for asset in graph.assets}
    cards = (PicturedCard(**card.model_dump(), picture=pictures[card.asset]) for card in cards_of(graph))
    return Cast(cards=tuple(cards), choices=look_choices())


def _shown(session: Session, asset: Asset) -> ShownAsset:
    details = asset_details(session.graph, asset.asset_id)
    params = asset.canonical.params if asset.canonical is not None and asset.canonical.source == "file" else {}
    sides = {name: str(params.get(name, "")) for name in ("front", "top")}
    return ShownAsset.model_validate({**details.model_dump(), **sides})


def _offered(session: Session, asset: Asset, call: AssetCall) -> Asset:
    """Return the candidate that is meant. Raises InputError."""
    for each in session.candidates(asset.asset_id, call.words):
        if AssetJob(asset=each).digest == call.digest:
            return each
    raise InputError("it is not offered any more", mend="look at the candidates again")


def _candidate(session: Session, asset: Asset, offered: Asset) -> Candidate:
    made = offered.canonical
    assert made is not None, "what is offered is known"
    own, origin = made.source == "file", made.provenance or Provenance(source="", file="")
    return Candidate(
        digest=AssetJob(asset=offered).digest,
        model="" if own else made.key,
        file=made.key if own else "",
        name=_name_of_file(made.key, origin.source) if own else PROPS[made.key].name,
        source=_place_of(origin.source) if own else "built in",
        credit=", ".join(filter(None, (origin.author, origin.license))) if own else "",
        score=made.match_score or 0.0,
        chosen=asset.canonical is not None and asset.canonical.key == made.key,
        picture=_drawn(session, offered),
    )


def _as_in_file(asset: Asset) -> Asset:
    """Return a thing in the pose that its model file has. Raises InputError."""
    made = asset.canonical
    if made is None or made.source != "file":
        raise InputError(f"{asset.asset_id} is no model of yours", mend="only those are turned")
    params = {**made.params, **AS_IN_FILE.params}
    return asset.model_copy(update={"canonical": made.model_copy(update={"params": params, "geometry_hash": ""})})


def _drawn(session: Session, asset: Asset) -> str:
    """Return the address of the picture of an asset; empty if it is not drawn yet."""
    path = session.folder / view_name(session.graph, asset, "png")
    return _address(path) if path.is_file() else ""


def _address(path: Path) -> str:
    return f"/cast/{path.name}"


def _name_of_file(key: str, source: str) -> str:
    """Return what a model in a folder or in the library is called."""
    entry = SharedLibrary.open().told(key) if source != ModelFolders.name else None
    return entry.name if entry is not None else PurePosixPath(key).stem.replace("_", " ")


def _place_of(source: str) -> str:
    """Return where a model is, as people say it."""
    if source == ModelFolders.name:
        return "your folders"
    if source in ("", ADDED, LibrarySource.name):
        return "your library"
    return f"your library, from {source.replace('_', ' ').title()}"


def _offers(session: Session, asset: Asset, words: str) -> ShownOffers:
    """Return what services offer for a thing, but for what the library has, which is among the candidates."""
    made, library = asset.canonical, SharedLibrary.open()
    offered = session.offers(asset.asset_id, words)
    cards = tuple(
        OfferedCard(
            file=each.key,
            name=each.offer.name,
            source=each.offer.service,
            credit=", ".join(filter(None, (each.offer.author, each.offer.licence.name))),
            url=each.offer.url if each.offer.url.startswith(("https://", "http://")) else "",
            megabytes=round(each.offer.bytes / 1e6, 1),
            score=each.score,
            chosen=made is not None and made.key == each.key,
            picture=_address(session.folder / each.picture) if (session.folder / each.picture).is_file() else "",
        )
        for each in offered.models
        if library.told(each.key) is None
    )
    return ShownOffers(
        services=session.catalogues,
        waiting=offered.waiting,
        failures=tuple(map(_with_service, offered.failures)),
        cards=cards,
    )


def _with_service(failure: str) -> str:
    """Return what is wrong with a service, with the name of it as people say it."""
    service, colon, problem = failure.partition(": ")
    return f"{service.replace('_', ' ').title()}{colon}{problem}"
