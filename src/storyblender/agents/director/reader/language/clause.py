"""A clause: a verb with who does it, to whom, where."""

from __future__ import annotations

from dataclasses import dataclass, field

from storyblender.agents.director.reader.language.phrases import NounPhrase


@dataclass
class Clause:
    """A verb with everything that belongs to it."""

    index: int
    """Position of the verb among the words."""
    at: int
    """Offset of the verb in the script."""
    verb: str
    particle: str = ""
    subject: list[NounPhrase] = field(default_factory=list)
    object: list[NounPhrase] = field(default_factory=list)
    recipient: list[NounPhrase] = field(default_factory=list)
    complement: list[NounPhrase] = field(default_factory=list)
    """What somebody or something is said to be: ``The shop is a ruin``, ``Hale is asleep``."""
    places: list[tuple[str, list[NounPhrase]]] = field(default_factory=list)
    """Prepositions with their nouns."""
    asides: list[NounPhrase] = field(default_factory=list)
    """``waits outside, a coat over one arm``."""
    opening: int = 0
    """How many of the last places open the sentence: ``Beside the pond Arlo mends a net``."""
    participle: bool = False
    """An -ing form, or a bare infinitive."""
    infinitive: bool = False
    """``watches her go``."""
    absolute: bool = False
    """A participle with a subject of its own: ``engine running``."""
    passive: bool = False
    """A past participle: somebody else does it."""
    negated: bool = False
    earlier: bool = False
    """It was done before: ``the gate he had locked``."""
    unreal: bool = False
    """It does not happen: would, if, without, wants to."""
    elided: bool = False
    """No subject is written."""
    start: int = 0
    end: int = 0
    """Its characters in the script, from its first noun or its verb to its last."""
    main: bool = True
