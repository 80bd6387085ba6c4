"""How many interactions `run` aims at places if nobody says."""

from pathlib import Path

import pytest
from command_line import neurosym
from conftest import RUN_TOY

from neurosym.commands import pipeline
from neurosym.stages.folder import DomainFolder
from neurosym.worlds.world_file import make_world

TOY = make_world("toy", {})


def test_a_quarter_as_many_are_aimed_at_places_if_there_are_any(tmp_path: Path, monkeypatch):
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    folder = DomainFolder(tmp_path / "new")
    for steps, places in ((1, 0), (1023, 0), (1024, 256), (10_000, 2500)):
        assert pipeline._counts(folder, TOY, steps, None, 0) == (steps, places, 0)
    monkeypatch.setattr(pipeline, "references_of", lambda _: ())
    assert pipeline._counts(folder, TOY, 10_000, None, 0) == (10_000, 0, 0)


def test_no_fewer_than_there_are_so_that_nothing_is_done_again(folder: Path, capsys):
    assert pipeline._counts(DomainFolder(folder), TOY, 1024, None, 0)[1] == 512
    assert RUN_TOY[-2] == "--places"
    assert neurosym("run", folder, *RUN_TOY[:-2]) == 0
    assert ": done" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--steps", "256"], "with what carries objects to places; give --places a number"),
        (["--world", "toy"], "The world toy takes no object as a reference"),
    ],
)
def test_relations_that_cannot_be_are_refused_before_anything_is_done(tmp_path: Path, capsys, options, said):
    folder = tmp_path / "new"
    assert neurosym("run", folder, *options, "--relations", "64") == 2
    assert said in capsys.readouterr().err
    assert not (folder / "exploration.safetensors").exists()
    assert not (folder / "interactions.npz").exists()
