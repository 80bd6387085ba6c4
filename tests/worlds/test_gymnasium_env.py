"""Worlds as Gymnasium environments: they keep its rules, and report what interactions do."""

from functools import partial

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from standing import boxes

from neurosym.errors import InvalidValue, InvalidWorld, UnknownChoice
from neurosym.world import Place
from neurosym.worlds.gymnasium_env import MOST_STEPS, WorldEnv
from neurosym.worlds.toy import ToyWorld, make_world

LIFT = np.array([0, 0, 0, 1.0, 0, 0, 0, 1.0, 0, 0, 0, 0.0])
PUSH = np.array([-0.03, 0, 0, 0.0, 0, 0, 0, 0.0, 0.03, 0, 0, 0.0])
unbounded = pytest.mark.filterwarnings(r"ignore:.*A Box observation space m\w+ value is -?infinity")
"""Nothing bounds what a world calls features, nor how far an object falls."""


def scene_of_pucks(objects: int = 2):
    """Narrow solid pucks in the middle of the table, which can be grasped and pushed."""
    return boxes(*((0.05, 0.05, 0.04, 0.0, 0.7, 0.2 * number) for number in range(objects)))


@unbounded
@pytest.mark.parametrize(("name", "objects"), [("Toy", 3), ("Tabletop", 1)])
def test_environment_keeps_the_rules_of_gymnasium(name, objects):
    check_env(gymnasium.make(f"neurosym/{name}-v0", objects=objects).unwrapped)


def test_reward_is_how_far_the_target_was_moved_at_the_end_of_the_rise():
    env = WorldEnv("toy", objects=2)
    env.reset(options={"scene": scene_of_pucks(), "target": 1})
    observation, reward, terminated, truncated, info = env.step(LIFT)
    assert (reward, terminated, truncated) == (pytest.approx(0.2), False, False)
    assert (info["kind"], info["target"], info["touched"]) == ("held", 1, ())
    np.testing.assert_allclose(info["effect"], [0, 0, 0.2])
    np.testing.assert_allclose(info["resting_effect"], 0)
    np.testing.assert_array_equal(observation["positions"], scene_of_pucks().positions)
    observation, reward, *_ = env.step(PUSH)
    assert reward == pytest.approx(0.08)
    np.testing.assert_allclose(observation["positions"] - scene_of_pucks().positions, [[0] * 3, [0.08, 0, 0]])


def test_actions_may_be_relative_to_a_place():
    env = WorldEnv("toy", objects=1)
    small = scene_of_pucks(1)
    env.reset(options={"scene": small, "reference": Place(0.5, 0.2)})
    action = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0])
    observation, _, _, _, info = env.step(action)
    assert info["carried"] is True
    np.testing.assert_allclose(info["resting_effect"], 0, atol=1e-12)
    np.testing.assert_allclose(observation["positions"][0], [0.5, 0.2, 0.02])
    env.reset(options={"scene": small})
    assert "carried" not in env.step(action)[4]


def test_episode_ends_when_the_target_is_lost_or_after_fifty_steps():
    for world in (make_world, make_world(), partial(ToyWorld, make_world().config)):
        env = WorldEnv(world)
        env.reset(options={"scene": scene_of_pucks(1)})
        assert [env.step(PUSH)[2] for _ in range(4)] == [False, False, False, True]
    env = gymnasium.make("neurosym/Toy-v0", objects=2)
    one, again, other = (env.reset(seed=seed, options={"target": 1}) for seed in (0, 0, 1))
    assert one[1] == {"target": 1}
    assert one[0]["positions"].tobytes() == again[0]["positions"].tobytes() != other[0]["positions"].tobytes()
    assert env.reset()[1] == {"target": 0}
    assert [env.step(np.zeros(12))[3] for _ in range(MOST_STEPS)] == [False] * 49 + [True]


def test_what_an_environment_returns_is_the_callers_to_change():
    env = WorldEnv("toy")
    scene = scene_of_pucks(1)
    observation, _ = env.reset(options={"scene": scene})
    observation["positions"][:] = 9.0
    assert env.step(np.zeros(12))[0]["positions"][0, 0] == 0.7
    assert scene.positions[0, 0] == 0.7


def test_picture_shows_the_present_scene_if_it_is_asked_for():
    env, blind = WorldEnv("toy", render_mode="rgb_array"), WorldEnv("toy")
    for one in (env, blind):
        one.reset(options={"scene": scene_of_pucks(1)})
    before = env.render()
    assert (before.dtype, before.ndim) == (np.uint8, 3)
    env.step(PUSH)
    assert np.any(env.render() != before)
    assert blind.render() is None


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ({"target": 2}, "target = 2 must be one of the objects 0 to 1"),
        ({"goal": 1}, "no reset option 'goal'; valid: reference, scene, target"),
        ({"reference": (0.5, 0.0)}, "reference .* a Place or an OtherObject"),
        ({"scene": scene_of_pucks(3)}, "has 3 objects; this environment takes 2"),
        (lambda: WorldEnv("moon"), "no world 'moon'"),
        (lambda: WorldEnv("toy", objects=0), "objects = 0 must be at least 1"),
        (lambda: WorldEnv("toy", render_mode="human"), "no render mode 'human'; valid: rgb_array"),
        (lambda: WorldEnv("toy").step(np.zeros(12)), "reset"),
    ],
)
def test_what_cannot_be_is_refused(call, message):
    refusals = (InvalidValue, UnknownChoice, InvalidWorld, gymnasium.error.ResetNeeded)
    with pytest.raises(refusals, match=message):
        call() if callable(call) else WorldEnv("toy", objects=2).reset(options=call)
