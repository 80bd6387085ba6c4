"""The robot's world: what actions do, and that they do it again."""

import pickle

import numpy as np
import pytest

from neurosym.errors import InvalidValue
from neurosym.sim.camera import HEIGHT, WIDTH
from neurosym.sim.config import TabletopConfig, pybullet
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Scene

OPEN, CLOSED = 1.0, 0.0
LIFT = [0, 0, 0, OPEN, 0, 0, 0, CLOSED, 0, 0, 0.03, CLOSED]
WALL_LIFT = [0, 0.05, 0, OPEN, 0, 0.05, 0, CLOSED, 0, 0.05, 0.03, CLOSED]
PLACE = [0, 0, 0, OPEN, 0.05, 0.05, 0.02, CLOSED, 0.05, 0.05, 0.05, OPEN]
PUSHES = {
    "right": ([0, 0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, -0.05, 0, CLOSED], (1, -1)),
    "left": ([0, -0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, 0.05, 0, CLOSED], (1, 1)),
    "forward": ([-0.05, 0, 0, CLOSED, 0, 0, 0, CLOSED, 0.05, 0, 0, CLOSED], (0, 1)),
    "pull": ([0.05, 0, 0, CLOSED, 0, 0, 0, CLOSED, -0.05, 0, 0, CLOSED], (0, -1)),
}


def one_box(s_x: float, s_y: float, d: float, t: float) -> Scene:
    return Scene(
        features=np.array([[s_x, s_y, d, t]]),
        positions=np.array([[0.65, 0.0, d / 2]]),
        orientations=np.array([[0.0, 0.0, 0.0, 1.0]]),
    )


def perform(scene: Scene, action: list[float], **options: bool) -> Outcome:
    return Tabletop().interact(scene, np.array(action), 0, **options)


def same(first: Outcome, second: Outcome) -> bool:
    return all(
        getattr(first, when).positions.tobytes() == getattr(second, when).positions.tobytes()
        and getattr(first, when).orientations.tobytes() == getattr(second, when).orientations.tobytes()
        for when in ("start", "lifted", "end")
    )


@pytest.mark.parametrize("hollow", [0.0, 1.0])
def test_grasped_box_hangs_in_the_air_and_is_set_down_where_it_hung(hollow):
    outcome = perform(one_box(0.05, 0.05, 0.05, hollow), LIFT)
    assert outcome.held
    assert outcome.effect[2] == pytest.approx(0.23, abs=0.005)
    assert np.linalg.norm(outcome.resting_effect[:2] - outcome.effect[:2]) < 0.01
    assert abs(outcome.resting_effect[2]) < 0.001


def test_without_put_down_the_outcome_ends_in_mid_air():
    outcome = perform(one_box(0.05, 0.05, 0.05, 0), LIFT, put_down=False)
    assert outcome.held
    assert outcome.end is outcome.lifted


@pytest.mark.parametrize("direction", PUSHES)
def test_push_moves_the_box_its_way_and_leaves_it_on_the_table(direction):
    action, (axis, sign) = PUSHES[direction]
    outcome = perform(one_box(0.05, 0.05, 0.05, 0), action)
    assert 0.06 < sign * outcome.effect[axis] < 0.12
    assert abs(outcome.effect[1 - axis]) < 0.01
    assert abs(outcome.effect[2]) < 0.001
    assert not any((outcome.held, outcome.toppled, outcome.lost))


def test_pick_and_place_carries_the_box_and_ends_at_rest():
    outcome = perform(one_box(0.05, 0.05, 0.05, 0), PLACE)
    assert not outcome.held
    assert outcome.effect == pytest.approx([0.05, 0.05, 0.0], abs=0.006)
    assert outcome.peak_height > 0.015


def test_box_too_wide_to_span_is_lifted_by_a_wall_only_when_hollow():
    assert perform(one_box(0.1, 0.1, 0.06, 1), WALL_LIFT).held
    assert not perform(one_box(0.17, 0.17, 0.06, 0), WALL_LIFT).held


def test_pushing_a_tall_thin_box_topples_it_and_says_so():
    assert perform(one_box(0.08, 0.03, 0.09, 0), PUSHES["left"][0]).toppled


def test_object_beyond_the_edge_is_lost():
    scene = one_box(0.05, 0.05, 0.05, 0)
    edge = Scene(scene.features, np.array([[0.65, 0.29, 0.025]]), scene.orientations)
    assert perform(edge, PUSHES["left"][0]).lost


def test_interaction_has_the_same_bytes_in_any_order_and_in_a_used_world():
    world = Tabletop()
    rng = np.random.default_rng(5)
    tasks = [(world.sample_scene(rng, 2), world.action_box.sample(rng, 1)[0]) for _ in range(12)]
    forward = [world.interact(scene, action, 0) for scene, action in tasks]
    fresh = Tabletop()
    backward = [fresh.interact(scene, action, 0) for scene, action in reversed(tasks)][::-1]
    assert all(same(a, b) for a, b in zip(forward, backward, strict=True))


def test_other_actions_have_other_bytes():
    scene = one_box(0.05, 0.05, 0.05, 0)
    assert not same(perform(scene, LIFT), perform(scene, PLACE))


def test_end_of_an_interaction_is_at_rest_when_it_starts_the_next():
    outcome = perform(one_box(0.05, 0.05, 0.05, 0), PUSHES["left"][0])
    following = perform(outcome.end, LIFT)
    assert np.abs(following.start.positions - outcome.end.positions).max() < 5e-4


def test_bystander_keeps_its_place_and_is_reported():
    world = Tabletop()
    scene = Scene(
        features=np.array([[0.05, 0.05, 0.05, 0], [0.06, 0.06, 0.04, 1]], dtype=float),
        positions=np.array([[0.55, 0.0, 0.025], [0.75, 0.1, 0.02]]),
        orientations=np.tile([0.0, 0.0, 0.0, 1.0], (2, 1)),
    )
    outcome = world.interact(scene, np.array(LIFT), 0)
    assert outcome.held
    assert np.abs(outcome.end.positions[1] - scene.positions[1]).max() < 1e-3


def test_sampled_objects_do_not_overlap_and_stay_inside_the_margin():
    world = Tabletop()
    for seed in range(30):
        scene = world.sample_scene(np.random.default_rng(seed), 2)
        apart = np.abs(scene.positions[0] - scene.positions[1])[:2] - scene.features[:, :2].sum(axis=0) / 2
        assert apart.max() >= world.config.spawn_gap
        assert all(world.table.contains(position) for position in scene.positions)


def test_too_many_objects_are_refused():
    with pytest.raises(InvalidValue, match="40 objects do not fit"):
        Tabletop().sample_scene(np.random.default_rng(0), 40)


@pytest.mark.parametrize(
    ("action", "target", "message"),
    [
        (np.zeros(5), 0, r"shape \(5,\)"),
        (np.full(12, np.nan), 0, "not finite"),
        (np.zeros(12), 3, "no object 3"),
    ],
)
def test_impossible_requests_are_refused_in_one_sentence(action, target, message):
    with pytest.raises(InvalidValue, match=message):
        Tabletop().interact(one_box(0.05, 0.05, 0.05, 0), action, target)


@pytest.mark.parametrize(
    "options", [{"size": (0.2, 0.1)}, {"mass": -1.0}, {"wall": 0.05}, {"shapes": {"box": -1.0}}]
)
def test_impossible_configuration_is_refused(options):
    with pytest.raises(InvalidValue):
        TabletopConfig(**options)


def test_pictures_show_the_motion():
    frames = []
    Tabletop(TabletopConfig(frame_every=150)).interact(
        one_box(0.05, 0.05, 0.05, 0), np.array(LIFT), 0, on_frame=lambda frame, _phase: frames.append(frame)
    )
    assert len(frames) > 3
    assert frames[0].shape == (HEIGHT, WIDTH, 3)
    assert (frames[0] != frames[-1]).any()


def test_world_survives_pickling_for_worker_processes():
    world = Tabletop(TabletopConfig(lift_height=0.15))
    world.client()
    assert pickle.loads(pickle.dumps(world)).config == world.config


def boxes_at(*places, size=(0.03, 0.03, 0.04)):
    return Scene(
        features=np.array([[*size, 0.0]] * len(places)),
        positions=np.array([[x, y, size[2] / 2] for x, y in places]),
        orientations=np.tile([0.0, 0.0, 0.0, 1.0], (len(places), 1)),
    )


@pytest.mark.parametrize("target", [0, 1])
def test_whatever_hangs_from_the_hand_is_put_down_not_only_the_target(target):
    scene = boxes_at((0.6, 0.0), (0.6, -0.07))
    aside = -0.035 if target == 0 else 0.035  # the hand closes around both
    action = np.array([0, aside, 0, OPEN, 0, aside, 0, CLOSED, 0, aside, 0.03, CLOSED])
    outcome = Tabletop().interact(scene, action, target)
    assert outcome.lifted.positions[:, 2].max() > 0.15
    assert outcome.kind == "held"
    assert outcome.end.positions[:, 2].max() < 0.05
    again = Tabletop().interact(outcome.end, np.tile([0.05, 0.05, 0.025, 0.0], 3), 0)
    assert np.abs(again.start.positions - outcome.end.positions).max() < 2e-3


def test_bystander_that_is_lifted_instead_of_the_target_is_put_down_and_reported():
    scene = boxes_at((0.6, 0.1), (0.6, 0.06))
    around_the_other = np.array([0, -0.04, 0, OPEN, 0, -0.04, 0, CLOSED, 0, -0.04, 0.03, CLOSED])
    outcome = Tabletop().interact(scene, around_the_other, 0)
    assert outcome.end.positions[:, 2].max() < 0.05
    assert 1 in outcome.touched


def test_bystander_pushed_off_the_table_is_reported_as_lost():
    scene = boxes_at((0.65, -0.22), (0.65, -0.26))
    outcome = Tabletop().interact(scene, np.array(PUSHES["right"][0]), 0)
    assert (1, "lost") in outcome.disturbed


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        (boxes_at((0.6, 0.0), size=(0.03, -0.03, 0.04)), "size that is not greater than 0"),
        (
            Scene(np.ones((1, 3)), np.zeros((1, 3)), np.zeros((1, 4))),
            "features has shape",
        ),
        (boxes_at((np.nan, 0.0)), "not finite"),
    ],
)
def test_impossible_scenes_are_refused_in_one_sentence(scene, message):
    with pytest.raises(InvalidValue, match=message):
        Tabletop().interact(scene, np.zeros(12), 0)


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
