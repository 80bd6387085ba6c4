"""PDDL as data: what is printed, and what a plan does."""

import pytest

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.pddl.syntax import Action, Course, Domain, Facts, PddlProblem, Predicate

STEP = Action(
    "step",
    "go on",
    (("?a", "place"), ("?b", "place"), ("?c", "price")),
    (("at", "?a"), ("road", "?a", "?b", "?c")),
    (("at", "?b"),),
    (("at", "?a"),),
    ("cost", "?c"),
)
DOMAIN = Domain(
    "way",
    ("A way.",),
    (("place", "object"), ("price", "object")),
    (),
    (
        Predicate("at", (("?a", "place"),), "here"),
        Predicate("road", (("?a", "place"), ("?b", "place"), ("?c", "price")), "leads"),
    ),
    (Predicate("cost", (("?c", "price"),), ""),),
    (STEP,),
)
PROBLEM = PddlProblem(
    "go",
    "way",
    (),
    (("a", "place"), ("b", "place"), ("c3", "price")),
    (Facts("where", (("at", "a"), ("road", "a", "b", "c3"))),),
    {("cost", "c3"): 3},
    (("at", "b"),),
)


def test_a_domain_prints_what_it_holds():
    assert DOMAIN.text() == (
        "; A way.\n(define (domain way)\n  (:requirements :strips :typing :action-costs)\n"
        "  (:types\n    place price - object)\n  (:predicates\n    (at ?a - place) ; here\n"
        "    (road ?a ?b - place ?c - price) ; leads\n  )\n"
        "  (:functions (total-cost) - number (cost ?c - price) - number)\n"
        "  (:action step ; go on\n    :parameters (?a ?b - place ?c - price)\n"
        "    :precondition (and (at ?a) (road ?a ?b ?c))\n"
        "    :effect (and (not (at ?a)) (at ?b) (increase (total-cost) (cost ?c)))))\n"
    )


def test_without_costs_nothing_speaks_of_them():
    assert "cost" not in DOMAIN.text(costs=False)
    assert "total-cost" not in PROBLEM.text(costs=False)


def test_a_problem_prints_facts_of_one_thing_on_one_line():
    assert PROBLEM.text() == (
        "(define (problem go)\n  (:domain way)\n  (:objects\n    a b - place\n    c3 - price)\n  (:init\n"
        "    ; where\n    (at a) (road a b c3)\n    (= (total-cost) 0) (= (cost c3) 3)\n  )\n"
        "  (:goal (and (at b)))\n  (:metric minimize (total-cost)))\n"
    )


def test_a_course_follows_a_plan():
    course = Course(DOMAIN, {*PROBLEM.atoms})
    course.take("step", ("a", "b", "c3"))
    assert ("at", "b") in course.holds
    assert ("at", "a") not in course.holds


@pytest.mark.parametrize(
    ("name", "arguments", "said"),
    [
        ("step", ("b", "a", "c3"), r"\(at b\) does not hold there"),
        ("step", ("a", "b"), r"it has 2 arguments; valid: \(step \?a \?b \?c\)"),
    ],
)
def test_a_course_refuses_what_is_not_possible(name, arguments, said):
    with pytest.raises(InvalidValue, match=said):
        Course(DOMAIN, {*PROBLEM.atoms}).take(name, arguments)


def test_a_course_knows_its_actions():
    with pytest.raises(UnknownChoice, match="step"):
        Course(DOMAIN, set()).take("jump", ())
