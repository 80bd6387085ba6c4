"""The cluster on paper takes the times that can be reckoned by hand."""

from functools import partial

import pytest

from neurosym.exploration.choice import ExplorationConfig
from neurosym.worlds.toy import make_world
from tools.benchmarks.world import simulate_cluster as cluster


def costs(choose=0.0, hand_out=0.0, perform=(1.0,), train=0.0, train_row=0.0):
    return cluster.Costs(choose, hand_out, perform, train, train_row)


def seconds(forecast):
    return forecast.hours * 3600


@pytest.mark.parametrize("workers", [1, 4])
def test_interactions_alone_are_shared_out(workers):
    found = cluster.forecast(costs(), cluster.Design(block=100), workers, steps=200)
    assert seconds(found) == pytest.approx(200 / workers)
    assert found.efficiency == pytest.approx(1.0)
    assert found.dominant == "simulating"


def test_no_number_of_workers_outruns_a_driver_that_chooses():
    slow = costs(choose=0.5)
    as_it_is = cluster.forecast(slow, cluster.Design(block=100), 100, steps=100)
    shared = cluster.forecast(slow, cluster.Design(block=100, workers_choose=True), 100, steps=100)
    assert seconds(as_it_is) == pytest.approx(100 * 0.5 + 1.0)
    assert as_it_is.dominant == "choosing"
    assert seconds(shared) == pytest.approx(1.5)


def test_training_on_all_so_far_waits_for_the_block_or_hides_behind_the_next():
    trained = costs(train=1.0, train_row=0.1)  # 2 s after ten interactions, 3 s after twenty
    waiting = cluster.forecast(trained, cluster.Design(block=10), 1, steps=20)
    hidden = cluster.forecast(trained, cluster.Design(block=10, overlapped=True), 1, steps=20)
    assert seconds(waiting) == pytest.approx(10 + 2 + 10 + 3)
    assert seconds(hidden) == pytest.approx(10 + 10 + 3)


def test_a_slow_interaction_ends_its_block():
    times = [1.0, 1.0, 5.0, 1.0]
    assert cluster.block_time(costs(), cluster.Design(), 4, times) == pytest.approx(5.0)
    assert cluster.block_time(costs(), cluster.Design(), 1, times) == pytest.approx(8.0)


def test_what_a_choice_and_an_update_take_can_be_measured(monkeypatch):
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
