"""The benchmark of bits learns symbols of every width from the same data, and goes on where it was."""

import json

import pytest

from tools.benchmarks.planning import bits


@pytest.mark.evaluation
def test_widths_are_learned_from_one_exploration_and_tried_on_the_same_tasks(
    toy_folder, tmp_path, monkeypatch
):
    monkeypatch.setattr(bits, "EVERY", (bits.Learned(2, 3), bits.Learned(1, 2, "lowest-error")))
    monkeypatch.setattr(bits, "REGIME", "quick")
    work, results = tmp_path / "work", tmp_path / "results"
    results.mkdir()
    bits.explored(work, 1).mkdir(parents=True)
    for name in ("world.toml", "interactions.npz"):
        (bits.explored(work, 1) / name).write_bytes((toy_folder / name).read_bytes())
    manifest = json.loads((toy_folder / "manifest.json").read_text())
    manifest["stages"] = {"explore": manifest["stages"]["explore"]}
    (bits.explored(work, 1) / "manifest.json").write_text(json.dumps(manifest))
    (work / "jobs").mkdir()
    (work / "jobs" / "explore-1.json").write_text("300")
    options = {"seeds": 1, "steps": 300, "tasks": 2, "work": work, "results": results, "workers": 1}
    bits.main(**options)
    told = json.loads((results / "bits.json").read_text())
    assert list(told["reached"]) == ["2+3", "1+2, the paper's choice"]
    assert all(0 <= share <= 1 for cells in told["reached"].values() for (share,) in cells.values())
    (wide,), (narrow,) = told["learned"].values()
    assert wide["operators"] > narrow["operators"] > 0
    page = (results / "bits.md").read_text()
    assert "| single, 50 mm, blind |" in page
    assert "## Promises" in page
    assert all(missed["50 mm"][0] >= 0 for missed in told["promise_rms_mm"].values())
    times = {path: path.stat().st_mtime_ns for path in (work / "jobs").glob("*.json")}
    bits.main(**options)
    assert times == {path: path.stat().st_mtime_ns for path in (work / "jobs").glob("*.json")}


def test_page_of_what_is_there_says_of_how_many_seeds_it_is(tmp_path, monkeypatch):
    monkeypatch.setattr(bits, "EVERY", (bits.Learned(2, 3), bits.Learned(2, 4), bits.Learned(2, 5)))
    learned = {"categories": 4, "primitives": 8, "spread_median_mm": 1.0, "spread_p90_mm": 2.0}
    (tmp_path / "jobs").mkdir()
    for name, operators in (("2+3-own-1", 20), ("2+3-own-2", 30), ("2+4-own-2", 50)):
        (tmp_path / "jobs" / f"learn-{name}.json").write_text(json.dumps({**learned, "operators": operators}))
    bits.main(seeds=2, work=tmp_path, results=tmp_path, only_report=True)
    page = (tmp_path / "bits.md").read_text()
    assert "| 2+3 | 4.0 ± 0.0 | 8.0 ± 0.0 | 25.0 ± 7.1 |" in page
    assert "| 2+4 (1 seed) | 4.0 | 8.0 | 50.0 |" in page
    assert "2+5" not in page
    assert "| single, 50 mm, blind | - | - |" in page
