"""How often does it come true what is foreseen of operators for pairs of any kind? Prints Markdown.

New pairs of which one fits into the other, as a person would say, are put into one another by what is
foreseen most surely, though it was chosen for pairs of another kind; and by an action that a person wrote.
This is where the numbers in `neurosym/pair_operators.py` come from. The tasks of the evaluation are not used.
"""

from itertools import pairwise
from pathlib import Path
from typing import Annotated

import numpy as np
import tyro

from neurosym.evaluation.summary import markdown_table
from neurosym.pair_operators import RelationOperators, pooled
from neurosym.primitives.reliability import end_state
from neurosym.stages.console import say
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import RELATION_OPERATORS, WORLD
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.worlds.aims import REFERENCE, TARGET, RelatedFactory, RelatedScene
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.carrying.tasks import is_graspable
from tools.benchmarks.relations.geometry import fits
from tools.benchmarks.world.hand_written import carry_to
from tools.relearn_towers import FOLDER as SHIPPED
from tools.relearn_towers import state_called

LIMITS = (0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0)
"""Pairs are told apart by what is foreseen, from one of these to the next."""
SEED = 960_000
DRAWN = 20_000


def main(
    folder: Annotated[Path, tyro.conf.arg(help="A domain with relations.")] = SHIPPED,
    state: Annotated[str, tyro.conf.arg(help="How the name of the state begins that is sought.")] = "sits-in",
    pairs: Annotated[int, tyro.conf.arg(help="How many pairs there are at most in each row.")] = 40,
    workers: Annotated[int, tyro.conf.arg(help="How many processes.")] = 2,
) -> None:
    """Try, and print the table."""
    domain = DomainFolder(folder)
    table, sight = RelationOperators.load(folder / RELATION_OPERATORS), sight_of_pairs(domain)
    assert sight is not None, "relations were learned"
    assert sight.chances is not None, "learned with the kinds"
    sought = table.state_named(state_called(state, domain)).symbol
    column, states = sight.order.index(sought), table
    factory = RelatedFactory(read_world(folder / WORLD))
    scenes = _fitting(factory)
    features = np.concatenate([scene.features for scene in scenes])
    known = [one for one in pooled(table) if one.promise and one.promise.state == sought]
    actions = [np.array(table.primitive_of(one).action) for one in known]
    foreseen = np.array(
        [sight.chances(features, np.tile(one, (len(features), 1)))[:, column] for one in actions]
    )
    best = foreseen.max(0)
    rows = []
    for low, high in pairwise(LIMITS):
        here = np.flatnonzero((best >= low) & (best < high))[:pairs]
        by_hand = [Task(scenes[row], np.array(carry_to(scenes[row].whole.features[TARGET]))) for row in here]
        learned = [Task(scenes[row], actions[foreseen[:, row].argmax()]) for row in here]
        put = [end_state(one, states) == sought for one in perform_all(factory, by_hand + learned, workers)]
        hand, own = sum(put[: len(here)]), sum(put[len(here) :])
        share = f"{best[here].mean():.2f}" if len(here) else "-"
        rows.append([f"{low:g} to {high:g}", str(len(here)), share, str(hand), str(own)])
    say(markdown_table(["foreseen", "pairs", "in the mean", "by hand", "by what is foreseen"], rows))


def _fitting(factory: RelatedFactory) -> list[RelatedScene]:
    """Draw pairs of which the target can be grasped and fits into the reference."""
    world, rng = factory(), np.random.default_rng(SEED)
    drawn = [world.sample_scene(rng, 1) for _ in range(DRAWN)]
    pairs = [(scene, scene.whole.features[TARGET], scene.whole.features[REFERENCE]) for scene in drawn]
    return [scene for scene, target, other in pairs if is_graspable(target) and fits(target, other)]


if __name__ == "__main__":
    tyro.cli(main)
