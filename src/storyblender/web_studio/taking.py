"""Things from outside that a person has used in the story: each call takes one into the project, and makes one edit."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from storyblender.edits.dispatcher import Applied
from storyblender.edits.targets import person_or_thing, scene_named
from storyblender.errors import InputError
from storyblender.memory.edits import AssetEdit, Edit, LightEdit, SetEdit
from storyblender.memory.scene_decision import LightDecision, SetDecision
from storyblender.session import Session
from storyblender.web_studio.page_call import PageCall
from storyblender.web_studio.uploads import BATCH, Uploads
from storyblender.workplace.workplace import Workplace

_Name = Annotated[str, Field(min_length=1, max_length=128)]


class SurfaceCall(PageCall):
    """Makes the walls or the ground of a set of a picture, of the folder or of the library: one undo.

    Without a picture, that which they are made of gets another width.
    """

    call: Literal["surface"]
    """Which call this is."""
    scene: _Name
    """Such as ``SC010``."""
    part: Literal["walls", "ground"]
    """What is made of it."""
    file: Annotated[str, Field(max_length=300)] = ""
    """Path of its colour picture in the folder."""
    entry: Annotated[str, Field(max_length=64)] = ""
    """Or its digest in the library."""
    metres: Annotated[float, Field(ge=0.01, le=25)] | None = None
    """Width of the picture; what is known of it, or the usual, if not given."""
    revision: _Name | None = None
    """What the person saw when they chose it."""


class PanoramaCall(PageCall):
    """Lights a scene by a panorama of the folder or of the library: one undo."""

    call: Literal["panorama"]
    """Which call this is."""
    scene: _Name
    """Such as ``SC010``."""
    file: Annotated[str, Field(max_length=128)] = ""
    """File name of an .hdr or .exr in the folder."""
    entry: Annotated[str, Field(max_length=64)] = ""
    """Or its digest in the library."""
    revision: _Name | None = None
    """What the person saw when they chose it."""


class TakeOfferCall(PageCall):
    """Has a thing made from a model that a service offers, which is fetched first: one undo."""

    call: Literal["take_offer"]
    """Which call this is."""
    thing: _Name
    """Its id."""
    file: Annotated[str, Field(min_length=1, max_length=256)]
    """Of what is offered."""
    revision: _Name | None = None
    """What the person saw when they chose it."""


class TakeModelCall(PageCall):
    """Has a thing made from a model that the page has sent, file by file: one undo."""

    call: Literal["take_model"]
    """Which call this is."""
    thing: _Name
    """Its id."""
    batch: Annotated[str, Field(pattern=f"^{BATCH.pattern}$")]
    """What the page called its files."""
    revision: _Name | None = None
    """What the person saw when they chose it."""


TakingCall = TakeOfferCall | TakeModelCall | SurfaceCall | PanoramaCall


def taken_in(session: Session, place: Workplace, uploads: Uploads, call: TakingCall) -> Applied:
    """Take something from outside into the project, and make the edit that uses it.

    Args:
        session: Open, with nothing under way.
        place: The folder, with the person's own pictures.
        uploads: The files that pages have sent.
        call: What is taken.

    Raises:
        InputError: It is not there, or cannot be used.
    """
    match call:
        case TakeOfferCall():
            edit = _made_from_offer(session, call)
        case TakeModelCall():
            edit = _made_from_given(session, uploads, call)
        case SurfaceCall():
            edit = _made_of(session, place, call)
        case PanoramaCall():
            edit = _lit_by(session, place, call)
    return session.apply([edit], call.revision)


def _made_from_offer(session: Session, call: TakeOfferCall) -> Edit:
    """Fetch a model that a service offers, for a thing to be made from it."""
    session.take_offer(call.file)
    return AssetEdit(thing=call.thing, file=call.file)


def _made_from_given(session: Session, uploads: Uploads, call: TakeModelCall) -> Edit:
    """Keep a model that the page has sent in the project, for a thing to be made from it."""
    files = uploads.files(call.batch)
    if not files:
        raise InputError("the model did not arrive", mend="choose it again")
    thing = person_or_thing(session.graph, call.thing)
    try:
        return AssetEdit(thing=thing, file=session.take_in_model(thing, files))
    finally:
        uploads.forget()


def _lit_by(session: Session, place: Workplace, call: PanoramaCall) -> Edit:
    """Take a panorama of the folder or of the library into the project, for a scene to be lit by it."""
    if call.entry:
        panorama = session.take_library_panorama(call.entry)
    else:
        panorama = session.take_in_panorama(place.panorama(call.file))
    return LightEdit(scene=call.scene, decision=LightDecision(panorama=panorama))


def _made_of(session: Session, place: Workplace, call: SurfaceCall) -> Edit:
    """Take a surface of the folder or of the library into the project, for a part of a set to be made of it."""
    name = {"walls": "wall_texture", "ground": "ground_texture"}[call.part]
    if call.entry:
        texture = session.take_library_texture(call.entry, call.metres)
    elif call.file:
        texture = session.take_in_texture(place.surface(call.file), call.metres)
    else:
        texture = getattr(scene_named(session.graph, call.scene).environment, name, None)
        if texture is None or call.metres is None:
            raise InputError(f"there is no picture on the {call.part}", mend="choose one first")
        texture = texture.model_copy(update={"metres": call.metres})
    return SetEdit(scene=call.scene, decision=SetDecision.model_validate({name: texture}))
