"""Experience: an object that was acted upon is believed to do again what it was last seen to do."""

import numpy as np
from tables import grounding, problem

from neurosym.execution.experience import Experience, believed_name, learned_name
from neurosym.pddl.plan_text import PlanStep
from neurosym.world import Outcome, Scene

LIFT, PUSH = PlanStep("lift-010-block", "item-01"), PlanStep("push-left-000-block", "item-01")


def outcome(effect: tuple[float, float, float], *, held: bool = False) -> Outcome:
    def scene(by: tuple[float, float, float]) -> Scene:
        return Scene(np.zeros((1, 4)), np.array([by]), np.array([[0.0, 0.0, 0.0, 1.0]]))

    down = (effect[0], effect[1], 0.0)
    return Outcome(scene((0.0, 0.0, 0.0)), scene(effect), scene(down), 0, held, False, False, effect[2])


def test_nothing_seen_changes_nothing():
    assert Experience(grounding()).believed(problem()) == (problem(), grounding())


def test_object_that_was_acted_upon_gets_a_category_of_its_own():
    experience = Experience(grounding())
    experience.learn(PUSH, outcome((0.0, 0.04, 0.0)))
    believed, learned = experience.believed(problem())
    assert [thing.category for thing in believed.objects] == ["00-of-item-01", "11"]
    own = learned.operator_named("push-left-000-block-of-item-01")
    assert learned.displacement(own) == (0.0, 0.04, 0.0)
    assert own.successes == own.trials
    assert learned.operator_named("push-left-000-block") == grounding().operator_named("push-left-000-block")


def test_outcome_that_does_not_come_is_hoped_for_half_as_much_each_time():
    experience, chances = Experience(grounding()), []
    for _ in range(4):
        experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
        _, learned = experience.believed(problem())
        chances.append(learned.operator_named("lift-010-block-of-item-01").successes)
    assert chances == [7, 3, 1, 0]
    assert "lift-010-block-of-item-01" in learned.left_out


def test_what_came_once_is_hoped_for_as_it_came():
    experience = Experience(grounding())
    experience.learn(LIFT, outcome((0.03, 0.0, 0.19), held=True))
    experience.learn(LIFT, outcome((0.0, 0.0, 0.0)))
    _, learned = experience.believed(problem())
    lift = learned.operator_named("lift-010-block-of-item-01")
    assert learned.displacement(lift) == (0.03, 0.0, 0.19)
    assert lift.successes == 7


def test_names_of_steps_lead_there_and_back():
    experience = Experience(grounding())
    experience.learn(PUSH, outcome((0.0, 0.04, 0.0)))
    _, learned = experience.believed(problem())
    put_down = PlanStep("put-down-lift-010-block", "item-01")
    for step in (PUSH, put_down):
        own = believed_name(step, learned)
        assert own.operator == f"{step.operator}-of-item-01"
        assert learned_name(own) == step
    stranger = PlanStep("push-left-000-tray", "item-02")
    assert believed_name(stranger, learned) == stranger == learned_name(stranger)
