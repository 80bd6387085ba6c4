"""Pasts: what an object was seen to do changes what it is promised, and never to certainty."""

import msgspec
import pytest
from places import ROOT
from tables import grounding, problem

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.tasks.pasts import LEAST_CHANCE, as_it_lies, with_pasts
from neurosym.tasks.promises import promised

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
    return msgspec.structs.replace(problem().objects[0], past=trials)


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
    task = msgspec.structs.replace(problem(), objects=(after(one), *problem().objects[1:]))
    known = with_pasts(task, {"item-01": (other,)})
    assert known.objects[0].past == (one, other)
    assert known.objects[1] == task.objects[1]


def test_a_problem_is_saved_without_the_past_of_its_objects(tmp_path):
    task = msgspec.structs.replace(
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
    in_a_run = msgspec.structs.replace(tried, run="task-01.bfs")
    in_runs = promised(learned, msgspec.structs.replace(item, past=(in_a_run,)))
    assert promised(learned, item).keys() == in_runs.keys()
    met = promised(learned, msgspec.structs.replace(item, past=(tried,)))
    offered = [met[one.name] for one in others if one.name in met]
    assert len({one.label for one in offered}) == len(offered) > 2  # each motion once
    for one in offered:
        usual = learned.operator_named(one.name)
        assert one.successes == pytest.approx(0.24 * usual.successes, abs=1)
    first, *rest = offered
    missed = Trial(f"to-{first.label}", "missed", (0.0,) * 3, (0.0,) * 3, STRAIGHT)
    again = promised(learned, msgspec.structs.replace(item, past=(tried, missed)))
    assert again[first.name].chance < LEAST_CHANCE / 2
    promise = first.promise
    assert promise is not None
    carried = Trial(f"to-{first.label}", "carried", promise.effect, promise.resting_effect, STRAIGHT)
    kept = promised(learned, msgspec.structs.replace(item, past=(carried,)))
    assert all(one.successes < LEAST_CHANCE * one.trials for one in offered)  # not planned with
    assert kept[first.name].chance > 2 * LEAST_CHANCE
    assert all(again[one.name].chance < one.chance for one in rest)
