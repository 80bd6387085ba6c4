"""Mirrors of worlds must name what is there, and show what the world does."""

import copy
from dataclasses import replace

import numpy as np
import pytest

from neurosym import check_world
from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.world import Mirror, three_waypoints
from neurosym.worlds.own_world import broken_mirror
from neurosym.worlds.toy import ToyConfig, ToyWorld
from neurosym.worlds.world_file import make_world

FORWARD, LEFT = three_waypoints().mirrors


class MirroredToy(ToyWorld):
    """The toy world, with mirrors of one's own, and a wind that blows everything forward."""

    def __init__(self, *mirrors, box=None, wind=0.0):
        super().__init__(ToyConfig())
        self.action_box, self.wind = replace(box or self.action_box, mirrors=mirrors), wind

    def interact(self, scene, action, target, **options):  # noqa: D102
        outcome = super().interact(scene, action, target, **options)
        for moment in {id(scene): scene for scene in (outcome.lifted, outcome.end)}.values():
            if moment is not outcome.start:
                moment.positions[target, 0] += self.wind
        return outcome


def box_with(number, **bounds):
    box = three_waypoints()
    for name, value in bounds.items():
        getattr(box, name)[number] = value
    return box


@pytest.mark.parametrize(
    ("mirror", "box", "message"),
    [
        (Mirror((12,), (0,)), None, "different action parameters from 0 to 11"),
        (Mirror((), (0,)), None, "at least one"),
        (Mirror((0, 3), (0,)), None, "no gripper value"),
        (Mirror((0,), (3,)), None, "different effect axes from 0 to 2"),
        (FORWARD, box_with(4, low=-0.01), "parameter 4 goes from -0.01 to 0.05"),
        (FORWARD, box_with(0, high=0.0), "as far below 0 as above"),
    ],
)
def test_mirror_of_what_is_not_there_is_refused(mirror, box, message):
    with pytest.raises(InvalidValue, match=message) as caught:
        MirroredToy(mirror, box=box)
    assert "\n" not in str(caught.value)
    for mirrors, said in (((mirror,), message), ([mirror], "a tuple of Mirror")):
        world = MirroredToy()
        world.action_box = copy.copy(box or world.action_box)
        object.__setattr__(world.action_box, "mirrors", mirrors)  # behind the back of what makes boxes
        with pytest.raises(InvalidWorld, match=said):
            check_world(world)


@pytest.mark.parametrize(
    ("mirror", "axis"),
    [
        (Mirror(FORWARD.actions, ()), 0),
        (Mirror(FORWARD.actions, (1,)), 0),
        (Mirror(FORWARD.actions, (0, 2)), 2),
        (Mirror(LEFT.actions, (0, 1)), 0),
    ],
)
def test_mirror_in_which_the_world_does_the_opposite_is_refused(mirror, axis):
    with pytest.raises(InvalidWorld, match=f"opposite way along effect axis {axis}; leave that mirror out"):
        check_world(MirroredToy(LEFT, mirror))


def test_wind_breaks_the_mirror_that_it_blows_against_and_no_other():
    assert broken_mirror(MirroredToy(FORWARD, LEFT)) is None
    assert broken_mirror(MirroredToy(LEFT, wind=0.3)) is None
    assert "axis 0" in (broken_mirror(MirroredToy(FORWARD, wind=0.3)) or "")


def distances(world, count):
    """How far effects and what happens in each mirror lie apart, and how far the effects of chance pairs."""
    rng = np.random.default_rng(11)
    box, effects = world.action_box, []
    found = [[] for _ in box.mirrors]
    for _ in range(count):
        scene, action = world.sample_scene(rng, 1), box.sample(rng, 1)[0]
        effects.append(world.interact(scene, action, 0).effect)
        for mirror, apart in zip(box.mirrors, found, strict=True):
            image = np.where(np.isin(np.arange(len(action)), mirror.actions), -action, action)
            seen = world.interact(scene, image, 0).effect
            seen = np.where(np.isin(np.arange(3), mirror.effects), -seen, seen)
            apart.append(np.linalg.norm(effects[-1] - seen))
    by_chance = np.linalg.norm(np.array(effects) - np.array(effects)[rng.permutation(count)], axis=1)
    return np.array(found), by_chance


def test_the_toy_world_does_exactly_in_its_mirrors_what_it_does():
    found, by_chance = distances(make_world("toy", {}), 200)
    assert found.shape == (2, 200)
    assert found.max() < 1e-9 < by_chance.mean()


@pytest.mark.evaluation
def test_the_tabletop_does_nearly_the_same_in_its_mirrors(capsys):
    found, by_chance = distances(make_world("tabletop", {}), 200)
    with capsys.disabled():
        for name, apart in (("x", found[0]), ("y", found[1]), ("chance", by_chance)):
            print(f"\n{name}: {1000 * apart.mean():.1f} mm, median {1000 * np.median(apart):.1f} mm", end="")
    assert found.mean(1).max() < 0.25 * by_chance.mean()
