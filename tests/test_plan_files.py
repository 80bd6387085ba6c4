"""What is called a plan is one of the printed domain and problem, as a validator says that is not ours."""

from pathlib import Path

import pytest
from places import ROOT

from neurosym.choices import DOMAINS
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import ground_plan, problem_text
from neurosym.pddl.plan_reading import read_plan
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.verdicts import judge_plan
from neurosym.tasks.transition import validate


def shipped(domain: str, ending: str = ".plan") -> list[Path]:
    return sorted((ROOT / "domains" / domain / "plans").glob(f"*{ending}"))


@pytest.mark.parametrize("domain", DOMAINS)
def test_shipped_plans_are_plans_of_the_printed_files_beside_them_and_steps_are_none(domain: str):
    folder, plans = DomainFolder(ROOT / "domains" / domain), shipped(domain)
    assert len(plans) > 15
    for file in plans[::3]:  # `make evaluate` judges all of them
        verdict = judge_plan(folder, file.name.split(".")[0], file)
        assert verdict.valid, (file.name, verdict.pddl_reason, verdict.replay_reason)
        assert not verdict.written_out
    steps = shipped(domain, ".steps")
    assert steps or domain != "tabletop"
    for file in steps:
        assert not judge_plan(folder, file.name.split(".")[0], file).valid


@pytest.mark.evaluation
@pytest.mark.parametrize("domain", DOMAINS)
def test_every_shipped_plan_is_valid_by_the_files_as_they_are(domain: str):
    """Nothing is left out for the validator here: it takes some seconds a plan."""
    from validators import unified_planning_accepts

    folder = DomainFolder(ROOT / "domains" / domain)
    for file in shipped(domain):
        verdict = judge_plan(folder, name := file.name.split(".")[0], file)
        task = folder / f"problems/{name}.pddl"
        assert unified_planning_accepts(folder / verdict.domain, task, file.read_text()), file.name


def test_problem_says_what_a_plan_beside_it_needs_and_nothing_else():
    """The plan ends a cell beside the region that is printed for any plan; its replay meets the goal."""
    folder = ROOT / "domains/tabletop"
    grounding = Grounding.load(folder / "grounding.json")
    problem = Problem.load(folder / "problems/task-04.scene.json")
    steps = read_plan(folder / "plans/task-04.bfs.plan", grounding, problem)
    assert validate(steps, problem, grounding).valid
    whole = ground_plan(steps, problem, grounding)
    bare, fitted = (problem_text(problem, grounding, plans=plans) for plans in ((), (whole, whole)))
    assert 1 <= len(whole.missing(bare)) < len(whole.lines)
    assert not whole.missing(fitted)
    assert set(bare.split()) <= set(fitted.split())
