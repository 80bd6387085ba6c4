"""Commands answer programs in JSON, keep quiet if told so, and read and write plans through pipes."""

import io
import json
import sys
from pathlib import Path

import pytest
from command_line import neurosym, refusal

from neurosym.errors import version_of

PLAN = "plans/task-01.fast-downward.plan"


@pytest.fixture
def planned(folder):
    assert neurosym("plan", folder, "task-01") == 0
    return folder


def answered(capsys, *arguments: object) -> object:
    """What a command printed as JSON; it printed nothing else."""
    capsys.readouterr()
    neurosym(*arguments)
    return json.loads(capsys.readouterr().out)


def test_version_says_what_is_installed(capsys):
    assert neurosym("--version") == 0
    assert capsys.readouterr().out.startswith(f"neurosym-pddl {version_of('neurosym')} (Python 3.")


def test_plans_and_runs_are_told_as_they_are_recorded(planned, capsys):
    plan = answered(capsys, "plan", planned, "task-01", "--json")
    assert plan["status"] == "solved"
    assert plan["file"] == str(planned / PLAN)
    assert {**plan, "seconds": 0} == {"file": plan["file"], **recorded(planned / PLAN), "seconds": 0}
    run = answered(capsys, "execute", planned, "task-01", planned / PLAN, "--json")
    assert run["reached"] in (True, False)
    assert len(run["steps"]) >= 1


def recorded(plan):
    return json.loads(plan.with_suffix(".json").read_text())


def test_what_else_programs_ask_for(planned, capsys):
    held = answered(capsys, "check", planned, "--json")
    assert (held["interactions"], held["actions"], held["problems"]) == (1024, 12, [])
    assert answered(capsys, "explain", planned, "--json")["actions"]
    names = [one["name"] for one in answered(capsys, "planners", "--json")]
    assert {"bfs", "counting", "fast-downward"} <= {*names}


def test_problems_of_a_data_set_are_listed_for_programs_too(folder, tmp_path, capsys):
    (tmp_path / "broken.npz").write_bytes(b"nothing")
    assert neurosym("check", tmp_path / "broken.npz", "--json") == 2
    captured = capsys.readouterr()
    assert not captured.out or json.loads(captured.out)["problems"]
    assert captured.err


def test_quiet_commands_print_only_what_goes_wrong(planned, capsys):
    capsys.readouterr()
    assert neurosym("--quiet", "plan", planned, "task-01") == 0
    assert neurosym("execute", planned, "task-01", planned / PLAN, "--quiet") in (0, 3)
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "no problem 'task-99'" in refusal(capsys, "plan", planned, "task-99", "--quiet")
    assert neurosym("planners") == 0
    assert "Planners" in capsys.readouterr().out


def test_plans_go_through_pipes(planned, capsys, monkeypatch):
    capsys.readouterr()
    assert neurosym("plan", planned, "task-01", "--output", "-") == 0
    text = capsys.readouterr().out
    assert text.strip() == (planned / PLAN).read_text().strip()
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    assert neurosym("execute", planned, "task-01", "-") in (0, 3)
    assert (planned / "runs" / "task-01.stdin.run.json").is_file()
    assert (planned / "plans" / "task-01.stdin.plan").read_text().strip() == text.strip()


@pytest.mark.parametrize("data", [b"", b"rubbish\n", b"\xff\xfe", b"x" * 70_000_000])
def test_what_is_no_plan_is_refused_and_leaves_nothing(folder, capsys, monkeypatch, data):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
    if data:
        assert "standard input" in refusal(capsys, "execute", folder, "task-02", "-").lower()
        assert not (folder / "plans" / "task-02.stdin.plan").exists()
    else:
        assert neurosym("execute", folder, "task-02", "-") in (0, 3)


@pytest.mark.parametrize("device", ["/dev/full", "/dev/null"])
def test_devices_stay_what_they_are(planned, capsys, device):
    said = refusal(capsys, "plan", planned, "task-01", "--output", device)
    assert "should be a file" in said
    assert Path(device).is_char_device()


@pytest.mark.parametrize("output", ["", "missing/a.plan", "."])
def test_plan_is_written_where_it_can_be(planned, tmp_path, capsys, output):
    if not output:
        assert neurosym("plan", planned, "task-01", "--output", tmp_path / "a.plan") == 0
        assert (tmp_path / "a.plan").read_text() == (planned / PLAN).read_text()
    else:
        assert "No plan can be written to" in refusal(
            capsys, "plan", planned, "task-01", "--output", tmp_path / output
        )


def test_standard_output_cannot_hold_two_things(planned, capsys):
    said = refusal(capsys, "plan", planned, "task-01", "--output", "-", "--json")
    assert "leave one of them out" in said
