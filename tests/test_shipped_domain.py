"""`domains/tabletop` as it is shipped: complete, true to its record, taken unchanged by other programs."""

import warnings

import pytest
from shipped import FOLDER, GROUNDING

import neurosym
from neurosym.files import digest, read_json
from neurosym.operators import OperatorTable
from neurosym.pddl import domain_text
from neurosym.pddl.compiler import with_every_outcome
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import plan_fast_downward
from neurosym.stages.compilation import texts_of
from neurosym.stages.folder import load_scene
from neurosym.stages.plan_records import PlanRecord, recorded_plans
from neurosym.tasks.transition import validate

NAMES = FOLDER.problem_names()


def shipped_plan(name: str) -> PlanRecord:
    return read_json(FOLDER / f"plans/{name}.fast-downward.json", PlanRecord)


SOLVED = [name for name in NAMES if shipped_plan(name).solved]


def test_there_are_twenty_problems_of_rising_size():
    sizes = [len(load_scene(FOLDER / f"problems/{name}.scene.json").objects) for name in NAMES]
    assert len(sizes) == 20
    assert sizes == sorted(sizes)
    assert (sizes[0], sizes[-1]) == (1, 8)
    assert list(NAMES) == [f"task-{number:02d}" for number in range(1, len(sizes) + 1)]


def test_files_are_those_that_the_record_tells_of():
    stages = FOLDER.manifest().stages
    assert stages["explore"].options == {
        "strategy": "disagreement",
        "steps": 10_000,
        "seed": 1,
        "regime": "default",
    }
    for record in stages.values():
        for name, recorded in {**record.inputs, **record.outputs}.items():
            assert digest(FOLDER / name) == recorded, name


def test_text_is_what_the_compiler_prints_from_the_table():
    assert (FOLDER / "domain.pddl").read_text() == domain_text(GROUNDING)
    assert (FOLDER / "domain-numeric.pddl").read_text() == domain_text(GROUNDING, "numeric")
    for name in NAMES:
        problem = load_scene(FOLDER / f"problems/{name}.scene.json")
        printed = texts_of(problem, GROUNDING, recorded_plans(FOLDER, problem, GROUNDING))
        assert len(printed) == 2
        for file, text in printed.items():
            assert (FOLDER / file).read_text() == text


def test_grounding_holds_the_table_that_was_rehearsed():
    table = OperatorTable.load(FOLDER / "primitives.json")
    assert GROUNDING.operators == with_every_outcome(table)


@pytest.mark.parametrize("name", [*NAMES[:3], *NAMES[6:9]])
def test_fast_downward_takes_the_files_unchanged_and_agrees_with_the_record(name):
    answer = plan_fast_downward(FOLDER / "domain.pddl", FOLDER / f"problems/{name}.pddl", time_limit=60.0)
    unsolvable = shipped_plan(name).status == PlanStatus.UNSOLVABLE.value
    assert answer.status is (PlanStatus.UNSOLVABLE if unsolvable else PlanStatus.SOLVED)


@pytest.mark.parametrize("name", NAMES[:1])
def test_unified_planning_takes_the_files_unchanged(name):
    from unified_planning.io import PDDLReader

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning's own
        task = PDDLReader().parse_problem(str(FOLDER / "domain.pddl"), str(FOLDER / f"problems/{name}.pddl"))
    assert {action.name for action in task.actions} >= {"push", "lift", "put-down", "move-x", "move-y"}


@pytest.mark.parametrize("name", [*SOLVED[:2], *SOLVED[-2:]])
def test_plan_found_now_is_true_when_replayed(name):
    problem = load_scene(FOLDER / f"problems/{name}.scene.json")
    result = plan(problem, GROUNDING)
    assert result.status is PlanStatus.SOLVED
    assert validate(result.steps, problem, GROUNDING).valid


def test_every_verb_of_the_package_can_be_had():
    for name in neurosym.__all__:
        assert getattr(neurosym, name)
    with pytest.raises(AttributeError, match="no attribute 'fly'"):
        neurosym.fly  # noqa: B018
