"""Exploration gives the same bytes for any number of workers, and after a kill."""

import subprocess
import sys
import time
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from places import ROOT

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import STRATEGIES
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import FORMAT, INTERACTIONS_FILE, STATE_FILE, ExplorationConfig, explore
from neurosym.learning.training_config import ModelConfig
from neurosym.worlds.toy import ToyConfig, make_world

BRIEF = LearningConfig(epochs=2, ensemble=2, ensemble_hidden=16)
QUICK = ExplorationConfig(candidates=20, block=40, learning=BRIEF)
SMALL = ModelConfig(hidden=16)
CURIOUS = ["disagreement", "entropy"]


def run(steps=100, workers=1, factory=make_world, **options):
    options = {"seed": 3, "config": QUICK, "model_config": SMALL, **options}
    return explore(factory, steps=steps, workers=workers, **options)


def bytes_of(folder, **options):
    """Explore, and return the bytes of the interactions and of the networks that chose them."""
    folder.mkdir(exist_ok=True)
    run(checkpoint=folder, **options).save(folder / "interactions.npz")
    return (folder / "interactions.npz").read_bytes(), (folder / STATE_FILE).read_bytes()


def state_after(folder, **options):
    """Explore, and return the arrays of the networks."""
    folder.mkdir(exist_ok=True)
    run(checkpoint=folder, **options)
    return read_tensors(folder / STATE_FILE, FORMAT)[0]


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_every_strategy_makes_the_interactions_asked_for(strategy):
    interactions = run(strategy=strategy)
    assert len(interactions) == 100
    assert interactions.origin["strategy"] == strategy


@pytest.mark.parametrize("strategy", ["random", "active"])
def test_strategies_without_curiosity_keep_no_networks_and_take_the_first_candidate(strategy, tmp_path):
    assert state_after(tmp_path / "a", strategy=strategy, steps=80) == {}
    config = ExplorationConfig(candidates=1, block=40)
    np.testing.assert_array_equal(
        run(strategy=strategy).actions, run(strategy="random", config=config).actions
    )


def test_curiosity_is_another_name_of_entropy():
    one, other = (run(strategy=name) for name in ("curiosity", "entropy"))
    np.testing.assert_array_equal(one.actions, other.actions)


@pytest.mark.parametrize("strategy", CURIOUS)
def test_one_worker_and_two_give_the_same_bytes(strategy, tmp_path):
    factory = partial(make_world, ToyConfig(lift_height=0.15))
    options = {"factory": factory, "strategy": strategy}
    assert bytes_of(tmp_path / "1", **options) == bytes_of(tmp_path / "2", workers=2, **options)


def test_another_seed_gives_other_interactions():
    assert not np.array_equal(run(steps=5).actions, run(steps=5, seed=4).actions)


@pytest.mark.parametrize("strategy", CURIOUS)
def test_a_run_interrupted_between_blocks_resumes_to_the_same_bytes(strategy, tmp_path):
    with pytest.raises(KeyboardInterrupt):
        run(strategy=strategy, checkpoint=tmp_path, progress=_stop_after(95))
    assert bytes_of(tmp_path, strategy=strategy) == bytes_of(tmp_path / "whole", strategy=strategy)


def test_interactions_written_ahead_of_the_state_are_made_again(tmp_path):
    run(steps=40, checkpoint=tmp_path)
    state = (tmp_path / STATE_FILE).read_bytes()
    run(steps=80, checkpoint=tmp_path)
    (tmp_path / STATE_FILE).write_bytes(state)  # as a kill between the two writes would leave it
    assert bytes_of(tmp_path) == bytes_of(tmp_path / "whole")


KILLED = """
import sys
from pathlib import Path
sys.path[:0] = {tests!r}
from test_loop import run
if __name__ == "__main__":
    run(checkpoint=Path(sys.argv[1]), strategy=sys.argv[2], workers=2, steps=100_000)
"""


@pytest.mark.parametrize("strategy", CURIOUS)
def test_a_killed_run_resumes_to_the_same_bytes_and_leaves_no_workers(strategy, tmp_path):
    script, state = tmp_path / "killed.py", tmp_path / STATE_FILE
    script.write_text(KILLED.format(tests=[str(Path(__file__).parent), str(ROOT / "tests")]))
    process = subprocess.Popen([sys.executable, script, tmp_path, strategy], stderr=subprocess.DEVNULL)
    try:
        assert _becomes_true(state.exists, 120)
        children = _children(process.pid)
    finally:
        process.kill()
        process.wait()
    assert children
    assert _becomes_true(lambda: not any(_is_alive(child) for child in children), 5)
    steps = read_tensors(state, FORMAT)[1]["blocks"] * QUICK.block + 50
    options = {"steps": steps, "strategy": strategy}
    assert bytes_of(tmp_path, **options) == bytes_of(tmp_path / "whole", **options)


def test_a_finished_run_can_be_extended(tmp_path):
    run(steps=50, checkpoint=tmp_path)
    assert bytes_of(tmp_path) == bytes_of(tmp_path / "whole")


def test_a_finished_run_is_not_made_again(tmp_path):
    run(steps=80, checkpoint=tmp_path)
    calls = []
    interactions = run(steps=80, checkpoint=tmp_path, progress=lambda *numbers: calls.append(numbers))
    assert len(interactions) == 80
    assert not calls


@pytest.mark.parametrize("strategy", CURIOUS)
def test_networks_do_not_learn_from_a_block_that_is_not_whole(strategy, tmp_path):
    before = state_after(tmp_path / "39", strategy=strategy, steps=39)
    after = state_after(tmp_path / "40", strategy=strategy, steps=40)
    more = state_after(tmp_path / "79", strategy=strategy, steps=79)
    assert not any("/adam/" in name for name in before)
    assert np.all(before["0/model/effect_std"] == 1)
    assert any("/adam/" in name for name in after)
    assert np.all(after["0/model/effect_std"] < 0.5)
    assert after.keys() == more.keys()
    assert all(np.array_equal(after[name], more[name]) for name in after)


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"seed": 4}, "seed"),
        ({"strategy": "random"}, "strategy"),
        ({"config": replace(QUICK, candidates=21)}, "candidates"),
        ({"config": replace(QUICK, min_predicted_effect=0.1)}, "min_predicted_effect"),
        ({"config": replace(QUICK, learning=replace(BRIEF, ensemble=3))}, "learning"),
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


@pytest.mark.parametrize("file", [INTERACTIONS_FILE, STATE_FILE])
def test_a_damaged_checkpoint_is_refused_by_name(file, tmp_path):
    run(steps=40, checkpoint=tmp_path)
    path = tmp_path / file
    for content in (b"damaged", path.read_bytes()[: path.stat().st_size // 2]):
        path.write_bytes(content)
        with pytest.raises(InvalidFile, match=file):
            run(checkpoint=tmp_path)


def test_a_state_without_its_interactions_or_with_those_of_another_is_refused(tmp_path):
    run(steps=40, checkpoint=tmp_path)
    (tmp_path / "other").mkdir()
    run(steps=40, checkpoint=tmp_path / "other", seed=4)
    (tmp_path / "other" / INTERACTIONS_FILE).replace(tmp_path / INTERACTIONS_FILE)
    with pytest.raises(InvalidFile, match="it is of another exploration"):
        run(checkpoint=tmp_path)
    (tmp_path / INTERACTIONS_FILE).unlink()
    with pytest.raises(InvalidFile, match=f"{INTERACTIONS_FILE} is missing"):
        run(checkpoint=tmp_path)


@pytest.mark.parametrize(
    "changes", [{"blocks": "x"}, {"blocks": None}, {"blocks": 1.5}, {"blocks": -1}, {"options": [1]}]
)
def test_a_state_that_does_not_say_what_it_is_is_refused(changes, tmp_path):
    run(steps=40, checkpoint=tmp_path)
    arrays, description = read_tensors(tmp_path / STATE_FILE, FORMAT)
    write_tensors(tmp_path / STATE_FILE, FORMAT, arrays, description | changes)
    with pytest.raises(InvalidFile, match="does not say"):
        run(checkpoint=tmp_path)


def without(*parts):
    return lambda arrays: {
        name: array for name, array in arrays.items() if not any(part in name for part in parts)
    }


def cut_short(part):
    return lambda arrays: {
        name: array[..., :-1] if part in name and array.ndim else array for name, array in arrays.items()
    }


@pytest.mark.parametrize("strategy", CURIOUS)
@pytest.mark.parametrize(
    "damage",
    [
        without(""),
        without("0/model"),
        without("0/adam"),
        without("exp_avg_sq"),
        without("effect_std"),
        cut_short("weight"),
        cut_short("exp_avg"),
        lambda arrays: {**arrays, "what": np.zeros(1)},
    ],
)
def test_a_checkpoint_with_other_weights_is_refused(strategy, damage, tmp_path):
    run(steps=40, strategy=strategy, checkpoint=tmp_path)
    arrays, description = read_tensors(tmp_path / STATE_FILE, FORMAT)
    write_tensors(tmp_path / STATE_FILE, FORMAT, damage(arrays), description)
    with pytest.raises(InvalidFile, match="weights do not fit"):
        run(strategy=strategy, checkpoint=tmp_path)


def test_no_workers_are_refused():
    with pytest.raises(InvalidValue, match="workers"):
        run(workers=0)


@pytest.mark.parametrize("strategy", ["random", "active"])
def test_strategies_that_predict_nothing_cannot_filter_by_it(strategy):
    config = replace(QUICK, min_predicted_effect=0.1)
    with pytest.raises(InvalidValue, match="valid with it: disagreement, entropy"):
        run(strategy=strategy, config=config)


@pytest.mark.parametrize("option", [{"candidates": 0}, {"block": 0}, {"min_predicted_effect": -0.1}])
def test_impossible_options_are_refused(option):
    with pytest.raises(InvalidValue, match=next(iter(option))):
        ExplorationConfig(**option)


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
