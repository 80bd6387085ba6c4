"""Domains whose operators promise each object something of its own: who reads them, and what holds."""

import re
from pathlib import Path

import msgspec
import pddl as pddl_package
import pytest
import rehearsed
import tables
from validators import unified_planning_accepts

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.moves import ENCODINGS, Encoding
from neurosym.pddl.numeric import UNIT
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import operator_for, validate
from neurosym.planners import PlanStatus, plan
from neurosym.planners.fast_downward import plan_fast_downward
from neurosym.problems import Problem
from neurosym.tasks.moves import moves_for

CELL = 0.02
LIFT = "lift-010-block"
AWAY, LEFT = "push-away-001-block", "push-left-000-block"


def coarse() -> tuple[Grounding, Problem]:
    """Return what unified-planning reads in a moment."""
    return rehearsed.grounding(CELL), msgspec.structs.replace(rehearsed.problem(), tolerance=0.05)


def written(folder: Path, encoding: Encoding) -> tuple[Path, Path]:
    learned, task = coarse()
    domain, file = folder / "domain.pddl", folder / "problem.pddl"
    domain.write_text(domain_text(learned, encoding))
    file.write_text(problem_text(task, learned, encoding))
    return domain, file


def cost_of(steps: tuple[PlanStep, ...], task: Problem, learned: Grounding) -> int:
    moves = {item.name: moves_for(item, learned, task.tolerance) for item in task.objects}
    costs = {(move.name, name): move.cost for name, listed in moves.items() for move in listed}
    return sum(costs[step.operator, step.object] for step in steps)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_pddl_package_reads_the_text_if_told_that_costs_are_functions(tmp_path: Path, encoding: Encoding):
    """It wants :numeric-fluents for that, which Fast Downward refuses; competitions asked for neither."""
    domain_file, problem_file = written(tmp_path, encoding)
    text = domain_file.read_text()
    if encoding != "numeric":
        text = text.replace(":action-costs)", ":action-costs :numeric-fluents)")
    domain_file.write_text(text)
    domain, task = pddl_package.parse_domain(domain_file), pddl_package.parse_problem(problem_file)
    assert {operator.name for operator in coarse()[0].live} <= {str(action.name) for action in domain.actions}
    assert task.domain_name == domain.name == ("tabletop-numeric" if encoding == "numeric" else "tabletop")


@pytest.mark.parametrize("encoding", ["stepwise", "operators"])
def test_plan_of_fast_downward_is_valid_and_so_is_its_text_with_cells(tmp_path: Path, encoding: Encoding):
    (domain, file), (learned, task) = written(tmp_path, encoding), coarse()
    answer = plan_fast_downward(domain, file, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED, answer.reason
    assert unified_planning_accepts(domain, file, answer.text)
    steps = parse_plan(answer.text, tmp_path / "plan", learned, task)
    again = print_ground_plan(steps, task, learned, encoding)
    assert unified_planning_accepts(domain, file, again)
    assert not unified_planning_accepts(domain, file, again.replace(f"({LIFT}", ";", 1))


def test_both_domains_on_a_grid_declare_the_same():
    learned, _ = coarse()
    stepwise, operators = (domain_text(learned, name) for name in ("stepwise", "operators"))
    for section in (":types", ":constants", ":functions"):
        parts = [text.split(f"({section}")[1].split("\n\n")[0] for text in (stepwise, operators)]
        assert parts[0] == parts[1]
    shared = r"\((?:can|[xyz]-of|[xyz]-leads) [^)]*- [^)]*\)"
    assert set(re.findall(shared, operators)) == set(re.findall(shared, stepwise)) != set()


@pytest.mark.parametrize("whole", [False, True])
def test_printed_steps_lead_to_plans_of_the_same_cost_as_in_sas(whole: bool):
    learned, task = rehearsed.grounding(), rehearsed.problem()
    found = {name: plan(task, learned, "lmcut", encoding=name, whole=whole) for name in ("sas", "stepwise")}
    for result in found.values():
        assert result.status is PlanStatus.SOLVED, result.reason
        assert validate(result.steps, task, learned).valid
    ours, theirs = (cost_of(result.steps, task, learned) for result in found.values())
    assert ours == theirs


def test_objects_of_one_category_get_steps_by_their_size():
    learned = rehearsed.grounding()
    for size, times, cells in ((0.037, 3, 12), (0.055, 2, 18)):  # of 5 mm; on average it is 83.2 mm
        one = rehearsed.item("item-01", 0.4, -0.1, size)
        goal = (0.4, -0.1 + times * 0.0832 * size / rehearsed.MEAN, 0.025)
        task = Problem("p", (one,), {"item-01": goal}, tolerance=0.012)
        assert f"(y-of a-{LEFT} item-01 y-plus-{cells})" in problem_text(task, learned)
        result = plan(task, learned, encoding="stepwise")
        assert result.steps == (PlanStep(LEFT, "item-01"),) * times, result.reason


def test_operator_that_does_nothing_to_an_object_is_not_for_it():
    learned = rehearsed.grounding(CELL)
    widest = rehearsed.item("item-01", 0.4512, 0.0, rehearsed.WIDE)
    task = Problem("p", (widest,), {"item-01": (0.55, 0.0, 0.025)})
    text, numbers = (problem_text(task, learned, encoding) for encoding in ("stepwise", "numeric"))
    assert f"{AWAY}: moves less than half a cell." in text
    assert f"-of a-{AWAY} item-01 x" not in text
    assert f"(can a-{AWAY} item-01)" not in text
    assert f"(can-{AWAY} item-01)" not in numbers
    assert f"(can-{LIFT} item-01)" in numbers
    with pytest.raises(InvalidValue, match=f"{AWAY} is not in the domain for item-01"):
        print_ground_plan([PlanStep(AWAY, "item-01")], task, learned)


def test_object_unlike_all_that_were_rehearsed_is_promised_what_its_category_is():
    learned = rehearsed.grounding(CELL)
    task = Problem("p", (rehearsed.item("item-01", 0.45, 0.0, 0.3),), {"item-01": (0.55, 0.0, 0.025)})
    text = problem_text(task, learned)
    assert "item-01 is unlike all that were rehearsed" in text
    for move in moves_for(task.objects[0], tables.grounding(CELL), task.tolerance):
        assert f"(x-of a-{move.name} item-01 x-plus-{move.cells[0]})" in text
    assert plan(task, learned, encoding="stepwise").status is PlanStatus.SOLVED


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_no_parenthesis_is_lost_in_a_comment(encoding: Encoding):
    """Where the last object has operators that are not for it, or none at all and a goal in the air."""
    learned = rehearsed.grounding()
    widest = rehearsed.item("item-01", 0.4512, 0.0, rehearsed.WIDE)
    few = tuple(one for one in learned.operators.operators if one.category == "00")
    bare = msgspec.structs.replace(
        learned, operators=msgspec.structs.replace(learned.operators, operators=few)
    )
    tray = rehearsed.item("item-02", 0.7, 0.0, 0.05, category="11")
    for one, grounding in ((widest, learned), (tray, bare)):
        text = problem_text(Problem("p", (one,), {one.name: (0.5, 0.0, 0.3)}), grounding, encoding)
        code = re.sub(r";.*", "", text)
        assert code.count("(") == code.count(")")


def test_numbers_say_what_is_promised_to_an_object():
    learned, task = rehearsed.grounding(), rehearsed.problem()
    text = problem_text(task, learned, "numeric")
    assert not re.search(r"[\s(]-\d", re.sub(r";.*", "", text))
    for item in task.objects:
        for move in moves_for(item, learned, task.tolerance):
            found = re.search(rf"\(= \(x-of-{move.name} {item.name}\) (\d+)\)", text)
            step = PlanStep(move.name, item.name)
            operator = operator_for(step, task, learned)
            by = learned.put_down_displacement if step.puts_down else learned.displacement
            assert found
            assert (int(found[1]) - 10_000) * UNIT == pytest.approx(by(operator)[0], abs=UNIT)


def test_plan_is_valid_in_numbers_and_half_of_it_is_not(tmp_path: Path):
    (domain, file), (learned, task) = written(tmp_path, "numeric"), coarse()
    steps = plan(task, learned, "counting").steps
    text = print_ground_plan(steps, task, learned, "numeric")
    assert unified_planning_accepts(domain, file, text)
    assert not unified_planning_accepts(domain, file, "\n".join(text.splitlines()[1:]))


def test_problem_never_lists_cells_for_an_operator():
    learned = rehearsed.grounding()
    task = rehearsed.problem()
    text = problem_text(task, learned)
    facts = re.findall(r"\([xyz]-of [^)]*\)", text)
    assert len(facts) == sum(
        len(move.all_axes) for item in task.objects for move in moves_for(item, learned, task.tolerance)
    )
    steps = r"[xyz]-(?:plus|minus)-\d+"
    declared = set(re.findall(steps, text.split("(:init")[0]))
    needed = set(re.findall(rf"-of \S+ \S+ ({steps})\)", text))
    constants = domain_text(learned).split("(:constants")[1].split("(:predicates")[0]
    assert declared == needed - set(re.findall(steps, constants))


@pytest.mark.parametrize(
    "name", ["x-plus-3", "z-minus-40", "y-step", "move-x", f"a-{LIFT}", f"put-down-{LIFT}"]
)
def test_object_named_like_a_step_is_refused(name: str):
    item = msgspec.structs.replace(rehearsed.item("a", 0.5, 0.0, 0.05), name=name)
    with pytest.raises(InvalidValue, match=f"called {name}"):
        problem_text(Problem("p", (item,), {}), rehearsed.grounding())


def test_turns_are_told_above_an_action():
    text = domain_text(rehearsed.grounding(), "operators")
    assert "It turned the object by over 15 degrees in 4 of 20 rehearsals." in text
    assert "degrees" not in domain_text(tables.grounding(), "operators")
