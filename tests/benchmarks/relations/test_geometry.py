"""The relations that judge: each is told from where two objects are, and what touches."""

import math

import numpy as np
import pytest

from neurosym.world import Outcome, Scene
from tools.benchmarks.relations import by_hand
from tools.benchmarks.relations.geometry import fits, relation
from tools.benchmarks.relations.summary import summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.tasks import cells

SOLID, TRAY, TILTED = 0, 1, (0.0, math.sin(0.3), 0.0, math.cos(0.3))
UPRIGHT, QUARTER = (0.0, 0.0, 0.0, 1.0), (0.0, math.sin(math.pi / 4), 0.0, math.cos(math.pi / 4))
UNDER = (0.7, 0.1, 0.02)


def outcome(kind: int, where: tuple[float, float, float], *, touching: bool, turn=UPRIGHT) -> Outcome:
    scene = Scene(
        np.array([[0.05, 0.05, 0.06, 0], [0.15, 0.15, 0.04, kind]]),
        np.array([where, UNDER]),
        np.array([turn, UPRIGHT]),
    )
    return Outcome(scene, scene, scene, 0, False, False, False, 0.0, contacts=((0, 1),) if touching else ())


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
    scene = Scene(features, np.array([[0.7, 0.1, 0.02], [0.7, 0.1, 0.025]]), np.array([UPRIGHT, UPRIGHT]))
    rings = Outcome(scene, scene, scene, 0, False, False, False, 0.0)
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
