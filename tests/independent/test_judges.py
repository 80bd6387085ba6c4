"""The judges themselves: each finds what is wrong, and where there are two of a kind, they agree."""

import copy
from collections.abc import Sequence
from decimal import Decimal
from pathlib import Path

import msgspec
import numpy as np
import pytest
import tables
import toy_places
import toy_relations
from independent.brute_force import Search
from independent.ground_pddl import judge, judge_sas, pyval_says
from independent.random_tables import Drawn, draw
from independent.replay import Json, Step, domain_operators, read_text, replay
from validators import unified_planning_accepts

from neurosym.grounding import Grounding
from neurosym.operators import Vector
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.pddl.sas import sas_text
from neurosym.pddl.syntax import ENCODINGS
from neurosym.planners import plan as make_plan
from neurosym.planners.external import SAS_SUFFIX, plan_fast_downward
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Table

LIFT, DOWN = ("lift-010-block", "item-01"), ("put-down-lift-010-block", "item-01")
AWAY, LEFT = ("push-away-001-block", "item-01"), ("push-left-000-block", "item-01")
PULL = ("pull-010-tray", "item-02")
SOLVED = (PULL, AWAY, LIFT)


def raw(value: Grounding | Problem) -> Json:
    """Return what the file of a domain or a scene says."""
    return read_text(msgspec.json.encode(value).decode())


def errand(goals: dict[str, Vector] | None = None) -> Problem:
    task = tables.problem()
    return task if goals is None else msgspec.structs.replace(task, goals=goals)


def test_replay_adds_up_exactly_what_is_promised():
    near = {"item-01": (0.535, -0.02, 0.228), "item-02": (0.545, -0.14, 0.02)}
    wrong, top = replay(raw(tables.grounding()), raw(errand(near)), SOLVED)
    assert not wrong
    assert top.primitives == 3
    assert top.places["item-01"] == (Decimal("0.5345"), Decimal("-0.0201"), Decimal("0.228"))


@pytest.mark.parametrize(
    ("steps", "said"),
    [
        ((LIFT, PULL), "full hand"),
        ((DOWN,), "with None in the hand"),
        ((LIFT, ("put-down-lift-010-block", "item-02")), "not for objects like"),
        ((("lift-010-block", "item-03"),), "there is no"),
        ((LEFT,) * 4, "leaves the table"),
        ((AWAY, AWAY, ("push-left-000-tray", "item-02")), "put into"),
        ((LIFT, DOWN), "missed: item-01"),
    ],
)
def test_replay_names_what_is_wrong(steps: Sequence[Step], said: str):
    assert said in replay(raw(tables.grounding()), raw(errand()), steps)[0]


def test_both_replays_agree_on_steps_at_random():
    """Possible or not, met or not, and where everything ends: 1,500 random plans on 50 tables."""
    seen = set()
    for number in range(1000, 1050):
        drawn, rng = draw(number), np.random.default_rng(number)
        names = [one["name"] for one in drawn.domain_json["operators"]["operators"] if _fits(one, drawn)]
        for _ in range(30 if names else 0):
            steps = _random_steps(names, drawn.problem, drawn.domain_json, rng)
            wrong, top = replay(drawn.domain_json, drawn.scene_json, steps)
            checked = validate([PlanStep(*step) for step in steps], drawn.problem, drawn.grounding)
            assert checked.valid == (not wrong), (number, steps, wrong, checked.reason)
            seen.add(" ".join(wrong.split()[-4:-2]) or "valid")
            if checked.possible:
                ends = np.array([top.places[name] for name in drawn.problem.object_names], dtype=float)
                assert np.allclose(checked.positions[-1], ends, atol=1e-12)
    assert len(seen) > 3


def _fits(operator: Json, drawn: Drawn) -> bool:
    return operator in domain_operators(drawn.domain_json)


def _random_steps(
    names: Sequence[str], problem: Problem, domain: Json, rng: np.random.Generator
) -> tuple[Step, ...]:
    """Draw steps that fit their objects; what was lifted is mostly put down again."""
    operators = {one["name"]: one for one in domain["operators"]["operators"]}
    steps: list[Step] = []
    for _ in range(rng.integers(1, 6)):
        item = problem.objects[rng.integers(len(problem.objects))]
        fitting = [name for name in names if operators[name]["category"] == item.category]
        if fitting:
            name = fitting[rng.integers(len(fitting))]
            steps.append((name, item.name))
            promised = operators[name].get("promised") or operators[name]["modes"][0]["kind"]
            if promised == "held" and rng.random() < 0.8:
                steps.append((f"put-down-{name}", item.name))
    return tuple(steps)


def test_domain_has_the_operators_that_the_document_says():
    for number in range(1000, 1100):
        drawn = draw(number)
        live = {one["name"] for one in domain_operators(drawn.domain_json)}
        assert live == {operator.name for operator in drawn.grounding.live}, number


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_judges_of_pddl_agree(encoding: str):
    """`pddl-pyvalidator`, and ours, which is quick enough for large problems."""
    pytest.importorskip("pyval", reason="pddl-pyvalidator is not installed")
    near = {"item-01": (0.535, -0.02, 0.228), "item-02": (0.545, -0.14, 0.02)}
    small = Table(x=(0.44, 0.62), y=(-0.16, 0.04))
    learned, task = msgspec.structs.replace(tables.grounding(0.02), table=small), errand(near)
    files = domain_text(learned, encoding), problem_text(task, learned, encoding)
    plan = ground_plan([PlanStep(*step) for step in SOLVED], task, learned, encoding).text
    lines = plan.splitlines()
    broken = [lines[1:], lines[:-1]] if encoding != "numeric" else [lines[1:], lines[:-1], lines[::-1]]
    for text, is_valid in [(plan, True), *(("\n".join(part), False) for part in broken)]:
        assert pyval_says(*files, text) == is_valid
        assert (judge(*files, text) == "") == is_valid, text


@pytest.mark.parametrize(
    ("problem", "learned"),
    [
        (toy_places.mixed(), toy_places.grounding()),
        (toy_relations.tower(), toy_relations.grounding()),
        (toy_relations.sorting(), toy_relations.grounding()),
    ],
    ids=lambda one: one.name,
)
def test_judges_agree_on_places_and_relations(problem: Problem, learned: Grounding, tmp_path: Path):
    """Of a plan, and of the same without any one of its actions."""
    plan = ground_plan(make_plan(problem, learned).steps, problem, learned)
    texts = domain_text(learned), problem_text(problem, learned, plans=[plan])
    files = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    for file, text in zip(files, texts, strict=True):
        file.write_text(text)
    lacking = [[*plan.lines[:number], *plan.lines[number + 1 :]] for number in range(len(plan.lines))]
    for lines, is_valid in [(plan.lines, True), *((lines, False) for lines in lacking)]:
        assert (judge(*texts, "\n".join(lines)) == "") == is_valid, lines
        assert unified_planning_accepts(*files, "\n".join(lines)) == is_valid, lines


def test_judge_of_sas_finds_what_is_wrong(tmp_path: Path):
    near = {"item-01": (0.535, -0.02, 0.228), "item-02": (0.545, -0.14, 0.02)}
    text = sas_text(errand(near), tables.grounding(0.02))
    (both := tmp_path / f"problem{SAS_SUFFIX}").write_text(text)
    plan = plan_fast_downward(both, both, time_limit=30.0).text
    lines = [line for line in plan.splitlines() if not line.startswith(";")]
    assert judge_sas(text, plan) == ""
    assert "does not apply" in judge_sas(text, "\n".join([lines[0], *lines]))
    assert "do not hold" in judge_sas(text, "\n".join(lines[:-1]))
    assert "no such operator" in judge_sas(text, "(fly item-01)")


def test_brute_force_leads_one_block_around_another():
    """Straight ahead stands a tray that must go first."""
    task = tables.crossing()
    found = Search(raw(tables.grounding()), raw(task)).solve()
    assert (found.fewest, found.is_exact) == (2, True)
    assert found.steps[0][1] == "item-02"
    assert replay(raw(tables.grounding()), raw(task), found.steps)[0] == ""


def test_brute_force_says_whether_it_saw_everything():
    drawn = draw(1003, "tiny")
    nowhere = {**copy.deepcopy(drawn.scene_json), "goals": {"item-1": [Decimal(9), Decimal(9), Decimal(0)]}}
    everything = Search(drawn.domain_json, nowhere).solve()
    cut_off = Search(drawn.domain_json, nowhere, most_states=2).solve()
    assert (everything.fewest, everything.is_exact) == (None, True)
    assert (cut_off.fewest, cut_off.is_exact) == (None, False)
