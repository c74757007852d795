"""Finds the people of a screenplay: cues, names in capitals, titles with a name (notes of the director, 1a)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER, unaccented
from storyblender.agents.director.reader.cast.aliases import (
    bracketed_alias,
    find_nicknames,
    join_revealed,
    name_on_tag,
    person_in_clothes,
)
from storyblender.agents.director.reader.cast.later_names import add_noun_aliases
from storyblender.agents.director.reader.cast.walk_ons import add_walk_ons
from storyblender.agents.director.reader.language.morphology import form_kind, is_person_noun
from storyblender.agents.director.reader.language.person_nouns import find_person_nouns
from storyblender.agents.director.reader.language.words import TextIndex
from storyblender.agents.director.reader.manuscript import Manuscript, Paragraph, without_quotations
from storyblender.agents.director.reader.people.look import read_description
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import as_rule, rule, rule_applies
from storyblender.catalog.inflection import singular

_CAPITAL = UPPER + "ʿʾʻ"
_RUN = re.compile(
    r"(?<![^\W\d_])(?:THE |A |AN |TWO |THREE |FOUR |FIVE |SIX )?"
    rf"(?:(?:MRS|MR|DR|MS|PROF|SGT|LT|CAPT|ST)\.|[{_CAPITAL}][{_CAPITAL}'’.-]*[{_CAPITAL}]|[A-Z]{{2,}}\.|[A-Z])"
    rf"(?:[ ](?:(?:IN|OF|WITH|THE|A)\s)*(?:[{_CAPITAL}][{_CAPITAL}'’.-]*[{_CAPITAL}]\.?|#?\d+))*(?![{LOWER}])"
)
"""A run of words in capitals."""
_TITLED = re.compile(
    r"\b(?:Mr|Mrs|Ms|Dr|Miss|Officer|Detective|Sergeant|Captain|Professor|Uncle|Aunt|Sheriff|Lieutenant|Deputy)\.? "
    rf"[{UPPER}][{LOWER}]+"
)
_CAPITALISED_ROLE = re.compile(r"\b[Tt]he ((?:[A-Z][a-z]+ ){1,2}[A-Z][a-z]*)\b")
_ARTICLE_OR_COUNT = re.compile(r"^(THE|A|AN|TWO|THREE|FOUR|FIVE|SIX) ")
_COUNT = re.compile(r"^(TWO|THREE|FOUR|FIVE|SIX) ")
_NUMBERS = "|".join(word for word, number in lexicon.NUMBERS.items() if number > 1)
_COUNTED_BEFORE = re.compile(rf"\b({_NUMBERS}) (?:[a-z-]+ ){{0,2}}$", re.IGNORECASE)
_YEARS = r"(?:eigh|nine|seven|six|fif|four|thir|twen|for)(?:teen|ty|ties)\b|"
_YEARS += r"(?:four|five|six|seven|eight|nine|ten|eleven|twelve)\b"
_INTRODUCED = re.compile(
    r"\s*\((?:early |mid |late |age |aged )?\d|\s*\([^)]*(?:\d0s|years)|\s*,\s*(?:\d|a |an |the |in h|early |mid|late "
    rf"|barely |not yet |{_YEARS})|\s*\([^)]*(?:{_YEARS})"
)
_AGED = re.compile(r"\s*\((?:early |mid |late |age |aged )?\d\d?(?:['’]?s)?\s*[),]")
_WORN = "|".join(sorted(word for word in lexicon.WORN if word.endswith("s")))
_QUALITIES = "|".join(sorted(word for word in lexicon.BUILD | lexicon.FACE | set(lexicon.AGE_WORDS) if word.isalpha()))
_LOOK = re.compile(
    rf"\s*\(([^)]*)\)|\s*,\s*((?:a|an|in|the|her|his|early|mid|late|barely|\d|{_YEARS}|(?:{_QUALITIES})\b)[^.;]*?)"
    rf"(?=,?\s+(?:is|was|(?!(?:{_WORN})\b)[a-z]+s)\b(?! of)|[.;])",
    re.DOTALL,
)
_NEXT_LINE = re.compile(rf"\n(?=\s*(?:A |AN |THE )?[{UPPER}]{{2}})")
"""The cue line of another speaker."""
_SOME, _MOST = 3, 6
"""Members of a group whose number is not told, and of one that is a crowd."""
_FOLLOWING = 40
"""How many characters after a name are read to decide whether it names a person."""
_NOT_FAR = 900
"""Characters back to the first sight of a person who is then called ``the STRANGER``."""
_PERSON_NOUNS = frozenset({"man", "woman", "boy", "girl", "figure", "stranger", "child", "kid"})
_NUMBERED = re.compile(r"\s*#?\d+$")
_CHORUS = lexicon.words("chorus")
"""Cues that mean the people present."""
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.SCENERY | lexicon.ABSTRACT | lexicon.BODY


@dataclass(frozen=True, order=True)
class _Sighting:
    """One place where a name occurs."""

    at: int
    name: str
    after: str
    """The first characters that follow it in its paragraph."""
    nickname: str = ""
    rule: str = "people.cue"


_PART_OF = re.compile(r"\b(?:OF|DE|DEL|DU|DES|DI|DELLA|VON|DER)\b")
"""``LA MANO DE ROSA``: a part of a person, and no name."""


def find_screenplay_cast(script: Manuscript) -> Roster:
    """Return the people of a screenplay in the order they appear."""
    cues = {paragraph.name for paragraph in script.paragraphs if paragraph.kind == "cue"}
    cues -= {cue for cue in cues if cue.lower() in _CHORUS}
    sightings: list[_Sighting] = []
    written = TextIndex(script.text)
    for paragraph in script.paragraphs:
        if paragraph.kind == "cue" and paragraph.name.lower() not in _CHORUS:
            sightings.append(_Sighting(paragraph.start, paragraph.name, ""))
        elif paragraph.kind in ("action", "cast"):
            named = _sightings_in_action(written, paragraph.body, paragraph.start, cues)
            sightings += [replace(each, after="") for each in named[:1]] if paragraph.kind == "cast" else named
            sightings += _sightings_in_camera_notes(paragraph, cues)
    singles = [
        part for sighting in sightings for part in _split(sighting) if part.name in cues or "'S " not in part.name
    ]
    roster = Roster()
    full_names = _FullNames(_ARTICLE_OR_COUNT.sub("", sighting.name) for sighting in singles)
    for sighting in sorted(singles):
        with as_rule(sighting.rule, sighting.at, sighting.at + len(sighting.name)):
            _admit(roster, sighting, full_names, script.text)
    for paragraph in script.paragraphs:
        if paragraph.kind == "cast":
            _describe_entry(roster, paragraph.text)
    speaking = {bare(cue) for cue in cues}
    for person in roster.people:
        person.speaks = any(alias in speaking for alias in person.aliases)
    join_revealed(roster, script.text)
    add_walk_ons(roster, script)
    add_noun_aliases(roster, script.text)
    if not roster.people:
        _add_unnamed(roster, script)
    roster.link_variants()
    return roster


@rule("people.cast_list")
def _describe_entry(roster: Roster, line: str) -> None:
    """Read an entry of the cast list: ``MAMA RISI, a tailor, fifty-eight``."""
    entry = re.match(rf"(?:A |AN |THE )?([{UPPER}][{UPPER}.'’ -]+[{UPPER}])[\s,:.(–—-]+(.+)", line.strip())
    people = roster.find(entry.group(1)) if entry else []
    if entry and people:
        read_description(roster, people[0], entry.group(2).replace(")", "").strip(" ."))


@rule("people.unnamed_pair")
def _add_unnamed(roster: Roster, script: Manuscript) -> None:
    """Add a woman and a man where nobody has a name: ``She leaves. He stays.``"""
    for paragraph in script.paragraphs:
        for word in re.finditer(r"\b(?:he|she)\b", paragraph.raw, re.IGNORECASE) if paragraph.kind == "action" else ():
            roster.add("Woman" if word.group().lower() == "she" else "Man", paragraph.start + word.start())


def _sightings_in_action(written: TextIndex, text: str, start: int, cues: set[str]) -> list[_Sighting]:
    """Return the names in capitals in a paragraph of action."""
    found: list[_Sighting] = []
    pieces, done = [], 0
    for at, end, name, nickname in find_nicknames(text):
        found.append(_Sighting(start + at, name, text[end : end + _FOLLOWING], nickname, "people.nickname"))
        pieces += [text[done:at], " " * (end - at)]
        done = end
    text = without_quotations("".join([*pieces, text[done:]]))
    for match in _RUN.finditer(text):
        name = re.sub(r"['’]S$", "", match.group(0).strip(" .-'’")).replace("’", "'")
        before, after = text[max(0, match.start() - 30) : match.start()], text[match.end() : match.end() + _FOLLOWING]
        by = _rule_of_person(name, before, after, cues, written) if len(name) > 1 else ""
        if by:
            found.append(_Sighting(start + match.start(), name, after, rule=by))
    for match in _TITLED.finditer(text):
        found.append(_Sighting(start + match.start(), match.group(0).upper(), "", rule="people.title_and_name"))
    for match in _CAPITALISED_ROLE.finditer(text):
        words = match.group(1).split()
        kind = re.match(r" ([a-z]+)", text[match.end() :])  # the German Shepherd dog
        if len(words) > 1 and is_person_noun(singular(words[-1])) and not (kind and kind[1] in lexicon.ANIMALS):
            found.append(_Sighting(start + match.start(1), match.group(1).upper(), "", rule="people.role_with_capital"))
    return found


def _sightings_in_camera_notes(paragraph: Paragraph, cues: set[str]) -> list[_Sighting]:
    """Return the names in camera directions: ``CLOSE ON KIRA``, ``BEN'S POV``."""
    found: list[_Sighting] = []
    for _, camera in paragraph.cameras:
        for name in (camera.subject, camera.who):
            at = paragraph.raw.find(name)
            part = _PART_OF.search(name) is not None and bool(cues & {*name.split()})
            name_alone = not part and name.upper() == name and at >= 0 and len(name) > 1
            after = paragraph.raw[at + len(name) : at + len(name) + _FOLLOWING]
            by = _rule_of_person(name, "the ", after, cues, TextIndex("")) if name_alone else ""
            if by:
                found.append(_Sighting(paragraph.start + at, name, after, rule=by))
    return found


def _rule_of_person(name: str, before: str, after: str, cues: set[str], written: TextIndex) -> str:
    """Return the rule by which words in capitals name a person; empty for a noise, a thing or a camera."""
    base = _ARTICLE_OR_COUNT.sub("", name)
    if rule_applies("people.cue", base in cues or name in cues):
        return "people.cue"
    if re.search(r" (?:DE|DEL|DI|VON|OF) ", base) and base.split()[-1] in cues:
        return ""  # LA MANO DE ROSA
    part = " " in base and {base.split()[0], base.split()[-1]} & cues and base.split()[-1].lower() not in _THINGS
    if rule_applies("people.part_of_cue", part):
        return "people.part_of_cue"
    unnumbered = _NUMBERED.sub("", re.split(r" (?:IN|OF|WITH) ", base)[0]) or "x"
    head = singular(unnumbered.split()[-1])
    title = base.split()[0].strip(".").lower()
    told = _noun_before(before) and re.match(r"[,.;]| \(", after)
    first = {unaccented(head), unaccented(unnumbered.split()[-1].lower())} & lexicon.FIRST_NAMES
    for found, evidence in (
        ("people.trade_or_kin", is_person_noun(head)),
        ("people.title_and_name", title in lexicon.TITLES and " " in base),
        ("people.age_in_brackets", _AGED.match(after)),
        ("people.apposition", _is_called_a_person(after) or told),
        ("", head in lexicon.PROPS | lexicon.SET_PIECES or base.lower() in lexicon.NOT_PEOPLE),
        ("", head in lexicon.SOUNDS),
        ("people.first_name", first),
        ("people.introduced", _INTRODUCED.match(after)),
        ("", head in _THINGS),
    ):
        if rule_applies(found, evidence) if found else evidence:
            return found
    acts = "people.name_in_capitals_acts"
    return acts if rule_applies(acts, _acts_like_a_person(base, before, after, written)) else ""


def _is_called_a_person(after: str) -> bool:
    """Whether an apposition says that it is a person: ``STONE, a big man, carries``."""
    told = re.match(r"\s*,\s*(an?\s.*)", after)
    return told is not None and any(phrase.start == 0 for phrase in find_person_nouns(told.group(1)))


def _acts_like_a_person(base: str, before: str, after: str, written: TextIndex) -> bool:
    """Whether a third-person verb follows, and no article or common use contradicts a name."""
    verb = re.match(r"\s+([a-z]+)", after)
    if verb is None or form_kind(verb.group(1)) not in ("3sg", "aux", "ing") or form_kind(base.lower()):
        return False
    bare_name = not re.search(r"\b(?:the|a|an|his|her|their|its)\s(?:[a-z-]+\s){0,2}$", before, re.IGNORECASE)
    name = base.title()
    return bare_name or any(not written.text.startswith(("'", "’"), at + len(name)) for at in written.places(name))


def _split(sighting: _Sighting) -> list[_Sighting]:
    """Split VERA AND DUTCH, and drop ON, WITH before and 'S VOICE behind a name."""
    name = re.sub(r"^(ON|AND|WITH|OF|IN) ", "", sighting.name)
    name = re.sub(r"['’]S (VOICE|POV|HAND|HANDS|FACE|EYES)$", "", name)
    parts = [part.strip() for part in re.split(r" AND | & | ?/ ?", name) if part.strip()]
    return [
        _Sighting(
            sighting.at + max(name.find(part), 0),
            part,
            sighting.after if part == parts[-1] else "",
            sighting.nickname,
            sighting.rule,
        )
        for part in parts
    ]


class _FullNames:
    """All names of the script as written, by their words."""

    def __init__(self, names: Iterable[str]) -> None:
        self.all = {*names}
        self._with_word: dict[str, list[str]] = {}
        for name in self.all:
            for word in {*name.split()}:
                self._with_word.setdefault(word, []).append(name)

    def have_part(self, name: str) -> bool:
        """Whether a single word is a part of a longer name."""
        return " " not in name and any(_is_part_of(name, full) for full in self._with_word.get(name, ()))

    def number(self, words: Sequence[str]) -> bool:
        """Whether one of these nouns occurs with a number: THUG #1."""
        told = "|".join(re.escape(word) for word in words)
        with_noun = (full for word in words for full in self._with_word.get(word.rsplit(" ", 1)[-1], ()))
        return any(re.fullmatch(rf"(?:{told}) #?(?:\d|ONE|TWO)", full) for full in with_noun)


def _admit(roster: Roster, sighting: _Sighting, full_names: _FullNames, text: str) -> None:
    """Add a sighting to the cast unless a longer form of the name is introduced elsewhere."""
    base = re.sub(r"^(A|AN) ", "", _COUNT.sub("", sighting.name))
    if _are_numbered(base, full_names):
        return
    name = re.sub(r"^THE ", "", base)
    known = roster.find(name)
    if not known and full_names.have_part(name):
        return
    other = None if known else _apposed(roster, sighting, name, text) or person_in_clothes(roster, name)
    if other:
        roster.add_alias(other, bare(name))
    before = text[max(0, sighting.at - 40) : sighting.at]
    person = known[0] if known else other or _add_person(roster, sighting, base, before)
    if sighting.nickname:
        roster.add_alias(person, bare(sighting.nickname))
    after = sighting.at + len(sighting.name)
    looks = _descriptions_after(_NEXT_LINE.split(text[after : after + 160].lstrip("_*"))[0]) if sighting.after else []
    if not known:
        _merge_earlier_view(roster, person, text, sighting.at)
    _note_kin_before(roster, person, before)
    for said in looks:
        read_description(roster, person, said)
        if also := bracketed_alias(said):
            roster.add_alias(person, bare(also))
        if person.role and (tag := name_on_tag(said, full_names.all)):
            roster.add_alias(person, bare(tag))


def _descriptions_after(after: str) -> list[str]:
    """Return the descriptions after a name, in brackets and between commas: ``(25), in a red coat, sits``."""
    found, at = [], 0
    while said := _LOOK.match(after, at):
        found.append(said.group(1) or said.group(2) or "")
        at = said.end()
    return found


def _merge_earlier_view(roster: Roster, person: Person, text: str, at: int) -> None:
    """Merge ``A man staggers out of the trees`` with ``the STRANGER`` named right after."""
    if not person.role or not text.endswith("the ", 0, at):
        return
    earlier = [
        phrase
        for phrase in find_person_nouns(text[max(0, at - _NOT_FAR) : at])
        if phrase.determiner in ("a", "an") and not phrase.plural and phrase.noun in _PERSON_NOUNS
    ]
    if earlier and not any(earlier[-1].noun in other.aliases for other in roster.people):
        roster.add_alias(person, earlier[-1].noun)
        if person.gender == "unknown":
            person.gender = lexicon.gender_of_word(earlier[-1].noun)


def _note_kin_before(roster: Roster, person: Person, before: str) -> None:
    """Note kin told before a name: ``Tobin's little sister, LARK``, ``his driver, DOT``."""
    animal = _noun_before(before)
    if animal in lexicon.ANIMALS and person.kind == "human" and not person.role:
        person.kind, person.role = "animal", animal
        roster.add_alias(person, animal)
    said = re.search(r"(?:\b(?:his|her|their)|['’]s) (?:[a-z-]+ ){0,2}([a-z-]+),? $", before)
    if said and not person.role and person.kind == "human" and is_person_noun(said.group(1)):
        person.role = said.group(1)
        if person.gender == "unknown":
            person.gender = lexicon.gender_of_word(person.role)
        roster.add_alias(person, person.role)


def _noun_before(before: str) -> str:
    """Return the noun before a name after a comma: ``a small dog, BIJOU,``; empty if there is none."""
    noun = re.search(r"(?:\b(?:an?|the|his|her|their)|['’]s) (?:[a-z-]+ ){0,2}([a-z-]+), $", before, re.IGNORECASE)
    return noun.group(1).lower() if noun and is_person_noun(noun.group(1).lower()) else ""


def _are_numbered(name: str, full_names: _FullNames) -> bool:
    """Whether people are named with numbers elsewhere: ``two THUGS`` are THUG #1 and THUG #2."""
    head = singular(name.split()[-1])
    plural = head != name.split()[-1].lower() and is_person_noun(head)
    return plural and full_names.number((" ".join([*name.split()[:-1], head.upper()]), head.upper()))


def _apposed(roster: Roster, sighting: _Sighting, name: str, text: str) -> Person | None:
    """Return the person of two nouns in capitals for one person: ``his RIVAL, a TALL ROWER,``."""
    left = text[max(0, sighting.at - 40) : sighting.at]
    before = re.search(rf"([{UPPER}][{UPPER}' -]*[{UPPER}]), (?:a |an |the )?$", left)
    people = roster.find(before.group(1)) if before else []
    if (
        people
        and people[0].role == bare(people[0].name) in lexicon.KIN
        and left.endswith(", ")
        and " " not in left[-2:-1]
    ):
        roster.rename(people[0], name)
        roster.add_alias(people[0], bare(name))
        return people[0]
    if not people or left.endswith(", ") or people[0].count > 1 or not is_person_noun(singular(name.split()[-1])):
        return None
    roster.add_alias(people[0], bare(name))
    roster.add_alias(people[0], name.split()[-1].lower())
    people[0].age = people[0].age or lexicon.AGE_WORDS.get(name.split()[0].lower(), "")
    return people[0]


def _add_person(roster: Roster, sighting: _Sighting, name: str, before: str) -> Person:
    """Return a new person, or a group for TWO GUARDS, ``two elderly WIDOWS`` and SAILORS."""
    words = name.split()
    head = singular(words[-1])
    plural = head != words[-1].lower() and is_person_noun(head)
    counted = _COUNT.match(sighting.name) or (_COUNTED_BEFORE.search(before) if plural else None)
    count = min(lexicon.NUMBERS[counted.group(1).lower()], _MOST) if counted else _SOME if plural else 1
    if count > 1:
        name = " ".join([*words[:-1], head.upper()])
    person = roster.add(name, sighting.at)
    if count > 1 and person.first == sighting.at:
        person.count, person.kind = max(person.count, count), "group" if person.kind == "human" else person.kind
        roster.add_alias(person, bare(sighting.name))
    return person


def _is_part_of(name: str, full: str) -> bool:
    """Whether a name is a part of a longer one."""
    words = full.split()
    return (
        full != name
        and name in words
        and not re.search(r"\d", full)
        and not (words[0].lower() in lexicon.VARIANT_WORDS and words[-1] == name)
        and (words[0].strip(".").lower() in lexicon.TITLES or name in (words[0], words[-1]))
    )
