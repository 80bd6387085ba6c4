"""Plans with relations come true in the toy world, are watched, and are made anew."""

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace
from toy_relations import PUT_ON, REST, WORLD, grounding, scene, sorting, tower, tower_at_place

from neurosym.execution.executor import execute
from neurosym.execution.performance import compare_runs, rerun
from neurosym.execution.record import Run
from neurosym.planners import PlanStatus, plan, planner_named
from neurosym.problems import Problem
from neurosym.stages.execution import replanning
from neurosym.tasks.transition import PlanStep
from neurosym.worlds.aims import Aimed


def planned(problem: Problem) -> tuple[PlanStep, ...]:
    result = plan(problem, grounding())
    assert result.has_plan, result.reason
    return result.steps


def replanner(problem, learned):
    return plan(problem, learned)


class Spoiled(Aimed):
    """The toy world, in which some interactions, counted from 1, go otherwise."""

    def __init__(self, *spoiled: int, aside: float = 0.0):
        super().__init__(WORLD)
        self.spoiled, self.aside, self.count = spoiled, aside, 0

    def interact(self, scene, action, target, **options):
        """Act, by another action if it is time to."""
        self.count += 1
        if self.count in self.spoiled or not self.spoiled:
            action = np.array(action)
            action[8:10] += self.aside
            action[7] = 0.0 if self.aside else 1.0
        return WORLD.interact(scene, action, target, **options)


FULL = Problem(
    "full",
    scene(("tray", 0.8, 0.0), ("cube", 0.8, 0.0, 0.01), ("block", 0.5, 0.1)),
    {"item-01": (0.5, -0.1, 0.03)},
    0.02,
    relations=(("item-02", "item-03", REST),),
)
"""A tray to be emptied for what is to come there."""
UNDER = Problem(
    "under",
    scene(("cube", 0.5, 0.0, 0.05), ("cube", 0.5, 0.0, 0.1), ("block", 0.5, 0.0)),
    {"item-03": (0.8, 0.0, 0.025)},
    0.02,
)
"""No goal by relation, but it starts with a stack."""


@pytest.mark.parametrize(
    "problem", [tower(), tower_at_place(), sorting(), FULL, UNDER], ids=lambda one: one.name
)
def test_plans_come_true_in_the_world_and_again_from_the_record(problem):
    run = execute(WORLD, problem, grounding(), planned(problem), replanner=replanner)
    assert run.reached, run.reason
    assert run.unmet == (() if problem.relations else msgspec.UNSET)
    assert run.replans == 0
    assert all(record.as_promised for record in run.steps)
    again = rerun(WORLD, problem, grounding(), run)
    assert compare_runs(run, again).course == "same bytes"
    assert msgspec.json.decode(msgspec.json.encode(run), type=Run) == run


def test_steps_tell_the_states_of_pairs_and_what_bears_what():
    first, last = execute(WORLD, tower(), grounding(), planned(tower())).steps
    assert (first.object, first.place) == ("item-03", "item-02")
    assert first.promised_state == first.state == REST
    assert first.relations == {"item-03": f"{REST} item-02"}
    assert last.relations == {"item-01": f"{REST} item-03", "item-03": f"{REST} item-02"}
    assert last.reference.index == 2
    assert last.effect == pytest.approx((0.0, 0.0, 0.05))
    assert last.deviation == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("step", "aside", "happened"),
    [(1, 0.0, ["missed", "carried", "carried"]), (2, 0.06, None), (2, 0.9, None)],
)
def test_step_that_goes_wrong_is_planned_again_unless_the_object_is_lost(step, aside, happened):
    run = execute(Spoiled(step, aside=aside), tower(), grounding(), planned(tower()), replanner=replanner)
    assert not run.steps[step - 1].as_promised
    assert happened in (None, [record.happened for record in run.steps])
    if aside == 0.9:
        assert run.ended == "lost"
        assert "step 2 threw item-01 off the table" in run.reason
    else:
        assert run.reached, run.reason
        assert len(run.steps) >= 3


def test_no_new_plan_from_off_the_table_is_a_result():
    first, *others = tower().objects
    off = replace(first, position=(5.0, 0.0, first.position[2]))
    problem = replace(tower(), objects=(off, *others))
    result = replanning(planner_named("fast-downward"))(problem, grounding())
    assert result.status is PlanStatus.FAILED
    assert "off the table" in result.reason


def test_blind_run_says_which_relation_is_missed_and_since_which_step():
    steps = [*planned(tower()), PlanStep("carry-to-01-cube", "item-01", "park-01")]
    run = execute(WORLD, tower(), grounding(), steps)
    assert not run.reached
    assert run.unmet == (("item-01", "item-03", REST),)
    assert run.reason.startswith(
        f"item-01 is borne by nothing, not {REST} item-03 as after step 2: that ended in step 3; "
    )


def test_pair_that_failed_again_and_again_is_given_up():
    world = Spoiled()
    run = execute(world, tower(), grounding(), planned(tower()), replanner=replanner)
    assert not run.reached
    assert 4 <= len(run.steps) <= 5
    assert run.ended == "no plan"
    assert "no operator brings item-03 to rests-on-001 with item-02" in run.reason


def test_after_an_operator_failed_twice_with_a_pair_another_one_is_tried():
    learned = grounding()
    first = learned.relations.operators[0]
    (end,) = first.outcomes
    second = replace(first, name="second", variant="b", outcomes=(replace(end, count=18, near_mean=18),))
    motions = (*learned.relations.primitives, replace(learned.relations.primitives[0], variant="b"))
    operators = (first, second, *learned.relations.operators[1:])
    both = replace(learned.relations, primitives=motions, operators=operators)
    learned = replace(learned, relations=both)
    steps = plan(tower(), learned).steps
    run = execute(Spoiled(1, 2), tower(), learned, steps, replanner=replanner)
    of_pair = [step.operator for step in run.steps if step.object == "item-03"]
    assert of_pair == [PUT_ON, PUT_ON, "second"]
    assert run.reached


class Stubborn(Aimed):
    """The toy world, in which the object that is acted upon at first cannot be grasped."""

    def __init__(self) -> None:
        super().__init__(WORLD)
        self.never: int | None = None

    def interact(self, scene, action, target, **options):
        """Act, with an open hand if it is to fail."""
        self.never = target if self.never is None else self.never
        action = np.array(action)
        action[7] = 1.0 if target == self.never else action[7]
        return WORLD.interact(scene, action, target, **options)


TWO = Problem(
    "two",
    scene(("cube", 0.5, -0.2), ("block", 0.5, 0.1), ("cube", 0.7, -0.1), ("block", 0.8, 0.15)),
    {},
    0.02,
    relations=(("item-01", "item-02", REST), ("item-03", "item-04", REST)),
)
"""Two pairs that have nothing to do with each other."""


def test_pair_that_fails_does_not_keep_others_from_being_put_together():
    run = execute(Stubborn(), TWO, grounding(), planned(TWO), replanner=replanner)
    assert len(run.unmet) == 1
    assert [record.object for record in run.steps if record.as_promised] == [
        next(name for name in ("item-01", "item-03") if name != run.unmet[0][0])
    ]


@pytest.mark.parametrize(("share", "tries"), [(0.9, 4), (0.2, 1)])
def test_what_is_hardly_foreseen_of_a_pair_is_tried_once(share, tries):
    pair = Problem("pair", TWO.objects[:2], {}, 0.02, relations=TWO.relations[:1])
    known = replace(pair, pairs={"item-01 item-02": "01"}, foreseen={"item-01 item-02": {PUT_ON: share}})
    run = execute(Spoiled(), known, grounding(), planned(known), replanner=replanner)
    assert len(run.steps) == tries
