"""A domain with places for the toy world, written by hand, and two problems: a swap, and one with a push."""

import toy_domain

from neurosym.formats import PlaceFile
from neurosym.grounding import Grounding
from neurosym.operators import Category, Kept, Mode, Operator, OperatorTable, Primitive
from neurosym.problems import Problem, SceneObject

CARRY = (0, 0, 0, 1.0, 0.01, 0, 0, 0.0, 0.03, -0.02, 0, 0.0)
OFFSET = (0.02, -0.02, 0.0)
"""Where the action sets an object down, seen from the place: from waypoint 2 to waypoint 3."""
NAME = "carry-to-01-cube"
CUBE, SLAB = (0.05, 0.05, 0.05, 0.0), (0.05, 0.12, 0.05, 0.0)


def grounding(cell: float = 0.02) -> Grounding:
    """Cubes are carried; slabs, which the toy's hand cannot span, are pushed."""
    cube = Category("00", "cube", 0.5, CUBE, (0.0,) * 4)
    slab = Category("11", "slab", 0.5, SLAB, (0.0,) * 4)
    nothing = (0.0, 0.0, 0.0)
    carried = Mode("carried", 20, 1.0, OFFSET, nothing, OFFSET, nothing, 0.2, 20)
    missed = Mode("missed", 20, 1.0, nothing, nothing, nothing, nothing, 0.0, 20)
    carriers = OperatorTable(
        (cube, slab),
        (Primitive("01", CARRY, 0.0),),
        (Operator(NAME, "00", "01", 20, (carried,)), Operator("miss-01-slab", "11", "01", 20, (missed,))),
    )
    pushes = tuple(
        toy_domain.operator(f"push-{way}-{symbol}-slab", symbol, by, category="11")
        for way, symbol, by in (("left", "001", (0.0, 0.08, 0.0)), ("forward", "010", (0.08, 0.0, 0.0)))
    )
    primitives = (Primitive("001", toy_domain.LEFT, 0.0), Primitive("010", toy_domain.FORWARD, 0.0))
    places = PlaceFile(carriers, (Kept(NAME, 10, 0),)).table()
    return toy_domain.compiled(OperatorTable((cube, slab), primitives, pushes), cell, places=places)


def scene(*objects: tuple[str, float, float]) -> tuple[SceneObject, ...]:
    """Cubes and slabs, each given as its kind and where it stands."""
    kinds = {"cube": ("00", CUBE), "slab": ("11", SLAB)}
    return tuple(
        SceneObject(f"item-{number:02d}", *kinds[kind], (x, y, 0.025))
        for number, (kind, x, y) in enumerate(objects, start=1)
    )


def swap() -> Problem:
    """Two cubes that shall change places."""
    goals = {"item-01": (0.8, 0.1, 0.025), "item-02": (0.5, -0.1, 0.025)}
    return Problem("swap", scene(("cube", 0.5, -0.1), ("cube", 0.8, 0.1)), goals, 0.02)


def mixed() -> Problem:
    """A cube to be carried to where a slab stands, which must be pushed away."""
    goals = {"item-01": (0.7, 0.0, 0.025), "item-02": (0.7, 0.16, 0.025)}
    return Problem("mixed", scene(("cube", 0.5, -0.2), ("slab", 0.7, 0.0)), goals, 0.02)
