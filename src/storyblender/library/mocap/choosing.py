"""Finds the clip of the user that does what a script says: by the words of its name, else by what they mean.

A clip is taken where its name says what is done at least as well as the motion of the catalogue does. One that says how
it is done, angrily or drunk, is for those who do it so.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from storyblender.catalog.motions import MOTIONS, STANDING
from storyblender.library.mocap.clip_words import stem, words_of_clip
from storyblender.library.mocap.folders import MOST_FILES, MotionFile
from storyblender.memory.base import seed_of
from storyblender.memory.shot_context import CharacterAction
from storyblender.ports import Embedder

VOICED: Final = frozenset(("talk", "whisper", "shout"))
ENOUGH: Final = 0.6
"""Share of the words of a clip that an action has to say, where it does not say the clip's verb."""
LIKE: Final = 0.62
"""Least likeness of meaning of a clip that no word of the script names."""
LIKER: Final = 0.10
"""By how much it has to be more like the script's words than the motion of the catalogue is."""
_MANNERS: Final = {
    "angry": ("angr", "anger", "furiou", "rage", "mad"), "happy": ("hap", "joy", "glad", "cheer", "excit"),
    "sad": ("sad", "griev", "mourn", "depres"), "afraid": ("afraid", "scar", "fear", "terrif", "nervou", "anxiou"),
    "tender": ("tender", "gentl"), "drunk": ("drunk", "drunken"), "tired": ("tir", "exhaust", "wear"),
    "hurt": ("hurt", "injur", "wound", "limp"), "old": ("old", "elder"), "sneaky": ("sneak", "sneaky"),
}  # fmt: skip
"""Stems of words that say how something is done; the first ones as the moods of actions."""
_MANNER_STEMS: Final = frozenset(form for forms in _MANNERS.values() for form in forms)
_SPEECH: Final = frozenset(
    ("talk", "speak", "spech", "argu", "convers", "convers", "discus", "rant", "explain", "tell", "shout", "yell",
     "whisp", "whisper", "gestur", "debat", "complain", "present")
)  # fmt: skip
_PLAIN: Final = frozenset(
    ("to", "the", "a", "an", "in", "at", "with", "and", "his", "her", "their", "of", "on", "up", "down", "look", "hand",
     "turn", "walk", "stand", "sit", "go", "com", "get", "tak", "both", "one", "left", "right", "him", "them", "it")
)  # fmt: skip
"""Stems that alone do not make a clip the one that is meant."""


@dataclass(frozen=True)
class Choice:
    """A clip that fits an action.

    Attributes:
        file: The clip.
        score: Larger is better.
        reason: Why it fits, for people.
    """

    file: MotionFile
    score: float
    reason: str


def choices_for(
    action: CharacterAction,
    files: Sequence[MotionFile],
    embedder: Callable[[], Embedder],
    name: str,
    *,
    seated: bool = False,
) -> list[Choice]:
    """Return the clips that fit an action, best first; equal ones in an order that ``name`` decides.

    Args:
        action: Of a script.
        files: The clips.
        embedder: Loads the sentence model, where no word names a clip.
        name: Of the action, so that people do not all do the same.
        seated: Whether the person sits.
    """
    fitting = [file for file in files if may_play(action, file) and (seated or not file.seated)]
    said = _said(action)
    manners = _manners([*said], action.mood)
    named = [choice for file in fitting if (choice := _by_words(action, said, manners, file)) is not None]
    found = named or _by_meaning(action, fitting, embedder)
    return sorted(
        found, key=lambda each: (seated and not each.file.seated, -each.score, seed_of(f"{name} {each.file.name}"))
    )


def may_play(action: CharacterAction, file: MotionFile) -> bool:
    """Return whether a clip can take the place of what the catalogue has for an action.

    Ways, changes of posture, and what is done with things or with other people's bodies stay the catalogue's.

    Args:
        action: Of a script.
        file: The clip.
    """
    motion = MOTIONS[action.motion]
    if motion.speed is not None and action.motion != "dance":
        return False
    if motion.after not in (None, "stand") or motion.reach not in ("self",) or action.motion in ("rise", "get_up"):
        return False
    if action.prop_id is not None and motion.hands:
        return False
    target = action.target_id is not None
    return file.needs is None or target


def _said(action: CharacterAction) -> dict[str, str]:
    """Return the words of an action by their stems, in order."""
    words = words_of_clip(action.action_description)
    mood = [action.mood] if action.mood != "neutral" else []
    return {stem(word): word for word in (*words, *mood)}


def _manners(stems: Sequence[str], mood: str = "") -> set[str]:
    return {manner for manner, forms in _MANNERS.items() if manner == mood or any(form in stems for form in forms)}


@dataclass(frozen=True)
class _Told:
    """Stems that a clip says: of its own name, with those of its folders and description, and its manners."""

    own: tuple[str, ...]
    all: frozenset[str]
    manners: frozenset[str]


@lru_cache(maxsize=MOST_FILES)
def _told_by(file: MotionFile) -> _Told:
    own = tuple(stem(word) for word in file.words)
    every = frozenset((*own, *map(stem, file.folder_words), *map(stem, words_of_clip(file.description))))
    return _Told(own, every, frozenset(_manners([*every])))


def _by_words(action: CharacterAction, said: dict[str, str], manners: set[str], file: MotionFile) -> Choice | None:
    """Return a clip whose name, folder or description says what is done."""
    clip = _told_by(file)
    own, told = clip.own, clip.all
    shared = [each for each in said if each in told]
    if not clip.manners <= manners:
        return None
    spoken = action.motion in VOICED
    if spoken:
        if not clip.manners or not _SPEECH & told:
            return None  # without a manner in its name, every speaker would get the same clip
        return Choice(file, 2.0 + len(shared), f"{file.name} is a clip of speech, and is {action.mood}")
    telling = [each for each in shared if each not in _PLAIN and each not in _MANNER_STEMS]
    if not telling:
        return None
    verb = next(iter(said))
    explained = sum(each in said for each in own) / max(1, len(own))
    motion = MOTIONS[action.motion]
    known = {stem(word) for text in (motion.key, motion.name, *motion.tags) for word in words_of_clip(text)}
    catalogue = len([each for each in said if each in known]) if action.motion not in STANDING else 0
    if (verb not in shared and explained < ENOUGH) or len(shared) < min(catalogue, 1):
        return None
    words = ", ".join(said[each] for each in shared)
    return Choice(file, len(shared) + explained, f"its name says {words}")


def _by_meaning(action: CharacterAction, files: Sequence[MotionFile], embedder: Callable[[], Embedder]) -> list[Choice]:
    """Return the clips that mean nearly what an action says, and more so than the motion of the catalogue."""
    words = words_of_clip(action.action_description)
    if not files or len(words) < 1 or action.motion in VOICED:
        return []
    motion, stems = MOTIONS[action.motion], [stem(word) for word in words]
    own = _manners(stems, action.mood)
    files = [file for file in files if _told_by(file).manners <= own]
    if not files:
        return []
    texts = [file.description or " ".join((*file.words, *file.folder_words)) for file in files]
    model = embedder()
    query = model.embed([action.action_description])[0]
    likeness = model.embed(texts) @ query
    catalogue = max(model.embed([motion.name, *motion.tags[:3]]) @ query) if action.motion not in STANDING else 0.0
    least = max(LIKE, float(catalogue) + LIKER)
    return [
        Choice(file, float(like), f"means nearly {text!r} ({float(like):.2f})"[:200])
        for file, text, like in zip(files, texts, likeness, strict=True)
        if float(like) >= least
    ]
