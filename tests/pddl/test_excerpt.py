"""What of a printed domain and problem a plan touches: whoever judges the plan says the same of the whole."""

import re

import numpy as np
import pytest
from independent.ground_pddl import judge
from places import ROOT

from neurosym.errors import InvalidValue
from neurosym.pddl.compiler import excerpt_for, parameters_of, tree_of

CELLS = "tabletop/plans/task-07.fast-downward.plan"
PLACES = "places/plans/swap-2-06.fast-downward.plan"
RELATIONS = "towers/plans/tower-4-03.fast-downward.plan"


def case(plan: str) -> tuple[str, str, list[tuple[str, ...]]]:
    file = ROOT / "domains" / plan
    folder, problem = file.parent.parent, file.name.split(".")[0]
    actions = [tuple(str(word) for word in tree_of(line)) for line in file.read_text().splitlines()]
    texts = [(folder / name).read_text() for name in ("domain.pddl", f"problems/{problem}.pddl")]
    return texts[0], texts[1], actions


def spoilt(actions: list[tuple[str, ...]], rng: np.random.Generator) -> list[tuple[str, ...]]:
    """Drop, repeat, exchange or alter one of the actions."""
    changed, at, other = list(actions), *rng.integers(len(actions), size=2)
    kind = rng.integers(4)
    if kind == 0:
        del changed[at]
    elif kind == 1:
        changed.insert(other, changed[at])
    elif kind == 2:
        changed[at], changed[other] = changed[other], changed[at]
    else:
        word = rng.choice([word for action in actions for word in action[1:]])
        changed[at] = (*changed[at][:-1], str(word))
    return changed


def text_of(actions: list[tuple[str, ...]]) -> str:
    return "".join(f"({' '.join(action)})\n" for action in actions)


@pytest.mark.parametrize("plan", [CELLS, PLACES, RELATIONS])
def test_judge_says_of_the_excerpt_what_it_says_of_the_whole(plan: str):
    domain, problem, actions = case(plan)
    rng, verdicts = np.random.default_rng(0), []
    for changed in [actions, *(spoilt(actions, rng) for _ in range(12))]:
        part = excerpt_for(domain, problem, changed)
        said = judge(domain, problem, text_of(changed))
        assert judge(part.domain, part.problem, text_of(changed)) == said
        verdicts.append(said)
    assert verdicts[0] == ""
    assert sum(map(bool, verdicts)) > 6


@pytest.mark.parametrize("plan", [CELLS, PLACES, RELATIONS])
def test_excerpt_has_only_the_actions_of_the_plan_and_what_these_speak_of(plan: str):
    domain, problem, actions = case(plan)
    part = excerpt_for(domain, problem, actions)
    kept = parameters_of(part.domain)
    assert kept == {name: count for name, count in parameters_of(domain).items() if name in kept}
    assert set(kept) == {name for name, *_ in actions}
    spoken = set(re.findall(r"\(([a-z-]+)", part.domain.partition("(:action ")[2]))
    declared = {head[0] for head in section(part.domain, ":predicates")}
    assert declared == spoken & {head[0] for head in section(domain, ":predicates")}


def section(domain: str, name: str) -> list:
    return next(part[1:] for part in tree_of(domain) if part[0] == name)


def test_excerpt_is_small():
    domain, problem, actions = case(CELLS)
    part = excerpt_for(domain, problem, actions)
    assert len(part.domain) < len(domain) / 2
    assert len(part.problem) < len(problem) / 10


def test_plan_of_no_action_leaves_a_domain_that_can_be_read():
    domain, problem, _ = case(CELLS)
    assert len(parameters_of(excerpt_for(domain, problem, ()).domain)) == 1


def test_parameters_are_counted_as_the_domain_declares_them():
    domain, _, _ = case(PLACES)
    found = parameters_of(domain)
    assert found["note-clear"] == 4
    assert found["move-x"] == 4
    assert found["reach-place"] == 2


@pytest.mark.parametrize("text", ["", "(define (domain x)", "(a))", "(a) (b)", "word"])
def test_text_whose_parentheses_do_not_fit_is_refused(text: str):
    with pytest.raises(InvalidValue, match="parentheses"):
        tree_of(text)
