"""What the tests of the tabletop share: the engines that simulate it."""

import pytest

from neurosym.choices import ENGINES
from neurosym.sim.config import TabletopConfig


@pytest.fixture(params=ENGINES)
def engine(request, monkeypatch):
    """One engine after the other, as the one that simulates unless another is asked for."""
    *others, usual = TabletopConfig.__init__.__defaults__
    assert usual == ENGINES[0], "the engine is the last option"
    monkeypatch.setattr(TabletopConfig.__init__, "__defaults__", (*others, request.param))
    return request.param
