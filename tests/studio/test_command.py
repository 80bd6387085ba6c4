"""The command opens a page, says what is missing, and ends cleanly."""

import http.client
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from command_line import neurosym, refusal
from places import ROOT, SHIPPED


def started(tmp_path: Path, *arguments: str) -> tuple[subprocess.Popen[str], str]:
    """The studio in a process of its own, and its address."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "TMPDIR": str(tmp_path)}
    command = [sys.executable, "-m", "neurosym", "studio", "--no-browser", *arguments]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment, cwd=tmp_path
    )
    said = process.stdout.readline()
    assert said.startswith("the studio is at http://"), said
    return process, said.split()[-1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_studio_ends_in_order_and_leaves_nothing_behind(tmp_path, number):
    process, address = started(tmp_path)
    way = http.client.HTTPConnection(urlsplit(address).netloc, timeout=30)
    way.request("GET", "/")
    place = way.getresponse()
    assert place.status == 303
    assert list(tmp_path.glob("neurosym-studio-*"))
    process.send_signal(number)
    said, _ = process.communicate(timeout=30)
    assert process.returncode == 0
    assert said.splitlines()[-1] == "the studio is closed"
    assert "viser" not in said
    assert list(tmp_path.iterdir()) == []


def test_other_machines_are_warned_of_and_a_token_is_asked_for(tmp_path):
    process, address = started(tmp_path, "--host", "0.0.0.0")
    try:
        assert "token=" in address
        assert process.stdout.readline().startswith("note: anybody who can reach this machine")
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)


def test_extra_that_is_missing_or_of_another_version_is_named(capsys, monkeypatch):
    for installed, said in (
        ({}, "viser is not installed; install it with: pip install 'neurosym-pddl[studio]'"),
        ({"viser": "1.0.30"}, "viser 1.0.30 will not do"),
        ({"viser": "2.0.0"}, "viser 2.0.0 will not do"),
    ):
        monkeypatch.setattr("neurosym.errors._recorded", lambda _, installed=installed: installed)
        assert said in refusal(capsys, "studio")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--port", "70000"], "port"),
        (["--problem", "no-such-problem"], "no-such-problem"),
        (
            ["--host", "no such host"],
            "; name another --port (0 takes a free one), or a --host of this machine",
        ),
        (["no-such-folder"], "no-such-folder"),
        ([tempfile.gettempdir()], "world.toml"),
    ],
)
def test_bad_input_is_one_sentence(capsys, arguments, said, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert said in refusal(capsys, "studio", *arguments)


def test_run_is_written_as_one_page(tmp_path, capsys):
    page = tmp_path / "run.html"
    assert neurosym("replay", SHIPPED, "task-03.fast-downward", "--page", page) == 0
    assert f"wrote {page}" in capsys.readouterr().out
    written = page.read_text()
    assert "<title>tabletop: a run</title>" in written
    assert written.rstrip().endswith("</html>")
