"""The reader may not fall below what was measured; ``fresh`` scripts were annotated before they were first read."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[5]
sys.path.insert(0, str(ROOT / "benchmarks" / "director"))

from score import MEASURES, Count, score_file  # noqa: E402

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


@pytest.mark.parametrize("pattern", FLOORS)
def test_scores_stay_above_their_floor(pattern: str) -> None:
    total = {measure: Count() for measure in MEASURES}
    for path in sorted(GOLD.glob(pattern)):
        for measure, count in score_file(path).items():
            total[measure].merge(count)
    below = {m: round(total[m].f1, 3) for m, floor in FLOORS[pattern].items() if total[m].f1 < floor}
    assert not below


def test_a_wrong_answer_lowers_the_score(tmp_path: Path) -> None:
    gold = (GOLD / "t1_twohander.gold").read_text(encoding="utf-8")
    wrong = tmp_path / "wrong.gold"
    wrong.write_text(gold.replace("act: nora sit booth", "act: nora run booth"), encoding="utf-8")
    assert score_file(wrong)["action"].f1 < score_file(GOLD / "t1_twohander.gold")["action"].f1
