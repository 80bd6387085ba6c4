"""Runs are pictured from what happens in the world, and those that tell most come first."""

from dataclasses import replace

import numpy as np
import pytest
from toy_domain import WORLD, grounding, problem

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.pictures.film import run_stills
from neurosym.tasks.transition import PlanStep
from neurosym.worlds.toy import ToyConfig, ToyWorld

GOALS = {"item-01": (0.68, 0.0, 0.025), "item-02": (0.8, 0.18, 0.025)}
PLAN = (PlanStep("push-forward-010-cube", "item-01"), PlanStep("push-left-001-cube", "item-02"))


def test_run_is_shown_from_its_goals_to_its_start():
    asked = problem(GOALS)
    stills = run_stills(WORLD, grounding(), asked, execute(WORLD, asked, grounding(), PLAN))
    assert len(stills.frames) == len(stills.captions) == 3
    assert stills.captions[-1].endswith("item-02: resting, goal reached")
    np.testing.assert_array_equal(stills.frames[0], WORLD.picture(asked.scene(), asked.goal_positions()))
    assert not np.array_equal(stills.frames[0], WORLD.picture(asked.scene()))


def test_run_that_goes_another_way_is_not_shown():
    asked = problem(GOALS)
    run = execute(WORLD, asked, grounding(), PLAN)
    nearer = ToyWorld(replace(ToyConfig(), lift_height=0.1))
    lifted = execute(WORLD, asked, grounding(), [PlanStep("lift-000-cube", "item-01")])
    assert run_stills(nearer, grounding(), asked, run).frames
    with pytest.raises(InvalidValue, match="Step 1 of the run of errand goes another way"):
        run_stills(nearer, grounding(), asked, lifted)
