"""Choosing actions for kinds of pairs: of all symbols, those that most surely bring a kind into some state.

Candidates are shortlisted by what a network without a bottleneck predicts, and auditioned on pairs of the
kind, fewer of them in each round. What is left is the surest for each state that pairs can be brought
to. An action that does nothing to a kind has no operator there.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import islice, zip_longest

import numpy as np

from neurosym.actions import ActionBox
from neurosym.guarded import made
from neurosym.operators import Primitive
from neurosym.primitives.by_state import by_state, foresee_relating, foreseen_state
from neurosym.primitives.judging import Judging, Performance
from neurosym.primitives.own import Round, moved
from neurosym.primitives.performing import perform
from neurosym.primitives.repertoire import Repertoire, with_own
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.variety import PredictOutcomes
from neurosym.progress import Progress
from neurosym.relation_operators import PairStates
from neurosym.symbols import Categorise
from neurosym.world import Scene, WorldFactory
from neurosym.worlds.workers import Task

ROUNDS = Round(16, 4), Round(8, 4), Round(4, 8)
"""Auditions for a kind of pairs."""
OF_SYMBOL = 4
"""Candidates of one symbol that are shortlisted for a kind of pairs and a state at most."""
KEPT = 3
"""Actions that a kind of pairs has in the end at most."""
FORESEEN, SURE = 0.1, 0.3
"""Actions that are foreseen, or that turn out, to be less sure than this are left out."""
_STREAM = 0x7063  # keeps these draws apart from those of other auditions and rehearsals


@dataclass(slots=True, eq=False)
class _Contest:
    """The candidates for one kind of pairs.

    Attributes:
        scenes: A pair of the kind in each.
        left: Those that are left, the surest first.
        seen: How they turned out.
    """

    scenes: tuple[Scene, ...]
    left: list[Primitive]
    seen: dict[Primitive, list[Performance]] = field(default_factory=dict)


def choose_for_pairs(
    world_factory: WorldFactory,
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    categorise: Categorise,
    states: PairStates,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> Repertoire:
    """Choose for each kind of pairs the actions that most surely bring it into some state.

    Args:
        world_factory: Builds the world in which actions are aimed at other objects.
        candidates: Distilled actions.
        predict: A network that sees the pairs themselves and not their symbols.
        categorise: Gives the kinds of pairs of features.
        states: The states of pairs.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each performance.
    """
    world, judging = made(world_factory), by_state(states)
    least = sum(one.objects for one in ROUNDS)
    sample = sample_by_category(world, categorise, least=least, seed=seed, stream=_STREAM)
    contests = {
        kind: _Contest(scenes, _shortlist(candidates, predict, scenes, states, world.action_box, seed))
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
            seen.append(judging.watch(outcome))
            done += 1
            if progress is not None:
                progress(min(done, total), total)
        first += one.objects
        for contest in contests.values():
            contest.left = _ranked(contest, judging)
            if number + 1 < len(ROUNDS):
                contest.left = contest.left[: ROUNDS[number + 1].candidates]
    chosen = {kind: _surest_for_states(contest, judging) for kind, contest in contests.items()}
    return with_own(_one_each(candidates), chosen)


def _shortlist(
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    scenes: Sequence[Scene],
    states: PairStates,
    box: ActionBox,
    seed: int,
) -> list[Primitive]:
    """List candidates that are foreseen to bring a kind surely into a state, some for each state in turn."""
    features = np.concatenate([scene.features for scene in scenes])
    actions = np.concatenate([moved(one, len(features), box, seed) for one in candidates])
    predicted = np.split(predict(np.tile(features, (len(candidates), 1)), actions), len(candidates))
    sureness = [foresee_relating(rows).sureness for rows in predicted]
    taken, for_state = Counter[tuple[str, str]](), dict[str, list[Primitive]]()
    for number in np.argsort(-np.array(sureness), kind="stable"):
        one, state = candidates[number], foreseen_state(predicted[number], states)
        if state and sureness[number] >= FORESEEN and taken[one.symbol, state] < OF_SYMBOL:
            taken[one.symbol, state] += 1
            for_state.setdefault(state, []).append(one)
    in_turn = (one for row in zip_longest(*for_state.values()) for one in row if one is not None)
    return list(islice(in_turn, ROUNDS[0].candidates))


def _ranked(contest: _Contest, judging: Judging) -> list[Primitive]:
    return sorted(contest.left, key=lambda one: -judging.judge(contest.seen[one]).sureness)


def _surest_for_states(contest: _Contest, judging: Judging) -> list[Primitive]:
    """Keep the surest action, and others that are the surest for another state."""
    kept, reached = list[Primitive](), set[str]()
    for one in contest.left:
        ends = Counter(seen.state for seen in contest.seen[one] if seen.state)
        state = ends.most_common(1)[0][0] if ends else ""
        if state and state not in reached and judging.judge(contest.seen[one]).sureness >= SURE:
            reached.add(state)
            kept.append(one)
    return kept[:KEPT]


def _one_each(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return of each symbol the candidate that encodes to it best; it names the others of the symbol."""
    best: dict[str, Primitive] = {}
    for one in candidates:
        if one.symbol not in best or one.code_error < best[one.symbol].code_error:
            best[one.symbol] = one
    return [best[symbol] for symbol in sorted(best)]
