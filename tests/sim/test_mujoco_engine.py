"""MuJoCo in place of PyBullet: what is chosen, what is refused, and what is the same again."""

import tomllib
from functools import partial

import numpy as np
import pytest
from command_line import contents, neurosym, refusal
from standing import CARRY, CLOSED, FAR, boxes

from neurosym.choices import ENGINES
from neurosym.errors import version_of
from neurosym.sim import config
from neurosym.sim.config import TabletopConfig
from neurosym.sim.tabletop import Tabletop
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import origin_of, read_world

MUJOCO = TabletopConfig(engine="mujoco")
BOX = boxes((0.05, 0.05, 0.08, 0, 0.5, 0.0))


def test_a_new_folder_is_simulated_by_the_engine_that_is_named(tmp_path, capsys):
    for name, options in {"usual": [], "other": ["--engine", "mujoco"]}.items():
        assert neurosym("init", tmp_path / name, *options) == 0
    told = [tomllib.loads((tmp_path / name / "world.toml").read_text()) for name in ("usual", "other")]
    assert [one["options"].pop("engine") for one in told] == ["pybullet", "mujoco"]
    assert told[0] == told[1]
    usual, other = (origin_of(read_world(tmp_path / name / "world.toml")) for name in ("usual", "other"))
    assert other["world_options"].pop("engine") == f"mujoco {version_of('mujoco-core')}"
    assert usual == other, "data that name no engine are PyBullet's"
    capsys.readouterr()
    said = refusal(capsys, "run", tmp_path / "other", "--engine", "pybullet")
    assert "is simulated by mujoco, not pybullet; name another folder" in said


def test_a_folder_whose_engine_was_changed_is_not_mixed(tmp_path, capsys):
    assert neurosym("init", tmp_path, "--engine", "mujoco") == 0
    little = ["--strategy", "random", "--workers", "1"]
    assert neurosym("explore", tmp_path, "--steps", "8", *little) == 0
    world = tmp_path / "world.toml"
    world.write_text(world.read_text().replace('"mujoco"', '"pybullet"'))
    (tmp_path / "budget.json").write_text('{"rounds": []}')  # it grows in rounds
    before = contents(tmp_path)
    capsys.readouterr()
    exploring = ["explore", tmp_path, "--steps", "16", *little]
    for command in (exploring, ["run", tmp_path, "--interactions", "1000", *little], ["train", tmp_path]):
        said = refusal(capsys, *command)
        assert (
            f"engine = 'mujoco {version_of('mujoco-core')}', and {world} says 'pybullet'; set it back" in said
        )
    assert contents(tmp_path) == before


@pytest.mark.parametrize("command", ["init", "run"])
def test_a_world_without_engines_is_not_made(command, tmp_path, capsys):
    said = refusal(capsys, command, tmp_path / "new", "--world", "toy", "--engine", "mujoco")
    assert "toy has no --engine; tabletop and camera have" in said
    assert not (tmp_path / "new").exists()


def test_an_engine_that_is_not_there_is_refused_in_one_sentence(tmp_path, capsys, monkeypatch):
    (tmp_path / "world.toml").write_text('world = "tabletop"\n[options]\nengine = "bullet"\n')
    assert "no engine 'bullet'; valid: mujoco, pybullet" in refusal(capsys, "explore", tmp_path)
    monkeypatch.setattr(config, "find_spec", lambda _: None)
    said = refusal(capsys, "init", tmp_path / "new", "--engine", "mujoco")
    assert "pip install 'neurosym-pddl[mujoco]'" in said
    assert not (tmp_path / "new").exists()


def test_other_interactions_and_other_processes_change_no_byte():
    scenes = [boxes((0.05, 0.05, 0.08, 0, 0.5, 0.0)), boxes((0.12, 0.06, 0.04, 1, 0.6, 0.1))]
    tasks = [Task(scene, CARRY, 0, reference=FAR) for scene in scenes]
    forward, backward = (
        [*perform_all(partial(Tabletop, MUJOCO), some, workers=workers)]
        for some, workers in ((tasks, 1), (tasks[::-1], 2))
    )
    for one, two in zip(forward, backward[::-1], strict=True):
        assert one.carried
        assert one.end.positions.tobytes() == two.end.positions.tobytes()


def test_engines_agree_on_what_is_carried_and_pushed_and_not_on_the_last_bit():
    push = np.array([0, -0.08, 0, CLOSED, 0, 0, 0, CLOSED, 0, 0.05, 0, CLOSED])
    for action, reference in ((CARRY, FAR), (push, None)):
        ends = [
            Tabletop(TabletopConfig(engine=name)).interact(BOX, action, 0, reference=reference)
            for name in ENGINES
        ]
        one, two = (each.end.positions[0] for each in ends)
        assert ends[0].kind == ends[1].kind
        assert 0 < np.linalg.norm(one - two) < 0.01
        assert np.linalg.norm(one - BOX.positions[0]) > 0.05
