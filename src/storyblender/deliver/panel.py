"""A panel: the names, words and numbers of one shot, as every deliverable shows them."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, groupby
from string import capwords
from typing import Literal

from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import shot_name
from storyblender.memory.camera_words import listed
from storyblender.memory.coverage import as_filmed
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline
from storyblender.memory.shot_context import ShotContext
from storyblender.memory.vocabulary import Movement
from storyblender.screenplay.comments import without_comments
from storyblender.screenplay.cues import strip_emphasis

Way = Literal["left", "right", "up", "down", "in", "out"]
"""Direction of a camera move on the screen."""
STOPS = (".", "!", "?", "…", ":", "。", "！", "？")
"""Characters that end a sentence."""
_QUOTATION = 70
"""Most characters of a speech in a description."""
STILL = 0.02
"""Metres moved, or radians turned, below which a camera counts as static."""
USUAL_CLOSING = 0.7
"""Share of the starting picture that a push in ends on, where the shot has no camera yet."""
KIND_LABEL = {
    "two_shot": "two-shot",
    "ots": "over the shoulder",
    "pov": "POV",
    "establishing": "establishing",
    "insert": "insert",
    "reaction": "reaction",
    "group": "group",
}


@dataclass(frozen=True)
class Panel:
    """What board, shot list, timeline and page say about one shot.

    Attributes:
        name: Slate, e.g. ``SC010_SH020``.
        scene: Its scene in the outline.
        outline: Its script lines.
        shot: Its context.
        start: First frame on the story's timeline.
        fps: Frames a second.
        lines: Its script lines without notes and the marks of emphasis; an action line has an ellipsis where its
            sentence is cut.
        description: What happens: the lines in order, with who speaks to whom; without lines, whom or what it shows.
        omitted: Whether a person left the shot, or its scene, out of the film.
        opens: Whether it is the first of its scene in the film.
    """

    name: str
    scene: SceneOutline
    outline: ShotOutline
    shot: ShotContext
    start: int
    fps: int
    lines: tuple[ScriptLine, ...]
    description: str
    omitted: bool = False
    opens: bool = False

    @property
    def lens(self) -> float:
        """mm; 0 while the crew is still to choose it."""
        camera = self.shot.camera
        if camera is not None:
            return camera.poses[0].lens
        return self.shot.camera_instruction.lens or 0.0

    @property
    def framing(self) -> str:
        """Size and kind, e.g. ``MCU over the shoulder``."""
        instruction = self.shot.camera_instruction
        label = KIND_LABEL.get(instruction.kind)
        return f"{instruction.size} {label}" if label else instruction.size

    @property
    def facts(self) -> str:
        """The camera in a line, e.g. ``MCU over the shoulder · low angle · 65 mm · push in``."""
        angle = self.shot.camera_instruction.angle
        lens = f"{self.lens:.0f} mm" if self.lens else ""
        said = (self.framing, "" if angle == "eye-level" else angle, lens, self.movement)
        return " · ".join(filter(None, said))

    @property
    def closes_to(self) -> float:
        """Width of the narrowest view divided by that of the widest, at the pivot; for push in and pull out."""
        camera = self.shot.camera
        if camera is None:
            return USUAL_CLOSING
        views = [pose.distance / pose.lens for pose in (camera.poses[0], camera.poses[-1])]
        return min(views) / max(views)

    @property
    def move(self) -> Movement:
        """The move that the camera really makes.

        A static shot whose camera turns to follow a person is a pan; a move whose camera keeps one pose is static.
        """
        wanted, camera = self.shot.camera_instruction.movement, self.shot.camera
        if camera is None:
            return wanted
        if wanted == "static":
            return wanted if camera.poses[0].rotation == camera.poses[-1].rotation else "pan"
        return "static" if len(camera.poses) == 1 else wanted

    @property
    def movement(self) -> str:
        """The camera move in words."""
        movement, way = self.move, self.way
        return f"{movement} {way}" if way and not movement.endswith(way) else movement

    @property
    def way(self) -> Way | None:
        """Direction of the move: measured from the camera, else as the script says; None if static."""
        move, camera = self.move, self.shot.camera
        if move == "static":
            return None
        if move in ("push in", "zoom in"):
            return "in"
        if move in ("pull out", "zoom out"):
            return "out"
        if camera is None:
            return self.shot.camera_instruction.direction
        first, last = (Orbit(p.pivot, p.rotation, p.distance, p.lens) for p in (camera.poses[0], camera.poses[-1]))
        goes = last.position - first.position
        if move in ("pan", "tilt"):
            goes = first.axes[:, 2] - last.axes[:, 2]
        right, up, back = first.axes.T @ goes
        ways: dict[Way, float] = {"left": -right, "right": right, "down": -up, "up": up, "in": -back, "out": back}
        if move in ("pan", "tilt"):
            del ways["in"], ways["out"]
        way = max(ways, key=lambda way: ways[way])
        return way if ways[way] > STILL else None

    @property
    def seconds(self) -> float:
        """Length of the shot."""
        return self.shot.duration / self.fps

    @property
    def dialogue(self) -> tuple[ScriptLine, ...]:
        """The speeches in the script's own words."""
        return tuple(line for line in self.lines if line.kind == "dialogue")

    @property
    def action(self) -> str:
        """The action lines in the script's own words."""
        return " ".join(line.text for line in self.lines if line.kind == "action" and line.text)

    @property
    def script(self) -> tuple[tuple[str, str], ...]:
        """Its speeches with their cues, and its action with an empty cue, in the order of the script."""
        told: list[tuple[str, str]] = []
        for spoken, lines in groupby(self.lines, key=lambda line: line.kind == "dialogue"):
            if spoken:
                told += [(cue_of(line), line.text) for line in lines]
            elif action := " ".join(line.text for line in lines if line.text):
                told.append(("", action))
        return tuple(told)

    @property
    def status(self) -> str:
        """``OMITTED`` or ``APPROVED`` where a person left the shot out of the film, or approved it; else empty."""
        return "OMITTED" if self.omitted else "APPROVED" if self.shot.approved is not None else ""

    @property
    def open_notes(self) -> tuple[str, ...]:
        """The writer's notes, then those of people on the finished shot that are not resolved."""
        return (*self.notes, *(note.words for note in self.shot.notes if not note.resolved))

    @property
    def notes(self) -> tuple[str, ...]:
        """The writer's notes: the scene's at its first shot, then the shot's own."""
        return (*(self.scene.notes if self.opens else ()), *self.outline.notes)


def panels(graph: ContinuityMemoryGraph, *, with_omitted: bool = False) -> list[Panel]:
    """Return every shot of the film in order.

    Args:
        graph: The story.
        with_omitted: Whether to return also the shots that are not in the film, where they would be.
    """
    graph = as_filmed(graph)
    names = {asset.asset_id: asset.name for asset in graph.assets if asset.name}
    places = {scene.scene_id: capwords(scene.setup.place) for scene in graph.scenes}
    outlines = {scene.scene_id: scene for scene in graph.outline}
    result: list[Panel] = []
    start = 0
    for context in graph.scenes_in_order:
        scene, opens = outlines[context.scene_id], True
        lines = [line for outline in scene.shots for line in outline.lines]
        firsts = accumulate((len(outline.lines) for outline in scene.shots), initial=0)
        planned = {outline.shot_id: (first, outline) for first, outline in zip(firsts, scene.shots, strict=False)}
        for shot in graph.shots_in_order(scene.scene_id):
            omitted = context.omitted or shot.omitted
            if omitted and not with_omitted:
                continue
            first, outline = planned[shot.shot_id]
            name = shot_name(scene.scene_id, shot.shot_id)
            end = first + len(outline.lines)
            shown = tuple(_shown_line(lines, index, first, end) for index in range(first, end))
            words = _description(outline.lines, shot, names, places.get(scene.scene_id, ""))
            numbers = (start, graph.format.fps)
            result.append(Panel(name, scene, outline, shot, *numbers, shown, words, omitted, opens and not omitted))
            if not omitted:
                start, opens = start + shot.duration, False
    return result


def length_of(shots: Sequence[Panel]) -> str:
    """Return a summary of the length: ``5 scenes, 22 shots, 2:54 minutes``."""
    scenes = len({panel.scene.scene_id for panel in shots})
    minutes, seconds = divmod(round(sum(panel.seconds for panel in shots)), 60)
    counted = ", ".join(
        f"{n} {word}" if n == 1 else f"{n} {word}s" for n, word in ((scenes, "scene"), (len(shots), "shot"))
    )
    return f"{counted}, {minutes}:{seconds:02d} minutes"


def _shown_line(lines: Sequence[ScriptLine], index: int, first: int, end: int) -> ScriptLine:
    """Return a line of a shot as it is shown: action with an ellipsis where its sentence goes on in another shot or in
    a camera direction that is left out.

    Args:
        lines: All lines of the scene.
        index: Of the line.
        first: Index of the shot's first line.
        end: The index after its last.
    """
    line = lines[index]
    text = _shown_text(line)
    if line.kind == "action" and (text := text.strip()):
        if text[0].islower() and (index == first or not _goes_on(lines[index - 1])):
            text = f"… {text}"
        if index == end - 1 and end < len(lines) and _goes_on(line) and lines[end].text.strip()[:1].islower():
            text += " …"
    return line.model_copy(update={"text": text})


def _description(lines: Sequence[ScriptLine], shot: ShotContext, names: Mapping[str, str], place: str) -> str:
    """Return what happens in a shot; see ``Panel.description``.

    Args:
        lines: Of the shot.
        shot: Its context: whom a speech is addressed to, whom the camera shows.
        names: Display names by asset id.
        place: Display name of the place; may be empty.
    """
    parts: list[str] = []
    for index, line in enumerate(lines):
        words = " ".join(_shown_text(line).split())
        if line.kind == "action" and words:
            parts.append(words[0].upper() + words[1:] + ("" if words.endswith((*'.!?…"”',)) else "."))
        elif words and words[0] in '"“«„':
            parts.append(words)
        elif words:
            said = (names.get(each.target_id or "") for each in shot.character_actions if each.line_index == index)
            to = next((f" to {name}" for name in said if name), "")
            speaker = names.get(line.speaker or "") or line.speaker_name.title() or "A voice"
            parts.append(f"{speaker}{to}: “{textwrap.shorten(words, _QUOTATION, placeholder=' …')}”")
    if parts:
        return " ".join(parts)
    if shot.camera_instruction.kind == "establishing":
        return f"{place or 'The place'}, before the first line is spoken."
    shown = listed([names.get(each, each) for each in shot.camera_instruction.focus_on_ids]) or place or "the place"
    return f"{'We see' if shot.camera_instruction.kind == 'insert' else 'On'} {shown}."


def _shown_text(line: ScriptLine) -> str:
    """Return the words of a line without notes and the marks of emphasis."""
    return strip_emphasis(without_comments(line.text))


def _goes_on(line: ScriptLine) -> bool:
    """Return whether an action line ends in the middle of a sentence."""
    return line.kind == "action" and not line.text.rstrip(" \n\"'”’)]").endswith(STOPS)


def timecode(frame: int, fps: int) -> str:
    """Return a frame as ``HH:MM:SS:FF``; after 24 hours a clock begins again.

    Args:
        frame: Number of the frame; 0 is ``00:00:00:00``.
        fps: Frames a second.
    """
    seconds, frames = divmod(frame, fps)
    return f"{seconds // 3600 % 24:02d}:{seconds // 60 % 60:02d}:{seconds % 60:02d}:{frames:02d}"


def frame_of(time: str, fps: int) -> int:
    """Return the frame that a timecode ``HH:MM:SS:FF`` counts.

    Args:
        time: The timecode; 0 is ``00:00:00:00``.
        fps: Frames a second.
    """
    hours, minutes, seconds, frames = map(int, time.split(":"))
    return ((hours * 60 + minutes) * 60 + seconds) * fps + frames


def cue_of(line: ScriptLine) -> str:
    """Return the character cue of a speech as scripts write it: ``ANNA (whispering)``."""
    notes = [*(["O.S."] if line.off_screen else []), *([line.parenthetical] if line.parenthetical else [])]
    return " ".join([line.speaker_name.upper(), *(f"({note})" for note in notes)])
