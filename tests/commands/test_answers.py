"""Commands answer programs in JSON, keep quiet if told so, and read and write plans through pipes."""

import io
import json
import sys
from pathlib import Path

import pytest
from command_line import neurosym, refusal

PLAN = "plans/task-01.fast-downward.plan"


def answered(capsys, *arguments: object) -> object:
    """What a command printed as JSON; it printed nothing else."""
    capsys.readouterr()
    neurosym(*arguments)
    return json.loads(capsys.readouterr().out)


def test_programs_are_told_in_json_what_is_recorded(folder, capsys):
    plan = answered(capsys, "plan", folder, "task-01", "--json")
    recorded = json.loads((folder / PLAN).with_suffix(".json").read_text())
    assert plan["status"] == "solved"
    assert {**plan, "seconds": 0} == {"file": str(folder / PLAN), **recorded, "seconds": 0}
    run = answered(capsys, "execute", folder, "task-01", folder / PLAN, "--json")
    assert run["reached"] in (True, False)
    assert len(run["steps"]) >= 1
    held = answered(capsys, "check", folder, "--json")
    assert (held["interactions"], held["actions"], held["problems"]) == (1024, 12, [])
    assert answered(capsys, "explain", folder, "--json")["actions"]
    names = [one["name"] for one in answered(capsys, "planners", "--json")]
    assert {"bfs", "counting", "fast-downward"} <= {*names}


def test_quiet_commands_print_only_what_goes_wrong(folder, capsys):
    assert neurosym("--quiet", "plan", folder, "task-01") == 0
    assert neurosym("execute", folder, "task-01", folder / PLAN, "--quiet") in (0, 3)
    assert capsys.readouterr().out == ""
    assert "no problem 'task-99'" in refusal(capsys, "plan", folder, "task-99", "--quiet")
    assert neurosym("planners") == 0
    assert "Planners" in capsys.readouterr().out


def test_plans_go_through_pipes(folder, capsys, monkeypatch):
    assert neurosym("plan", folder, "task-01", "--output", "-") == 0
    text = capsys.readouterr().out
    assert text.strip() == (folder / PLAN).read_text().strip()
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    assert neurosym("execute", folder, "task-01", "-") in (0, 3)
    assert (folder / "runs" / "task-01.stdin.run.json").is_file()
    assert (folder / "plans" / "task-01.stdin.plan").read_text().strip() == text.strip()


@pytest.mark.parametrize("data", [b"rubbish\n", b"\xff\xfe", b"x" * 70_000_000])
def test_what_is_no_plan_is_refused_and_leaves_nothing(kept, capsys, monkeypatch, data):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
    assert "standard input" in refusal(capsys, "execute", kept, "task-02", "-").lower()


def test_plan_is_written_where_it_can_be(folder, tmp_path, capsys):
    asked = ("plan", folder, "task-01", "--output")
    assert neurosym(*asked, tmp_path / "a.plan") == 0
    assert (tmp_path / "a.plan").read_text() == (folder / PLAN).read_text()
    for output, said in (
        (tmp_path / "missing/a.plan", "No plan can be written to"),
        (tmp_path, "No plan can be written to"),
        ("/dev/full", "should be a file"),
        ("/dev/null", "should be a file"),
    ):
        assert said in refusal(capsys, *asked, output)
    assert Path("/dev/null").is_char_device()
    assert "leave one of them out" in refusal(capsys, *asked, "-", "--json")
