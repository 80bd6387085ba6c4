"""The summary of budgets: the fewest interactions that are enough, in the mean of the seeds."""

import pytest

from neurosym.worlds.world_file import read_world
from tools.benchmarks.budget import codes, engines, evaluate, heights, ways
from tools.benchmarks.budget.summary import page, summarise

LEARNED = {"cpu": 60.0, "interactions": 1990, "moved": 0.3, "kinds": ["push"], "r2": 0.5}


def trial(reached: bool) -> dict:
    ended = {"reached": reached, "ended": "", "kind": "", "reason": "", "distances": [0.0], "steps": []}
    return {"task": "drawn-1", "status": "solved", "blind": ended, "replanned": ended}


def found(shares: dict[int, float], way: str = "one-budget", make=trial) -> dict:
    """Record two seeds, whose tasks are reached so often after so many interactions."""
    jobs = {}
    for seed in (1, 2):
        for total, share in shares.items():
            kinds = ["push"] * (6 if total >= 4000 else 4)
            jobs[f"learn-{way}-{seed}-{total}"] = {**LEARNED, "interactions": total - seed, "kinds": kinds}
            for cell in ways.WAYS[way].points[total]:
                trials = [make(number < 20 * share) for number in range(20)]
                jobs[f"try-{way}-{seed}-{total}-{cell.name}-0"] = trials
    return jobs


def test_the_fewest_interactions_are_told_that_are_enough():
    summary = summarise(found({2000: 0.9, 4000: 0.95, 8000: 1.0}) | found({2000: 0.5}, "random"))
    assert summary["interactions_for"] == {"drawn": 4000, "places": None, "relations": None}
    assert summary["blind_at_2000"]["one_budget"] == pytest.approx(0.9)
    assert summary["blind_at_2000"]["random"] == pytest.approx(0.5)
    assert summary["blind_at_2000"]["entropy"] is None
    assert summary["six_kinds"] == {"one-budget": [3998, 3999]}
    assert summary["seeds"] == 2
    written = page(summary)
    assert "| one-budget | 4,000 | single | 2 | 95 % (83 to 99) | 95 % (83 to 99) |" in written
    assert "| one-budget-1-2000 | 1,999 | 1.0 | 30 % | 4 | 0.50 |" in written


def test_tasks_of_one_kind_are_not_counted_with_those_of_another():
    jobs = found({2000: 1.0})
    for name in jobs:
        if "20mm" in name:
            jobs[name] = [trial(reached=False)] * 20
    told = summarise(jobs)["shares"]["one-budget"]["2000"]
    assert {name: (cell["blind"], cell["tasks"]) for name, cell in told.items()} == {
        "single": ([1.0, 1.0], 40),
        "double": ([1.0, 1.0], 40),
        "20mm-single": ([0.0, 0.0], 40),
        "20mm-double": ([0.0, 0.0], 40),
    }


def test_places_count_with_replanning_and_pairs_by_geometry_too():
    jobs = found({5000: 1.0, 10_000: 1.0}, "with-places")
    jobs |= found({8000: 1.0}, "with-relations", lambda reached: {"blind": False, "reached": reached})
    assert summarise(jobs)["interactions_for"] == {"drawn": None, "places": 5000, "relations": None}
    for seed in (1, 2):
        judged = {"operators": {"on": {"right": 0.9}, "in": {"right": 0.9}}}
        jobs[f"learn-with-relations-{seed}-8000"]["pairs"] = judged
    assert summarise(jobs)["interactions_for"]["relations"] == 8000
    judged["operators"]["in"] = None
    assert summarise(jobs)["interactions_for"]["relations"] is None


def test_groups_are_compared_whatever_they_are_called():
    assert codes.agreement("0 0 1 1", "7 7 3 3") == 1
    assert codes.agreement("0 0 1 1", "0 1 0 1") == pytest.approx(-0.5)
    jobs = {
        f"codes-{way}-{seed}-2000": {"r2": r2, "symbols": f"0 0 {last} 1 1"}
        for way, seed, r2, last in [("random", 1, 0.2, 0), ("random", 2, 0.4, 1), ("entropy", 1, 0.5, 0)]
    }
    told = codes.summarise(jobs)["2000"]
    assert told["r2"] == {"one-budget": [], "random": [0.2, 0.4], "entropy": [0.5], "stages": []}
    assert told["alike"] == {"random and entropy": [1.0], "random": [pytest.approx(1 / 6)]}
    assert "| groups of random and entropy | 1.00 |" in codes.tables({"2000": told})


def test_ways_to_explore_are_told_apart_whose_names_begin_alike():
    cell = {"moved": 0.2, "moved_last": 0.3}
    jobs = {"high-test-8": {"moved": 0.14, "of": 400}} | {
        f"high-8-{way}-{seed}": {**cell, "r2": r2 + seed / 10}
        for way, r2 in (("random", 0.1), ("long-random", 0.5))
        for seed in (1, 2)
    }
    told = heights.summarise(jobs)
    assert {way: told["8"][way]["r2"] for way in heights.STRATEGIES if way in told["8"]} == {
        "random": [pytest.approx(0.2), pytest.approx(0.3)],
        "long-random": [pytest.approx(0.6), pytest.approx(0.7)],
    }
    assert "| 8 | 14 % | 4,096 | random | 20 % | 30 % | 0.65 ± 0.07 |" in heights.tables(told)


def test_nothing_is_told_of_what_was_not_measured():
    empty = summarise({})
    assert set(empty["interactions_for"].values()) == {None}
    assert empty["cpu_ratio"] is None
    assert "not measured yet" in page(empty)


def test_run_goes_through_its_checkpoints_whether_they_are_asked_for_or_not(monkeypatch, tmp_path):
    asked = list[int]()

    def run(folder, *, interactions, **_):
        folder.mkdir(exist_ok=True)
        asked.append(interactions)
        if interactions == 8000:
            raise InterruptedError

    monkeypatch.setattr(evaluate, "run", run)
    for _ in range(2):  # without its folder, and with it
        with pytest.raises(InterruptedError):
            evaluate.learn(tmp_path, "random", 4, 8000)
    assert asked == 2 * [2000, 4000, 8000]


def test_a_run_that_has_grown_beyond_begins_anew(monkeypatch, tmp_path):
    folder, there = tmp_path / "random-4-run", list[bool]()

    def run(folder, **_):
        there.append(folder.exists())
        raise InterruptedError

    monkeypatch.setattr(evaluate, "run", run)
    monkeypatch.setattr(evaluate, "_performed", lambda _: 5000)
    for total in (8000, 4000):
        folder.mkdir(exist_ok=True)
        (folder / evaluate.layout.BUDGET).touch()
        with pytest.raises(InterruptedError):
            evaluate.learn(tmp_path, "random", 4, total)
    assert there == [True, False]


def test_what_one_engine_taught_is_told_of_in_both(tmp_path):
    domain = tmp_path / "mujoco-1-6000"
    domain.mkdir()
    (domain / "world.toml").write_text('world = "tabletop"\n[options]\nengine = "mujoco"\n')
    world = read_world(engines.moved_over(domain, "pybullet") / "world.toml")
    assert world().config.engine == "pybullet"
    assert read_world(domain / "world.toml")().config.engine == "mujoco"
    jobs = found({6000: 1.0}, "mujoco")
    for name in jobs:
        if "-pybullet-" in name:
            jobs[name] = [trial(number < 15) for number in range(20)]
    jobs[engines.JOB] = {"both": {"tasks": 500, "median": 6.3, "rms": 23.0, "r2": 0.66, "kind": 0.962}}
    written = page(summarise(jobs))
    assert "| mujoco | mujoco | single | 2 | 100 % (91 to 100) | 100 % (91 to 100) |" in written
    assert "| mujoco | pybullet | single | 2 | 75 % (60 to 86) | 75 % (60 to 86) |" in written
    assert "| both | 500 | 6.3 | 23 | 0.66 | 96 % |" in written


@pytest.mark.parametrize("part", ["", "teaching", "prior", "weighing", "stopping"])
def test_parts_of_the_loop_are_left_out_for_a_while(part):
    before = parts()
    with ways.left_out(part):
        during = parts()
        assert (ways.bandit.Contest(1.0, [], [], {}, len).counts < 1) == (part == "prior")
    assert sum(one != other for one, other in zip(before, during, strict=True)) == bool(part)
    assert parts() == before


def parts() -> tuple:
    return (
        ways.rounds.train_stage,
        ways.bandit._Arm.gain,
        ways.audition.LEAST_GAIN,
        ways.bandit.Contest.counts,
    )
