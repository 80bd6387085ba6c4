"""How the objects of a problem stand to one another: states of pairs, what bears what, and goals by relation.

A state of a pair is what the learned encoder says of its description. Which object bears another one is what
plans are made with: of several that seem to, it is the one whose pair is most typical of its state.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Category
from neurosym.pair_states import describe_pair, extent
from neurosym.problems import Problem
from neurosym.relation_goals import RelationGoal, pair_key
from neurosym.relation_operators import PairState, PairStates, RelationOperator, RelationOperators
from neurosym.symbols import Symbol
from neurosym.world import Scene

Contacts = tuple[tuple[int, int], ...]
KindsOfPairs = Callable[[Float[np.ndarray, "N F"]], tuple[Symbol, ...]]
"""Gives the kinds of pairs, from the features of the target and then those of the reference."""
ChancesOfStates = Callable[[Float[np.ndarray, "N F"], Float[np.ndarray, "N A"]], Float[np.ndarray, "N S"]]
"""Foresees the chances of the states that bear, in the order of their codes, from features of pairs and
actions."""
TOUCHING = 0.002
"""Objects whose boxes are no farther apart than this are taken to touch, where nobody saw it [m]."""
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


@dataclass(frozen=True, slots=True)
class Borne:
    """What bears an object.

    Attributes:
        by: Name of the object that bears it.
        state: The state of the two.
    """

    by: str
    state: PairState


def contacts_of(scene: Scene) -> Contacts:
    """Tell from geometry which objects touch: those whose boxes along the axes meet or overlap.

    Args:
        scene: The objects, at rest.
    """
    halves = [extent(scene, index) / 2 for index in range(len(scene))]
    found = []
    for one, other in combinations(range(len(scene)), 2):
        away = np.abs(scene.positions[one] - scene.positions[other])
        if np.all(away <= halves[one] + halves[other] + TOUCHING):
            found.append((one, other))
    return tuple(found)


def touching(problem: Problem) -> Contacts:
    """Return which objects of a problem touch, as somebody saw it or else by geometry.

    Args:
        problem: The problem.
    """
    if not isinstance(problem.touching, tuple):
        return contacts_of(problem.scene())
    index = {name: number for number, name in enumerate(problem.object_names)}
    pairs = [sorted((index[one], index[other])) for one, other in problem.touching]
    return tuple((one, other) for one, other in pairs)


def with_contacts(problem: Problem, contacts: Contacts) -> Problem:
    """Return a problem that says which of its objects touch.

    Args:
        problem: The problem.
        contacts: Pairs of indices.
    """
    names = problem.object_names
    return msgspec.structs.replace(
        problem, touching=tuple((names[one], names[other]) for one, other in contacts)
    )


def misfit(description: Sequence[float], state: PairState, relations: RelationOperators) -> float:
    """Return how far a description is from what is typical of a state, in its scales.

    Args:
        description: How a target stands to a reference.
        state: The state.
        relations: What was learned of pairs.
    """
    rows = zip(description, state.centre, relations.scales, strict=True)
    return math.hypot(*((one - centre) / scale for one, centre, scale in rows))


def states_of(problem: Problem, relations: RelationOperators) -> dict[tuple[str, str], PairState]:
    """Return the state of each pair of objects, by the names of target and reference.

    Args:
        problem: The problem, with the objects as they stand now.
        relations: What was learned of pairs.
    """
    return {names: state for names, (state, _) in _seen(problem, relations).items()}


def bearers_of(problem: Problem, relations: RelationOperators) -> dict[str, Borne]:
    """Return what bears each object that another one bears.

    Args:
        problem: The problem, with the objects as they stand now.
        relations: What was learned of pairs.
    """
    known = _known_ends(relations)
    kinds = problem.pairs if isinstance(problem.pairs, dict) else {}
    bearing = [
        ((kinds.get(pair_key(*names), ""), state.symbol) not in known, off, names, state)
        for names, (state, off) in _seen(problem, relations).items()
        if state.bears
    ]
    found = dict[str, Borne]()
    for *_, (target, reference), state in sorted(bearing, key=lambda row: row[:3]):
        if target not in found and target not in chain_below(reference, found):
            found[target] = Borne(reference, state)
    return {name: found[name] for name in problem.object_names if name in found}


def known_bearers(problem: Problem, relations: RelationOperators) -> dict[str, Borne]:
    """Return what bears each object as far as some operator leads to that.

    Args:
        problem: The problem, with the objects as they stand now.
        relations: What was learned of pairs.
    """
    problem, known = with_pairs(problem, relations), _known_ends(relations)
    kinds = problem.pairs if isinstance(problem.pairs, dict) else {}
    return {
        name: borne
        for name, borne in bearers_of(problem, relations).items()
        if (kinds.get(pair_key(name, borne.by), ""), borne.state.symbol) in known
    }


def _known_ends(relations: RelationOperators) -> set[tuple[Symbol, Symbol]]:
    """List the kinds of pairs and the states that some operator was seen to bring them to."""
    return {(one.pair, end.state) for one in relations.operators for end in one.ends}


def chain_below(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name an object and what bears it, down to what stands on the table.

    Args:
        name: The object.
        bearers: What bears each object that another one bears; in no circle.
    """
    chain = [name]
    while chain[-1] in bearers:
        chain.append(bearers[chain[-1]].by)
    return tuple(chain)


def loads_of(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name what stands on or in an object itself.

    Args:
        name: The object.
        bearers: What bears each object that another one bears.
    """
    return tuple(target for target, borne in bearers.items() if borne.by == name)


def carried_along(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name all that an object takes along where it is carried.

    Args:
        name: The object.
        bearers: What bears each object that another one bears.
    """
    return tuple(one for one in bearers if one != name and name in chain_below(one, bearers))


def unmet_relations(problem: Problem, grounding: Grounding) -> tuple[RelationGoal, ...]:
    """List the goals by relation that do not hold as the objects stand now.

    Where a goal is that an object bears another one, it must be that one itself that bears it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    if not problem.related:
        return ()
    relations = relations_of(grounding, problem)
    problem = with_pairs(problem, relations)
    states, bearers = states_of(problem, relations), bearers_of(problem, relations)

    def holds(target: str, reference: str, state: str) -> bool:
        asked = relations.state_named(state)
        if asked.bears:
            return bearers.get(target) == Borne(reference, asked)
        return states[target, reference] == asked

    return tuple(goal for goal in problem.related if not holds(*goal))


def is_reached(problem: Problem, grounding: Grounding) -> bool:
    """Say whether all goals are met as the objects stand now.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    return problem.is_met(problem.scene().positions) and not unmet_relations(problem, grounding)


def relations_of(grounding: Grounding, problem: Problem) -> RelationOperators:
    """Return what a domain knows of relations.

    Args:
        grounding: The learned domain.
        problem: The problem that needs it.

    Raises:
        InvalidValue: If it knows nothing of them.
    """
    if grounding.relations is None:
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, and the domain {grounding.name} has learned "
            "none; valid: a problem with goals on the table, or a domain with relations."
        )
    return grounding.relations


def is_relational(problem: Problem, grounding: Grounding) -> bool:
    """Say whether a problem is one of relations: it asks for some, or begins with some.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    return bool(problem.related) or bool(grounding.relations and bearers_of(problem, grounding.relations))


def relating(name: str, grounding: Grounding) -> RelationOperator | None:
    """Return what puts objects in relations to one another by that name, or None if there is none.

    Args:
        name: Name of an operator.
        grounding: The learned domain.
    """
    table = grounding.relations.operators if grounding.relations else ()
    return next((one for one in table if one.name == name), None)


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
    if relations is None or problem.pairs is not msgspec.UNSET or not relations.pairs:
        return problem
    pairs = [*permutations(problem.objects, 2)]
    if not pairs:
        return msgspec.structs.replace(problem, pairs={}, foreseen=msgspec.UNSET)
    names = [(one.name, other.name) for one, other in pairs]
    rows = np.array([(*one.features, *other.features) for one, other in pairs])
    kinds = sight.kinds(rows) if sight else nearest_kinds(rows, relations.pairs)
    found = {pair_key(*pair): kind for pair, kind in zip(names, kinds, strict=True)}
    if sight is None or sight.chances is None:
        return msgspec.structs.replace(problem, pairs=found, foreseen=msgspec.UNSET)
    chances = _foreseen(rows, kinds, relations, sight, sight.chances)
    foreseen = {pair_key(*pair): row for pair, row in zip(names, chances, strict=True) if row}
    return msgspec.structs.replace(problem, pairs=found, foreseen=foreseen)


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
        for operator in relations.operators
        if operator.pair == kind and operator.promise and operator.promise.state in order
    ]
    found: list[dict[str, float]] = [{} for _ in kinds]
    if not cases:
        return found
    actions = np.array([relations.primitive_of(operator).action for _, operator, _ in cases])
    predicted = chances(features[[row for row, *_ in cases]], actions)
    for (row, operator, column), of_states in zip(cases, predicted, strict=True):
        found[row][operator.name] = round(float(of_states[column]), _DIGITS)
    return found


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


def _seen(problem: Problem, relations: RelationOperators) -> dict[tuple[str, str], tuple[PairState, float]]:
    """Return the state of each pair, and how far it is from what is typical of that."""
    scene, contacts, names = problem.scene(), touching(problem), problem.object_names
    found = {}
    for target, reference in permutations(range(len(scene)), 2):
        described = tuple(describe_pair(scene, target, reference, contacts).tolist())
        state = relations.state_of(described)
        found[names[target], names[reference]] = state, misfit(described, state, relations)
    return found
