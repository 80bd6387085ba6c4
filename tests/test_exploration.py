"""Exploration gives the same bytes for any number of workers, and after a kill."""

import os
import subprocess
import sys
import time
from functools import partial

import numpy as np
import pytest

from neurosym.effect_model import EffectModel
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.exploration import (
    INTERACTIONS_FILE,
    STATE_FILE,
    ExplorationConfig,
    choose_action,
    explore,
)
from neurosym.model_config import Dimensions, ModelConfig
from neurosym.strategies import MIN_EFFECT, STRATEGIES, has_high_effect
from neurosym.toy_world import ToyConfig, make_world

QUICK = ExplorationConfig(candidates=20, block=40, epochs=2)
SMALL = ModelConfig(hidden=16)


def run(steps=100, workers=1, factory=make_world, **options):
    options = {"seed": 3, "config": QUICK, "model_config": SMALL, **options}
    return explore(factory, steps=steps, workers=workers, **options)


def bytes_of(result, folder):
    interactions, model = result
    folder.mkdir(exist_ok=True)
    interactions.save(folder / "interactions.npz")
    model.save(folder / "model.safetensors")
    return (folder / "interactions.npz").read_bytes(), (folder / "model.safetensors").read_bytes()


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_every_strategy_makes_the_interactions_asked_for(strategy):
    interactions, model = run(strategy=strategy)
    assert len(interactions) == 100
    assert interactions.origin["strategy"] == strategy
    assert model.config.head == ("gaussian" if strategy == "curiosity" else "mean")


def test_one_worker_and_two_give_the_same_bytes(tmp_path):
    factory = partial(make_world, ToyConfig(lift_height=0.15))
    one = bytes_of(run(workers=1, factory=factory), tmp_path / "one")
    two = bytes_of(run(workers=2, factory=factory), tmp_path / "two")
    assert one == two


def test_another_seed_gives_other_interactions():
    first, _ = run(steps=5)
    second, _ = run(steps=5, seed=4)
    assert not np.array_equal(first.actions, second.actions)


def test_a_run_interrupted_between_blocks_resumes_to_the_same_bytes(tmp_path):
    whole = bytes_of(run(), tmp_path / "whole")
    stop_at_third_block = _stop_after(95)
    with pytest.raises(KeyboardInterrupt):
        run(checkpoint=tmp_path, progress=stop_at_third_block)
    assert bytes_of(run(checkpoint=tmp_path), tmp_path / "resumed") == whole


def test_interactions_written_ahead_of_the_state_are_made_again(tmp_path):
    whole = bytes_of(run(), tmp_path / "whole")
    run(steps=40, checkpoint=tmp_path)
    state = (tmp_path / STATE_FILE).read_bytes()
    run(steps=80, checkpoint=tmp_path)
    (tmp_path / STATE_FILE).write_bytes(state)  # as a kill between the two writes would leave it
    assert bytes_of(run(checkpoint=tmp_path), tmp_path / "resumed") == whole


KILLED = """
import sys
from pathlib import Path
sys.path.insert(0, {tests!r})
from test_exploration import run
if __name__ == "__main__":
    run(checkpoint=Path(sys.argv[1]), workers=2, steps=100_000)
"""


def test_a_killed_run_resumes_to_the_same_bytes_and_leaves_no_workers(tmp_path):
    script, state = tmp_path / "killed.py", tmp_path / STATE_FILE
    script.write_text(KILLED.format(tests=os.path.dirname(__file__)))  # noqa: PTH120 (a string is wanted)
    process = subprocess.Popen([sys.executable, script, tmp_path], stderr=subprocess.DEVNULL)
    try:
        assert _becomes_true(state.exists, 30)
        children = _children(process.pid)
    finally:
        process.kill()
        process.wait()
    assert children
    assert _becomes_true(lambda: not any(_is_alive(child) for child in children), 5)
    done = _blocks_done(state)
    steps = done * QUICK.block + 50
    resumed = bytes_of(run(steps=steps, checkpoint=tmp_path), tmp_path / "resumed")
    assert resumed == bytes_of(run(steps=steps), tmp_path / "whole")


def test_a_finished_run_can_be_extended(tmp_path):
    run(steps=50, checkpoint=tmp_path)
    extended = bytes_of(run(steps=100, checkpoint=tmp_path), tmp_path / "extended")
    assert extended == bytes_of(run(steps=100), tmp_path / "whole")


def test_a_finished_run_is_not_made_again(tmp_path):
    run(steps=80, checkpoint=tmp_path)
    calls = []
    interactions, _ = run(steps=80, checkpoint=tmp_path, progress=lambda *numbers: calls.append(numbers))
    assert len(interactions) == 80
    assert not calls


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"seed": 4}, "seed"),
        ({"strategy": "random"}, "strategy|model"),
        ({"config": ExplorationConfig(candidates=21, block=40, epochs=2)}, "candidates"),
        ({"origin": {"world_file": "other"}}, "world_file"),
    ],
)
def test_a_checkpoint_of_other_options_is_refused_and_the_option_named(tmp_path, options, named):
    run(steps=40, checkpoint=tmp_path)
    with pytest.raises(InvalidValue, match=f"with ({named}) = .* remove"):
        run(checkpoint=tmp_path, **options)


def test_fewer_steps_than_the_checkpoint_holds_are_refused(tmp_path):
    run(steps=80, checkpoint=tmp_path)
    with pytest.raises(InvalidValue, match="already holds 80"):
        run(steps=50, checkpoint=tmp_path)


def test_a_damaged_checkpoint_is_refused(tmp_path):
    run(steps=40, checkpoint=tmp_path)
    (tmp_path / INTERACTIONS_FILE).write_bytes(b"damaged")
    with pytest.raises(InvalidFile):
        run(checkpoint=tmp_path)


def test_unknown_strategies_and_no_workers_are_refused():
    with pytest.raises(UnknownChoice, match="curiosity"):
        run(strategy="greed")
    with pytest.raises(InvalidValue, match="workers"):
        run(workers=0)


def test_curiosity_chooses_what_a_naive_reading_of_algorithm_1_chooses():
    world, model = make_world(), EffectModel(Dimensions(), ModelConfig()).eval()
    config = ExplorationConfig(candidates=50)
    for number in range(5):
        task = choose_action(world, STRATEGIES["curiosity"], model, config, 7, number)
        rng = np.random.default_rng([7, number])
        scene = world.sample_scene(rng, 1)
        best, best_entropy = None, -np.inf
        for candidate in world.action_box.sample(rng, 50).astype(np.float32):
            _, variance = model.predict(scene.features, candidate[None])
            entropy = sum(0.5 * np.log(2 * np.pi * np.e * v) for v in variance[0]) / 3
            if entropy > best_entropy:
                best, best_entropy = candidate, entropy
        np.testing.assert_array_equal(task.action, best)
        np.testing.assert_array_equal(task.scene.positions, scene.positions)


def test_the_model_does_not_learn_from_a_block_that_is_not_whole():
    _, before = run(steps=39)
    _, after = run(steps=40)
    features, actions = np.full((1, 4), 0.1), np.full((1, 12), 0.01)
    assert np.all(before.effect_mean.numpy() == 0)
    assert not np.allclose(before.predict(features, actions)[0], after.predict(features, actions)[0])


def test_active_learning_learns_only_from_high_effects():
    effects = np.array([[0.05, -0.05, 0.0], [0.03, 0.0, 0.0], [0.0, 0.0, -MIN_EFFECT]])
    assert has_high_effect(effects).tolist() == [True, False, True]
    interactions, model = run(strategy="active", steps=120)
    if has_high_effect(interactions.effects).sum() >= 32:
        high = interactions.effects[has_high_effect(interactions.effects)]
        np.testing.assert_allclose(model.effect_mean.numpy(), high.mean(0), atol=1e-5)


def _stop_after(count):
    def progress(done, steps):
        if done >= count:
            raise KeyboardInterrupt

    return progress


def _becomes_true(condition, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.05)
    return False


def _children(pid):
    found = subprocess.run(
        ["ps", "-o", "pid=", "--ppid", str(pid)], capture_output=True, text=True, check=False
    )
    return [int(line) for line in found.stdout.split()]


def _is_alive(pid):
    found = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True, check=False)
    return bool(found.stdout.strip()) and not found.stdout.strip().startswith("Z")


def _blocks_done(state):
    from neurosym.exploration import FORMAT
    from neurosym.tensor_files import read_tensors

    return read_tensors(state, FORMAT)[1]["blocks"]
