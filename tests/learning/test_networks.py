"""Both networks: what they are shown and say, in which units, and that their files give them back."""

import re

import numpy as np
import pytest
import torch
from safetensors.numpy import save_file

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidFile
from neurosym.learning.network import (
    LOG_VARIANCE_FLOOR,
    DirectModel,
    EffectModel,
    InputNorm,
    as_signs,
    with_gripper_states,
)
from neurosym.learning.training_config import DirectConfig, ModelConfig
from neurosym.operators import all_symbols


def made(kind, config, seed, dimensions):
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        model = kind(dimensions or Dimensions(), config).eval()
        model.set_scale(torch.randn(100, len(model.effect_mean)) * 0.1 + 0.05)
    return model


def a_direct_model(seed=0, dimensions=None, **options):
    return made(DirectModel, DirectConfig(**{"hidden": 16, **options}), seed, dimensions)


def an_effect_model(seed=0, dimensions=None, **options):
    return made(EffectModel, ModelConfig(**{"hidden": 16, **options}), seed, dimensions)


def inputs(rows, features=4, actions=12):
    rng = np.random.default_rng(0)
    return rng.uniform(size=(rows, features)), rng.uniform(size=(rows, actions))


def tensors(rows):
    return [torch.from_numpy(column).float() for column in inputs(rows)]


KINDS = pytest.mark.parametrize("make", [a_direct_model, an_effect_model])


# What they say


@pytest.mark.parametrize("peaks", [True, False])
def test_predictions_of_the_direct_model_are_in_metres(peaks):
    model = a_direct_model(peaks=peaks)
    with torch.inference_mode():
        standardised, standard = model(*tensors(7)).numpy(), model.standard_effects(*tensors(7)).numpy()
    expected = standardised * model.effect_std.numpy() + model.effect_mean.numpy()
    assert expected.shape == (7, 3 + peaks)
    np.testing.assert_allclose(model.predict_outcomes(*inputs(7)), expected, rtol=1e-5)
    np.testing.assert_allclose(model.predict(*inputs(7)), expected[:, :3], rtol=1e-5)
    np.testing.assert_allclose(standard, standardised[:, :3], rtol=1e-5)


def test_layers_are_those_of_the_paper_and_signs_follow_the_step_function():
    model = an_effect_model()
    kinds = [type(layer).__name__ for layer in model.action_encoder]
    assert kinds == ["InputNorm", *["Linear", "ReLU", "Dropout"] * 3, "Linear", "Tanh"]
    assert [type(layer).__name__ for layer in model.decoder] == [*["Linear", "ReLU", "Dropout"] * 3, "Linear"]
    assert model.decoder[-1].out_features == 6
    assert as_signs(torch.tensor([[0.5, 0.0, -0.5]])).tolist() == [[1.0, -1.0, -1.0]]
    model.train().predict(*inputs(5))
    assert model.training, "asking leaves the mode as it was"


def test_variance_has_a_floor_and_a_head_of_means_has_none():
    model = an_effect_model()
    with torch.no_grad():
        model.decoder[-1].bias.fill_(-1000.0)
    _, variance = model.predict(*inputs(5))
    floor = np.exp(LOG_VARIANCE_FLOOR) * model.effect_std.numpy() ** 2
    np.testing.assert_allclose(variance, np.tile(floor, (5, 1)), rtol=1e-4)
    assert np.all(an_effect_model(head="mean").predict(*inputs(5))[1] == 0)
    model.set_scale(torch.zeros(10, 3))
    assert model.effect_std.min() > 0, "also of an axis that never changes"


def test_prediction_from_codes_sees_nothing_but_the_bits_and_stands_in_the_table():
    model = an_effect_model()
    features, actions = inputs(200)
    mean, _ = model.predict_from_codes(features, actions)
    pairs = list(zip(model.object_symbols(features), model.action_symbols(actions), strict=True))
    for pair in set(pairs):
        rows = [row for row, other in enumerate(pairs) if other == pair]
        np.testing.assert_allclose(mean[rows], np.tile(mean[rows[0]], (len(rows), 1)), atol=1e-6)
    table = model.branching_table(features, all_symbols(3))
    chosen = [int(symbol, 2) for symbol in model.action_symbols(actions)]
    np.testing.assert_allclose(table[np.arange(200), chosen], mean, atol=1e-6)


# What they are shown: grippers open or closed, and each sample in the mirrors that a coin chooses


def samples(rows=200):
    generator = torch.Generator().manual_seed(0)
    return torch.rand(rows, 6, generator=generator), torch.randn(rows, 3, generator=generator)


def test_only_open_or_closed_counts_of_a_gripper():
    model, (features, actions) = a_direct_model(), inputs(5)
    ajar = actions.copy()
    for column in model.dimensions.gripper_columns:
        ajar[:, column] = np.where(actions[:, column] >= 0.5, 0.51, 0.49)
    np.testing.assert_allclose(model.predict(features, ajar), model.predict(features, actions), atol=1e-6)
    as_it_is = a_direct_model(gripper_sharpness=None)
    assert np.any(as_it_is.predict(features, ajar) != as_it_is.predict(features, actions))


def test_gripper_is_forwards_a_step_and_backwards_a_sigmoid_and_all_else_as_it_is():
    stepped, smooth = (samples()[0] for _ in range(2))
    stepped[0, 3] = smooth[0, 3] = 0.5
    stepped, smooth = stepped.requires_grad_(), smooth.requires_grad_()
    weights = torch.linspace(-1, 1, 6)
    seen = with_gripper_states(stepped, (3, 5), 15.0)
    torch.testing.assert_close(seen[:, [3, 5]], (stepped[:, [3, 5]] >= 0.5).float(), rtol=0, atol=1e-6)
    assert torch.equal(seen[:, [0, 1, 2, 4]], stepped[:, [0, 1, 2, 4]])
    (seen * weights).sum().backward()
    columns = [torch.sigmoid(15.0 * (smooth[:, c] - 0.5)) if c in (3, 5) else smooth[:, c] for c in range(6)]
    (torch.stack(columns, dim=1) * weights).sum().backward()
    torch.testing.assert_close(stepped.grad, smooth.grad)
    assert stepped.grad[:, 3].abs().max() > 0
    for grippers, sharpness in (((3, 5), None), ((), 15.0)):
        assert torch.equal(with_gripper_states(smooth, grippers, sharpness), smooth)


def test_inputs_are_normalised_and_states_become_minus_one_and_one():
    shown, _ = samples()
    shown = with_gripper_states(shown, (3, 5), 15.0)
    norm, plain = InputNorm(6, (3, 5)), torch.nn.BatchNorm1d(6)
    for layer in (norm, plain, norm.eval(), plain.eval()):  # in training, then with what was learned by it
        seen = layer(shown)
        if layer is norm:
            torch.testing.assert_close(seen[:, [3, 5]], torch.where(shown[:, [3, 5]] == 1, 1.0, -1.0))
            ours = seen
        else:
            torch.testing.assert_close(seen[:, [0, 1, 2, 4]], ours[:, [0, 1, 2, 4]])
    norm = InputNorm(1, (0,))
    for _ in range(100):
        norm(torch.ones(200, 1))
    assert norm.eval()(torch.zeros(1, 1)).item() == -1, "a state that never was is not far from the other"


@pytest.mark.parametrize("sharpness", [15.0, None])
def test_networks_normalise_grippers_only_if_shown_their_values(sharpness):
    effect, direct = (make(gripper_sharpness=sharpness) for make in (an_effect_model, a_direct_model))
    for layers, before in ((effect.action_encoder, 0), (direct.layers, Dimensions().features)):
        states = [before + column for column in Dimensions().gripper_columns] if sharpness else []
        assert torch.nonzero(layers[0].is_state)[:, 0].tolist() == states


# Their files


def refused(path, said, network=DirectModel):
    with pytest.raises(InvalidFile, match=f"^{re.escape(str(path))} .*{said}[^\n]*$"):
        network.load(path)


@pytest.mark.parametrize(
    ("make", "options"),
    [
        (a_direct_model, {"dropout": 0.3, "gripper_sharpness": None, "peaks": True}),
        (a_direct_model, {"peaks": False}),
        (an_effect_model, {"object_bits": 1, "layer_norm": False}),
    ],
)
def test_a_saved_model_comes_back_whole(make, options, tmp_path):
    model = make(dimensions=Dimensions(3, 5, 2, (4,)), **options)
    model.trained_by = {"seed": 3}
    model.save(tmp_path / "m")
    again = type(model).load(tmp_path / "m")
    assert (again.config, again.dimensions, again.trained_by) == (model.config, model.dimensions, {"seed": 3})
    assert not again.training
    np.testing.assert_array_equal(again.predict(*inputs(9, 3, 5)), model.predict(*inputs(9, 3, 5)))


@KINDS
def test_torn_and_foreign_files_are_refused_in_a_sentence(make, tmp_path):
    model, path = make(), tmp_path / "m"
    model.save(path)
    path.write_bytes(path.read_bytes()[:-100])
    refused(path, "not a safetensors file, or it is damaged", type(model))
    save_file({"weight": np.zeros(3, np.float32)}, path)
    refused(path, "not of the format", type(model))
    {a_direct_model: an_effect_model, an_effect_model: a_direct_model}[make]().save(path)
    refused(path, f"not of the format {model.FORMAT}", type(model))


@KINDS
@pytest.mark.parametrize(
    "change",
    [
        *({"config": change} for change in ({"hidden": 17}, {"hidden": "16"}, {"hidden": -1})),
        *({"config": change} for change in ({"dropout": 2.0}, {"depth": 3}, {"gripper_sharpness": "a"})),
        *({"config": change} for change in ({"hidden": 16, "peaks": False}, {"hidden": 16, "peaks": "yes"})),
        *({"config": None}, {"trained_by": 5}, {"dimensions": [7, 5, 2]}),
        *(
            {"dimensions": {"features": 4, "actions": 12, "effects": 3, "gripper_columns": []} | change}
            for change in ({"features": 5}, {"features": "4"}, {"gripper_columns": [12]})
        ),
    ],
)
def test_weights_that_do_not_fit_their_description_are_refused_in_a_sentence(make, change, tmp_path):
    model = make()
    model.save(tmp_path / "m")
    weights, description = read_tensors(tmp_path / "m", model.FORMAT)
    if isinstance(change.get("config"), dict):
        change = {"config": description["config"] | change["config"]}
    write_tensors(tmp_path / "m", model.FORMAT, weights, {**description, **change})
    refused(tmp_path / "m", "do not fit the configuration", type(model))


@KINDS
def test_weights_that_cannot_be_predicted_with_are_refused(make, tmp_path):
    model = make()
    for value, said in ((torch.inf, "not finite"), (torch.nan, "not finite"), (-3e38, "1e+18")):
        model.effect_std.fill_(value)
        model.save(tmp_path / "m")
        refused(tmp_path / "m", re.escape(said), type(model))
    model = an_effect_model()
    model.action_encoder[0].running_var[2] = -1.0
    model.save(tmp_path / "m")
    refused(tmp_path / "m", "a variance below zero", EffectModel)
