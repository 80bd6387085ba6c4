"""The bench of planning measures everything that has a limit."""

import json


def test_glance_writes_every_figure_beside_its_limit(tmp_path, capsys):
    from tools.benchmarks.planning.bench import main

    main(times=1, output=tmp_path / "planning.json")
    assert capsys.readouterr().out == ""
    found = json.loads((tmp_path / "planning.json").read_text())
    assert found["bfs_two_objects"]["limit_ms"] == 50.0
    assert found["counting_sixteen_objects"]["limit_seconds"] == 1.0
    assert found["counting_sixteen_objects"]["primitives"] == found["counting_sixteen_objects"]["fewest"]
    assert found["plan_process"]["limit_seconds"] == 1.0
    assert found["without_translation"]["ratio"] > 0
    names = ("bfs_two_objects", "counting_sixteen_objects", "without_translation", "plan_process")
    parts = [found[name] for name in names]
    assert found["passed"] == all(part["passed"] for part in parts)
