"""The effect model is built as the paper draws it, and its file gives it back."""

import json

import numpy as np
import pytest
import torch
from safetensors.numpy import save_file

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.learning.network import LOG_VARIANCE_FLOOR, EffectModel, as_signs
from neurosym.learning.training_config import ModelConfig
from neurosym.operators import all_symbols, signs


def a_model(seed=0, dimensions=None, **options):
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        model = EffectModel(dimensions or Dimensions(), ModelConfig(**options)).eval()
        model.set_scale(torch.randn(100, model.dimensions.effects) * 0.1 + 0.05)
    return model


def inputs(rows, seed=0, features=4, actions=12):
    rng = np.random.default_rng(seed)
    return rng.uniform(size=(rows, features)), rng.uniform(size=(rows, actions))


def test_layers_are_those_of_the_paper():
    model = a_model()
    kinds = [type(layer).__name__ for layer in model.action_encoder]
    assert kinds == ["InputNorm", *["Linear", "ReLU", "Dropout"] * 3, "Linear", "Tanh"]
    assert [type(layer).__name__ for layer in model.decoder] == [*["Linear", "ReLU", "Dropout"] * 3, "Linear"]
    assert model.decoder[-1].out_features == 6
    assert isinstance(a_model(layer_norm=True).norm, torch.nn.LayerNorm)


def test_embeddings_lie_within_tanhs_range_and_have_the_bits_asked_for():
    model = a_model(object_bits=1, action_bits=4)
    features, actions = inputs(20)
    assert model.object_codes(features).shape == (20, 1)
    assert np.all(np.abs(model.action_codes(actions * 100)) <= 1)
    assert len(model.action_symbols(actions)[0]) == 4


def test_any_dimensions_will_do():
    model = a_model(dimensions=Dimensions(features=2, actions=5, effects=1, gripper_columns=()))
    mean, variance = model.predict(*inputs(7, features=2, actions=5))
    assert mean.shape == variance.shape == (7, 1)


def test_predictions_are_in_metres():
    model, other = a_model(), a_model()
    other.effect_mean.copy_(model.effect_mean * 10)
    other.effect_std.copy_(model.effect_std * 10)
    mean, variance = model.predict(*inputs(5))
    scaled_mean, scaled_variance = other.predict(*inputs(5))
    np.testing.assert_allclose(scaled_mean, mean * 10, rtol=1e-4)
    np.testing.assert_allclose(scaled_variance, variance * 100, rtol=1e-4)


def test_variance_has_a_floor():
    model = a_model()
    with torch.no_grad():
        model.decoder[-1].bias.fill_(-1000.0)
    _, variance = model.predict(*inputs(5))
    floor = np.exp(LOG_VARIANCE_FLOOR) * model.effect_std.numpy() ** 2
    np.testing.assert_allclose(variance, np.tile(floor, (5, 1)), rtol=1e-4)


def test_gripper_values_on_one_side_of_the_threshold_look_alike():
    model, raw = a_model(), a_model(gripper_sharpness=None)
    _, actions = inputs(1)
    slightly, widely = actions.copy(), actions.copy()
    slightly[0, 3], widely[0, 3] = 0.9, 1.0
    spread = np.abs(model.action_codes(slightly) - model.action_codes(widely)).max()
    raw_spread = np.abs(raw.action_codes(slightly) - raw.action_codes(widely)).max()
    assert spread < 0.1 * raw_spread


def test_prediction_from_codes_sees_nothing_but_the_bits():
    model = a_model()
    features, actions = inputs(200)
    mean, _ = model.predict_from_codes(features, actions)
    pairs = list(zip(model.object_symbols(features), model.action_symbols(actions), strict=True))
    for pair in set(pairs):
        rows = [row for row, other in enumerate(pairs) if other == pair]
        np.testing.assert_allclose(mean[rows], np.tile(mean[rows[0]], (len(rows), 1)), atol=1e-6)


def test_branching_table_agrees_with_decoding_one_code_at_a_time():
    model = a_model()
    features, _ = inputs(4)
    symbols = all_symbols(3)
    table = model.branching_table(features, symbols)
    assert table.shape == (4, 8, 3)
    for i, object_symbol in enumerate(model.object_symbols(features)):
        for j, symbol in enumerate(symbols):
            codes = [torch.tensor(signs(s), dtype=torch.float32)[None] for s in (object_symbol, symbol)]
            with torch.inference_mode():
                mean = model.decode(*codes)[0] * model.effect_std + model.effect_mean
            np.testing.assert_allclose(table[i, j], mean[0].numpy(), atol=1e-6)


def test_entropies_agree_with_the_predicted_variances():
    model = a_model()
    features, actions = inputs(50)
    repeated = np.tile(features[0], (50, 1))
    _, variance = model.predict(repeated, actions)
    expected = (0.5 * np.log(2 * np.pi * np.e * variance)).mean(1)
    np.testing.assert_allclose(model.mean_entropies(features[0], actions), expected, rtol=1e-4, atol=1e-5)


def test_a_mean_head_has_no_variance():
    model = a_model(head="mean")
    mean, variance = model.predict(*inputs(5))
    assert np.all(np.isfinite(mean))
    assert np.all(variance == 0)


def test_signs_follow_the_step_function():
    values = torch.tensor([[0.5, 0.0, -0.5]])
    assert as_signs(values).tolist() == [[1.0, -1.0, -1.0]]


def test_asking_a_model_leaves_its_mode_as_it_was():
    model = a_model().train()
    model.predict(*inputs(5))
    assert model.training


def test_a_saved_model_comes_back_whole(tmp_path):
    model = a_model(object_bits=1, layer_norm=False)
    model.trained_by = {"seed": 3}
    model.save(tmp_path / "m.safetensors")
    again = EffectModel.load(tmp_path / "m.safetensors")
    assert (again.config, again.dimensions, again.trained_by) == (model.config, model.dimensions, {"seed": 3})
    np.testing.assert_array_equal(again.predict(*inputs(9))[0], model.predict(*inputs(9))[0])


def test_equal_models_are_equal_bytes(tmp_path):
    a_model().save(tmp_path / "a")
    a_model().save(tmp_path / "b")
    a_model(seed=1).save(tmp_path / "c")
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes() != (tmp_path / "c").read_bytes()


@pytest.mark.parametrize("content", [b"", b"hello", b"\x80\x04K\x01.", b"\xff" * 64])
def test_files_that_are_no_safetensors_are_refused(tmp_path, content):
    (tmp_path / "m").write_bytes(content)
    with pytest.raises(InvalidFile, match="safetensors"):
        EffectModel.load(tmp_path / "m")


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(InvalidFile):
        EffectModel.load(tmp_path / "m")


def test_a_truncated_model_is_refused(tmp_path):
    a_model().save(tmp_path / "m")
    content = (tmp_path / "m").read_bytes()
    (tmp_path / "m").write_bytes(content[: len(content) // 2])
    with pytest.raises(InvalidFile, match="damaged"):
        EffectModel.load(tmp_path / "m")


def test_a_foreign_safetensors_file_is_refused(tmp_path):
    save_file({"weight": np.zeros(3, np.float32)}, tmp_path / "m")
    with pytest.raises(InvalidFile, match="format"):
        EffectModel.load(tmp_path / "m")


def test_weights_of_another_shape_are_refused(tmp_path):
    model = a_model()
    path = tmp_path / "m"
    model.save(path)
    content = path.read_bytes()
    config = json.dumps('"hidden": 128')[1:-1].encode()
    assert config in content
    path.write_bytes(content.replace(config, config.replace(b"128", b"127")))
    with pytest.raises(InvalidFile, match="do not fit"):
        EffectModel.load(path)


def test_configuration_of_another_type_is_refused(tmp_path):
    a_model().save(tmp_path / "m")
    weights, description = read_tensors(tmp_path / "m", EffectModel.FORMAT)
    description["config"]["gripper_sharpness"] = "a"
    write_tensors(tmp_path / "m", EffectModel.FORMAT, weights, description)
    with pytest.raises(InvalidFile, match="do not fit"):
        EffectModel.load(tmp_path / "m")


def test_variance_below_zero_is_refused(tmp_path):
    model = a_model()
    model.action_encoder[0].running_var[2] = -1.0
    model.save(tmp_path / "m")
    with pytest.raises(InvalidFile, match="a variance below zero"):
        EffectModel.load(tmp_path / "m")


def test_weights_that_are_not_finite_are_refused(tmp_path):
    model = a_model()
    model.effect_mean.fill_(torch.nan)
    model.save(tmp_path / "m")
    with pytest.raises(InvalidFile, match="not finite"):
        EffectModel.load(tmp_path / "m")


@pytest.mark.parametrize("option", [{"object_bits": 0}, {"dropout": 1.0}, {"hidden": 0}, {"action_bits": 99}])
def test_impossible_options_are_refused(option):
    with pytest.raises(InvalidValue):
        ModelConfig(**option)
