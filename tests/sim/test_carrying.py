"""Actions with a place as reference, in the robot's world: what they carry, where, and always the same."""

import numpy as np
import pytest
from standing import CARRY, CLOSED, FAR, boxes

from neurosym.errors import InvalidValue
from neurosym.sim.config import TabletopConfig
from neurosym.sim.interaction import _grasp_opening
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Place
from neurosym.worlds.workers import Task, perform_all

MISS = np.array([0, 0, 0.025, CLOSED, 0, 0, 0.025, CLOSED, 0, 0, 0, CLOSED])
CORNERS = [Place(0.37, -0.28), Place(0.93, 0.28)]
BOX = (0.05, 0.05, 0.06, 0, 0.5, -0.1)
WIDE = (0.17, 0.17, 0.06, 0, 0.5, -0.1)
THERE = (0.05, 0.05, 0.06, 0, FAR.x, FAR.y)


@pytest.mark.parametrize("place", CORNERS)
def test_grasped_box_is_set_down_at_a_place_anywhere_on_the_table(place):
    outcome = Tabletop().interact(boxes(BOX), CARRY, 0, reference=place)
    assert outcome.carried
    assert outcome.kind == "carried"
    assert outcome.reference == place
    np.testing.assert_allclose(outcome.resting_effect, [0, 0, 0], atol=0.004)
    assert outcome.end is outcome.lifted


def test_third_waypoint_is_relative_to_the_place():
    action = CARRY + np.array([0] * 8 + [0.04, -0.03, 0, 0])
    outcome = Tabletop().interact(boxes(BOX), action, 0, reference=FAR)
    np.testing.assert_allclose(outcome.resting_effect[:2], [0.04, -0.03], atol=0.004)


@pytest.mark.parametrize(("scene", "action"), [(boxes(WIDE, THERE), CARRY), (boxes(BOX, THERE), MISS)])
def test_what_does_not_hang_from_the_hand_stays_and_the_hand_does_not_go_there(scene, action):
    outcome = Tabletop().interact(scene, action, 0, reference=FAR)
    assert not outcome.carried
    assert not outcome.held
    assert not outcome.touched
    assert np.linalg.norm(outcome.resting_effect) < 0.05


def test_what_is_carried_passes_over_what_stands_in_the_way():
    wall = (0.03, 0.18, 0.10, 0, 0.675, 0.05)
    outcome = Tabletop().interact(boxes(BOX, wall), CARRY, 0, reference=FAR)
    assert outcome.carried
    assert not outcome.touched
    assert not outcome.disturbed
    assert outcome.peak_height > wall[2]


def test_neighbours_of_the_place_stay_where_they_are():
    beside = (0.05, 0.05, 0.06, 0, FAR.x, FAR.y - 0.09)
    outcome = Tabletop().interact(boxes(BOX, beside), CARRY, 0, reference=FAR)
    assert outcome.carried
    assert not outcome.disturbed


@pytest.mark.parametrize("side", [-1, 1])
def test_neighbours_two_centimetres_from_the_target_stay_where_they_are(side):
    """The hand opens along y to 14 cm where it need not heed them."""
    beside = (0.05, 0.05, 0.06, 0, 0.5, -0.1 + side * 0.07)
    narrow = Tabletop().interact(boxes(BOX, beside), CARRY, 0, reference=FAR)
    assert narrow.carried
    assert not narrow.disturbed
    assert Tabletop().interact(boxes(BOX, beside), CARRY, 0).touched == (1,)


@pytest.mark.parametrize(("shift", "opening"), [(0.0, 0.031), (0.01, 0.041), (-0.01, 0.041)])
def test_hand_opens_around_what_it_can_span(shift, opening):
    simulation = Simulation(Tabletop().client(), TabletopConfig(), boxes(BOX))
    assert _grasp_opening(simulation, 0, BOX[5] + shift, 0.07) == pytest.approx(opening, abs=0.003)


def test_hand_opens_around_the_nearest_wall_of_what_is_too_wide():
    simulation = Simulation(Tabletop().client(), TabletopConfig(), boxes(WIDE))
    assert _grasp_opening(simulation, 0, WIDE[5] + 0.08, 0.07) == pytest.approx(0.011, abs=0.003)
    assert _grasp_opening(simulation, 0, WIDE[5], 0.07) == 0.07


def test_hand_waits_above_a_tower():
    tower = [(0.06, 0.06, 0.10, 0, 0.65, 0.0)] * 4
    scene = boxes(*tower, BOX)
    scene.positions[:4, 2] += 0.10 * np.arange(4)
    outcome = Tabletop().interact(scene, CARRY, 4, reference=Place(0.5, 0.2))
    assert outcome.carried
    assert not outcome.disturbed


def test_same_bytes_in_any_order_and_with_any_number_of_workers():
    tasks = [
        Task(Tabletop().sample_scene(np.random.default_rng(n), 1), CARRY, reference=FAR) for n in range(6)
    ]
    one, two = (
        [outcome.end.positions.tobytes() for outcome in perform_all(Tabletop, tasks, workers)]
        for workers in (1, 2)
    )
    reverse = [outcome.end.positions.tobytes() for outcome in perform_all(Tabletop, tasks[::-1], 1)]
    assert one == two == reverse[::-1]


def test_place_off_the_table_is_refused_in_one_sentence():
    message = (
        r"The place \(1.2, 0\) lies off the table; valid: x from 0.35 to 0.95 m and y from -0.3 to 0.3 m"
    )
    with pytest.raises(InvalidValue, match=message):
        Tabletop().interact(boxes(BOX), CARRY, 0, reference=Place(1.2, 0.0))


@pytest.mark.parametrize("values", [(np.nan, 0.0), (0.0, np.inf)])
def test_impossible_place_is_refused(values):
    with pytest.raises(InvalidValue, match=r"Place\.[xy] = .* must be finite"):
        Place(*values)


def test_carrying_can_be_filmed():
    phases = []
    world = Tabletop(TabletopConfig(frame_every=30))  # a film of few pictures
    filmed = world.interact(
        boxes(BOX), CARRY, 0, reference=FAR, on_frame=lambda _, phase: phases.append(phase)
    )
    plain = Tabletop().interact(boxes(BOX), CARRY, 0, reference=FAR)
    assert list(dict.fromkeys(phases))[-3:] == ["carry", "put down", "rise"]
    assert filmed.end.positions.tobytes() == plain.end.positions.tobytes()


def test_what_the_hand_would_take_along_by_mistake_is_not_carried_away():
    """Two narrow boxes side by side, gripped together: neither is carried."""
    pair = ((0.05, 0.03, 0.06, 0, 0.5, 0.0), (0.05, 0.03, 0.06, 0, 0.5, 0.031))
    between = CARRY + np.array([0, 0.0155, 0, 0] * 2 + [0] * 4)
    outcome = Tabletop().interact(boxes(*pair), between, 0, reference=FAR)
    assert 1 in outcome.touched
    assert not outcome.carried
    assert outcome.kind == "missed"
    assert np.all(outcome.end.positions[:, 0] < 0.6)
