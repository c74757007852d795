"""Draws what edits made stale, beside the conversation: previews, then frames, at last what is delivered."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from storyblender.errors import Cancelled, StoryBlenderError
from storyblender.memory.base import shot_name
from storyblender.session import Session

_LOG = logging.getLogger(__name__)
PAIR = 2
"""Frames that are drawn side by side."""
REST = 2.0
"""Seconds without an edit before the frames themselves are drawn."""
LOOK = 5.0
"""Seconds between two looks whether a person saved story.blend in Blender, while there is nothing to do."""
IDLE = 15.0
"""Seconds without an edit before board, lists and story.blend are written."""

Shown = Callable[[Mapping[str, Path]], None]


class Drawer:
    """A thread that draws the stale shots of a session; an edit interrupts it, and it goes on after it.

    Args:
        session: Open and made.
        previewed: Hears of new previews, by shot name.
        drawn: Hears that frames are new, with their previews' places taken.
        failed: Hears why something could not be drawn, in a sentence.
        saved: Hears, once a save, that a person saved story.blend in Blender; nothing is delivered before that is taken
            over.
    """

    def __init__(
        self,
        session: Session,
        previewed: Shown,
        drawn: Callable[[Collection[str]], None],
        failed: Callable[[str], None],
        saved: Callable[[], None],
    ) -> None:
        self._session, self._previewed, self._drawn = session, previewed, drawn
        self._failed, self._saved = failed, saved
        self._waiting: dict[str, bool] = {}
        self._undrawn: frozenset[str] = frozenset()
        """Shots whose frames could not be drawn, and are not tried again by themselves."""
        self._saved_ones: Mapping[str, float] = {}
        """Files that were saved in Blender, as was told, and when each was."""
        self._looked_at = self._edited = self._ready_for = ""
        self._touched = time.monotonic()
        """When a person last edited something, or looked at another shot."""
        self._changed = threading.Condition()
        self._working = self._ended = self._paused = self._unknown = self._delivering = False
        self._thread = threading.Thread(target=self._run, name="drawer", daemon=True)
        self._thread.start()

    @property
    def stale(self) -> frozenset[str]:
        """Names of the shots whose frames do not show the story as it is."""
        with self._changed:
            return self._undrawn.union(self._waiting)

    def find_stale(self) -> None:
        """Find out which frames do not show the story as it is, and draw them."""
        with self._changed:
            self._unknown = True
            self._changed.notify_all()

    def look_at(self, name: str) -> None:
        """Hear which shot a person looks at: its preview comes first, and Blender gets ready for edits of it.

        Of the shots of other scenes no previews are drawn any more; their frames are drawn after a rest without edits.
        """
        with self._changed:
            self._looked_at, self._touched = name, time.monotonic()
            self._waiting = {each: preview and _share_scene(each, name) for each, preview in self._waiting.items()}
            if self._working and self._is_unready():  # frames and what is delivered can wait
                self._session.cancel()
            self._changed.notify_all()

    def draw(self, names: Collection[str], first: str = "") -> None:
        """Draw shots as soon as there is nothing to be edited; the one that a person looks at alone, before all others.

        Args:
            names: Shots that show something else now.
            first: The one that was edited; it comes first where another one is looked at. Previews are drawn of its
                scene only, those of its other shots after a rest, so that Blender is ready for the next edit of it.
        """
        with self._changed:
            first = self._edited = self._looked_at if self._looked_at in names else first
            near = sorted(names, key=lambda name: (name != first, not _share_scene(name, first)))
            shown = {name: not first or _share_scene(name, first) for name in near}
            self._waiting = shown | {name: False for name in self._waiting if name not in names}
            self._undrawn = self._undrawn.difference(names)
            self._delivering = True
            self._changed.notify_all()

    def is_drawn(self, name: str) -> None:
        """Hear that a call drew the frame of a shot as it is now."""
        with self._changed:
            self._undrawn = self._undrawn.difference((name,))
            self._waiting.pop(name, None)

    def pause(self) -> None:
        """End the drawing under way, and begin none before ``go_on``, so that an edit need not wait."""
        with self._changed:
            self._paused, self._touched = True, time.monotonic()
            if self._working:
                self._session.cancel()

    def go_on(self) -> None:
        """Draw again after a pause; what was not drawn is still stale."""
        with self._changed:
            if self._paused:
                self._paused, self._touched = False, time.monotonic()
            self._changed.notify_all()

    def close(self) -> None:
        """End the thread."""
        with self._changed:
            self._ended = True
            self._changed.notify_all()
        self.pause()
        self._thread.join(60)

    def _run(self) -> None:
        with suppress(StoryBlenderError):  # closed meanwhile
            self._session.warm()
        while True:
            with self._changed:
                self._working = False
                has_work = self._changed.wait_for(self._has_work, LOOK)
            if not has_work:
                with suppress(StoryBlenderError, OSError):  # closed meanwhile, or a file is being replaced
                    self._look_for_saved()
                continue
            with self._changed:
                if not self._unknown:
                    self._wait_for_rest()
                if self._ended:
                    return
                if self._paused:
                    continue
                there = self._shots()
                self._waiting = {name: preview for name, preview in self._waiting.items() if name in there}
                previews = [name for name, preview in self._waiting.items() if preview]
                wanted = sorted(previews, key=lambda name: name != self._looked_at)[:1]
                look = self._looked_at if self._is_unready() and self._looked_at in there else ""
                if not look:
                    self._ready_for = self._looked_at
                if not self._waiting and not self._unknown and not self._delivering and not look:
                    continue
                self._working, all_of_them, unknown = True, tuple(self._waiting), self._unknown
                rehearsing = bool(look) and look not in wanted and not unknown
            try:
                if wanted and not rehearsing and not unknown:
                    self._ready_for = look or self._ready_for
                self._work(look if rehearsing else "", wanted, all_of_them, unknown=unknown)
            except Cancelled:
                continue
            except StoryBlenderError as error:
                if rehearsing or not self._shots().issuperset(wanted or all_of_them):
                    continue  # a preview will say why; or an edit or an undo took one of them away meanwhile
                self._give_up(wanted or all_of_them, str(error), drawn=not wanted)
            except Exception:  # noqa: BLE001 - logged; the other pictures are drawn
                _LOG.exception("a picture of the page failed")
                sentence = "a picture could not be drawn, and should have been; the terminal says more"
                if not rehearsing:
                    self._give_up(wanted or all_of_them, sentence, drawn=not wanted)

    def _wait_for_rest(self) -> None:
        """Wait until a person rests, or something is to be done at once; an edit on the way begins the rest anew."""
        while not self._is_asked():
            rested = time.monotonic() - self._touched
            left = (REST if self._waiting else IDLE) - rested
            if left <= 0:
                break
            self._changed.wait(left)

    def _work(self, rehearsed: str, wanted: Sequence[str], all_of_them: Sequence[str], *, unknown: bool) -> None:
        """Do what comes first: find out what is stale, get ready for a shot, draw a preview, frames, what is delivered.

        Raises:
            StoryBlenderError: It cannot be drawn.
            Cancelled: An edit came.
        """
        if unknown:
            self.draw(self._session.stale_frames())
            self._unknown, self._delivering = False, not self._session.delivered
        elif rehearsed:
            self._ready_for = rehearsed
            self._session.rehearse(rehearsed)
        elif wanted:
            self._previewed(self._session.preview(wanted))
            self._settle(wanted, drawn=False)
        elif all_of_them:
            next_ones = all_of_them[:PAIR]
            self._session.shoot(next_ones)
            self._settle(next_ones, drawn=True)
            self._drawn(next_ones)
        elif self._look_for_saved():
            self._delivering = False
        else:
            self._session.render()
            self._delivering, self._undrawn = False, frozenset()
            self._drawn(())

    def _look_for_saved(self) -> bool:
        """Tell of what was saved in Blender since it was last told; return whether anything was and waits."""
        names = self._session.saved_in_blender
        saved = {name: (self._session.folder / name).stat().st_mtime for name in names}
        if saved and saved != self._saved_ones:
            self._saved()
        self._saved_ones = saved
        return bool(saved)

    def _give_up(self, names: Collection[str], why: str, *, drawn: bool) -> None:
        """Leave what cannot be drawn as it is, and say why."""
        self._unknown = False
        self._delivering = self._delivering and bool(names)
        self._settle(names, drawn=drawn)
        if drawn:
            self._undrawn = self._undrawn.union(names)
        self._failed(why)

    def _is_unready(self) -> bool:
        """Whether a person looks at a shot that Blender is not ready for."""
        return self._looked_at != self._ready_for

    def _has_work(self) -> bool:
        """Whether there is drawing to do and it is not paused, or the drawer was closed."""
        waits = self._waiting or self._unknown or self._delivering or self._is_asked()
        return self._ended or (bool(waits) and not self._paused)

    def _is_asked(self) -> bool:
        """Whether there is something to do at once: the end, a preview, a look at another shot."""
        looked_at = [preview for name, preview in self._waiting.items() if name in (self._edited, self._looked_at)]
        return self._ended or any(looked_at) or self._is_unready()

    def _shots(self) -> set[str]:
        """Return the names of the shots that there are now."""
        return {shot_name(shot.scene_id, shot.shot_id) for shot in self._session.graph.shots if not shot.joined}

    def _settle(self, names: Collection[str], *, drawn: bool) -> None:
        with self._changed:
            if drawn:
                self._waiting = {name: wait for name, wait in self._waiting.items() if name not in names or wait}
            else:
                self._waiting |= {name: False for name in names if name in self._waiting}


def _share_scene(one: str, other: str) -> bool:
    """Return whether two shots are of one scene, by their names."""
    return one.partition("_")[0] == other.partition("_")[0]
