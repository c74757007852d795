"""One project, any number of browsers: calls are done in their order, and every browser hears what changed."""

from __future__ import annotations

import asyncio
import logging
import threading
from collections.abc import Callable, Collection, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, Literal

from storyblender.agents.vocabulary import vocabulary
from storyblender.edits.dispatcher import Applied
from storyblender.edits.pulling import UNDECIDED, Choice
from storyblender.errors import InputError, StoryBlenderError
from storyblender.memory.base import shot_name
from storyblender.memory.coverage import as_filmed
from storyblender.memory.edits import LightEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_decision import LightDecision
from storyblender.proposing import pictures_of_other_takes, propose_stagings
from storyblender.session import Session
from storyblender.trace import Event
from storyblender.web_studio.assets import answer_about_assets
from storyblender.web_studio.board import board_of, staging_cards
from storyblender.web_studio.cut import Cut, cut_of
from storyblender.web_studio.deliver import DeliverCall, WriteCall, deliveries_of, write_now
from storyblender.web_studio.drawer import Drawer
from storyblender.web_studio.messages import (
    Answer,
    ApplyCall,
    AssetCall,
    Board,
    Call,
    InstructCall,
    MakeCall,
    News,
    OpenCall,
    PanoramaCall,
    PlainCall,
    ProposeCall,
    ReviseCall,
    SceneCall,
    ShotCall,
    StageCall,
    TakeOverCall,
)
from storyblender.web_studio.scene import scene_details
from storyblender.web_studio.shot import in_inspector
from storyblender.web_studio.stage import stage_of
from storyblender.web_studio.stage_values import Stage
from storyblender.workplace.values import details_of
from storyblender.workplace.workplace import Workplace

_LOG = logging.getLogger(__name__)
_TOLD = ("stage", "propose", "score", "refine", "accept", "handover", "warning")
"""Kinds of events that the page shows as the crew at work."""


class Hub:
    """What the browsers talk to. Calls are made on one thread of their own, so the wire stays free.

    Args:
        folder: Of scripts and projects; nothing outside it is read or written.
        opened: Hears which project is open now; None where there is none.
    """

    def __init__(self, folder: Path, opened: Callable[[Path | None], None] = lambda _: None) -> None:
        self.place = Workplace(folder, self._hear, opened)
        self._calls = ThreadPoolExecutor(1, "calls")
        self._browsers: set[asyncio.Queue[News]] = set()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._drawer: Drawer | None = None
        self.previews: dict[str, Path] = {}
        self.takes: dict[str, Path] = {}
        self._begun: Callable[[], dict[str, Any]] | None = None
        """Makes the story from its script, as it was begun last for the open project."""

    def join(self) -> asyncio.Queue[News]:
        """Return the news for one more browser, from now on."""
        self._loop = asyncio.get_running_loop()
        news: asyncio.Queue[News] = asyncio.Queue()
        self._browsers.add(news)
        return news

    def leave(self, news: asyncio.Queue[News]) -> None:
        """Forget a browser."""
        self._browsers.discard(news)

    async def answer(self, call: Call) -> Answer:
        """Make one call; what cannot be done is an answer, never an exception. Only a cancel overtakes other calls."""
        if isinstance(call, PlainCall) and call.call == "cancel":
            return await asyncio.to_thread(self._said, call.id, self.place.cancel)
        return await asyncio.get_running_loop().run_in_executor(self._calls, self._said, call.id, self._of(call))

    def open(self, project: str) -> None:
        """Open a project, and draw what is not up to date. Raises InputError, ProjectLocked."""
        self._stop_drawing()
        self._begun = None
        try:
            self.place.open(project)
        finally:
            if self.place.is_open:
                self._begin_drawing(self.place.session)

    def begin(self, script: str) -> None:
        """Open the project that was made from a script of the folder; where there is none, make it.

        Raises:
            InputError: No such script.
            ProjectLocked: Another program has the project open.
        """
        project = self.place.project_of(script)
        if project in self.place.names()[1]:
            self.open(project)
        else:
            self.place.make(script, {})
            self._followed()

    def close(self) -> None:
        """End the work under way and close the project."""
        self.place.cancel()
        self._stop_drawing()
        self.place.close()
        self._calls.shutdown()

    def _said(self, number: int, call: Callable[[], Any]) -> Answer:
        try:
            return Answer(id=number, ok=True, value=call())
        except StoryBlenderError as error:
            return Answer(id=number, ok=False, error=str(error))
        except Exception:  # noqa: BLE001 - logged; the page goes on
            _LOG.exception("a call of the page failed")
            return Answer(id=number, ok=False, error="this failed, and should not have; the terminal says more")

    def _of(self, call: Call) -> Callable[[], Any]:
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
                }[call.call]
                return lambda: asked(call.shot)
            case ReviseCall():
                return lambda: self._compare(call) if call.call == "compare" else self._revise(call)
            case ProposeCall():
                return lambda: self._propose(call)
            case PanoramaCall():
                return lambda: self._lit_by(call)
            case WriteCall():
                return lambda: self._write(call)
            case TakeOverCall():
                return lambda: self._pull(Choice(take=call.take, leave=call.leave))
            case PlainCall():
                return {
                    "places": self._places,
                    "board": self.board,
                    "shots": self._shots,
                    "cut": self._cut,
                    "vocabulary": vocabulary,
                    "undo": lambda: self._stepped("undo"),
                    "redo": lambda: self._stepped("redo"),
                    "go_on": self._go_on,
                    "check": self._check,
                    "pull": self._pull,
                    "blender": self._blender,
                    "changes": self._changes,
                }[call.call]
            case _:
                return lambda: self._looked_at(call)

    def _looked_at(self, call: SceneCall | StageCall | AssetCall | DeliverCall) -> Any:
        """Return what a view of the page shows."""
        match call:
            case SceneCall():
                return scene_details(self.place.session.graph, call.scene, self.place.panoramas())
            case StageCall():
                return self._stage(call.shot, call.frame)
            case DeliverCall():
                return deliveries_of(self.place.session, call.layout).model_dump()
            case AssetCall():
                self._refuse_busy()
                return answer_about_assets(self.place.session, call, self._pause_drawing)

    def board(self) -> Board:
        """Return the open project as the page shows it. Raises InputError if there is none."""
        stale = self._drawer.stale if self._drawer is not None else frozenset[str]()
        return board_of(self.place.session, stale, self.previews)

    def _cut(self) -> Cut:
        stale = self._drawer.stale if self._drawer is not None else frozenset[str]()
        return cut_of(self.place.session.graph, stale)

    def _places(self) -> dict[str, Any]:
        scripts, projects = self.place.names()
        return {"scripts": scripts, "projects": projects, "status": self.place.status.model_dump()}

    def _opened(self, project: str) -> Board:
        self.open(project)
        self._tell(News(news="board", revision=self.place.session.revision))
        return self.board()

    def _make(self, call: MakeCall) -> dict[str, Any]:
        self._stop_drawing()
        settings: dict[str, object] = {"look": call.look, "animatic": call.animatic, "crew": call.crew}
        if call.text is None:
            self.place.make(call.script, settings)
        else:
            self.place.make_of(call.script, call.text, settings)
        self._begun = partial(self._make, call)
        return self._followed()

    def _compare(self, call: ReviseCall) -> dict[str, Any]:
        self._refuse_busy()
        self._pause_drawing()
        return self.place.session.compare(self.place.revision(call.script, call.text)).model_dump()

    def _revise(self, call: ReviseCall) -> dict[str, Any]:
        self._refuse_busy()
        script, session = self.place.revision(call.script, call.text), self.place.session
        self._stop_drawing()
        self.place.begin(f"revise {call.script}", lambda: session.make(script))
        self._begun = partial(self._revise, call)
        return self._followed()

    def _followed(self) -> dict[str, Any]:
        """Return how far the work is that has just begun; the browsers hear of it until it ends."""
        threading.Thread(target=self._follow_work, name="work", daemon=True).start()
        return self.place.status.model_dump()

    def _follow_work(self) -> None:
        """Tell the browsers how far the work is until it ends."""
        while True:
            status = self.place.wait(0.5)
            self._tell(News(news="status", status=status))
            if not status.busy:
                break
        if not status.error or status.work.startswith("write "):
            self._begin_drawing(self.place.session)
        self._tell(News(news="board", revision=self.place.session.revision))

    def _shot(self, name: str) -> dict[str, Any]:
        panel, graph = self.place.panel(name), self.place.session.graph
        self._look_at(panel.name)
        return {**details_of(panel, graph).model_dump(), **in_inspector(panel, graph).model_dump()}

    def _shots(self) -> list[dict[str, Any]]:
        graph = self.place.session.graph
        return [details_of(panel, graph).model_dump() for panel in self.place.panels()]

    def _draw_now(self, name: str) -> str:
        """Draw the frame of a shot before all others, and return the name of its file in the project."""
        self._refuse_busy()
        panel = self.place.panel(name)
        self._pause_drawing()
        self.place.session.shoot([panel.name])
        self._frames_drawn([panel.name])
        return f"frames/{panel.name}.png"

    def _why(self, name: str) -> dict[str, Any]:
        self._refuse_busy()
        self._pause_drawing()
        return self.place.session.why(name).model_dump()

    def _takes(self, name: str, of: Literal["camera", "blocking", "layout"]) -> dict[int, str]:
        """Return the addresses of the pictures of a shot's takes, by number; that of the film is on the board."""
        self._refuse_busy()
        self._pause_drawing()
        panel, session = self.place.panel(name), self.place.session
        found = session.takes(panel.name) if of == "camera" else pictures_of_other_takes(session, panel.name, of)
        self.takes |= {f"{panel.name}-{of}-{number}": path for number, path in found.items()}
        return {number: f"/takes/{panel.name}-{of}-{number}.png?v={path.stem}" for number, path in found.items()}

    def _propose(self, call: ProposeCall) -> list[dict[str, Any]]:
        """Return other stagings of a shot's scene; nothing is drawn while they are tried."""
        self._refuse_busy()
        panel, session = self.place.panel(call.shot), self.place.session
        self._stop_drawing()
        try:
            found = propose_stagings(session, panel.name, call.takes)
        finally:
            self._begin_drawing(session)
        cards, self.takes = staging_cards(found, panel.name)
        return [card.model_dump() for card in cards]

    def _stage(self, name: str, frame: int | None) -> Stage:
        """Return the scene of a shot in 3D; what is being drawn waits."""
        self._refuse_busy()
        panel, session = self.place.panel(name), self.place.session
        self._look_at(panel.name)
        self._pause_drawing()
        model, moment = session.moment(panel.name, frame)
        shot = session.graph.shot(panel.shot.scene_id, panel.shot.shot_id)
        return stage_of(session.graph, shot, f"/moments/{model.name}", moment)

    def _edited(self, make: Callable[[Session], Applied], edits: Collection[Any]) -> dict[str, Any]:
        """Make an edit at once, whatever is being drawn, and draw what it made stale."""
        self._refuse_busy()
        session = self.place.session
        self._pause_drawing()
        applied = make(session)
        looked_at = next((edit.shot for edit in edits if hasattr(edit, "shot")), "")
        self._draw(applied.stale, looked_at)
        self._tell(News(news="board", revision=applied.version))
        return applied.model_dump()

    def _pull(self, choice: Choice = UNDECIDED) -> dict[str, Any]:
        """Take over what was changed in Blender, and draw what that makes stale."""
        self._refuse_busy()
        self._pause_drawing()
        pulled = self.place.session.pull(choice=choice)
        self._draw(pulled.applied.stale if pulled.applied is not None else (), "")
        self._tell(News(news="board", revision=self.place.session.revision))
        return pulled.model_dump(exclude={"applied"})

    def _blender(self) -> dict[str, Any]:
        """Return which files were saved in Blender, and how many conflicts wait."""
        session = self.place.session
        return {"saved": session.saved_in_blender if session.made else (), "conflicts": session.waiting_conflicts}

    def _changes(self) -> dict[str, Any]:
        """Return what was changed in Blender; nothing is taken over."""
        self._refuse_busy()
        self._pause_drawing()
        return self.place.session.pull(apply=False).model_dump(exclude={"applied"})

    def _lit_by(self, call: PanoramaCall) -> dict[str, Any]:
        """Take a panorama of the folder into the project, and light a scene by it."""
        self._refuse_busy()
        self._pause_drawing()
        taken_in = self.place.session.take_in_panorama(self.place.panorama(call.file))
        edits = [LightEdit(scene=call.scene, decision=LightDecision(panorama=taken_in))]
        return self._edited(lambda session: session.apply(edits, call.revision), edits)

    def _stepped(self, way: str) -> dict[str, Any]:
        """Undo or redo; a frame that was drawn before is found again."""
        self._refuse_busy()
        session = self.place.session
        self._pause_drawing()
        before = session.graph
        commits = session.undo() if way == "undo" else session.redo()
        self._draw(reached(before, session.graph), "")
        self._tell(News(news="board", revision=session.revision))
        return {
            "revision": session.revision,
            "done": "; ".join(each.reason for each in commits if each.author == "user"),
        }

    def _write(self, call: WriteCall) -> dict[str, Any]:
        """Begin to write something that is delivered; what is to be drawn waits until it is there, or stopped."""
        self._refuse_busy()
        session = self.place.session
        self._stop_drawing()
        self.place.begin(f"write {call.what}", partial(write_now, session, call))
        return self._followed()

    def _go_on(self) -> dict[str, Any]:
        """Go on with work that was stopped, here or in another run of the studio."""
        self._refuse_busy()
        if self._begun is not None:
            return self._begun()
        script = self.place.script_of_open_project
        self._stop_drawing()
        self.place.make(script, self.place.settings_made_with)
        return self._followed()

    def _check(self) -> dict[str, Any]:
        self._refuse_busy()
        found = self.place.session.check()
        return {"clean": found.clean, "findings": list(found.findings)}

    def _draw(self, stale: Collection[str], first: str) -> None:
        if self._drawer is not None:
            for name in stale:
                self.previews.pop(name, None)
            self._drawer.draw(stale, first)

    def _look_at(self, name: str) -> None:
        """Hear which shot a browser shows large: its preview is drawn before those of others."""
        if self._drawer is not None:
            self._drawer.look_at(name)

    def _begin_drawing(self, session: Session) -> None:
        self.previews, self.takes = {}, {}
        heard = (self._previewed, self._frames_drawn, self._failed, self._saved)
        self._drawer = Drawer(session, *heard) if session.made else None
        if self._drawer is not None:
            self._drawer.find_stale()

    def _stop_drawing(self) -> None:
        if self._drawer is not None:
            self._drawer.close()
            self._drawer = None

    def _pause_drawing(self) -> None:
        """End the drawing under way, so that a call need not wait; it goes on by itself after it."""
        if self._drawer is not None:
            self._drawer.interrupt()

    def _refuse_busy(self) -> None:
        if self.place.status.busy:
            raise InputError(f"work is under way: {self.place.status.work}", mend="wait for it, or stop it")

    def _previewed(self, pictures: Mapping[str, Path]) -> None:
        self.previews |= pictures
        self._tell(News(news="frames", shots=tuple(pictures), revision=self.place.session.revision))

    def _frames_drawn(self, names: Collection[str]) -> None:
        self._tell(News(news="frames", shots=tuple(names), revision=self.place.session.revision))

    def _saved(self) -> None:
        self._tell(News(news="blender"))

    def _failed(self, why: str) -> None:
        self._tell(News(news="event", event=Event(kind="warning", role="frames", message=why)))

    def _hear(self, event: Event) -> None:
        if event.kind in _TOLD:
            self._tell(News(news="event", event=event.model_copy(update={"draft": "", "view": ""})))

    def _tell(self, news: News) -> None:
        """Tell all browsers, from any thread."""
        for queue in list(self._browsers):
            assert self._loop is not None, "a browser joined in it"
            with suppress(RuntimeError):  # the loop ends with the server, and a thread may still have something to say
                self._loop.call_soon_threadsafe(queue.put_nowait, news)


def reached(before: ContinuityMemoryGraph, after: ContinuityMemoryGraph) -> list[str]:
    """Return the names of the shots that may look otherwise in one graph than in another.

    Args:
        before: A story.
        after: The same story, changed.
    """
    before, after = as_filmed(before), as_filmed(after)
    scenes = {scene.scene_id: scene for scene in before.scenes}
    shots = {(shot.scene_id, shot.shot_id): shot for shot in before.shots}
    same_things = before.assets == after.assets and before.format == after.format
    return [
        shot_name(shot.scene_id, shot.shot_id)
        for shot in after.shots
        if not same_things
        or scenes.get(shot.scene_id) != after.scene(shot.scene_id)
        or shots.get((shot.scene_id, shot.shot_id)) != shot
    ]
