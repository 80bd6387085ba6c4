"""A domain of relations for the toy world, written by hand from its rules, and problems for it.

Cubes and blocks stand on one another, one on each; cubes and blocks go into trays, several into each; trays
stand on nothing.
"""

import msgspec
import toy_domain

from neurosym.grounding import Grounding
from neurosym.operators import Category, Company, Kept, Mode, Operator, OperatorTable, Primitive
from neurosym.pair_operators import PairState, RelationOperators, pair_end
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
    on, lying = pair_end(ON, 19, 0.95, (0.0, 0.0, 1.0), nothing), pair_end(IN, 20, 1.0, (0, 0, 0.09), nothing)
    return RelationOperators(
        states,
        (0.5, 0.3, 0.1, 0.1, 0.1),
        kinds,
        (Primitive("01", CARRY, 0.0),),
        (
            _on_pairs(PUT_ON, "01", on, borne=10, occupied=0, laden=9),
            _on_pairs(PUT_IN, "11", lying, borne=10, occupied=8, laden=9),
            _on_pairs("miss-01-tray-10", "10", borne=0, occupied=0, laden=0),
        ),
    )


def _on_pairs(name: str, kind: str, *ends: Mode, **kept: int) -> Operator:
    company = tuple((how, Kept(name, 10, count)) for how, count in kept.items())
    return Operator(name, kind, "01", 20, ends, frame="pair", company=company)


def grounding(world: World = WORLD) -> Grounding:
    """Everything is carried to places, and on or into one another as the table says."""
    categories = tuple(
        Category(symbol, name, 0.3, features, (0.0,) * 4) for name, (symbol, features) in KINDS.items()
    )
    nothing = (0.0, 0.0, 0.0)
    carried = Mode("carried", 20, 1.0, nothing, nothing, nothing, nothing, 0.2, 20)
    kept: dict[Company, int] = {"occupied": 0, "borne": 9, "laden": 9}
    operators = []
    for category in categories:
        name = f"carry-to-01-{category.name}"
        company = tuple((how, Kept(name, 10, count)) for how, count in kept.items())
        told = name, category.symbol, "01", 20, (carried,)
        operators.append(Operator(*told, frame="place", company=company))
    carriers = OperatorTable(categories, (Primitive("01", CARRY, 0.0),), tuple(operators))
    empty = OperatorTable(categories, (), ())
    return toy_domain.compiled(empty, 0.02, world, places=carriers, relations=relations())


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
    company = tuple((how, Kept(name, 10, changes.get(how, kept.kept))) for how, kept in one.company)
    operators = tuple(replace(other, company=company) if other is one else other for other in table.operators)
    return replace(learned, relations=replace(table, operators=operators))
