"""Tasks of relations: what is planned for them, and that it comes true."""

from pathlib import Path

import msgspec
import pytest
import toy_places
from toy_relations import (
    LIE,
    PUT_IN,
    PUT_ON,
    REST,
    grounding,
    relearned,
    scene,
    sorting,
    tower,
    tower_at_place,
)

from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, plan
from neurosym.planners.planner import Planner, PlanResult
from neurosym.problems import Problem
from neurosym.tasks.options import left_out, puts_for, puts_of
from neurosym.tasks.supports import bearers_of, with_pairs
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, validate


def solved(problem: Problem, learned: Grounding | None = None, **options) -> tuple[PlanStep, ...]:
    result = plan(problem, learned or grounding(), **options)
    assert result.status is PlanStatus.SOLVED, result.reason
    return result.steps


def words(steps: tuple[PlanStep, ...]) -> list[str]:
    return [f"{step.operator} {step.object} {step.place}" for step in steps]


def test_tower_is_built_from_below():
    assert words(solved(tower())) == [f"{PUT_ON} item-03 item-02", f"{PUT_ON} item-01 item-03"]


def test_tower_at_a_place_is_built_there_after_the_place_was_cleared():
    steps = solved(tower_at_place())
    assert [step.object for step in steps] == ["item-04", "item-02", "item-03", "item-01"]
    ends = validate(steps, tower_at_place(), grounding()).positions[-1]
    assert ends[2] == pytest.approx([*ends[1][:2], 0.075])
    assert ends[0] == pytest.approx([*ends[1][:2], 0.125])


def test_stack_is_taken_down_from_above():
    assert words(solved(sorting())) == [f"{PUT_IN} item-01 item-04", f"{PUT_IN} item-02 item-05"]


def test_what_fails_with_a_third_object_on_the_target_is_done_without():
    steps = solved(tower_at_place(), relearned(PUT_ON, laden=0))
    assert steps == solved(tower_at_place())


def test_what_fails_from_another_object_goes_by_way_of_a_place():
    steps = solved(sorting(), relearned(PUT_IN, borne=0))
    assert len(steps) == 4
    assert {step.operator for step in steps[::2]} == {"carry-to-01-cube"}


def test_of_operators_that_do_the_same_a_few_are_in_the_domain_and_each_pair_gets_the_surest():
    learned = grounding()
    assert learned.relations is not None
    one = learned.relations.operators[0]
    worse = [
        msgspec.structs.replace(
            one, name=f"worse-{count}", ends=(msgspec.structs.replace(one.ends[0], count=count),)
        )
        for count in (15, 16, 17, 18)
    ]
    both = msgspec.structs.replace(learned.relations, operators=(*worse, *learned.relations.operators))
    changed = msgspec.structs.replace(learned, relations=both)
    assert {put.name for put in puts_of(changed)} - {put.name for put in puts_of(learned)} == {
        "worse-16",
        "worse-17",
        "worse-18",
    }
    assert left_out(changed.relations)["worse-15"] == f"does less surely what {PUT_ON} does"
    problem = with_pairs(tower(), changed.relations)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == [PUT_ON]
    foreseen = {"item-01 item-03": {PUT_ON: 0.5, "worse-16": 0.9}}
    problem = msgspec.structs.replace(problem, foreseen=foreseen)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == ["worse-16"]
    assert {one.put.name for one in understand(problem, changed).put_options["item-01", "item-03"]} == {
        "worse-16"
    }


def test_what_rests_on_a_carried_object_goes_along_in_the_replay():
    step = PlanStep("carry-to-01-block", "item-03", "park-01")
    before, after = validate([step], sorting(), grounding()).positions
    assert (after - before)[0] == pytest.approx((after - before)[2])
    assert (after - before)[3:] == pytest.approx(0)


def answering(steps: tuple[PlanStep, ...]):
    def solve(query):
        return PlanResult(PlanStatus.SOLVED, steps, 0.0)

    return solve


def test_planner_of_ones_own_is_asked_for_relations_as_it_is():
    steps = solved(tower())
    for given, status in ((steps, PlanStatus.SOLVED), (steps[:1], PlanStatus.FAILED)):
        own = Planner("own", "mine", answering(given))
        assert plan(tower(), grounding(), own).status is status


def test_goals_met_at_the_start_need_no_step():
    problem = msgspec.structs.replace(sorting(), relations=(("item-01", "item-02", REST),))
    assert solved(problem) == ()
    indirect = msgspec.structs.replace(sorting(), relations=(("item-01", "item-03", REST),))
    assert len(solved(indirect)) > 1


def test_what_bears_what_is_seen_in_a_box_with_a_stack():
    objects = scene(
        ("tray", 0.7, 0.0), ("cube", 0.7, 0.03, 0.01), ("cube", 0.7, 0.03, 0.06), ("block", 0.5, 0.2)
    )
    problem = with_pairs(Problem("box", objects, {}), grounding().relations)
    found = bearers_of(problem, grounding().relations)
    assert {name: (one.by, one.state.name) for name, one in found.items()} == {
        "item-02": ("item-01", LIE),
        "item-03": ("item-02", REST),
    }


@pytest.mark.parametrize(("target", "reference"), [("item-01", "item-02"), ("item-02", "item-01")])
def test_of_two_that_look_as_if_each_bore_the_other_the_one_bears_that_goals_ask_for(target, reference):
    learned = grounding().relations
    _, lying, miss = learned.operators
    around = msgspec.structs.replace(miss, ends=lying.ends)  # trays are put around cubes, too
    known = msgspec.structs.replace(learned, operators=(*learned.operators[:2], around))
    objects = scene(("tray", 0.7, 0.0), ("cube", 0.7, 0.0, 0.005))
    problem = with_pairs(Problem("mutual", objects, {}, relations=((target, reference, LIE),)), known)
    assert {name: one.by for name, one in bearers_of(problem, known).items()} == {target: reference}


def test_kinds_of_pairs_are_kept_in_the_file_of_a_problem_and_old_files_have_none(tmp_path: Path):
    problem = with_pairs(tower(), grounding().relations)
    assert problem.pairs["item-01 item-02"] == "01"
    problem.save(tmp_path / "new.json")
    assert Problem.load(tmp_path / "new.json") == problem
    toy_places.swap().save(tmp_path / "old.json")
    assert (
        not {"relations", "pairs", "touching"}
        & msgspec.json.decode((tmp_path / "old.json").read_text()).keys()
    )


def test_groundings_with_relations_are_stored_and_have_a_format_of_their_own(tmp_path: Path):
    grounding().save(tmp_path / "grounding.json")
    assert Grounding.load(tmp_path / "grounding.json") == grounding()
    assert grounding().format == "neurosym-grounding-4"
    assert toy_places.grounding().format == "neurosym-grounding-3"
