"""The domain with durative actions: what it says, who reads it, and that its plans come true."""

import math
import re
import warnings
from fractions import Fraction
from pathlib import Path

import msgspec
import numpy as np
import pytest
import toy_domain
import toy_relations
from places import GOLDEN, ROOT
from toy_places import NAME, grounding, mixed, scene, swap

from neurosym.contract import way_seconds
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.operators import Primitive
from neurosym.pddl.compiler import problem_text
from neurosym.pddl.durative import (
    CARRY,
    MOST_OVER,
    carry_seconds,
    durative_domain_text,
    durative_problem_text,
    read_durative,
)
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.strips_plan import Misread
from neurosym.problems import Problem
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.tasks.options import carriers_of
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep
from neurosym.world import Place, Scene

PLAN = """0.000: (carry item-02 start-item-02 park-01 nowhere nowhere nowhere) [6.100]
6.101: (carry item-01 start-item-01 goal-item-01 start-item-02 nowhere nowhere) [6.100]
12.202: (carry item-02 park-01 goal-item-02 start-item-01 nowhere nowhere) [6.100]
"""
"""A plan for the swap as Kairos, PlanSys2's planner, writes it."""
PLACES = Grounding.load(ROOT / "domains/places/grounding.json")


def texts() -> dict[str, str]:
    """The domain and a problem, as they are printed."""
    problem = durative_problem_text(swap(), grounding())
    return {"domain-durative.pddl": durative_domain_text(grounding()), "swap.durative.pddl": problem}


@pytest.mark.parametrize("name", ["domain-durative.pddl", "swap.durative.pddl"])
def test_text_is_the_golden_one_to_the_letter(name):
    """Run this file as a program to write the golden files anew."""
    assert texts()[name] == (GOLDEN / name).read_text()


def test_unified_planning_reads_types_and_durations_and_accepts_a_plan():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from unified_planning.io import PDDLReader
        from unified_planning.model import DurativeAction
        from unified_planning.shortcuts import PlanValidator

        reader = PDDLReader()
        task = reader.parse_problem_string(*texts().values())
        (action,) = task.actions
        assert isinstance(action, DurativeAction)
        assert action.duration.lower == action.duration.upper
        assert action.duration.lower.constant_value() == Fraction(61, 10)
        kinds = [str(parameter.type).split(" - ")[0] for parameter in action.parameters]
        assert action.name == CARRY
        assert kinds == ["thing", *["place"] * (2 + MOST_OVER)]
        assert {str(one.type).split(" - ")[0] for one in task.all_objects} == {"cube", "place"}
        with PlanValidator(name="up_time_triggered_validator") as validator:
            assert validator.validate(task, reader.parse_plan_string(task, PLAN))
            too_soon = PLAN.replace("6.101:", "6.000:")
            assert not validator.validate(task, reader.parse_plan_string(task, too_soon))
            in_the_way = "\n".join(PLAN.splitlines()[1:])
            assert not validator.validate(task, reader.parse_plan_string(task, in_the_way))


def test_plan_of_a_temporal_planner_is_read_and_comes_true():
    problem, learned = swap(), grounding()
    steps = parse_plan(PLAN, Path("plan"), learned, problem)
    assert steps[1] == PlanStep(NAME, "item-01", "goal-item-01")
    run = execute(toy_domain.WORLD, problem, learned, steps)
    assert run.reached
    assert run.replans == 0


def test_no_other_action_is_read_as_a_carry():
    task = understand(swap(), grounding())
    carry = (CARRY, "item-02", "start-item-02", "park-01", *["nowhere"] * MOST_OVER)
    assert read_durative([carry], task) == (PlanStep(NAME, "item-02", "park-01"),)
    for words in (("push", *carry[1:]), carry[:-1], (CARRY, "item-09", *carry[2:])):
        with pytest.raises(Misread, match="nothing carries that"):
            read_durative([words], task)


def test_nothing_is_asked_for_that_plansys2_does_not_take():
    domain, problem = (re.sub(r";.*", "", text) for text in texts().values())
    assert re.findall(r":requirements ([^)]*)", domain) == [":strips :typing :durative-actions"]
    for section in (":functions", ":constants", ":action ", "total-cost", "-number"):
        assert section not in domain + problem
    conditions = re.findall(r":condition .*", domain)
    assert conditions
    assert not any("(not" in line for line in conditions)
    assert not re.search(r"\s-\d", domain + problem)
    predicates = domain.split("(:predicates")[1].split("(:durative-action")[0].strip().splitlines()
    assert all(line.count("(") == 1 for line in predicates)  # PlanSys2 joins domains line by line


def test_what_cannot_be_carried_has_no_durative_form():
    with pytest.raises(InvalidValue, match="item-02 cannot be carried to where it shall be, so mixed has no"):
        durative_problem_text(mixed(), grounding())
    with pytest.raises(InvalidValue, match="Nothing in the domain toy carries objects"):
        durative_domain_text(toy_domain.grounding())
    with pytest.raises(InvalidValue, match="Nothing in the domain toy carries objects"):
        durative_problem_text(toy_domain.problem({}), toy_domain.grounding())


def test_goals_by_relation_have_no_durative_form():
    begun = msgspec.structs.replace(toy_relations.sorting(), relations=())
    for problem in (toy_relations.tower(), begun):
        with pytest.raises(
            InvalidValue, match=f"{problem.name} has goals by relation, or begins with one object"
        ):
            durative_problem_text(problem, toy_relations.grounding())
    asked = msgspec.structs.replace(swap(), goals={}, relations=(("item-01", "item-02", "00"),))
    with pytest.raises(InvalidValue, match="swap is one of relations, and the domain toy has learned none"):
        durative_problem_text(asked, grounding())


def test_object_at_its_goal_may_stay_where_it_starts():
    stays = Problem("stays", scene(("cube", 0.5, -0.1)), {"item-01": (0.5, -0.1, 0.025)}, 0.02)
    assert "(:goal (and (stands item-01 start-item-01)))" in durative_problem_text(stays, grounding())


def test_named_place_near_a_goal_is_where_the_object_shall_stand():
    places = {"tray": (0.8, 0.11), "shelf": (0.8, 0.1), "park-here": (0.6, 0.2)}
    named = msgspec.structs.replace(swap(), goals={"item-01": (0.8, 0.1, 0.025)}, places=places)
    assert "(:goal (and (stands item-01 shelf)))" in durative_problem_text(named, grounding())


def test_place_under_more_objects_than_can_be_named_is_not_carried_to():
    crowd = [("cube", 0.7 + dx, dy) for dx in (-0.03, 0.03) for dy in (-0.03, 0.03)]
    problem = Problem("crowd", scene(("cube", 0.5, -0.2), *crowd), {"item-01": (0.7, 0.0, 0.025)}, 0.02)
    text = durative_problem_text(problem, grounding())
    assert "(free goal-item-01)\n" in text
    three = msgspec.structs.replace(problem, objects=problem.objects[:-1])
    assert re.search(
        r"\(room item-01 goal-item-01( start-item-0[234]){3}\)", durative_problem_text(three, grounding())
    )


def test_seconds_that_somebody_measured_are_printed_instead():
    assert ":duration (= ?duration 4.200)" in durative_domain_text(grounding(), {NAME: 4.2})
    with pytest.raises(InvalidValue, match=r"takes 0 s; valid: at least 0\.001 s"):
        durative_domain_text(grounding(), {NAME: 0.0})
    with pytest.raises(UnknownChoice, match="no operator 'carry'; valid: carry-to-01-cube"):
        durative_domain_text(grounding(), {"carry": 1.0})


def test_action_that_is_not_three_waypoints_needs_seconds():
    learned = grounding()
    places = learned.places
    strange = (Primitive("01", (0.0, 0.1), 0.0),)
    operators = msgspec.structs.replace(places.operators, primitives=strange)
    learned = msgspec.structs.replace(learned, places=msgspec.structs.replace(places, operators=operators))
    with pytest.raises(InvalidValue, match=f"How long {NAME} takes cannot be known"):
        durative_domain_text(learned)
    assert "(= ?duration 3.000)" in durative_domain_text(learned, {NAME: 3.0})


def test_carrying_in_the_simulator_takes_no_longer_than_is_said(monkeypatch):
    """What is measured is what the hand does; the world settles besides."""
    world, operator = Tabletop(), carriers_of(PLACES)[0]
    settling, simulations = [0], []
    settle = Simulation.settle

    def counted(simulation: Simulation) -> None:
        before = simulation.ticks
        settle(simulation)
        settling[0] += simulation.ticks - before
        simulations.append(simulation)

    monkeypatch.setattr(Simulation, "settle", counted)
    start, place = (0.47, -0.18), (0.83, 0.18)
    mean = PLACES.category(operator.category).feature_means
    alone = Scene(
        np.array([[*mean[:3], round(mean[3])]]),
        np.array([[*start, mean[2] / 2]]),
        np.array([[0.0, 0.0, 0.0, 1.0]]),
    )
    outcome = world.interact(
        alone, np.array(PLACES.primitive_of(operator).action), 0, reference=Place(*place)
    )
    assert outcome.carried
    ticks = simulations[-1].ticks - settling[0]
    diagonal = way_seconds(math.hypot(0.6, 0.6))
    said = carry_seconds(operator, PLACES) - diagonal + way_seconds(math.dist(start, place))
    assert said - 1.5 < ticks * world.config.time_step <= said


def test_shipped_domain_with_places_is_printed_for_each_problem_that_only_carries():
    domain = durative_domain_text(PLACES)
    slowest = max(carry_seconds(one, PLACES) for one in carriers_of(PLACES))
    assert re.findall(r"\(:durative-action (\S+)", domain) == [CARRY]
    assert f":duration (= ?duration {slowest:.3f})" in domain
    printed = []
    for path in sorted((ROOT / "domains/places/problems").glob("*.scene.json")):
        problem = Problem.load(path)
        is_led = "(by-cells " in re.sub(r";.*", "", problem_text(problem, PLACES))
        if is_led:
            with pytest.raises(InvalidValue, match="cannot be carried to where it shall be"):
                durative_problem_text(problem, PLACES)
            continue
        text = durative_problem_text(problem, PLACES)
        assert text == durative_problem_text(problem, PLACES)
        assert {*problem.goals} <= {*re.findall(r"\(can-carry (\S+)\)", text)}
        printed.append(problem.name)
    assert len(printed) == 13


if __name__ == "__main__":
    for name, text in texts().items():
        (GOLDEN / name).write_text(text)
