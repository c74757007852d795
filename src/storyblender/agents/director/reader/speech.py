"""Speeches: speaker, manner, listener, and the actions in their brackets (notes of the director, 1e and 0.5)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.feelings import mood_of
from storyblender.agents.director.reader.action import read_action
from storyblender.agents.director.reader.bearing.calls import is_far_end, is_other_end, take_call
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.words import Mention, Word, is_adverb, tokenize
from storyblender.agents.director.reader.page.sentences import Sentence, SpokenText
from storyblender.agents.director.reader.people.look import approximate_age
from storyblender.agents.director.reader.people.mentions import mark_mentions
from storyblender.agents.director.reader.people.person_reference import resolve_mention
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Deed, Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_OFF = re.compile(
    r"V\.?\s?O|O\.?\s?S|O\.?\s?C|OFF|FILTER|INTO PHONE|PRE-?LAP|ON (?:PHONE|RADIO|TV|SCREEN)", re.IGNORECASE
)
_QUIET = re.compile(r"whisper|\bhiss|under (?:his|her|their) breath|sotto voce|\bhush")
"""Only what is said without voice; ``softly``, ``quietly``, ``low``, ``muttering`` is talk."""
_SUNG = re.compile(r"\bs[iu]ngs?\b|\bsinging\b|\bcroon|\bchant")
_LOUD = re.compile(r"shout|scream|yell|loud|calling|bellow|roar")
_CALLED_OUT = re.compile(r"[^.?!]{1,24}!")
"""``Yusuf! Who salted this?``"""
_WORDS = re.compile(r"\w+")
_MARKS = re.compile(r"[.!?]+")
_SHORT = 6
"""Words."""
_INTO = re.compile(
    r"(?:in)?to (?:the |his |her |a )?"
    r"(phone|telephone|radio|walkie-talkie|microphone|camera|intercom|receiver|headset|cell)"
)
_TO = re.compile(r"\bto ([a-z .#0-9'’-]+)")
_POSES = frozenset({"hold", "stand", "sit", "lie_down", "sleep", "listen", "look"})
_SAYING = frozenset({"talk", "whisper", "shout"})
_MANNER = {
    "whisper": "whisper", "hiss": "whisper",
    "shout": "shout", "cry": "shout", "scream": "shout", "yell": "shout", "roar": "shout", "exclaim": "shout",
    "call": "shout", "bellow": "shout", "holler": "shout", "shriek": "shout", "bark": "shout", "thunder": "shout",
}  # fmt: skip
_ON_THE_PHONE = re.compile(
    r"^\W*(?:tele|cell)?phone\W*$"
    r"|\b(?:on|into|over|in|by|answers|answering) (?:(?:the|his|her|a) )?(?:(?:tele|cell)?phone|receiver|cell|mobile)\b"
)
"""``(on phone)``, ``(into the telephone)``: a person who picks up a phone may still talk to a person present."""
_VOCATIVE = re.compile(
    r"(?:^|[,.!]\s*)(child|kid|boy|girl|son|sir|ma'am|madam|miss|officer|doctor|doc|sergeant|captain|king|mister|sheriff|"
    r"chief|commander|lieutenant|professor|mother|father|mom|dad|mama|mamma|papa|boss|skipper)\s*[,.!?]"
)
_GENDER_OF_ADDRESS: dict[str, Gender] = {
    "son": "male", "sir": "male", "mister": "male", "boy": "male", "father": "male", "dad": "male", "papa": "male",
    "ma'am": "female", "madam": "female", "miss": "female", "girl": "female", "mother": "female", "mom": "female",
    "mama": "female", "mamma": "female",
}  # fmt: skip
_TITLED = rf"(?:{'|'.join(sorted(map(re.escape, lexicon.TITLES), key=lambda title: (-len(title), title)))})\.? "
"""A title before a name a person is called by."""
_OPENS_ADDRESS = re.compile(rf"(?:^|,\s*)(?:{_TITLED})?$")
_ENDS_ADDRESS = re.compile(r"\s*[.!?,]")
_LONG_TITLE = 40
"""Characters."""
_PARENT = {"mom": "mother", "mama": "mother", "mamma": "mother", "dad": "father", "papa": "father"}
_TO_THE_YOUNG = frozenset({"child", "kid", "boy", "girl", "son"})


@rule("speech.speaker")
def read_speech(state: ReaderState, sentence: Sentence, speech: SpokenText) -> None:
    """Read a speech into the current unit: speaker, manner, listener.

    Args:
        state: The reader's state.
        sentence: The sentence of the speech.
        speech: Its words, cue and brackets.
    """
    unit, prose = state.unit, state.reading.screenplay.format == "prose"
    speaker = _narrated_speaker(state, speech) if prose else state.find(speech.name)
    unit.kind, unit.text, unit.parenthetical, unit.dual = "dialogue", speech.text, speech.parenthetical, speech.dual
    unit.speaker_name = speech.name.title() if speech.name else speaker.name if speaker else ""
    far = is_far_end(state, speaker, speech.extension) if speaker else None
    unit.off_screen = bool(_OFF.search(speech.extension)) if far is None else far
    if speaker is None:
        return
    unit.speaker = speaker.id
    speaker.speaks = True
    if not unit.off_screen and speaker.id in state.scene.off_screen | state.scene.pictured:
        unit.off_screen = True
    state.mention(speaker, 0.3 if unit.off_screen else 1.0)
    state.discourse.last_sentence[speaker.id] = state.discourse.sentence
    if unit.off_screen:
        state.scene.off_screen |= {speaker.id} - set(state.scene.on)
        return
    state.enter(speaker)
    state.add_to_unit(speaker)
    if far is False or _ON_THE_PHONE.search(speech.parenthetical.lower()) or is_other_end(state, speaker):
        take_call(state, speaker)
    _add_speech(state, speaker, speech, prose, sentence.start)


def _narrated_speaker(state: ReaderState, speech: SpokenText) -> Person | None:
    """Return the speaker in prose: the subject of ``said``, else who acted last."""
    if not speech.subject and speech.verb == "answer" and state.discourse.last_listener:
        return state.discourse.last_listener
    if not speech.subject:
        return _unnamed_speaker(state, speech)
    mention = next((word.mention for word in speech.subject if word.mention), None)
    if mention:
        people = resolve_mention(state, mention) or mention.candidates
        return people[0] if people else None
    for index, word in enumerate(state.sentence.words):
        if any(word is said for said in speech.subject) and state.sentence.pronouns.get(index, ([], None))[0]:
            return state.sentence.pronouns[index][0][0]
    return None


def _unnamed_speaker(state: ReaderState, speech: SpokenText) -> Person | None:
    """Return the speaker of a quotation without ``said``: who acts next, the listener of the last, or who acted."""
    discourse = state.discourse
    turns = [person for person in (discourse.last_listener, discourse.last_speaker) if person]
    if speech.after and speech.after.mention:
        people = resolve_mention(state, speech.after.mention)
        return people[0] if people else None
    if speech.after:
        gender = lexicon.PRONOUNS[speech.after.low]
        fitting = [p for p in turns if p.gender in (gender, "unknown") and p is not state.roster.narrator]
        if fitting:
            return fitting[0]
    replies = speech.alone and len(state.reading.units) > 1 and state.reading.units[-2].kind == "dialogue"
    if replies and discourse.last_listener and discourse.last_listener.id in state.scene.on:
        return discourse.last_listener
    return discourse.subjects[0] if discourse.subjects else None


def _add_speech(state: ReaderState, speaker: Person, speech: SpokenText, prose: bool, at: int) -> None:
    """Write speaker, words, manner and listener into the unit."""
    unit, discourse = state.unit, state.discourse
    device = _INTO.search(speech.parenthetical.lower())
    manner = _manner(speech, prose, device)
    said_already = lexicon.MOTION_OF_VERB.get(speech.verb) if prose else None
    told = [d for d in unit.deeds if d.motion in _SAYING or (d.actor == speaker.id and d.motion == said_already)]
    named = next((state.person(d.target or "") for d in told if d.actor == speaker.id and d.target), None)
    called = speaker.id in state.calls and not _TO.match(speech.parenthetical.lower())
    listener = None if device or called else named or _listener(state, speaker, speech, prose)
    if device and not called:
        thing = state.inventory.id_of(device.group(1), at)
        state.inventory.note(thing, "handled")
        unit.things.append(thing)
    unit.deeds = [deed for deed in unit.deeds if deed not in told]
    mood = mood_of(speech.parenthetical or speech.verb)
    unit.deeds.append(Deed(speaker.id, manner, listener.id if listener else None, at=at, verb=speech.verb, mood=mood))
    if listener and listener.id not in state.scene.on:
        discourse.subjects, discourse.last_speaker, discourse.last_listener = [speaker], speaker, None
        return
    unit.to = listener.id if listener else None
    if listener:
        state.discourse.raise_salience(listener, 0.4)
    discourse.subjects = [speaker]
    discourse.last_speaker, discourse.last_listener = (None, None) if device or called else (speaker, listener)


def _manner(speech: SpokenText, prose: bool, device: re.Match[str] | None) -> str:
    """Return talk, whisper or shout."""
    parenthetical = speech.parenthetical.lower()
    if _QUIET.search(parenthetical):
        return "whisper"
    if speech.sung or _SUNG.search(parenthetical):
        return "sing"
    if _LOUD.search(parenthetical):
        return "shout"
    if prose:
        return _MANNER.get(speech.verb, "talk")
    return "shout" if _is_loud(speech.text) and not device else "talk"


def _is_loud(text: str) -> bool:
    """Whether a speech is only exclamations, or short and opens with one."""
    marks = _MARKS.findall(text)
    only = bool(marks) and all("!" in mark for mark in marks)
    return only or (len(text.split()) <= _SHORT and _CALLED_OUT.match(text) is not None)


@rule("speech.listener")
def _listener(state: ReaderState, speaker: Person, speech: SpokenText, prose: bool) -> Person | None:
    """Return whom a speech is for: told in brackets, called by name, the last speaker, the only other; else a guess."""
    others = [person for person in state.on_stage() if person is not speaker]
    here = [person for person in others if _may_be_addressed(state, person)]
    if prose and not here:
        here = others
    directed = _TO.match(speech.parenthetical.lower())
    named = state.find(directed.group(1)) if directed else None
    if named and named is not speaker:
        return named
    called = _vocative_person(state, others, speech.text) or _absent_addressee(state, speaker, speech.text)
    if called:
        return called
    last, listener = state.discourse.last_speaker, state.discourse.last_listener
    if speech.dual and listener and listener is not speaker:
        return listener
    if len(here) < 2:
        return here[0] if here else None
    turned_to = _last_target(state, speaker) or _last_actor(state, speaker)
    if turned_to in here:
        return turned_to
    if last and last is not speaker and last.id in state.scene.on:
        return last
    guess = max(here, key=lambda person: state.discourse.last_named.get(person.id, 0))
    if last is speaker and listener in here:
        guess = listener or guess
    unit = state.unit
    state.flag("addressee", guess.id, f"{speaker.name} may speak to any of {len(here)} people", unit.start, unit.end)
    return guess


def _absent_addressee(state: ReaderState, speaker: Person, text: str) -> Person | None:
    """Return an absent member of the cast who is called: ``Tully! Open up!`` behind the door."""
    called = _CALLED_OUT.match(text)
    if called is None:
        return None
    here = {speaker.id, *state.scene.on}
    away = [person for person in state.roster.people if person.id not in here and person.kind != "animal"]
    return _person_named(away, called.group())


def _may_be_addressed(state: ReaderState, person: Person) -> bool:
    """Whether a speech may be for a person not named: no sleeper, and an animal only where it speaks too."""
    awake = state.scene.posture.get(person.id, ("", None))[0] != "asleep"
    return awake and (person.kind != "animal" or person.speaks)


def _last_target(state: ReaderState, speaker: Person) -> Person | None:
    """Return whom the speaker did something to since the last speech."""
    for unit in reversed(state.reading.units[:-1]):
        if unit.kind == "dialogue" or unit.scene != state.unit.scene:
            break
        for deed in reversed(unit.deeds):
            target = state.person(deed.target or "")
            if deed.actor == speaker.id and target:
                return target
    return None


def _last_actor(state: ReaderState, speaker: Person) -> Person | None:
    """Return who acted last since the last speech, except the speaker."""
    for unit in reversed(state.reading.units[:-1]):
        if unit.kind == "dialogue" or unit.scene != state.unit.scene:
            break
        for deed in reversed(unit.deeds):
            if deed.actor != speaker.id and deed.motion not in _POSES:
                return state.person(deed.actor)
    return None


def _person_named(people: Iterable[Person], text: str) -> Person | None:
    """Return the first of these people whom a speech calls by name, or None."""
    low = text.lower()
    if not any(mark in low for mark in ",.!?"):
        return None
    said = frozenset(_WORDS.findall(low))
    for person in people:
        for name, words in _call_names(person.aliases):
            if words <= said and _is_called(name, low):
                return person
    return None


def _is_called(name: str, low: str) -> bool:
    """Whether a name is an address, at the start or after a comma; both in small letters."""
    at = low.find(name)
    while at >= 0:
        opens = _OPENS_ADDRESS.search(low, max(0, at - _LONG_TITLE), at)
        if opens and _ENDS_ADDRESS.match(low, at + len(name)):
            return True
        at = low.find(name, at + 1)
    return False


@lru_cache(maxsize=4096)
def _call_names(aliases: tuple[str, ...]) -> tuple[tuple[str, frozenset[str]], ...]:
    """Return the one-word names of a person, and the words in each."""
    names = {word for alias in aliases for word in (alias.split()[0], alias.split()[-1])}
    return tuple((name, frozenset(_WORDS.findall(name))) for name in sorted(names - lexicon.TITLES - {"i"}))


def _vocative_person(state: ReaderState, here: list[Person], text: str) -> Person | None:
    """Return who is called by name (``Wake up, Tom``) or by role (``Careful, child!``), or None."""
    named = _person_named(here, text)
    if named:
        return named
    address = _VOCATIVE.search(text.lower().replace("’", "'"))
    if address is None:
        return None
    word = address.group(1)
    meant = _PARENT.get(word, lexicon.TITLE_SYNONYMS.get(word, word))
    by_role = [person for person in here if meant in (person.role, _title(person), *person.aliases)]
    gender = _GENDER_OF_ADDRESS.get(word, "unknown")
    fitting = [person for person in here if gender != "unknown" and person.gender in (gender, "unknown")]
    if word in _TO_THE_YOUNG and not by_role:
        fitting = fitting or list(here)
        fitting.sort(key=approximate_age)
    else:
        fitting.sort(key=lambda person: -state.discourse.last_named.get(person.id, 0))
        if word in ("ma'am", "madam", "sir"):
            fitting.sort(key=lambda person: -approximate_age(person))
    return next(iter(by_role + fitting), None)


def _title(person: Person) -> str:
    """Return the title of a person in full: ``doctor`` for DR. OKORO."""
    first = person.name.lower().split()[0].strip(".")
    return lexicon.TITLE_SYNONYMS.get(first, first)


_VOICE = frozenset({"talk", "whisper", "shout", "sing", "phone"})
"""Motions that a speech implies by itself."""


@rule("speech.brackets")
def read_parenthetical_action(state: ReaderState, sentence: Sentence, speech: SpokenText) -> None:
    """Read the actions of a speaker in the brackets of a speech: ``(picking up the rose)``.

    Args:
        state: Its unit is the speech, with its speaker.
        sentence: Of the speech.
        speech: With what stands in brackets.
    """
    speaker = state.person(state.unit.speaker or "")
    if speaker is None or state.unit.off_screen:
        return
    discourse, spoken = state.discourse, len(state.unit.deeds)
    present, subjects = discourse.salience.get(speaker.id, 0.0), discourse.subjects
    for part in re.split(r"[,;]\s*|\s+and\s+(?=[a-z]+(?:s|ing)\b)", speech.parenthetical.strip("()[] ")):
        words = mark_mentions(tokenize(part, sentence.start), state.roster)
        first = next((word for word in words if not is_adverb(word)), None)
        form = FORMS.get(first.low) if first else None
        if form and form.kind in ("ing", "3sg") and lexicon.MOTION_OF_VERB.get(form.lemma, "talk") not in _VOICE:
            mention = Mention("name", [speaker], speaker.name.lower(), start=sentence.start)
            name = Word(speaker.name, sentence.start, sentence.start, mention)
            read_action(state, replace(sentence, words=[name, *words], speech=None))
    deeds = state.unit.deeds
    state.unit.deeds = deeds[spoken:] + deeds[:spoken]
    # Brackets are no sentence: the speech decides what the next ``she`` means.
    discourse.salience[speaker.id], discourse.subjects = present, subjects
