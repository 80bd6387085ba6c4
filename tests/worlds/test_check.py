"""`check_world` accepts worlds, and says of anything else which requirement is broken."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from neurosym import check_world
from neurosym.errors import InvalidWorld
from neurosym.world import REQUIRED
from neurosym.worlds.toy import make_world as make_toy
from neurosym.worlds.world_file import make_world


@pytest.mark.parametrize("name", ["toy", "tabletop"])
def test_worlds_of_ours_are_worlds(name):
    check_world(make_world(name, {}))


def test_worlds_without_references_are_never_given_any():
    def interact(scene, action, target, *, put_down, on_frame, ghosts):
        return make_toy().interact(scene, action, target, put_down=put_down, on_frame=on_frame, ghosts=ghosts)

    def called(scene, action, target, **options):
        return interact(
            scene, action, target, **{"put_down": True, "on_frame": None, "ghosts": None} | options
        )

    check_world(Wrong(references=(), interact=called))


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


def scene_with(**changes):
    def sample_scene(rng, objects):
        made = make_toy().sample_scene(rng, objects)
        for name, value in changes.items():
            object.__setattr__(made, name, value)
        return made

    return sample_scene


def outcome_with(**changes):
    def interact(*arguments, **options):
        made = make_toy().interact(*arguments, **options)
        for name, value in changes.items():
            object.__setattr__(made, name, value)
        return made

    return interact


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
        ({"name": "9lives"}, "has the name '9lives'"),
        ({"feature_names": ()}, "feature_names = .*one name or more"),
        ({"lift_height": 0.0}, "lift_height = 0.0; valid: a length above 0 m"),
        ({"table": ((0, 1), (0, 1))}, "table of type tuple; valid: Table"),
        ({"references": ("moon",)}, "references = .*valid: a tuple of 'place', 'object', or none"),
        ({"interact": outcome_with(reference=None)}, "gives the reference None when asked for Place"),
        ({"interact": outcome_with(carried=True)}, "carried = True without a reference"),
        ({"interact": outcome_with(carried=1)}, "outcome.carried = 1; valid: a bool"),
        ({"action_box": SimpleNamespace(low=0)}, "action_box of type SimpleNamespace"),
        ({"action_box": box(high=np.ones(3))}, r"low \(12,\), high \(3,\) and gripper \(12,\)"),
        ({"action_box": box(gripper=np.zeros(12))}, "gripper of float64; valid: bool"),
        ({"action_box": box(low=np.full(12, 2.0))}, "empty or not finite"),
        ({"sample_scene": fail}, "raises an error in sample_scene: KeyError"),
        ({"sample_scene": nothing}, "gives a NoneType as sample_scene"),
        ({"sample_scene": scene_with(positions=np.zeros((1, 2)))}, r"positions of shape \(1, 2\)"),
        ({"sample_scene": scene_with(features=np.full((1, 4), np.nan))}, "features in .* not finite"),
        ({"sample_scene": scene_with(positions=np.zeros((1, 3)))}, "off its table"),
        ({"sample_scene": surprise}, "another scene from a generator in the same state"),
        ({"interact": poor}, "raises an error in interact: TypeError: .*put_down"),
        ({"interact": nothing}, "gives a NoneType from interact"),
        ({"interact": spoil}, "changes the scene that interact is given"),
        ({"interact": outcome_with(held=1)}, "outcome.held = 1; valid: a bool"),
        ({"interact": outcome_with(target=3)}, "the target 3"),
        ({"interact": outcome_with(peak_height=np.inf)}, "peak_height = inf"),
        ({"interact": outcome_with(end=make_toy().sample_scene(np.random.default_rng(9), 1))}, "features"),
    ],
)
def test_check_says_which_requirement_is_broken(changes, message):
    with pytest.raises(InvalidWorld, match=message) as caught:
        check_world(Wrong(**changes))
    assert "\n" not in str(caught.value)
