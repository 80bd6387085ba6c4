"""Exploration gives the same bytes for any number of workers, and after it was interrupted."""

import shutil
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import STRATEGIES, own_name
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


@pytest.mark.parametrize("strategy", [*STRATEGIES, "curiosity"])
def test_every_strategy_makes_the_interactions_asked_for(strategy, tmp_path):
    interactions, meant = run(strategy=strategy, checkpoint=tmp_path), own_name(strategy)
    assert len(interactions) == 100
    assert interactions.origin["strategy"] == meant
    if meant not in CURIOUS:  # the first candidate is taken, and there are no networks
        first = run(strategy="random", config=replace(QUICK, candidates=1))
        np.testing.assert_array_equal(interactions.actions, first.actions)
        assert read_tensors(tmp_path / STATE_FILE, FORMAT)[0] == {}


@pytest.mark.parametrize("strategy", CURIOUS)
def test_one_worker_and_two_give_the_same_bytes(strategy, tmp_path):
    factory = partial(make_world, ToyConfig(lift_height=0.15))
    options = {"factory": factory, "strategy": strategy}
    one = bytes_of(tmp_path / "1", **options)
    assert (
        one == bytes_of(tmp_path / "2", workers=2, **options) != bytes_of(tmp_path / "3", **options, seed=4)
    )


@pytest.mark.parametrize("strategy", CURIOUS)
def test_a_run_interrupted_between_blocks_resumes_to_the_same_bytes(strategy, tmp_path):
    def stop(done, steps):
        if done >= 95:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(strategy=strategy, checkpoint=tmp_path, progress=stop)
    assert bytes_of(tmp_path, strategy=strategy) == bytes_of(tmp_path / "whole", strategy=strategy)


def test_interactions_written_ahead_of_the_state_are_made_again(tmp_path):
    run(steps=40, checkpoint=tmp_path)
    state = (tmp_path / STATE_FILE).read_bytes()
    run(steps=80, checkpoint=tmp_path)
    (tmp_path / STATE_FILE).write_bytes(state)  # as a kill between the two writes would leave it
    assert bytes_of(tmp_path) == bytes_of(tmp_path / "whole")


def test_a_finished_run_is_not_made_again_and_can_be_extended(tmp_path):
    run(steps=50, checkpoint=tmp_path)
    calls = []
    assert len(run(steps=40, checkpoint=tmp_path, progress=lambda *told: calls.append(told))) == 40
    assert not calls
    assert bytes_of(tmp_path) == bytes_of(tmp_path / "whole")
    with pytest.raises(InvalidValue, match="already holds 80"):
        run(steps=50, checkpoint=tmp_path)


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"seed": 4}, "seed"),
        ({"strategy": "random"}, "strategy"),
        ({"config": replace(QUICK, candidates=21)}, "candidates"),
        ({"config": replace(QUICK, learning=replace(BRIEF, ensemble=3))}, "learning"),
        ({"origin": {"world_file": "other"}}, "world_file"),
    ],
)
def test_a_checkpoint_of_other_options_is_refused_and_the_option_named(kept, options, named):
    with pytest.raises(InvalidValue, match=f"with ({named}) = .* remove"):
        run(checkpoint=kept["disagreement"], **options)


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Folders in which one block of each curious strategy is kept; tests must not change them."""
    folders = {strategy: tmp_path_factory.mktemp(strategy) for strategy in CURIOUS}
    for strategy, folder in folders.items():
        run(steps=40, strategy=strategy, checkpoint=folder)
    return folders


@pytest.fixture
def begun(kept, tmp_path):
    """A copy of one of them that a test may change."""
    return Path(shutil.copytree(kept["disagreement"], tmp_path / "begun"))


def test_a_state_without_its_interactions_or_with_those_of_another_is_refused(begun, tmp_path):
    (tmp_path / "other").mkdir()
    run(steps=40, checkpoint=tmp_path / "other", seed=4)
    (tmp_path / "other" / INTERACTIONS_FILE).replace(begun / INTERACTIONS_FILE)
    with pytest.raises(InvalidFile, match="it is of another exploration"):
        run(checkpoint=begun)
    (begun / INTERACTIONS_FILE).unlink()
    with pytest.raises(InvalidFile, match=f"{INTERACTIONS_FILE} is missing"):
        run(checkpoint=begun)


def without(part):
    return lambda arrays: {name: array for name, array in arrays.items() if part not in name}


def cut_short(part):
    return lambda arrays: {
        name: array[..., :-1] if part in name and array.ndim else array for name, array in arrays.items()
    }


@pytest.mark.parametrize("strategy", CURIOUS)
@pytest.mark.parametrize(
    "damage",
    [
        *({"blocks": blocks} for blocks in ("x", None, 1.5, -1)),
        {"options": [1]},
        *map(without, ("", "0/model", "0/adam", "exp_avg_sq", "effect_std")),
        *map(cut_short, ("weight", "exp_avg")),
        lambda arrays: {**arrays, "what": np.zeros(1)},
    ],
)
def test_a_state_that_does_not_say_what_it_is_or_has_other_weights_is_refused(
    strategy, damage, kept, tmp_path
):
    shutil.copytree(kept[strategy], tmp_path, dirs_exist_ok=True)
    arrays, description = read_tensors(tmp_path / STATE_FILE, FORMAT)
    is_told = not callable(damage)
    changed = (arrays, description | damage) if is_told else (damage(arrays), description)
    write_tensors(tmp_path / STATE_FILE, FORMAT, *changed)
    with pytest.raises(InvalidFile, match="does not say" if is_told else "weights do not fit"):
        run(strategy=strategy, checkpoint=tmp_path)
