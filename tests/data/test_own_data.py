"""Data of one's own go as far as they can: trained, distilled, and told what a domain would need besides."""

import json
import re
import shutil
from pathlib import Path

import pytest
from command_line import contents, neurosym, refusal
from documents import python_blocks
from own_data import own_columns, write_data
from places import DOCS

from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions, strategy_of
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.training_config import DirectConfig, ModelConfig
from neurosym.operators import OperatorTable

(EXAMPLE,) = python_blocks("data.md")
"""The script that the document shows."""
COMMANDS = re.findall(r"^\$ neurosym (.*)$", (DOCS / "data.md").read_text(), re.MULTILINE)
"""What the document types after `neurosym`."""
OTHER_GRIPPER = EffectModel(Dimensions(7, 5, 2, (1,)), ModelConfig(hidden=8))


@pytest.fixture(scope="module")
def learned(tmp_path_factory):
    """The folder of the document's example, where its commands have been typed; tests must not change it."""
    place = tmp_path_factory.mktemp("document")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(place)
        exec(EXAMPLE, {})
        for command, *rest in map(str.split, COMMANDS):
            quick = ["--regime", "quick"] if command == "train" else []
            assert neurosym(command, *rest, *quick) == 0
    return place / "discs"


@pytest.fixture
def discs(learned, tmp_path):
    """A copy that a test may change."""
    return Path(shutil.copytree(learned, tmp_path / "discs"))


def test_the_documents_example_is_learned_through_the_bits(learned):
    assert [typed.split()[0] for typed in COMMANDS] == ["check", "train", "distill"]
    assert len(EXAMPLE.splitlines()) <= 18
    report = json.loads((learned / "training.json").read_text())
    assert report["r2_through_codes"] > 0.8
    assert len(report["mae"]["model"]) == 2


def test_distill_says_what_it_did_and_what_a_domain_needs(discs, capsys):
    assert neurosym("distill", discs) == 0
    said = capsys.readouterr().out
    assert "averaged from the data" in said
    assert "no PDDL domain can be made of 2 axes" in said
    assert "effects of 2 axes; a PDDL domain needs 3" in refusal(capsys, "compile-domain", discs)
    assert not (discs / "domain.pddl").exists()


def test_own_data_along_three_axes_lack_nothing_but_a_world(folder, capsys):
    (folder / "world.toml").unlink()
    assert neurosym("distill", folder) == 0
    assert f"neurosym init {folder} --world module:factory" in capsys.readouterr().out
    table = OperatorTable.load(folder / "primitives.json")
    assert (table.measured, table.axes) == ("data", 3)
    said = refusal(capsys, "compile-domain", folder)
    assert "world.toml is missing: a domain also needs where objects may stand" in said
    assert neurosym("init", folder, "--world", "toy") == 0
    assert neurosym("compile-domain", folder) == 0
    for name in ("domain.pddl", "domain-numeric.pddl"):
        said = "; Pushes and lifts were not rehearsed: what they do are averages over rows"
        assert said in (folder / name).read_text()


@pytest.mark.parametrize("command", ["explore", "run"])
def test_exploration_does_not_replace_data_of_ones_own(command, discs, capsys):
    (discs / "world.toml").write_text('world = "toy"\n')
    before = contents(discs)
    said = refusal(capsys, command, discs, "--steps", 3000)
    assert "which `neurosym explore` did not make; move it away first, or learn from it" in said
    assert f"`neurosym train {discs}`" in said
    assert contents(discs) == before


def test_data_of_ones_own_are_ones_own_whatever_they_call_their_world(tmp_path, capsys):
    (tmp_path / "world.toml").write_text('world = "toy"\n')
    path = write_data(tmp_path, own_columns(), {"world": "lab table", "strategy": ["active"], "robot": "arm"})
    before = path.read_bytes()
    assert "did not make" in refusal(capsys, "explore", tmp_path, "--steps", 100)
    assert path.read_bytes() == before
    assert strategy_of(Interactions.load(path).origin) is None


def test_data_that_do_not_fit_the_world_are_refused(discs, capsys):
    (discs / "world.toml").write_text('world = "toy"\n')
    said = refusal(capsys, "distill", discs)
    assert "7 object features, 5 action parameters and 2 effect axes, and the toy world has 4" in said


@pytest.mark.parametrize(
    ("name", "network", "said"),
    [
        ("effect_model", EffectModel(Dimensions(), ModelConfig(hidden=8)), "it was trained on 4 object feat"),
        ("direct_model", DirectModel(Dimensions(), DirectConfig(hidden=8)), "and the data have 7 object"),
        ("effect_model", OTHER_GRIPPER, "its gripper columns are [1], and those of the data [4]; train"),
    ],
)
def test_network_of_other_dimensions_than_the_data_is_refused(name, network, said, discs, capsys):
    network.save(discs / f"{name}.safetensors")
    refused = refusal(capsys, "distill", discs)
    assert f"{name}.safetensors cannot be used: " in refused
    assert said in refused


def test_one_effect_axis_and_no_gripper_go_the_whole_way(tmp_path, capsys):
    columns = own_columns(200)
    write_data(tmp_path, {**columns, "effects": columns["effects"][:, :1]})
    assert neurosym("train", tmp_path, "--regime", "paper") == 0
    said = capsys.readouterr().out
    assert "e1" in said
    assert "\nverdict: " in said
    assert neurosym("distill", tmp_path) == 0
    assert "no PDDL domain can be made of 1 axis" in capsys.readouterr().out
