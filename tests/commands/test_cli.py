"""The command line: what it writes, what it says, and what it names as the next step."""

import json
from pathlib import Path

from command_line import neurosym
from conftest import RUN_TOY

from neurosym.stages.folder import DomainFolder


def test_run_makes_again_what_is_missing_and_what_comes_after(folder, capsys):
    stages = DomainFolder(folder).manifest().stages
    assert (stages["explore"].options["seed"], stages["explore"].options["steps"]) == (3, 1024)
    assert "domain.pddl" in stages["compile-domain"].outputs
    (folder / "grounding.json").unlink()
    assert neurosym("run", folder, *RUN_TOY) == 0
    said = capsys.readouterr().out
    assert "distill: up to date" in said
    assert "compile-domain: done" in said
    assert said[said.rindex("\nverdict: ") :].splitlines()[-1].startswith("next: ")


def test_goal_set_by_hand_is_planned_and_reached(folder, capsys):
    scene, plan = folder / "problems/mine.scene.json", folder / "plans/mine.fast-downward.plan"
    strip, gif = folder / "mine.png", folder / "mine.gif"
    pictures = ("--strip", strip, "--gif", gif)
    for seed in range(12):  # some objects do not budge; the first that does will do
        mine = ("new-problem", folder, "--name", "mine", "--seed", seed, "--goal")
        assert neurosym(*mine, "item-01=0.7,0") == 0
        x, y, _ = json.loads(scene.read_text())["objects"][0]["position"]
        neurosym(*mine, f"item-01={x},{y + (0.08 if y < 0 else -0.08)}")
        if neurosym("plan", folder, "mine") == 0:
            capsys.readouterr()
            if neurosym("execute", folder, "mine", plan, *pictures) == 0:
                break
    assert "goal reached" in capsys.readouterr().out
    assert strip.read_bytes().startswith(b"\x89PNG")
    assert gif.read_bytes().startswith(b"GIF")
    record = folder / "runs/mine.fast-downward.run.json"
    assert json.loads(record.read_text())["reached"]
    assert neurosym("execute", folder, "mine", plan, "--disturb", "3") in (0, 3)
    assert "was nudged by" in capsys.readouterr().out
    assert neurosym("replay", folder, record) == 0
    assert "byte for byte" in capsys.readouterr().out
    record.write_text(record.read_text().replace('"touched": []', '"touched": ["item-01"]'))
    assert neurosym("replay", folder, record) == 3
    assert "something else happened" in capsys.readouterr().out


def test_new_problem_takes_the_first_free_name_and_what_it_replaces_is_told(folder, capsys):
    before = (folder / "problems/task-01.scene.json").read_bytes()
    for name in ("task-03", "task-04"):
        assert neurosym("new-problem", folder) == 0
        assert f"wrote {folder}/problems/{name}.pddl" in capsys.readouterr().out
    assert (folder / "problems/task-01.scene.json").read_bytes() == before
    assert neurosym("new-problem", folder, "--name", "task-01", "--seed", 8) == 0
    assert f"replaced {folder}/problems/task-01.pddl" in capsys.readouterr().out


def init(folder: Path, capsys) -> str:
    """Give a folder its world, and return what is to be typed next."""
    (folder / "world.toml").unlink(missing_ok=True)
    capsys.readouterr()
    assert neurosym("init", folder, "--world", "toy") == 0
    return capsys.readouterr().out.splitlines()[-1]


def test_next_step_is_what_follows_what_is_there(folder, capsys):
    assert init(folder, capsys) == f"next: neurosym distill {folder}"
    (folder / "effect_model.safetensors").unlink()
    assert init(folder, capsys) == f"next: neurosym train {folder}"
    (folder / "interactions.npz").unlink()
    assert init(folder, capsys) == f"next: neurosym explore {folder}"
