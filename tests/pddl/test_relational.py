"""Tasks of relations: what is planned for them, that it comes true, and what cannot be is refused."""

import dataclasses
import json
import re
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
import toy_places
import toy_relations
from msgspec.structs import replace
from toy_relations import LIE, PUT_IN, PUT_ON, REST, grounding, relations, scene, sorting, tower

from neurosym.errors import InvalidFile, InvalidValue, NeurosymError
from neurosym.grounding import Grounding
from neurosym.operators import Kept
from neurosym.pair_operators import pair_end, pooled
from neurosym.pddl.compiler import problem_text
from neurosym.pddl.problem_check import check_relations, relations_meant
from neurosym.planners import PlanStatus, plan
from neurosym.planners.planner import Planner, PlanResult
from neurosym.problems import Problem
from neurosym.tasks.options import put_named, puts_for, puts_of
from neurosym.tasks.supports import PairSight, bearers_of, with_pairs
from neurosym.tasks.task import MOST_BORNE, understand
from neurosym.tasks.transition import PlanStep, chance, start, validate


def solved(problem: Problem, learned: Grounding | None = None, **options) -> tuple[PlanStep, ...]:
    result = plan(problem, learned or grounding(), **options)
    assert result.status is PlanStatus.SOLVED, result.reason
    return result.steps


@pytest.mark.parametrize(
    ("problem", "steps"),
    [
        (tower(), [(PUT_ON, "item-03", "item-02"), (PUT_ON, "item-01", "item-03")]),  # from below
        (sorting(), [(PUT_IN, "item-01", "item-04"), (PUT_IN, "item-02", "item-05")]),  # from above
        (replace(sorting(), relations=(("item-01", "item-02", REST),)), []),
    ],
)
def test_steps_are_those_one_would_take_whoever_plans(problem: Problem, steps: list[tuple[str, str, str]]):
    wanted = tuple(PlanStep(*step) for step in steps)
    assert solved(problem) == wanted
    assert len(solved(problem, planner="bfs")) == len(wanted)
    own = Planner("own", "mine", lambda _: PlanResult(PlanStatus.SOLVED, wanted, 0.0))
    assert solved(problem, planner=own) == wanted
    false = Planner("own", "mine", lambda _: PlanResult(PlanStatus.SOLVED, wanted[:1], 0.0))
    assert not steps or plan(problem, grounding(), false).status is PlanStatus.FAILED


def test_what_rests_on_an_object_goes_along():
    step = PlanStep("carry-to-01-block", "item-03", "park-01")
    before, after = validate([step], sorting(), grounding()).positions
    assert (after - before)[0] == pytest.approx((after - before)[2])
    assert (after - before)[3:] == pytest.approx(0)


def test_what_fails_with_a_third_object_is_done_without_and_what_fails_from_one_by_way_of_a_place():
    assert solved(toy_relations.tower_at_place(), toy_relations.relearned(PUT_ON, laden=0)) == solved(
        toy_relations.tower_at_place()
    )
    steps = solved(sorting(), toy_relations.relearned(PUT_IN, borne=0))
    assert len(steps) == 4
    assert {step.operator for step in steps[::2]} == {"carry-to-01-cube"}


def test_of_operators_that_do_the_same_a_few_are_in_the_domain_and_each_pair_gets_the_surest():
    learned = grounding()
    assert learned.relations is not None
    one = learned.relations.operators[0]
    (end,) = one.outcomes
    worse = [
        replace(one, name=f"worse-{n}", outcomes=(replace(end, count=n, near_mean=n),))
        for n in (15, 16, 17, 18)
    ]
    both = replace(learned.relations, operators=(*worse, *learned.relations.operators))
    changed = replace(learned, relations=both)
    more = {put.name for put in puts_of(changed)} - {put.name for put in puts_of(learned)}
    assert more == {"worse-16", "worse-17", "worse-18"}
    assert changed.relations.left_out["worse-15"] == f"does less surely what {PUT_ON} does"
    problem = with_pairs(tower(), changed.relations)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == [PUT_ON]
    foreseen = {"item-01 item-03": {PUT_ON: 0.5, "worse-16": 0.9}}
    problem = replace(problem, foreseen=foreseen)
    assert [put.name for put in puts_for(problem, changed, "item-01", "item-03")] == ["worse-16"]


def test_what_bears_what_is_seen_in_a_box_with_a_stack():
    cubes = ("cube", 0.7, 0.03, 0.01), ("cube", 0.7, 0.03, 0.06)
    objects = scene(("tray", 0.7, 0.0), *cubes, ("block", 0.5, 0.2))
    problem = with_pairs(Problem("box", objects, {}), grounding().relations)
    found = bearers_of(problem, grounding().relations).items()
    found = {name: (one.by, one.state.name) for name, one in found}
    assert found == {"item-02": ("item-01", LIE), "item-03": ("item-02", REST)}


def test_nothing_is_put_where_as_many_lie_as_plans_count():
    cubes = [("cube", 0.45 + 0.08 * n, -0.25) for n in range(MOST_BORNE + 1)]
    objects = scene(*cubes, ("tray", 0.7, 0.1))
    *inside, tray = (item.name for item in objects)
    full = Problem("full", objects, {}, 0.02, relations=((inside[0], tray, LIE),))
    steps = [PlanStep(PUT_IN, name, place=tray) for name in inside]
    assert validate(steps[:-1], full, grounding()).valid
    found = validate(steps, full, grounding())
    assert found.reason.endswith(f"{tray} bears {MOST_BORNE} objects, and plans count no more")


@pytest.mark.parametrize(("target", "reference"), [("item-01", "item-02"), ("item-02", "item-01")])
def test_of_two_that_look_as_if_each_bore_the_other_the_one_bears_that_goals_ask_for(target, reference):
    learned = grounding().relations
    _, lying, miss = learned.operators
    around = replace(miss, outcomes=lying.outcomes)  # trays are put around cubes, too
    known = replace(learned, operators=(*learned.operators[:2], around))
    objects = scene(("tray", 0.7, 0.0), ("cube", 0.7, 0.0, 0.001))
    problem = with_pairs(Problem("mutual", objects, {}, relations=((target, reference, LIE),)), known)
    assert {name: one.by for name, one in bearers_of(problem, known).items()} == {target: reference}


def test_kinds_of_pairs_and_relations_are_kept_in_files_and_old_ones_have_none(tmp_path: Path):
    path, problem = tmp_path / "new.json", seen(tower(), lying=0.0)
    assert problem.pairs["item-01 item-02"] == "01"
    problem.save(path)
    assert Problem.load(path) == problem
    path.write_text(path.read_text().replace("0.987", "1.987", 1))
    with pytest.raises(InvalidFile, match="<= 1"):
        Problem.load(path)
    toy_places.swap().save(tmp_path / "old.json")
    assert not {"relations", "pairs", "touching"} & json.loads((tmp_path / "old.json").read_text()).keys()
    grounding().save(tmp_path / "grounding.json")
    assert Grounding.load(tmp_path / "grounding.json") == grounding()
    assert grounding().format == "neurosym-grounding-4"
    assert toy_places.grounding().format == "neurosym-grounding-3"


@pytest.mark.parametrize(
    ("steps", "said"),
    [
        (((PUT_IN, "item-02", "item-01"),), "it is not for item-02 with item-01, a pair of the kind 01"),
        (((PUT_ON, "item-01", "item-03"),), "item-03 bears item-02, which rehearsals forbid"),
        (((PUT_ON, "item-03", "item-01"),), "item-01 rests on item-03 itself"),
        ((("carry-to-01-cube", "item-03", "park-01"),), "it is not for item-03"),
        ((("carry-to-01-cube", "item-01", "spot-5000-0"),), "item-01 ends where item-02 is"),
        ((("carry-to-01-cube", "item-01", "park-01"),), "item-01 ends borne by nothing, not lies-in-010"),
    ],
)
def test_replay_says_what_is_wrong(steps, said):
    checked = validate([PlanStep(*step) for step in steps], sorting(), grounding())
    assert not checked.valid
    assert said in checked.reason


@pytest.mark.parametrize(
    ("goals", "said"),
    [
        ([("item-01", "item-01", REST)], "item-01 cannot be rests-on-001 of itself; valid references: item"),
        ([("item-01", "item-02", REST), ("item-02", "item-01", REST)], "lead round in a circle"),
        ([("item-01", "item-02", REST), ("item-01", "item-03", REST)], "rests-on-001 item-03; give it one"),
        ([("item-01", "item-02", REST), ("item-01", "item-02", LIE)], r"and \S+ item-02; give it one of"),
        ([("item-01", "moon", REST)], "a relation of moon, which is not in the scene; objects: item-01"),
        ([("item-01", "item-02", "floats")], "no state of a pair 'floats'; valid: apart-000"),
        ([("item-01", "item-02", "apart-000")], "in which nothing is borne; valid states: rests-on-001"),
        ([("item-04", "item-03", REST)], "nothing puts item-04 on or into any other object"),
        ([("item-01", "item-04", REST)], "item-01 to rests-on-001 with item-04; valid for item-01: rests-on"),
        ([("item-01", "item-03", REST), ("item-02", "item-03", REST)], "show that it bears one object at a"),
    ],
)
def test_relations_that_cannot_be_are_refused_in_one_sentence(goals, said):
    with pytest.raises(NeurosymError, match=said):
        check_relations(replace(sorting(), relations=tuple(goals)), grounding())


SHORT = {"item-01 item-02": "1"}


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: replace(tower(), goals={"item-01": (0.8, 0.0, 0.025)}), "item-01 has a goal and a relation"),
        (lambda: plan(tower(), toy_places.grounding()), "learned none; valid: a problem with goals"),
        (lambda: plan(tower(), grounding(), "counting"), r"which counting does not take; valid: .*bfs"),
        (lambda: check_relations(replace(tower(), pairs=SHORT), grounding()), "the code '1' for 'item-01 it"),
        (lambda: grounding().relations.state_meant("b"), "may be any of several states; valid: below-011"),
    ],
)
def test_what_does_not_go_together_is_refused_in_one_sentence(call, said):
    with pytest.raises(InvalidValue, match=said):
        call()


def test_relation_is_meant_by_the_beginning_of_a_name_and_one_that_nothing_leads_to_is_a_result():
    goal = ("item-01", "item-02", "rests")
    assert relations_meant((goal, goal), grounding()) == (("item-01", "item-02", REST),)
    problem = replace(sorting(), relations=(("item-04", "item-03", REST),))
    for planner in ("fast-downward", "bfs"):
        result = plan(problem, grounding(), planner)
        assert result.status is PlanStatus.UNSOLVABLE
        assert result.reason.startswith("no operator brings item-04 to rests-on-001 with item-03")


ON_ANY, IN_ANY = "rests-on-001-by-01", "lies-in-010-by-01"


def kinds(features: np.ndarray) -> tuple[str, ...]:
    """Tell a tray as the reference, or as the target, or neither."""
    return tuple("11" if row[7] else "10" if row[3] else "01" for row in features)


def sight(on: float, lying: float) -> PairSight:
    """Networks that foresee the same of all pairs."""
    return PairSight(kinds, lambda features, _: np.tile((on, lying), (len(features), 1)), ("001", "010"))


def seen(problem: Problem, **foreseen: float) -> Problem:
    return with_pairs(problem, relations(), sight(foreseen.get("on", 0.95), foreseen.get("lying", 0.95)))


def test_each_pair_is_asked_for_the_operators_of_its_kind():
    problem = seen(sorting(), on=0.75, lying=0.3)
    assert problem.foreseen["item-01 item-02"] == {PUT_ON: 0.714, ON_ANY: 0.75, IN_ANY: 0.3}
    assert problem.foreseen["item-01 item-04"] == {PUT_IN: 0.286, ON_ANY: 0.75, IN_ANY: 0.3}
    assert problem.foreseen["item-04 item-01"] == {ON_ANY: 0.75, IN_ANY: 0.3}
    assert set(problem.pairs) == {f"{one} {other}" for one, other in permutations(problem.object_names, 2)}


def test_what_is_only_faintly_foreseen_is_offered_where_a_goal_asks_for_it():
    problem, learned = seen(sorting(), on=0.9, lying=0.06), grounding()
    pair, state = ("item-04", "item-01"), learned.relations.state_named("lies-in-010").name
    assert problem.foreseen["item-04 item-01"] == {ON_ANY: 0.9, IN_ANY: 0.06}
    assert [put.name for put in puts_for(problem, learned, *pair)] == [ON_ANY]
    asked = replace(problem, relations=((*pair, state),))
    assert [put.name for put in puts_for(asked, learned, *pair)] == [IN_ANY, ON_ANY]
    assert "(can-put item-04 lies-in-item-01 way" in problem_text(asked, learned)
    assert "lies-in-item-01" not in problem_text(problem, learned)
    tried = plan(asked, learned)
    assert [step.operator for step in tried.steps] == [IN_ANY]
    fainter = replace(seen(sorting(), on=0.9, lying=0.01), relations=asked.relations)
    assert plan(fainter, learned).status is PlanStatus.UNSOLVABLE


def test_what_is_hardly_foreseen_is_not_planned_with_and_has_hardly_a_chance():
    problem, learned = seen(tower(), on=0.004, lying=0.004), grounding()
    assert puts_for(problem, learned, "item-01", "item-03") == ()
    assert "(can-put " not in problem_text(problem, learned)
    result = plan(problem, learned)
    assert result.status is PlanStatus.UNSOLVABLE
    assert result.reason.startswith(f"no operator brings item-01 to {REST} with item-03")
    steps = (PlanStep(PUT_ON, "item-03", "item-02"), PlanStep(PUT_ON, "item-01", "item-03"))
    assert validate(steps, problem, learned).valid  # it may be, if somebody else wants it so
    task = understand(problem, learned)
    assert chance(task, start(task), steps[0]) == 0.1


def test_cost_is_that_of_the_pair_and_more_where_a_third_object_spoils_it():
    learned = grounding()
    put = put_named(PUT_IN, learned)
    assert put is not None
    problem = seen(sorting(), lying=0.3)
    of_pair = put.with_pair(problem, learned, "item-01", "item-04")
    assert of_pair.chance == 0.3  # the nearest of `SHARES`
    assert dataclasses.replace(of_pair, case={"occupied"}).chance < of_pair.chance
    task = understand(problem, learned)
    at_first = [one for one in task.put_options["item-01", "item-04"] if one.name == PUT_IN]
    costs = {one.case: one.cost(learned) for one in at_first}
    assert costs[frozenset()] == of_pair.cost(learned) < costs[frozenset({"occupied"})]
    text = problem_text(problem, learned)
    (way,) = re.findall(r"\(can-put item-01 lies-in-item-04 (way\d+)\)", text)
    assert f"(fee {way} from-spot n0 cost{costs[frozenset()]})" in text
    assert f"(fee {way} from-spot n1 cost{costs[frozenset({'occupied'})]})" in text


def test_without_that_network_pairs_do_as_others_of_their_kind_and_one_for_other_states_is_refused():
    problem = with_pairs(sorting(), relations(), PairSight(kinds))
    (put,) = puts_for(problem, grounding(), "item-01", "item-02")
    assert (problem.foreseen, put.foreseen, put.share) == ({}, None, put.end.share)
    assert "(can-put item-01 rests-on-item-02 way" in problem_text(problem, grounding())
    others = PairSight(kinds, sight(0.5, 0.5).chances, ("001", "100"))
    with pytest.raises(InvalidValue, match="was trained on others than the domain has"):
        with_pairs(sorting(), relations(), others)


def test_operator_pooled_adds_up_what_was_rehearsed_with_each_kind():
    table = relations()
    first = table.operators[0]
    ends = (pair_end("001", 1, 0.1, (0.0, 0.0, 0.8), (0.0, 0.0, 0.0)),)
    changes = {"name": "put-on-01-tray-10", "subject": "10", "trials": 10, "outcomes": ends}
    company = (("borne", Kept("put-on-01-tray-10", 4, 1)), *first.company[1:])
    other = replace(first, **changes, company=company)
    (found,) = pooled(replace(table, operators=(first, other)))
    assert (found.name, found.subject, found.trials) == (ON_ANY, "", 30)
    (end,) = found.outcomes
    assert (end.kind, end.count) == ("001", 20)
    assert end.effect == pytest.approx((0, 0, 0.99))
    assert end.spread == pytest.approx((0, 0, np.std([1.0] * 19 + [0.8])), abs=1e-4)
    assert (found.among("borne").trials, found.among("borne").kept) == (14, 11)
