"""The domain with durative actions: what it says, who reads it, and that its plans come true."""

import math
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import toy_domain
import toy_relations
from msgspec.structs import replace
from places import ROOT
from toy_places import NAME, grounding, mixed, scene, swap
from validators import quiet

from neurosym.contract import way_seconds
from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.pddl import durative
from neurosym.pddl.durative import CARRY, carry_seconds, durative_domain_text, durative_problem_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.problems import Problem
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep
from neurosym.world import Place, Scene, Table

PLAN = """0.000: (carry item-02 start-item-02 park-01 nowhere nowhere nowhere) [6.100]
6.101: (carry item-01 start-item-01 goal-item-01 start-item-02 nowhere nowhere) [6.100]
12.202: (carry item-02 park-01 goal-item-02 start-item-01 nowhere nowhere) [6.100]
"""
"""A plan for the swap as Kairos, PlanSys2's planner, writes it."""
PLACES = Grounding.load(ROOT / "domains/places/grounding.json")


def test_unified_planning_reads_types_and_durations_and_accepts_a_plan():
    with quiet():
        from unified_planning.io import PDDLReader
        from unified_planning.model import DurativeAction
        from unified_planning.shortcuts import PlanValidator

        reader = PDDLReader()
        texts = durative_domain_text(grounding()), durative_problem_text(swap(), grounding())
        task = reader.parse_problem_string(*texts)
        (action,) = task.actions
        assert isinstance(action, DurativeAction)
        assert action.duration.lower == action.duration.upper
        assert action.duration.lower.constant_value() == Fraction(61, 10)
        kinds = [str(parameter.type).split(" - ")[0] for parameter in action.parameters]
        assert action.name == CARRY
        assert kinds == ["thing", *["place"] * (2 + durative.MOST_OVER)]
        assert {str(one.type).split(" - ")[0] for one in task.all_objects} == {"cube", "place"}
        with PlanValidator(name="up_time_triggered_validator") as validator:
            assert validator.validate(task, reader.parse_plan_string(task, PLAN))
            too_soon = PLAN.replace("6.101:", "6.000:")
            assert not validator.validate(task, reader.parse_plan_string(task, too_soon))
            in_the_way = "\n".join(PLAN.splitlines()[1:])
            assert not validator.validate(task, reader.parse_plan_string(task, in_the_way))


def test_plan_of_a_temporal_planner_is_read_and_comes_true_and_no_other_action_is_a_carry():
    problem, learned = swap(), grounding()
    steps = parse_plan(PLAN, Path("plan"), learned, problem)
    assert steps[1] == PlanStep(NAME, "item-01", "goal-item-01")
    run = execute(toy_domain.WORLD, problem, learned, steps)
    assert (run.reached, run.replans) == (True, 0)
    carry = (CARRY, "item-02", "start-item-02", "park-01", *["nowhere"] * durative.MOST_OVER)
    for words in (("push", *carry[1:]), carry[:-1], (CARRY, "item-09", *carry[2:])):
        with pytest.raises(InvalidValue, match="nothing carries that"):
            list(durative.read_durative([words], understand(problem, learned)))


STACK = replace(toy_relations.sorting(), relations=())


@pytest.mark.parametrize(
    ("problem", "learned", "said"),
    [
        (mixed(), grounding(), "item-02 cannot be carried to where it shall be, so mixed has no"),
        (toy_domain.problem({}), toy_domain.grounding(), "Nothing in the domain toy carries objects"),
        (toy_relations.tower(), toy_relations.grounding(), "tower has goals by relation, or begins with"),
        (STACK, toy_relations.grounding(), "sorting has goals by relation, or begins with one object"),
    ],
)
def test_what_cannot_be_carried_has_no_durative_form(problem: Problem, learned: Grounding, said: str):
    with pytest.raises(InvalidValue, match=said):
        durative_problem_text(problem, learned)


CROWD = [("cube", 0.5, -0.2), *[("cube", 0.7 + dx, dy) for dx in (-0.03, 0.03) for dy in (-0.03, 0.03)]]
SHELVES = {"tray": (0.8, 0.11), "shelf": (0.8, 0.1), "park-here": (0.6, 0.2)}


@pytest.mark.parametrize(
    ("objects", "goal", "places", "said"),
    [
        ([("cube", 0.5, -0.1)], (0.5, -0.1), {}, r"\(:goal \(and \(stands item-01 start-item-01\)\)\)"),
        ([("cube", 0.5, -0.1)], (0.8, 0.1), SHELVES, r"\(:goal \(and \(stands item-01 shelf\)\)\)"),
        (CROWD[:-1], (0.7, 0.0), {}, r"\(room item-01 goal-item-01( start-item-0[234]){3}\)"),
        (CROWD, (0.7, 0.0), {}, r"\(free goal-item-01\)\n"),  # more than an action can name
    ],
    ids=["stays", "at a named place", "over three", "over too many"],
)
def test_problem_says_where_an_object_shall_stand_and_what_must_leave_before(objects, goal, places, said):
    problem = Problem("p", scene(*objects), {"item-01": (*goal, 0.025)}, 0.02, places=places)
    assert re.search(said, durative_problem_text(problem, grounding()))


def test_seconds_that_somebody_measured_are_printed_instead():
    assert ":duration (= ?duration 4.200)" in durative_domain_text(grounding(), 4.2)
    with pytest.raises(InvalidValue, match=r"takes 0 s; valid: at least 0\.001 s"):
        durative_domain_text(grounding(), 0.0)


def test_carrying_in_the_simulator_takes_no_longer_than_is_said(monkeypatch):
    """What is measured is what the hand does; the world settles besides."""
    world, operator = Tabletop(), PLACES.live_on("place")[0]
    settling, simulations, settle = [0], [], Simulation.settle

    def counted(simulation: Simulation) -> None:
        before = simulation.ticks
        settle(simulation)
        settling[0] += simulation.ticks - before
        simulations.append(simulation)

    monkeypatch.setattr(Simulation, "settle", counted)
    start, place = (0.47, -0.18), (0.83, 0.18)
    mean = PLACES.category(operator.subject).feature_means
    features, position = np.array([[*mean[:3], round(mean[3])]]), np.array([[*start, mean[2] / 2]])
    alone = Scene(features, position, np.array([[0.0, 0.0, 0.0, 1.0]]))
    action = np.array(PLACES.primitive_of(operator).action)
    assert world.interact(alone, action, 0, reference=Place(*place)).carried
    ticks = simulations[-1].ticks - settling[0]
    diagonal = way_seconds(math.hypot(0.6, 0.6))
    said = carry_seconds(operator, PLACES) - diagonal + way_seconds(math.dist(start, place))
    for table in (Table((0.4, 1.5), PLACES.table.y), Table(PLACES.table.x, (-0.8, 0.8))):
        assert carry_seconds(operator, replace(PLACES, table=table)) > carry_seconds(operator, PLACES)
    assert said - 1.5 < ticks * world.config.time_step <= said


def test_shipped_domain_with_places_is_printed_for_each_problem_that_only_carries():
    slowest = max(carry_seconds(one, PLACES) for one in PLACES.live_on("place"))
    assert f":duration (= ?duration {slowest:.3f})" in durative_domain_text(PLACES)
    printed = 0
    for path in sorted((ROOT / "domains/places/problems").glob("*.scene.json")):
        problem = Problem.load(path)
        if {*problem.goals} - {*understand(problem, PLACES).carried}:
            with pytest.raises(InvalidValue, match="cannot be carried to where it shall be"):
                durative_problem_text(problem, PLACES)
            continue
        text = durative_problem_text(problem, PLACES)
        assert {*problem.goals} <= {*re.findall(r"\(can-carry (\S+)\)", text)}
        printed += 1
    assert printed == 13
