"""Domains as they are shipped: complete, true to their record, taken by others, copied, with valid plans."""

import errno
import shutil
from functools import cache
from pathlib import Path

import pytest
from places import ROOT

from neurosym.choices import DOMAINS, copy_shipped, shipped_domain
from neurosym.errors import CannotWrite
from neurosym.files import digest, read_json
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
from neurosym.pddl import domain_text
from neurosym.pddl.compiler import ground_plan, problem_text, with_every_outcome
from neurosym.pddl.plan_reading import read_plan
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import plan_fast_downward
from neurosym.problems import Problem
from neurosym.stages.compilation import texts_of
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.plan_records import PlanRecord, recorded_plans
from neurosym.stages.verdicts import judge_plan
from neurosym.tasks.task import is_reached
from neurosym.tasks.transition import validate

TASKS = {
    "tabletop": (1, 8, {"task"}),
    "places": (1, 8, {"anywhere", "swap", "row", "crowded"}),
    "camera": (1, 8, {"anywhere", "swap", "row", "crowded"}),
    "towers": (2, 8, {"tower", "boxes", "unstack", "exchange", "anywhere"}),
}
"""The least and the most objects of the problems of a domain, and their kinds."""


def folder_of(name: str) -> DomainFolder:
    return DomainFolder(ROOT / "domains" / name)


@cache
def grounding_of(name: str) -> Grounding:
    return Grounding.load(folder_of(name) / "grounding.json")


@cache
def problems_of(name: str) -> dict[str, Problem]:
    folder = folder_of(name)
    return {one: load_scene(folder / f"problems/{one}.scene.json") for one in folder.problem_names()}


@pytest.mark.parametrize("name", DOMAINS)
def test_files_are_those_that_the_record_tells_of(name):
    folder = folder_of(name)
    for record in folder.manifest().stages.values():
        for file, recorded in {**record.inputs, **record.outputs}.items():
            assert digest(folder / file) == recorded, file


@pytest.mark.parametrize("name", TASKS)
def test_there_are_twenty_problems_of_its_kinds(name):
    problems, (least, most, kinds) = problems_of(name), TASKS[name]
    sizes = [len(problem.objects) for problem in problems.values()]
    assert (len(problems), min(sizes), max(sizes)) == (20, least, most)
    assert {one.split("-")[0] for one in problems} == kinds
    related = [problem for problem in problems.values() if problem.relations]
    assert bool(related) == (name == "towers")
    assert not any(is_reached(problem, grounding_of(name)) for problem in related)


@pytest.mark.parametrize("name", TASKS)
def test_text_is_what_the_compiler_prints_from_the_table(name):
    folder, grounding = folder_of(name), grounding_of(name)
    assert (folder / "domain.pddl").read_text() == domain_text(grounding)
    for problem in list(problems_of(name).values())[:6]:
        for file, text in texts_of(problem, grounding, recorded_plans(folder, problem, grounding)).items():
            assert (folder / file).read_text() == text
    assert grounding.objects == with_every_outcome(OperatorTable.load(folder / "primitives.json"))


@pytest.mark.parametrize(
    ("name", "task"),
    [
        *(("tabletop", "task-01"), ("tabletop", "task-08"), ("tabletop-paper", "task-05")),
        *(("places", "swap-2-07"), ("towers", "tower-2-01")),
    ],
)
def test_fast_downward_takes_the_files_unchanged_and_agrees_with_the_record(name, task):
    folder, grounding, problem = folder_of(name), grounding_of(name), problems_of(name)[task]
    answer = plan_fast_downward(folder / "domain.pddl", folder / f"problems/{task}.pddl", time_limit=60.0)
    record = read_json(folder / f"plans/{task}.fast-downward.json", PlanRecord)
    is_solved = record.status is PlanStatus.SOLVED
    assert answer.status is (PlanStatus.SOLVED if is_solved else PlanStatus.UNSOLVABLE)
    assert task != "swap-2-07" or answer.text.count("put-at") >= 3, "one waits while the other is carried"
    if is_solved:
        result = plan(problem, grounding)
        assert result.status is PlanStatus.SOLVED
        assert validate(result.steps, problem, grounding).valid


# They are copied whole or not at all


@pytest.mark.parametrize("name", DOMAINS)
def test_copy_has_what_a_user_needs_and_nothing_that_is_made_again(name, tmp_path):
    assert copy_shipped(name, tmp_path / "mine")
    copied, shipped = (folder / "grounding.json" for folder in (tmp_path / "mine", shipped_domain(name)))
    assert copied.read_bytes() == shipped.read_bytes()
    assert not {"plans", "runs", "pictures"} & {path.name for path in (tmp_path / "mine").iterdir()}


def test_other_names_are_no_shipped_domains_and_a_folder_that_is_there_stays_as_it_is(tmp_path):
    assert not copy_shipped("kitchen", tmp_path / "mine")
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "mine").mkdir()
    assert copy_shipped("tabletop", tmp_path / "mine")
    assert list((tmp_path / "mine").iterdir()) == []


def test_disk_that_is_full_half_way_leaves_nothing(tmp_path, monkeypatch):
    copied, real = [], shutil.copyfile

    def copyfile(source, target, **options):
        copied.append(target)
        if len(copied) == 3:
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(source, target, **options)

    monkeypatch.setattr(shutil, "copyfile", copyfile)
    with pytest.raises(CannotWrite, match="mine cannot be written: No space left on device"):
        copy_shipped("tabletop", tmp_path / "mine")
    assert list(tmp_path.iterdir()) == []


# What is called a plan is one of the printed domain and problem, as a validator says that is not ours


def shipped(domain: str, ending: str = ".plan") -> list[Path]:
    return sorted((folder_of(domain) / "plans").glob(f"*{ending}"))


@pytest.mark.parametrize("domain", DOMAINS)
def test_shipped_plans_are_plans_of_the_printed_files_beside_them_and_steps_are_none(domain: str):
    folder, plans = folder_of(domain), shipped(domain)
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

    folder = folder_of(domain)
    for file in shipped(domain):
        verdict = judge_plan(folder, name := file.name.split(".")[0], file)
        task = folder / f"problems/{name}.pddl"
        assert unified_planning_accepts(folder / verdict.domain, task, file.read_text()), file.name


def test_problem_says_what_a_plan_beside_it_needs_and_nothing_else():
    """The plan ends a cell beside the region that is printed for any plan; its replay meets the goal."""
    grounding, problem = grounding_of("tabletop"), problems_of("tabletop")["task-03"]
    steps = read_plan(folder_of("tabletop") / "plans/task-03.bfs.plan", grounding, problem)
    assert validate(steps, problem, grounding).valid
    whole = ground_plan(steps, problem, grounding)
    bare, fitted = (problem_text(problem, grounding, plans=plans) for plans in ((), (whole, whole)))
    assert 1 <= len(whole.missing(bare)) < len(whole.lines)
    assert not whole.missing(fitted)
    assert set(bare.split()) <= set(fitted.split())
