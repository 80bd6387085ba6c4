"""The relations that judge, tasks of them that a person solves beforehand, and what is counted."""

import math

import numpy as np
import pytest

from neurosym.world import Outcome, Scene
from tools.benchmarks.relations import by_hand, protocols
from tools.benchmarks.relations.geometry import fits, relation
from tools.benchmarks.relations.summary import summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.tasks import cells
from tools.benchmarks.world.measures import factory

SOLID, TRAY, TILTED = 0, 1, (0.0, math.sin(0.3), 0.0, math.cos(0.3))
UPRIGHT, QUARTER = (0.0, 0.0, 0.0, 1.0), (0.0, math.sin(math.pi / 4), 0.0, math.cos(math.pi / 4))
UNDER = (0.7, 0.1, 0.02)


def outcome(kind: int, where: tuple[float, float, float], *, touching: bool, turn=UPRIGHT) -> Outcome:
    scene = Scene(
        np.array([[0.05, 0.05, 0.06, 0], [0.15, 0.15, 0.04, kind]]),
        np.array([where, UNDER]),
        np.array([turn, UPRIGHT]),
    )
    return ended(scene, ((0, 1),) if touching else ())


def ended(scene: Scene, contacts=()) -> Outcome:
    return Outcome(scene, scene, scene, 0, False, False, False, 0.0, contacts=contacts)


@pytest.mark.parametrize(
    ("found", "name"),
    [
        (outcome(SOLID, (0.72, 0.1, 0.07), touching=True), "on"),
        (outcome(TRAY, (0.7, 0.1, 0.07), touching=True), "on"),
        (outcome(TRAY, (0.7, 0.12, 0.036), touching=False), "in"),
        (outcome(TRAY, (0.7, 0.12, 0.04), touching=True, turn=TILTED), "leaning"),
        (outcome(SOLID, (0.78, 0.1, 0.05), touching=True, turn=TILTED), "leaning"),
        (outcome(SOLID, (0.8, 0.1, 0.03), touching=True), "against"),
        (outcome(SOLID, (0.8, 0.1, 0.03), touching=False), "beside"),
        (outcome(TRAY, (0.5, -0.2, 0.03), touching=False), "apart"),
        (outcome(TRAY, (0.7, 0.1, -0.03), touching=True), "against"),  # it stands on the other
        (outcome(SOLID, (0.7, 0.1, 0.065), touching=True, turn=QUARTER), "on"),  # by the sizes it shows
    ],
)
def test_relation_is_told(found, name):
    assert relation(found, 0, 1) == name


@pytest.mark.parametrize(
    ("width", "kind", "does"), [(0.12, TRAY, True), (0.14, TRAY, False), (0.12, SOLID, False)]
)
def test_what_fits_is_narrower_than_the_inside_of_a_hollow_one(width, kind, does):
    assert fits(np.array([0.05, width, 0.06, SOLID]), np.array([0.15, 0.15, 0.04, kind])) is does


def test_hollow_object_is_around_what_is_in_it_and_of_two_the_smaller_is_in_the_larger():
    for touching in (False, True):
        box_in_tray = outcome(TRAY, (0.7, 0.12, 0.036), touching=touching)
        assert (relation(box_in_tray, 0, 1), relation(box_in_tray, 1, 0)) == ("in", "around")
    features = np.array([[0.1, 0.1, 0.04, TRAY], [0.15, 0.15, 0.05, TRAY]])
    rings = ended(Scene(features, np.array([[0.7, 0.1, 0.02], [0.7, 0.1, 0.025]]), np.array([UPRIGHT] * 2)))
    assert (relation(rings, 0, 1), relation(rings, 1, 0)) == ("in", "around")


@pytest.mark.evaluation
def test_actions_by_hand_put_over_take_away_and_build():
    found = {
        "command": "this",
        "put_over": by_hand.put_over(1, 1, 1),
        "towers_by_hand": by_hand.towers(1, 2, 1),
        "random": by_hand.predictability(8, 3, 1),
    }
    assert len(found["put_over"]) == 16
    assert all(cell["tried"] == 1 for cell in found["put_over"].values())
    assert found["put_over"]["box over box"] == {
        "tried": 1, "carried": 1, "ends": {"on": 1}, "taken_on": [1, 1], "taken_in": [0, 0]
    }  # fmt: skip
    assert found["towers_by_hand"] == {n: {"tried": 1, "stand": 1} for n in ("3", "4")}
    text = page(summarise(found, {}, cells(1), seeds=5, steps=1))
    assert "| box over box | 1 of 1 | 1 |" in text
    assert "Of 8 random actions" in text


# Tasks of relations that a person solves beforehand, and what is counted of them

HAND = {
    "command": "this",
    "put_over": {},
    "towers_by_hand": {},
    "random": {"interactions": 1, "carried": 0.0, "ends_of_carried": {}, "another_relation": 0},
}
QUICK = ("tower of 3", "unstack and sort", "swap", "tower of 3 at a place")


@pytest.fixture(scope="module")
def world():
    return factory()()


@pytest.mark.parametrize("name", QUICK)
def test_what_is_asked_for_is_not_so_at_the_start(name, world):
    asked = {name: draw for name, draw, _ in cells(1)}[name](world, 5)
    assert not asked.is_met(ended(asked.start, asked.contacts))
    assert bool(asked.contacts) == (name in ("unstack and sort", "swap")), "these begin with stacks"
    assert bool(asked.places) == (name == "tower of 3 at a place")
    for goal in asked.goals:
        target, reference = asked.start.features[goal.target], asked.start.features[goal.reference]
        assert goal.word == ("in" if fits(target, reference) else "on")


def symbols(right: float) -> dict:
    return {
        "operators": {"on": {"operator": "a", "right": right, "pairs": 0.1}, "in": None},
        "static_bits": {"balanced": 0.8, "carries": 0.9, "fits": 0.7},
        "state_bits": {"balanced": right},
        "recall_on": {"recall": 0.6, "precision": 0.7},
        "effect_errors": {"2": {"error": right, "nothing_moves": 2.0, "carried": 0.5}},
    }


def test_summary_counts_seeds_and_means_over_them():
    tower = [{"status": "solved", "reached": True, "blind": False}, {"status": "no plan"}]
    found = {
        "learn-1": symbols(0.9),
        "learn-2": symbols(0.8),
        "try-1-tower-of-3-0": tower,
        "try-2-tower-of-3-0": tower[:1],
        "try-2-tower-of-3-at-a-place-0": tower[1:],
        "learn-random-1": symbols(0.1),
        "try-random-1-tower-of-3-0": tower[1:],
        "singly-1-tower-of-3-0": [True, False],
    }
    summary = summarise(HAND, found, cells(10), seeds=5, steps=1)
    assert (summary["on_operator_seeds"], summary["in_operator_seeds"]) == (1, 0)
    assert summary["state_bits"] == pytest.approx(0.85)
    assert summary["towers"] == {"3": 0.75, "4": None}
    assert summary["tower_at_place"] == 0.0
    cell = summary["table"]["tower of 3"]
    assert (cell["tasks"], cell["planned"], cell["blind"]) == (3, 2, [0.0, 0.0])
    text = page(summary)
    assert "| seed 1 | 90% (10.0%) | none | 90.0% | 80.0% | 90% | 70% | 60% | 70% |" in text
    assert "| seed 1, at random | 10% (10.0%) | none |" in text
    assert "| 2 | 0.85 | 2.00 | 50% |" in text
    assert "| tower of 3 | 3 | 2 | 0% ± 0 | 75% ± 35 | 50% | 0% | 0% |" in text


@pytest.mark.parametrize(("name", "draw", "_"), protocols.cells(1))
def test_what_others_asked_is_drawn_with_as_many_objects_as_theirs(name, draw, _, world):
    asked = draw(world, 5)
    assert asked.goals or asked.places or isinstance(asked, protocols.Likened)
    few = name.startswith("up to three")
    low, high = (protocols.FEW, protocols.FEW) if few else protocols.AMONG
    assert low <= len(asked.start) <= high
    assert not asked.is_met(ended(asked.start)), "something must be done"
    if isinstance(asked, protocols.Likened):
        assert asked.is_met(ended(asked.like))
