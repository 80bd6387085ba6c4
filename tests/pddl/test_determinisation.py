"""Outcomes: each that is seen often enough is an operator of its own, and planners may hope for any."""

import re
from pathlib import Path

import pytest
from msgspec.structs import replace
from tables import BOUNDS, grounding, item, mode, table

from neurosym.operators import Operator
from neurosym.pddl import compile_domain, problem_text
from neurosym.pddl.compiler import ground_plan, with_every_outcome
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.syntax import ENCODINGS
from neurosym.planners import PlanStatus, plan
from neurosym.planners.bfs import branching_of
from neurosym.problems import Problem
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep

HELD = mode((0.012, -0.021, 0.203), kind="held", count=14, near=14, resting=(0.014, -0.023, 0.0))
SLIPPED = mode((0.06, 0.0, 0.0), count=6, near=5)


def of(*modes) -> list[Operator]:
    operator = Operator("lift-010-block", "00", "010", 20, tuple(modes))
    changed = tuple(operator if op.name == operator.name else op for op in table().operators)
    expanded = with_every_outcome(replace(table(), operators=changed))
    return [op for op in expanded.operators if (op.category, op.primitive) == ("00", "010")]


def shares(*modes):
    return tuple(replace(each, share=each.count / 20) for each in modes)


def test_each_outcome_at_rest_or_held_is_an_operator_that_is_named_for_it():
    likeliest, other = of(*shares(HELD, SLIPPED))
    assert (likeliest.name, likeliest.promised) == ("lift-010-block", None)
    assert (other.name, other.promised) == ("push-forward-010-block", "resting")
    assert other.promise is not None
    assert (other.promise.outcome, other.successes, other.trials) == ((0.06, 0.0, 0.0), 5, 20)
    assert cost(other) > 3 * cost(likeliest)


@pytest.mark.parametrize(
    "unwanted",
    [mode((0.06, 0.0, 0.0), count=1, near=1), mode((0.06, 0.0, 0.0), kind="toppled", count=6)],
    ids=["too rare", "toppled"],
)
def test_what_is_too_rare_or_neither_upright_nor_held_is_no_operator(unwanted):
    assert len(of(*shares(HELD, unwanted))) == 1


def test_compiled_domain_has_every_outcome_as_an_action_and_as_a_choice():
    changed = tuple(
        replace(op, modes=shares(HELD, SLIPPED)) if op.name == "lift-010-block" else op
        for op in table().operators
    )
    learned = compile_domain(
        replace(table(), operators=changed), name="tabletop", table_bounds=BOUNDS, lift_height=0.2
    )
    problem = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.56, 0.0, 0.025)}, tolerance=0.01)
    text = problem_text(problem, learned)
    assert "(lifts item-01 m-010 dx2 dy-4 " in text
    assert "(pushes item-01 m-010 dx12 dy0 " in text
    steps = [PlanStep("push-forward-010-block", "item-01"), PlanStep("lift-010-block", "item-01")]
    for encoding in ENCODINGS:
        written = ground_plan(steps, problem, learned, encoding).text
        assert parse_plan(written, Path("p"), learned, problem) == tuple(steps)
    numbers = problem_text(problem, learned, "numeric")
    assert len(set(re.findall(r"\(along-x (\S+)\)", numbers))) == numbers.count("(along-x ")
    assert "push-forward-010-block" in branching_of(problem, learned).names[0]
    found = plan(problem, learned)
    assert found.status is PlanStatus.SOLVED
    assert [step.operator for step in found.steps] == ["push-forward-010-block"]
    assert plan(problem, grounding(), "bfs-operators").status is not PlanStatus.SOLVED
