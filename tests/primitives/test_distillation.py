"""Distilled parameters encode to their symbols and stay inside the action box."""

import numpy as np
import pytest
import torch
from toy_learning import toy_data

from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.learning.losses import reproducible
from neurosym.learning.network import EffectModel
from neurosym.learning.training_config import ModelConfig
from neurosym.operators import CONVERGED, OperatorTable, all_symbols
from neurosym.primitives.distillation import code_errors, distill, draw_of_every_kind
from neurosym.worlds.toy import make_world

FEW = {"candidates": 4, "steps": 40}
BOX = make_world().action_box
DATA = toy_data(500)


def a_model(bits=3):
    with reproducible(0):
        model = EffectModel(Dimensions(), ModelConfig(action_bits=bits)).train()
        with torch.no_grad():
            for _ in range(50):
                model.embed_actions(torch.from_numpy(DATA.actions))  # lets batch statistics settle
            codes = model.eval().embed_actions(torch.from_numpy(DATA.actions))
            last = model.action_encoder[-2]
            last.bias -= codes.atanh().median(0).values  # so that every bit is used
            last.weight *= 100
            last.bias *= 100
    return model


def by_symbol(candidates):
    symbols = sorted({candidate.symbol for candidate in candidates})
    return {symbol: [c for c in candidates if c.symbol == symbol] for symbol in symbols}


def test_starts_are_of_every_kind_of_outcome_however_rare():
    rng = np.random.default_rng(0)
    outcomes = rng.normal(size=(2000, 4)) * 0.05
    rare = rng.permutation(2000)[:20]
    outcomes[rare, 2] += 3
    rows = np.setdiff1d(np.arange(2000), rare[:10])  # half of the rare ones have another symbol
    drawn = draw_of_every_kind(rows, outcomes, 120, rng)
    assert len(set(drawn.tolist())) == 120
    assert set(drawn) <= set(rows)
    assert set(rare[10:]) <= set(drawn)
    few = draw_of_every_kind(rows[:50], outcomes, 120, rng)
    assert sorted(few) == rows[:50].tolist()


def test_every_candidate_encodes_to_its_symbol_and_lies_in_the_box():
    model = a_model()
    candidates = distill(model, DATA, BOX, seed=0, **FEW)
    assert len(by_symbol(candidates)) >= 4
    for candidate in candidates:
        action = np.array(candidate.action)
        assert BOX.contains(action)
        assert model.action_symbols(action[None]) == (candidate.symbol,)
        (error,) = code_errors(model, action[None], np.array([candidate.symbol]))
        assert candidate.code_error == pytest.approx(error, rel=1e-4)


def test_all_candidates_have_converged_or_there_is_only_the_best_one():
    model = a_model()
    counts = []
    for steps in (0, 5, 40):
        found = by_symbol(distill(model, DATA, BOX, seed=0, candidates=12, steps=steps))
        for candidates in found.values():
            errors = [candidate.code_error for candidate in candidates]
            assert errors == sorted(errors)
            assert len(errors) == 1 or max(errors) < CONVERGED
            assert len(errors) <= 2 * 12
        counts.append(sum(map(len, found.values())))
    assert counts[0] < counts[-1]  # the longer the descent, the more arrive


def test_the_same_seed_gives_the_same_primitives_the_model_is_untouched_and_what_it_lacks_is_told():
    model = a_model()
    before = {name: weights.clone() for name, weights in model.state_dict().items()}
    assert distill(model, DATA, BOX, seed=1, **FEW) == distill(model, DATA, BOX, seed=1, **FEW)
    assert all(torch.equal(before[name], weights) for name, weights in model.state_dict().items())
    assert all(parameter.grad is None for parameter in model.parameters())
    used = min(model.action_symbols(DATA.actions))
    rows = np.array([symbol == used for symbol in model.action_symbols(DATA.actions)])
    found = distill(model, DATA[rows], BOX, seed=0, **FEW)
    assert {primitive.symbol for primitive in found} == {used}, "symbols of no action are left out"
    assert OperatorTable((), found[:1], ()).unreached == tuple(s for s in all_symbols(3) if s != used)
    with torch.no_grad():
        model.action_encoder[-2].weight *= 1e-4
        model.action_encoder[-2].bias *= 1e-4
    assert all(primitive.code_error > 0.5 for primitive in distill(model, DATA, BOX, seed=0, **FEW))
    for option in ({"candidates": 0}, {"steps": -1}):
        with pytest.raises(InvalidValue, match=next(iter(option))):
            distill(model, DATA, BOX, seed=0, **option)
