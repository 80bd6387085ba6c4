"""Fast Downward, directly and through unified-planning: plans, proofs, time-outs, and nothing left behind."""

import subprocess
import sys
import tempfile
import time
from functools import partial
from pathlib import Path

import pytest
from processes import alive
from tables import grounding, problem

from neurosym.pddl import domain_text, problem_text
from neurosym.planners import PlanStatus, external
from neurosym.planners.external import Search, plan_fast_downward, plan_program
from neurosym.planners.planner import PlannerAnswer
from neurosym.planners.process import Finished, run_limited
from neurosym.planners.unified_planning import engine_program

plan_unified_planning = partial(plan_program, program=engine_program("fast-downward"))
PLANNERS = [plan_fast_downward, plan_unified_planning]


@pytest.fixture
def scratch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder that stands in for the system's folder of temporary files."""
    folder = tmp_path / "scratch"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def write(folder: Path, *, cell: float = 0.03, solvable: bool = True, domain: str = "") -> tuple[Path, Path]:
    task = problem_text(problem(), grounding(cell))
    (folder / "domain.pddl").write_text(domain or domain_text(grounding(cell)))
    unreachable = task.replace("(goal-on-table item-02)", "")
    assert unreachable != task
    (folder / "problem.pddl").write_text(task if solvable else unreachable)
    return folder / "domain.pddl", folder / "problem.pddl"


@pytest.mark.parametrize("planner", PLANNERS)
def test_plan_is_found_and_nothing_is_left_behind(tmp_path: Path, scratch: Path, planner):
    here = set(Path.cwd().iterdir())
    answer: PlannerAnswer = planner(*write(tmp_path), time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED, answer.reason
    assert "(lift item-01 m-010 " in answer.text
    assert list(scratch.iterdir()) == []
    assert set(Path.cwd().iterdir()) == here


@pytest.mark.parametrize("planner", PLANNERS)
def test_unsolvable_is_a_result(tmp_path: Path, scratch: Path, planner):
    answer: PlannerAnswer = planner(*write(tmp_path, solvable=False), time_limit=60.0)
    assert (answer.status, answer.text) == (PlanStatus.UNSOLVABLE, "")
    assert list(scratch.iterdir()) == []


@pytest.mark.parametrize("planner", PLANNERS)
def test_broken_domain_fails_with_the_last_words(tmp_path: Path, scratch: Path, planner):
    answer: PlannerAnswer = planner(*write(tmp_path, domain="(define (domain tabletop)"), time_limit=60.0)
    assert answer.status is PlanStatus.FAILED
    assert len(answer.reason) > 40
    assert list(scratch.iterdir()) == []


def test_unknown_search_fails_with_the_last_words(tmp_path: Path):
    files = write(tmp_path)
    answer = plan_fast_downward(*files, time_limit=20.0, searches=[Search("no-such-search()")])
    assert answer.status is PlanStatus.FAILED
    assert "code 33" in answer.reason


@pytest.mark.parametrize(("planner", "limit"), [(plan_fast_downward, 0.15), (plan_unified_planning, 0.4)])
def test_time_out_is_a_result_that_comes_in_time(tmp_path: Path, scratch: Path, planner, limit: float):
    begin = time.perf_counter()
    answer: PlannerAnswer = planner(*write(tmp_path, cell=0.005), time_limit=limit)
    assert answer.status is PlanStatus.TIMEOUT
    assert time.perf_counter() - begin < limit + 1.0
    assert alive(str(tmp_path)) == []
    assert list(scratch.iterdir()) == []


def test_time_out_kills_children_in_whatever_session(tmp_path: Path):
    sleeper = f"import time; time.sleep(60)  # {tmp_path}"
    parent = (
        "import subprocess, sys, time\n"
        f"subprocess.Popen([sys.executable, '-c', {sleeper!r}], start_new_session=True)\n"
        "print('started', flush=True)\ntime.sleep(60)"
    )
    finished = run_limited([sys.executable, "-c", parent], tmp_path, 1.5)
    assert finished.code is None
    assert finished.last_words == "started"
    time.sleep(0.1)
    assert alive(str(tmp_path)) == []


def test_children_are_seen_while_they_live(tmp_path: Path):
    """The counter-test: what the test above looks for would be found."""
    command = [sys.executable, "-c", f"import time; time.sleep(60)  # {tmp_path}"]
    with subprocess.Popen(command) as process:
        seen = []
        for _ in range(100):
            seen = seen or alive(str(tmp_path))
            time.sleep(0.01)
        process.kill()
    assert len(seen) == 1


def test_fast_downward_is_found_without_unified_planning():
    code = (
        "import sys, neurosym.planners.external as f; f._programs();"
        "sys.exit(any(name in sys.modules for name in ('unified_planning', 'torch', 'pybullet')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_search_that_is_not_complete_proves_nothing(tmp_path: Path, scratch: Path):
    """Exit code 12: the search ended without a plan, and there may be one."""
    files = write(tmp_path, solvable=False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(external, "run_limited", lambda *_, **__: Finished(12, "no solution!"))
        answer = plan_fast_downward(*files, time_limit=1.0)
    assert (answer.status, answer.text) == (PlanStatus.NOT_FOUND, "")
