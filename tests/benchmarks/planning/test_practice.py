"""The benchmark of practice tries the same tasks in each copy of a domain, and goes on where it was."""

import json

import pytest

from tools.benchmarks.planning.practice import HOW, main


@pytest.mark.evaluation
def test_practice_and_even_rehearsal_are_compared_on_the_same_tasks(toy_folder, tmp_path):
    work, results = tmp_path / "work", tmp_path / "results"
    results.mkdir()
    options = {"interactions": 100, "seeds": 1, "tasks": 2, "work": work, "results": results, "workers": 1}
    main(toy_folder, **options)
    told = json.loads((results / "practice.json").read_text())
    assert set(told["reached"]) == set(HOW)
    for shares in told["reached"].values():
        assert len(shares) == 8
        assert all(0 <= share <= 1 for (share,) in shares.values())
    assert told["practice"]["practised 1"]["spent"] >= 100 <= told["practice"]["evenly 1"]["spent"]
    assert all(missed["50 mm"][0] >= 0 for missed in told["promise_rms_mm"].values())
    page = (results / "practice.md").read_text()
    assert "| single, 50 mm, blind |" in page
    assert "| promises of tasks within 20 mm miss by [mm] |" in page
    times = {path: path.stat().st_mtime_ns for path in (work / "jobs").glob("*.json")}
    assert len(times) == 3 + 3 * 4
    main(toy_folder, **options)
    assert times == {path: path.stat().st_mtime_ns for path in (work / "jobs").glob("*.json")}
