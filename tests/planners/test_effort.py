"""Plans do not depend on the clock: budgets count work, and a limit of time is a time-out, nothing else."""

import dataclasses
import itertools
import time
from functools import partial
from unittest.mock import ANY

import pytest
import tables
import toy_domain

from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.pddl.sas import sas_text
from neurosym.planners import PLANNERS, PlanResult, PlanStatus, plan
from neurosym.planners.action_counts import plan_counting
from neurosym.planners.external import PORTFOLIO, Search, plan_fast_downward
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep

SEARCHES = ["bfs-operators", "counting", "fast-downward"]


@pytest.fixture
def leaping_clock(monkeypatch):
    """A clock that goes on by an hour each time that it is looked at."""
    hours = itertools.count()
    monkeypatch.setattr(time, "perf_counter", lambda: 3600.0 * next(hours))


def answers(planner: str) -> list[object]:
    """What a planner says of some tasks: solved, several objects, in each other's way, out of reach."""
    spot = (0.57, 0.06, 0.025)
    blocks = (tables.item("item-01", 0.4, 0.0), tables.item("item-02", 0.4, 0.12))
    tasks = (
        tables.problem(),
        tables.crossing(),
        Problem("p", blocks, {"item-01": spot, "item-02": spot}),
        Problem("p", blocks[:1], {"item-01": (0.35, 0.0, 0.025)}),
    )
    results = [plan(task, tables.grounding(), planner) for task in tasks]
    results.append(plan_counting(tasks[3], tables.grounding(), goes_near=True))
    return [(result.status, result.steps, result.reason) for result in results]


@pytest.mark.parametrize("planner", SEARCHES)
def test_a_clock_that_leaps_changes_no_plan(planner: str, request):
    expected = answers(planner)
    request.getfixturevalue("leaping_clock")
    assert answers(planner) == expected
    assert any(found[0] is PlanStatus.SOLVED for found in expected)
    assert PLANNERS[planner].ceiling == float("inf")


def test_a_clock_that_leaps_changes_no_run(request):
    task, learned = toy_domain.problem({"item-01": (0.6, 0.16, 0.025)}), toy_domain.grounding()
    steps = [PlanStep("push-left-001-cube", "item-01")]
    run = partial(execute, toy_domain.WORLD, task, learned, steps)

    def replanner(now: Problem, believed: Grounding) -> PlanResult:
        return plan(now, believed, "fast-downward")

    expected = run(replanner=replanner)
    request.getfixturevalue("leaping_clock")
    assert run(replanner=replanner) == expected
    assert expected.replannings


@pytest.mark.parametrize("planner", [*SEARCHES, "lama-first"])
def test_a_ceiling_that_cuts_in_is_a_time_out_that_says_so(planner: str, request):
    request.getfixturevalue("leaping_clock")
    found = plan(tables.problem(), tables.grounding(), planner, time_limit=5.0)
    assert (found.status, found.steps) == (PlanStatus.TIMEOUT, ())
    assert found.reason == "the time limit of 5 s cut in"


def test_work_is_counted_and_its_end_is_a_result_that_says_so():
    found = plan_counting(tables.problem(), tables.grounding(), work=1)
    assert found.status is PlanStatus.NOT_FOUND
    assert "none within 1 candidates, joins and orders looked at" in found.reason
    asked = partial(plan, tables.problem(), tables.grounding(), "fast-downward")
    whole, few = asked(), asked(work=0)
    assert (few.status, few.steps) == (PlanStatus.NOT_FOUND, ())
    assert few.reason == "the budget of 0 states for a plan was used up"
    assert asked(work=2 * whole.work) == dataclasses.replace(whole, seconds=ANY)


def test_a_search_that_wants_more_memory_makes_way_for_the_next(tmp_path):
    file = tmp_path / "task.sas"
    file.write_text(sas_text(tables.problem(), tables.grounding(0.002), steps=1, margin=0))
    tight = Search(PORTFOLIO[0].configuration, memory=11 * 2**20)
    alone = plan_fast_downward(file, file, time_limit=60.0, searches=(tight,))
    assert alone.status is PlanStatus.NOT_FOUND
    assert alone.reason.startswith("Fast Downward ran out of memory; ask for fewer goals")
    both = plan_fast_downward(file, file, time_limit=60.0, searches=(tight, PORTFOLIO[1]))
    assert both.status is PlanStatus.SOLVED
    assert alone.work is not None
    assert both.work is not None
    assert both.work > alone.work
