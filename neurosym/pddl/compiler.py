"""The compiler: from the table of operators to a grounding, whose names PDDL can take."""

import math
from collections.abc import Iterable

import msgspec

from neurosym.checks import check_kind, check_length
from neurosym.choices import CELL as CELL
from neurosym.errors import InvalidValue
from neurosym.grounding import FORMAT, FORMAT_WITH_PLACES, FORMAT_WITH_RELATIONS, Grounding
from neurosym.naming import counted_axes, name_operator
from neurosym.operators import MIN_CHANCE, OperatorTable
from neurosym.pddl.strips import WORDS
from neurosym.place_operators import PlaceOperators
from neurosym.problems import LEGAL_NAME
from neurosym.relation_operators import RelationOperators
from neurosym.table import Table

MAX_CELLS = 5000
RESERVED_PREFIXES = ("finish-", "put-down-", "reach-", "move-", "a-")
"""What no operator's name begins with: steps and plans of earlier versions use it otherwise."""


def compile_domain(
    table: OperatorTable,
    *,
    name: str,
    table_bounds: Table,
    lift_height: float,
    cell: float = CELL,
    places: PlaceOperators | None = None,
    relations: RelationOperators | None = None,
) -> Grounding:
    """Turn a table of operators into everything that planning needs, an operator for each outcome.

    Args:
        table: What each primitive does to each category.
        name: Name of the domain, that of the world.
        table_bounds: Where objects may stand.
        lift_height: How far the hand rises after the last waypoint [m].
        cell: Edge of a grid cell [m].
        places: What carries objects of the same categories to places, if that was learned.
        relations: What puts objects in relations to one another, if that was learned.

    Raises:
        InvalidValue: If effects are not along x, y and z, the cell is no sensible size, or a name is not
            legal, taken, or reserved.
    """
    check_kind("table", table, OperatorTable, "an OperatorTable, as tabulate returns it")
    check_kind("name", name, str, "a PDDL name")
    check_kind("table_bounds", table_bounds, Table, "a Table")
    check_length("lift_height", lift_height)
    check_length("cell", cell)
    check_axes(table)
    widest = max(high - low for low, high in (table_bounds.x, table_bounds.y))
    if not (math.isfinite(cell) and widest / MAX_CELLS <= cell <= widest):
        raise InvalidValue(f"A cell of {cell} m will not do; valid: {widest / MAX_CELLS:g} to {widest:g} m.")
    expanded = with_every_outcome(table)
    categories = [category.name for category in table.categories]
    operators = [operator.name for operator in expanded.operators]
    carriers = [operator.name for operator in places.operators.operators] if places else []
    related = [one.name for one in relations.states] if relations else []
    related += [one.name for one in relations.operators] if relations else []
    _check_names([name, *WORDS, *categories, *operators, *carriers, *related])
    if taken := [operator for operator in operators if operator.startswith(RESERVED_PREFIXES)]:
        raise InvalidValue(
            f"No operator can be called {taken[0]}; {', '.join(RESERVED_PREFIXES)} are reserved."
        )
    return Grounding(
        format=FORMAT_WITH_RELATIONS if relations else FORMAT_WITH_PLACES if places else FORMAT,
        name=name,
        cell=cell,
        table=table_bounds,
        lift_height=lift_height,
        operators=expanded,
        places=_with_objects(places) if places else None,
        relations=relations,
    )


def with_every_outcome(table: OperatorTable) -> OperatorTable:
    """Add to each operator those that promise its other outcomes, at rest or held.

    A primitive that lifts two objects of a category out of three leaves the third where it is, and a planner
    may want either. So each outcome that is seen often enough becomes an operator of its own, at a cost that
    says how rare it is: the all-outcomes determinisation of FF-Replan (Yoon, Fern and Givan, 2007). Execution
    sees what really happens, and replans if it was another.

    Args:
        table: A table whose operators promise what is most frequent.
    """
    names = {category.symbol: category.name for category in table.categories}
    operators = [
        msgspec.structs.replace(
            operator,
            name=name_operator(operator.label, names[operator.category], [mode]),
            promised=mode.kind,
        )
        for operator in table.operators
        for mode in operator.modes
        if mode is not operator.promise and mode.kind in ("resting", "held") and mode.share >= MIN_CHANCE
    ]
    return msgspec.structs.replace(table, operators=(*table.operators, *operators))


def _with_objects(places: PlaceOperators) -> PlaceOperators:
    """Keep with each operator the objects that it was rehearsed on: its category may have had others."""
    rehearsed = {one.symbol: one.objects for one in places.operators.categories}
    operators = tuple(
        msgspec.structs.replace(one, objects=one.objects or rehearsed.get(one.category, ()))
        for one in places.operators.operators
    )
    return msgspec.structs.replace(
        places, operators=msgspec.structs.replace(places.operators, operators=operators)
    )


def check_axes(table: OperatorTable) -> None:
    """Raise `InvalidValue` unless effects are displacements along x, y and z."""
    if table.axes != 3:
        raise InvalidValue(
            f"The table of operators has effects of {counted_axes(table.axes)}; "
            "a PDDL domain needs 3: x, y and z [m]."
        )


def _check_names(names: Iterable[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if not LEGAL_NAME.fullmatch(name):
            raise InvalidValue(
                f"{name!r} is not a legal PDDL name; valid: a lower-case letter, then a-z, 0-9 and hyphens."
            )
        if name in seen:
            raise InvalidValue(f"Two parts of the domain are called {name}; each needs a name of its own.")
        seen.add(name)
