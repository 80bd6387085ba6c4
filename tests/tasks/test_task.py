"""A task is understood once: places, pairs and promises are worked out one time for all that is done."""

import sys
from collections import Counter
from collections.abc import Callable
from types import ModuleType

import pytest
from places import ROOT

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.planners.registry import plan
from neurosym.problems import Problem
from neurosym.tasks import promises, supports, task
from neurosym.tasks.task import understand
from neurosym.tasks.transition import expected_success, validate

DOMAINS = ROOT / "domains"
COUNTED = ((task, "goal_spots"), (supports, "describe_pair"), (supports, "nearest_kinds"))


def loaded(domain: str, name: str) -> tuple[Problem, Grounding]:
    """Read a shipped problem and its domain, anew."""
    folder = DOMAINS / domain
    problem = Problem.load(folder / "problems" / f"{name}.scene.json")
    return problem, Grounding.load(folder / "grounding.json")


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """Count how often places are drawn, pairs described and promises worked out."""
    found: Counter[str] = Counter()
    promises._promised.cache_clear()

    def count(module: ModuleType, name: str) -> None:
        real: Callable[..., object] = getattr(module, name)

        def counting(*given: object, **named: object) -> object:
            found[name] += 1
            return real(*given, **named)

        for other in list(sys.modules.values()):
            if getattr(other, "__name__", "").startswith("neurosym") and getattr(other, name, None) is real:
                monkeypatch.setattr(other, name, counting)

    for module, name in (*COUNTED, (promises, "_refined")):
        count(module, name)
    return found


@pytest.mark.parametrize(("domain", "name"), [("places", "row-4-12"), ("towers", "tower-6-05")])
def test_a_task_is_understood_once(domain: str, name: str, counted: Counter[str]):
    problem, grounding = loaded(domain, name)
    found = plan(problem, grounding)
    text = problem_text(problem, grounding, plans=[ground_plan(found.steps, problem, grounding)])
    assert text
    assert validate(found.steps, problem, grounding).valid
    assert 0 < expected_success(found.steps, problem, grounding) <= 1
    objects = len(problem.objects)
    assert counted["goal_spots"] == 1
    assert counted["describe_pair"] in (0, objects * (objects - 1))
    assert counted["nearest_kinds"] <= 1
    every = sum(one.category == item.category for item in problem.objects for one in grounding.every_operator)
    assert 0 < counted["_refined"] <= every


def test_what_cannot_be_is_refused():
    problem, _ = loaded("towers", "tower-2-01")
    _, grounding = loaded("places", "row-4-12")
    with pytest.raises(InvalidValue, match="learned none"):
        understand(problem, grounding)
