"""The paper cluster of `tools/simulate_cluster.py` takes the times that can be reckoned by hand."""

from functools import partial
from pathlib import Path

import pytest

from neurosym.exploration import ExplorationConfig
from neurosym.toy_world import make_world

TOOLS = Path(__file__).parent.parent / "tools"


@pytest.fixture
def cluster(monkeypatch):
    monkeypatch.syspath_prepend(TOOLS)
    import simulate_cluster

    return simulate_cluster


def costs(cluster, choose=0.0, hand_out=0.0, perform=(1.0,), train=0.0, train_row=0.0):
    return cluster.Costs(choose, hand_out, perform, train, train_row)


def seconds(forecast):
    return forecast.hours * 3600


@pytest.mark.parametrize("workers", [1, 4])
def test_interactions_alone_are_shared_out(cluster, workers):
    found = cluster.forecast(costs(cluster), cluster.Design(block=100), workers, steps=200)
    assert seconds(found) == pytest.approx(200 / workers)
    assert found.efficiency == pytest.approx(1.0)
    assert found.dominant == "simulating"


def test_no_number_of_workers_outruns_a_driver_that_chooses(cluster):
    slow = costs(cluster, choose=0.5)
    as_it_is = cluster.forecast(slow, cluster.Design(block=100), 100, steps=100)
    shared = cluster.forecast(slow, cluster.Design(block=100, workers_choose=True), 100, steps=100)
    assert seconds(as_it_is) == pytest.approx(100 * 0.5 + 1.0)
    assert as_it_is.dominant == "choosing"
    assert seconds(shared) == pytest.approx(1.5)


def test_training_on_all_so_far_waits_for_the_block_or_hides_behind_the_next(cluster):
    trained = costs(cluster, train=1.0, train_row=0.1)  # 2 s after ten interactions, 3 s after twenty
    waiting = cluster.forecast(trained, cluster.Design(block=10), 1, steps=20)
    hidden = cluster.forecast(trained, cluster.Design(block=10, overlapped=True), 1, steps=20)
    assert seconds(waiting) == pytest.approx(10 + 2 + 10 + 3)
    assert seconds(hidden) == pytest.approx(10 + 10 + 3)


def test_a_slow_interaction_ends_its_block(cluster):
    times = [1.0, 1.0, 5.0, 1.0]
    assert cluster.block_time(costs(cluster), cluster.Design(), 4, times) == pytest.approx(5.0)
    assert cluster.block_time(costs(cluster), cluster.Design(), 1, times) == pytest.approx(8.0)


def test_what_a_choice_and_an_update_take_can_be_measured(cluster, monkeypatch):
    monkeypatch.setattr(cluster, "BLOCK", 8)
    monkeypatch.setattr(cluster, "make_world", lambda *_: make_world())
    small = partial(ExplorationConfig, block=8)
    monkeypatch.setattr(cluster, "ExplorationConfig", small)
    choose, interactions = cluster.measure_interactions(3)
    train, train_row = cluster.measure_training(3)
    assert choose > 0
    assert len(interactions) == 3
    assert train >= 0
    assert isinstance(train_row, float)
