"""Score the rule-based reader against scripts with their answers written in.

A ``.gold`` file is a script with lines of answers after the paragraph they are for:

    || cast: nora=Nora/Nora Vance; ben=Ben      who is physically in the story, with their names
    || props: folder, ring                      and ``set:`` the furniture and structures, ``absent:`` only talked of
    |s int; roadside diner; night               the scene that starts here
    | on: nora,ben                              who is on stage when the paragraph is over, exits not yet taken
    | act: nora give ben; ben open folder       actor, motion, target or thing (optional)
    | rel: folder on table                      relations stated
    | pro: it=folder; They=nora+ben             what pronouns mean, in order

The rules of annotation are in ``ANNOTATING.md``. Run ``python benchmarks/director/score.py [-v] FILES``; ``-v`` lists
what was missed and what was too much.
"""

from __future__ import annotations

import argparse
import re
from collections import Counter, defaultdict
from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reader.people.roster import bare
from storyblender.agents.director.reading import Person, Reading
from storyblender.catalog.inflection import singular
from storyblender.screenplay.source import read

MEASURES = ("cast", "scene", "on-stage", "objects", "props", "action", "action+target", "relation", "pronoun")
_RELATION = re.compile(
    r" (on|in|under|over|behind|next_to|in_front_of|facing|left_of|right_of|at|against|between|inside) "
)


@dataclass
class Count:
    """Hits and misses of one measure."""

    hits: int = 0
    extra: list[str] = field(default_factory=list)
    missed: list[str] = field(default_factory=list)

    def add(self, gold: Iterable[Hashable], found: Iterable[Hashable], where: str = "") -> None:
        """Compare two bags of answers."""
        wanted, got = Counter(gold), Counter(found)
        self.hits += (wanted & got).total()
        self.extra += [f"{where} {answer}" for answer in (got - wanted).elements()]
        self.missed += [f"{where} {answer}" for answer in (wanted - got).elements()]

    def merge(self, other: Count) -> None:
        """Add another count to this one."""
        self.hits += other.hits
        self.extra += other.extra
        self.missed += other.missed

    @property
    def precision(self) -> float:
        return self.hits / (self.hits + len(self.extra)) if self.hits + len(self.extra) else 1.0

    @property
    def recall(self) -> float:
        return self.hits / (self.hits + len(self.missed)) if self.hits + len(self.missed) else 1.0

    @property
    def f1(self) -> float:
        total = self.precision + self.recall
        return 2 * self.precision * self.recall / total if total else 0.0


@dataclass
class Segment:
    """A stretch of the script with its answers."""

    start: int
    end: int
    answers: dict[str, str] = field(default_factory=dict)

    def items(self, key: str, separator: str = ";") -> list[str]:
        return [item.strip() for item in self.answers.get(key, "").split(separator) if item.strip()]


@dataclass
class Gold:
    """A script and all its answers."""

    text: str
    segments: list[Segment]
    cast: dict[str, str]
    """Every name, lower case without article -> the gold id."""
    things: dict[str, set[str]]
    scenes: list[tuple[str, str, str]]

    @property
    def ids(self) -> list[str]:
        """Gold ids of people, the longest first."""
        return sorted(set(self.cast.values()), key=lambda id: (-len(id), id))


def parse_gold(path: Path) -> Gold:
    """Read a ``.gold`` file."""
    lines: list[str] = []
    segments: list[Segment] = []
    meta: dict[str, str] = defaultdict(str)
    scenes: list[tuple[str, str, str]] = []
    position, running = 0, False
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("|"):
            running = False
            if line.startswith("|| "):
                key, value = line[3:].split(":", 1)
                meta[key] += value.strip()
            elif line.startswith("|s "):
                inout, place, time = (part.strip() for part in line[3:].split(";"))
                scenes.append((inout, place, time))
            else:
                key, value = line[2:].split(":", 1)
                segments[-1].answers[key] = value.strip()
            continue
        end = position + len(line)
        if running and segments and segments[-1].end == position - 1:
            segments[-1].end = end
        else:
            segments.append(Segment(position, end))
        running = bool(line.strip())
        lines.append(line)
        position = end + 1
    names: dict[str, str] = {}
    for entry in meta["cast"].split(";"):
        id, _, aliases = entry.strip().partition("=")
        for alias in [id, *aliases.split("/")]:
            names[bare(alias)] = id.strip()
    things = {kind: {_plain(item) for item in meta[kind].split(",") if item.strip()} for kind in ("props", "set")}
    return Gold("\n".join(lines), segments, names, things, scenes)


def _plain(text: str) -> str:
    return " ".join(singular(word) for word in text.split())


class Scorer:
    """Compares one reading with its gold."""

    def __init__(self, gold: Gold, reading: Reading) -> None:
        self.gold, self.reading = gold, reading
        self.people = {person.id: self._gold_id(person) for person in reading.people}
        self.things = {thing.id: thing.name for thing in reading.things}
        self.counts = {measure: Count() for measure in MEASURES}

    def _gold_id(self, person: Person) -> str:
        names = [person.name, *sorted(person.aliases, key=len, reverse=True)]
        known = (self.gold.cast[bare(name)] for name in names if bare(name) in self.gold.cast)
        return next(known, bare(person.name))

    def name(self, id: str | None) -> str:
        """What an asset id is called in the gold."""
        if not id:
            return ""
        return self.people.get(id) or self.things.get(id) or id.replace("_", " ")

    def score(self) -> dict[str, Count]:
        """All measures."""
        self._cast()
        self._scenes()
        self._things()
        self._relations()
        for segment in self.gold.segments:
            self._segment(segment)
        return self.counts

    def _cast(self) -> None:
        crowds = {p.id for p in self.reading.people if p.count > 1 and bare(p.name) not in self.gold.cast}
        seen = {person for unit in self.reading.units for person in unit.on_stage} - crowds
        self.counts["cast"].add(set(self.gold.cast.values()), [self.people[id] for id in sorted(seen)])

    def _scenes(self) -> None:
        found = []
        for index, scene in enumerate(self.reading.scenes):
            timed = index >= len(self.gold.scenes) or self.gold.scenes[index][2]
            found.append(("int" if scene.scene_type == "indoor" else "ext", scene.place, scene.time if timed else ""))
        self.counts["scene"].add(self.gold.scenes, found)

    def _things(self) -> None:
        props, furniture = self.gold.things["props"], self.gold.things["set"]

        def known(name: str) -> str:
            name = _plain(name)
            head = name.rsplit(" ", 1)[-1]
            return head if name not in props | furniture and head in props | furniture else name

        found = {known(thing.name) for thing in self.reading.things if thing.kind == "prop"}
        others = {known(thing.name) for thing in self.reading.things if thing.kind != "prop"}
        self.counts["props"].add(props, found)
        self.counts["objects"].add(props | furniture, found | others)

    def _relations(self) -> None:
        gold: set[tuple[int, str, str, str]] = set()
        for segment in self.gold.segments:
            scene = next((u.scene for u in self.reading.units if segment.start <= u.start <= segment.end), -1)
            for item in segment.items("rel"):
                person = next((id for id in self.gold.ids if item.startswith(id + " ")), "")
                found = _RELATION.search(item, len(person))
                if found:
                    kind = "in" if found.group(1) == "inside" else found.group(1)
                    gold.add((scene, _plain(item[: found.start()]), kind, _plain(item[found.end() :])))
        words = {word for _, subject, _, anchor in gold for word in (subject, anchor)}

        def known(id: str) -> str:
            name = _plain(self.name(id))
            return name if name in words or name.rsplit(" ", 1)[-1] not in words else name.rsplit(" ", 1)[-1]

        stated: set[tuple[int, str, str, str]] = set()
        for scene, relation in self.reading.relations:
            for anchor in filter(None, (relation.anchor_asset_id, relation.second_anchor_asset_id)):
                stated.add((scene, known(relation.asset_id), relation.kind, known(anchor)))
        self.counts["relation"].add(gold, stated)

    def _segment(self, segment: Segment) -> None:
        where = " ".join(self.gold.text[segment.start : segment.end].split())[:40]
        units = [unit for unit in self.reading.units if segment.start <= unit.start <= segment.end]
        if segment.answers.keys() & {"on", "act", "rel"}:
            on = {self.name(person) for unit in units for person in unit.on_stage}
            self.counts["on-stage"].add(segment.items("on", ","), on, where)
        gold = dict.fromkeys(action for item in segment.items("act") if (action := self._action(item)))
        stand_ins = {flag.start for flag in self.reading.flags if flag.topic == "act"}
        found = [
            (self.name(deed.actor), deed.motion, self.name(deed.target), self.name(deed.prop))
            for unit in units
            for deed in unit.deeds
            if deed.at not in stand_ins  # an act without a motion of its own, shown by the nearest and flagged
        ]
        self.counts["action"].add({g[:2] for g in gold}, {f[:2] for f in found}, where)
        self._targets([g for g in gold if g[2]], found, where)
        self._pronouns(segment, where)

    def _action(self, item: str) -> tuple[str, str, str] | None:
        actor = next((id for id in self.gold.ids if item.startswith(id + " ")), None)
        if actor is None:
            raise ValueError(f"the actor of {item!r} is not in the cast")
        motion, _, target = item[len(actor) + 1 :].partition(" ")
        return actor, motion, target

    def _targets(self, gold: list[tuple[str, str, str]], found: list[tuple[str, str, str, str]], where: str) -> None:
        """Actions whose gold names a target: right if target or prop has its head noun.

        Of two that an action may be, it is the first as written that none before it was.
        """
        answers: set[tuple[str, str, str]] = set()
        for actor, motion, target, prop in found:
            options = [g for g in gold if g[:2] == (actor, motion)]
            if options:
                heads = {singular(word) for name in (target, prop) if name for word in (name, name.split()[-1])}
                hits = [g for g in options if singular(g[2]) in heads]
                hit = next((g for g in hits if g not in answers), hits[0] if hits else None)
                answers.add(hit or (actor, motion, target or prop))
        self.counts["action+target"].add(gold, answers, where)

    def _pronouns(self, segment: Segment, where: str) -> None:
        """The n-th use of a word in the gold against its n-th use in the reading; others do not count."""
        uses: Counter[str] = Counter()
        gold: set[tuple[str, int, str]] = set()
        for item in segment.items("pro"):
            word, _, who = (part.strip() for part in item.partition("="))
            uses[word.lower()] += 1
            gold.add((word.lower(), uses[word.lower()], "+".join(sorted(singular(name) for name in who.split("+")))))
        uses.clear()
        answers: set[tuple[str, int, str]] = set()
        meanings = {who for _, _, who in gold}
        spoken = {(at, word, who) for at, word, who in self.reading.pronouns if segment.start <= at <= segment.end}
        for _, word, who in sorted(spoken):
            uses[word.lower()] += 1
            meaning = "+".join(sorted(singular(self.name(id)) for id in who))
            head = meaning.rsplit(" ", 1)[-1]
            meaning = head if meaning not in meanings and "+" not in meaning and head in meanings else meaning
            answers.add((word.lower(), uses[word.lower()], meaning))
        asked = {g[:2] for g in gold}
        self.counts["pronoun"].add(gold, {a for a in answers if a[:2] in asked}, where)


def score_file(path: Path) -> dict[str, Count]:
    """Read the script of a ``.gold`` file and score it."""
    gold = parse_gold(path)
    return Scorer(gold, read_script(read(gold.text))).score()


def main() -> None:
    """Print precision, recall and F1 of every measure over all files given."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("-v", "--verbose", action="store_true", help="list what was missed and what was too much")
    arguments = parser.parse_args()
    total = {measure: Count() for measure in MEASURES}
    for path in arguments.files:
        counts = score_file(path)
        print(f"{path.stem:<22}", "  ".join(f"{measure} {count.f1:.2f}" for measure, count in counts.items()))
        for measure, count in counts.items():
            total[measure].merge(count)
            if arguments.verbose:
                print(
                    *(f"    {measure}: MISSED {item}" for item in count.missed), sep="\n", end="\n" * bool(count.missed)
                )
                print(
                    *(f"    {measure}: EXTRA  {item}" for item in count.extra), sep="\n", end="\n" * bool(count.extra)
                )
    print()
    for measure, count in total.items():
        print(
            f"{measure:<14} P {count.precision:.2f}  R {count.recall:.2f}  F1 {count.f1:.2f}  "
            f"({count.hits} hits, {len(count.extra)} extra, {len(count.missed)} missed)"
        )


if __name__ == "__main__":
    main()
