"""A clause (a verb with its subjects, objects and places) and the builder that collects the clauses of a sentence."""

from __future__ import annotations

from dataclasses import dataclass, field

from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.words import Word


@dataclass
class Clause:
    """A verb with its subjects, objects, recipients and places."""

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
    """What a person or a thing is said to be: ``The shop is a ruin``, ``Hale is asleep``."""
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
    """A past participle: another person does it."""
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


@dataclass
class ClauseBuilder:
    """Clauses and loose nouns of the part of the sentence read so far."""

    phrases: list[Phrase]
    words: list[Word]
    clauses: list[Clause] = field(default_factory=list)
    subject: list[NounPhrase] = field(default_factory=list)
    """Subject of the clauses so far; a verb without one inherits it."""
    outer: list[NounPhrase] = field(default_factory=list)
    """Subject of the clause around ``where he told her``: its verbs go on after a comma."""
    pending: list[NounPhrase] = field(default_factory=list)
    """A noun read before its verb."""
    relative: list[NounPhrase] = field(default_factory=list)
    """``a man, who, peering in, knocked``: whose verbs come next."""
    inserted: bool = False
    """The noun before its verb stands after ``where`` or ``until``."""
    preposition: str = ""
    aside: bool = False
    """Within ``, a book in her lap``: its places are the book's, not the clause's."""
    leading: list[tuple[str, list[NounPhrase]]] = field(default_factory=list)
    """Places told before the first clause: ``On top of the stone sat a fox``."""
    fronted: list[tuple[str, list[NounPhrase]]] | None = None
    """Places told before a later clause: ``; behind him Silas pulled at the oars``."""
    closed: bool = False
    """A comma stands after the last verb: ``feet up`` is no ``slump up``."""
    negated: bool = False
    unreal: bool = False
    passive: bool = False
    earlier: bool = False
    """``had locked``: done before."""
    perfect: bool = False
    """``has fallen``: a person's own deed."""

    @property
    def current(self) -> Clause | None:
        """The last clause, or None."""
        return self.clauses[-1] if self.clauses else None

    def close_fronted(self) -> None:
        """Make a clause of a place and its subject without a verb: ``and behind it a lamp``."""
        if self.fronted and self.pending:
            at = self.pending[0].index
            clause = Clause(at, self.words[at].start, "be", subject=self.pending, places=self.fronted)
            clause.opening, self.fronted = len(self.fronted), None
            self.clauses.append(clause)
            self.pending = []
