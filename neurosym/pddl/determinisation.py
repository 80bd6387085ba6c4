"""Outcomes: an operator for each way that a primitive turns out, so that planners can hope for any of them.

A primitive that lifts two objects of a category out of three leaves the third where it is, and a planner may
want either. So each outcome that is seen often enough becomes an operator of its own, at a cost that says how
rare it is: the all-outcomes determinisation of FF-Replan (Yoon, Fern and Givan, 2007). Execution sees what
really happens, and replans if it was another.
"""

import msgspec

from neurosym.naming import name_operator
from neurosym.operators import MIN_CHANCE, OperatorTable


def with_every_outcome(table: OperatorTable) -> OperatorTable:
    """Add to each operator those that promise its other outcomes, at rest or held.

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
