"""Plans made at the same time: all of them in order, or an end to the rest once one cannot be had."""

import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from neurosym.errors import CannotStart
from neurosym.planners.pddl_search import _plan_together as plan_together
from neurosym.planners.planner import PlanResult, PlanStatus
from neurosym.planners.process import run_limited


def test_results_come_in_the_order_of_the_tasks():
    def waits(seconds: float) -> PlanResult:
        time.sleep(seconds)
        return PlanResult(PlanStatus.SOLVED, (), seconds)

    found = plan_together([lambda s=s: waits(s) for s in (0.2, 0.0, 0.1)])
    assert [one.seconds for one in found] == [0.2, 0.0, 0.1]


def test_first_without_a_plan_ends_what_still_runs(tmp_path: Path):
    ended: list[int | None] = []

    def sleeps() -> PlanResult:
        command = [sys.executable, "-c", "import time; time.sleep(60)"]
        ended.append(run_limited(command, tmp_path, 60.0).code)
        return PlanResult(PlanStatus.FAILED, (), 0.0)

    def gives_up() -> PlanResult:
        time.sleep(0.5)
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, "no way")

    begin = time.perf_counter()
    found = plan_together([gives_up, sleeps, sleeps])
    assert [one.reason for one in found] == ["no way"]
    assert time.perf_counter() - begin < 20
    assert set(ended) == {-9}


def test_where_nothing_can_be_started_a_sentence_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def refused(*_: object, **__: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    with monkeypatch.context() as patch:
        patch.setattr(subprocess, "Popen", refused)
        with pytest.raises(CannotStart, match="No planner can be started: Resource temporarily"):
            run_limited(["true"], tmp_path, 1.0)

    def no_thread(*_: object) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threading.Thread, "start", no_thread)
    with pytest.raises(CannotStart, match="can't start new thread; allow more"):
        plan_together([lambda: PlanResult(PlanStatus.SOLVED, (), 0.0)])
