"""Planning for one object after another: who is planned for again is who was in conflict."""

import pytest
from tables import DOWN, LEFT, LIFT, PUSH, grounding, item

from neurosym.planners import PlanResult, PlanStatus, pddl_search
from neurosym.planners.planner import Effort
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate


def of(name: str, *steps: PlanStep) -> tuple[PlanStep, ...]:
    return tuple(PlanStep(step.operator, name) for step in steps)


def test_plans_that_no_way_joins_are_no_plan(monkeypatch: pytest.MonkeyPatch):
    no_way = PlanResult(PlanStatus.NOT_FOUND, (), 0.0, "no ways")
    monkeypatch.setattr(pddl_search, "plan_around", lambda *_, **__: no_way)
    monkeypatch.setattr(pddl_search, "plan_counting", lambda *_, **__: no_way)
    goals = {"item-1": (0.5, 0.0832, 0.025), "item-10": (0.8, -0.0168, 0.025)}
    task = Problem("p", (item("item-1", 0.5, 0.0), item("item-10", 0.8, -0.1)), goals)
    asked: list[str] = []

    def believed(one: Problem, effort: Effort) -> PlanResult:
        del effort
        (name,) = one.goals
        asked.append(name)
        steps = of(name, *[LEFT] * 5) if name == "item-10" else of(name, LEFT)  # off the table, and right
        return PlanResult(PlanStatus.SOLVED, steps, 0.0)

    result = pddl_search._plan_one_by_one(task, grounding(), believed, Effort())
    assert result.status is PlanStatus.FAILED
    assert "no order of the steps was found that brings item-10 past the others" in result.reason
    assert sorted(asked) == ["item-1", "item-10"]


TWO = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.0832))


@pytest.mark.parametrize(
    ("steps", "concerned"),
    [
        (of("item-02", LEFT), ()),
        (of("item-01", LEFT), ("item-01", "item-02")),  # where the other is
        ((*of("item-02", LIFT), *of("item-01", PUSH)), ("item-01", "item-02")),  # which is still held
        (of("item-01", *[LEFT] * 6), ("item-01", "item-02")),
        (of("item-02", *[LEFT] * 6), ("item-02",)),  # off the table
        (of("item-02", DOWN), ("item-02",)),
        ((), ("item-02",)),  # far from its goal
    ],
)
def test_replay_names_whom_its_reason_concerns(steps: tuple[PlanStep, ...], concerned: tuple[str, ...]):
    task = Problem("p", TWO, {"item-02": (0.5, 0.1664, 0.025)})
    assert validate(steps, task, grounding()).concerned == concerned
