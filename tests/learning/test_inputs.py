"""Networks are shown grippers as open or closed, and each sample in the mirrors that a coin chooses."""

import numpy as np
import pytest
import torch

from neurosym.data.origin import Dimensions
from neurosym.learning.network import DirectModel, EffectModel, InputNorm, reflected, with_gripper_states
from neurosym.learning.training_config import DirectConfig, ModelConfig
from neurosym.world import Mirror

MIRRORS = (Mirror(actions=(0, 4), effects=(0,)), Mirror(actions=(1, 4), effects=(1, 2)))


def scale_of(effects, mirrored):
    network = DirectModel(Dimensions(), DirectConfig(peaks=False))
    network.set_scale(effects, mirrored)
    return network.effect_mean, network.effect_std


def samples(rows=200):
    generator = torch.Generator().manual_seed(0)
    return torch.rand(rows, 6, generator=generator), torch.randn(rows, 3, generator=generator)


def test_forwards_a_gripper_is_open_or_closed_and_all_else_as_it_is():
    actions, _ = samples()
    actions[0, 3] = 0.5
    seen = with_gripper_states(actions, (3, 5), 15.0)
    torch.testing.assert_close(seen[:, [3, 5]], (actions[:, [3, 5]] >= 0.5).float(), rtol=0, atol=1e-6)
    assert torch.equal(seen[:, [0, 1, 2, 4]], actions[:, [0, 1, 2, 4]])


def test_backwards_a_gripper_is_a_sigmoid():
    stepped, smooth = (samples()[0].requires_grad_() for _ in range(2))
    weights = torch.linspace(-1, 1, 6)
    (with_gripper_states(stepped, (3, 5), 15.0) * weights).sum().backward()
    columns = [torch.sigmoid(15.0 * (smooth[:, c] - 0.5)) if c in (3, 5) else smooth[:, c] for c in range(6)]
    (torch.stack(columns, dim=1) * weights).sum().backward()
    torch.testing.assert_close(stepped.grad, smooth.grad)
    assert stepped.grad[:, 3].abs().max() > 0


@pytest.mark.parametrize(("columns", "sharpness"), [((3, 5), None), ((), 15.0)])
def test_without_sharpness_or_grippers_actions_are_seen_as_they_are(columns, sharpness):
    actions, _ = samples()
    assert torch.equal(with_gripper_states(actions, columns, sharpness), actions)


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


def test_state_that_never_was_is_not_far_from_all_that_were():
    opened = torch.ones(200, 1)
    norm = InputNorm(1, (0,))
    for _ in range(100):
        norm(opened)
    assert norm.eval()(torch.zeros(1, 1)).item() == -1
    careless = torch.nn.BatchNorm1d(1)
    for _ in range(100):
        careless(opened)
    assert careless.eval()(torch.zeros(1, 1)).item() < -100


def test_which_inputs_are_states_is_not_among_the_weights():
    assert InputNorm(6, (3,)).state_dict().keys() == torch.nn.BatchNorm1d(6).state_dict().keys()


@pytest.mark.parametrize("sharpness", [15.0, None])
def test_networks_normalise_grippers_only_if_shown_their_values(sharpness):
    networks = (
        EffectModel(Dimensions(), ModelConfig(gripper_sharpness=sharpness)).action_encoder,
        DirectModel(Dimensions(), DirectConfig(gripper_sharpness=sharpness)).layers,
    )
    for network, before in zip(networks, (0, Dimensions().features), strict=True):
        states = [before + column for column in Dimensions().gripper_columns] if sharpness else []
        assert torch.nonzero(network[0].is_state)[:, 0].tolist() == states


def test_reflections_are_those_of_a_naive_loop_with_the_same_coins():
    actions, effects = samples()
    found = reflected(actions, effects, MIRRORS, torch.Generator().manual_seed(5))
    coins = torch.Generator().manual_seed(5)
    expected_actions, expected_effects = actions.clone(), effects.clone()
    for mirror in MIRRORS:
        heads = torch.randint(2, (len(actions), 1), generator=coins)
        for row in range(len(actions)):
            if not heads[row]:
                for column in mirror.actions:
                    expected_actions[row, column] = -expected_actions[row, column]
                for axis in mirror.effects:
                    expected_effects[row, axis] = -expected_effects[row, axis]
    assert torch.equal(found[0], expected_actions)
    assert torch.equal(found[1], expected_effects)


def test_every_combination_of_mirrors_is_looked_through_equally_often():
    ones = torch.ones(4000, 6), torch.ones(4000, 3)
    actions, effects = reflected(*ones, MIRRORS, torch.Generator().manual_seed(0))
    kinds, counts = np.unique(effects.numpy(), axis=0, return_counts=True)
    assert kinds.tolist() == [[-1, -1, -1], [-1, 1, 1], [1, -1, -1], [1, 1, 1]]
    assert counts.min() > 900
    assert torch.equal(actions[:, 4], effects[:, 0] * effects[:, 1])  # turned round twice is not at all


def test_without_mirrors_nothing_is_drawn():
    actions, effects = samples()
    generator = torch.Generator().manual_seed(0)
    before = generator.get_state()
    assert reflected(actions, effects, (), generator) == (actions, effects)
    assert torch.equal(generator.get_state(), before)


@pytest.mark.parametrize("mirrored", [(), (0,), (0, 2)])
def test_scale_is_that_of_the_effects_together_with_all_their_images(mirrored):
    effects = samples()[1] * torch.tensor([1.0, 2.0, 0.5]) + 0.3
    images = effects
    for axis in mirrored:
        signs = torch.ones(3)
        signs[axis] = -1
        images = torch.cat([images, images * signs])
    mean, std = scale_of(effects, mirrored)
    torch.testing.assert_close(mean, images.mean(0), atol=1e-5, rtol=1e-4)
    torch.testing.assert_close(std, images.std(0, correction=0), atol=1e-5, rtol=1e-4)


def test_an_axis_that_never_changes_has_a_scale_all_the_same():
    effects = torch.zeros(10, 3)
    assert scale_of(effects, ())[1].min() > 0
