"""`neurosym figures` draws primitives and example plans from what happens in the world."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import neurosym, refusal
from PIL import Image
from toy_domain import WORLD, grounding, problem

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.pictures.images import STRIP_SIZE
from neurosym.pictures.motions import surest_carriers
from neurosym.pictures.stills import run_stills
from neurosym.report.examples import Example, telling_examples
from neurosym.tasks.steps import PlanStep
from neurosym.worlds.toy import ToyConfig, ToyWorld

GOALS = {"item-01": (0.68, 0.0, 0.025), "item-02": (0.8, 0.18, 0.025)}
PLAN = (PlanStep("push-forward-010-cube", "item-01"), PlanStep("push-left-001-cube", "item-02"))


def example(tmp_path, name, goals, plan):
    asked = problem(goals)
    run = execute(WORLD, asked, grounding(), plan)
    return Example(tmp_path / f"{name}.bfs.run.json", asked, run)


def test_run_is_shown_from_its_goals_to_its_start():
    asked = problem(GOALS)
    stills = run_stills(WORLD, asked, grounding(), execute(WORLD, asked, grounding(), PLAN))
    assert len(stills.frames) == len(stills.captions) == 3
    assert stills.captions[-1].endswith("item-02: resting, goal reached")
    np.testing.assert_array_equal(stills.frames[0], WORLD.picture(asked.scene(), asked.goal_positions()))
    assert not np.array_equal(stills.frames[0], WORLD.picture(asked.scene()))


def test_run_that_goes_another_way_is_not_shown():
    asked = problem(GOALS)
    run = execute(WORLD, asked, grounding(), PLAN)
    nearer = ToyWorld(replace(ToyConfig(), lift_height=0.1))
    lifted = execute(WORLD, asked, grounding(), [PlanStep("lift-000-cube", "item-01")])
    assert run_stills(nearer, asked, grounding(), run).frames
    with pytest.raises(InvalidValue, match="Step 1 of the run of errand goes another way"):
        run_stills(nearer, asked, grounding(), lifted)


def test_examples_that_reach_their_goals_with_more_objects_come_first(tmp_path):
    both = example(tmp_path, "errand", GOALS, PLAN)
    one = example(tmp_path, "errand", {"item-01": GOALS["item-01"]}, PLAN[:1])
    missed = example(tmp_path, "errand", GOALS, PLAN[:1])
    empty = example(tmp_path, "errand", GOALS, ())
    assert telling_examples([missed, one, empty, both]) == (both,)
    assert telling_examples([missed, empty]) == (missed,)


def test_figures_have_a_row_for_each_primitive_and_plan(folder, capsys):
    assert neurosym("figures", folder) == 0
    said = capsys.readouterr().out
    grounding = Grounding.load(folder / "grounding.json")
    carriers = surest_carriers(grounding)
    assert carriers
    with Image.open(folder / "pictures/figure-3-primitives.png") as image:
        assert image.height // (len(grounding.operators.symbols) + len(carriers)) in range(
            STRIP_SIZE[1], STRIP_SIZE[1] + 120
        )
    with Image.open(folder / "pictures/figure-4-plans.png") as image:
        assert image.width >= 2 * STRIP_SIZE[0]
    assert f"wrote {folder}/pictures/figure-4-plans.png" in said


def test_without_runs_there_is_no_figure_of_plans(folder, tmp_path, capsys):
    for run in (folder / "runs").iterdir():
        run.unlink()
    assert neurosym("figures", folder, "--output", tmp_path / "figures") == 0
    assert [path.name for path in (tmp_path / "figures").iterdir()] == ["figure-3-primitives.png"]
    assert "no Figure 4" in capsys.readouterr().out


def test_damaged_records_are_named_and_left_out(folder, capsys):
    whole = Path(next((folder / "runs").glob("*.json")))
    broken = folder / "runs/task-01.mine.run.json"
    broken.write_text(whole.read_text().replace('"reached": true', '"reached": null', 1))
    assert neurosym("figures", folder) == 0
    said = capsys.readouterr().out
    notes = [line for line in said.splitlines() if line.startswith("note: ")]
    assert len(notes) == 1
    assert notes[0].startswith(f"note: {broken} cannot be used: Expected `bool`, got `null`")
    assert f"wrote {folder}/pictures/figure-4-plans.png" in said


def test_figures_that_cannot_be_drawn_are_refused(folder, capsys):
    assert "name a folder" in refusal(capsys, "figures", folder, "--output", folder / "world.toml")
    (folder / "grounding.json").unlink()
    assert "neurosym compile-domain" in refusal(capsys, "figures", folder)
