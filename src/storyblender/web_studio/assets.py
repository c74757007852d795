"""People and things as the page shows them: the list of all, one of them large, what it could be made from instead."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from storyblender.agents.concept_artist.asset_formatter import AS_IN_FILE
from storyblender.catalog.props import PROPS
from storyblender.edits.targets import person_or_thing
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
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
    score: float
    """How well it fits what the script says, 1 to 10."""
    chosen: bool
    """Whether the thing is made from it now."""
    picture: str
    """Address; empty while it is not drawn."""


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
    own = made.source == "file"
    return Candidate(
        digest=AssetJob(asset=offered).digest,
        model="" if own else made.key,
        file=made.key if own else "",
        name=made.key if own else PROPS[made.key].name,
        source="your models" if own else "library",
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
