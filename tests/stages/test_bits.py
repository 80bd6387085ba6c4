"""The bits of symbols, as stages record them: old records mean the paper's, and stay up to date."""

import pytest

from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import explore_stage, train_stage

EXPLORING = {"steps": 8, "seed": 0, "regime": "default", "workers": 1}


@pytest.fixture
def folder(tmp_path):
    return DomainFolder(tmp_path)


def trained_with(folder, regime="default", **bits):
    return train_stage(folder, seed=0, regime=regime, **bits).options


def explored_with(folder, strategy, **bits):
    return explore_stage(folder, strategy=strategy, **EXPLORING, **bits).options


def test_bits_of_the_paper_are_not_recorded_and_others_are(folder):
    assert trained_with(folder, object_bits=2, action_bits=3) == {"seed": 0, "regime": "default"}
    assert trained_with(folder, "paper") == {"seed": 0, "regime": "paper"}
    wide = trained_with(folder, object_bits=2, action_bits=5)
    assert wide == {"seed": 0, "regime": "default", "action_bits": 5}
    assert trained_with(folder, "paper", object_bits=1)["object_bits"] == 1


def test_bits_change_what_is_explored_only_where_a_network_with_symbols_is_explored_by(folder):
    for strategy in ("disagreement", "random"):
        assert explored_with(folder, strategy, action_bits=5) == explored_with(folder, strategy)
    assert explored_with(folder, "entropy", action_bits=5)["action_bits"] == 5
    assert "action_bits" not in explored_with(folder, "entropy")
