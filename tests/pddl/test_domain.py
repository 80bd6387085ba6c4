"""The printed domain and problem: exact text, read back by others, solved, and the plans validated.

Run this file as a program to write the golden files anew.
"""

import inspect
import re
from pathlib import Path

import msgspec
import pddl as pddl_package
import pytest
from places import GOLDEN
from tables import grounding, item, problem, table
from validators import unified_planning_accepts

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.pddl import compile_domain, domain_text, problem_text
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.moves import ENCODINGS, Encoding
from neurosym.pddl.plan_reading import parse_plan
from neurosym.planners import PlanStatus
from neurosym.planners.fast_downward import plan_fast_downward

CELL = 0.02
"""Coarse, so that unified-planning reads it in a moment."""


def texts() -> dict[str, str]:
    learned = grounding(CELL)
    return {
        "domain.pddl": domain_text(learned, "stepwise"),
        "domain-operators.pddl": domain_text(learned, "operators"),
        "domain-numeric.pddl": domain_text(learned, "numeric"),
        "errand.pddl": problem_text(problem(), learned, steps=1),
        "errand.numeric.pddl": problem_text(problem(), learned, "numeric", steps=1),
    }


def written(folder: Path, encoding: Encoding) -> tuple[Path, Path]:
    found = texts()
    domain, task = folder / "domain.pddl", folder / "errand.pddl"
    domain.write_text(found["domain.pddl" if encoding == "stepwise" else f"domain-{encoding}.pddl"])
    task.write_text(found["errand.numeric.pddl" if encoding == "numeric" else "errand.pddl"])
    return domain, task


@pytest.mark.parametrize("name", sorted(texts()))
def test_text_is_exactly_the_golden_one(name: str):
    assert texts()[name] == (GOLDEN / name).read_text()


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_order_of_the_table_does_not_show_in_the_text(encoding: Encoding):
    shuffled = table()
    shuffled = msgspec.structs.replace(
        shuffled, operators=shuffled.operators[::-1], categories=shuffled.categories[::-1]
    )
    learned = grounding(CELL)
    other = compile_domain(shuffled, name="tabletop", cell=CELL, table_bounds=learned.table, lift_height=0.2)
    assert domain_text(other, encoding) == domain_text(learned, encoding)
    assert problem_text(problem(), other, encoding) == problem_text(problem(), learned, encoding)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_pddl_package_reads_the_text(tmp_path: Path, encoding: Encoding):
    domain_file, problem_file = written(tmp_path, encoding)
    domain, task = pddl_package.parse_domain(domain_file), pddl_package.parse_problem(problem_file)
    named = {str(action.name) for action in domain.actions}
    assert {operator.name for operator in grounding(CELL).live} <= named
    assert task.domain_name == domain.name == ("tabletop-numeric" if encoding == "numeric" else "tabletop")
    assert len(task.objects) == (2 if encoding == "numeric" else 2 + 31 + 31 + 11)


@pytest.mark.parametrize("encoding", ["stepwise", "operators"])
def test_plan_of_fast_downward_is_valid_and_so_is_its_text_with_cells(tmp_path: Path, encoding: Encoding):
    domain, task = written(tmp_path, encoding)
    answer = plan_fast_downward(domain, task, time_limit=30.0)
    assert answer.status is PlanStatus.SOLVED, answer.reason
    assert unified_planning_accepts(domain, task, answer.text)
    steps = parse_plan(answer.text, tmp_path / "plan", grounding(CELL), problem())
    assert "lift-010-block" in [step.operator for step in steps]
    again = print_ground_plan(steps, problem(), grounding(CELL), encoding)
    assert unified_planning_accepts(domain, task, again)
    assert not unified_planning_accepts(domain, task, again.replace("(lift-010-block", ";", 1))


def test_text_is_portable():
    for text in texts().values():
        code = "\n".join(line.split(";")[0] for line in text.splitlines())
        assert code == code.lower()
        assert not set("._") & set(code)
        assert code.count("(:action") == code.count(":precondition")
        assert not re.search(r"\s-\d", code)  # no negative numbers
        assert "(not " not in "".join(line for line in code.splitlines() if ":precondition" in line)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_text_declares_what_readers_want_declared(encoding: Encoding):
    """Each of these some reader insists on: parents before children, and costs as in the competitions."""
    domain = domain_text(grounding(CELL), encoding)
    task = problem_text(problem(), grounding(CELL), encoding)
    types = domain.split("(:types")[1].split("(:predicates")[0]
    assert types.index("- object") < types.index("- movable")
    requirements = domain.split("(:requirements")[1].split(")")[0].split()
    assert requirements[:2] == [":strips", ":typing"]
    assert ":action-costs" in requirements
    assert (":numeric-fluents" in requirements) == (encoding == "numeric")
    assert "(total-cost) - number" in domain
    assert domain.count("(:action") == len(re.findall(r"\(increase \(total-cost\) \d+\)", domain))
    assert "(= (total-cost) 0)" in task
    assert task.endswith("(:metric minimize (total-cost)))\n")


def test_a_table_without_live_operators_still_makes_a_domain():
    bare = msgspec.structs.replace(table(), operators=())
    learned = compile_domain(bare, name="bare", table_bounds=grounding().table, lift_height=0.2)
    assert "reach-goal" in domain_text(learned)
    assert "(goal-z item-02 z000)" in problem_text(problem(), learned)


def test_unknown_encoding_is_refused():
    with pytest.raises(UnknownChoice, match="valid: numeric, operators, stepwise"):
        inspect.unwrap(domain_text)(grounding(), "numbers")  # without the check of types that tests put on


@pytest.mark.parametrize("name", ["movable", "block", "x12", "lift-010-block"])
def test_object_named_like_a_part_of_the_domain_is_refused(name: str):
    task = msgspec.structs.replace(problem(), objects=(item(name, 0.5, 0.0),), goals={})
    with pytest.raises(InvalidValue, match=f"called {name}"):
        problem_text(task, grounding())


def test_object_of_an_unknown_category_is_refused():
    task = msgspec.structs.replace(problem(), objects=(item("a", 0.5, 0.0, category="01"),), goals={})
    with pytest.raises(UnknownChoice, match="valid: 00, 11"):
        problem_text(task, grounding())


if __name__ == "__main__":
    for file_name, content in texts().items():
        (GOLDEN / file_name).write_text(content)
