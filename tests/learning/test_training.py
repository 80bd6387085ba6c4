"""Training makes bits that hold what the effect needs, and always the same ones."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest
import torch
from places import SHIPPED
from toy_learning import BRIEF, SMALL, toy_data

from neurosym.data.origin import Dimensions, has_high_effect, mirrors_of
from neurosym.errors import InvalidValue
from neurosym.exploration.curiosity import LearningConfig
from neurosym.exploration.loop import ExplorationConfig
from neurosym.learning import losses, training
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.recipes import RECIPES
from neurosym.learning.training_config import (
    REGIMES,
    CodingConfig,
    DecoderConfig,
    ModelConfig,
    NamingConfig,
    TeacherConfig,
    TrainingConfig,
)
from neurosym.learning.training_report import empty_codes


def test_nll_is_that_of_the_normal_distribution():
    generator = torch.Generator().manual_seed(0)
    mean, log_variance, effects = torch.randn(3, 20, 3, generator=generator)
    normal = torch.distributions.Normal(mean, (log_variance / 2).exp())
    torch.testing.assert_close(
        losses.negative_log_likelihood(mean, log_variance, effects), -normal.log_prob(effects).mean()
    )


def test_nt_xent_agrees_with_eq_8_read_naively():
    z = torch.randn(12, 5, generator=torch.Generator().manual_seed(0))
    unit = z / z.norm(dim=1, keepdim=True)
    total = 0.0
    for i in range(12):
        s = [float(unit[i] @ unit[j]) for j in range(12)]
        total -= np.log(np.exp(s[i] / 0.5) / sum(np.exp(value / 0.5) for value in s)) / 12
    assert float(losses.nt_xent(z, 0.5)) == pytest.approx(total, rel=1e-5)


def test_a_prediction_that_is_right_in_metres_costs_nothing():
    model = EffectModel(Dimensions(), replace(SMALL, head="mean")).eval()
    model.effect_mean.fill_(0.5)
    model.effect_std.fill_(2.0)
    objects, chosen = torch.ones(4, SMALL.object_bits), torch.ones(4, SMALL.action_bits)
    effects = model.decode(objects, chosen)[0].detach() * 2.0 + 0.5
    assert losses.prediction_loss(model, objects, chosen, effects).item() == pytest.approx(0.0, abs=1e-9)


def test_the_coefficient_multiplies_both_terms():
    data, model = toy_data(300), EffectModel(Dimensions(), SMALL).eval()
    batch = [torch.from_numpy(column) for column in (data.features, data.actions, data.effects)]
    with losses.reproducible(0):
        one, half = (
            losses.total_loss(model, *batch, coefficient=c, temperature=0.1).item() for c in (1.0, 0.5)
        )
        without = losses.total_loss(model, *batch, coefficient=1.0, temperature=None).item()
    assert half == pytest.approx(one / 2)
    assert one != without


def test_every_sample_is_seen_once_in_an_epoch_and_none_that_is_held_out():
    weight = torch.nn.Parameter(torch.zeros(1))
    seen = []

    def loss_of(rows):
        seen.extend(rows.tolist())
        return weight.sum()

    optimiser = torch.optim.SGD([weight], lr=0.1)
    losses.run_epochs(loss_of, 23, optimiser, torch.Generator(), epochs=3, batch=5, clip_norm=1.0, decay=True)
    assert sorted(seen) == sorted([*range(23)] * 3)
    assert optimiser.param_groups[0]["lr"] == 0.1
    data = toy_data(300)
    kept, held_out = training.split(data, 0.2, seed=1)
    rows = {tuple(row) for row in kept.actions.tolist()}
    assert not rows & {tuple(row) for row in held_out.actions.tolist()}
    assert (len(kept), len(held_out)) == (240, 60)


@pytest.mark.parametrize("recipe", RECIPES)
def test_the_same_seed_gives_the_same_bytes(recipe, tmp_path):
    config = replace(BRIEF, recipe=recipe)
    for name, seed in (("a", 5), ("b", 5), ("c", 6)):
        before = torch.random.get_rng_state()
        trained = training.train(toy_data(300), config=config, model_config=SMALL, seed=seed)
        trained.model.save(tmp_path / name)
        trained.direct.save(tmp_path / f"{name}-direct")
        assert torch.equal(before, torch.random.get_rng_state())
        torch.rand(3)  # what happens outside changes nothing
    for kind in ("", "-direct"):
        a, b, c = ((tmp_path / f"{name}{kind}").read_bytes() for name in "abc")
        assert a == b != c


@pytest.mark.parametrize("strategy", ["active", "random", "disagreement"])
def test_data_of_a_baseline_are_learned_as_that_baseline_learns(strategy):
    data = replace(toy_data(400), origin={**toy_data(400).origin, "strategy": strategy})
    used = data[has_high_effect(data.effects)] if strategy == "active" else data
    model = training.train(data, config=BRIEF, model_config=SMALL, seed=0).model
    assert model.config.head == ("gaussian" if strategy == "disagreement" else "mean")
    assert model.trained_by["interactions"] == len(used)
    kept, _ = training.split(used, BRIEF.validation_share, 0)
    squares = (kept.effects - model.effect_mean.numpy()) ** 2
    np.testing.assert_allclose(model.effect_std, np.sqrt(squares.mean(0)), rtol=1e-4)


def test_mirrors_are_made_use_of_only_if_the_origin_names_them_and_the_config_allows():
    data = toy_data(300)
    unknown = replace(data, origin={k: v for k, v in data.origin.items() if k != "mirrors"})
    assert len(mirrors_of(data.origin)) == 2
    assert losses.samples_of(data).mirrors == mirrors_of(data.origin)
    assert losses.samples_of(data, mirrors=False).mirrors == losses.samples_of(unknown).mirrors == ()
    means = [
        training.train(
            rows, config=replace(BRIEF, mirrors=mirrors), model_config=SMALL, seed=0
        ).model.effect_mean
        for rows, mirrors in ((data, True), (data, False), (unknown, True))
    ]
    assert means[0][:2].tolist() == [0, 0]  # left as often as right, in the mirror
    assert all(means[1][:2] != 0)
    assert torch.equal(means[1], means[2])


def test_batches_are_seen_through_each_mirror_half_of_the_time():
    samples = losses.samples_of(toy_data(300))
    for axis in (0, 1):
        row = int(samples.effects[:, axis].abs().argmax())
        _, actions, effects = samples.batch(torch.full((2000,), row), torch.Generator())
        flipped = actions[:, axis] == -samples.actions[row, axis]
        assert 0.45 < flipped.float().mean() < 0.55
        signs = torch.where(flipped, -1.0, 1.0)
        torch.testing.assert_close(actions[:, axis + 8], signs * samples.actions[row, axis + 8])
        torch.testing.assert_close(effects[:, axis], signs * samples.effects[row, axis])
        assert torch.all(effects[:, 2] == samples.effects[row, 2])


def assessed(data):
    """Assess networks that learned nothing; also returns the direct one, and the held out interactions."""
    kept, held_out = training.split(data, 0.2, seed=1)
    model = EffectModel(Dimensions(), SMALL).eval()
    direct = DirectModel(Dimensions(), BRIEF.teacher.network).eval()
    return training.assess(model, direct, kept, held_out), direct, held_out


def test_trivial_predictors_stand_beside_the_model():
    report, direct, held_out = assessed(toy_data(300))
    np.testing.assert_allclose(report.mae["always zero"], np.abs(held_out.effects).mean(0), rtol=1e-5)
    assert set(report.mae) == {"model", "always zero", "always mean", "per-axis median"}
    direct_r2 = training.r_squared(direct.predict(held_out.features, held_out.actions), held_out.effects)
    assert report.r2_direct_by_axis == pytest.approx(direct_r2.tolist(), rel=1e-4, abs=1e-5)
    seen = np.array([[0.0, 10.0], [1.0, 10.0], [8.0, 40.0]])
    found = training.trivial_predictions(seen, 2)
    assert found["always zero"].tolist() == [[0.0, 0.0]] * 2
    assert found["always mean"].tolist() == [pytest.approx([3.0, 20.0])] * 2
    assert found["per-axis median"].tolist() == [[1.0, 10.0]] * 2


def test_axes_that_never_change_are_left_out_of_the_mean_and_there_is_no_share_of_what_explains_nothing():
    data = toy_data(300)
    report, _, _ = assessed(replace(data, effects=data.effects * np.array([1, 1, 0], dtype=np.float32)))
    assert report.r2_direct == pytest.approx(np.mean(report.r2_direct_by_axis[:2]))
    hardly = data.effects * np.array([1, 1, 1e-4], dtype=np.float32)  # z varies by some micrometres
    for origin, axes in ((data.origin, 2), ({}, 3)):  # of a user's data nobody knows what is little
        report, _, _ = assessed(replace(data, effects=hardly, origin=origin))
        assert report.r2_direct == pytest.approx(np.mean(report.r2_direct_by_axis[:axes]))
    assert training.share_of(0.3, 0.6) == pytest.approx(0.5)
    assert training.share_of(-0.2, -0.3) is None
    assert training.share_of(0.1, 0.0) is None


def test_r_squared_is_one_for_the_truth_and_zero_for_the_mean():
    truth = np.random.default_rng(0).normal(size=(50, 2))
    np.testing.assert_allclose(training.r_squared(truth, truth), 1)
    np.testing.assert_allclose(training.r_squared(np.tile(truth.mean(0), (50, 1)), truth), 0, atol=1e-12)
    assert training.r_squared(truth, np.zeros((50, 2))).tolist() == [0, 0]


def test_networks_say_what_trained_them_and_effects_that_are_not_standardised_stay_in_metres():
    config = replace(BRIEF, standardise=False)
    trained = training.train(toy_data(300), config=config, model_config=SMALL, seed=9)
    assert trained.model.effect_std.tolist() == [1, 1, 1]
    assert trained.model.effect_mean.tolist() == [0, 0, 0]
    assert all(trained.direct.effect_std < 0.2)  # the yardstick is
    for network in (trained.model, trained.direct):
        assert network.trained_by["seed"] == 9
        assert network.trained_by["training"]["direct"]["hidden"] == 16
        assert network.trained_by["origin"]["strategy"] == "random"


def test_encoders_take_more_steps_and_the_table_has_more_rows_for_more_bits():
    config = TrainingConfig(naming=NamingConfig(steps=10), coding=CodingConfig(steps=20))
    assert config.for_bits(3) == config.for_bits(2) == config
    longer = config.for_bits(6)
    assert (longer.naming.steps, longer.coding.steps) == (40, 80)
    assert replace(longer, naming=config.naming, coding=config.coding) == config
    small = TrainingConfig(naming=NamingConfig(table_actions=60, table_objects=12))
    for config, bits, table in ((TrainingConfig(), (8, 6), (3000, 192)), (small, (5, 2), (96, 12))):
        naming = config.for_bits(*bits).naming
        assert (naming.table_actions, naming.table_objects) == table


@pytest.mark.parametrize("bits", [3, pytest.param(8, marks=pytest.mark.evaluation)])
def test_wide_symbols_can_be_trained_and_codes_without_rows_are_listed(bits):
    trained = training.train(toy_data(100), config=BRIEF, model_config=SMALL.with_bits(6, bits), seed=0)
    model, report, data = trained.model, trained.report, toy_data(100)
    used = set(model.object_symbols(data.features)), set(model.action_symbols(data.actions))
    assert used[0].isdisjoint(report.empty_object_codes)
    assert len(used[0]) + len(report.empty_object_codes) == 64
    assert len(used[1]) + len(report.empty_action_codes) == 2**bits
    assert f" and {len(report.empty_object_codes) - 16} more" in empty_codes(report)
    full = msgspec.structs.replace(report, empty_object_codes=(), empty_action_codes=())
    assert empty_codes(full) == ""


def test_the_papers_regime_has_the_papers_numbers():
    paper = REGIMES["paper"]
    assert (paper.training.learning_rate, paper.training.loss_coefficient) == (1e-5, 0.01)
    assert (paper.training.recipe, paper.model.gripper_sharpness) == ("joint", None)
    assert not paper.training.mirrors
    assert not paper.training.standardise


def test_options_are_stored_by_the_names_that_model_files_have_had_from_the_beginning():
    stored = EffectModel.load(SHIPPED / "effect_model.safetensors").trained_by["training"]
    assert stored == TrainingConfig().as_stored()


@pytest.mark.parametrize(
    ("kind", "option", "message"),
    [
        (TeacherConfig, {"epochs": 0}, "TeacherConfig.epochs = 0 must be at least 1"),
        (NamingConfig, {"table_restarts": 0}, "NamingConfig.table_restarts = 0 must be at least 1"),
        (CodingConfig, {"steps": 0}, "CodingConfig.steps = 0 must be at least 1"),
        (DecoderConfig, {"imagined": 0}, "DecoderConfig.imagined = 0 must be at least 1"),
        (TrainingConfig, {"learning_rate": 0.0}, "TrainingConfig.learning_rate = 0.0 must be positive"),
        (TrainingConfig, {"validation_share": 1.0}, "validation_share = 1.0"),
        *((ModelConfig, {name: 0}, name) for name in ("object_bits", "hidden")),
        *((ModelConfig, option, next(iter(option))) for option in ({"dropout": 1.0}, {"action_bits": 99})),
        *((LearningConfig, {name: least}, name) for name, least in (("epochs", 0), ("ensemble", 1))),
        *(
            (LearningConfig, {name: least}, name)
            for name, least in (("learning_rate", 0.0), ("clip_norm", -1.0))
        ),
        *((ExplorationConfig, {name: 0}, name) for name in ("candidates", "block")),
    ],
)
def test_impossible_options_are_refused(kind, option, message):
    with pytest.raises(InvalidValue, match=message):
        kind(**option)
