"""Domains as they are shipped: complete, true to their record, taken unchanged by others, run again."""

from functools import cache

import pytest
from places import ROOT

from neurosym.choices import DOMAINS
from neurosym.execution.performance import compare_runs, rerun
from neurosym.execution.record import Run
from neurosym.files import digest, read_json
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
from neurosym.pddl import domain_text
from neurosym.pddl.compiler import with_every_outcome
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import plan_fast_downward
from neurosym.problems import Problem
from neurosym.stages.compilation import texts_of
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.plan_records import PlanRecord, recorded_plans
from neurosym.tasks.task import is_reached
from neurosym.tasks.transition import validate
from neurosym.worlds.world_file import read_world

TASKS = {
    "tabletop": (1, 8, {"task"}),
    "places": (1, 8, {"anywhere", "swap", "row", "crowded"}),
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
    related = [problem for problem in problems.values() if problem.related]
    assert bool(related) == (name == "towers")
    assert not any(is_reached(problem, grounding_of(name)) for problem in related)


@pytest.mark.parametrize("name", TASKS)
def test_text_is_what_the_compiler_prints_from_the_table(name):
    folder, grounding = folder_of(name), grounding_of(name)
    assert (folder / "domain.pddl").read_text() == domain_text(grounding)
    for problem in list(problems_of(name).values())[:6]:
        for file, text in texts_of(problem, grounding, recorded_plans(folder, problem, grounding)).items():
            assert (folder / file).read_text() == text
    assert grounding.operators == with_every_outcome(OperatorTable.load(folder / "primitives.json"))


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


@pytest.mark.parametrize("name", ["places", "towers"])
def test_run_happens_again(name):
    folder, again = folder_of(name), 0
    for path in sorted((folder / "runs").glob("*.fast-downward.run.json")):
        run, problem = read_json(path, Run), problems_of(name)[path.name.split(".")[0]]
        if run.reached and again < 2:
            made = rerun(read_world(folder / "world.toml")(), problem, grounding_of(name), run)
            assert compare_runs(run, made).course != "another"
            again += 1
    assert again == 2


def test_towers_know_of_places_what_places_know():
    here, there = folder_of("towers"), folder_of("places")
    for file in ("effect_model.safetensors", "primitives.json", "places/operators.json"):
        assert digest(here / file) == digest(there / file)
    for name in ("anywhere-2-04", "swap-2-07"):
        problem = problems_of("places")[name]
        found, elsewhere = (plan(problem, grounding_of(one)) for one in ("towers", "places"))
        assert found.status is PlanStatus.SOLVED
        assert found.steps == elsewhere.steps
