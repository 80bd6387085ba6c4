"""Choosing actions for kinds of pairs: for each state, a few that together bring as many pairs there as can.

No action does the same to all pairs of a kind. A network foresees what each candidate does to each pair. The
candidate that brings most pairs into a state comes first, then the one that adds most to it, while that is
worth it: kinds that are met often get more actions than rare ones. For each of these there is a contest on
the pairs that it adds. Candidates are listed by what is foreseen of them, and auditioned on them, fewer
of them in each round; what was foreseen counts beside what was seen. The surest is left. Where nothing brings
a kind into a state, there is no operator.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.operators import Primitive
from neurosym.primitives.judging import sureness, watch
from neurosym.primitives.own import Contest, Round, audition_in_rounds, moved
from neurosym.primitives.repertoire import Repertoire, with_own
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.search import Search
from neurosym.relation_operators import PairStates
from neurosym.symbols import Symbol
from neurosym.world import Scene

ROUNDS = Round(4, 4), Round(2, 6)
"""Auditions of one contest."""
OF_A_KIND = 64
"""Pairs of a kind that are looked at, to find which can be brought into a state, and by what."""
WORTH = 0.002
"""An action beyond the first for a kind and a state adds this share or more of all pairs, of whatever kind,
that can be brought there."""
OF_SYMBOL = 4
"""Candidates of one symbol that are shortlisted for a kind of pairs and a state at most."""
LEAST = 0.1
"""Actions that are foreseen, or that turn out, to bring about a state less surely are left out for it."""
FORESEEN_COUNTS = 10
"""What is foreseen of an action counts as much as so many performances: few tell little of rare outcomes."""
_STREAM = 0x7063  # keeps these draws apart from those of other auditions and rehearsals


@dataclass(slots=True, eq=False)
class _OfState(Contest):
    """The candidates for some pairs of one kind, and one state.

    Attributes:
        state: Code of the state.
        foreseen: How surely each candidate brings these pairs into the state, as foreseen.
        few: Those that are left, the surest first.
    """

    state: str
    foreseen: dict[Primitive, float]
    few: list[Primitive]

    def left(self) -> list[Primitive]:
        return self.few

    def most_left(self, candidates: int) -> int:
        return min(candidates, len(self.few))

    def close_round(self, kept: int) -> None:
        sure = {one: self._sureness(one) for one in self.few}
        ranked = sorted((one for one in self.few if sure[one] >= LEAST), key=lambda one: -sure[one])
        self.few = ranked[:kept]

    def won(self) -> list[Primitive]:
        """Return those that are left and that were seen to do it."""
        return [one for one in self.few if sureness(self.seen[one], self.state) > 0]

    def _sureness(self, one: Primitive) -> float:
        seen = self.seen[one]
        weighed = len(seen) * sureness(seen, self.state) + FORESEEN_COUNTS * self.foreseen[one]
        return weighed / (len(seen) + FORESEEN_COUNTS)


def choose_for_pairs(search: Search, states: PairStates) -> Repertoire:
    """Choose for each kind of pairs the actions that most surely bring it into each state.

    States in which targets lean are left out.

    Args:
        search: What there is to choose from; the chances of the states that bear are predicted, in their
            order.
        states: The states of pairs.
    """
    world = made(search.shown)
    sample = sample_by_category(world, search.categorise, least=OF_A_KIND, seed=search.seed, stream=_STREAM)
    foreseen = {kind: _foreseen(search, scenes, world.action_box) for kind, scenes in sample.scenes.items()}
    contests: dict[Symbol, list[_OfState]] = {kind: [] for kind in foreseen}
    for state in sorted(states.straight):
        column = states.bearing_order.index(state)
        of_state = {kind: chances[:, :, column] for kind, chances in foreseen.items()}
        reach = sum(sample.shares[kind] * chances.max(0).mean() for kind, chances in of_state.items())
        for kind, chances in of_state.items():
            worth = float(WORTH * reach / sample.shares[kind])
            contests[kind] += _contests(search.candidates, chances, sample.scenes[kind], state, worth)
    every = [contest for of_kind in contests.values() for contest in of_kind]
    with search.open_bar("auditioning for each kind of pairs") as advance:
        audition_in_rounds(search, every, ROUNDS, search.shown, partial(watch, states=states), advance)
    chosen = {
        kind: list(dict.fromkeys(one for contest in of_kind for one in contest.won()))
        for kind, of_kind in contests.items()
    }
    return with_own(_one_each(search.candidates), chosen)


def _foreseen(search: Search, scenes: Sequence[Scene], box: ActionBox) -> Float[np.ndarray, "C N S"]:
    """Foresee what each candidate does to each pair."""
    features = np.concatenate([scene.features for scene in scenes])
    actions = np.concatenate([moved(one, len(features), box, search.seed) for one in search.candidates])
    foreseen = np.clip(search.predict(np.tile(features, (len(search.candidates), 1)), actions), 0.0, 1.0)
    return foreseen.reshape(len(search.candidates), len(features), -1)


def _contests(
    candidates: Sequence[Primitive],
    chances: Float[np.ndarray, "C N"],
    scenes: Sequence[Scene],
    state: str,
    worth: float,
) -> list[_OfState]:
    """Begin contests for a kind and a state: on those pairs first of which most can be brought there.

    A further action adds so much to the mean chance, at least, that it is worth it.
    """
    begun, known = list[_OfState](), np.zeros(len(scenes))
    while True:
        gains = np.maximum(chances - known, 0.0)
        best = int(gains.mean(1).argmax())
        if begun and gains[best].mean() <= worth:
            return begun
        pairs = np.sort(np.argsort(-gains[best], kind="stable")[: sum(one.objects for one in ROUNDS)])
        mean = chances[:, pairs].mean(1)
        likely = [number for number in np.argsort(-mean, kind="stable") if mean[number] >= LEAST]
        few = _few_of_a_symbol([candidates[number] for number in likely])[: ROUNDS[0].candidates]
        of_pairs = {one: float(sure) for one, sure in zip(candidates, mean, strict=True) if one in few}
        begun.append(_OfState(tuple(scenes[row] for row in pairs), state, of_pairs, few))
        known = np.maximum(known, chances[best])


def _few_of_a_symbol(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return the first candidates of each symbol, in the same order."""
    taken = Counter[str]()
    few = []
    for one in candidates:
        taken[one.symbol] += 1
        if taken[one.symbol] <= OF_SYMBOL:
            few.append(one)
    return few


def _one_each(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return of each symbol the candidate that encodes to it best; it names the others of the symbol."""
    best: dict[str, Primitive] = {}
    for one in candidates:
        if one.symbol not in best or one.code_error < best[one.symbol].code_error:
            best[one.symbol] = one
    return [best[symbol] for symbol in sorted(best)]
