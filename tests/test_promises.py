"""Promises for the object at hand: refined by rehearsals of objects like it."""

import math
import re

import msgspec
import numpy as np
import pytest
import tables

from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Rehearsal
from neurosym.pddl.compiler import problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem, SceneObject
from neurosym.regression import fit
from neurosym.tasks.promises import OUTSIDE, chances_of, is_rehearsed, promised, usable, why_unfit
from neurosym.tasks.transition import PlanStep, validate

AWAY = "push-away-001-block"


def rehearsed(count: int = 40, cliff: float = math.inf) -> Grounding:
    """Have blocks of 4 to 10 cm go away by as much as they are wide, and fail from a width on."""
    learned, replace = tables.grounding(), msgspec.structs.replace
    widths = np.random.default_rng(0).uniform(0.04, 0.1, count).tolist()
    objects = tuple((width, 0.05, 0.05, 0.0) for width in widths)
    away = [(("toppled" if width > cliff else "resting"), (width, 0.0, 0.0)) for width in widths]
    rows = tuple(Rehearsal(kind, by, by, 0.0, 0.0) for kind, by in away)
    table = learned.objects
    categories = tuple(
        replace(one, objects=objects) if one.symbol == "00" else one for one in table.categories
    )
    operators = tuple(
        replace(one, rehearsals=rows, trials=count) if one.name == AWAY else one for one in table.operators
    )
    return replace(learned, objects=replace(table, categories=categories, operators=operators))


def block(width: float) -> SceneObject:
    return SceneObject("item-01", "00", (width, 0.05, 0.05, 0.0), (0.45, 0.0, 0.025))


@pytest.mark.parametrize("width", [0.045, 0.07, 0.095])
def test_what_an_operator_does_is_read_from_objects_of_that_size(width: float):
    learned = rehearsed()
    promise = promised(learned, block(width))[AWAY].promise
    assert promise is not None
    assert promise.resting_effect[0] == pytest.approx(width, abs=0.002)
    assert promise.resting_spread[0] < 0.005
    assert promised(learned, block(width))[AWAY].rehearsals == ()


def test_objects_unlike_all_that_were_rehearsed_are_promised_the_mean_less_surely():
    learned = rehearsed()
    huge = block(0.2)
    assert not is_rehearsed(learned.category("00"), huge.features)
    assert is_rehearsed(learned.category("00"), block(0.09).features)
    found, mean = promised(learned, huge)[AWAY].promise, learned.operator_named(AWAY).promise
    assert found.near_mean == round(OUTSIDE * mean.near_mean)
    assert found == msgspec.structs.replace(mean, near_mean=found.near_mean)


def test_what_mostly_fails_with_an_object_is_not_planned_with_and_the_problem_leaves_it_out():
    learned = rehearsed(80, cliff=0.07)
    blocks = [block(width) for width in np.linspace(0.07, 0.075, 50).tolist()]
    good, worse = (promised(learned, block(width))[AWAY] for width in (0.05, 0.095))
    assert good.successes > 0.75 * good.trials
    assert worse.successes < 0.2 * worse.trials
    bad = next(one for one in blocks if 8 <= promised(learned, one)[AWAY].successes < 20)
    assert AWAY not in {one.name for one in usable(learned, bad)}
    reason = why_unfit(promised(learned, bad)[AWAY], learned)
    assert re.fullmatch(r"keeps its promise with such objects in about \d+ of 80 only", str(reason))
    for encoding, motion in (("strips", "m-001"), ("numeric", "m-001-item-01")):
        for one, is_offered in ((bad, False), (block(0.05), True)):
            task = Problem("p", (one,), {"item-01": (0.54, 0.0, 0.025)})
            text = problem_text(task, learned, encoding)
            assert bool(re.search(rf"\(pushes item-01 {motion}[ )]", text)) == is_offered
            assert bool(re.search(rf"\b{motion}[ )]", text)) == is_offered
    plain = tables.grounding()
    assert why_unfit(plain.operator_named(AWAY), plain) is None


def test_chances_are_told_for_many_objects_at_once():
    learned = rehearsed(80, cliff=0.07)
    operator, category = learned.operator_named(AWAY), learned.category("00")
    features = np.array([[width, 0.05, 0.05, 0.0] for width in (0.05, 0.095)])
    chances = chances_of(operator, category, features)
    assert chances is not None
    for row, one in zip(features, chances, strict=True):
        found = promised(learned, block(row[0]))[AWAY]
        assert found.successes == round(one * found.trials)
    assert chances_of(tables.grounding().operator_named(AWAY), category, features) is None


@pytest.mark.parametrize("planner", ["counting", "fast-downward"])
def test_plans_are_made_and_checked_with_what_is_promised_to_the_object(planner: str):
    """Two pushes of a small block lead as far as one of a large one: 90 mm."""
    learned = rehearsed()
    for width, times in ((0.045, 2), (0.09, 1)):
        task = Problem("p", (block(width),), {"item-01": (0.54, 0.0, 0.025)}, tolerance=0.008)
        found = plan(task, learned, planner)
        assert found.status is PlanStatus.SOLVED, found.reason
        assert found.steps == (PlanStep(AWAY, "item-01"),) * times
        assert validate(found.steps, task, learned).valid


@pytest.mark.parametrize("column", [0, 1])
def test_one_feature_that_decides_is_found_among_four(column: int):
    rng = np.random.default_rng(column)
    objects = rng.uniform((0.03, 0.03, 0.02, 0.0), (0.18, 0.18, 0.1, 2.0), (32, 4))
    is_kind = objects[:, column] < 0.12
    outcomes = np.zeros((int(is_kind.sum()), 2))
    found = fit(objects, is_kind, outcomes, scale=objects.std(0))
    assert np.flatnonzero(found.choice.deciding).tolist() == [column]
    at = (objects - found.centre) / found.scale
    chances = np.array([found.chance(row, TOLERANCE) for row in at])
    assert chances[objects[:, column] > 0.14].max() < 0.3
    assert chances[objects[:, column] < 0.1].min() > 0.7


def test_what_lies_turned_is_promised_to_go_that_way():
    learned, straight = msgspec.structs.replace(rehearsed(), turned=True), block(0.07)
    turned = msgspec.structs.replace(straight, orientation=(0.0, 0.0, math.sin(0.25), math.cos(0.25)))
    before, after = (promised(learned, item)[AWAY].promise for item in (straight, turned))
    assert before is not None
    assert after is not None
    far = math.hypot(*before.resting_effect[:2])
    assert after.resting_effect[:2] == pytest.approx((far * math.cos(0.5), far * math.sin(0.5)), abs=1e-3)
    assert (after.count, after.near_mean) == (before.count, before.near_mean)
    elsewhere = msgspec.structs.replace(learned, turned=False)  # in a world that turns nothing
    assert promised(elsewhere, turned)[AWAY].promise == before
