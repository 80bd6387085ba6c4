"""Experience: an object that was acted upon is believed to do again what it was last seen to do."""

import math

import msgspec
import numpy as np
import pytest
from tables import grounding, problem

from neurosym.execution.experience import Experience, believed_name, learned_name
from neurosym.grounding import Grounding, is_lift
from neurosym.tasks.steps import PlanStep
from neurosym.world import Outcome, Scene

LIFT, PUSH = PlanStep("lift-010-block", "item-01"), PlanStep("push-left-000-block", "item-01")


def outcome(
    effect: tuple[float, float, float], *, held: bool = False, touched: tuple[int, ...] = ()
) -> Outcome:
    def scene(by: tuple[float, float, float]) -> Scene:
        return Scene(np.zeros((1, 4)), np.array([by]), np.array([[0.0, 0.0, 0.0, 1.0]]))

    down = (effect[0], effect[1], 0.0)
    return Outcome(
        scene((0.0, 0.0, 0.0)), scene(effect), scene(down), 0, held, False, False, effect[2], touched
    )


def with_chance(learned: Grounding, name: str, share: float) -> Grounding:
    """Have an operator keep its promise in a share of its trials only."""
    operators = []
    for one in learned.operators.operators:
        if one.name == name:
            kept = round(share * one.trials)
            modes = tuple(
                msgspec.structs.replace(mode, count=kept, share=share, near_mean=kept) for mode in one.modes
            )
            one = msgspec.structs.replace(one, modes=modes)
        operators.append(one)
    table = msgspec.structs.replace(learned.operators, operators=tuple(operators))
    return msgspec.structs.replace(learned, operators=table)


def test_nothing_seen_changes_nothing():
    assert Experience(grounding()).believed(problem()) == (problem(), grounding())


def test_object_that_was_acted_upon_gets_a_category_of_its_own():
    experience = Experience(grounding())
    experience.learn(PUSH, outcome((0.0, 0.07, 0.0)))
    believed, learned = experience.believed(problem())
    assert [thing.category for thing in believed.objects] == ["00-of-item-01", "11"]
    own = learned.operator_named("push-left-000-block-of-item-01")
    before = grounding().operator_named("push-left-000-block")
    assert 0.07 < learned.displacement(own)[1] < grounding().displacement(before)[1]
    assert own.successes > before.successes
    assert learned.operator_named("push-left-000-block") == before


def test_the_more_is_seen_the_less_counts_what_was_promised():
    experience, away = Experience(grounding()), []
    for _ in range(5):
        experience.learn(PUSH, outcome((0.0, 0.05, 0.0)))
        own = experience.believed(problem())[1].operator_named("push-left-000-block-of-item-01")
        assert own.promise is not None
        away.append(own.promise.outcome[1] - 0.05)
    assert sorted(away, reverse=True) == away
    assert away[0] > 2 * away[-1] > 0


def test_what_failed_twice_in_a_row_is_not_tried_again():
    experience, chances = Experience(grounding()), []
    for _ in range(2):
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
        _, learned = experience.believed(problem())
        chances.append(learned.operator_named("lift-010-block-of-item-01").successes)
    before = grounding().operator_named("lift-010-block").successes
    assert chances[0] < before
    lift = learned.operator_named("lift-010-block-of-item-01")
    assert learned.displacement(lift) == (0.0, 0.0, 0.0)  # which is what it did
    assert lift.name in learned.left_out


def test_what_came_twice_in_its_place_is_promised_instead():
    experience = Experience(grounding())
    for away in (0.03, 0.04):
        experience.learn(LIFT, outcome((away, 0.0, 0.0)))
    _, learned = experience.believed(problem())
    lift = learned.operator_named("lift-010-block-of-item-01")
    assert learned.displacement(lift) == pytest.approx((0.035, 0.0, 0.0))
    assert not is_lift(lift)
    assert lift.successes > lift.trials / 2


def test_what_failed_is_hoped_for_once_the_object_lies_otherwise():
    experience, turned = Experience(grounding()), (0.0, 0.0, math.sin(0.5), math.cos(0.5))
    for _ in range(2):
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    item = msgspec.structs.replace(problem().objects[0], orientation=turned)
    now = msgspec.structs.replace(problem(), objects=(item, *problem().objects[1:]))
    _, learned = experience.believed(now)
    own = learned.operator_named("lift-010-block-of-item-01")
    assert own.successes == grounding().operator_named("lift-010-block").successes


def test_hoping_again_does_not_hope_for_what_failed_twice_the_same_way():
    experience = Experience(grounding())
    for _ in range(2):
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    experience.learn(PUSH, outcome((0.0, 0.0, 0.0)))
    hoping = experience.hoping_again(problem())
    _, learned = hoping.believed(problem())
    assert "lift-010-block-of-item-01" in learned.left_out
    own = learned.operator_named("push-left-000-block-of-item-01")
    assert own.successes == grounding().operator_named("push-left-000-block").successes
    assert not Experience(grounding()).hoping_again(problem()).says_something


def test_what_fails_again_after_hoping_again_is_given_up():
    experience = Experience(grounding())
    for _ in range(2):
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
        experience = experience.hoping_again(problem())
    _, learned = experience.believed(problem())
    assert "lift-010-block-of-item-01" in learned.left_out


def test_what_was_unlikely_before_and_failed_once_is_given_up():
    rare = with_chance(grounding(), "lift-010-block", 0.5)
    experience = Experience(rare)
    experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    for now in (experience, experience.hoping_again(problem())):
        assert "lift-010-block-of-item-01" in now.believed(problem())[1].left_out


def test_a_failure_says_less_where_others_were_in_the_way():
    chances = []
    for touched in ((), (1,)):
        experience = Experience(grounding())
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0), touched=touched))
        own = experience.believed(problem())[1].operator_named("lift-010-block-of-item-01")
        chances.append(own.successes / own.trials)
    before = grounding().operator_named("lift-010-block")
    assert chances[0] < 0.6 * chances[1] < 0.6 * before.successes / before.trials


def test_what_was_forgotten_does_not_stand_against_what_has_not_failed_twice():
    experience = Experience(grounding())
    experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    hoping = experience.hoping_again(problem())
    assert hoping.believed(problem()) == (problem(), grounding())
    hoping.learn(LIFT, outcome((0.0, 0.0, 0.2), held=True))
    hoping.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    _, learned = hoping.believed(problem())
    assert learned.operator_named("lift-010-block-of-item-01").successes > 0


def test_what_came_once_is_hoped_for_as_it_came():
    experience = Experience(grounding())
    experience.learn(LIFT, outcome((0.03, 0.0, 0.19), held=True))
    once = experience.believed(problem())[1].operator_named("lift-010-block-of-item-01")
    experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    twice = experience.believed(problem())[1].operator_named("lift-010-block-of-item-01")
    assert once.modes[0].outcome == twice.modes[0].outcome
    assert once.successes > twice.successes > 0


def test_names_of_steps_lead_there_and_back():
    experience = Experience(grounding())
    experience.learn(PUSH, outcome((0.0, 0.04, 0.0)))
    believed, learned = experience.believed(problem())
    put_down = PlanStep("put-down-lift-010-block", "item-01")
    for step in (PUSH, put_down):
        own = believed_name(step, believed, learned)
        assert own.operator == f"{step.operator}-of-item-01"
        assert learned_name(own) == step
    stranger = PlanStep("push-left-000-tray", "item-02")
    assert believed_name(stranger, believed, learned) == stranger == learned_name(stranger)
