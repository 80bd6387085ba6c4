"""The robot's world: what actions do, and that they do it again; objects are built as their features say."""

from dataclasses import replace

import numpy as np
import pytest
from standing import CLOSED, OPEN, boxes

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.sim.config import (
    MOST_OBJECTS,
    TabletopConfig,
    pybullet,
)
from neurosym.sim.interaction import _landing_shift
from neurosym.sim.shapes import (
    OPEN_THROUGH,
    OPEN_TOP,
    SHAPES,
    SOLID,
    TEST_SHAPES,
    UNSEEN,
    body_of,
    sample_objects,
)
from neurosym.sim.simulation import Simulation, sample_scene
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Scene

LIFT = [0, 0, 0, OPEN, 0, 0, 0, CLOSED, 0, 0, 0.03, CLOSED]
WALL_LIFT = [0, 0.05, 0, OPEN, 0, 0.05, 0, CLOSED, 0, 0.05, 0.03, CLOSED]
LEFT = [0, -0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, 0.05, 0, CLOSED]
RIGHT = [0, 0.05, 0, CLOSED, 0, 0, 0, CLOSED, 0, -0.05, 0, CLOSED]
NARROW = (0.03, 0.03, 0.04, 0)


def perform(scene: Scene, action: list[float], **options: bool) -> Outcome:
    return Tabletop().interact(scene, np.array(action), 0, **options)


@pytest.mark.usefixtures("engine")
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


@pytest.mark.usefixtures("engine")
def test_what_is_too_wide_tall_and_thin_or_at_the_edge_is_not_lifted_topples_or_is_lost():
    assert perform(boxes((0.1, 0.1, 0.06, 1, 0.65, 0.0)), WALL_LIFT).held
    assert not perform(boxes((0.17, 0.17, 0.06, 0, 0.65, 0.0)), WALL_LIFT).held
    assert perform(boxes((0.08, 0.03, 0.09, 0, 0.65, 0.0)), LEFT).toppled
    assert perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.29)), LEFT).lost


@pytest.mark.usefixtures("engine")
def test_end_of_an_interaction_is_at_rest_when_it_starts_the_next():
    outcome = perform(boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0)), LEFT)
    following = perform(outcome.end, LIFT)
    assert np.abs(following.start.positions - outcome.end.positions).max() < 5e-4


def test_free_motion_is_not_simulated_and_ends_as_if_it_were(engine, monkeypatch):
    above, push = [0, 0, 0.2, OPEN, 0.05, 0, 0.2, OPEN, 0, 0, 0.2, CLOSED], LEFT
    scene, steps = boxes((0.05, 0.05, 0.05, 0, 0.65, 0.0)), []
    inner = Simulation._stepped

    def counted(simulation):
        steps.append(simulation.ticks)
        inner(simulation)

    monkeypatch.setattr(Simulation, "_stepped", counted)
    perform(scene, above)
    assert len(steps) < 0.25 * steps[-1], "only settling is simulated"
    steps.clear()
    skipped = perform(scene, push)
    few = len(steps)
    monkeypatch.setattr("neurosym.sim.robot.CLEARANCE", 10.0)  # everything is near
    steps.clear()
    whole = perform(scene, push)
    assert few < 0.7 * len(steps)
    near = {"pybullet": 1e-3, "mujoco": 1e-2}[engine]  # in MuJoCo a tenth of a millimetre may do as much
    assert np.abs(skipped.end.positions - whole.end.positions).max() < near


@pytest.mark.usefixtures("engine")
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


@pytest.mark.usefixtures("engine")
def test_bystander_pushed_off_the_table_is_reported_as_lost():
    scene = boxes((*NARROW, 0.65, -0.22), (*NARROW, 0.65, -0.26))
    outcome = Tabletop().interact(scene, np.array(RIGHT), 0)
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


# Objects of every shape, and scenes of many of them

LIKE = {"wall": 0.006, "mass": 0.1, "friction": 0.8}


def sizes(parts):
    """Sizes of the smallest box around the parts of an object, along x, y, z."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for part in parts:
        turned = np.abs(np.array(pybullet.getMatrixFromQuaternion(part.orientation)).reshape(3, 3))
        half = np.full(3, part.size[0]) if part.kind == "sphere" else turned @ np.array(part.size) / 2
        middle = np.array(part.position)
        low, high = np.minimum(low, middle - half), np.maximum(high, middle + half)
    return high - low


@pytest.mark.parametrize(("kind", "parts"), [(SOLID, 1), (OPEN_TOP, 5), (OPEN_THROUGH, 12)])
def test_object_is_as_large_as_its_features_say(kind, parts):
    body = body_of(np.array([0.12, 0.12, 0.05, kind]), (), **LIKE)
    assert len(body.parts) == parts
    assert sizes(body.parts) == pytest.approx([0.12, 0.12, 0.05], abs=0.004)


@pytest.mark.parametrize("number", range(1, 1 + len(TEST_SHAPES)))
def test_shapes_to_be_tried_on_are_as_large_as_they_look_and_stand_still(number):
    shape = [*TEST_SHAPES][number - 1]
    scene = sample_scene(TabletopConfig(shapes={shape: 1.0}), np.random.default_rng(number), 1)
    assert scene.unseen[0].tolist() == [number, 0, 0, 0, 0]
    body = body_of(scene.features[0], scene.unseen[0], **LIKE)
    assert len(body.parts) <= 16
    assert sizes(body.parts) == pytest.approx(scene.features[0, :3], abs=0.012)
    simulation = Simulation(Tabletop().client(), TabletopConfig(), scene)
    simulation.settle()
    now = simulation.observe()
    assert now.positions == pytest.approx(scene.positions, abs=2e-4)
    assert now.orientations == pytest.approx(scene.orientations, abs=2e-3)
    np.testing.assert_array_equal(now.unseen, scene.unseen)


@pytest.mark.usefixtures("engine")
def test_what_no_feature_shows_changes_what_happens():
    plain = boxes((0.1, 0.05, 0.05, 0.0, 0.65, 0.0))

    def lifted(**unseen: float) -> Outcome:
        row = [unseen.get(name, 0.0) for name in UNSEEN]
        return perform(replace(plain, unseen=np.array([row])), LIFT)

    assert lifted().held
    assert lifted(mass=0.5).held
    assert not lifted(mass=6.0, friction=0.1).held
    tilted = [lifted(heavy_end=share).lifted.orientations[0, 1] for share in (0.0, 0.8)]
    assert abs(tilted[1] - tilted[0]) > 0.001
    for row in ([0.0, 1.0], [0, -1, 0, 0, 0], [99, 0, 0, 0, 0], [0, 0, 0, 2, 0]):
        with pytest.raises(InvalidValue, match="unseen"):
            perform(replace(plain, unseen=np.array([row], dtype=float)), LIFT)


def drawn(shapes, objects):
    config = TabletopConfig()
    rng = np.random.default_rng(0)
    return sample_objects(rng, objects, shapes=shapes, size=config.size, height=config.height)[0]


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_keeps_to_the_ranges_of_the_world(shape):
    config = TabletopConfig()
    features = drawn({shape: 1.0}, 200)
    assert features[:, :2].min() >= config.size[0]
    assert features[:, :2].max() <= config.size[1]
    assert features[:, 2].min() >= config.height[0]
    assert features[:, 2].max() <= config.height[1]
    assert len(set(features[:, 3])) == 1


def test_planks_are_flat_and_long_and_rings_are_round_and_drawn_as_often_as_asked():
    planks, rings = drawn({"plank": 1.0}, 200), drawn({"ring": 1.0}, 200)
    assert planks[:, 2].max() <= 0.04
    assert (planks[:, :2].max(axis=1) / planks[:, :2].min(axis=1)).min() > 1.5
    assert np.array_equal(rings[:, 0], rings[:, 1])
    rings = drawn({"box": 3.0, "ring": 1.0}, 2000)[:, 3] == OPEN_THROUGH
    assert rings.mean() == pytest.approx(0.25, abs=0.03)


def test_eight_objects_stand_on_the_table_apart_from_one_another():
    config = TabletopConfig()
    with pytest.raises(InvalidValue, match="40 objects do not fit"):
        sample_scene(config, np.random.default_rng(0), 40)
    for seed in range(20):
        scene = sample_scene(config, np.random.default_rng(seed), MOST_OBJECTS)
        np.testing.assert_array_equal(scene.positions[:, 2], scene.features[:, 2] / 2)  # on the table
        half = scene.features[:, :2] / 2
        apart = np.abs(scene.positions[:, None, :2] - scene.positions[:, :2]) - (half[:, None] + half)
        others = ~np.eye(MOST_OBJECTS, dtype=bool)
        assert apart.max(axis=-1)[others].min() >= config.spawn_gap
        assert (np.abs(scene.positions[:, 1]) + half[:, 1]).max() <= 0.3


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"shapes": {"sphere": 1.0}}, "no shape 'sphere'; valid: ball, box, cylinder"),
        ({"shapes": {"box": 0.0}}, "a share greater than 0"),
        ({"size": (30.0, 180.0)}, "lengths are in metres"),
        ({"table_x": (0.4, 0.5)}, "shorter than the 0.24 m"),
        ({"size": (0.2, 0.1)}, "put the smaller number first"),
        ({"mass": -1.0}, "mass = -1.0 must be greater than 0"),
        ({"spawn_gap": -0.1}, "must not be negative"),
        ({"wall": 0.05}, "leaves no room inside"),
        ({"time_step": 1 / 60}, "between 1/2000 and 1/120"),
    ],
)
def test_impossible_world_is_refused_in_one_sentence(options, message):
    with pytest.raises(NeurosymError, match=message):
        TabletopConfig(**options)


def tilted_about_x(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


@pytest.mark.parametrize(("degrees", "lands"), [(0, False), (10, True), (30, True), (90, False)])
def test_tilted_object_shifts_as_it_turns_about_its_lowest_corner_and_one_on_a_face_does_not(degrees, lands):
    half_y, half_z, angle = 0.05, 0.02, np.radians(degrees)
    expected = half_y * (1 - np.cos(angle)) + half_z * np.sin(angle)
    shift = _landing_shift(np.array([0.08, 0.1, 0.04, 0.0]), tilted_about_x(degrees))
    assert shift == pytest.approx([0.0, expected * lands], abs=1e-9)  # its -y side is low and stays there
