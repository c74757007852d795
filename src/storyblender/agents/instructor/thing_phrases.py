"""The phrases about things that the rules know: they are replaced, coloured, taken away and added; only what can be."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.agents.instructor.set_phrases import THE
from storyblender.catalog.fixtures import is_part_called
from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.phrases import HEAPS
from storyblender.catalog.props.prop_names import kind_named, prop_named
from storyblender.catalog.props.variants import COLORS, MATERIALS, read_variant, words_of
from storyblender.memory.edits import AssetEdit, Edit
from storyblender.memory.vocabulary import RelationKind

_REPLACE: Final = (
    re.compile(
        rf"(?:replace|swap|exchange|trade|change|turn|make) {THE}(?P<thing>.+?) (?:by|with|for|to|into)"
        rf" {THE}(?P<model>.+)"
    ),
    re.compile(rf"(?:put )?{THE}(?P<model>.+?) (?:instead of|in place of|rather than) {THE}(?P<thing>.+)"),
    re.compile(r"make the (?P<thing>\w+(?: \w+)?) an? (?P<model>.+)"),
)
_ANY_COLOUR: Final = f"(?:{'|'.join(sorted({*COLORS, *MATERIALS}))})"
_COLOUR: Final = re.compile(
    rf"(?:make|paint|dye|colou?r|turn) {THE}(?P<thing>.+?) (?:in |into )?(?P<colours>{_ANY_COLOUR}(?: {_ANY_COLOUR})*)"
)
_REMOVE: Final = re.compile(
    rf"(?:remove|delete|lose|take away|take out|clear away|get rid of|without|no) {THE}(?P<thing>.+)"
    rf"|take {THE}(?P<taken>.+) (?:away|out)"
)
_SENTENCE: Final = re.compile(r"\b(?:holds?|looks?|sits?|lies?|leans?|stands?) (?:on |at |against |in )?the\b")
"""Words that say what a person does with a thing, and are no name of one."""
_ADD: Final = re.compile(
    r"(?:(?P<verb>add|put in|put|bring in|with|place|stand|there (?:is|should be)) )?(?:an?|another|one|some)"
    r" (?P<what>.+?)(?: (?:in|into|to) (?:the )?(?:room|scene|set|picture))?"
)
_RELATIONS: Final[dict[str, RelationKind]] = {
    "on top of": "on", "on the left of": "left_of", "on the right of": "right_of", "to the left of": "left_of",
    "to the right of": "right_of", "left of": "left_of", "right of": "right_of", "in front of": "in_front_of",
    "next to": "next_to", "close to": "next_to", "beside": "next_to", "by": "next_to", "near": "next_to", "on": "on",
    "in": "in", "under": "under", "below": "under", "beneath": "under", "over": "over", "above": "over",
    "behind": "behind", "against": "against", "at": "at", "around": "around",
}  # fmt: skip
_RELATION: Final = re.compile(rf" (?P<relation>{'|'.join(_RELATIONS)}) {THE}")
_OLD: Final = frozenset(("old", "present", "current"))
"""Words that say no more than that a thing is there."""
_SIDES: Final = frozenset(("left", "right", "back", "front", "side"))
_UNDERFOOT: Final = frozenset(("floor", "ground"))


def edits_of_things(words: str, scene: SceneNow) -> list[Edit] | str:
    """Return what words do with things, or in one sentence why it cannot be; none where they mean something else.

    Args:
        words: In lower case: ``replace the sofa by a red bench``, ``make the sofa red``, ``put a piano by the window``.
        scene: As it is.
    """
    for pattern in _REPLACE:
        match = pattern.fullmatch(words)
        if match is not None and kind_named(match["model"]) and (thing := _there(match["thing"], scene)):
            problem = _no_such(thing, match["thing"], scene) or _cannot_be(match["model"])
            return problem or [AssetEdit(action="replace", thing=thing, scene=scene.name, model=match["model"])]
    if match := _COLOUR.fullmatch(words):
        return _coloured(match["thing"], match["colours"], scene)
    if match := _REMOVE.fullmatch(words):
        name = match["thing"] or match["taken"]
        if _SENTENCE.search(name):
            return []
        thing = _there(name, scene)
        problem = _no_such(thing, name, scene)
        return problem or ([AssetEdit(action="remove", thing=thing, scene=scene.name)] if thing else [])
    match = _ADD.fullmatch(words)
    return _added(match["what"], scene, placed=match["verb"] is None) if match is not None else []


def _coloured(name: str, colours: str, scene: SceneNow) -> list[Edit] | str:
    """Return a thing in another colour or material: it is replaced by its like."""
    thing = _there(name, scene)
    if not thing:
        return []
    if problem := _no_such(thing, name, scene):
        return problem
    key = scene.things.get(thing) or scene.furniture.get(thing) or kind_named(thing.replace("_", " "))
    if key not in PROPS:
        return f"the library has no {name}, so its colour cannot be chosen"
    several = PROPS[key].name if noun_key(thing) == thing else thing
    model = f"{colours} {several}"
    if kind_named(model) != key:
        return f"the library has no {model}"
    return _cannot_be(model) or [AssetEdit(action="replace", thing=thing, scene=scene.name, model=model)]


def _added(what: str, scene: SceneNow, *, placed: bool) -> list[Edit] | str:
    """Return a thing that is added, at its place if one is told.

    Args:
        what: ``piano by the window``.
        scene: As it is.
        placed: Whether it counts only with a place.
    """
    unknown = ""
    for model, relation, name in _places(what):
        if not kind_named(model):
            continue
        if name in _UNDERFOOT and prop_named(model).placement == "floor":  # type: ignore[union-attr]
            anchor = ""
        else:
            anchor = _anchor(name, scene)
            if not anchor:
                unknown = unknown or f"there is no {name} in {scene.name}"
                continue
        said = {"relation": relation, "anchor": anchor} if anchor else {}
        edit = AssetEdit.model_validate({"action": "add", "scene": scene.name, "model": model, **said})
        return _cannot_be(model, single=True) or [edit]
    if unknown:
        return unknown
    if placed or not kind_named(what):
        return []
    return _cannot_be(what, single=True) or [AssetEdit(action="add", scene=scene.name, model=what)]


def _places(what: str) -> Iterator[tuple[str, RelationKind, str]]:
    """Yield each way to read words as a thing, a relation and what it is related to."""
    for match in _RELATION.finditer(what):
        yield what[: match.start()], _RELATIONS[match["relation"]], what[match.end() :]


def _anchor(name: str, scene: SceneNow) -> str:
    """Return the id of a thing, or the name of a part of the set, that words mean; empty if there is none."""
    thing = _there(name, scene)
    if thing and not _no_such(thing, name, scene):
        return "_".join(thing.split())
    words = name.split()
    if is_part_called(words[-1], scene.parts) and {*words[:-1]} <= _SIDES:
        return "_".join(words)
    return ""


def _there(name: str, scene: SceneNow) -> str:
    """Return how an edit calls what words name: the id of a thing, or the words themselves; empty if it is no thing."""
    as_id, kind = "_".join(name.split()), kind_named(name)
    if as_id in scene.things or as_id in scene.furniture:
        return as_id
    own = next((asset_id for asset_id, prop in scene.things.items() if kind and prop == kind), "")
    return own or (name if kind else "")


def _no_such(thing: str, name: str, scene: SceneNow) -> str:
    """Return in one sentence that a scene has no such thing; empty if it has."""
    if not thing or thing in scene.things or thing in scene.furniture:
        return ""
    kind = kind_named(name)
    if kind not in {*scene.things.values(), *scene.furniture.values()}:
        return f"there is no {name} in {scene.name}"
    more = [word for word in words_of(name) if word not in _OLD and not _is_own(word, PROPS[kind])]
    return f"which {PROPS[kind].name} is {' '.join(more)!r} is not known" if more else ""


def _cannot_be(model: str, *, single: bool = False) -> str:
    """Return in one sentence what the library's thing cannot be of what words say about it; empty if it can be all.

    Args:
        model: ``red bench``.
        single: Whether it has to be one.
    """
    entry = prop_named(model)
    assert entry is not None, "it is in the library"
    words = words_of(model)
    last = words[-1]
    if single and noun_key(last) != last and not any(last in term.split() for term in (entry.name, *entry.tags)):
        return f"things are added one at a time, so say which {entry.name}, and where"
    whole = read_variant(entry, model)
    idle = [
        word
        for word in words
        if not _is_own(word, entry)
        and word not in ("of", *HEAPS)
        and MATERIALS.get(word) not in entry.materials.values()
        and read_variant(entry, " ".join(each for each in words if each != word)) == whole
    ]
    return f"the library's {entry.name} cannot be {' '.join(idle)!r}" if idle else ""


def _is_own(word: str, entry: PropEntry) -> bool:
    """Return whether a word is one of the names of a prop."""
    known = {each for term in (entry.name, *entry.tags) for each in words_of(term)}
    return bool({word, noun_key(word)} & {*known, *map(noun_key, known)})
