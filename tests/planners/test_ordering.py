"""The order of steps: whoever is in the way goes first; and counting, the cheapest among the fewest."""

import itertools

import tables
from tables import grounding, item

from neurosym.planners import PlanStatus, plan
from neurosym.planners.action_counts import mend
from neurosym.problems import Problem
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, primitives, validate
from tools.benchmarks.planning.tasks import fewest_steps


def test_long_row_is_moved_from_its_front():
    """Eight blocks in a row, named from behind: only one of the 40320 orders is possible."""
    row = tuple(item(f"item-{n}", 0.35 + 0.06 * n, 0.0) for n in range(8))
    goals = {thing.name: (thing.position[0] + 0.0713, -0.0124, 0.025) for thing in row}
    steps = [PlanStep("push-away-001-block", thing.name) for thing in row]
    ordered, checked = mend(steps, Problem("row", row, goals), grounding())
    assert checked.valid, checked.reason
    assert list(ordered) == steps[::-1]


def test_among_the_fewest_it_takes_the_cheapest():
    learned = tables.grounding()
    task = Problem("p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (0.6, 0.13, 0.025)})
    found = plan(task, learned, "counting")
    names = [operator.name for operator in learned.live if operator.category == "00"]

    def price(steps: tuple[str, ...]) -> int:
        return sum(cost(learned.operator_named(step)) for step in steps)

    def down(steps: tuple[str, ...]) -> tuple[PlanStep, ...]:
        pairs = ([step, f"put-down-{step}"] if step.startswith("lift") else [step] for step in steps)
        return tuple(PlanStep(one, "item-01") for pair in pairs for one in pair)

    every = itertools.combinations_with_replacement(names, primitives(found.steps))
    cheapest = min(price(steps) for steps in every if validate(down(steps), task, learned).valid)
    assert price(tuple(step.operator for step in found.steps if not step.puts_down)) == cheapest
    assert fewest_steps(task, learned) == primitives(found.steps)


def test_objects_with_one_goal_end_beside_each_other():
    learned = tables.grounding()
    items = (tables.item("item-01", 0.4, 0.0), tables.item("item-02", 0.4, 0.12))
    spot = (0.57, 0.06, 0.025)
    task = Problem("p", items, {"item-01": spot, "item-02": spot})
    found = plan(task, learned, "counting")
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, learned).valid
    assert primitives(found.steps) >= fewest_steps(task, learned)
