"""How the objects of a problem stand to one another: states of pairs, what bears what, and goals by relation.

A state of a pair is what the learned encoder says of its description. Which object bears another one is what
plans are made with: of several that seem to, it is the one whose pair is most typical of its state.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidValue
from neurosym.operators import Category, Symbol, labelled
from neurosym.pair_operators import (
    FAINT,
    FAINTEST,
    LEAST,
    PairState,
    RelationOperators,
    describe_pair,
    extent,
    shares_foreseen,
    tilt,
)
from neurosym.problems import Problem, pair_key
from neurosym.world import Scene

# What is said of pairs before anything is done: their kinds, and how surely operators will keep promises.
#
# Networks say it where there are some. Without one, a pair is of the kind whose mean features are nearest.

KindsOfPairs = Callable[[Float[np.ndarray, "N F"]], tuple[Symbol, ...]]
"""Gives the kinds of pairs, from the features of the target and then those of the reference."""
ChancesOfStates = Callable[[Float[np.ndarray, "N F"], Float[np.ndarray, "N A"]], Float[np.ndarray, "N S"]]
"""Foresees the chances of the states that bear, in the order of their codes, from features of pairs and
actions."""
_LEAST_SPREAD = 1e-3
_DIGITS = 3


@dataclass(frozen=True, slots=True)
class PairSight:
    """What learned networks say of pairs of objects."""

    kinds: KindsOfPairs  # gives their kinds
    # foresees the states that actions bring them to; None where that was not learned
    chances: ChancesOfStates | None = None
    order: tuple[Symbol, ...] = ()  # codes of the states, in the order in which they are foreseen


def with_pairs(
    problem: Problem, relations: RelationOperators | None, sight: PairSight | None = None
) -> Problem:
    """Return a problem that knows the kinds of all pairs of its objects, and what is foreseen of each.

    If it knows them already, or nothing was learned of pairs, it stays as it is. Where no networks say so, a
    pair is of the kind whose mean features are nearest, and nothing is foreseen that does not hold for the
    whole kind. Networks that foresee other states than the domain has are refused.
    """
    rows = _features(problem, relations)
    if relations is None or not rows:
        return problem
    if sight is None:
        return msgspec.structs.replace(problem, pairs=dict(kinds_of(problem, relations)), foreseen={})
    features = np.array([*rows.values()])
    kinds = sight.kinds(features)
    chances = _foreseen(features, kinds, relations, sight) if sight.chances else [{} for _ in rows]
    foreseen = {pair: row for pair, row in zip(rows, chances, strict=True) if row}
    return msgspec.structs.replace(problem, pairs=dict(zip(rows, kinds, strict=True)), foreseen=foreseen)


def kinds_of(problem: Problem, relations: RelationOperators | None) -> Mapping[str, Symbol]:
    """Return the kinds of all pairs of a problem's objects, as it says itself, or else those nearest."""
    rows = _features(problem, relations)
    if relations is None or not rows:
        return problem.pairs
    nearest = nearest_kinds(np.array([*rows.values()]), relations.pairs)
    return dict(zip(rows, nearest, strict=True))


def _features(problem: Problem, relations: RelationOperators | None) -> dict[str, tuple[float, ...]]:
    """Return the features of targets and then of references, for all pairs whose kinds are still to tell."""
    if problem.pairs or relations is None or not relations.pairs:
        return {}
    pairs = permutations(problem.objects, 2)
    return {pair_key(one.name, other.name): (*one.features, *other.features) for one, other in pairs}


def nearest_kinds(features: Float[np.ndarray, "N F"], kinds: Sequence[Category]) -> tuple[Symbol, ...]:
    """Return of which kind pairs are by their features, target first: that whose mean is nearest."""
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
) -> list[dict[str, float]]:
    """Foresee for each pair how surely the operators for its kind keep their promises, by their names."""
    order = relations.bearing
    if sight.order != order:
        raise InvalidValue(
            "The network that foresees states of pairs was trained on others than the domain has; valid: "
            "one of the same training: `neurosym distill` and `neurosym compile-domain`."
        )
    cases = [
        (row, operator, order.index(operator.promise.kind))
        for row, kind in enumerate(kinds)
        for operator in relations.every_operator
        if operator.is_for(kind) and operator.promise and operator.promise.kind in order
    ]
    found: list[dict[str, float]] = [{} for _ in kinds]
    if not cases or not sight.chances:
        return found
    actions = np.array([labelled(relations.primitives, operator.label).action for _, operator, _ in cases])
    predicted = sight.chances(features[[row for row, *_ in cases]], actions)
    known = {(row, column): 0.0 for row, _, column in cases}
    faint: dict[tuple[int, int], list[tuple[float, str]]] = {case: [] for case in known}
    for (row, operator, column), rare, often in zip(
        cases, predicted, shares_foreseen(predicted), strict=True
    ):
        share = float((often if operator.subject else rare)[column])
        if not operator.subject and share < LEAST:
            faint[row, column].append((share, operator.name))
            continue
        found[row][operator.name] = round(share, _DIGITS)
        known[row, column] = max(known[row, column], share)
    for (row, column), left in faint.items():
        if known[row, column] < LEAST:
            surest = sorted(left, key=lambda one: (-one[0], one[1]))[:FAINTEST]
            found[row] |= {name: round(chance, _DIGITS) for chance, name in surest if chance >= FAINT}
    return found


Contacts = tuple[tuple[int, int], ...]
_LEVEL = 0.1  # what is tilted by less stands on a side, and does not lean [rad]
_TOUCHING = 0.002  # objects whose boxes are no farther apart are taken to touch, where nobody saw it [m]


@dataclass(frozen=True, slots=True)
class Borne:
    """What bears an object."""

    by: str  # name of the object that bears it
    state: PairState  # the state of the two


def contacts_of(scene: Scene) -> Contacts:
    """Tell from geometry which objects at rest touch: those whose boxes along the axes meet or overlap."""
    near = np.asarray(np.all(_gaps(scene) <= _TOUCHING, axis=-1))
    return tuple((one, other) for one, other in combinations(range(len(scene)), 2) if near[one, other])


def _gaps(scene: Scene) -> Float[np.ndarray, "M M 3"]:
    """Return how far the boxes of two objects are apart along each axis, negative if they overlap [m]."""
    halves = np.array([extent(scene, index) / 2 for index in range(len(scene))])
    return np.asarray(np.abs(scene.positions[:, None] - scene.positions) - (halves[:, None] + halves))


def touching(problem: Problem) -> Contacts:
    """Return which objects of a problem touch, as somebody saw it or else by geometry."""
    if problem.touching is None:
        return contacts_of(problem.scene())
    index = {name: number for number, name in enumerate(problem.object_names)}
    pairs = [sorted((index[one], index[other])) for one, other in problem.touching]
    return tuple((one, other) for one, other in pairs)


def with_contacts(problem: Problem, contacts: Contacts) -> Problem:
    """Return a problem that says which of its objects touch, by pairs of their indices."""
    names = problem.object_names
    touched = tuple((names[one], names[other]) for one, other in contacts)
    return msgspec.structs.replace(problem, touching=touched)


Seen = Mapping[tuple[str, str], tuple[PairState, float]]
"""The state of each pair, by its names, and how far it is from what is typical of that."""


def seen_states(problem: Problem, relations: RelationOperators) -> Seen:
    """Return the states of all pairs of a problem's objects as they stand now, and how typical they are."""
    scene, contacts, names = problem.scene(), touching(problem), problem.object_names
    found = {}
    for target, reference in permutations(range(len(scene)), 2):
        described = tuple(describe_pair(scene, target, reference, contacts).tolist())
        state = relations.of(described)
        found[names[target], names[reference]] = state, relations.misfit(described, state)
    return found


def bearers_of(
    problem: Problem,
    relations: RelationOperators,
    kinds: Mapping[str, Symbol] | None = None,
    seen: Seen | None = None,
) -> dict[str, Borne]:
    """Return what bears each object that another one bears.

    Of two objects that look as if each bore the other, as a box and the ring around it do, the one bears that
    the goals say bears. What lies on the table beside another object is not borne by it, however alike that
    looks to the encoder. Nor is what reaches lower than the other: there it is the other that is borne, as a
    low thing in a deep box is. Kinds and states of the pairs are worked out if they are not given.
    """
    known, beside = _known_ends(relations), _beside(problem)
    kinds = kinds_of(problem, relations) if kinds is None else kinds
    asked = {(target, reference) for target, reference, _ in problem.relations}
    every = (seen_states(problem, relations) if seen is None else seen).items()
    bears = {names: (state, off) for names, (state, off) in every if state.bears and names not in beside}
    for names in _lower(problem) & bears.keys():
        del bears[names]
        bears.setdefault(names[::-1], _as_borne(problem, relations, *names[::-1]))
    bearing = [
        ((kinds.get(pair_key(*names), ""), state.symbol) not in known, off, names, state)
        for names, (state, off) in bears.items()
        if names in asked or not (names[::-1] in asked and names[::-1] in bears)
    ]
    found = dict[str, Borne]()
    for *_, (target, reference), state in sorted(bearing, key=lambda row: row[:3]):
        if target not in found and target not in chain_below(reference, found):
            found[target] = Borne(reference, state)
    return {name: found[name] for name in problem.object_names if name in found}


def _beside(problem: Problem) -> set[tuple[str, str]]:
    """List targets that lie on the table, each with the references that it does not overlap from above."""
    scene, names = problem.scene(), problem.object_names
    heights = np.array([extent(scene, index)[2] / 2 for index in range(len(scene))])
    lies = scene.positions[:, 2] - heights < _TOUCHING
    apart = (_gaps(scene)[..., :2] > 0).any(-1)
    return {(names[one], names[other]) for one, other in np.argwhere(lies[:, None] & apart)}


def _lower(problem: Problem) -> set[tuple[str, str]]:
    """List targets that lie level, each with the references that do not reach as far down."""
    scene, names = problem.scene(), problem.object_names
    rows = range(len(scene))
    lowest = scene.positions[:, 2] - np.array([extent(scene, index)[2] / 2 for index in rows])
    is_level = np.array([tilt(scene, index) < _LEVEL for index in rows])
    lower = is_level[:, None] & (lowest[:, None] < lowest - _TOUCHING)
    return {(names[one], names[other]) for one, other in np.argwhere(lower)}


def _as_borne(
    problem: Problem, relations: RelationOperators, target: str, reference: str
) -> tuple[PairState, float]:
    """Return the state that is most like that of a pair of those in which something is borne."""
    names = problem.object_names
    pair = names.index(target), names.index(reference)
    described = tuple(describe_pair(problem.scene(), *pair, touching(problem)).tolist())
    off = {state.symbol: relations.misfit(described, state) for state in relations.states if state.bears}
    nearest = min(off, key=lambda symbol: off[symbol])
    return next(state for state in relations.states if state.symbol == nearest), off[nearest]


def known_bearers(problem: Problem, relations: RelationOperators) -> dict[str, Borne]:
    """Return what bears each object as far as some operator leads to that; see `bearers_of`."""
    kinds, known = kinds_of(problem, relations), _known_ends(relations)
    return {
        name: borne
        for name, borne in bearers_of(problem, relations, kinds).items()
        if (kinds.get(pair_key(name, borne.by), ""), borne.state.symbol) in known
    }


def _known_ends(relations: RelationOperators) -> set[tuple[Symbol, Symbol]]:
    """List the kinds of pairs and the states that some operator was seen to bring them to."""
    return {(one.subject, end.kind) for one in relations.operators for end in one.outcomes}


def chain_below(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name an object and what bears it, down to what stands on the table; nothing bears itself."""
    chain = [name]
    while chain[-1] in bearers:
        chain.append(bearers[chain[-1]].by)
    return tuple(chain)


def loads_of(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name what stands on or in an object itself."""
    return tuple(target for target, borne in bearers.items() if borne.by == name)


def carried_along(name: str, bearers: Mapping[str, Borne]) -> tuple[str, ...]:
    """Name all that an object takes along where it is carried."""
    return tuple(one for one in bearers if one != name and name in chain_below(one, bearers))
