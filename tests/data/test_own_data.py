"""Data of one's own go the whole way: trained, distilled, compiled, planned with, and judged by others."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
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

EXAMPLE, PUSHER = python_blocks("data.md")
"""The script that the document shows, and the world of its discs."""
WORLD = re.findall(r"^```toml\n(world = .*?)```", (DOCS / "data.md").read_text(), re.MULTILINE | re.DOTALL)[0]
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
        Path("pusher.py").write_text(PUSHER)
        Path("discs/world.toml").write_text(WORLD)
        type_commands("discs")
    return place / "discs"


def type_commands(folder: str) -> None:
    """Type what the document types in a folder, with a quick training."""
    for command, named, *rest in map(str.split, COMMANDS):
        quick = ["--regime", "quick"] if command == "train" else []
        if named == folder:
            assert neurosym(command, named, *rest, *quick) == 0, command


@pytest.fixture
def discs(learned, tmp_path):
    """A copy that a test may change."""
    return Path(shutil.copytree(learned, tmp_path / "discs"))


def test_the_documents_example_is_learned_through_the_bits(learned):
    assert len([*EXAMPLE.splitlines(), *PUSHER.splitlines()]) < 40
    run = json.loads((learned / "runs" / "task-01.fast-downward.run.json").read_text())
    assert run["reached"]
    report = json.loads((learned / "training.json").read_text())
    assert report["r2_through_codes"] > 0.8
    assert len(report["mae"]["model"]) == 2


def test_a_plan_for_the_documents_example_is_one_by_others(discs, capsys):
    plan = discs / "plans" / "task-01.fast-downward.plan"
    capsys.readouterr()
    assert neurosym("validate", discs, "task-01", plan) == 0
    assert "as unified-planning's validator says: valid" in capsys.readouterr().out
    plan.write_text(plan.read_text().partition("\n")[2])
    assert neurosym("validate", discs, "task-01", plan) == 3
    domain = (discs / "domain.pddl").read_text()
    assert "; x (length): " in domain
    assert "(:action move-y" in domain


def test_a_csv_of_a_room_becomes_a_plan_in_six_commands(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    rng = np.random.default_rng(0)
    lines = ["feature.temperature,feature.door,choice.move,after.temperature,after.door"]
    for _ in range(600):
        warm, door, move = (
            rng.uniform(10, 30),
            int(rng.integers(2)),
            str(rng.choice(["heat", "cool", "door"])),
        )
        change = {"heat": 2.0, "cool": -2.0, "door": 0.0}[move] / (3 if door else 1) + rng.normal(0, 0.05)
        lines.append(f"{warm},{door},{move},{warm + change},{1 - door if move == 'door' else door}")
    Path("room.csv").write_text("\n".join(lines))
    type_commands("room")
    said = capsys.readouterr().out
    assert "predictor        temperature  door" in said
    assert "verdict: good" in said.split("axes; world.toml")[1]
    assert neurosym("validate", "room", "task-01", "room/plans/task-01.fast-downward.plan") == 0
    assert "valid" in capsys.readouterr().out
    assert "room.csv" not in refusal(
        capsys, "execute", "room", "task-01", "room/plans/task-01.fast-downward.plan"
    )
    assert neurosym("explain", "room") == 0
    said = capsys.readouterr().out
    assert "heat-" in said
    assert re.search(r"door-\d+ +\d+% +door over 0.5", said)
    assert neurosym("report", "room") == 0
    page = Path("room/report.html").read_text()
    drawn = re.search(r'aria-label="Which things have which symbol. 600 rows by .*?</svg>', page, re.DOTALL)
    assert drawn[0].count("M") == 600
    assert "door under 0.5" in page
    assert neurosym("compare", "room", "--tasks", "4") == 0
    assert re.search(r"valid in the model +\d+% +100%", capsys.readouterr().out)
    before = {path: path.stat().st_mtime_ns for path in Path("room/comparison").glob("*/task-*.json")}
    assert len(before) == 4
    assert neurosym("compare", "room", "--tasks", "4") == 0
    assert before == {path: path.stat().st_mtime_ns for path in before}
    assert "no world with a table" in refusal(capsys, "show", "room", "--problem", "task-01")
    assert "there is no --task or --tolerance" in refusal(
        capsys, "compare", "room", "--task", "swap", "--tolerance", "0.02"
    )
    assert "exists already" in refusal(capsys, "init", "room", "--data", "room.csv")
    axes = Path("room/world.toml").read_text()
    Path("room/world.toml").write_text(axes.replace('"temperature"', '"temperature", cell = 2.0, unit = "C"'))
    assert neurosym("compile-domain", "room") == 0
    assert "by 2" in capsys.readouterr().out
    for said, refused in (
        ("cell = 0", "a cell of 0"),
        ("low = 100, high = 200", "most of the data lie outside: they go from 10"),
        ('kind = "flag"', "is a flag, and the data have"),
        ('kind = "angle", period = 2.0', "effects go beyond half of its period"),
        ("cell = 1e6", "no effect on it is greater than"),
    ):
        Path("room/world.toml").write_text(axes.replace('"temperature"', f'"temperature", {said}'))
        assert refused in refusal(capsys, "check", "room")
        assert refused in refusal(capsys, "compile-domain", "room")
        assert refused in refusal(capsys, "train", "room")
    Path("room/world.toml").write_text(axes.replace("temperature", "warmth"))
    assert "valid: temperature, door, in this order" in refusal(capsys, "compile-domain", "room")
    assert "not a legal name" in refusal(capsys, "compile-domain", "room", "--name", "Ü")
    assert "no --cell" in refusal(capsys, "compile-domain", "room", "--cell", "0.5")
    Path("room/world.toml").unlink()
    assert neurosym("init", "room") == 0
    assert Path("room/world.toml").read_text() == axes


def test_plans_in_short_are_judged_and_written_out(discs, capsys):
    steps = json.loads((discs / "plans" / "task-01.fast-downward.json").read_text())["steps"]
    (discs / "short.plan").write_text("".join(f"({' '.join(step)})\n" for step in steps))
    assert neurosym("validate", discs, "task-01", discs / "short.plan") == 0
    assert "written out" in capsys.readouterr().out
    (discs / "short.plan").write_text(f"({' '.join(steps[0])})\n")
    assert neurosym("validate", discs, "task-01", discs / "short.plan") == 3
    record = discs / "runs" / "task-01.fast-downward.run.json"
    assert "are not replayed" in refusal(capsys, "replay", discs, record)
    assert neurosym("execute", discs, "task-01", discs / "short.plan") == 3  # nobody plans anew
    nudged = refusal(capsys, "execute", discs, "task-01", discs / "short.plan", "--disturb", 0)
    assert "no --disturb" in nudged
    for wrong, said in (("(fly thing-01)", "no operator 'fly'"), ("(act bus x)", "operator 'x'"),
                        (f"({steps[0][0]} bus)", "no thing 'bus'")):  # fmt: skip
        (discs / "short.plan").write_text(f"({' '.join(steps[0])})\n{wrong}\n")
        for command in ("validate", "execute"):
            assert said in refusal(capsys, command, discs, "task-01", discs / "short.plan")
    for goal, said in (
        (("x=1",), "cannot be read"), (("thing-01.x=0.2", "thing-01.x=0.4"), "has two goals"),
        (("thing-01.x=many",), "cannot be read"), (("thing-01.z=1",), "z"),
    ):  # fmt: skip
        typed = (word for one in goal for word in ("--goal", one))
        assert said in refusal(capsys, "new-problem", discs, *typed)


def test_scenes_and_worlds_that_cannot_be_are_refused(discs, capsys, monkeypatch):
    scene = json.loads((discs / "problems/task-01.scene.json").read_text())
    scene["things"][0]["features"] = [1, 2]
    (discs / "short.json").write_text(json.dumps(scene))
    assert "thing-01 has 2 features" in refusal(capsys, "new-problem", discs, "--scene", discs / "short.json")
    assert "cannot be 1000000 things" in refusal(capsys, "new-problem", discs, "--objects", 1_000_000)
    monkeypatch.chdir(discs.parent)
    Path("stuck.py").write_text("class Stuck:\n    def step(self, state, action):\n        return 1 / 0\n")
    (discs / "world.toml").write_text(WORLD.replace("pusher:Pusher", "stuck:Stuck"))
    record = discs / "runs/task-01.fast-downward.run.json"
    record.unlink()
    plan = discs / "plans/task-01.fast-downward.plan"
    assert "ZeroDivisionError" in refusal(capsys, "execute", discs, "task-01", plan)
    assert not record.exists()
    (discs / "world.toml").write_text(WORLD.replace("pusher:Pusher", "pusher"))
    assert "valid beside axes: none, or module:factory" in refusal(capsys, "compile-domain", discs)


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


def test_one_action_alone_is_enough_for_symbols_of_objects(tmp_path, capsys):
    rng = np.random.default_rng(0)
    lines = ["feature.mass,feature.size,choice.push,effect.x"]
    for mass, size in rng.uniform(0, 2, (300, 2)):
        lines.append(f"{mass},{size},push,{(1.0 if mass < 1 else 0.2) + rng.normal(0, 0.02)}")
    (tmp_path / "one.csv").write_text("\n".join(lines))
    folder = tmp_path / "one"
    assert neurosym("init", folder, "--data", tmp_path / "one.csv") == 0
    assert neurosym("train", folder, "--regime", "quick", "--action-bits", 1) == 0
    assert neurosym("distill", folder) == 0
    capsys.readouterr()
    assert neurosym("compile-domain", folder) == 0
    assert re.search(r"x \+(0\.99|1)", capsys.readouterr().out)


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
    assert neurosym("compile-domain", tmp_path) == 0
    assert "e1 (length)" in (tmp_path / "domain.pddl").read_text()
