"""What we write in SAS+ ourselves, beside what Fast Downward's own translator makes of the page."""

from pathlib import Path

import msgspec
import pytest
from independent.ground_pddl import judge
from tables import grounding, item, problem, total_cost

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text
from neurosym.pddl.plan_reading import read_answer
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips_plan import write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import PORTFOLIO, Search, plan_fast_downward
from neurosym.problems import Problem
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep

SHIPPED = Path("domains/tabletop")


@pytest.mark.parametrize("search", ["astar(blind())", "astar(lmcut())"])
@pytest.mark.parametrize("name", ["task-01", "task-02", "task-03", "task-04", "task-05", "task-06"])
def test_cheapest_plan_is_one_of_the_page_and_as_cheap_as_after_translation(
    name: str, search: str, tmp_path: Path
):
    """On the same cells: the page of a folder has coarser ones."""
    learned = Grounding.load(SHIPPED / "grounding.json")
    task = understand(Problem.load(SHIPPED / "problems" / f"{name}.scene.json"), learned)
    page = StripsProblem(task, led=task.names, grid=learned)
    texts = {
        "task.sas": sas_text(task.problem, learned),
        "domain.pddl": domain_text(learned),
        "problem.pddl": page.data().text(),
    }
    for file, text in texts.items():
        (tmp_path / file).write_text(text)

    def solve(*files: str) -> tuple[PlanStep, ...]:
        domain, problem = (tmp_path / file for file in files)
        answer = plan_fast_downward(domain, problem, time_limit=60.0, searches=(Search(search),))
        assert answer.status is PlanStatus.SOLVED, answer.reason
        return read_answer(answer.text, problem, task, lambda _: page)

    def price(steps: tuple[PlanStep, ...]) -> int:
        costs = {move.name: move.cost for move in task.moves_on(learned, task.names[0])}
        return sum(costs[step.operator] for step in steps)

    ours, theirs = solve("task.sas", "task.sas"), solve("domain.pddl", "problem.pddl")
    assert price(ours) == price(theirs) > 0
    every = StripsProblem(task, led=task.names, grid=learned, every=True)
    lines = [f"({' '.join(words)})" for words in write(ours, every).actions]
    assert judge(texts["domain.pddl"], every.data().text(), "\n".join(lines)) == ""


@pytest.mark.parametrize("search", PORTFOLIO, ids=lambda one: one.configuration[:12])
def test_every_search_of_the_portfolio_takes_it(search: Search, tmp_path: Path):
    file = tmp_path / "task.sas"
    file.write_text(sas_text(problem(), grounding()))
    answer = plan_fast_downward(file, file, time_limit=60.0, searches=(search,))
    assert answer.status is PlanStatus.SOLVED, answer.reason


def test_objects_solved_at_once_cost_as_much_as_after_translation():
    ours, theirs = (plan(problem(), grounding(), encoding=name, whole=True) for name in ("sas", "strips"))
    assert ours.status is theirs.status is PlanStatus.SOLVED, (ours.reason, theirs.reason)
    assert total_cost(ours.steps) == total_cost(theirs.steps)


def test_goal_in_a_corner_has_no_plan_in_either():
    nowhere = Problem("p", (item("item-01", 0.45, 0.01),), {"item-01": (0.45, 0.01, 0.4)})
    found = {name: plan(nowhere, grounding(), encoding=name).status for name in ("sas", "strips")}
    assert set(found.values()) == {PlanStatus.UNSOLVABLE}


def test_a_step_moves_one_coordinate_and_the_lock_keeps_others_out():
    learned = Grounding.load(SHIPPED / "grounding.json")
    task = Problem.load(SHIPPED / "problems" / "task-01.scene.json")
    names = [block.splitlines()[1] for block in sas_text(task, learned).split("begin_operator")[1:]]
    assert len(names) == len(set(names))
    assert all(len(name.split()) == 4 for name in names if not name.startswith("reach-goal"))


def test_object_without_a_goal_is_left_out():
    task = problem()
    fewer = msgspec.structs.replace(task, goals={"item-01": task.goals["item-01"]})
    assert "item-02" in sas_text(task, grounding())
    assert "item-02" not in sas_text(fewer, grounding())


def test_name_that_the_domain_uses_is_refused():
    task = Problem("p", (item("motion", 0.45, 0.01),), {"motion": (0.5, 0.01, 0.025)})
    with pytest.raises(InvalidValue, match="No object can be called motion"):
        sas_text(task, grounding())
