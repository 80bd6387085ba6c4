"""Tasks of relations that a person solves beforehand, and what is counted of them."""

import pytest

from neurosym.world import Outcome, Scene
from tools.benchmarks.relations import protocols
from tools.benchmarks.relations.geometry import fits
from tools.benchmarks.relations.summary import summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.tasks import cells
from tools.benchmarks.world.measures import factory

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
    assert asked.goals or asked.places
    few = name.startswith("up to three")
    low, high = (protocols.FEW, protocols.FEW) if few else protocols.AMONG
    assert low <= len(asked.start) <= high
    assert not asked.is_met(ended(asked.start)), "something must be done"
    if isinstance(asked, protocols.Likened):
        assert asked.is_met(ended(asked.like))


def ended(scene: Scene, contacts=()) -> Outcome:
    return Outcome(scene, scene, scene, 0, False, False, False, 0.0, contacts=contacts)
