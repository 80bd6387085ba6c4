"""Averaging: what primitives do, read from the data themselves, where there is no world to rehearse in.

The rows whose action and object have the symbols of a pair stand in for its rehearsals. They were made with
other parameters than the distilled ones, so that such a table says what a symbol means and not what its
distilled action does.
"""

from collections.abc import Callable, Sequence

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.naming import name_operator, names_of_features
from neurosym.operators import TABLE_FORMAT, Operator, OperatorTable, Primitive
from neurosym.primitives.categories import describe_categories
from neurosym.primitives.modes import sort_into_modes
from neurosym.symbols import Symbol
from neurosym.world import OutcomeKind

ToSymbols = Callable[[np.ndarray], Sequence[Symbol]]
"""Gives the symbols of object features (N, F), or of actions (N, A)."""


def average(
    interactions: Interactions,
    primitives: Sequence[Primitive],
    object_symbols: ToSymbols,
    action_symbols: ToSymbols,
) -> OperatorTable:
    """Average effects over the rows of the data, for each primitive and category.

    Args:
        interactions: The data; feature names are read from their origin, where they stand there.
        primitives: The primitives.
        object_symbols: Gives the symbols of features.
        action_symbols: Gives the symbols of actions.

    Raises:
        InvalidValue: If there is no primitive.
    """
    if not primitives:
        raise InvalidValue("Nothing can be averaged without primitives: no action symbol was distilled.")
    objects = np.array(object_symbols(interactions.features))
    actions = np.array(action_symbols(interactions.actions))
    names = names_of_features(interactions.features.shape[1], interactions.origin.get("feature_names", ()))
    categories = describe_categories(interactions.features.astype(np.float64), objects, names)
    ordered = sorted(primitives, key=lambda primitive: primitive.symbol)
    operators = []
    for primitive in ordered:
        for category in categories:
            rows = interactions[(actions == primitive.symbol) & (objects == category.symbol)]
            if len(rows):
                operators.append(_operator(primitive.symbol, category.symbol, category.name, rows))
    return OperatorTable(categories, tuple(ordered), tuple(operators), measured="data", format=TABLE_FORMAT)


def kinds_of(interactions: Interactions) -> list[OutcomeKind]:
    """Tell for each row how the target ended, as `Outcome.kind` does."""
    flags = (interactions.lost, interactions.held, interactions.toppled)
    kinds: list[OutcomeKind] = ["lost", "held", "toppled", "resting"]
    return [kinds[number] for number in np.argmax([*flags, np.ones(len(interactions))], axis=0)]


def _operator(primitive: Symbol, category: Symbol, category_name: str, rows: Interactions) -> Operator:
    modes = sort_into_modes(
        kinds_of(rows),
        rows.effects.astype(np.float64),
        rows.resting_effects.astype(np.float64),
        rows.peak_heights.astype(np.float64),
    )
    return Operator(
        name=name_operator(primitive, category_name, modes),
        category=category,
        primitive=primitive,
        trials=len(rows),
        modes=modes,
    )
