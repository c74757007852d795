"""When each speech of a shot is spoken, for subtitles and timeline markers."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, replace

from storyblender.deliver.panel import Panel
from storyblender.memory.outline import ScriptLine

SPOKEN = ("talk", "whisper", "shout")
"""Clips during which a mouth moves."""
SUBTITLE = 84
"""Most characters of a subtitle: two lines of 42."""
_QUOTED = re.compile(r"[\"“„«]([^\"“”„«»]+)[\"”“»]")
_SENTENCE_END = re.compile(r"(?<=[.!?…][\"'”’)]) |(?<=[.!?…]) ")


@dataclass(frozen=True)
class Speech:
    """One speech of a shot.

    Attributes:
        line: Who says what.
        start: First frame, counted from the shot's start.
        end: The frame after the last.
    """

    line: ScriptLine
    start: int
    end: int


@dataclass(frozen=True)
class Subtitle:
    """One subtitle, with start and end in seconds from the beginning of the film."""

    start: float
    end: float
    text: str


def speeches(panel: Panel) -> list[Speech]:
    """Return the speeches of a shot, timed by the talking motions of their speakers and ended by the next speech.

    In a shot without motions yet they share the duration by their number of characters.
    """
    cues = sorted((cue for cue in panel.shot.cues if cue.clip in SPOKEN), key=lambda cue: cue.start)
    said: list[Speech] = []
    for line in panel.dialogue:
        cue = next((cue for cue in cues if cue.asset_id == line.speaker), None)
        if cue is None or cue.duration is None:
            return _by_length(panel)
        cues.remove(cue)
        said.append(Speech(line, cue.start, min(panel.shot.duration, cue.start + cue.duration)))
    ends = (*(speech.start for speech in said[1:]), panel.shot.duration)
    return [
        replace(speech, end=max(speech.start, min(speech.end, end))) for speech, end in zip(said, ends, strict=False)
    ]


def subtitles(shots: Sequence[Panel]) -> list[Subtitle]:
    """Return the dialogue as subtitles of readable length; the first of each speech names the speaker."""
    pieces: list[Subtitle] = []
    for panel in shots:
        for speech in speeches(panel):
            texts = _pieces(f"{speech.line.speaker_name}: {_said(panel, speech.line.text)}")
            total, done = sum(map(len, texts)), 0
            start, length = panel.start + speech.start, speech.end - speech.start
            for text in texts:
                times = [(start + length * share / total) / panel.fps for share in (done, done + len(text))]
                pieces.append(Subtitle(times[0], times[1], text))
                done += len(text)
    return pieces


def _said(panel: Panel, text: str) -> str:
    """Return the spoken words of a line: in prose (scenes without heading) only those in quotation marks."""
    quoted = [] if panel.scene.heading else [piece.strip() for piece in _QUOTED.findall(text)]
    return " ".join(quoted).rstrip(",") or text


def _pieces(text: str) -> list[str]:
    """Split text into subtitles, at sentence ends where possible; a longer sentence into parts of similar length."""
    pieces: list[str] = []
    for sentence in _SENTENCE_END.split(" ".join(text.split())):
        if pieces and len(pieces[-1]) + 1 + len(sentence) <= SUBTITLE:
            pieces[-1] += f" {sentence}"
        elif len(sentence) <= SUBTITLE:
            pieces.append(sentence)
        else:
            slack = max(map(len, sentence.split()))
            pieces += textwrap.wrap(sentence, min(SUBTITLE, len(sentence) // -(-len(sentence) // SUBTITLE) + slack))
    return [_in_lines(piece) for piece in pieces]


def _in_lines(piece: str) -> str:
    """Break a subtitle that is too long for one line near its middle."""
    spaces = [at for at, letter in enumerate(piece) if letter == " "]
    if len(piece) <= SUBTITLE // 2 or not spaces:
        return piece
    at = min(spaces, key=lambda at: abs(2 * at - len(piece)))
    return f"{piece[:at]}\n{piece[at + 1 :]}"


def _by_length(panel: Panel) -> list[Speech]:
    total = sum(len(line.text) for line in panel.dialogue) or 1
    said, start = [], 0.0
    for line in panel.dialogue:
        end = start + panel.shot.duration * len(line.text) / total
        said.append(Speech(line, round(start), round(end)))
        start = end
    return said
