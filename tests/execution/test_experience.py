"""Experience: an object that was acted upon is believed to do again what it was last seen to do."""

import dataclasses
import math

import numpy as np
import pytest
from msgspec import UNSET
from msgspec.structs import replace
from tables import grounding, problem

from neurosym.execution.replanning import Experience
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.problems import Problem
from neurosym.tasks.promises import promised, usable
from neurosym.tasks.transition import PlanStep
from neurosym.world import Outcome, Scene

LIFT, PUSH = PlanStep("lift-010-block", "item-01"), PlanStep("push-left-000-block", "item-01")


def outcome(
    effect: tuple[float, float, float], *, held: bool = False, touched: tuple[int, ...] = ()
) -> Outcome:
    def scene(by: tuple[float, float, float]) -> Scene:
        return Scene(np.zeros((1, 4)), np.array([by]), np.array([[0.0, 0.0, 0.0, 1.0]]))

    down = (effect[0], effect[1], 0.0)
    ends = (scene(one) for one in ((0.0, 0.0, 0.0), effect, down))
    return Outcome(*ends, 0, held, False, False, effect[2], touched)


NOTHING = outcome((0.0, 0.0, 0.0))


def after(step: PlanStep, *outcomes: Outcome, learned: Grounding | None = None) -> Experience:
    """The experience of one step that came out so, again and again."""
    experience = Experience(learned or grounding())
    for one in outcomes:
        experience.learn(step, one)
    return experience


def own(experience: Experience, step: PlanStep = LIFT, task: Problem | None = None) -> Operator:
    """What is believed of a step's operator with its object."""
    item = experience.believed(task or problem()).object_named(step.object)
    return promised(experience.grounding, item)[step.operator]


def gives_up(experience: Experience) -> bool:
    """Whether the lift is not tried again."""
    item = experience.believed(problem()).object_named(LIFT.object)
    return LIFT.operator not in [one.name for one in usable(experience.grounding, item)]


def test_object_that_was_acted_upon_is_promised_what_it_did():
    experience = after(PUSH, outcome((0.0, 0.07, 0.0)))
    before = grounding().operator_named(PUSH.operator)
    assert 0.07 < grounding().displacement(own(experience, PUSH))[1] < grounding().displacement(before)[1]
    assert own(experience, PUSH).successes > before.successes
    other = replace(experience.believed(problem()).object_named(PUSH.object), past=UNSET)
    assert promised(grounding(), other)[PUSH.operator] == before


def test_the_more_is_seen_the_less_counts_what_was_promised():
    promises = [own(after(PUSH, *[outcome((0.0, 0.05, 0.0))] * times), PUSH).promise for times in range(1, 6)]
    away = [promise.outcome[1] - 0.05 for promise in promises if promise]
    assert len(away) == 5
    assert sorted(away, reverse=True) == away
    assert away[0] > away[-1] > 0


def test_what_scatters_is_promised_less_surely_and_more_widely():
    steady, scattered = (
        own(after(PUSH, *[outcome((0.0, y, 0.0)) for y in ends]), PUSH)
        for ends in ((0.1, 0.1, 0.1, 0.1), (0.02, 0.2, 0.02, 0.2))
    )
    assert scattered.chance < 0.5 < steady.chance
    assert scattered.promise.resting_spread[1] > 4 * steady.promise.resting_spread[1]


def test_what_came_last_counts_most():
    seen = [*[outcome((0.0, 0.08, 0.0))] * 3, outcome((0.0, 0.05, 0.0))]
    (late, early) = (own(after(PUSH, *rows), PUSH).promise for rows in (seen, seen[::-1]))
    assert late.outcome[1] < 0.065 < early.outcome[1]


def test_what_failed_twice_in_a_row_is_not_tried_again():
    once, twice = after(LIFT, NOTHING), after(LIFT, NOTHING, NOTHING)
    assert own(once).successes < grounding().operator_named(LIFT.operator).successes
    assert grounding().displacement(own(twice)) == (0.0, 0.0, 0.0)  # which is what it did
    assert gives_up(twice)
    twice.learn(PUSH, NOTHING)
    hoping = twice.hoping_again(problem())  # but not for what failed twice the same way
    assert gives_up(hoping)
    assert own(hoping, PUSH).successes == grounding().operator_named(PUSH.operator).successes
    again = once.hoping_again(problem())
    assert own(again).outcomes == grounding().operator_named(LIFT.operator).outcomes
    assert Experience(grounding()).believed(problem()) == problem()
    again.learn(LIFT, NOTHING)
    assert gives_up(again.hoping_again(problem()))


def test_what_came_twice_in_its_place_is_promised_instead():
    lift = own(after(LIFT, outcome((0.03, 0.0, 0.0)), outcome((0.04, 0.0, 0.0))))
    x, y, z = grounding().displacement(lift)
    assert (0.035 < x < 0.04, y, z) == (True, 0.0, 0.0)
    assert not is_lift(lift)
    assert lift.successes > lift.trials / 2


def test_what_failed_is_hoped_for_once_the_object_lies_otherwise():
    turned = (0.0, 0.0, math.sin(0.5), math.cos(0.5))
    item = replace(problem().objects[0], orientation=turned)
    now = replace(problem(), objects=(item, *problem().objects[1:]))
    before = grounding().operator_named(LIFT.operator)
    assert own(after(LIFT, NOTHING, NOTHING), task=now).successes == before.successes


def test_a_failure_says_less_where_others_were_in_the_way():
    alone, crowded = (own(after(LIFT, outcome((0.0, 0.0, 0.0), touched=touched))) for touched in ((), (1,)))
    before = grounding().operator_named(LIFT.operator)
    chances = [one.successes / one.trials for one in (alone, crowded, before)]
    assert chances[0] < 0.6 * chances[1] < 0.6 * chances[2]


def test_what_was_seen_of_an_object_that_lay_turned_holds_for_any_angle():
    """A push to the left of what lies turned by 0.5 rad; it is promised so wherever that points."""
    learned = replace(grounding(), turned=True)
    lay = np.array([[0.0, 0.0, math.sin(0.25), math.cos(0.25)]])
    seen = outcome((-0.07 * math.sin(0.5), 0.07 * math.cos(0.5), 0.0))
    start = Scene(seen.start.features, seen.start.positions, lay)
    experience = after(PUSH, dataclasses.replace(seen, start=start), learned=learned)
    straight = after(PUSH, outcome((0.0, 0.07, 0.0)), learned=learned)
    for believed in (experience, straight):
        promise = own(believed, PUSH).promise
        assert promise is not None
        assert promise.resting_effect == pytest.approx(own(straight, PUSH).promise.resting_effect, abs=1e-9)
