"""Plans and complaints of other people's planners are read as printed, without any of them installed."""

import sys

import pytest

from tools.benchmarks.foreign import Task, called, judged, plan_in
from tools.benchmarks.foreign_calls.planners import PLANNERS, error_in, steps_in

MOVE = ("move", "cup", "here", "there")
RECORDED = {
    "Fast Downward": "(move cup here there)\n; cost = 3 (general cost)\n",
    "LPG": "; Version LPG-td-1.4\n; Time 0.01\n\n0:   (MOVE CUP HERE THERE) [1]\n",
    "ENHSP": "(move cup here there)\n",
    "Kairos": "0.000: (move cup here there) [1.000]\n; cost 3\n",
    "jupyddl": "Plan (1 steps, cost 1):\n    1. move(cup,here,there)\nValid: True\nStats: expanded=1\n",
}
"""A plan as each of these planners writes it."""


DOMAIN = """(define (domain table)
  (:requirements :strips :typing :action-costs)
  (:types thing place price - object)
  (:predicates (at ?o - thing ?p - place) (free ?p - place) (priced ?o - thing ?c - price))
  (:functions (total-cost) (cost ?c - price))
  (:action move
    :parameters (?o - thing ?from ?to - place ?c - price)
    :precondition (and (at ?o ?from) (free ?to) (priced ?o ?c))
    :effect (and (at ?o ?to) (not (at ?o ?from)) (free ?from) (not (free ?to)) DOES)))
"""
PROBLEM = """(define (problem p)
  (:domain table)
  (:objects cup - thing here there - place c15 - price)
  (:init (= (total-cost) 0) (= (cost c15) 15) (priced cup c15) (at cup here) (free there))
  (:goal (and (at cup there)))METRIC)
"""
METRIC = "\n  (:metric minimize (total-cost))"


def printed(does: str = "(increase (total-cost) 3)", metric: str = METRIC) -> Task:
    return Task("a task", DOMAIN.replace("DOES", does), PROBLEM.replace("METRIC", metric))


@pytest.mark.parametrize("planner", RECORDED)
def test_plan_is_read_in_the_form_of(planner):
    assert steps_in(RECORDED[planner]) == [MOVE]


def test_warnings_are_not_taken_for_errors():
    output = (
        "WARNING: predicate A is declared to use unknown or empty type\ntoo many functions! increase MAX\n"
    )
    assert error_in(output) == "too many functions! increase MAX"
    assert not error_in("Solution found.\nPlan cost: 3\n")


def test_plan_is_judged_and_its_cost_added_up():
    priced = "(increase (total-cost) (cost ?c))"
    for task, cost in ((printed("", ""), None), (printed(), 3), (printed(priced), 15)):
        found = judged(task, [(*MOVE, "c15")])
        assert (found["valid"], found["plan_length"], found["cost"]) == (True, 1, cost)
    assert judged(printed(), [("move", "cup", "there", "here", "c15")])["valid"] is False


def test_no_plan_is_found_where_no_planner_left_one(tmp_path):
    (tmp_path / "problem.pddl").write_text("(move cup here there)")
    assert plan_in(tmp_path, PLANNERS["LPG"]) is None
    (tmp_path / "plan_1.SOL").write_text(RECORDED["LPG"])
    assert plan_in(tmp_path, PLANNERS["LPG"]) == [MOVE]


def test_planner_is_ended_with_what_it_started(tmp_path):
    cpu, clock, code = called([sys.executable, "-c", "while True: pass"], tmp_path, 1)
    assert code is None
    assert 0 < cpu < 4
    assert clock < 30
    assert called(["bash", "-c", "exit 3"], tmp_path, 1)[2] == 3
