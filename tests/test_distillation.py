"""Distilled parameters encode to their symbols and stay inside the action box."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch

from neurosym.distillation import DistillationConfig, code_errors, distill, unreached
from neurosym.effect_model import EffectModel
from neurosym.errors import InvalidValue
from neurosym.exploration import ExplorationConfig, explore
from neurosym.fitting import reproducible
from neurosym.model_config import Dimensions, ModelConfig
from neurosym.symbols import all_symbols
from neurosym.toy_world import make_world

FEW = DistillationConfig(candidates=4, steps=40)
BOX = make_world().action_box


@cache
def toy_data():
    config = ExplorationConfig(candidates=1, block=1001)
    return explore(make_world, steps=500, strategy="random", seed=0, config=config)


def a_model(bits=3):
    with reproducible(0):
        model = EffectModel(Dimensions(), ModelConfig(action_bits=bits)).train()
        with torch.no_grad():
            for _ in range(50):
                model.embed_actions(torch.from_numpy(toy_data().actions))  # lets batch statistics settle
            codes = model.eval().embed_actions(torch.from_numpy(toy_data().actions))
            last = model.action_encoder[-2]
            last.bias -= codes.atanh().median(0).values  # so that every bit is used
            last.weight *= 20
            last.bias *= 20
    return model


def test_every_primitive_encodes_to_its_symbol_and_lies_in_the_box():
    model = a_model()
    primitives = distill(model, toy_data(), BOX, seed=0, config=FEW)
    assert len(primitives) >= 4
    for primitive in primitives:
        action = np.array(primitive.action)
        assert BOX.contains(action)
        assert model.action_symbols(action[None]) == (primitive.symbol,)
        (error,) = code_errors(model, action[None], np.array([primitive.symbol]))
        assert primitive.code_error == pytest.approx(error)


def test_descent_lowers_the_error_of_the_best_start():
    model = a_model()
    starts = distill(model, toy_data(), BOX, seed=0, config=replace(FEW, steps=0))
    ends = distill(model, toy_data(), BOX, seed=0, config=FEW)
    before, after = ({p.symbol: p.code_error for p in found} for found in (starts, ends))
    assert before.keys() == after.keys()
    assert all(after[symbol] <= before[symbol] for symbol in before)
    assert sum(after.values()) < 0.7 * sum(before.values())


def test_symbols_of_no_action_are_left_out_and_can_be_listed():
    model = a_model()
    used = set(model.action_symbols(toy_data().actions))
    rows = np.array([symbol == min(used) for symbol in model.action_symbols(toy_data().actions)])
    primitives = distill(model, toy_data()[rows], BOX, seed=0, config=FEW)
    assert [primitive.symbol for primitive in primitives] == [min(used)]
    assert unreached(model, primitives) == tuple(s for s in all_symbols(3) if s != min(used))


def test_the_same_seed_gives_the_same_primitives_and_the_model_is_untouched():
    model = a_model()
    before = model.weights()
    assert distill(model, toy_data(), BOX, seed=1, config=FEW) == distill(
        model, toy_data(), BOX, seed=1, config=FEW
    )
    assert all(np.array_equal(before[name], array) for name, array in model.weights().items())
    assert all(parameter.grad is None for parameter in model.parameters())


def test_codes_that_do_not_saturate_are_reported_honestly():
    model = a_model()
    with torch.no_grad():
        model.action_encoder[-2].weight *= 1e-3
        model.action_encoder[-2].bias *= 1e-3
    assert all(
        primitive.code_error > 0.5 for primitive in distill(model, toy_data(), BOX, seed=0, config=FEW)
    )


def test_impossible_options_are_refused():
    with pytest.raises(InvalidValue):
        DistillationConfig(candidates=0)
    with pytest.raises(InvalidValue):
        DistillationConfig(momentum=1.0)
