"""What takes minutes of physics: run by `make evaluate`, each figure printed with -s."""

from functools import partial

import numpy as np
import pytest

from neurosym.cli import main
from neurosym.files import read_json
from neurosym.interactions import Interactions
from neurosym.plan_stages import PlanRecord
from neurosym.workers import Task, perform_all
from neurosym.world_file import make_world

pytestmark = pytest.mark.evaluation
TABLETOP = partial(make_world, "tabletop", {})


def random_tasks(count: int, seed: int, nudge: float = 0.0) -> list[Task]:
    """Random actions on random objects, each nudged by a random vector of that length [m]."""
    world = TABLETOP()
    tasks = []
    for number in range(count):
        rng = np.random.default_rng([seed, number])
        scene = world.sample_scene(rng, 1)
        action = world.action_box.sample(rng, 1)[0]
        direction = np.where(world.action_box.gripper, 0.0, rng.normal(size=len(action)))
        nudged = action + nudge * direction / np.linalg.norm(direction)
        tasks.append(Task(scene, np.clip(nudged, world.action_box.low, world.action_box.high)))
    return tasks


def test_most_of_the_effect_survives_a_tenth_of_a_millimetre():
    effects = [
        np.array([outcome.effect for outcome in perform_all(TABLETOP, random_tasks(600, 77, nudge), 2)])
        for nudge in (0.0, 1e-4)
    ]
    lost = ((effects[0] - effects[1]) ** 2).sum() / 2
    share = 1 - lost / ((effects[0] - effects[0].mean(0)) ** 2).sum()
    print(f"share of the effects' variance that survives 0.1 mm: {share:.3f}")
    assert share > 0.96


def test_held_objects_are_put_down_where_they_hung_and_object_and_hand_decide_who_is_held():
    tasks = random_tasks(1500, 78)
    data = Interactions.from_outcomes(
        list(perform_all(TABLETOP, tasks, 2)), np.array([task.action for task in tasks]), {}
    )
    away = np.linalg.norm((data.resting_effects - data.effects)[data.held][:, :2], axis=1)
    hollow, wide = data.features[:, 3] >= 0.5, data.features[:, 1] > 0.14
    print(f"held {data.held.mean():.3f}, put down within 1 cm {np.mean(away < 0.01):.3f}")
    assert np.mean(away < 0.01) > 0.93
    assert data.held[hollow & wide].mean() > 10 * data.held[~hollow & wide].mean()
    assert data.held[data.actions[:, 11] >= 0.5].mean() < 0.03


def test_thousand_curious_steps_lead_to_an_executed_plan(tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["run", str(tmp_path / "domain"), "--steps", "1024", "--seed", "7"])
    assert ended.value.code == 0
    records = [read_json(path, PlanRecord) for path in (tmp_path / "domain/plans").glob("*.json")]
    assert any(record.steps for record in records)
    assert list((tmp_path / "domain/runs").glob("*.run.json"))
