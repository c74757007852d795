"""Which shots and scenes a person's words are about: ``SC010_SH020``, ``Scene 10``, ``SC010_SH010-SH030``, ``all``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from storyblender.errors import InputError

_SCENE: Final = r"sc(?:ene)?\.?[ _]*(?P<{0}>\d{{1,5}})"
_SHOT: Final = r"sh(?:ot)?\.?[ _]*(?P<{0}>\d{{1,5}})"
_IN_SCENE: Final = rf"{_SHOT.format('of_shot')} (?:of|in) {_SCENE.format('of_scene')}"
_FULL: Final = rf"{_SCENE.format('scene')}(?:(?:[ _/.,-]|, )*{_SHOT.format('shot')})?"
_WHOLE_SCENE: Final = r"(?:(?:all|every)(?: the)?(?: shots?)? (?:of|in) )?"
_ONE: Final = re.compile(rf"{_WHOLE_SCENE}(?:{_IN_SCENE}|{_FULL}|{_SHOT.format('same')})(?![\w])", re.IGNORECASE)
_ALL: Final = re.compile(
    r"(?:all|every)(?: (?:the )?(?:shots?|scenes?))?(?=[\s:,]|$)|(?:the )?(?:whole film|whole story)", re.IGNORECASE
)
_TO: Final = re.compile(r"\s*(?:-|–|—|\.\.+|\bto\b|\bthrough\b)\s*", re.IGNORECASE)
_ALSO: Final = re.compile(r"\s*(?:,|&|\band\b)\s*|\s+", re.IGNORECASE)
_WISH: Final = re.compile(r"\s*:\s*|\s*[,–—-]?\s+(?::\s*)?")
_MEND: Final = 'say it as in "SC010_SH020: closer, shallow focus"'


@dataclass(frozen=True)
class Address:
    """What words are about.

    Attributes:
        names: Of shots and scenes, in the order in which they are named.
        said: The rest of the words: what is wanted.
        everywhere: Whether ``all`` was said: what only some of them can do is then done there.
    """

    names: tuple[str, ...]
    said: str
    everywhere: bool = False


def address_of(words: str, shots: Sequence[str], scenes: Sequence[str]) -> Address:
    """Return the shots and scenes that words begin with; a colon after them may be left out.

    Numbers are those on the board: ``Scene 10`` is SC010, ``shot 20`` SH020.

    Args:
        words: ``SC010_SH010-SH030: closer``.
        shots: Names of all shots, in order.
        scenes: Names of all scenes, in order.

    Raises:
        InputError: They begin with no shot or scene, with one that there is not, or want nothing.
    """
    text = " ".join(words.split())
    match = None if _ONE.match(text) else _ALL.match(text)
    if match is not None:
        names, end = list(scenes), match.end()
    else:
        names, end = _listed(text, shots, scenes)
    wish = _WISH.match(text, end)
    said = text[wish.end() :].strip() if wish else ""
    if not names or not said.strip(":;,. "):
        raise InputError(f"{words!r} names no shot and what is wanted of it", mend=_MEND)
    return Address(tuple(dict.fromkeys(names)), said, match is not None)


def _listed(text: str, shots: Sequence[str], scenes: Sequence[str]) -> tuple[list[str], int]:
    """Return the names at the beginning of a text, ranges filled, and where they end."""
    names: list[str] = []
    at = end = 0
    while match := _ONE.match(text, at):
        name = _name(match, names[-1] if names else "")
        end = match.end()
        to = _TO.match(text, end)
        last = _ONE.match(text, to.end()) if to else None
        if last is None:
            names.append(_known(name, shots, scenes))
        else:
            names += _between(name, _name(last, name), shots, scenes)
            end = last.end()
        also = _ALSO.match(text, end)
        if also is None:
            break
        at = also.end()
    return names, end


def _name(match: re.Match[str], before: str) -> str:
    """Return the name that a match tells; ``SH020`` alone is of the scene of the name before."""
    told = match.groupdict()
    if told["same"]:
        return f"{before.partition('_')[0]}_SH{int(told['same']):03d}" if before else f"SH{int(told['same']):03d}"
    scene, shot = told["scene"] or told["of_scene"], told["shot"] or told["of_shot"]
    return f"SC{int(scene):03d}" + (f"_SH{int(shot):03d}" if shot else "")


def _known(name: str, shots: Sequence[str], scenes: Sequence[str]) -> str:
    if name in shots or name in scenes:
        return name
    inside = [each for each in shots if each.startswith(f"{name.partition('_')[0]}_")]
    there = inside if "_" in name and inside else scenes
    several = f"{there[0]} to {there[-1]}" if len(there) > 1 else "".join(there)
    raise InputError(f"there is no {'shot' if 'SH' in name else 'scene'} {name}", mend=f"there is {several}")


def _between(first: str, last: str, shots: Sequence[str], scenes: Sequence[str]) -> list[str]:
    """Return the names from one to another, both included."""
    row = shots if "_" in _known(first, shots, scenes) else scenes
    if _known(last, shots, scenes) not in row:
        raise InputError(f"{first} to {last} is no range", mend="give two shots, or two scenes")
    low, high = sorted((row.index(first), row.index(last)))
    return list(row[low : high + 1])
