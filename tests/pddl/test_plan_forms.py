"""Plan forms: every form of a plan gives the same steps, and an edited plan no others than it says."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from places import DOCS, ROOT

from neurosym.errors import InvalidPlan
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.plan_reading import parse_plan, written_plan
from neurosym.pddl.syntax import EncodingName
from neurosym.problems import Problem
from neurosym.tasks.supports import relating
from neurosym.tasks.transition import PlanStep
from tools.benchmarks.plan_forms import FORMS, PlanForm

SHIPPED = (
    ("places", "row-4-12.fast-downward"),
    ("tabletop", "task-01.fast-downward"),
    ("towers", "tower-6-05.fast-downward"),
)
"""A plan of each kind of domain: by places, over cells, and by relations."""
Words = list[list[str]]


@cache
def shipped(domain: str, plan: str) -> tuple[str, Grounding, Problem]:
    folder = ROOT / "domains" / domain
    scene = folder / "problems" / f"{plan.partition('.')[0]}.scene.json"
    text = (folder / "plans" / f"{plan}.plan").read_text()
    return text, Grounding.load(folder / "grounding.json"), Problem.load(scene)


def actions_of(text: str) -> Words:
    """Return the words of the ground actions in a plan file, an action a line."""
    lines = (line.partition(";")[0].strip() for line in text.splitlines())
    return [line.strip("()").split() for line in lines if line]


def read(text: str, domain: str, plan: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), *shipped(domain, plan)[1:])


def by_hand(actions: Words) -> list[tuple[str, ...]]:
    """Fold ground actions into steps by their names alone, a few lines instead of what is tested."""
    steps = []
    for name, thing, *words in actions:
        if name in ("push", "lift", "put-down"):
            steps.append((thing, words[0].removeprefix("m-"), ""))
        elif name == "put-at":
            steps.append((thing, "carry", words[0]))
        elif name in ("put", "put-loaded"):
            steps.append((thing, "put", words[1]))
    return steps


def in_short(steps: tuple[PlanStep, ...], grounding: Grounding) -> list[tuple[str, ...]]:
    """Say of steps what `by_hand` tells."""
    done = []
    for step in steps:
        if relating(step.operator, grounding):
            done.append((step.object, "put", step.place))
        else:
            done.append(
                (
                    step.object,
                    "carry" if step.place else grounding.operator_named(step.base).label,
                    step.place,
                )
            )
    return done


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.name)
@pytest.mark.parametrize(("domain", "plan"), SHIPPED)
def test_a_plan_gives_the_same_steps_in_every_form(form: PlanForm, domain: str, plan: str):
    text = shipped(domain, plan)[0]
    assert read(form.write(actions_of(text)), domain, plan) == read(text, domain, plan) != ()


def is_known(word: str) -> bool:
    return word.replace("_", "-") in {"push-left", "reach-goal", "item-01"}


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.name)
def test_a_form_in_windows_lines_or_cut_off_is_read_alike_or_refused(form: PlanForm):
    actions = [["push-left", "item-01", "x1", "x2"], ["reach-goal", "item-01", "x2"]]
    text = form.write(actions)
    whole = written_plan(text, Path("p"), is_known)
    names = [(one.name, one.arguments) for one in whole]
    crlf = text.replace("\n", "\r\n")
    assert [(one.name, one.arguments) for one in written_plan(crlf, Path("p"), is_known)] == names
    for end in range(len(text)):
        try:
            cut = written_plan(text[:end], Path("p"), is_known)
        except InvalidPlan:
            continue
        marked = [one for one in cut if not one.is_plain]
        assert all(whole.startswith(one.name) for one, (whole, _) in zip(marked, names, strict=False))


def test_every_form_is_listed_in_the_documents():
    page = (DOCS / "other-plans.md").read_text()
    assert [form.name for form in FORMS if f"| {form.name} |" not in page] == []


@pytest.mark.parametrize("encoding", ["strips", "numeric", "sas"])
def test_every_encoding_of_a_plan_gives_the_same_steps(encoding: EncodingName):
    text, grounding, problem = shipped("tabletop", "task-01.fast-downward")
    steps = read(text, "tabletop", "task-01.fast-downward")
    again = ground_plan(steps, problem, grounding, encoding).text
    assert read(again, "tabletop", "task-01.fast-downward") == steps


def edited(actions: Words, rng: np.random.Generator, words: list[str]) -> Words:
    """Drop, double or swap actions, or change a word of one."""
    actions = [[*action] for action in actions]
    at, other = (int(number) for number in rng.integers(len(actions), size=2))
    match rng.integers(4):
        case 0:
            del actions[at]
        case 1:
            actions.insert(other, actions[at])
        case 2:
            actions[at], actions[other] = actions[other], actions[at]
        case 3:
            actions[at] = [*actions[at]]
            actions[at][int(rng.integers(len(actions[at])))] = str(rng.choice(words))
    return actions


@pytest.mark.parametrize(("domain", "plan"), SHIPPED)
def test_an_edited_plan_is_refused_or_gives_the_steps_that_it_says(domain: str, plan: str):
    text, grounding, _ = shipped(domain, plan)
    actions, rng = actions_of(text), np.random.default_rng(41)
    words = [
        *sorted({word for action in actions for word in action}),
        "x999",
        "item-77",
        "goal-item-01",
        "one",
    ]
    refused = 0
    for _ in range(150):
        some = edited(actions, rng, words)
        try:
            steps = read(FORMS[0].write(some), domain, plan)
        except InvalidPlan:
            refused += 1
        else:
            assert in_short(steps, grounding) == by_hand(some)
    assert refused > 75


@pytest.mark.parametrize(("domain", "plan"), SHIPPED)
def test_any_other_argument_is_refused(domain: str, plan: str):
    actions = actions_of(shipped(domain, plan)[0])
    for at, action in enumerate(actions):
        for number in range(1, len(action)):
            other = [*action[:number], "x000" if action[number] != "x000" else "x001", *action[number + 1 :]]
            with pytest.raises(InvalidPlan):
                read(FORMS[0].write([*actions[:at], other, *actions[at + 1 :]]), domain, plan)
