"""A domain of relations for the toy world, written by hand from its rules, and problems for it.

Cubes and blocks stand on one another, one on each; cubes and blocks go into trays, several into each; trays
stand on nothing.
"""

import msgspec
import toy_domain

from neurosym.grounding import Grounding
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive
from neurosym.pair_operators import (
    Kept,
    PairEnd,
    PairState,
    PlaceOperators,
    RelationOperator,
    RelationOperators,
)
from neurosym.problems import Problem, SceneObject
from neurosym.world import World
from neurosym.worlds.toy_relations import ToyRelations

WORLD = ToyRelations()
CARRY = (0, 0, 0, 1.0, 0, 0, 0, 0.0, 0, 0, 0, 0.0)
CUBE, BLOCK, TRAY = (0.05, 0.05, 0.05, 0.0), (0.08, 0.08, 0.05, 0.0), (0.18, 0.18, 0.06, 1.0)
KINDS = {"cube": ("00", CUBE), "block": ("01", BLOCK), "tray": ("10", TRAY)}
ON, IN = "001", "010"
REST, LIE = "rests-on-001", "lies-in-010"
PUT_ON, PUT_IN = "put-on-01-solid-01", "put-in-01-hollow-11"


def relations() -> RelationOperators:
    """What the rules of the toy world make true of pairs."""
    nothing = (0.0, 0.0, 0.0)
    states = (
        PairState("000", "apart-000", (1.5, 0.0, 0.0, 0.0, 0.0), 0.8, False),
        PairState(ON, REST, (0.0, 1.0, 1.0, 0.0, 0.0), 0.0, True),
        PairState(IN, LIE, (0.2, 0.1, 1.0, 0.0, 0.0), 0.0, True),
        PairState("011", "below-011", (0.0, -1.0, 1.0, 0.0, 0.0), 0.0, False),
        PairState("100", "beside-100", (1.0, 0.0, 1.0, 0.0, 0.0), 0.1, False),
    )
    mean = tuple((one + other) / 2 for one, other in zip(CUBE, BLOCK, strict=True))
    kinds = (
        Category("01", "solid-01", 0.4, (*mean, *mean), (0.0,) * 8),
        Category("10", "tray-10", 0.4, (*TRAY, *mean), (0.0,) * 8),
        Category("11", "hollow-11", 0.2, (*mean, *TRAY), (0.0,) * 8),
    )
    on, lying = PairEnd(ON, 19, 0.95, (0.0, 0.0, 1.0), nothing), PairEnd(IN, 20, 1.0, (0, 0, 0.09), nothing)
    return RelationOperators(
        states,
        (0.5, 0.3, 0.1, 0.1, 0.1),
        kinds,
        (Primitive("01", CARRY, 0.0),),
        (
            RelationOperator(PUT_ON, "01", "01", 20, (on,), *_kept(PUT_ON, borne=10, occupied=0, laden=9)),
            RelationOperator(PUT_IN, "11", "01", 20, (lying,), *_kept(PUT_IN, borne=10, occupied=8, laden=9)),
            RelationOperator("miss-01-tray-10", "10", "01", 20, (), *_kept("miss", 0, 0, 0)),
        ),
    )


def _kept(name: str, borne: int, occupied: int, laden: int) -> tuple[Kept, Kept, Kept]:
    return Kept(name, 10, borne), Kept(name, 10, occupied), Kept(name, 10, laden)


def grounding(world: World = WORLD) -> Grounding:
    """Everything is carried to places, and on or into one another as the table says."""
    categories = tuple(
        Category(symbol, name, 0.3, features, (0.0,) * 4) for name, (symbol, features) in KINDS.items()
    )
    nothing = (0.0, 0.0, 0.0)
    carried = Mode("carried", 20, 1.0, nothing, nothing, nothing, nothing, 0.2, 20)
    operators = tuple(
        Operator(f"carry-to-01-{category.name}", category.symbol, "01", 20, (carried,))
        for category in categories
    )
    carriers = OperatorTable(categories, (Primitive("01", CARRY, 0.0),), operators)
    nearly_always = tuple(Kept(one.name, 10, 9) for one in operators)
    never = tuple(Kept(one.name, 10, 0) for one in operators)
    places = PlaceOperators(carriers, never, borne=nearly_always, laden=nearly_always)
    empty = OperatorTable(categories, (), ())
    return toy_domain.compiled(empty, 0.02, world, places=places, relations=relations())


def scene(*objects: tuple[str, float, float] | tuple[str, float, float, float]) -> tuple[SceneObject, ...]:
    """Objects, each given as its kind, where it stands, and at which height unless on the table."""
    return tuple(
        SceneObject(f"item-{number:02d}", *KINDS[kind], (x, y, (*under, 0.0)[0] + KINDS[kind][1][2] / 2))
        for number, (kind, x, y, *under) in enumerate(objects, start=1)
    )


def tower() -> Problem:
    """Three cubes and a block, which shall be a tower of three."""
    objects = scene(("cube", 0.5, -0.2), ("block", 0.5, 0.1), ("cube", 0.7, -0.1), ("cube", 0.8, 0.15))
    goals = (("item-01", "item-03", REST), ("item-03", "item-02", REST))
    return Problem("tower", objects, {}, 0.02, relations=goals)


def tower_at_place() -> Problem:
    """The same, with the block at a place where a cube stands at first."""
    return msgspec.structs.replace(tower(), name="tower-at-place", goals={"item-02": (0.8, 0.15, 0.025)})


def sorting() -> Problem:
    """A stack of three, of which two shall come into two trays."""
    objects = scene(
        ("cube", 0.5, 0.0, 0.1),
        ("cube", 0.5, 0.0, 0.05),
        ("block", 0.5, 0.0),
        ("tray", 0.8, -0.15),
        ("tray", 0.8, 0.15),
    )
    goals = (("item-01", "item-04", LIE), ("item-02", "item-05", LIE))
    return Problem("sorting", objects, {}, 0.02, relations=goals)


def relearned(name: str, learned: Grounding | None = None, **changes: int) -> Grounding:
    """Return the domain after other rehearsals of one operator, given as how many of 10 were kept."""
    learned, replace = learned or grounding(), msgspec.structs.replace
    table = learned.relations
    assert table is not None
    one = next(one for one in table.operators if one.name == name)
    cases = {case: replace(getattr(one, case), trials=10, kept=kept) for case, kept in changes.items()}
    operators = tuple(replace(other, **cases) if other is one else other for other in table.operators)
    return replace(learned, relations=replace(table, operators=operators))
