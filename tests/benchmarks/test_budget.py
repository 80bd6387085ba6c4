"""The summary of budgets: the fewest interactions that are enough, in the mean of the seeds."""

import pytest

from tools.benchmarks.budget.summary import WAYS, page, summarise

LEARNED = {"cpu": 60.0, "interactions": 1990, "idle": False}


def trial(reached: bool) -> dict:
    ended = {"reached": reached, "ended": "", "kind": "", "reason": "", "distances": [0.0], "steps": []}
    return {"task": "drawn-1", "status": "solved", "blind": ended, "replanned": ended}


def found(shares: dict[int, float], way: str = "one-budget") -> dict:
    """Record two seeds, whose tasks are reached so often after so many interactions."""
    jobs = {}
    for seed in (1, 2):
        for total, share in shares.items():
            jobs[f"learn-{way}-{seed}-{total}"] = LEARNED
            for cell in WAYS[way][total]:
                trials = [trial(number < 20 * share) for number in range(20)]
                jobs[f"try-{way}-{seed}-{total}-{cell.name}-0"] = trials
    return jobs


def test_the_fewest_interactions_are_told_that_are_enough():
    summary = summarise(found({2000: 0.9, 4000: 0.95, 8000: 1.0}) | found({2000: 0.5}, "random"))
    assert summary["interactions_for"] == {"drawn": 4000, "places": None}
    assert summary["blind_at_2000"]["one-budget"] == pytest.approx(0.9)
    assert summary["blind_at_2000"]["random"] == pytest.approx(0.5)
    assert summary["blind_at_2000"]["entropy"] is None
    assert summary["seeds"] == 2
    written = page(summary)
    assert "| one-budget | 4,000 | single | 2 | 95 % (83 to 99) | 95 % (83 to 99) |" in written
    assert "| one-budget-1-2000 | 1,990 | 1.0 |" in written


def test_places_count_with_replanning_and_nothing_is_told_of_what_was_not_measured():
    assert summarise(found({5000: 1.0, 10_000: 1.0}, "with-places"))["interactions_for"]["places"] == 5000
    empty = summarise({})
    assert empty["interactions_for"] == {"drawn": None, "places": None}
    assert "not measured yet" in page(empty)
