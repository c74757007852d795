"""Expressions and moods from words: of a sentence, a parenthetical, or the description of a face."""

from __future__ import annotations

import re
from typing import Final, get_args

from storyblender.agents.director.lexicon import MOOD_OF_WORD
from storyblender.memory.vocabulary import Expression, Mood

_MOODS: Final[dict[Mood, str]] = {
    "happy": "happ|smil|grin|laugh|cheer|joy|delight|amus|beam|excited|proud|playful|bright",
    "sad": "sad|tear|cry|sob|weep|grie|mourn|broken|bitter|lonel|regret|heartbroken|quiet|weary|tired",
    "angry": "angr|furious|rage|scowl|glare|frown|snarl|yell|shout|harsh|cold|snap|spit|hiss|annoy|irritat|stern",
    "afraid": "afraid|fear|scare|terrif|panic|nervous|trembl|shak|anxious|worr|pale|alarm|frantic|horrif|startl"
    "|urgent|whisper",
    "tender": "tender|gentl|soft|warm|kind|lov|sooth|affection",
}
"""Stems of the words for each mood, the stronger moods first."""
_EXPRESSIONS: Final[dict[Expression, str]] = {
    "terrified": "terrif|horror|horrif|aghast|scream",
    "rage": "rage|furious|fury|livid|yell|snarl|roar|bellow",
    "cry": "cry|cries|crying|sob|weep|tears|in tears|bawl",
    "laugh": "laugh|giggl|chuckl|guffaw|crack(?:s|ed|ing)? up|hilar",
    "surprised": "surpris|startl|amaz|astonish|shock|stunn|gasp|wide-eyed|jaw drop|double take|baffl|confus",
    "disgusted": "disgust|revolt|nause|sneer|contempt|distast|repuls",
    "pained": "pain|winc|grimac|hurt|agony|ache|groan",
    "afraid": "afraid|fear|scare|panic|nervous|trembl|anxious|worr|alarm|uneasy|tense|dread",
    "angry": "angr|scowl|glar|frown|harsh|cold|hiss|annoy|irritat|stern|grim|cross|sulk",
    "suspicious": "suspic|squint|narrow|sceptic|skeptic|doubt|wary|sly|smirk",
    "thoughtful": "thought|pensiv|ponder|consider|concentrat|puzzl|curious|intent|focus|serious|dreamy|absent",
    "tired": "tired|weary|exhaust|sleepy|drows|yawn|bored|dull|drained",
    "tender": "tender|gentl|soft|warm|kind|lov|sooth|affection|fond",
    "sad": "sad|grie|mourn|broken|bitter|lonel|regret|wistful|melanchol|disappoint|crestfallen|glum|unhapp|sorry",
    "smile": "smil|grin|happ|cheer|joy|delight|amus|beam|excited|proud|playful|pleased|relie|content|triumph|hopeful",
}
"""Stems of the words for each expression, the stronger first."""
_MOOD_OF_EXPRESSION: Final[dict[Expression, Mood]] = {
    "smile": "happy", "laugh": "happy", "sad": "sad", "cry": "sad", "pained": "sad", "angry": "angry", "rage": "angry",
    "disgusted": "angry", "afraid": "afraid", "terrified": "afraid", "tender": "tender",
}  # fmt: skip


def mood_of(words: str, *, direction: bool = False) -> Mood:
    """Return the mood that words name, ``neutral`` if they name none.

    Args:
        words: A sentence, a parenthetical, an expression or the description of a face.
        direction: Whether the words describe how a person is, and nothing else. The stems of words then count too:
            ``cold`` in a parenthetical is a mood, in a sentence it may be the weather.
    """
    if direction and words in get_args(Expression):
        return _MOOD_OF_EXPRESSION.get(expression_of(words), "neutral")
    plain = words.lower()
    for word in re.split(r"[\s,.]+", plain):
        if word in MOOD_OF_WORD:
            return MOOD_OF_WORD[word]
    for mood, stems in _MOODS.items() if direction else ():
        if re.search(rf"\b(?:{stems})", plain):
            return mood
    return "neutral"


def expression_of(words: str) -> Expression:
    """Return the expression that a description of a face means: one of the sixteen by name, else by word stems."""
    plain = words.lower().strip()
    for expression in get_args(Expression):
        if plain == expression:
            return expression
    for expression, stems in _EXPRESSIONS.items():
        if re.search(rf"\b(?:{stems})", plain):
            return expression
    return "neutral"
