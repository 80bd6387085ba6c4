"""The benchmark of bits learns symbols of every width from the same data, and goes on where it was."""

import json

from tools.benchmarks.planning import bits


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
