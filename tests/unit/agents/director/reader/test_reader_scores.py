"""The reader may not fall below what was measured; ``fresh`` scripts were annotated before they were first read."""

import re
import sys
from functools import cache
from pathlib import Path

import pytest
from tests.every import every

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

ROOT = Path(__file__).parents[5]
sys.path.insert(0, str(ROOT / "benchmarks" / "director"))

from score import MEASURES, Count, Gold, Scorer, parse_gold, score_file  # noqa: E402

GOLD = ROOT / "tests" / "data" / "director"
FLOORS = {
    "t?_*.gold": {
        "cast": 0.98, "scene": 0.98, "on-stage": 0.98, "objects": 0.94, "props": 0.95, "action": 0.95,
        "action+target": 0.94, "relation": 0.89, "pronoun": 0.93,
    },
    "prose*.gold": {
        "cast": 0.98, "scene": 0.98, "on-stage": 0.96, "objects": 0.82, "props": 0.9, "action": 0.93,
        "action+target": 0.78, "relation": 0.85, "pronoun": 0.93,
    },
    "fresh_*.gold": {
        "cast": 0.96, "scene": 0.88, "on-stage": 0.94, "objects": 0.82, "props": 0.84, "action": 0.91,
        "action+target": 0.85, "relation": 0.8, "pronoun": 0.88,
    },
    "unseen_*.gold": {
        "cast": 0.95, "on-stage": 0.92, "action": 0.8, "action+target": 0.68, "relation": 0.6, "pronoun": 0.8,
    },
    "dev_*.gold": {
        "cast": 0.93, "scene": 0.98, "on-stage": 0.95, "objects": 0.86, "props": 0.82, "action": 0.81,
        "action+target": 0.7, "relation": 0.59, "pronoun": 0.83,
    },
    "dev2_*.gold": {
        "cast": 0.94, "scene": 0.72, "on-stage": 0.9, "objects": 0.82, "props": 0.79, "action": 0.76,
        "action+target": 0.61, "relation": 0.52, "pronoun": 0.79,
    },
    "dev3_*.gold": {
        "cast": 0.96, "scene": 0.98, "on-stage": 0.97, "objects": 0.9, "props": 0.88, "action": 0.81,
        "action+target": 0.69, "relation": 0.74, "pronoun": 0.88,
    },
    "dev4_*.gold": {
        "cast": 0.95, "scene": 0.7, "on-stage": 0.96, "objects": 0.86, "props": 0.84, "action": 0.83,
        "action+target": 0.7, "relation": 0.65, "pronoun": 0.83,
    },
    "dev5_*.gold": {
        "cast": 0.98, "scene": 0.9, "on-stage": 0.95, "objects": 0.91, "props": 0.87, "action": 0.83,
        "action+target": 0.75, "relation": 0.68, "pronoun": 0.84,
    },
    "dev6_*.gold": {
        "cast": 0.98, "scene": 0.85, "on-stage": 0.88, "objects": 0.86, "props": 0.86, "action": 0.82,
        "action+target": 0.77, "relation": 0.62, "pronoun": 0.89,
    },
    "dev7_*.gold": {
        "cast": 0.98, "on-stage": 0.96, "objects": 0.85, "props": 0.86, "action": 0.88, "action+target": 0.72,
        "relation": 0.71, "pronoun": 0.88,
    },
    "dev8_*.gold": {
        "cast": 0.95, "on-stage": 0.98, "objects": 0.87, "props": 0.92, "action": 0.89, "action+target": 0.74,
        "relation": 0.76, "pronoun": 0.85,
    },
}  # fmt: skip


@cache
def answered(path: Path) -> tuple[Gold, Reading]:
    """Return a script's answers and how it is read."""
    gold = parse_gold(path)
    return gold, read_script(read(gold.text))


@pytest.mark.parametrize("pattern", FLOORS)
def test_scores_stay_above_their_floor(pattern: str) -> None:
    total = {measure: Count() for measure in MEASURES}
    for path in sorted(GOLD.glob(pattern)):
        for measure, count in Scorer(*answered(path)).score().items():
            total[measure].merge(count)
    below = {m: round(total[m].f1, 3) for m, floor in FLOORS[pattern].items() if total[m].f1 < floor}
    assert not below


def test_a_wrong_answer_lowers_the_score(tmp_path: Path) -> None:
    gold = (GOLD / "t1_twohander.gold").read_text(encoding="utf-8")
    wrong = tmp_path / "wrong.gold"
    wrong.write_text(gold.replace("act: nora sit booth", "act: nora run booth"), encoding="utf-8")
    assert score_file(wrong)["action"].f1 < score_file(GOLD / "t1_twohander.gold")["action"].f1


@every("thing", ["cup", "book", "key", "ball", "knife", "letter", "hat"])
def test_an_act_that_may_be_two_answers_is_the_first_that_is_open(thing: str, tmp_path: Path) -> None:
    page = tmp_path / "page.gold"
    page.write_text(
        f"|| cast: jo=Jo; al=Al\nINT. HALL - DAY\n\nJO (30) throws the {thing} at AL (40). Jo throws the {thing}.\n"
        f"| act: jo throw al; jo throw {thing}\n"
    )
    assert score_file(page)["action+target"].missed == []


@every("name", sorted(path.name for path in GOLD.glob("*.gold")))
def test_every_id_is_known(name: str) -> None:
    _, reading = answered(GOLD / name)
    deeds = [deed for unit in reading.units for deed in unit.deeds]
    known = {p.id for p in reading.people} | {t.id for t in reading.things}
    used = {id for deed in deeds for id in (deed.actor, deed.target, deed.prop) if id}
    used -= {id for id in used if id.rsplit("_", 1)[-1] in lexicon.PARTS | lexicon.LIQUIDS | {*lexicon.PART_OF}}
    ends = {id for _, r in reading.relations for id in (r.asset_id, r.anchor_asset_id)}
    placed = {id for id in ends if id.rsplit("_", 1)[-1] not in lexicon.words("surfaces")}  # a top step is one
    used |= {id for id in placed if lexicon.noun_class(id.replace("_", " ")) != "worn"}
    assert used <= known


def runs(text: str, length: int = 5) -> set[tuple[str, ...]]:
    """Return all successive words of the lines of a text, without those that anybody writes: ``on the edge of the``."""
    lines = (re.findall(r"[a-z][a-z']*", line) for line in text.lower().splitlines())
    found = {tuple(line[at : at + length]) for line in lines for at in range(len(line) - length + 1)}
    return {words for words in found if sum(len(word) > 3 for word in words) > 1}


@every("name", sorted(path.name for path in GOLD.glob("*.gold") if path.name.startswith(("fresh_", "unseen_"))))
def test_no_rule_quotes_a_page_that_is_scored(name: str) -> None:
    quoted = [" ".join(words) for words in runs(parse_gold(GOLD / name).text) & rules()]
    assert quoted == []


@cache
def rules() -> set[tuple[str, ...]]:
    files = [file for file in (ROOT / "src/storyblender/agents/director").rglob("*") if file.suffix in (".py", ".tsv")]
    assert len(files) > 100
    return set().union(*(runs(file.read_text("utf-8")) for file in files))
