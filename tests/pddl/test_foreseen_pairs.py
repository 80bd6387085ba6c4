"""What networks foresee of the pairs at hand: in problems, in their PDDL, in plans and their replay."""

import dataclasses
import re
from itertools import permutations
from pathlib import Path

import msgspec
import numpy as np
import pytest
from toy_relations import PUT_IN, PUT_ON, REST, grounding, relations, scene, sorting, tower

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.pair_operators import Kept, PairEnd, pooled, share_with_any
from neurosym.pddl.compiler import problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.options import nearest_share, put_named, puts_for
from neurosym.tasks.supports import PairSight, with_pairs
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, chance, start, validate

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
    assert problem.foreseen["item-01 item-02"] == {PUT_ON: 0.75, ON_ANY: 0.45, IN_ANY: 0.2}
    assert problem.foreseen["item-01 item-04"] == {PUT_IN: 0.3, ON_ANY: 0.45, IN_ANY: 0.2}
    assert problem.foreseen["item-04 item-01"] == {ON_ANY: 0.45, IN_ANY: 0.2}
    assert set(problem.pairs) == {f"{one} {other}" for one, other in permutations(problem.object_names, 2)}


def test_what_is_only_faintly_foreseen_is_offered_where_a_goal_asks_for_it():
    problem, learned = seen(sorting(), on=0.9, lying=0.06), grounding()
    pair, state = ("item-04", "item-01"), learned.relations.state_named("lies-in-010").name
    assert problem.foreseen["item-04 item-01"] == {ON_ANY: 0.54, IN_ANY: 0.06}
    assert [put.name for put in puts_for(problem, learned, *pair)] == [ON_ANY]
    asked = msgspec.structs.replace(problem, relations=((*pair, state),))
    assert [put.name for put in puts_for(asked, learned, *pair)] == [IN_ANY, ON_ANY]
    assert "(can-put item-04 lies-in-item-01 way" in problem_text(asked, learned)
    assert "lies-in-item-01" not in problem_text(problem, learned)
    tried = plan(asked, learned)
    assert [step.operator for step in tried.steps] == [IN_ANY]
    fainter = msgspec.structs.replace(seen(sorting(), on=0.9, lying=0.01), relations=asked.relations)
    assert plan(fainter, learned).status is PlanStatus.UNSOLVABLE


def test_without_that_network_pairs_do_as_others_of_their_kind():
    problem = with_pairs(sorting(), relations(), PairSight(kinds))
    assert problem.foreseen == {}
    (put,) = puts_for(problem, grounding(), "item-01", "item-02")
    assert (put.foreseen, put.share) == (None, put.end.share)
    assert "(can-put item-01 rests-on-item-02 way" in problem_text(problem, grounding())


def test_what_another_kind_of_pairs_is_for_is_offered_where_it_is_foreseen_and_own_operators_are_not():
    problem, learned = seen(sorting(), on=0.9, lying=0.9), grounding()
    assert [put.name for put in puts_for(problem, learned, "item-01", "item-02")] == [IN_ANY, PUT_ON]
    assert [put.name for put in puts_for(problem, learned, "item-04", "item-01")] == [IN_ANY, ON_ANY]
    assert {put.foreseen for put in puts_for(problem, learned, "item-04", "item-01")} == {0.5}
    assert "(can-put item-04 rests-on-item-01 way" in problem_text(problem, learned)
    step = PlanStep(ON_ANY, "item-04", "item-01")
    assert validate((step,), problem, learned).failed is None  # the goals are what is left
    unknown = with_pairs(sorting(), relations(), PairSight(kinds))
    assert puts_for(unknown, learned, "item-04", "item-01") == ()


@pytest.mark.parametrize(("foreseen", "share"), [(0.09, None), (0.1, 0.2), (0.3, 0.2), (0.9, 0.54)])
def test_what_is_foreseen_of_any_pair_comes_true_less_often(foreseen: float, share: float | None):
    assert share_with_any(foreseen) == (None if share is None else pytest.approx(share))


def test_operator_pooled_adds_up_what_was_rehearsed_with_each_kind():
    table = relations()
    first = table.operators[0]
    other = msgspec.structs.replace(
        first,
        name="put-on-01-tray-10",
        pair="10",
        trials=10,
        ends=(PairEnd("001", 1, 0.1, (0.0, 0.0, 0.8), (0.0, 0.0, 0.0)),),
        borne=Kept("put-on-01-tray-10", 4, 1),
    )
    both = msgspec.structs.replace(table, operators=(first, other))
    (found,) = pooled(both)
    assert (found.name, found.pair, found.trials) == (ON_ANY, "", 30)
    (end,) = found.ends
    assert (end.state, end.count) == ("001", 20)
    assert end.offset == pytest.approx((0, 0, 0.99))
    assert end.spread == pytest.approx((0, 0, np.std([1.0] * 19 + [0.8])), abs=1e-4)
    assert (found.borne.trials, found.borne.kept) == (14, 11)


@pytest.mark.parametrize(("share", "told"), [(0.0, 0.1), (0.25, 0.3), (0.5, 0.5), (0.72, 0.7), (1.0, 0.9)])
def test_what_is_foreseen_counts_as_the_nearest_of_a_few(share: float, told: float):
    assert nearest_share(share) == told


def test_what_is_hardly_foreseen_is_not_planned_with_and_has_hardly_a_chance():
    problem, learned = seen(tower(), on=0.01, lying=0.01), grounding()
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
    of_pair = put.with_pair(problem, "item-01", "item-04")
    assert of_pair.chance() == 0.3
    assert of_pair.chance(occupied=True) < of_pair.chance()
    task = understand(problem, learned)
    at_first = [one for one in task.put_options["item-01", "item-04"] if one.put.name == PUT_IN]
    costs = {(one.borne, one.occupied): one.cost for one in at_first if not one.laden}
    assert costs[False, False] == of_pair.cost(learned) < costs[False, True]
    text = problem_text(problem, learned)
    (way,) = re.findall(r"\(can-put item-01 lies-in-item-04 (way\d+)\)", text)
    assert f"(fee {way} from-spot n0 cost{costs[False, False]})" in text
    assert f"(fee {way} from-spot n1 cost{costs[False, True]})" in text


@pytest.mark.parametrize(
    ("planner", "status"), [("bfs", PlanStatus.UNSOLVABLE), ("bfs-operators", PlanStatus.SOLVED)]
)
def test_breadth_first_search_reads_the_network_or_what_rehearsals_showed(planner: str, status: PlanStatus):
    assert plan(seen(tower(), on=0.01), grounding(), planner).status is status


def test_planner_takes_the_pair_that_is_foreseen_to_go_surely():
    objects = scene(("cube", 0.5, -0.2), ("tray", 0.5, 0.1), ("cube", 0.7, -0.2))
    problem = Problem("one-of-two", objects, {}, relations=(("item-01", "item-02", "lies-in-010"),))
    result = plan(seen(problem, lying=0.9), grounding())
    assert [step.operator for step in result.steps] == [PUT_IN]


def test_networks_that_foresee_other_states_are_refused():
    others = PairSight(kinds, sight(0.5, 0.5).chances, ("001", "100"))
    with pytest.raises(InvalidValue, match="was trained on others than the domain has"):
        with_pairs(sorting(), relations(), others)


def test_pairs_that_are_seen_anew_keep_nothing_that_was_foreseen():
    again = msgspec.structs.replace(seen(sorting()), pairs={})
    assert with_pairs(again, relations()).foreseen == {}


def test_rare_promises_are_not_forbidden_third_objects_for_being_rare():
    learned = grounding()
    put = put_named(PUT_IN, learned)
    assert put is not None
    rare = msgspec.structs.replace(put.end, share=0.2, count=4)
    operator = msgspec.structs.replace(put.operator, borne=Kept(PUT_IN, 10, 2), occupied=Kept(PUT_IN, 10, 0))
    changed = dataclasses.replace(put, end=rare, operator=operator)
    assert changed.takes_borne
    assert not changed.takes_occupied


def test_problems_keep_what_is_foreseen_and_refuse_what_is_no_share(tmp_path: Path):
    path = tmp_path / "seen.json"
    seen(tower()).save(path)
    assert Problem.load(path) == seen(tower())
    path.write_text(path.read_text().replace("0.95", "1.95", 1))
    with pytest.raises(InvalidFile, match="<= 1"):
        Problem.load(path)
