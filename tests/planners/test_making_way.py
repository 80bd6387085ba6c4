"""Who stands in a way is carried out of it: to its goal if that is beside it, or else aside."""

import msgspec
import numpy as np
from toy_places import grounding, scene

from neurosym.planners.joined_plans import _Way as Way
from neurosym.problems import Problem

PATH = np.array([[[0.7, y, 0.025]] for y in (-0.16, -0.08, 0.0, 0.08, 0.16, 0.24)])  # (steps, 1, 3)


def way(*cubes: tuple[float, float], **goals: tuple[float, float, float]) -> Way:
    """A slab's way along y at x = 0.7 m, and cubes."""
    things = scene(("slab", 0.7, -0.16), *(("cube", x, y) for x, y in cubes))
    named = {name.replace("_", "-"): goal for name, goal in goals.items()}
    now = Problem("way", things, {"item-01": (0.7, 0.24, 0.025), **named}, 0.02)
    return Way(PATH, ["item-01"], now, grounding().table)


def cleared(of: Way, *, everything: bool = False) -> dict[str, tuple[float, float, float]]:
    names = of.now.object_names[1:]
    goals = {name: goal for name, goal in of.now.goals.items() if name in names}
    return of.cleared(names, goals, everything=everything)


def clear_of(spot: tuple[float, ...], x: float, y: float, room: tuple[float, float]) -> bool:
    return abs(spot[0] - x) >= room[0] - 1e-9 or abs(spot[1] - y) >= room[1] - 1e-9


def test_who_stands_beside_the_way_stays():
    assert cleared(way((0.5, 0.0))) == {}


def test_who_stands_in_the_way_goes_to_its_goal_if_that_is_beside_it():
    goal = (0.5, 0.0, 0.025)
    assert cleared(way((0.7, 0.0), item_02=goal)) == {"item-02": goal}


def test_who_has_its_goal_beside_the_way_goes_there_if_everything_shall():
    goal = (0.5, 0.2, 0.025)
    assert cleared(way((0.5, 0.0), item_02=goal)) == {}
    assert cleared(way((0.5, 0.0), item_02=goal), everything=True) == {"item-02": goal}


def test_who_has_its_goal_in_the_way_waits_where_nobody_is_disturbed():
    """Beside the way by the hand's room, off the other cube, its goal and the edge."""
    of = way((0.7, 0.0), (0.5, 0.0), item_02=(0.7, 0.1, 0.025), item_03=(0.5, 0.2, 0.025))
    spots = cleared(of)
    assert list(spots) == ["item-02"]
    spot = spots["item-02"]
    assert all(clear_of(spot, 0.7, y, (0.07, 0.105)) for y in PATH[:, 0, 1])
    assert clear_of(spot, 0.5, 0.0, (0.1, 0.1))
    assert clear_of(spot, 0.5, 0.2, (0.1, 0.1))
    assert grounding().table.contains(np.array(spot))


def test_two_that_wait_do_not_wait_in_each_other():
    spots = cleared(way((0.7, 0.0), (0.7, 0.1)))
    (x, y, _), other = spots["item-02"], spots["item-03"]
    assert clear_of(other, x, y, (0.1, 0.1))


def test_objects_wait_only_at_the_places_that_somebody_wrote():
    of = way((0.7, 0.0))
    for places, waits in (
        ({"shelf": (0.5, 0.1)}, {"item-02": (0.5, 0.1, 0.025)}),
        ({"in-it": (0.7, 0.1)}, {}),
    ):
        own = msgspec.structs.replace(of.now, places=places)
        assert cleared(Way(PATH, ["item-01"], own, of.table)) == waits
