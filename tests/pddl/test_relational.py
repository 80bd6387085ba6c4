"""Domains of relations: what they say, who reads them, and that plans for them are true."""

from pathlib import Path

import msgspec
import pytest
import toy_places
from places import GOLDEN
from toy_relations import (
    LIE,
    PUT_IN,
    PUT_ON,
    REST,
    grounding,
    relations,
    scene,
    sorting,
    tower,
    tower_at_place,
)
from validators import unified_planning_accepts

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.moves import BY_RELATIONS, LIFTED, RELATIONAL
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.plan_text import PlanStep, print_plan
from neurosym.pddl.relational_problem import needed_texts
from neurosym.pddl.validation import validate
from neurosym.planners import PlanStatus, plan
from neurosym.planners.planner import Planner
from neurosym.planners.result import PlanResult
from neurosym.problems import Problem
from neurosym.related import bearers_of
from neurosym.tasks.pair_goals import puts_for
from neurosym.tasks.puts import left_out_puts, puts_of

PROBLEMS = (tower(), tower_at_place(), sorting())


def texts() -> dict[str, str]:
    """The domain in both ways, and a problem, as they are printed."""
    learned = grounding()
    found = {f"domain-{encoding}.pddl": domain_text(learned, encoding) for encoding in BY_RELATIONS}
    return found | {"sorting.relational.pddl": problem_text(sorting(), learned, RELATIONAL)}


@pytest.mark.parametrize("name", [*(f"domain-{one}.pddl" for one in BY_RELATIONS), "sorting.relational.pddl"])
def test_text_is_the_golden_one_to_the_letter(name):
    """Run this file as a program to write the golden files anew."""
    assert texts()[name] == (GOLDEN / name).read_text()


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


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda problem: problem.name)
@pytest.mark.parametrize("encoding", BY_RELATIONS)
def test_printed_plans_are_read_back_and_accepted_by_others(problem, encoding, tmp_path: Path):
    learned = grounding()
    steps = solved(problem, encoding=encoding)
    assert parse_plan(print_plan(steps), tmp_path, learned, problem) == steps
    ground = print_ground_plan(steps, problem, learned, encoding)
    assert parse_plan(ground, tmp_path, learned, problem) == steps
    domain, task = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    domain.write_text(domain_text(learned, encoding))
    task.write_text(problem_text(problem, learned, encoding))
    assert unified_planning_accepts(domain, task, ground)
    first, *others = [line for line in ground.splitlines() if not line.startswith("(l")]
    assert first
    assert not unified_planning_accepts(domain, task, "\n".join(others) + "\n")


@pytest.mark.parametrize("encoding", BY_RELATIONS)
def test_planners_read_only_what_a_problem_has_a_use_for(encoding, tmp_path: Path):
    learned, problem = grounding(), with_pairs(tower(), relations())
    domain, task = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    for file, text in zip((domain, task), needed_texts(problem, learned, encoding), strict=True):
        file.write_text(text)
        assert PUT_ON in text
        assert PUT_IN not in text, "there is no tray"
    ground = print_ground_plan(solved(problem, encoding=encoding), problem, learned, encoding)
    assert unified_planning_accepts(domain, task, ground)


def test_an_object_alone_is_put_on_nothing():
    alone = with_pairs(Problem("alone", scene(("cube", 0.6, 0.1)), {}, 0.02), relations())
    assert PUT_ON not in needed_texts(alone, grounding())[0]


def test_domain_forbids_what_rehearsals_showed_to_fail_and_allows_the_rest_at_its_cost():
    text = domain_text(grounding(), RELATIONAL)
    assert "With a third object on the reference: 0 of 10 went so, and it is forbidden." in text
    assert "With a third object on the reference: 8 of 10 went so, and it is allowed." in text
    assert "miss-01-tray-10: never carries its target to the reference." in text
    assert "not (exists" not in text
    problem = problem_text(sorting(), grounding(), RELATIONAL)
    assert f"(= (cost-of-{PUT_IN} usual none from-place) 6)" in problem
    assert f"(= (cost-of-{PUT_IN} usual one from-place) 30)" in problem


def relearned(name: str, **changes: int) -> Grounding:
    """The domain after other rehearsals of one operator, given as how many of 10 were kept."""
    learned = grounding()
    assert learned.relations is not None
    operators = tuple(
        msgspec.structs.replace(
            one,
            **{
                case: msgspec.structs.replace(getattr(one, case), trials=10, kept=kept)
                for case, kept in changes.items()
            },
        )
        if one.name == name
        else one
        for one in learned.relations.operators
    )
    relations = msgspec.structs.replace(learned.relations, operators=operators)
    return msgspec.structs.replace(learned, relations=relations)


def test_what_fails_with_a_third_object_on_the_target_is_done_without():
    steps = solved(tower_at_place(), relearned(PUT_ON, laden=0))
    assert steps == solved(tower_at_place())
    assert f"{PUT_ON}-laden" not in domain_text(relearned(PUT_ON, laden=0), RELATIONAL)
    assert f"{PUT_ON}-laden" in domain_text(grounding(), RELATIONAL)


def test_what_fails_from_another_object_goes_by_way_of_a_place():
    steps = solved(sorting(), relearned(PUT_IN, borne=0))
    assert len(steps) == 4
    assert {step.operator for step in steps[::2]} == {"carry-to-01-cube"}


def test_what_makes_its_target_lean_is_not_in_the_domain():
    table = relations()
    tilted = (0.0, 1.0, 1.0, 0.9, 0.0)
    states = tuple(
        msgspec.structs.replace(one, centre=tilted) if one.name == REST else one for one in table.states
    )
    leaning = msgspec.structs.replace(grounding(), relations=msgspec.structs.replace(table, states=states))
    assert left_out_puts(leaning)[PUT_ON] == "makes its target lean"
    assert {put.state.name for put in puts_of(leaning)} == {LIE}


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
    assert f"worse-15: does less surely what {PUT_ON} does." in domain_text(changed, RELATIONAL)
    problem = with_pairs(tower(), changed.relations)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == [PUT_ON]
    foreseen = {"item-01 item-03": {PUT_ON: 0.5, "worse-16": 0.9}}
    problem = msgspec.structs.replace(problem, foreseen=foreseen)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == ["worse-16"]
    assert "(can-worse-16 item-01 item-03 surely)" in problem_text(problem, changed, RELATIONAL)
    assert "item-01 item-03 often)" not in problem_text(problem, changed, RELATIONAL)


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
    assert isinstance(problem.pairs, dict)
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


@pytest.mark.parametrize(
    "name", ["none", "count-2", "from-place", "start-item-01", "rests-on-001", "solid-01", PUT_ON, "surely"]
)
def test_objects_have_no_names_of_the_domain(name):
    objects = (msgspec.structs.replace(tower().objects[0], name=name), *tower().objects[1:])
    with pytest.raises(InvalidValue, match=f"No object can be called {name}"):
        problem_text(Problem("named", objects, {}), grounding(), RELATIONAL)


def test_lifted_domain_says_not_and_exists_and_counts_nothing():
    text = domain_text(grounding(), LIFTED)
    assert ":negative-preconditions :existential-preconditions" in text
    assert "(not (exists (?x - movable) (rests-with ?x ?r)))" in text
    assert "count" not in "\n".join(line for line in text.splitlines() if not line.lstrip().startswith(";"))


if __name__ == "__main__":
    for name, content in texts().items():
        (GOLDEN / name).write_text(content)
