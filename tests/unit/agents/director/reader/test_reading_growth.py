"""Four times the script takes about four times as long, whatever it is made of.

Processor time of two sizes in one process is compared, with room to spare: what grows with the square takes sixteen
times as long.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.errors import InputError
from storyblender.screenplay.source import read

_GOLD = Path(__file__).parents[4] / "data" / "director"
_ROOM = "INT. ROOM - DAY\n\n"
_TIMES = 4
_MOST = 8.0
"""Between four, which is linear, and sixteen, which is quadratic."""
_NOISE = 0.1
"""Seconds."""


def _name(number: int) -> str:
    starts = ["Al", "Be", "Ca", "Du", "El", "Fi", "Go", "Ha", "Il", "Jo", "Ka", "Lu", "Mo", "Ne", "Ol", "Pa"]
    ends = [
        "ra",
        "ton",
        "vin",
        "dric",
        "lia",
        "mer",
        "sha",
        "ko",
        "bert",
        "nna",
        "lo",
        "dia",
        "rick",
        "sel",
        "wen",
        "go",
    ]
    return (
        starts[number % 16] + ends[number // 16 % 16] + ["", "s", "x", "t", "da", "ri", "lo", "ne"][number // 256 % 8]
    )


def _words(count: int) -> str:
    known = ("the", "man", "walks", "to", "old", "table", "and", "takes", "a", "red", "cup", "while", "rain", "falls")
    chance = random.Random(count)
    return " ".join(chance.choice(known) for _ in range(count))


_SHAPES: dict[str, Callable[[int], str]] = {
    "emphasis": lambda size: _ROOM + "*a_b" * (size // 4),
    "number signs": lambda size: "#" * size,
    "zero-width spaces": lambda size: _ROOM + "\u200b" * size,
    "a letter a line": lambda size: "a\n" * (size // 2),
    "a capital a line": lambda size: "A\n" * (size // 2),
    "a letter a paragraph": lambda size: "a\n\n" * (size // 3),
    "Thai": lambda size: "สวัสดีครับผมชื่อสมชายเขาเดินไปที่บ้าน" * (size // 37),
    "a quoted paragraph": lambda size: f"“I saw {_words(size // 5)}” said Tom.",
    "no full stop": lambda size: _ROOM + _words(size // 5),
    "notes in a line": lambda size: _ROOM + "[[a]] b\n" * (size // 8),
    "a long word": lambda size: _ROOM + "A" * size,
    "one paragraph": lambda size: _ROOM + "Tom walks to the table. She looks at him. " * (size // 42),
    "quotations never closed": lambda size: "“I saw him. " * (size // 12),
    "dots": lambda size: _ROOM + "." * size,
}
_MORE: dict[str, Callable[[int], str]] = {
    "headings": lambda size: "".join(f"INT. ROOM {at} - DAY\n\n" for at in range(size // 20)),
    "one heading": lambda size: "INT. ROOM - DAY\n\n" * (size // 17),
    "two who talk": lambda size: _ROOM + "TOM\nHello to you.\n\nANNA\nHi.\n\n" * (size // 27),
    "all capitals": lambda size: _ROOM + "TOM WALKS TO THE TABLE. HE TAKES A CUP.\n\n" * (size // 41),
    "all small letters": lambda size: _ROOM + "tom walks to the table. he takes a cup. " * (size // 40),
    "brackets within brackets": lambda size: f"{_ROOM}TOM {'(' * (size // 2)}{')' * (size // 2)}\nHello.\n",
    "notes within notes": lambda size: _ROOM + "[" * size,
    "boneyards": lambda size: _ROOM + "/* a */ b " * (size // 10),
    "emoji": lambda size: _ROOM + "😀" * size,
    "right to left": lambda size: _ROOM + "הוא הולך אל השולחן ולוקח כוס. " * (size // 30),
    "combining marks": lambda size: _ROOM + "e" + "\u0301" * size,
    "tabs": lambda size: _ROOM + "\ta" * (size // 2),
    "CRLF": lambda size: (_ROOM + "Tom walks.\n\n" * (size // 12)).replace("\n", "\r\n"),
    "arrows": lambda size: _ROOM + ">" * (size // 2) + "<" * (size // 2),
    "a list of names": lambda size: f"{_ROOM}Here sit {', '.join(_name(at) for at in range(size // 8))} and Zed.",
    "quotations in a row": lambda size: '"a" ' * (size // 4),
    "quotation marks": lambda size: '"' * size,
    "directions": lambda size: _ROOM + "CLOSE ON TOM. ANGLE ON ANNA. " * (size // 29),
    "words of directions": lambda size: _ROOM + "CLOSE ON " * (size // 9),
    "FDX": lambda size: _fdx("<Paragraph><Text>Tom walks to it.</Text></Paragraph>" * (size // 50)),
    "deep FDX": lambda size: _fdx("<Paragraph>" * (size // 23) + "</Paragraph>" * (size // 23)),
    "numbers": lambda size: _ROOM + "1789 " * (size // 5),
    "spaces": lambda size: f"{_ROOM}a{' ' * size}b",
}


def _fdx(paragraphs: str) -> str:
    return f'<?xml version="1.0"?><FinalDraft><Content>{paragraphs}</Content></FinalDraft>'


def _seconds(text: str) -> float:
    start = time.process_time()
    with suppress(InputError):
        storyboard(read_script(read(text)))
    return time.process_time() - start


def assert_linear(shape: Callable[[int], str], size: int) -> None:
    """Plan a script of a size and one of four times the size; the best of three, so that nothing else counts."""
    _seconds(shape(64))  # what is prepared once
    measured: list[tuple[float, float]] = []
    for _ in range(3):
        measured.append((_seconds(shape(size)), _seconds(shape(_TIMES * size))))
        if measured[-1][1] < _MOST * measured[-1][0] + _NOISE:
            return
    pytest.fail(f"{_TIMES} times the script took this long (seconds): {measured}")


@pytest.mark.parametrize("shape", _SHAPES)
def test_reading_is_linear(shape: str) -> None:
    assert_linear(_SHAPES[shape], 1500)


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("shape", [*_SHAPES, *_MORE])
def test_reading_much_is_linear(shape: str) -> None:
    assert_linear((_SHAPES | _MORE)[shape], 12_000)


def _people(count: int) -> str:
    """A script of so many people, each with a scene to themselves and somebody they talk to."""
    scenes = []
    for at in range(count):
        one, other = _name(at), _name((at * 7 + 3) % count)
        scenes.append(
            f"INT. OFFICE {at // 5} - DAY\n\n{one.upper()} (3{at % 10}), a tall man, walks to the table. {other} waits."
            f"\n\n{one.upper()}\nHello, {other}! Come here.\n\n{other.upper()}\nNo, {one}.\n\nHe takes the cup.\n\n"
        )
    return "".join(scenes)


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_six_hundred_people_take_four_times_as_long_as_a_hundred_and_fifty() -> None:
    assert_linear(_people, 150)


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_six_hundred_people_in_a_story_are_linear() -> None:
    rooms = ("kitchen", "office", "street", "garden", "bar")

    def story(count: int) -> str:
        return "".join(
            f"{_name(at)} walked into the {rooms[at % 5]} and took the cup. {_name(at + 1)} looked at him. “Hello,"
            f" {_name(at + 1)}!” said {_name(at)}. “No, {_name(at)},” said {_name(at + 1)}.\n\n"
            for at in range(count)
        )

    assert_linear(story, 150)


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_a_hundred_and_twenty_pages_are_linear() -> None:
    scenes: list[str] = []
    for path in sorted(_GOLD.glob("*.gold")):
        text = "\n".join(line for line in path.read_text(encoding="utf-8").split("\n") if not line.startswith("|"))
        scenes += [f"INT. {part}" for part in text.split("\nINT. ")[1:]]

    def feature(pages: int) -> str:
        chance = random.Random(7)
        lines: list[str] = []
        while len(lines) < 55 * pages:
            lines += chance.choice(scenes).split("\n")
        return "\n".join(lines)

    assert_linear(feature, 30)
