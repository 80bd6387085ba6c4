"""`domains/places` as it is shipped: complete, true to its record, and its runs can be run again."""

import pytest
from places import ROOT

from neurosym.execution.record import Run
from neurosym.execution.rerun import compare_runs, rerun
from neurosym.files import digest, read_json
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.worlds.world_file import read_world

FOLDER = DomainFolder(ROOT / "domains" / "places")
GROUNDING = Grounding.load(FOLDER / "grounding.json")
PROBLEMS = {name: load_scene(FOLDER / f"problems/{name}.scene.json") for name in FOLDER.problem_names()}
NAMES = tuple(PROBLEMS)
SWAP = "swap-2-07"


def test_files_are_those_that_the_record_tells_of():
    stages = FOLDER.manifest().stages
    assert stages["explore"].options["steps"] + stages["explore-places"].options["steps"] == 10_000
    for record in stages.values():
        for name, recorded in {**record.inputs, **record.outputs}.items():
            assert digest(FOLDER / name) == recorded, name


def test_problems_are_all_that_people_bring_with_one_to_eight_objects():
    sizes = [len(problem.objects) for problem in PROBLEMS.values()]
    assert len(NAMES) == 20
    assert {min(sizes), max(sizes)} == {1, 8}
    assert {name.split("-")[0] for name in NAMES} == {"anywhere", "swap", "row", "crowded"}


def test_text_is_what_the_compiler_prints_from_the_table():
    assert (FOLDER / "domain.pddl").read_text() == domain_text(GROUNDING)
    for name in NAMES[:4]:
        printed = problem_text(PROBLEMS[name], GROUNDING)
        assert (FOLDER / f"problems/{name}.pddl").read_text() == printed, name


def test_most_plans_carry():
    plans = [path.read_text() for path in (FOLDER / "plans").glob("*.plan")]
    assert sum("(put-at " in plan for plan in plans) >= 18


def test_fast_downward_takes_the_files_unchanged():
    task = FOLDER / f"problems/{SWAP}.pddl"
    answer = plan_fast_downward(FOLDER / "domain.pddl", task, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED
    assert answer.text.count("put-at") >= 3, "one waits while the other is carried"


@pytest.mark.parametrize("name", [NAMES[0], SWAP])
def test_run_happens_again(name):
    run = read_json(FOLDER / f"runs/{name}.fast-downward.run.json", Run)
    again = rerun(read_world(FOLDER / "world.toml")(), PROBLEMS[name], GROUNDING, run)
    assert run.reached
    assert compare_runs(run, again).course != "another"
