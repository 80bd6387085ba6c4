"""Pasts: what an object was seen to do changes what it is promised, and never to certainty."""

import msgspec
import pytest
from msgspec.structs import replace
from places import ROOT
from tables import grounding, problem

from neurosym.execution.tries import try_once
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.sim.config import TabletopConfig
from neurosym.sim.tabletop import Tabletop
from neurosym.tasks.options import puts_of
from neurosym.tasks.pasts import LEAST_CHANCE, as_it_lies, with_pasts
from neurosym.tasks.promises import promised, usable
from neurosym.tasks.transition import validate
from tools.benchmarks.objects.tasks import pushing

STRAIGHT, ON_A_SIDE = (0.0, 0.0, 0.0, 1.0), (0.5**0.5, 0.0, 0.0, 0.5**0.5)
PUSH, OTHER = "push-left-000-block", "push-away-001-block"


def trial(operator: Operator, *, kept: bool, crowded: bool = False, lay=STRAIGHT) -> Trial:
    """What came of an operator: what it promises, or nothing."""
    promise, nothing = operator.promise, (0.0, 0.0, 0.0)
    assert promise is not None
    if not kept:
        return Trial(operator.label, "resting", nothing, nothing, lay, crowded)
    return Trial(operator.label, "resting", promise.effect, promise.resting_effect, lay, crowded)  # type: ignore[arg-type]


def after(*trials: Trial) -> SceneObject:
    return replace(problem().objects[0], past=trials)


def chance(name: str, *trials: Trial) -> float:
    return promised(grounding(), after(*trials))[name].chance


def named(name: str) -> Operator:
    return grounding().operator_named(name)


def test_what_one_push_did_tells_of_another():
    before = promised(grounding(), problem().objects[0])[OTHER].chance
    kept, failed = (chance(OTHER, trial(named(PUSH), kept=one)) for one in (True, False))
    assert failed < 0.8 * before
    assert failed < kept <= before


def test_what_others_were_in_the_way_of_tells_of_no_other_push():
    crowded = trial(named(PUSH), kept=False, crowded=True)
    assert chance(OTHER, crowded) == chance(OTHER)


def test_however_often_a_promise_is_kept_it_is_not_certain():
    assert 0.9 < chance(PUSH, *[trial(named(PUSH), kept=True)] * 50) < 1


def test_what_an_object_did_on_another_side_does_not_count():
    lying = trial(named(PUSH), kept=False, lay=ON_A_SIDE)
    assert as_it_lies(after(lying), turned=False) == ()
    assert chance(PUSH, lying) == chance(PUSH)


def test_what_is_seen_is_added_to_what_was_known():
    one, other = trial(named(PUSH), kept=True), trial(named(OTHER), kept=False)
    task = replace(problem(), objects=(after(one), *problem().objects[1:]))
    known = with_pasts(task, {"item-01": (other,)})
    assert known.objects[0].past == (one, other)
    assert known.objects[1] == task.objects[1]


def test_a_problem_is_saved_without_the_past_of_its_objects(tmp_path):
    task = replace(
        problem(), objects=(after(trial(named(PUSH), kept=True)),), goals={"item-01": (0.5, 0.1, 0.025)}
    )
    task.save(tmp_path / "one.scene.json")
    assert Problem.load(tmp_path / "one.scene.json").objects[0].past is msgspec.UNSET


def test_an_object_that_was_met_may_be_grasped_as_others_are():
    learned = Grounding.load(ROOT / "domains" / "places" / "grounding.json")
    item = SceneObject("item-01", "10", (0.15, 0.16, 0.05, 0.0), (0.6, 0.0, 0.025))
    own = {one.label for one in learned.operators_on("10") if one.frame == "place"}
    others = [one for one in learned.live_on("place") if one.label not in own and one.subject != "10"]
    assert not {one.name for one in others} & promised(learned, item).keys()
    tried = Trial("another motion", "resting", (0.0,) * 3, (0.0,) * 3, STRAIGHT)
    in_a_run = replace(tried, run="task-01.bfs")
    in_runs = promised(learned, replace(item, past=(in_a_run,)))
    assert promised(learned, item).keys() == in_runs.keys()
    met = promised(learned, replace(item, past=(tried,)))
    offered = [met[one.name] for one in others if one.name in met]
    assert len({one.label for one in offered}) == len(offered) > 2  # each motion once
    for one in offered:
        usual = learned.operator_named(one.name)
        assert one.successes == pytest.approx(0.24 * usual.successes, abs=1)
    first, *rest = offered
    missed = Trial(f"to-{first.label}", "missed", (0.0,) * 3, (0.0,) * 3, STRAIGHT)
    again = promised(learned, replace(item, past=(tried, missed)))
    assert again[first.name].chance < LEAST_CHANCE / 2
    promise = first.promise
    assert promise is not None
    carried = Trial(f"to-{first.label}", "carried", promise.effect, promise.resting_effect, STRAIGHT)
    kept = promised(learned, replace(item, past=(carried,)))
    assert all(one.successes < LEAST_CHANCE * one.trials for one in offered)  # not planned with
    assert kept[first.name].chance > 2 * LEAST_CHANCE
    assert all(again[one.name].chance < one.chance for one in rest)


def test_an_object_that_was_met_is_pushed_as_others_are_once_it_was_so():
    learned = Grounding.load(ROOT / "domains" / "places" / "grounding.json")
    own = {one.label for one in learned.operators_on("10") if one.frame == "object"}
    push = next(one for one in learned.live if one.label not in own and not is_lift(one))
    learned = replace(learned, objects=replace(learned.objects, operators=(push,)), places=None)
    item, shift = SceneObject("item-01", "10", (0.15, 0.16, 0.05, 0.0), (0.5, 0.0, 0.025)), (0.05, 0.03, 0.0)
    met = replace(item, past=(Trial("another motion", "resting", *[(0.0,) * 3] * 2, STRAIGHT),))
    pushed = replace(item, past=(Trial(push.label, "resting", shift, shift, STRAIGHT),))
    assert [push.name in promised(learned, one) for one in (item, met)] == [False, True]
    assert [[one.name for one in usable(learned, one)] for one in (met, pushed)] == [[], [push.name]]
    task = Problem("p", (pushed,), {"item-01": (0.65, 0.09, 0.025)}, tolerance=0.03)
    found = plan(task, learned)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert {step.operator for step in found.steps} == {push.name}
    assert validate(found.steps, task, learned).valid


def test_where_no_plan_is_known_what_probably_leads_farthest_towards_the_goal_is_tried():
    learned = pushing(Grounding.load(ROOT / "domains" / "places" / "grounding.json"))
    others = tuple(one for one in learned.objects.operators if one.subject != "10")
    learned = replace(learned, objects=replace(learned.objects, operators=others))
    once = Trial("another motion", "resting", (0.0,) * 3, (0.0,) * 3, STRAIGHT)
    item = SceneObject("item-01", "10", (0.15, 0.16, 0.05, 0.0), (0.6, 0.0, 0.025), past=(once,))
    for way in (-0.15, 0.15):
        task = Problem("p", (item,), {"item-01": (0.6, way, 0.025)})
        tried = try_once(Tabletop(TabletopConfig()), task, learned)
        assert tried is not None
        promise = learned.operator_named(tried.operator).promise
        assert promise is not None
        assert promise.resting_effect[1] / way > 0.2


def test_what_carries_and_puts_on_others_is_tried_first():
    learned = Grounding.load(ROOT / "domains" / "towers" / "grounding.json")
    item = SceneObject("item-01", "10", (0.15, 0.16, 0.05, 0.0), (0.6, 0.0, 0.025))
    tried = try_once(Tabletop(TabletopConfig()), Problem("p", (item,), {}), learned)
    assert tried is not None
    own = [one for one in learned.live_on("place") if one.subject == "10"]
    labels = {one.operator.label for one in puts_of(learned)}
    actions = {one.action for one in learned.relations.primitives if one.label in labels}
    puts = {one.name for one in own if learned.primitive_of(one).action in actions}
    assert tried.operator in puts < {one.name for one in own}
