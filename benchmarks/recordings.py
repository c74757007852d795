"""What models got wrong in recorded stories, what caught it, and after how many answers it was right.

``python -m benchmarks recordings [FOLDER ...]``: each FOLDER has a script and its ``answers``, and ``models`` if the
user had some, as in ``tests/data/recordings``. The story is made again from the answers; the table comes from both.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from storyblender.agents.asking import read_answer_as
from storyblender.language.answer_folder import BEFORE, REQUEST, asked
from storyblender.language_crew import ANSWERS
from storyblender.project import TRACE

RECORDINGS = Path(__file__).parent.parent / "tests/data/recordings"
_FORM, _CHECK, _CRITIC = "form", "check", "critic"


@dataclass(frozen=True)
class Mistake:
    """An answer that was sent back.

    Attributes:
        role: Whose it was.
        subject: What was to be decided.
        caught_by: ``form`` (the schema), ``check`` (what no schema can say) or ``critic`` (a draft that was judged).
        why: The first sentence that was sent back.
    """

    role: str
    subject: str
    caught_by: str
    why: str


def mistakes(answers: Path) -> list[Mistake]:
    """Return the answers of a recording that were sent back, in order of their requests.

    Args:
        answers: The folder.
    """
    given = {answer for _, answer in asked(answers) if answer is not None}
    found: list[Mistake] = []
    for name, _ in asked(answers):
        page = (answers / f"{name}{REQUEST}").read_text(encoding="utf-8")
        if BEFORE not in page:
            continue
        after = page.partition(BEFORE)[2]
        previous, _, complaints = after.partition("## What is wrong with it")
        text = previous.strip().partition("\n")[2].rpartition("\n")[0]
        why = next(line[2:] for line in complaints.splitlines() if line.startswith("* "))
        role, subject, _ = _parts(name)
        form_is_wrong = role in ANSWERS and bool(read_answer_as(ANSWERS[role], text)[1])
        caught_by = _FORM if form_is_wrong else _CHECK if text in given else _CRITIC
        found.append(Mistake(role, subject, caught_by, why))
    return found


def _parts(name: str) -> tuple[str, str, str]:
    """Return role, subject and digest of a request's name; a role without a subject has only two parts."""
    role, _, rest = name.partition("-")
    subject, _, digest = rest.rpartition("-")
    return role, subject, digest


def replayed(script: Path, answers: Path, project: Path, options: Sequence[str]) -> None:
    """Make a story again from its recorded answers. Raises CalledProcessError where that fails.

    Args:
        script: The script.
        answers: The recording.
        project: Where the project is written.
        options: More options of ``storyblender make``.
    """
    roles = sorted({_parts(name)[0] for name, _ in asked(answers)})
    crew = ",".join(["rules", *(f"{role}=replay:{answers}" for role in roles)])
    command = [sys.executable, "-m", "storyblender", "make", str(script), "--out", str(project), "--crew", crew]
    subprocess.run([*command, "--quiet", *options], check=True)


def print_table(answers: Path, project: Path) -> None:
    """Print requests, mistakes, scores and handovers of one story by role.

    Args:
        answers: The recording.
        project: The project made from it.
    """
    asked_of = Counter(_parts(name)[0] for name, _ in asked(answers))
    wrong = mistakes(answers)
    by_role = Counter((each.role, each.caught_by) for each in wrong)
    turns = _turns(project)
    heads = (
        ("answers", 8),
        (_FORM, 6),
        (_CHECK, 6),
        (_CRITIC, 7),
        ("first", 7),
        ("last", 6),
        ("turns", 6),
        ("to rules", 9),
    )
    print(f"{'role':24}" + "".join(f"{head:>{width}}" for head, width in heads))
    for role, count in sorted(asked_of.items()):
        sent_back = "".join(
            f"{by_role[role, kind]:>{width}}" for kind, width in ((_FORM, 6), (_CHECK, 6), (_CRITIC, 7))
        )
        print(f"{role:24}{count:>8}{sent_back}{turns.get(role, '')}")
    for each in wrong:
        print(f"  {each.role} {each.subject}, by {each.caught_by}: {each.why}")


def _turns(project: Path) -> dict[str, str]:
    """Return, by role, the mean first and last score, the most turns, and how often rules took over."""
    scores: dict[tuple[str, str], list[float]] = defaultdict(list)
    handovers = Counter[str]()
    for line in (project / TRACE).read_text(encoding="utf-8").splitlines():
        event = json.loads(line)
        if event["kind"] == "score":
            scores[event["role"], event["subject"]].append(event["score"])
        handovers[event["role"]] += event["kind"] == "handover"
    found: dict[str, str] = {}
    for role in {role for role, _ in scores}:
        runs = [run for (each, _), run in scores.items() if each == role]
        first, last = _mean(run[0] for run in runs), _mean(run[-1] for run in runs)
        found[role] = f"{first:>7.1f}{last:>6.1f}{max(map(len, runs)):>6}{handovers[role]:>9}"
    return found


def _mean(values: Iterable[float]) -> float:
    listed = list(values)
    return sum(listed) / len(listed)


def main() -> None:
    """Replay the recordings and print their tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path, default=sorted(RECORDINGS.iterdir()))
    parser.add_argument("--width", type=int, default=480)
    arguments = parser.parse_args()
    for folder in arguments.folders:
        script = next(path for path in sorted(folder.iterdir()) if path.is_file())
        with tempfile.TemporaryDirectory() as temporary:
            project = Path(temporary) / folder.name
            models = [word for place in folder.glob("models") for word in ("--models", str(place))]
            options = ["--no-animatic", "--width", str(arguments.width), *models]
            replayed(script, folder / "answers", project, options)
            print(f"\n{folder.name}", flush=True)
            print_table(folder / "answers", project)


if __name__ == "__main__":
    main()
