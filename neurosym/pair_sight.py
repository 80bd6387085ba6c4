"""What is said of pairs before anything is done: their kinds, and how surely operators will keep promises.

Networks say it where there are some. Without one, a pair is of the kind whose mean features are nearest.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.operators import Category
from neurosym.pooled_puts import FAINT, FAINTEST, LEAST, pooled, share_with_any
from neurosym.problems import Problem
from neurosym.relation_goals import pair_key
from neurosym.relation_operators import PairStates, RelationOperators
from neurosym.symbols import Symbol

KindsOfPairs = Callable[[Float[np.ndarray, "N F"]], tuple[Symbol, ...]]
"""Gives the kinds of pairs, from the features of the target and then those of the reference."""
ChancesOfStates = Callable[[Float[np.ndarray, "N F"], Float[np.ndarray, "N A"]], Float[np.ndarray, "N S"]]
"""Foresees the chances of the states that bear, in the order of their codes, from features of pairs and
actions."""
_LEAST_SPREAD = 1e-3
_DIGITS = 3


@dataclass(frozen=True, slots=True)
class PairSight:
    """What learned networks say of pairs of objects.

    Attributes:
        kinds: Gives their kinds.
        chances: Foresees the states that actions bring them to; None where that was not learned.
        order: Codes of the states, in the order in which they are foreseen.
    """

    kinds: KindsOfPairs
    chances: ChancesOfStates | None = None
    order: tuple[Symbol, ...] = ()


def with_pairs(
    problem: Problem, relations: RelationOperators | None, sight: PairSight | None = None
) -> Problem:
    """Return a problem that knows the kinds of all pairs of its objects, and what is foreseen of each.

    Args:
        problem: The problem; if it knows them already, it stays as it is.
        relations: What was learned of pairs; if nothing, the problem stays as it is.
        sight: What networks say of pairs. By default a pair is of the kind whose mean features are nearest,
            and nothing is foreseen that does not hold for the whole kind.

    Raises:
        InvalidValue: If the networks foresee other states than the domain has.
    """
    if relations is None or problem.pairs or not relations.pairs or len(problem.objects) < 2:
        return problem
    if sight is None:
        return msgspec.structs.replace(problem, pairs=kinds_of(problem, relations), foreseen={})
    rows = _features(problem)
    kinds = sight.kinds(rows)
    found, foreseen = dict(zip(_keys(problem), kinds, strict=True)), dict[str, dict[str, float]]()
    if sight.chances:
        chances = _foreseen(rows, kinds, relations, sight, sight.chances)
        foreseen = {pair: row for pair, row in zip(found, chances, strict=True) if row}
    return msgspec.structs.replace(problem, pairs=found, foreseen=foreseen)


def kinds_of(problem: Problem, relations: RelationOperators | None) -> Mapping[str, Symbol]:
    """Return the kinds of all pairs of a problem's objects, as it says itself, or else those nearest.

    Args:
        problem: The problem.
        relations: What was learned of pairs.
    """
    if relations is None or problem.pairs or not relations.pairs or len(problem.objects) < 2:
        return problem.pairs
    return dict(zip(_keys(problem), nearest_kinds(_features(problem), relations.pairs), strict=True))


def _keys(problem: Problem) -> list[str]:
    return [pair_key(*pair) for pair in permutations(problem.object_names, 2)]


def _features(problem: Problem) -> Float[np.ndarray, "N F"]:
    """Return the features of the target and then those of the reference, for each pair."""
    pairs = permutations(problem.objects, 2)
    return np.array([(*one.features, *other.features) for one, other in pairs])


def nearest_kinds(features: Float[np.ndarray, "N F"], kinds: Sequence[Category]) -> tuple[Symbol, ...]:
    """Return of which kind each pair is by its features alone: that whose mean is nearest.

    Args:
        features: Features of the targets, and then of the references.
        kinds: The kinds; those of which nothing was seen are left out.
    """
    known = [kind for kind in kinds if kind.feature_means]
    means = np.array([kind.feature_means for kind in known])  # (K, F)
    spread = np.maximum(means.std(0), _LEAST_SPREAD)
    away = np.linalg.norm((features[:, None] - means) / spread, axis=-1)  # (N, K)
    return tuple(known[int(nearest)].symbol for nearest in away.argmin(1))


def _foreseen(
    features: Float[np.ndarray, "N F"],
    kinds: Sequence[Symbol],
    relations: RelationOperators,
    sight: PairSight,
    chances: ChancesOfStates,
) -> list[dict[str, float]]:
    """Foresee for each pair how surely the operators for its kind keep their promises, by their names."""
    order = PairStates(relations.states, relations.scales).bearing_order
    if sight.order != order:
        raise InvalidValue(
            "The network that foresees states of pairs was trained on others than the domain has; valid: "
            "one of the same training: `neurosym distill` and `neurosym compile-domain`."
        )
    cases = [
        (row, operator, order.index(operator.promise.state))
        for row, kind in enumerate(kinds)
        for operator in (*relations.operators, *pooled(relations))
        if operator.is_for(kind) and operator.promise and operator.promise.state in order
    ]
    found: list[dict[str, float]] = [{} for _ in kinds]
    if not cases:
        return found
    actions = np.array([relations.primitive_of(operator).action for _, operator, _ in cases])
    predicted = chances(features[[row for row, *_ in cases]], actions)
    known = {(row, column): 0.0 for row, _, column in cases}
    faint: dict[tuple[int, int], list[tuple[float, str]]] = {case: [] for case in known}
    for (row, operator, column), of_states in zip(cases, predicted, strict=True):
        chance = float(of_states[column])
        share = chance if operator.pair else share_with_any(chance)
        if share is None:
            faint[row, column].append((chance, operator.name))
            continue
        found[row][operator.name] = round(share, _DIGITS)
        known[row, column] = max(known[row, column], share)
    for (row, column), left in faint.items():
        if known[row, column] < LEAST:
            surest = sorted(left, key=lambda one: (-one[0], one[1]))[:FAINTEST]
            found[row] |= {name: round(chance, _DIGITS) for chance, name in surest if chance >= FAINT}
    return found
