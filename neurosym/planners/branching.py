"""The branching table: what each primitive is predicted to do to each object of a scene.

It comes from the neural model, or from what the operators promise; planners do not care.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.cells import at_rest
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator, Vector
from neurosym.problems import Problem, SceneObject
from neurosym.promises import promised, usable
from neurosym.symbols import Symbol

Names = tuple[tuple[str, ...], ...]
"""Name of the operator for each object and choice, M rows of P; empty where there is none."""


@dataclass(frozen=True, slots=True, eq=False)
class Branching:
    """What each choice is predicted to do to each object of a scene.

    A choice is a primitive, or one of the outcomes that a primitive may have.

    Attributes:
        effects: Displacement at the end of the rise [m]; NaN where nothing is predicted.
        resting_effects: Displacement once put down [m]; used where the object ends held.
        held: Whether the object ends held.
    """

    effects: Float[np.ndarray, "M P 3"]
    resting_effects: Float[np.ndarray, "M P 3"]
    held: Bool[np.ndarray, "M P"]

    @property
    def settled(self) -> Float[np.ndarray, "M P 3"]:
        """Displacement before the next primitive may begin [m]."""
        return np.where(self.held[:, :, None], self.resting_effects, self.effects)

    def of_object(self, index: int) -> "Branching":
        """Keep one object only."""
        one = slice(index, index + 1)
        return Branching(self.effects[one], self.resting_effects[one], self.held[one])

    def usable(self, index: int) -> tuple[int, ...]:
        """Return the choices that predict something for an object."""
        predicted = np.isfinite(self.effects[index]) & np.isfinite(self.settled[index])
        return tuple(np.flatnonzero(predicted.all(axis=-1)).tolist())


def branching_of(problem: Problem, grounding: Grounding) -> tuple[Branching, Names]:
    """Return what the live operators promise as a branching table, and the operators' names.

    Args:
        problem: The problem whose M objects the table is for.
        grounding: The learned domain; its operators are in the order of the table of operators, and P is the
            greatest number of live ones of a category.
    """
    rows = [usable(grounding, item, problem.tolerance) for item in problem.objects]
    width = max(1, *map(len, rows))
    operators = tuple((*row, *[None] * (width - len(row))) for row in rows)
    return _branching(operators, _table(operators, grounding.displacement))


def predicted_branching(
    problem: Problem, grounding: Grounding, effects: Float[np.ndarray, "M P 3"]
) -> tuple[Branching, Names]:
    """Return what the neural model predicts as a branching table, and the operators' names.

    The model predicts the effect at the end of the rise. Whether the object is held then, and where it comes
    to rest if so, is what the rehearsals saw. Pairs that were never rehearsed are left out.

    Args:
        problem: The problem whose M objects the table is for.
        grounding: The learned domain; its P primitives are in the order of the table of operators.
        effects: Predicted displacements [m].
    """
    operators = _operators(problem, grounding)
    rehearsed = np.array([[operator is not None for operator in row] for row in operators])
    return _branching(operators, np.where(rehearsed[:, :, None], effects, np.nan))


def _operators(problem: Problem, grounding: Grounding) -> tuple[tuple[Operator | None, ...], ...]:
    """Find what each primitive mostly does to each object, M rows of P."""
    symbols = grounding.operators.symbols

    def promise(item: SceneObject, symbol: Symbol) -> Operator | None:
        learned = grounding.operator_for(item.category, symbol)
        return learned and promised(grounding, item, problem.tolerance)[learned.name]

    return tuple(tuple(promise(item, symbol) for symbol in symbols) for item in problem.objects)


def _branching(
    operators: tuple[tuple[Operator | None, ...], ...], effects: Float[np.ndarray, "M P 3"]
) -> tuple[Branching, Names]:
    held = np.array([[operator is not None and is_lift(operator) for operator in row] for row in operators])
    names = tuple(tuple(operator.name if operator else "" for operator in row) for row in operators)
    return Branching(effects, _table(operators, _resting), held), names


def _resting(operator: Operator) -> Vector:
    promise = operator.promise
    return at_rest(promise) if promise else (math.nan, math.nan, math.nan)


def _table(
    operators: tuple[tuple[Operator | None, ...], ...], entry: Callable[[Operator], Vector]
) -> Float[np.ndarray, "M P 3"]:
    none = (math.nan, math.nan, math.nan)
    return np.array([[entry(operator) if operator else none for operator in row] for row in operators])
