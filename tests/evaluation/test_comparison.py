"""Comparing planners on the toy world: what is counted, what is kept, and why planners disagree."""

import json
from pathlib import Path

import msgspec
import numpy as np
import pytest
from command_line import neurosym
from toy_domain import WORLD, grounding, problem
from toy_learning import an_outcome

from neurosym.evaluation.comparison import Bench, Setting, compare
from neurosym.evaluation.drawn_tasks import Order, compare_tasks
from neurosym.evaluation.summary import summarise, why_not_found
from neurosym.execution.performance import failure
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.operators import CARRIED, Primitive
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from tools.benchmarks.paper_tables import KINDS, kind_of, kinds_found

BOTH = ("bfs", "fast-downward")
TRUE_EFFECTS = np.array([(0.0, 0.0, 0.2), (0.0, 0.08, 0.0), (0.08, 0.0, 0.0)])  # lift, left, forward
AHEAD = problem({"item-01": (0.68, 0.0, 0.025)})


def setting(effects: np.ndarray = TRUE_EFFECTS) -> Setting:
    """The toy domain with a network that predicts the same for all objects."""
    return Setting(WORLD, grounding(), lambda features: np.repeat(effects[None], len(features), axis=0))


def without_seconds(value: object) -> object:
    """Leave out what a clock decides."""
    if isinstance(value, dict):
        return {key: without_seconds(entry) for key, entry in value.items() if key != "seconds"}
    return value


def records(folder: Path, name: str = "task-*.json") -> dict[str, object]:
    return {path.name: without_seconds(json.loads(path.read_bytes())) for path in folder.rglob(name)}


def run_with(*steps: StepRecord, stuck: bool) -> Run:
    plan = tuple((step.operator, step.object) for step in steps)
    answers = (Replanning(2, "it would miss", (), "no plan" if stuck else ""),)
    return Run("errand", plan, steps, False, {"item-01": 0.1}, "it missed", replannings=answers)


def step(happened: str, **changes: object) -> StepRecord:
    place, nothing = {"item-01": (0.6, 0.0, 0.025)}, (0.0, 0.0, 0.0)
    record = StepRecord("lift", "item-01", "held", nothing, "held", nothing, 0.0, happened == "held", place)
    return msgspec.structs.replace(record, happened=happened, **changes)


def test_planners_with_true_models_agree_and_their_plans_come_true():
    record = compare(setting(), AHEAD, BOTH)
    for attempt in record.attempts.values():
        assert (attempt.found, attempt.valid, attempt.primitives) == (True, True, 1)
        assert attempt.promised_miss == pytest.approx(0.0, abs=1e-6)
        assert attempt.predicted_miss == pytest.approx(0.0, abs=1e-6)
        assert attempt.open_loop.reached
        assert attempt.open_loop.kept == attempt.open_loop.interactions == 1
    assert why_not_found(record, "bfs", BOTH) == ""


def test_network_that_errs_makes_bfs_miss_and_the_record_says_so():
    swapped = TRUE_EFFECTS[[0, 2, 1]]  # the network takes the two pushes for each other
    record = compare(setting(swapped), AHEAD, BOTH)
    bfs, pddl = record.attempts["bfs"], record.attempts["fast-downward"]
    assert bfs.found
    assert not bfs.valid
    assert bfs.invalid == "elsewhere"
    assert bfs.predicted_miss == pytest.approx(0.0, abs=1e-6)
    assert bfs.promised_miss == pytest.approx(np.hypot(0.08, 0.08), abs=1e-3)
    assert not bfs.open_loop.reached
    assert pddl.valid
    assert pddl.predicted_miss > 0.05
    tally = summarise([record], BOTH).planners
    assert tally["bfs"].invalid == {"by the operators, it ends elsewhere": 1}
    assert (tally["bfs"].predicted, tally["fast-downward"].predicted) == (1, 0)


def test_network_that_sees_no_way_is_told_apart_from_a_plan_that_is_too_long():
    record = compare(setting(np.zeros((3, 3))), AHEAD, BOTH, executed=False)
    assert why_not_found(record, "bfs", BOTH) == "the network predicts the other plan to end elsewhere"
    far = problem({"item-01": (0.92, 0.16, 0.025)})
    record = compare(setting(), far, BOTH, executed=False)
    assert record.attempts["fast-downward"].primitives > 3
    assert why_not_found(record, "bfs", BOTH) == "it takes more than 3 primitives"


def test_tasks_met_at_the_start_are_counted_and_left_out():
    near = problem({"item-01": (0.61, 0.0, 0.025)})
    done, open_task = compare(setting(), near, BOTH), compare(setting(), AHEAD, BOTH, executed=False)
    assert done.met_at_start
    assert done.attempts == {}
    comparison = summarise([done, open_task], BOTH)
    assert (comparison.tasks, comparison.met_at_start, comparison.counted) == (2, 1, 1)
    assert comparison.planners["bfs"].found == 1


def test_goal_that_nobody_can_reach_and_a_category_never_rehearsed_are_results():
    record = compare(setting(), problem({"item-01": (0.5, 0.0, 0.025)}), BOTH)
    comparison = summarise([record], BOTH)
    assert comparison.solved_by_none == 1
    assert comparison.planners["bfs"].unfound == {}
    strange = tuple(msgspec.structs.replace(item, category="11") for item in AHEAD.objects)
    record = compare(setting(), msgspec.structs.replace(AHEAD, objects=strange), BOTH)
    assert not any(attempt.found for attempt in record.attempts.values())


@pytest.mark.parametrize(
    ("steps", "stuck", "kind"),
    [
        ([step("lost")], False, "an object fell off the table"),
        ([step("held", disturbed={"item-02": "lost"})], False, "an object fell off the table"),
        ([step("not performed")], False, "out of the arm's reach"),
        ([step("toppled")], True, "an object toppled"),
        ([step("resting")], True, "no plan from where things ended"),
        ([step("held", disturbed={"item-02": "moved"})], False, "another object was moved"),
        ([step("resting")], False, "a grasp failed"),
        ([step("resting", promised="resting")], False, "an object went elsewhere"),
        ([step("held")], False, "small errors added up"),
        ([], False, "small errors added up"),
    ],
)
def test_failure_is_named_by_the_worst_that_happened(steps, stuck, kind):
    assert failure(run_with(*steps, stuck=stuck)) == kind


def test_command_writes_records_and_counts_and_does_nothing_twice(folder, capsys):
    asked = ("compare", folder, "--tasks", 3, "--workers", 1, "--planners", "bfs")
    assert neurosym(*asked) == 0
    said = capsys.readouterr().out
    assert "3 tasks drawn with seeds 0 to 2, 1 object, 50 mm" in said
    assert "reached, followed blindly" in said
    place = folder / "comparison/1-objects-50-mm"
    counted = json.loads((place / "comparison.json").read_text())
    assert counted["tasks"] == 3
    before = {path: path.stat().st_mtime_ns for path in place.glob("task-*.json")}
    assert len(before) == 3
    assert neurosym(*asked) == 0
    assert {path: path.stat().st_mtime_ns for path in place.glob("task-*.json")} == before


def test_another_planner_is_added_to_what_is_there_and_another_domain_begins_anew(folder):
    order = Order(folder, 1, ("bfs",), 0.05)
    [first] = compare_tasks(order, [5])
    [both] = compare_tasks(msgspec.structs.replace(order, planners=("bfs", "bfs-operators")), [5])
    assert both.attempts["bfs"] == first.attempts["bfs"]  # seconds, too
    assert list(both.attempts) == ["bfs", "bfs-operators"]
    text = (folder / "grounding.json").read_text()
    (folder / "grounding.json").write_text(text + "\n")
    [anew] = compare_tasks(order, [5])
    assert list(anew.attempts) == ["bfs"]


def test_number_of_workers_does_not_change_the_records(folder, tmp_path):
    order = Order(folder, 2, ("bfs",), 0.05)
    list(compare_tasks(order, range(4), workers=1))
    alone = records(order.place)
    for path in order.place.glob("*.json"):
        path.unlink()
    list(compare_tasks(order, range(4), workers=2))
    assert records(order.place) == alone
    assert len(alone) == 4
    [path] = order.place.glob("task-*3.json")
    path.write_text(path.read_text()[:40])  # a damaged record is measured again
    list(compare_tasks(order, range(4), workers=1))
    assert records(order.place) == alone


def test_task_is_that_of_new_problem_and_the_same_scene_and_goal_at_any_tolerance(folder):
    bench = Bench(DomainFolder(folder))
    wide, narrow = bench.draw(2, 3, 0.05), bench.draw(2, 3, 0.02)
    assert narrow == msgspec.structs.replace(wide, tolerance=0.02)
    assert neurosym("new-problem", folder, "--name", "mine", "--seed", 3, "--objects", 2) == 0
    mine = Problem.load(folder / "problems/mine.scene.json")
    assert (mine.objects, mine.goals) == (wide.objects, wide.goals)


LIFT_HEIGHT = 0.2


OF_KIND = {
    "right push": an_outcome((0.0, -0.05, 0.0)),
    "left push": an_outcome((0.02, 0.05, 0.0)),
    "forward push": an_outcome((0.05, -0.02, 0.0)),
    "pull": an_outcome((-0.031, 0.0, 0.0)),
    "grasp": an_outcome((0.0, 0.0, 0.19), (0.0, 0.0, 0.0), held=True, peak_height=0.19),
    "pick and place": an_outcome((0.03, -0.03, 0.0), peak_height=0.05),
}
OF_NO_KIND = {
    "nothing": an_outcome(),
    "too short": an_outcome((0.029, 0.0, 0.0)),
    "askew": an_outcome((0.05, 0.026, 0.0)),
    "toppled": an_outcome((0.05, 0.0, 0.0), toppled=True),
    "lost": an_outcome((0.5, 0.0, -0.5), lost=True),
    "lost from the hand": an_outcome((0.0, 0.0, 0.2), (0.5, 0, -0.5), lost=True, held=True),
    "hardly lifted": an_outcome((0.0, 0.0, 0.09), (0.0, 0.0, 0.0), held=True, peak_height=0.09),
    "carried nowhere": an_outcome((0.0, 0.02, 0.0), peak_height=0.05),
}


def test_each_kind_is_recognised_and_a_push_that_rises_only_above_what_counts_as_carried():
    assert {kind: kind_of(OF_KIND[kind], LIFT_HEIGHT) for kind in KINDS} == {kind: kind for kind in KINDS}
    assert {what for what in OF_NO_KIND if kind_of(OF_NO_KIND[what], LIFT_HEIGHT)} == set()
    assert kind_of(an_outcome((0.05, 0, 0), peak_height=CARRIED), LIFT_HEIGHT) == "forward push"
    assert kind_of(an_outcome((0.05, 0, 0), peak_height=CARRIED + 1e-6), LIFT_HEIGHT) == "pick and place"
    dropped = an_outcome((0.0, 0.0, 0.02), (0.05, 0.0, 0.0))
    assert kind_of(dropped, LIFT_HEIGHT) == "forward push"  # it is judged at rest


def rehearsals(symbols, *columns):
    """Primitives 000, 001, ... that turned out so on objects of these symbols."""
    primitives = tuple(Primitive(f"{n:03b}", (0.0,) * 12, 0.0) for n in range(len(columns)))
    return Rehearsals(primitives, np.zeros((len(symbols), 4)), np.array(symbols), tuple(map(tuple, columns)))


@pytest.mark.parametrize("kind", KINDS)
def test_kind_counts_as_found_where_enough_rehearsals_were_of_it(kind):
    it, other = OF_KIND[kind], OF_NO_KIND["nothing"]
    symbols = ["00"] * 10 + ["11"] * 10
    some = [it] * 6 + [other] * 4 + [it] * 5 + [other] * 5
    found = kinds_found(rehearsals(symbols, [other] * 20, some), LIFT_HEIGHT)
    assert set(found) == set(KINDS)
    assert found[kind] == (("001", "00"),)
    assert all(not pairs for name, pairs in found.items() if name != kind)


def test_kind_that_only_a_rare_object_symbol_shows_is_not_found():
    grasp, other = OF_KIND["grasp"], OF_NO_KIND["nothing"]
    for rare, is_found in ((9, False), (10, True)):
        symbols = ["1"] * rare + ["0"] * (100 - rare)
        found = kinds_found(rehearsals(symbols, [grasp] * rare + [other] * (100 - rare)), LIFT_HEIGHT)
        assert bool(found["grasp"]) == is_found
