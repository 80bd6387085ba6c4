"""How many interactions `run` aims at places if nobody says."""

from pathlib import Path

import pytest
from command_line import neurosym
from conftest import RUN_TOY

from neurosym.stages import pipeline
from neurosym.stages.folder import DomainFolder
from neurosym.worlds.world_file import make_world

TOY = make_world("toy", {})


@pytest.mark.parametrize(("steps", "places"), [(1, 0), (1023, 0), (1024, 256), (10_000, 2500)])
def test_a_quarter_as_many_are_aimed_at_places(tmp_path: Path, steps, places):
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    assert pipeline._usual_places(DomainFolder(tmp_path / "new"), TOY, steps) == places


def test_no_fewer_than_there_are_so_that_nothing_is_done_again(folder: Path, capsys):
    assert pipeline._usual_places(DomainFolder(folder), TOY, 1024) == 512
    assert RUN_TOY[-2] == "--places"
    assert neurosym("run", folder, *RUN_TOY[:-2]) == 0
    assert ": done" not in capsys.readouterr().out


def test_worlds_that_take_no_places_get_none(tmp_path: Path, monkeypatch):
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    monkeypatch.setattr(pipeline, "references_of", lambda _: ())
    assert pipeline._usual_places(DomainFolder(tmp_path / "new"), TOY, 10_000) == 0


def test_relations_without_places_are_refused_before_anything_is_done(tmp_path: Path, capsys):
    folder = tmp_path / "new"
    assert neurosym("run", folder, "--steps", "256", "--relations", "64") == 2
    assert "with what carries objects to places; give --places a number" in capsys.readouterr().err
    assert not (folder / "exploration.safetensors").exists()


def test_relations_in_a_world_without_them_are_refused_before_anything_is_done(tmp_path: Path, capsys):
    folder = tmp_path / "new"
    assert neurosym("run", folder, "--world", "toy", "--relations", "64") == 2
    assert "The world toy takes no object as a reference" in capsys.readouterr().err
    assert not (folder / "interactions.npz").exists()
    assert not (folder / "exploration.safetensors").exists()
