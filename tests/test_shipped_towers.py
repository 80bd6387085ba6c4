"""`domains/towers` as it is shipped: complete, true to its record, and its runs can be run again."""

import pytest
from places import ROOT

from neurosym.execution.record import Run
from neurosym.execution.rerun import compare_runs, rerun
from neurosym.files import digest, read_json
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import plan_fast_downward
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.tasks.supports import is_reached
from neurosym.worlds.world_file import read_world

FOLDER = DomainFolder(ROOT / "domains" / "towers")
GROUNDING = Grounding.load(FOLDER / "grounding.json")
PROBLEMS = {name: load_scene(FOLDER / f"problems/{name}.scene.json") for name in FOLDER.problem_names()}
OF_RELATIONS = tuple(name for name, problem in PROBLEMS.items() if problem.related)
RUNS = {path.name.split(".")[0]: path for path in sorted((FOLDER / "runs").glob("*.run.json"))}
REACHED = tuple(name for name, path in RUNS.items() if read_json(path, Run).reached)


def test_files_are_those_that_the_record_tells_of():
    for record in FOLDER.manifest().stages.values():
        for name, recorded in {**record.inputs, **record.outputs}.items():
            assert digest(FOLDER / name) == recorded, name


def test_what_was_learned_of_single_objects_is_that_of_the_domain_with_places():
    there = DomainFolder(ROOT / "domains" / "places")
    for name in ("effect_model.safetensors", "primitives.json", "places/operators.json"):
        assert digest(FOLDER / name) == digest(there / name)


@pytest.mark.parametrize("name", ["anywhere-2-04", "swap-2-07", "row-4-11"])
def test_goals_on_the_table_are_planned_for_as_in_the_domain_with_places(name):
    there = DomainFolder(ROOT / "domains" / "places")
    problem = load_scene(there / f"problems/{name}.scene.json")
    here, elsewhere = (
        plan(problem, known) for known in (GROUNDING, Grounding.load(there / "grounding.json"))
    )
    assert here.status is PlanStatus.SOLVED
    assert here.steps == elsewhere.steps


def test_problems_are_of_two_to_eight_objects():
    sizes = [len(problem.objects) for problem in PROBLEMS.values()]
    assert len(PROBLEMS) == 20
    assert {min(sizes), max(sizes)} == {2, 8}
    assert {name.split("-")[0] for name in PROBLEMS} == {"tower", "boxes", "unstack", "exchange", "anywhere"}


def test_text_is_what_the_compiler_prints_from_the_table():
    assert (FOLDER / "domain.pddl").read_text() == domain_text(GROUNDING)
    for name in OF_RELATIONS[:3]:
        printed = problem_text(PROBLEMS[name], GROUNDING)
        assert (FOLDER / f"problems/{name}.pddl").read_text() == printed, name


def test_nothing_asked_for_is_so_at_the_start():
    assert not any(is_reached(PROBLEMS[name], GROUNDING) for name in OF_RELATIONS)


def test_fast_downward_takes_the_files_unchanged():
    task = FOLDER / f"problems/{OF_RELATIONS[0]}.pddl"
    answer = plan_fast_downward(FOLDER / "domain.pddl", task, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED


@pytest.mark.parametrize("name", REACHED[:2])
def test_run_happens_again(name):
    again = rerun(
        read_world(FOLDER / "world.toml")(), PROBLEMS[name], GROUNDING, run := read_json(RUNS[name], Run)
    )
    assert compare_runs(run, again).course != "another"
