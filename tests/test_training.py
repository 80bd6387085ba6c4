"""Training makes bits that hold what the effect needs, and always the same ones."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch

from neurosym.effect_model import EffectModel
from neurosym.errors import InvalidValue
from neurosym.exploration import ExplorationConfig, explore
from neurosym.fitting import negative_log_likelihood, nt_xent, reproducible, run_epochs, total_loss
from neurosym.interactions import Interactions
from neurosym.model_config import Dimensions, ModelConfig
from neurosym.recipes import RECIPES
from neurosym.toy_world import make_world
from neurosym.training import assess, r_squared, split, train
from neurosym.training_config import REGIMES, TrainingConfig

BRIEF = TrainingConfig(restarts=1, epochs=2, batch=64, encoder_epochs=2, refit_epochs=2, teacher_actions=100)
SMALL = ModelConfig(hidden=16)


@cache
def toy_data(count):
    config = ExplorationConfig(candidates=1, block=count + 1)
    return explore(make_world, steps=count, strategy="random", seed=0, config=config)


def test_nll_is_that_of_the_normal_distribution():
    generator = torch.Generator().manual_seed(0)
    mean, log_variance, effects = torch.randn(3, 20, 3, generator=generator)
    normal = torch.distributions.Normal(mean, (log_variance / 2).exp())
    torch.testing.assert_close(
        negative_log_likelihood(mean, log_variance, effects), -normal.log_prob(effects).mean()
    )


def test_nt_xent_agrees_with_eq_8_read_naively():
    z = torch.randn(12, 5, generator=torch.Generator().manual_seed(0))
    unit = z / z.norm(dim=1, keepdim=True)
    total = 0.0
    for i in range(12):
        s = [float(unit[i] @ unit[j]) for j in range(12)]
        total -= np.log(np.exp(s[i] / 0.5) / sum(np.exp(value / 0.5) for value in s)) / 12
    assert float(nt_xent(z, 0.5)) == pytest.approx(total, rel=1e-5)


def test_the_coefficient_multiplies_both_terms():
    data, model = toy_data(300), EffectModel(Dimensions(), SMALL).eval()
    batch = [torch.from_numpy(column) for column in (data.features, data.actions, data.effects)]
    with reproducible(0):
        one, half = (total_loss(model, *batch, coefficient=c, temperature=0.1).item() for c in (1.0, 0.5))
        without = total_loss(model, *batch, coefficient=1.0, temperature=None).item()
    assert half == pytest.approx(one / 2)
    assert one != without


def test_every_sample_is_seen_once_in_an_epoch():
    weight = torch.nn.Parameter(torch.zeros(1))
    seen = []

    def loss_of(rows):
        seen.extend(rows.tolist())
        return weight.sum()

    optimiser = torch.optim.SGD([weight], lr=0.1)
    run_epochs(loss_of, 23, optimiser, torch.Generator(), epochs=3, batch=5, clip_norm=1.0, decay=True)
    assert sorted(seen) == sorted([*range(23)] * 3)
    assert optimiser.param_groups[0]["lr"] == 0.1


@pytest.mark.parametrize("recipe", RECIPES)
def test_the_same_seed_gives_the_same_bytes(recipe, tmp_path):
    config = TrainingConfig(
        recipe=recipe, restarts=1, epochs=2, encoder_epochs=2, refit_epochs=2, teacher_actions=100
    )
    for name, seed in (("a", 5), ("b", 5), ("c", 6)):
        train(toy_data(300), config=config, model_config=SMALL, seed=seed)[0].save(tmp_path / name)
        torch.rand(3)  # what happens outside changes nothing
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    assert (tmp_path / "a").read_bytes() != (tmp_path / "c").read_bytes()


def test_training_leaves_the_callers_random_state_alone():
    before = torch.random.get_rng_state()
    with reproducible(3):
        torch.rand(5)
    assert torch.equal(before, torch.random.get_rng_state())


def planted_kinds(count):
    """Perform lifts, pushes in four directions and nothing, each a little different every time."""
    world, rng = make_world(), np.random.default_rng(0)
    travels = np.array([[0, 0], [0.08, 0], [-0.08, 0], [0, 0.08], [0, -0.08], [0, 0]])
    kinds = rng.integers(6, size=count)
    waypoints = 0.003 * rng.normal(size=(count, 3, 4))
    waypoints[:, 0, :2] -= travels[kinds] / 2
    waypoints[:, 2, :2] += travels[kinds] / 2
    waypoints[:, :, 3] += 0.9
    waypoints[kinds == 0, 2, 3] -= 0.8
    actions = waypoints.reshape(count, 12)
    outcomes = [world.interact(world.sample_scene(rng, 1), action, 0) for action in actions]
    return Interactions.from_outcomes(outcomes, actions, {"gripper_columns": [3, 7, 11]}), kinds


def test_the_default_recipe_gives_each_planted_kind_of_action_its_own_symbol():
    data, kinds = planted_kinds(1500)
    config = replace(TrainingConfig(), restarts=1, epochs=60, batch=128, encoder_epochs=20, teacher_actions=0)
    model, report = train(data, config=config, model_config=ModelConfig(hidden=64, dropout=0.0), seed=0)
    assert report["r2_through_codes"] > 0.7  # lifts of objects at the limit of the grasp cost the rest
    symbols = np.array(model.action_symbols(data.actions))
    named = [np.unique(symbols[kinds == kind], return_counts=True) for kind in range(6)]
    favourites = [names[counts.argmax()] for names, counts in named]
    assert len(set(favourites)) == 6
    assert all(counts.max() > 0.9 * counts.sum() for _, counts in named)
    assert np.all(np.array(report["mae"]["model"]) < np.array(report["mae"]["always zero"]))


def test_the_best_restart_is_kept():
    config = TrainingConfig(recipe="refit", epochs=2, refit_epochs=2, restarts=3)
    _, report = train(toy_data(300), config=config, model_config=SMALL, seed=0)
    assert report["r2_through_codes"] == max(report["restarts"])
    assert len(set(report["restarts"])) == 3


def test_held_out_interactions_are_not_trained_on():
    data = toy_data(300)
    kept, held_out = split(data, 0.2, seed=1)
    rows = {tuple(row) for row in kept.actions.tolist()}
    assert not rows & {tuple(row) for row in held_out.actions.tolist()}
    assert (len(kept), len(held_out)) == (240, 60)


def test_trivial_predictors_stand_beside_the_model():
    data = toy_data(300)
    kept, held_out = split(data, 0.2, seed=1)
    report = assess(EffectModel(Dimensions(), SMALL).eval(), kept, held_out)
    np.testing.assert_allclose(report["mae"]["always zero"], np.abs(held_out.effects).mean(0), rtol=1e-5)
    assert set(report["mae"]) == {"model", "always zero", "always mean", "per-axis median"}


def test_r_squared_is_one_for_the_truth_and_zero_for_the_mean():
    truth = np.random.default_rng(0).normal(size=(50, 2))
    np.testing.assert_allclose(r_squared(truth, truth), 1)
    np.testing.assert_allclose(r_squared(np.tile(truth.mean(0), (50, 1)), truth), 0, atol=1e-12)
    assert r_squared(truth, np.zeros((50, 2))).tolist() == [0, 0]


def test_data_of_other_dimensions_can_be_learned():
    rng = np.random.default_rng(0)
    features, actions = rng.uniform(size=(200, 2)), rng.uniform(size=(200, 5))
    flags = np.zeros(200, dtype=bool)
    effects = actions[:, :1].copy()
    data = Interactions(features, actions, effects, effects, flags, flags, flags, np.zeros(200))
    model, report = train(data, config=BRIEF, model_config=ModelConfig(1, 2, hidden=8), seed=0)
    assert model.dimensions == Dimensions(2, 5, 1, ())
    assert len(report["r2_through_codes_by_axis"]) == 1


def test_too_few_interactions_are_refused():
    with pytest.raises(InvalidValue, match="too few"):
        train(toy_data(300)[:10], seed=0)


def test_a_model_says_what_trained_it(tmp_path):
    model, _ = train(toy_data(300), config=BRIEF, model_config=SMALL, seed=9)
    model.save(tmp_path / "m")
    trained_by = EffectModel.load(tmp_path / "m").trained_by
    assert trained_by["seed"] == 9
    assert trained_by["training"]["recipe"] == "teacher"
    assert trained_by["origin"]["strategy"] == "random"


def test_the_papers_regime_has_the_papers_numbers():
    paper = REGIMES["paper"]
    assert (paper.training.learning_rate, paper.training.loss_coefficient) == (1e-5, 0.01)
    assert paper.model.gripper_sharpness is None
    assert paper.training.recipe == "joint"


@pytest.mark.parametrize("option", [{"epochs": 0}, {"validation_share": 1.0}, {"learning_rate": 0.0}])
def test_impossible_options_are_refused(option):
    with pytest.raises(InvalidValue, match=next(iter(option))):
        TrainingConfig(**option)
