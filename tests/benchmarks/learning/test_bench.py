"""The bench of learning measures everything that has a limit; its figures mean nothing at this scale."""

import json


def test_glance_writes_every_figure_beside_its_limit(tmp_path, capsys):
    from tools.benchmarks.learning.bench import main

    main(scale=0.006, output=tmp_path / "learning.json")
    assert capsys.readouterr().out == ""
    found = json.loads((tmp_path / "learning.json").read_text())
    choosing = found["choosing_among_2000"]
    assert {name: part["limit_ms"] for name, part in choosing.items()} == {
        "entropy": 5.0,
        "ensemble member": 5.0,
        "ensemble": 25.0,
    }
    assert all(part["times"] >= 50 and part["cpu_ms"] > 0 for part in choosing.values())
    assert found["distillation"]["limit_seconds"] == 30
    assert found["distillation"]["symbols"] >= 1
    assert found["training"]["limit_share"] == 0.25
    parts = [*choosing.values(), found["distillation"], found["training"]]
    assert found["passed"] == all(part["passed"] for part in parts)


def test_all_updates_of_a_run_are_summed_up():
    from tools.benchmarks.learning.bench import training_share

    found = training_share({"cpu_seconds": 60.0}, fit=40.0, simulation=0.05)
    assert found["share"] == 0.2
    assert found["simulation_cpu_seconds"] == 500
    assert found["passed"]
    assert not training_share({"cpu_seconds": 60.0}, fit=70.0, simulation=0.05)["passed"]
