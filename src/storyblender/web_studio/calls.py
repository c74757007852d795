"""What each call of a browser does to the open project, and what it is answered."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from storyblender.agents.vocabulary import vocabulary
from storyblender.edits.dispatcher import Applied
from storyblender.edits.pulling import UNDECIDED, Choice
from storyblender.errors import InputError
from storyblender.memory.base import shot_name
from storyblender.memory.coverage import as_filmed
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import CAUSED_BY_PERSON
from storyblender.pipeline.shown import as_seen
from storyblender.proposing import picture_of_take, pictures_of_other_takes, propose_stagings
from storyblender.session import Session
from storyblender.web_studio.assets import answer_about_assets
from storyblender.web_studio.board import board_of, staging_cards
from storyblender.web_studio.cut import Cut, cut_of
from storyblender.web_studio.deliver import DeliverCall, WriteCall, deliveries_of, write_now
from storyblender.web_studio.library import shown_library
from storyblender.web_studio.messages import (
    ApplyCall,
    AssetCall,
    Board,
    Call,
    InstructCall,
    LibraryCall,
    MakeCall,
    News,
    OpenCall,
    PicturesCall,
    PlainCall,
    ProposeCall,
    ReviseCall,
    SceneCall,
    ShotCall,
    StageCall,
    TakeOverCall,
)
from storyblender.web_studio.pictures import picture_cards
from storyblender.web_studio.scene import scene_details
from storyblender.web_studio.shot import in_inspector
from storyblender.web_studio.stage import stage_of
from storyblender.web_studio.stage_values import Stage
from storyblender.web_studio.taking import PanoramaCall, SurfaceCall, TakeModelCall, TakeOfferCall, TakingCall, taken_in
from storyblender.workplace.values import details_of

if TYPE_CHECKING:
    from storyblender.web_studio.hub import Hub


class Calls:
    """The calls of the browsers, one after the other.

    Args:
        hub: Holds the project, draws, and tells the browsers what changed.
    """

    def __init__(self, hub: Hub) -> None:
        self._hub, self._place = hub, hub.place

    def handler(self, call: Call) -> Callable[[], Any]:
        """Return what makes a call and returns its value; it raises a StoryBlenderError if it cannot be."""
        match call:
            case OpenCall():
                return lambda: self._opened(call.project)
            case MakeCall():
                return lambda: self._make(call)
            case ApplyCall():
                return lambda: self._edited(lambda session: session.apply(call.edits, call.revision), call.edits)
            case InstructCall():
                return lambda: self._edited(lambda session: session.instruct(call.words, call.revision), ())
            case ShotCall():
                asked = {
                    "shot": self._shot,
                    "why": self._why,
                    "takes": partial(self._takes, of=call.of),
                    "draw": self._draw_now,
                    "draw_take": partial(self._draw_take, of=call.of, number=call.number),
                }[call.call]
                return lambda: asked(call.shot)
            case ReviseCall():
                return lambda: self._compare(call) if call.call == "compare" else self._revise(call)
            case ProposeCall():
                return lambda: self._propose(call)
            case TakeOfferCall() | TakeModelCall() | SurfaceCall() | PanoramaCall():
                return lambda: self._taken_in(call)
            case WriteCall():
                return lambda: self._write(call)
            case TakeOverCall():
                return lambda: self._pull(Choice(take=call.take, leave=call.leave))
            case LibraryCall():
                return lambda: self._library(call)
            case PlainCall():
                return {
                    "places": self._places,
                    "board": self._board,
                    "shots": self._shots,
                    "cut": self._cut,
                    "vocabulary": lambda: vocabulary(self._place.session.own_motions if self._place.is_open else {}),
                    "undo": lambda: self._stepped("undo"),
                    "redo": lambda: self._stepped("redo"),
                    "go_on": self._go_on,
                    "check": self._check,
                    "pull": self._pull,
                    "blender": self._blender,
                    "changes": self._changes,
                    "link": self._link,
                }[call.call]
            case _:
                return lambda: self._looked_at(call)

    def _taken_in(self, call: TakingCall) -> dict[str, Any]:
        """Take something from outside into the project, and make the edit that uses it."""
        return self._edited(lambda session: taken_in(session, self._place, self._hub.uploads, call), ())

    def _looked_at(self, call: SceneCall | StageCall | AssetCall | DeliverCall | PicturesCall) -> Any:
        """Return what a view of the page shows."""
        match call:
            case PicturesCall():
                return self._pictures(call)
            case SceneCall():
                return scene_details(self._place.session.graph, call.scene, self._place.panoramas())
            case StageCall():
                return self._stage(call.shot, call.frame)
            case DeliverCall():
                return deliveries_of(self._place.session, call.layout).model_dump()
            case AssetCall():
                self._hub.refuse_busy()
                return answer_about_assets(self._place.session, call, self._hub.pause_drawing)

    def _board(self) -> Board:
        return board_of(self._place.session, self._hub.stale, self._hub.previews)

    def _cut(self) -> Cut:
        return cut_of(self._place.session.graph, self._hub.stale)

    def _places(self) -> dict[str, Any]:
        scripts, projects = self._place.names()
        return {"scripts": scripts, "projects": projects, "status": self._place.status.model_dump()}

    def _link(self) -> dict[str, str]:
        """Return an address that opens the studio in one more browser; its key works once."""
        if self._hub.invite is None:
            raise InputError("no browser can join here", mend="start it with `storyblender studio`")
        return {"address": self._hub.invite()}

    def _opened(self, project: str) -> Board:
        self._hub.open(project)
        self._hub.tell(News(news="board", revision=self._place.session.revision))
        return self._board()

    def _make(self, call: MakeCall) -> dict[str, Any]:
        self._hub.stop_drawing()
        settings: dict[str, object] = {"look": call.look, "animatic": call.animatic, "crew": call.crew}
        if call.text is None:
            self._place.make(call.script, settings)
        else:
            self._place.make_of(call.script, call.text, settings)
        self._hub.begun = partial(self._make, call)
        return self._hub.followed()

    def _compare(self, call: ReviseCall) -> dict[str, Any]:
        return self._free().compare(self._place.revision(call.script, call.text)).model_dump()

    def _revise(self, call: ReviseCall) -> dict[str, Any]:
        self._hub.refuse_busy()
        script, session = self._place.revision(call.script, call.text), self._place.session
        self._hub.stop_drawing()
        self._place.begin(f"revise {call.script}", lambda: session.make(script))
        self._hub.begun = partial(self._revise, call)
        return self._hub.followed()

    def _shot(self, name: str) -> dict[str, Any]:
        panel, graph = self._place.panel(name), self._place.session.graph
        self._hub.look_at(panel.name)
        return {**details_of(panel, graph).model_dump(), **in_inspector(panel, graph).model_dump()}

    def _shots(self) -> list[dict[str, Any]]:
        graph = self._place.session.graph
        return [details_of(panel, graph).model_dump() for panel in self._place.panels()]

    def _draw_now(self, name: str) -> str:
        """Draw the frame of a shot before all others, and return the name of its file in the project."""
        panel = self._place.panel(name)
        self._free().shoot([panel.name])
        self._hub.drawn_now(panel.name)
        return f"frames/{panel.name}.png"

    def _why(self, name: str) -> dict[str, Any]:
        return self._free().why(name).model_dump()

    def _takes(self, name: str, of: Literal["camera", "blocking", "layout"]) -> dict[int, str]:
        """Return the addresses of the pictures of a shot's takes, by number; that of the film is on the board."""
        panel, session = self._place.panel(name), self._free()
        found = session.takes(panel.name) if of == "camera" else pictures_of_other_takes(session, panel.name, of)
        return {number: self._address_of_take(panel.name, of, number, path) for number, path in found.items()}

    def _draw_take(self, name: str, of: Literal["camera", "blocking", "layout"], number: int | None) -> str:
        """Draw a take that the film does not show, small and quickly, and return the address of the picture."""
        panel, session = self._place.panel(name), self._free()
        return self._address_of_take(panel.name, of, number, picture_of_take(session, panel.name, of, number))

    def _address_of_take(self, shot: str, of: str, number: int | None, picture: Path) -> str:
        self._hub.takes[f"{shot}-{of}-{number}"] = picture
        return f"/takes/{shot}-{of}-{number}.png?v={picture.stem}"

    def _propose(self, call: ProposeCall) -> list[dict[str, Any]]:
        """Return other stagings of a shot's scene; nothing is drawn while they are tried."""
        self._hub.refuse_busy()
        panel, session = self._place.panel(call.shot), self._place.session
        self._hub.stop_drawing()
        try:
            found = propose_stagings(session, panel.name, call.takes)
        finally:
            self._hub.begin_drawing(session)
        cards, self._hub.takes = staging_cards(found, panel.name)
        return [card.model_dump() for card in cards]

    def _stage(self, name: str, frame: int | None) -> Stage:
        """Return the scene of a shot in 3D; what is being drawn waits."""
        panel, session = self._place.panel(name), self._free()
        self._hub.look_at(panel.name)
        model, moment = session.moment(panel.name, frame)
        shot = session.graph.shot(panel.shot.scene_id, panel.shot.shot_id)
        return stage_of(session.graph, shot, f"/moments/{model.name}", moment)

    def _edited(self, make: Callable[[Session], Applied], edits: Collection[Any]) -> dict[str, Any]:
        """Make an edit at once, whatever is being drawn, and draw what it made stale."""
        session = self._free()
        applied = make(session)
        looked_at = next((edit.shot for edit in edits if hasattr(edit, "shot")), "")
        self._hub.draw(applied.stale, looked_at)
        self._hub.tell(News(news="board", revision=applied.version))
        return applied.model_dump()

    def _pull(self, choice: Choice = UNDECIDED) -> dict[str, Any]:
        """Take over what was changed in Blender, and draw what that makes stale."""
        session = self._free()
        pulled = session.pull(choice=choice)
        self._hub.draw(pulled.applied.stale if pulled.applied is not None else (), "")
        self._hub.tell(News(news="board", revision=session.revision))
        return pulled.model_dump(exclude={"applied"})

    def _blender(self) -> dict[str, Any]:
        """Return which files were saved in Blender, and how many conflicts wait."""
        session = self._place.session
        return {"saved": session.saved_in_blender if session.made else (), "conflicts": session.waiting_conflicts}

    def _changes(self) -> dict[str, Any]:
        """Return what was changed in Blender; nothing is taken over."""
        return self._free().pull(apply=False).model_dump(exclude={"applied"})

    def _library(self, call: LibraryCall) -> Any:
        """Return what of the user's library is shown, or the address of a picture that is drawn now."""
        if call.call == "library":
            return shown_library(call.words).model_dump()
        self._free().draw_library_picture(call.digest)
        return f"/library/{call.digest}.png"

    def _pictures(self, call: PicturesCall) -> list[dict[str, Any]]:
        """Return the surfaces or the panoramas of the folder, and those of the library."""
        own = self._place.surfaces() if call.kind == "texture" else self._place.panoramas()
        return [card.model_dump() for card in picture_cards(own, self._free().library_pictures(call.kind), call.words)]

    def _stepped(self, way: str) -> dict[str, Any]:
        """Undo or redo; a frame that was drawn before is found again."""
        session = self._free()
        before = session.graph
        commits = session.undo() if way == "undo" else session.redo()
        self._hub.draw(reached(before, session.graph), "")
        self._hub.tell(News(news="board", revision=session.revision))
        return {
            "revision": session.revision,
            "done": "; ".join(each.reason for each in commits if each.author in CAUSED_BY_PERSON),
        }

    def _write(self, call: WriteCall) -> dict[str, Any]:
        """Begin to write something that is delivered; what is to be drawn waits until it is there, or stopped."""
        self._hub.refuse_busy()
        session = self._place.session
        self._hub.stop_drawing()
        self._place.begin(f"write {call.what}", partial(write_now, session, call))
        return self._hub.followed()

    def _go_on(self) -> dict[str, Any]:
        """Go on with work that was stopped, here or in another run of the studio."""
        self._hub.refuse_busy()
        if self._hub.begun is not None:
            return self._hub.begun()
        script = self._place.script_of_open_project
        self._hub.stop_drawing()
        self._place.make(script, self._place.settings_made_with)
        return self._hub.followed()

    def _check(self) -> dict[str, Any]:
        self._hub.refuse_busy()
        found = self._place.session.check()
        return {"clean": found.clean, "findings": list(found.findings)}

    def _free(self) -> Session:
        """Return the open project for a call that needs it to itself: work is refused, drawing gives way."""
        self._hub.refuse_busy()
        self._hub.pause_drawing()
        return self._place.session


def reached(before: ContinuityMemoryGraph, after: ContinuityMemoryGraph) -> list[str]:
    """Return the names of the shots that may look otherwise in one graph than in another.

    Args:
        before: A story.
        after: The same story, changed.
    """
    before, after = as_filmed(before), as_filmed(after)
    scenes = {scene.scene_id: scene for scene in before.scenes}
    shots = {(shot.scene_id, shot.shot_id): as_seen(shot) for shot in before.shots}
    same_things = before.assets == after.assets and before.format == after.format
    return [
        shot_name(shot.scene_id, shot.shot_id)
        for shot in after.shots
        if not same_things
        or scenes.get(shot.scene_id) != after.scene(shot.scene_id)
        or shots.get((shot.scene_id, shot.shot_id)) != as_seen(shot)
    ]
