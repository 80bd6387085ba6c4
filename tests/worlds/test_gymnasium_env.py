"""Worlds as Gymnasium environments: they keep its rules, and report what interactions do."""

import subprocess
import sys
from functools import partial

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from neurosym.errors import InvalidValue, InvalidWorld, UnknownChoice
from neurosym.world import REQUIRED, Place
from neurosym.worlds.gymnasium_env import MOST_STEPS, WorldEnv
from neurosym.worlds.toy import ToyWorld, make_world

LIFT = np.array([0, 0, 0, 1.0, 0, 0, 0, 1.0, 0, 0, 0, 0.0])
PUSH = np.array([-0.03, 0, 0, 0.0, 0, 0, 0, 0.0, 0.03, 0, 0, 0.0])
unbounded = pytest.mark.filterwarnings(r"ignore:.*A Box observation space m\w+ value is -?infinity")
"""Nothing bounds what a world calls features, nor how far an object falls."""


def scene_of_pucks(objects: int = 2):
    """Narrow solid pucks in the middle of the table, which can be grasped and pushed."""
    scene = make_world().sample_scene(np.random.default_rng(0), objects)
    scene.features[:] = [0.05, 0.05, 0.04, 0.0]
    scene.positions[:, 0] = 0.7
    scene.positions[:, 1] = 0.2 * np.arange(objects)
    scene.positions[:, 2] = 0.02
    return scene


@unbounded
@pytest.mark.parametrize("objects", [1, 3])
@pytest.mark.parametrize("name", ["Toy", "Tabletop"])
def test_environment_keeps_the_rules_of_gymnasium(name, objects):
    check_env(gymnasium.make(f"neurosym/{name}-v0", objects=objects).unwrapped)


@pytest.mark.parametrize(
    "code",
    [
        "import gymnasium; env = gymnasium.make('neurosym.worlds.gymnasium_env:neurosym/Toy-v0')",
        "import gymnasium, neurosym; env = gymnasium.make('neurosym/Toy-v0')",
    ],
)
def test_environment_is_found_by_name(code):
    output = subprocess.run(
        [sys.executable, "-W", "error", "-c", f"{code}; print(env.reset(seed=0)[1])"],
        capture_output=True,
        text=True,
    )
    assert output.stdout.strip() == "{'target': 0}", output.stderr


def test_same_seed_gives_the_same_episode():
    def episode(seed):
        env = gymnasium.make("neurosym/Toy-v0", objects=2)
        env.action_space.seed(seed)
        steps = [env.reset(seed=seed)[0]]
        steps += [env.step(env.action_space.sample())[0] for _ in range(5)]
        return np.concatenate([step["positions"] for step in steps])

    assert episode(3).tobytes() == episode(3).tobytes()
    assert episode(3).tobytes() != episode(4).tobytes()


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


def test_episode_ends_when_the_target_is_lost():
    env = WorldEnv(make_world)
    env.reset(options={"scene": scene_of_pucks(1)})
    ends = [env.step(PUSH)[2] for _ in range(4)]
    assert ends == [False, False, False, True]


def test_episode_is_cut_off_after_fifty_steps():
    env = gymnasium.make("neurosym/Toy-v0")
    env.reset(seed=0)
    assert [env.step(np.zeros(12))[3] for _ in range(MOST_STEPS)] == [False] * 49 + [True]


def test_reset_takes_the_first_object_again_unless_told_otherwise():
    env = WorldEnv("toy", objects=2)
    assert env.reset(seed=0, options={"target": 1})[1] == {"target": 1}
    assert env.reset()[1] == {"target": 0}


def test_what_an_environment_returns_is_the_callers_to_change():
    env = WorldEnv("toy")
    scene = scene_of_pucks(1)
    observation, _ = env.reset(options={"scene": scene})
    observation["positions"][:] = 9.0
    assert env.step(np.zeros(12))[0]["positions"][0, 0] == 0.7
    assert scene.positions[0, 0] == 0.7


@pytest.mark.parametrize("world", ["toy", make_world(), make_world, partial(ToyWorld, make_world().config)])
def test_world_can_be_given_by_name_as_it_is_or_as_a_factory(world):
    assert WorldEnv(world).world.name == "toy"


def test_picture_shows_the_present_scene():
    env = WorldEnv("toy", render_mode="rgb_array")
    env.reset(options={"scene": scene_of_pucks(1)})
    before = env.render()
    assert (before.dtype, before.ndim) == (np.uint8, 3)
    env.step(PUSH)
    assert np.any(env.render() != before)


def test_world_that_only_films_shows_the_last_picture_of_the_last_step():
    class Filmed:
        def __init__(self):
            self._world = make_world()
            for name in REQUIRED:  # which newer Pythons look for without `__getattr__`
                setattr(self, name, getattr(self._world, name))

        def __getattr__(self, name):
            if name == "picture":
                raise AttributeError(name)
            return getattr(self._world, name)

    env = WorldEnv(Filmed, render_mode="rgb_array")
    env.reset(seed=0)
    assert env.render() is None
    env.step(PUSH)
    assert env.render().ndim == 3


def test_nothing_is_drawn_without_a_render_mode():
    env = WorldEnv("toy")
    env.reset(seed=0)
    assert env.render() is None


def test_environments_run_side_by_side():
    envs = gymnasium.make_vec("neurosym/Toy-v0", num_envs=2, vectorization_mode="sync")
    observations, _ = envs.reset(seed=1)
    assert observations["positions"].shape == (2, 1, 3)
    assert envs.step(np.zeros((2, 12)))[1].tolist() == [0.0, 0.0]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"target": 2}, "target = 2 must be one of the objects 0 to 1"),
        ({"target": -1}, "target = -1"),
        ({"goal": 1}, "no reset option 'goal'; valid: reference, scene, target"),
        ({"reference": (0.5, 0.0)}, "reference .* a Place or an OtherObject"),
        ({"scene": scene_of_pucks(3)}, "has 3 objects; this environment takes 2"),
    ],
)
def test_impossible_reset_is_refused(options, message):
    with pytest.raises((InvalidValue, UnknownChoice), match=message):
        WorldEnv("toy", objects=2).reset(options=options)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"world": "moon"}, "no world 'moon'"),
        ({"world": dict}, "lacks name"),
        ({"world": "toy", "objects": 0}, "objects = 0 must be at least 1"),
        ({"world": "toy", "render_mode": "human"}, "no render mode 'human'; valid: rgb_array"),
    ],
)
def test_impossible_environment_is_refused(arguments, message):
    with pytest.raises((InvalidValue, UnknownChoice, InvalidWorld), match=message):
        WorldEnv(**arguments)


def test_step_before_reset_is_refused():
    with pytest.raises(gymnasium.error.ResetNeeded):
        WorldEnv("toy").step(np.zeros(12))
