"""The robot's world: what actions do, and that they do it again."""

import numpy as np
import pytest
from standing import CLOSED, OPEN, boxes

from neurosym.errors import InvalidValue
from neurosym.sim.config import TabletopConfig, pybullet
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Scene

LIFT = [0, 0, 0, OPEN, 0, 0, 0, CLOSED, 0, 0, 0.03, CLOSED]
WALL_LIFT = [0, 0.05, 0, OPEN, 0, 0.05, 0, CLOSED, 0, 0.05, 0.03, CLOSED]
PLACE = [0, 0, 0, OPEN, 0.05, 0.05, 0.02, CLOSED, 0.05, 0.05, 0.05, OPEN]
PUSHES = {
    "right": ([0, 0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, -0.05, 0, CLOSED], (1, -1)),
    "left": ([0, -0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, 0.05, 0, CLOSED], (1, 1)),
    "forward": ([-0.05, 0, 0, CLOSED, 0, 0, 0, CLOSED, 0.05, 0, 0, CLOSED], (0, 1)),
    "pull": ([0.05, 0, 0, CLOSED, 0, 0, 0, CLOSED, -0.05, 0, 0, CLOSED], (0, -1)),
}

NARROW = (0.03, 0.03, 0.04, 0)


def perform(scene: Scene, action: list[float], **options: bool) -> Outcome:
    return Tabletop().interact(scene, np.array(action), 0, **options)


@pytest.mark.parametrize("hollow", [0.0, 1.0])
def test_grasped_box_hangs_in_the_air_and_is_set_down_where_it_hung(hollow):
    outcome = perform(boxes((0.05, 0.05, 0.05, hollow, 0.65, 0.0)), LIFT)
    assert outcome.held
    assert outcome.effect[2] == pytest.approx(0.23, abs=0.005)
    assert np.linalg.norm(outcome.resting_effect[:2] - outcome.effect[:2]) < 0.01
    assert abs(outcome.resting_effect[2]) < 0.001
    aloft = perform(boxes((0.05, 0.05, 0.05, hollow, 0.65, 0.0)), LIFT, put_down=False)
    assert aloft.held
    assert aloft.end is aloft.lifted


@pytest.mark.parametrize("direction", PUSHES)
def test_push_moves_the_box_its_way_and_leaves_it_on_the_table(direction):
    action, (axis, sign) = PUSHES[direction]
    outcome = perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0)), action)
    assert 0.06 < sign * outcome.effect[axis] < 0.12
    assert abs(outcome.effect[1 - axis]) < 0.01
    assert abs(outcome.effect[2]) < 0.001
    assert not any((outcome.held, outcome.toppled, outcome.lost))


def test_pick_and_place_carries_the_box_and_ends_at_rest():
    outcome = perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0)), PLACE)
    assert not outcome.held
    assert outcome.effect == pytest.approx([0.05, 0.05, 0.0], abs=0.006)
    assert outcome.peak_height > 0.015


def test_what_is_too_wide_tall_and_thin_or_at_the_edge_is_not_lifted_topples_or_is_lost():
    assert perform(boxes((0.1, 0.1, 0.06, 1, 0.65, 0.0)), WALL_LIFT).held
    assert not perform(boxes((0.17, 0.17, 0.06, 0, 0.65, 0.0)), WALL_LIFT).held
    assert perform(boxes((0.08, 0.03, 0.09, 0, 0.65, 0.0)), PUSHES["left"][0]).toppled
    assert perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.29)), PUSHES["left"][0]).lost


def test_end_of_an_interaction_is_at_rest_when_it_starts_the_next():
    outcome = perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0)), PUSHES["left"][0])
    following = perform(outcome.end, LIFT)
    assert np.abs(following.start.positions - outcome.end.positions).max() < 5e-4


@pytest.mark.parametrize("target", [0, 1])
def test_whatever_hangs_from_the_hand_is_put_down_not_only_the_target(target):
    scene = boxes((*NARROW, 0.6, 0.0), (*NARROW, 0.6, -0.07))
    aside = -0.035 if target == 0 else 0.035  # the hand closes around both
    action = np.array([0, aside, 0, OPEN, 0, aside, 0, CLOSED, 0, aside, 0.03, CLOSED])
    outcome = Tabletop().interact(scene, action, target)
    assert outcome.lifted.positions[:, 2].max() > 0.15
    assert outcome.kind == "held"
    assert outcome.end.positions[:, 2].max() < 0.05
    again = Tabletop().interact(outcome.end, np.tile([0.05, 0.05, 0.025, 0.0], 3), 0)
    assert np.abs(again.start.positions - outcome.end.positions).max() < 2e-3


def test_bystander_pushed_off_the_table_is_reported_as_lost():
    scene = boxes((*NARROW, 0.65, -0.22), (*NARROW, 0.65, -0.26))
    outcome = Tabletop().interact(scene, np.array(PUSHES["right"][0]), 0)
    assert (1, "lost") in outcome.disturbed


BOX = boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0))


@pytest.mark.parametrize(
    ("scene", "target", "message"),
    [
        (BOX, 3, "no object 3"),
        (boxes((0.03, -0.03, 0.04, 0, 0.6, 0.0)), 0, "size that is not greater than 0"),
        (boxes(*[(*NARROW, 0.6, 0.0)] * 9), 0, "9 objects; the simulator takes at most 8"),
    ],
)
def test_what_cannot_be_performed_is_refused_in_one_sentence(scene, target, message):
    with pytest.raises(InvalidValue, match=message):
        Tabletop().interact(scene, np.zeros(12), target)


@pytest.mark.parametrize(
    "options", [{"table_x": (2.0, 2.6)}, {"lift_height": 5.0}, {"table_y": (-300.0, 300.0)}]
)
def test_table_out_of_the_arms_reach_is_refused_and_the_option_named(options):
    with pytest.raises(InvalidValue, match=rf"{next(iter(options))} = .* more than the arm reaches"):
        Tabletop(TabletopConfig(**options))


def test_every_scene_is_simulated_with_its_pairs_of_touching_objects_sorted(monkeypatch):
    """Without it effects depend on what was simulated before; a few interactions would not show that."""
    given, set_parameters = [], pybullet.setPhysicsEngineParameter

    def spy(**parameters):
        given.append(parameters)
        set_parameters(**parameters)

    monkeypatch.setattr(pybullet, "setPhysicsEngineParameter", spy)
    world, rng = Tabletop(), np.random.default_rng(0)
    for _ in range(2):
        world.interact(world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0], 0)
    assert len(given) >= 2
    assert all(parameters["deterministicOverlappingPairs"] == 1 for parameters in given)
    assert all(parameters["numSolverIterations"] == 50 for parameters in given)
