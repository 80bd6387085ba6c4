"""Data of one's own go as far as they can: trained, distilled, and told what a domain would need besides."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
import torch
from command_line import neurosym, refusal
from own_data import own_columns, write_data
from places import DOCS
from safetensors.numpy import save_file

from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions, strategy_of
from neurosym.errors import InvalidFile
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.training_config import DirectConfig, ModelConfig
from neurosym.operators import OperatorTable
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import distill_stage

DOCUMENT = DOCS / "data.md"


def example() -> str:
    """The script that the document shows."""
    return re.search(r"```python\n(.*?)```", DOCUMENT.read_text(), re.DOTALL)[1]


def commands() -> list[list[str]]:
    """What the document types after `neurosym`."""
    return [line.split() for line in re.findall(r"^\$ neurosym (.*)$", DOCUMENT.read_text(), re.MULTILINE)]


@pytest.fixture(scope="module")
def learned(tmp_path_factory):
    """The folder of the document's example, where its commands have been typed; tests must not change it."""
    place = tmp_path_factory.mktemp("document")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(place)
        exec(example(), {})
        for command, *rest in commands():
            quick = ["--regime", "quick"] if command == "train" else []
            assert neurosym(command, *rest, *quick) == 0
    return place / "discs"


@pytest.fixture
def discs(learned, tmp_path):
    """A copy that a test may change."""
    return Path(shutil.copytree(learned, tmp_path / "discs"))


def test_the_documents_example_is_learned_through_the_bits(learned):
    assert [command for command, *_ in commands()] == ["check", "train", "distill"]
    assert len(example().splitlines()) <= 18
    report = json.loads((learned / "training.json").read_text())
    assert report["r2_through_codes"] > 0.8
    assert len(report["mae"]["model"]) == 2


def test_table_of_own_data_says_that_nothing_was_rehearsed(learned):
    table = OperatorTable.load(learned / "primitives.json")
    assert table.measured == "data"
    assert table.axes == 2
    low, high = [-1, -1, 0.1, 0, 0], [1, 1, 0.5, 1, 1]
    assert all(
        np.all(low <= np.array(p.action)) and np.all(np.array(p.action) <= high) for p in table.primitives
    )
    assert all(
        re.fullmatch("act-[01]{3}-(kind|unseen)-[01]{2}", operator.name) for operator in table.operators
    )
    assert sum(operator.trials for operator in table.operators) <= 2000


def test_distilling_again_without_a_world_is_up_to_date(discs):
    folder = DomainFolder(discs)
    stage = distill_stage(folder, objects=100, seed=0, workers=1)
    before = (discs / "primitives.json").read_bytes()
    folder.perform(stage, again=True)
    assert (discs / "primitives.json").read_bytes() == before
    assert not folder.perform(stage, again=False)
    inputs = {"effect_model.safetensors", "direct_model.safetensors", "interactions.npz"}
    assert set(folder.manifest().stages["distill"].inputs) == inputs


def test_distill_says_what_it_did_and_what_a_domain_needs(discs, capsys):
    assert neurosym("distill", discs) == 0
    said = capsys.readouterr().out
    assert "averaged from the data" in said
    assert "nothing was rehearsed" in said
    assert "no PDDL domain can be made of 2 axes" in said


def test_effects_along_other_axes_are_not_compiled(discs, capsys):
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
    shares = {f"{(one.successes + 1) / (one.trials + 2):.0%}" for one in table.operators}
    for name in ("domain.pddl", "domain-numeric.pddl"):
        domain = (folder / name).read_text()
        assert (
            "; Pushes and lifts were not rehearsed: what they do are averages over rows of the data.\n"
            in domain
        )
        assert "rehearsals" not in domain
        told = set(re.findall(r"(\d+%)(?:  |$)", pushed_and_lifted(domain), re.MULTILINE))
        assert told
        assert told <= shares


def pushed_and_lifted(domain: str) -> str:
    """The first table of symbols: what is carried was rehearsed in the toy world."""
    return re.search(r"^; Learned action symbols: .*\n((?:;   .*\n)+)", domain, re.MULTILINE)[1]


@pytest.mark.parametrize("command", ["explore", "run"])
def test_exploration_does_not_replace_data_of_ones_own(command, discs, capsys):
    (discs / "world.toml").write_text('world = "toy"\n')
    before = (discs / "interactions.npz").read_bytes()
    said = refusal(capsys, command, discs, "--steps", 3000)
    assert "which `neurosym explore` did not make; move it away first, or learn from it" in said
    assert f"`neurosym train {discs}`" in said
    assert (discs / "interactions.npz").read_bytes() == before


def test_data_of_ones_own_are_ones_own_whatever_they_call_their_world(tmp_path, capsys):
    (tmp_path / "world.toml").write_text('world = "toy"\n')
    path = write_data(tmp_path, own_columns(), {"world": "lab table", "strategy": ["active"], "robot": "arm"})
    before = path.read_bytes()
    assert "did not make" in refusal(capsys, "explore", tmp_path, "--steps", 100)
    assert path.read_bytes() == before
    assert strategy_of(Interactions.load(path).origin) is None


def test_nothing_is_written_if_there_is_nothing_to_run(discs, capsys):
    before = sorted(discs.iterdir())
    assert "did not make" in refusal(capsys, "run", discs, "--steps", 3000)
    assert sorted(discs.iterdir()) == before


def test_world_for_data_of_ones_own_leads_to_training_or_what_comes_after_it(discs, capsys):
    assert neurosym("init", discs, "--world", "toy") == 0
    assert f"next: neurosym distill {discs}" in capsys.readouterr().out
    for made in ("world.toml", "effect_model.safetensors"):
        (discs / made).unlink()
    assert neurosym("init", discs, "--world", "toy") == 0
    assert f"next: neurosym train {discs}" in capsys.readouterr().out


def test_model_that_reads_other_columns_as_grippers_is_refused(discs, capsys):
    EffectModel(Dimensions(7, 5, 2, (1,)), ModelConfig(hidden=8)).save(discs / "effect_model.safetensors")
    said = refusal(capsys, "distill", discs)
    assert "its gripper columns are [1], and those of the data [4]; train it again" in said


def test_symbols_that_hardly_any_action_encodes_to_are_told(discs, capsys):
    model = EffectModel.load(discs / "effect_model.safetensors")
    with torch.no_grad():
        model.action_encoder[-2].weight.zero_()
        model.action_encoder[-2].bias.fill_(-0.01)
    model.save(discs / "effect_model.safetensors")
    assert neurosym("distill", discs) == 0
    said = capsys.readouterr().out
    assert "no action was found that encodes to 001, 010, 011, 100, 101, 110, 111" in said
    assert "000 is done by an action that hardly encodes to it: its mean squared error is 0.98" in said
    assert neurosym("explain", discs) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "hardly encodes to the symbol: its error is 0.98, 0.05 at most" in said


def test_data_that_do_not_fit_the_world_are_refused(discs, capsys):
    (discs / "world.toml").write_text('world = "toy"\n')
    said = refusal(capsys, "distill", discs)
    assert "7 object features, 5 action parameters and 2 effect axes, and the toy world has 4" in said


def test_model_of_other_dimensions_than_the_data_is_refused(discs, capsys):
    EffectModel(Dimensions(), ModelConfig(hidden=8)).save(discs / "effect_model.safetensors")
    said = refusal(capsys, "distill", discs)
    assert "effect_model.safetensors cannot be used: it was trained on 4 object features, 12" in said
    assert "the data have 7" in said


def test_direct_model_of_other_dimensions_than_the_data_is_refused(discs, capsys):
    DirectModel(Dimensions(), DirectConfig(hidden=8)).save(discs / "direct_model.safetensors")
    said = refusal(capsys, "distill", discs)
    assert "direct_model.safetensors cannot be used: it was trained on 4 object features, 12" in said


@pytest.mark.parametrize("model", ["effect_model.safetensors", "direct_model.safetensors"])
@pytest.mark.parametrize("content", ["garbage", "foreign", "numpy", "torn"])
def test_file_that_is_no_model_is_refused(model, content, discs, capsys):
    path = discs / model
    whole = path.read_bytes()
    if content == "foreign":
        save_file({"weight": np.zeros(3, dtype=np.float32)}, path)
    elif content == "numpy":
        path.write_bytes((discs / "interactions.npz").read_bytes())
    else:
        path.write_bytes(b"\x00garbage" if content == "garbage" else whole[:-100])
    assert f"{model} cannot be used" in refusal(capsys, "distill", discs)


@pytest.mark.parametrize(
    "change",
    [
        {"dimensions": {"features": 8, "actions": 5, "effects": 2, "gripper_columns": [4]}},
        {"dimensions": {"features": "7", "actions": 5, "effects": 2, "gripper_columns": [4]}},
        {"dimensions": {"features": 7, "actions": 5, "effects": 2, "gripper_columns": [9]}},
        {"dimensions": [7, 5, 2]},
        {"config": {"hidden": 64}},
        {"config": {"depth": 3}},
        {"trained_by": 5},
    ],
)
def test_weights_that_do_not_fit_their_description_are_refused(change, learned, tmp_path):
    weights, description = read_tensors(learned / "effect_model.safetensors", EffectModel.FORMAT)
    write_tensors(tmp_path / "m", EffectModel.FORMAT, weights, {**description, **change})
    with pytest.raises(InvalidFile, match="do not fit the configuration"):
        EffectModel.load(tmp_path / "m")


def test_one_effect_axis_and_no_gripper_go_the_whole_way(tmp_path, capsys):
    columns = own_columns(200)
    write_data(tmp_path, {**columns, "effects": columns["effects"][:, :1]})
    assert neurosym("train", tmp_path, "--regime", "paper") == 0
    said = capsys.readouterr().out
    assert "e1" in said
    assert "\nverdict: " in said
    assert neurosym("distill", tmp_path) == 0
    assert "no PDDL domain can be made of 1 axis" in capsys.readouterr().out
