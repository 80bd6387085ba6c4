"""Plan text: steps printed in short and as ground actions."""

from pathlib import Path

import pytest
from tables import grounding, problem

from neurosym.errors import InvalidValue
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.plan_reading import parse_plan, read_plan
from neurosym.tasks.transition import PlanStep, print_plan

PULL, PUSH = PlanStep("pull-010-tray", "item-02"), PlanStep("push-away-001-block", "item-01")
LIFT, DOWN = PlanStep("lift-010-block", "item-01"), PlanStep("put-down-lift-010-block", "item-01")


def read(text: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), grounding(), problem())


def test_printed_plan_is_read_back(tmp_path: Path):
    path = tmp_path / "errand.plan"
    path.write_text(print_plan([PULL, LIFT, DOWN, PUSH]))
    assert path.read_text().endswith("(push-away-001-block item-01)\n; 3 primitives\n")
    assert read_plan(path, grounding(), problem()) == (PULL, LIFT, DOWN, PUSH)


def test_operator_left_out_of_the_domain_may_be_in_a_plan_but_has_no_cells():
    stay = PlanStep("stay-111-block", "item-01")
    assert read("(stay-111-block item-01)") == (stay,)
    with pytest.raises(InvalidValue, match="stay-111-block is not in the domain"):
        ground_plan([stay], problem(), grounding())
