"""`check_world` accepts worlds, and says of anything else which requirement is broken."""

from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

from neurosym import check_world
from neurosym.errors import InvalidWorld
from neurosym.world import REQUIRED
from neurosym.worlds import own_world
from neurosym.worlds.toy import make_world as make_toy
from neurosym.worlds.world_file import WORLDS, make_world


@pytest.mark.parametrize("name", sorted(WORLDS))
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
    made = replace(make_toy().action_box)
    for name, value in changes.items():
        object.__setattr__(made, name, value)
    return made


def made_with(method, **changes):
    """A method of the toy world, things changed in what it makes, behind the back of what checks types."""

    def make(*arguments, **options):
        made = getattr(make_toy(), method)(*arguments, **options)
        for name, value in changes.items():
            object.__setattr__(made, name, value)
        return made

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
