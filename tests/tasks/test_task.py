"""A task is understood once: places, pairs and promises are worked out one time for all that is done."""

import pytest
from places import ROOT

from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.tasks import promises, supports, task
from neurosym.tasks.transition import expected_success, validate


@pytest.mark.parametrize(("domain", "name"), [("places", "row-4-12"), ("towers", "tower-6-05")])
def test_a_task_is_understood_once(domain: str, name: str, monkeypatch: pytest.MonkeyPatch):
    folder, called = ROOT / "domains" / domain, list[str]()
    problem = Problem.load(folder / "problems" / f"{name}.scene.json")
    grounding = Grounding.load(folder / "grounding.json")
    for module, function in ((task, "goal_spots"), (supports, "describe_pair"), (supports, "nearest_kinds")):
        real = getattr(module, function)
        monkeypatch.setattr(
            module, function, lambda *given, of=function, do=real: called.append(of) or do(*given)
        )
    promises._promised.cache_clear()
    promises._refined.cache_clear()
    found = plan(problem, grounding)
    assert problem_text(problem, grounding, plans=[ground_plan(found.steps, problem, grounding)])
    assert validate(found.steps, problem, grounding).valid
    assert 0 < expected_success(found.steps, problem, grounding) <= 1
    objects, refined = len(problem.objects), promises._refined.cache_info()
    assert called.count("goal_spots") == 1
    assert called.count("describe_pair") in (0, objects * (objects - 1))
    assert called.count("nearest_kinds") <= 1
    every = sum(one.category == item.category for item in problem.objects for one in grounding.every_operator)
    assert 0 < refined.hits + refined.misses <= every
