"""The ledger of paid work: what was sent is never sent again unasked."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.library.shared.cleaning import rebuilt_index
from storyblender.library.shared.index import DamagedIndex
from storyblender.library.shared.jobs import JOURNAL, JobLedger, OutcomeUnknown
from storyblender.library.shared.shared_library import INDEX, SharedLibrary


@pytest.fixture
def jobs(tmp_path: Path) -> JobLedger:
    return SharedLibrary.open(tmp_path / "library").jobs


def reopened(tmp_path: Path) -> JobLedger:
    return SharedLibrary.open(tmp_path / "library").jobs


def test_submitted_work_is_gone_on_with_by_another_run(jobs: JobLedger, tmp_path: Path) -> None:
    job = jobs.submitted(jobs.begin("ab", "meshy", 0.2), "task-7")
    again = reopened(tmp_path).begin("ab", "meshy", 0.2)
    assert (again.id, again.state, again.remote_id, again.price) == (job.id, "submitted", "task-7", 0.2)
    assert reopened(tmp_path).unfinished() == [again]


def test_work_whose_outcome_is_not_known_is_not_sent_again_before_a_person_says_so(
    jobs: JobLedger, tmp_path: Path
) -> None:
    job = jobs.begin("ab", "meshy", 0.2)
    with pytest.raises(OutcomeUnknown, match=f"--ask-again {job.id}"):
        reopened(tmp_path).begin("ab", "meshy", 0.2)
    assert jobs.begin("ab", "trellis", 0.1).service == "trellis", "the same of another service is other work"
    reopened(tmp_path).ask_again(job.id)
    assert jobs.begin("ab", "meshy", 0.2).id != job.id


def test_finished_and_failed_work_may_be_asked_for_anew(jobs: JobLedger) -> None:
    done = jobs.finished(jobs.submitted(jobs.begin("ab", "meshy", 0.2), "task-7"), "ef" * 32)
    failed = jobs.failed(jobs.begin("cd", "meshy", 0.2), "no   credit\nleft" + "!" * 900)
    assert done.state == "finished" and failed.reason.startswith("no credit left!") and len(failed.reason) <= 500
    assert jobs.unfinished() == [] and [job.state for job in jobs.all()] == ["finished", "failed"]
    assert {jobs.begin(each, "meshy", 0.2).state for each in ("ab", "cd")} == {"begun"}


def test_only_an_unfinished_job_can_be_given_up(jobs: JobLedger) -> None:
    job = jobs.finished(jobs.begin("ab", "meshy", 0.2))
    for number in (job.id, 99):
        with pytest.raises(InputError, match="no unfinished job"):
            jobs.ask_again(number)


def ledger_with_many_jobs(library: SharedLibrary) -> JobLedger:
    for number in range(60):
        job = library.jobs.begin(f"{number:02}" * 200, "meshy", 0.2)
        if number % 3:
            job = library.jobs.submitted(job, f"task-{number}")
        if number % 3 == 2:
            library.jobs.finished(job)
    return library.jobs


@pytest.mark.parametrize("damage", ["whole", "middle"])
def test_what_was_paid_for_outlives_the_index(damage: str, tmp_path: Path) -> None:
    library = SharedLibrary.open(tmp_path / "library")
    before = ledger_with_many_jobs(library).all()
    library.close_index()
    index = library.files.root / INDEX
    data = bytearray(index.read_bytes())
    first = 0 if damage == "whole" else data.find(b"40" * 200)
    data[first : first + 4000] = b"damaged!" * 500
    index.write_bytes(data)
    with (library.files.root / JOURNAL).open("a") as journal:
        journal.write('{"id": 7, "requ')
    assert rebuilt_index(library) == (0, 60)
    assert reopened(tmp_path).all() == before
    assert library.jobs.begin("01" * 200, "meshy", 0.2).remote_id == "task-1", "nothing is asked twice"
    fresh = library.jobs.begin("new", "meshy", 0.2)
    library.close_index()
    assert fresh.id == 61 and rebuilt_index(library) == (0, 61), "also after a line that was torn"


def test_jobs_on_sound_pages_of_an_index_without_a_journal_are_kept(tmp_path: Path) -> None:
    library = SharedLibrary.open(tmp_path / "library")
    before = ledger_with_many_jobs(library).all()
    library.close_index()
    library.files.delete(JOURNAL)
    index = library.files.root / INDEX
    data = bytearray(index.read_bytes())
    page = data.find(b"30" * 200) // 4096 * 4096
    data[page : page + 4096] = b"damaged!" * 512
    index.write_bytes(data)
    opened = library.index()
    assert opened is not None
    with pytest.raises(DamagedIndex):
        opened.check()
    entries, jobs = rebuilt_index(library)
    assert (entries, 20 <= jobs < 60) == (0, True)
    assert all(job in before for job in library.jobs.all())
    assert [job.id for job in library.jobs.all()][:: jobs - 1] == [1, 60], "from both ends"
