"""The ledger of paid work: what was sent is never sent again unasked."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.library.shared.jobs import JobLedger, OutcomeUnknown
from storyblender.library.shared.shared_library import SharedLibrary


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
