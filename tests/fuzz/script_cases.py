"""Scripts nobody would write, from a seed: pieces of every format put together at random, mutated examples, garbage.

``python -m tests.fuzz.script_cases 10000`` tries that many and prints those that fail; a second number is the first
case. The same number is the same script on every machine.
"""

from __future__ import annotations

import random
import signal
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from xml.sax.saxutils import escape, quoteattr

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.errors import InputError
from storyblender.memory.gatekeeper import faults_of
from storyblender.memory.graph import ContinuityMemoryGraph, Storyboard
from storyblender.screenplay.model import Screenplay
from storyblender.screenplay.source import load

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.[ft]*"))
LONGEST = 10.0
"""Seconds of processor time for one script."""

_NAMES = [
    "ANNA",
    "Tom",
    "tom",
    "DR. FELL",
    "MAN #2",
    "TWO GUARDS",
    "Łucja",
    "李雷",
    "O'BRIEN",
    "THE",
    "A",
    "",
    "#",
    "Mr.",
]
_NAMES += [
    "VOICE (V.O.)",
    "ANNA ^",
    "ANNA & TOM",
    "ЕЛЕНА",
    "ANNA'S MOTHER",
    "X" * 70,
    "Sheriff Cole",
    "a dog",
    "İ",
    "ß",
]
_VERBS = [
    "walks to",
    "gives",
    "sits on",
    "is",
    "has been",
    "looks at",
    "",
    "kills",
    "enters",
    "leaves",
    "was",
    "picks up",
]
_THINGS = [
    "the table",
    "a red cup",
    "her",
    "him",
    "it",
    "them",
    "the door",
    "INT.",
    "1408",
    "a horse and a cart",
    "杯子",
    "🎬",
]
_MARKS = [
    ".",
    "!",
    "?",
    "...",
    ",",
    ":",
    ";",
    " -- ",
    "—",
    "\n",
    "\n\n",
    "(",
    ")",
    '"',
    "“",
    "”",
    "'",
    "[[",
    "]]",
    "/*",
    "*/",
]
_MARKS += [
    "*",
    "**",
    "_",
    "\\",
    "#",
    ">",
    "<",
    "=",
    "~",
    "@",
    "^",
    "\t",
    "\u200b",
    "\u202e",
    "\u0301",
    "\ufeff",
    "\x85",
    "\x0b",
]
_HEADINGS = [
    "INT. {} - DAY",
    "EXT. {} - NIGHT",
    ".{}",
    "INT./EXT. {}",
    "12A INT. {} - LATER 12A",
    "INT. {} #7#",
    "INT.",
    "I/E {}",
]
_PLACES = [
    "KITCHEN",
    "a very long corridor of the old house",
    "",
    "PARIS, 1789",
    "ROOM 1408",
    "厨房",
    "- - -",
    "THE SHIP / DECK",
]
_CAMERA = [
    "CLOSE ON {}.",
    "ANGLE ON {}",
    "POV {}",
    "OVER {}'S SHOULDER:",
    "WIDE SHOT.",
    "PAN TO {}",
    "INSERT - {}",
    "SUPER: “{}”",
]
_OTHERS = ["CUT TO:", "> FADE OUT", "> THE END <", "===", "# Act", "= synopsis", "~ la la", "!NOT A CUE"]
_BYTES = [
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\x00",
    b"%PDF",
    b"PK\x03\x04",
    b"\x1a",
    b"\r\n",
    b"\xc3\x28",
    b"<?xml",
    b"\xfe\xff",
]
_FDX_TYPES = [
    "Scene Heading",
    "Action",
    "Character",
    "Dialogue",
    "Parenthetical",
    "Transition",
    "Shot",
    "Lyrics",
    "General",
]
_FDX_TYPES += ["Cast List", "New Act", "Outline 1", "", "Unknown"]


def make(case: int) -> tuple[str, bytes]:
    """Return the suffix and the bytes of a script."""
    chance = random.Random(f"script {case}")
    suffix, text = chance.choice(_KINDS)(chance)
    if isinstance(text, bytes):
        return suffix, text
    if chance.random() < 0.3:
        text = _mutated(chance, text)
    if chance.random() < 0.15:
        text = text.replace("\n", chance.choice(["\r\n", "\r", "\x85", "\n\n", "\u2028"]))
    data = text.encode(chance.choice(["utf-8"] * 8 + ["utf-8-sig", "utf-16", "cp1252", "utf-16-le"]), "replace")
    if chance.random() < 0.05:
        at = chance.randrange(len(data) + 1)
        data = data[:at] + chance.choice(_BYTES) + data[at:]
    return suffix, data


def _words(chance: random.Random) -> str:
    pieces = [_NAMES, _VERBS, _THINGS, _MARKS]
    return " ".join(chance.choice(chance.choice(pieces)) for _ in range(chance.randrange(1, 14)))


def _sentence(chance: random.Random) -> str:
    return (
        f"{chance.choice(_NAMES)} {chance.choice(_VERBS)} {chance.choice(_THINGS)}{chance.choice(['.', '!', ',', ''])}"
    )


def _fountain(chance: random.Random) -> tuple[str, str]:
    parts: list[Callable[[], str]] = [
        lambda: chance.choice(_HEADINGS).format(chance.choice(_PLACES)),
        lambda: f"{chance.choice(_NAMES)}\n{_words(chance)}",
        lambda: f"{chance.choice(_NAMES)}\n({_words(chance)})\n{_words(chance)}",
        lambda: " ".join(_sentence(chance) for _ in range(chance.randrange(1, 6))),
        lambda: chance.choice(_CAMERA).format(chance.choice(_NAMES)),
        lambda: f"[[{_words(chance)}]]",
        lambda: f"/* {_words(chance)} */",
        lambda: chance.choice(_OTHERS),
        lambda: f"{chance.choice(['Title', 'Contact', 'Draft date', 'Key'])}: {_words(chance)}",
        lambda: _words(chance),
    ]  # fmt: skip
    gaps = ["\n\n"] * 6 + ["\n", " ", "\n  \n"]
    return ".fountain", "".join(chance.choice(parts)() + chance.choice(gaps) for _ in range(chance.randrange(1, 40)))


def _prose(chance: random.Random) -> tuple[str, str]:
    said = ["“{}” said {}.", '"{}," {} whispered.', "‘{}’", "{}: {}", "'{}' cried the {}"]
    told = [
        chance.choice(said).format(_words(chance), chance.choice(_NAMES))
        if chance.random() < 0.4
        else _sentence(chance)
        for _ in range(chance.randrange(1, 60))
    ]
    return ".txt", "".join(piece + chance.choice([" ", " ", "\n", "\n\n"]) for piece in told)


def _fdx(chance: random.Random) -> tuple[str, str]:
    def paragraph(depth: int) -> str:
        inside = f"<Text>{escape(_words(chance).translate(_NO_XML))}</Text>" * chance.randrange(3)
        if depth and chance.random() < 0.2:
            inside += chance.choice(["<DualDialogue>{}</DualDialogue>", "<ScriptNote>{}</ScriptNote>", "{}"]).format(
                paragraph(depth - 1)
            )
        number = f" Number={quoteattr(chance.choice(['1', '12A', '', 'é']))}" if chance.random() < 0.3 else ""
        return f"<Paragraph Type={quoteattr(chance.choice(_FDX_TYPES))}{number}>{inside}</Paragraph>"

    body = "".join(paragraph(3) for _ in range(chance.randrange(40)))
    title = f"<TitlePage><Content>{paragraph(1)}</Content></TitlePage>" if chance.random() < 0.4 else ""
    root = chance.choice(["FinalDraft"] * 8 + ["Other"])
    head = chance.choice(['<?xml version="1.0"?>', '<?xml version="1.0" encoding="latin-1"?>\n', "", "<!DOCTYPE x>"])
    return ".fdx", f"{head}<{root}><Content>{body}</Content>{title}</{root}>"


_NO_XML = {code: " " for code in (*range(9), 11, 12, *range(14, 32), 0x85, 0xFEFF)}


def _mutated_example(chance: random.Random) -> tuple[str, str]:
    path = chance.choice(EXAMPLES)
    lines = path.read_text(encoding="utf-8").split("\n")
    start = chance.randrange(len(lines))
    lines = lines[start : start + chance.randrange(1, 60)]
    for _ in range(chance.randrange(1, 12)):
        at = chance.randrange(len(lines))
        change = chance.randrange(5)
        if change == 0:
            lines.insert(at, chance.choice(lines))
        elif change == 1:
            lines[at] = lines[at].swapcase()
        elif change == 2:
            lines[at] = _mutated(chance, lines[at])
        elif change == 3:
            lines[at] = _words(chance)
        else:
            other = chance.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
    return chance.choice([path.suffix, ".txt", ".md", ".fountain"]), "\n".join(lines)


def _mutated(chance: random.Random, text: str) -> str:
    letters = list(text)
    for _ in range(chance.randrange(1, 10)):
        at = chance.randrange(len(letters) + 1)
        change = chance.randrange(4)
        if change == 0:
            letters[at:at] = chance.choice(_MARKS)
        elif change == 1:
            del letters[at : at + chance.randrange(1, 20)]
        elif change == 2:
            letters[at : at + 1] = chr(chance.randrange(1, 0xD7FF))
        else:
            letters[at:at] = letters[at : at + 30]
    return "".join(letters)


def _repeated(chance: random.Random) -> tuple[str, str]:
    piece = "".join(chance.choice([*_MARKS, *_NAMES, *_THINGS, " ", "\n"]) for _ in range(chance.randrange(1, 5)))
    before = chance.choice(["", "INT. ROOM - DAY\n\n", "TOM\n", "Title: "])
    return chance.choice([".fountain", ".txt"]), before + piece * chance.randrange(2, 600)


def _garbage(chance: random.Random) -> tuple[str, bytes | str]:
    size = chance.randrange(400)
    if chance.random() < 0.5:
        return chance.choice([".txt", ".fdx", ".fountain"]), chance.randbytes(size)
    return ".txt", "".join(
        chr(chance.choice([chance.randrange(32, 127), chance.randrange(1, 0xD7FF)])) for _ in range(size)
    )


_KINDS: list[Callable[[random.Random], tuple[str, bytes | str]]] = [
    _fountain, _fountain, _fountain, _prose, _prose, _fdx, _fdx, _mutated_example, _mutated_example,
    _repeated, _garbage,
]  # fmt: skip


def fault_of(case: int, folder: Path) -> str:
    """Plan one script; return what is wrong with how that went, or an empty string.

    Args:
        case: Number of the script.
        folder: Where its file may lie.
    """
    suffix, data = make(case)
    path = folder / f"case{suffix}"
    path.write_bytes(data)
    signal.signal(signal.SIGVTALRM, _too_long)
    signal.setitimer(signal.ITIMER_VIRTUAL, LONGEST)
    try:
        screenplay = load(path)
        return _fault_in(screenplay, storyboard(read_script(screenplay)))
    except InputError as error:
        return "a refusal of several lines" if "\n" in str(error) or not error.problem else ""
    except TimeoutError:
        return f"more than {LONGEST:.0f} seconds"
    except Exception:  # noqa: BLE001 - whatever it is, it is the finding
        return traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)


def _too_long(signum: int, frame: FrameType | None) -> None:
    raise TimeoutError


def _fault_in(screenplay: Screenplay, board: Storyboard) -> str:
    """What is wrong with a plan: a line that is not in the script, an id twice or of nothing."""
    graph = ContinuityMemoryGraph(
        outline=board.storyboard_outline,
        assets=board.asset_sheet,
        scenes=board.scene_details,
        shots=board.shot_details,
    )
    for line in (line for scene in graph.outline for shot in scene.shots for line in shot.lines):
        if line.text != screenplay.text[line.span.start : line.span.end]:
            return f"line {line.text!r} is not what the script says there"
    return "; ".join(faults_of(graph))


def main(count: int, first: int) -> int:
    """Try ``count`` scripts from number ``first`` on; return how many failed."""
    import tempfile

    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for case in range(first, first + count):
            fault = fault_of(case, Path(folder))
            if fault:
                failed += 1
                print(f"case {case}: {fault}", flush=True)
    print(f"{count} scripts from number {first} on, {failed} failed")
    return failed


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0) > 0)
