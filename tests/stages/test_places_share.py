"""How many interactions `run` aims at places if nobody says."""

from pathlib import Path

import pytest
from command_line import neurosym
from conftest import RUN_TOY

from neurosym.stages import whole_way
from neurosym.stages.folder import DomainFolder


@pytest.mark.parametrize(("steps", "places"), [(1, 0), (1023, 0), (1024, 256), (10_000, 2500)])
def test_a_quarter_as_many_are_aimed_at_places(tmp_path: Path, steps, places):
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    assert whole_way._usual_places(DomainFolder(tmp_path / "new"), steps) == places


def test_no_fewer_than_there_are_so_that_nothing_is_done_again(folder: Path, capsys):
    assert whole_way._usual_places(DomainFolder(folder), 1024) == 512
    assert RUN_TOY[-2] == "--places"
    assert neurosym("run", folder, *RUN_TOY[:-2]) == 0
    assert ": done" not in capsys.readouterr().out


def test_worlds_that_take_no_places_get_none(tmp_path: Path, monkeypatch):
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    monkeypatch.setattr(whole_way, "references_of", lambda _: ())
    assert whole_way._usual_places(DomainFolder(tmp_path / "new"), 10_000) == 0
