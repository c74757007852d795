"""Every script is planned or refused in one sentence; see ``script_cases``."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fuzz.script_cases import fault_of, make


@pytest.mark.parametrize("first", range(0, 240, 40))
def test_any_script_is_planned_or_refused(first: int, tmp_path: Path) -> None:
    faults = {case: fault for case in range(first, first + 40) if (fault := fault_of(case, tmp_path))}
    assert not faults


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_ten_thousand_scripts_are_planned_or_refused(tmp_path: Path) -> None:
    faults = {case: fault for case in range(10_000) if (fault := fault_of(case, tmp_path))}
    assert not faults


def test_a_case_is_the_same_script_every_time() -> None:
    assert [make(case) for case in range(50)] == [make(case) for case in range(50)]
