"""The page: what it holds, and that plans of the shipped domains are plans of it, by a validator not ours."""

import json

import pytest
from places import ROOT

from neurosym.grounding import Grounding
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.strips import page
from neurosym.pddl.strips_plan import Misread, led_by, led_in, read, write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.planners.plan_validator import validate_pddl
from neurosym.problems import Problem
from neurosym.shipped import DOMAINS
from neurosym.tasks.task import understand

LINES, BYTES, ACTIONS, LONGEST_NAME = 150, 12_000, 20, 32
WITH_RELATIONS, WITH_CELLS = 15_000, 120_000
SHIPPED = ROOT / "domains"


@pytest.fixture(scope="module", params=DOMAINS)
def folder(request):
    return SHIPPED / request.param


@pytest.fixture(scope="module")
def grounding(folder):
    return Grounding.load(folder / "grounding.json")


def task_in(folder, name, grounding):
    return understand(Problem.load(folder / "problems" / f"{name}.scene.json"), grounding)


def test_a_domain_fits_on_a_page(grounding):
    domain = page(grounding)
    text = domain.text()
    assert text.count("\n") <= LINES
    assert len(text.encode()) <= BYTES
    assert len(domain.actions) <= ACTIONS
    names = [one.name for one in (*domain.actions, *domain.predicates)]
    names += [name for name, _ in (*domain.types, *domain.constants)]
    assert max(map(len, names)) <= LONGEST_NAME


def test_problems_are_short(folder, grounding):
    for file in sorted((folder / "problems").glob("*.scene.json")):
        task = understand(Problem.load(file), grounding)
        size = len(StripsProblem(task).data().text().encode())
        assert size <= (WITH_CELLS if task.led else WITH_RELATIONS), file


def test_shipped_plans_are_plans_of_the_page(folder, grounding):
    domain = page(grounding).text()
    records = sorted((folder / "plans").glob("*.fast-downward.json"))
    assert records
    for record in records:
        found = json.loads(record.read_text())
        if not found["steps"]:
            continue
        task = task_in(folder, found["problem"], grounding)
        steps = [PlanStep(*step) for step in found["steps"]]
        written = write(steps, StripsProblem(task, led=led_by(steps, task)))
        problem = StripsProblem(task, led=written.led, kept=written.moves)
        text = problem.data(written.facts, written.spots).text()
        assert validate_pddl(domain, text, written.actions).valid, record
        every = StripsProblem(task, led=led_in(written.actions, task), every=True)
        back = read(written.actions, every)
        assert [(one.object, one.place) for one in back] == [(one.object, one.place) for one in steps]
        assert write(back, problem).actions == written.actions


@pytest.mark.parametrize(
    ("actions", "said"),
    [
        ([("take", "item-01", "start-item-02")], r"\(stands item-01 start-item-02\) does not hold"),
        ([("take", "item-01", "start-item-01")], "item-01 was taken, and is put nowhere"),
        ([("fly", "item-01")], "fly"),
        ([("reach-place", "item-01", "start-item-01")], r"\(goal-place item-01 start-item-01\)"),
    ],
)
def test_what_is_not_so_is_refused(actions, said):
    folder = SHIPPED / "places"
    task = task_in(folder, "row-4-12", Grounding.load(folder / "grounding.json"))
    with pytest.raises(Misread, match=said):
        read(actions, StripsProblem(task, every=True))
