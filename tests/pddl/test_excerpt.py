"""What of a printed domain and problem a plan touches: whoever judges the plan says the same of the whole."""

import numpy as np
import pytest
from independent.ground_pddl import judge
from places import ROOT

from neurosym.errors import InvalidValue
from neurosym.pddl.excerpt import excerpt_for, parameters_of, tree_of

CASES = {
    "tabletop/plans/task-07.fast-downward.plan": ("domain.pddl", "task-07.pddl"),
    "places/plans/swap-2-06.fast-downward.plan": ("domain-places.pddl", "swap-2-06.places.pddl"),
    "towers/plans/tower-4-03.fast-downward.plan": ("domain-relational.pddl", "tower-4-03.relational.pddl"),
}


def case(plan: str) -> tuple[str, str, list[tuple[str, ...]]]:
    file, (domain, problem) = ROOT / "domains" / plan, CASES[plan]
    folder = file.parent.parent
    actions = [tuple(str(word) for word in tree_of(line)) for line in file.read_text().splitlines()]
    return (folder / domain).read_text(), (folder / "problems" / problem).read_text(), actions


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


@pytest.mark.parametrize("plan", CASES)
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


def test_excerpt_is_small():
    domain, problem, actions = case("tabletop/plans/task-07.fast-downward.plan")
    part = excerpt_for(domain, problem, actions)
    assert len(part.domain) < len(domain) / 5
    assert len(part.problem) < len(problem) / 10


def test_plan_of_no_action_leaves_a_domain_that_can_be_read():
    domain, problem, _ = case("tabletop/plans/task-07.fast-downward.plan")
    assert len(parameters_of(excerpt_for(domain, problem, ()).domain)) == 1


def test_parameters_are_counted_as_the_domain_declares_them():
    domain, _, _ = case("places/plans/swap-2-06.fast-downward.plan")
    found = parameters_of(domain)
    assert found["look-on"] == 4
    assert found["move-x"] == 5
    assert found["reach-place"] == 2


@pytest.mark.parametrize("text", ["", "(define (domain x)", "(a))", "(a) (b)", "word"])
def test_text_whose_parentheses_do_not_fit_is_refused(text: str):
    with pytest.raises(InvalidValue, match="parentheses"):
        tree_of(text)
