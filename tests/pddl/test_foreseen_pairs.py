"""What networks foresee of the pairs at hand: in problems, in their PDDL, in plans and their replay."""

import dataclasses
import re
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace
from toy_relations import PUT_IN, PUT_ON, REST, grounding, relations, sorting, tower

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
    asked = replace(problem, relations=((*pair, state),))
    assert [put.name for put in puts_for(asked, learned, *pair)] == [IN_ANY, ON_ANY]
    assert "(can-put item-04 lies-in-item-01 way" in problem_text(asked, learned)
    assert "lies-in-item-01" not in problem_text(problem, learned)
    tried = plan(asked, learned)
    assert [step.operator for step in tried.steps] == [IN_ANY]
    fainter = replace(seen(sorting(), on=0.9, lying=0.01), relations=asked.relations)
    assert plan(fainter, learned).status is PlanStatus.UNSOLVABLE


@pytest.mark.parametrize(("foreseen", "share"), [(0.09, None), (0.1, 0.2), (0.3, 0.2), (0.9, 0.54)])
def test_what_is_foreseen_of_any_pair_comes_true_less_often(foreseen: float, share: float | None):
    assert share_with_any(foreseen) == (None if share is None else pytest.approx(share))
    assert [nearest_share(one) for one in (0.0, 0.25, 0.5, 0.72, 1.0)] == [0.1, 0.3, 0.5, 0.7, 0.9]


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
    assert of_pair.chance == 0.3
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
    ends = (PairEnd("001", 1, 0.1, (0.0, 0.0, 0.8), (0.0, 0.0, 0.0)),)
    changes = {"name": "put-on-01-tray-10", "pair": "10", "trials": 10, "ends": ends}
    other = replace(first, **changes, borne=Kept("put-on-01-tray-10", 4, 1))
    (found,) = pooled(replace(table, operators=(first, other)))
    assert (found.name, found.pair, found.trials) == (ON_ANY, "", 30)
    (end,) = found.ends
    assert (end.state, end.count) == ("001", 20)
    assert end.offset == pytest.approx((0, 0, 0.99))
    assert end.spread == pytest.approx((0, 0, np.std([1.0] * 19 + [0.8])), abs=1e-4)
    assert (found.borne.trials, found.borne.kept) == (14, 11)


def test_problems_keep_what_is_foreseen_and_refuse_what_is_no_share(tmp_path: Path):
    path = tmp_path / "seen.json"
    seen(tower()).save(path)
    assert Problem.load(path) == seen(tower())
    path.write_text(path.read_text().replace("0.95", "1.95", 1))
    with pytest.raises(InvalidFile, match="<= 1"):
        Problem.load(path)
