"""Problems drawn from a world, and goals set by hand."""

import numpy as np
import pytest
from toy_domain import WORLD

from neurosym.errors import InvalidValue
from neurosym.world import Scene
from neurosym.worlds.task_drawing import draw_problem, set_problem
from neurosym.worlds.toy import ToyConfig, ToyWorld


def categorise(features: np.ndarray) -> tuple[str, ...]:
    return tuple("10" if row[3] >= 0.5 else "00" for row in features)


class _StuckWorld(ToyWorld):
    """Solid objects too wide to grasp and too long to push."""

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        scene = super().sample_scene(rng, objects)
        scene.features[:, 3] = 0.0
        return scene


def draw(seed: int, objects: int = 1):
    return draw_problem(WORLD, categorise, name="task", objects=objects, seed=seed)


def test_same_seed_draws_the_same_problem_and_another_seed_another():
    assert draw(3, 2) == draw(3, 2)
    assert draw(3, 2) != draw(4, 2)


@pytest.mark.parametrize("objects", [1, 2])
def test_no_drawn_problem_is_met_at_its_start_and_every_goal_is_on_the_table(objects):
    for seed in range(40):
        problem = draw(seed, objects)
        assert not problem.is_met(problem.scene().positions)
        assert set(problem.goals) == set(problem.object_names)
        assert all(WORLD.table.contains(np.array(goal)) for goal in problem.goals.values())


def test_some_drawn_goals_are_in_mid_air():
    heights = [draw(seed).goals["item-01"][2] for seed in range(40)]
    assert max(heights) > 0.2
    assert min(heights) < 0.1


def test_objects_carry_the_symbols_they_were_given():
    problem = draw(5, 2)
    assert tuple(item.category for item in problem.objects) == categorise(problem.scene().features)


def test_world_in_which_nothing_moves_is_reported_not_searched_for_ever():
    stuck = _StuckWorld(ToyConfig(sizes=(0.17, 0.18)))
    with pytest.raises(InvalidValue, match="None of 1000 random actions"):
        draw_problem(stuck, categorise, name="task", objects=1, seed=0)


def test_several_actions_make_a_task_in_which_each_begins_at_rest():
    problem = draw_problem(WORLD, categorise, name="task", objects=3, actions=4, seed=5)
    assert problem.provenance.startswith("drawn with seed 5: 4 random actions on item-0")
    aloft = [
        name for name, goal in problem.goals.items() if goal[2] > problem.object_named(name).position[2] + 0.1
    ]
    assert len(aloft) <= 1
    assert all(WORLD.table.contains(goal) for goal in map(np.array, problem.goals.values()))
    with pytest.raises(InvalidValue, match="at least one action, not 0"):
        draw_problem(WORLD, categorise, name="task", objects=1, actions=0, seed=0)


def test_goal_set_by_hand_rests_on_the_table_unless_it_says_otherwise():
    problem = set_problem(
        WORLD, categorise, {"item-01": (0.7, 0.1), "item-02": (0.6, 0.0, 0.2)}, name="t", objects=2, seed=0
    )
    assert problem.goals["item-01"] == (0.7, 0.1, problem.objects[0].position[2])
    assert problem.goals["item-02"] == (0.6, 0.0, 0.2)


@pytest.mark.parametrize(
    ("goals", "message"),
    [
        ({"item-01": (2.0, 0.0)}, "x = 2 m, out of reach; valid: x 0.4 to 1"),
        ({"item-01": (0.7,)}, "give x,y or x,y,z"),
        ({"item-01": (0.7, float("nan"))}, "give x,y or x,y,z"),
        ({"item-09": (0.7, 0.0)}, "item-09, which is not in the scene"),
        ({}, "no goal"),
    ],
)
def test_impossible_goals_are_refused_in_one_sentence(goals, message):
    with pytest.raises(InvalidValue, match=message):
        set_problem(WORLD, categorise, goals, name="t", objects=1, seed=0)


def test_problem_without_objects_is_refused():
    with pytest.raises(InvalidValue, match="at least one object"):
        draw(0, 0)
