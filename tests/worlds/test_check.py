"""`check_world` says which requirement is broken; mirrors name what is there, and show what happens."""

import copy
from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

from neurosym import check_world
from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.world import REQUIRED, Mirror, three_waypoints
from neurosym.worlds import own_world
from neurosym.worlds.own_world import broken_mirror
from neurosym.worlds.toy import ToyConfig, ToyWorld
from neurosym.worlds.toy import make_world as make_toy
from neurosym.worlds.world_file import SEEING, WORLDS, make_world


@pytest.mark.parametrize("name", sorted(WORLDS.keys() - {SEEING}))  # tests/sim/ has one with an eye
def test_worlds_of_ours_are_worlds(name, monkeypatch):
    monkeypatch.setattr(own_world, "_INTERACTIONS", 4)  # that are looked at through each mirror
    check_world(make_world(name, {}))


class Wrong:
    """A toy world, one thing about it changed."""

    def __init__(self, **changes):
        self._world = make_toy()
        for name in (*REQUIRED, *changes):  # which newer Pythons look for without `__getattr__`
            setattr(self, name, changes.get(name, getattr(self._world, name, None)))

    def __getattr__(self, name):
        return getattr(self._world, name)


def box(**changes):
    """An action box with columns changed, behind the back of what checks its shape."""
    return changed(replace(make_toy().action_box), changes)


def changed(made, changes):
    for name, value in changes.items():
        object.__setattr__(made, name, value)
    return made


def made_with(method, **changes):
    """A method of the toy world, things changed in what it makes, behind the back of what checks types."""

    def make(*arguments, **options):
        return changed(getattr(make_toy(), method)(*arguments, **options), changes)

    return make


scene_with, outcome_with = partial(made_with, "sample_scene"), partial(made_with, "interact")
TWO = make_toy().sample_scene(np.random.default_rng(9), 2)


def spoil(scene, action, target, **options):
    scene.positions[0, 0] += 0.01
    return make_toy().interact(scene, action, target, **options)


def surprise(rng, objects):
    return make_toy().sample_scene(np.random.default_rng(), objects)


def poor(scene, action, target):
    return make_toy().interact(scene, action, target)


def nothing(*arguments, **options):
    return None


def fail(*arguments, **options):
    raise KeyError("joint")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"feature_names": ()}, "feature_names = .*one name or more"),
        ({"references": ("moon",)}, "references = .*valid: a tuple of 'place', 'object', or none"),
        ({"interact": outcome_with(reference=None)}, "gives the reference None when asked for Place"),
        ({"interact": outcome_with(carried=True)}, "carried = True without a reference"),
        ({"action_box": SimpleNamespace(low=0)}, "action_box of type SimpleNamespace"),
        ({"action_box": box(high=np.ones(3))}, r"low \(12,\), high \(3,\) and gripper \(12,\)"),
        ({"action_box": box(gripper=np.zeros(12))}, "gripper of float64; valid: bool"),
        ({"sample_scene": fail}, "raises an error in sample_scene: KeyError"),
        ({"sample_scene": nothing}, "gives a NoneType as sample_scene"),
        ({"sample_scene": scene_with(positions=np.zeros((1, 2)))}, r"positions of shape \(1, 2\)"),
        ({"sample_scene": scene_with(features=np.full((1, 4), np.nan))}, "features in .* not finite"),
        ({"sample_scene": scene_with(positions=[[0.7, 0, 0]])}, "positions of type list .*: a numpy array"),
        ({"sample_scene": scene_with(features=np.ones((1, 2)))}, r"shape \(1, 2\) .* 1 object: \(1, 4\)"),
        ({"sample_scene": scene_with(positions=np.zeros((1, 3)))}, "off its table"),
        ({"sample_scene": surprise}, "another scene from a generator in the same state"),
        ({"interact": poor}, "raises an error in interact: TypeError: .*put_down"),
        ({"interact": nothing}, "gives a NoneType from interact"),
        ({"interact": spoil}, "changes the scene that interact is given"),
        ({"interact": outcome_with(held=1)}, "outcome.held = 1; valid: a bool"),
        ({"interact": outcome_with(target=3)}, "the target 3"),
        ({"interact": outcome_with(peak_height=np.inf)}, "peak_height = inf"),
        ({"interact": outcome_with(end=make_toy().sample_scene(np.random.default_rng(9), 1))}, "features"),
        ({"interact": outcome_with(lifted=TWO)}, r"features of shape \(2, 4\) in outcome.lifted"),
        ({"interact": outcome_with(end=None)}, "a NoneType as outcome.end; valid: a Scene"),
        ({"interact": outcome_with(touched=(5,))}, r"outcome.touched = \(5,\)"),
    ],
)
def test_check_says_which_requirement_is_broken(changes, message):
    with pytest.raises(InvalidWorld, match=message) as caught:
        check_world(Wrong(**changes))
    assert "\n" not in str(caught.value)


# Mirrors

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
