"""Choosing actions for kinds of pairs: of all symbols, those that most surely bring a kind into some state.

Candidates are shortlisted by the chances of each state that a network foresees for pairs of the kind, and
auditioned on these pairs, fewer of them in each round. What is left is the surest for each state that pairs
can be brought to. An action that does nothing to a kind has no operator there.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import zip_longest

import numpy as np

from neurosym.actions import ActionBox
from neurosym.guarded import made
from neurosym.operators import Primitive
from neurosym.primitives.by_state import straight_states, sureness, watch
from neurosym.primitives.judging import Performance
from neurosym.primitives.own import Round, moved
from neurosym.primitives.performing import perform
from neurosym.primitives.repertoire import Repertoire, with_own
from neurosym.primitives.sampling import sample_by_category
from neurosym.progress import Progress
from neurosym.related import ChancesOfStates
from neurosym.relation_operators import PairStates
from neurosym.symbols import Categorise
from neurosym.world import Scene, WorldFactory
from neurosym.worlds.workers import Task

ROUNDS = Round(18, 4), Round(9, 4), Round(6, 8)
"""Auditions for a kind of pairs."""
OF_SYMBOL = 4
"""Candidates of one symbol that are shortlisted for a kind of pairs and a state at most."""
KEPT = 3
"""Actions that a kind of pairs has in the end at most."""
FORESEEN, SURE = 0.05, 0.1
"""Actions that are foreseen, or that turn out, to bring about a state less surely are left out for it."""
_STREAM = 0x7063  # keeps these draws apart from those of other auditions and rehearsals


@dataclass(slots=True, eq=False)
class _Contest:
    """The candidates for one kind of pairs.

    Attributes:
        scenes: A pair of the kind in each.
        left: Those that are left, the surest for each state in turn.
        seen: How they turned out.
    """

    scenes: tuple[Scene, ...]
    left: list[Primitive]
    seen: dict[Primitive, list[Performance]] = field(default_factory=dict)


def choose_for_pairs(
    world_factory: WorldFactory,
    candidates: Sequence[Primitive],
    foresee: ChancesOfStates,
    categorise: Categorise,
    states: PairStates,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> Repertoire:
    """Choose for each kind of pairs the actions that most surely bring it into each state.

    States in which targets are turned over are left out.

    Args:
        world_factory: Builds the world in which actions are aimed at other objects.
        candidates: Distilled actions.
        foresee: Foresees the chances of the states that bear, in their order.
        categorise: Gives the kinds of pairs of features.
        states: The states of pairs.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each performance.
    """
    world, wanted = made(world_factory), straight_states(states)
    columns = [states.bearing_order.index(state) for state in wanted]
    least = sum(one.objects for one in ROUNDS)
    sample = sample_by_category(world, categorise, least=least, seed=seed, stream=_STREAM)
    contests = {
        kind: _Contest(scenes, _shortlist(candidates, foresee, columns, scenes, world.action_box, seed))
        for kind, scenes in sample.scenes.items()
    }
    total = sum(
        min(one.candidates, len(contest.left)) * one.objects
        for contest in contests.values()
        for one in ROUNDS
    )
    done, first = 0, 0
    for number, one in enumerate(ROUNDS):
        tasks, owners = list[Task](), list[list[Performance]]()
        for contest in contests.values():
            scenes = contest.scenes[first : first + one.objects]
            for primitive in contest.left[: one.candidates]:
                actions = moved(primitive, first + len(scenes), world.action_box, seed)[first:]
                for scene, action in zip(scenes, actions, strict=True):
                    tasks.append(Task(scene, action))
                    owners.append(contest.seen.setdefault(primitive, []))
        performed = perform(world_factory, tasks, workers, None)
        for seen, outcome in zip(owners, performed, strict=True):
            seen.append(watch(outcome, states))
            done += 1
            if progress is not None:
                progress(min(done, total), total)
        first += one.objects
        for contest in contests.values():
            contest.left = _in_turn([_surest_first(contest, state) for state in wanted])
            if number + 1 < len(ROUNDS):
                contest.left = contest.left[: ROUNDS[number + 1].candidates]
    if progress is not None and total:
        progress(total, total)
    chosen = {
        kind: _in_turn([_surest_first(contest, state)[:1] for state in wanted])[:KEPT]
        for kind, contest in contests.items()
    }
    return with_own(_one_each(candidates), chosen)


def _shortlist(
    candidates: Sequence[Primitive],
    foresee: ChancesOfStates,
    columns: Sequence[int],
    scenes: Sequence[Scene],
    box: ActionBox,
    seed: int,
) -> list[Primitive]:
    """List candidates that are foreseen to bring a kind surely into a state, some for each state in turn."""
    features = np.concatenate([scene.features for scene in scenes])
    actions = np.concatenate([moved(one, len(features), box, seed) for one in candidates])
    foreseen = foresee(np.tile(features, (len(candidates), 1)), actions)
    chances = foreseen.reshape(len(candidates), len(features), -1).mean(1)  # (C, S)
    listed = []
    for column in chances[:, columns].T:
        likely = [number for number in np.argsort(-column, kind="stable") if column[number] >= FORESEEN]
        listed.append(_few_of_a_symbol([candidates[number] for number in likely]))
    return _in_turn(listed)[: ROUNDS[0].candidates]


def _few_of_a_symbol(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return the first candidates of each symbol, in the same order."""
    taken = Counter[str]()
    few = []
    for one in candidates:
        taken[one.symbol] += 1
        if taken[one.symbol] <= OF_SYMBOL:
            few.append(one)
    return few


def _surest_first(contest: _Contest, state: str) -> list[Primitive]:
    """Sort those that bring pairs into a state by how surely they do."""
    found = [(sureness(contest.seen[one], state), one) for one in contest.left]
    ranked = sorted(found, key=lambda row: -row[0])
    return [one for sure, one in ranked if sure >= SURE]


def _in_turn(listed: Sequence[Sequence[Primitive]]) -> list[Primitive]:
    """Return the first of each list, then the second of each, and so on, each action once."""
    rows = zip_longest(*listed)
    return list(dict.fromkeys(one for row in rows for one in row if one is not None))


def _one_each(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return of each symbol the candidate that encodes to it best; it names the others of the symbol."""
    best: dict[str, Primitive] = {}
    for one in candidates:
        if one.symbol not in best or one.code_error < best[one.symbol].code_error:
            best[one.symbol] = one
    return [best[symbol] for symbol in sorted(best)]
