"""The network without a bottleneck: its file gives it back, and no other file is taken for it."""

import numpy as np
import pytest
import torch
from safetensors.numpy import save_file

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidFile
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.training_config import DirectConfig, ModelConfig


def a_model(seed=0, dimensions=None, **options):
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        model = DirectModel(dimensions or Dimensions(), DirectConfig(**{"hidden": 16, **options})).eval()
        model.set_scale(torch.randn(100, len(model.effect_mean)) * 0.1 + 0.05)
    return model


def inputs(rows, features=4, actions=12):
    rng = np.random.default_rng(0)
    return rng.uniform(size=(rows, features)), rng.uniform(size=(rows, actions))


def sentence(path, network=DirectModel):
    with pytest.raises(InvalidFile) as refused:
        network.load(path)
    message = str(refused.value)
    assert message.startswith(str(path))
    assert len(message.splitlines()) == 1
    return message


@pytest.mark.parametrize("peaks", [True, False])
def test_predictions_are_in_metres(peaks):
    model = a_model(peaks=peaks)
    features, actions = (torch.from_numpy(column).float() for column in inputs(7))
    with torch.inference_mode():
        standardised = model(features, actions).numpy()
    expected = standardised * model.effect_std.numpy() + model.effect_mean.numpy()
    assert expected.shape == (7, 3 + peaks)
    np.testing.assert_allclose(model.predict_outcomes(*inputs(7)), expected, rtol=1e-5)
    np.testing.assert_allclose(model.predict(*inputs(7)), expected[:, :3], rtol=1e-5)


@pytest.mark.parametrize("peaks", [True, False])
def test_standard_effects_are_the_effects_before_they_are_scaled(peaks):
    model = a_model(peaks=peaks)
    with torch.inference_mode():
        standard = model.standard_effects(*(torch.from_numpy(column).float() for column in inputs(7)))
    scaled = standard.numpy() * model.effect_std.numpy()[:3] + model.effect_mean.numpy()[:3]
    np.testing.assert_allclose(model.predict(*inputs(7)), scaled, rtol=1e-5)


def test_only_open_or_closed_counts_of_a_gripper():
    model, (features, actions) = a_model(), inputs(5)
    ajar = actions.copy()
    for column in model.dimensions.gripper_columns:
        ajar[:, column] = np.where(actions[:, column] >= 0.5, 0.51, 0.49)
    np.testing.assert_allclose(model.predict(features, ajar), model.predict(features, actions), atol=1e-6)
    as_it_is = a_model(gripper_sharpness=None)
    assert np.any(as_it_is.predict(features, ajar) != as_it_is.predict(features, actions))


@pytest.mark.parametrize("peaks", [True, False])
def test_a_saved_model_comes_back_whole(peaks, tmp_path):
    options = {"dropout": 0.3, "gripper_sharpness": None, "peaks": peaks}
    model = a_model(dimensions=Dimensions(3, 5, 2, (4,)), **options)
    model.trained_by = {"seed": 3}
    model.save(tmp_path / "m")
    again = DirectModel.load(tmp_path / "m")
    assert (again.config, again.dimensions, again.trained_by) == (model.config, model.dimensions, {"seed": 3})
    assert not again.training
    for told, known in ((again.predict, model.predict), (again.predict_outcomes, model.predict_outcomes)):
        np.testing.assert_array_equal(told(*inputs(9, 3, 5)), known(*inputs(9, 3, 5)))


def test_equal_models_are_equal_bytes(tmp_path):
    for name, seed in (("a", 0), ("b", 0), ("c", 1)):
        a_model(seed).save(tmp_path / name)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes() != (tmp_path / "c").read_bytes()


@pytest.mark.parametrize("content", [b"", b"hello", b"\x80\x04K\x01.", b"\xff" * 64])
def test_files_that_are_no_safetensors_are_refused_in_a_sentence(tmp_path, content):
    (tmp_path / "m").write_bytes(content)
    assert "not a safetensors file, or it is damaged" in sentence(tmp_path / "m")


def test_missing_torn_and_foreign_files_are_refused_in_a_sentence(tmp_path):
    assert "there is no such file" in sentence(tmp_path / "nowhere")
    a_model().save(tmp_path / "m")
    (tmp_path / "m").write_bytes((tmp_path / "m").read_bytes()[:-100])
    assert "damaged" in sentence(tmp_path / "m")
    save_file({"weight": np.zeros(3, np.float32)}, tmp_path / "m")
    assert "not of the format" in sentence(tmp_path / "m")


def test_neither_network_is_taken_for_the_other(tmp_path):
    EffectModel(Dimensions(), ModelConfig(hidden=8)).save(tmp_path / "effect")
    a_model().save(tmp_path / "direct")
    assert "not of the format neurosym-direct-model" in sentence(tmp_path / "effect")
    assert "not of the format neurosym-effect-model" in sentence(tmp_path / "direct", EffectModel)


@pytest.mark.parametrize(
    "change",
    [
        {"config": {"hidden": 17}},
        {"config": {"hidden": "16"}},
        {"config": {"hidden": -1}},
        {"config": {"dropout": 2.0}},
        {"config": {"depth": 3}},
        {"config": {"hidden": 16, "peaks": False}},
        {"config": {"hidden": 16, "peaks": "yes"}},
        {"config": None},
        {"dimensions": {"features": 5, "actions": 12, "effects": 3, "gripper_columns": []}},
        {"dimensions": {"features": 4, "actions": 12, "effects": 3, "gripper_columns": [12]}},
        {"trained_by": 5},
    ],
)
def test_weights_that_do_not_fit_their_description_are_refused_in_a_sentence(change, tmp_path):
    a_model().save(tmp_path / "m")
    weights, description = read_tensors(tmp_path / "m", DirectModel.FORMAT)
    write_tensors(tmp_path / "m", DirectModel.FORMAT, weights, {**description, **change})
    assert "do not fit the configuration" in sentence(tmp_path / "m")


def test_weights_that_are_not_finite_are_refused(tmp_path):
    model = a_model()
    model.effect_std.fill_(torch.inf)
    model.save(tmp_path / "m")
    assert "not finite" in sentence(tmp_path / "m")


def test_weights_that_are_too_great_to_predict_with_are_refused(tmp_path):
    model = a_model()
    model.effect_std.fill_(-3e38)
    model.save(tmp_path / "m")
    assert "holds a number beyond 1e+18" in sentence(tmp_path / "m")
