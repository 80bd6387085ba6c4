"""How often operators keep their promises with fresh objects, beside the chance said; and then once more.

`python -m tools.benchmarks.planning.chances domains/tabletop` performs every operator of a domain on fresh
objects of its category, and once more on each object that it left upright, from where that lies then. It
prints the two tables.
"""

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import numpy as np
import tyro

from neurosym.grounding import Grounding, is_lift
from neurosym.learning.network import EffectModel
from neurosym.operators import TOLERANCE, Operator
from neurosym.primitives.sampling import perform, sample_by_category
from neurosym.problems import SceneObject
from neurosym.stages.console import progress_bar, say
from neurosym.stages.layout import GROUNDING, MODEL, WORLD
from neurosym.tasks.promises import promised
from neurosym.world import Outcome, Scene
from neurosym.worlds.workers import Task
from neurosym.worlds.world_file import read_world
from tools.benchmarks.options import Workers
from tools.benchmarks.tables import table

EDGES = (0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0)
"""What is said is counted between these."""
UNSURE = (0.1, 0.9)
"""Where it is said to be unsure whether a promise is kept, trying again is of interest."""
_STREAM = 0x6368  # keeps these objects apart from all others
Pair = tuple[Operator, Scene]


def main(
    folder: tyro.conf.Positional[Path],
    *,
    objects: Annotated[int, tyro.conf.arg(help="Objects of each category.")] = 40,
    seed: Annotated[int, tyro.conf.arg(help="Where all draws start.")] = 7,
    workers: Workers = 2,
) -> None:
    """Perform, count, print."""
    factory, grounding = read_world(folder / WORLD), Grounding.load(folder / GROUNDING)
    categorise = EffectModel.load(folder / MODEL).object_symbols
    sample = sample_by_category(factory(), categorise, least=objects, seed=seed, stream=_STREAM)
    actions = {one.label: np.array(one.action) for one in grounding.operators.primitives}

    def performed(pairs: Sequence[Pair], label: str) -> tuple[list[Outcome], np.ndarray, np.ndarray]:
        """Return outcomes, the chance that was said of each, and whether the promise was kept."""
        with progress_bar(label) as advance:
            tasks = [Task(scene, actions[operator.label]) for operator, scene in pairs]
            outcomes = list(perform(factory, tasks, workers, advance))
        judged = [_judged(grounding, *pair, outcome) for pair, outcome in zip(pairs, outcomes, strict=True)]
        said, kept = np.array(judged, dtype=float).reshape(-1, 2).T
        return outcomes, said, kept

    pairs = [
        (operator, scene)
        for operator in grounding.live
        for scene in sample.scenes.get(operator.category, ())[:objects]
    ]
    first, said, kept = performed(pairs, "performing")
    again = [
        number
        for number, outcome in enumerate(first)
        if outcome.kind in ("resting", "held") and UNSURE[0] <= said[number] <= UNSURE[1]
    ]
    _, _, kept_again = performed([(pairs[n][0], first[n].end) for n in again], "performing again")
    base = np.array([grounding.operator_named(operator.name).chance for operator, _ in pairs])
    scores = [f"{((chances - kept) ** 2).mean():.4f}" for chances in (said, base)]
    say(
        f"{len(pairs)} performances; Brier score {scores[0]}, of the operators' mean chances {scores[1]}\n\n"
        f"{_said_and_kept(said, kept)}\n\n{_tried_again(said[again], kept[again], kept_again)}"
    )


def _judged(grounding: Grounding, operator: Operator, scene: Scene, outcome: Outcome) -> tuple[float, bool]:
    """Return the chance that an operator said to have with an object, and whether it did as promised."""
    features = tuple(scene.features[0].tolist())
    x, y, z = scene.positions[0].tolist()
    promise = promised(grounding, SceneObject("item", operator.category, features, (x, y, z)))[operator.name]
    assert promise.promise is not None, "it is live"
    seen = outcome.effect if is_lift(promise) else outcome.resting_effect
    near = np.linalg.norm(np.subtract(promise.promise.outcome, seen)) <= TOLERANCE
    return promise.chance, outcome.kind == promise.promise.kind and bool(near)


def _said_and_kept(said: np.ndarray, kept: np.ndarray) -> str:
    """Write how often promises were kept, by what was said."""
    rows = [
        [
            f"{low:.0%} to {high:.0%}",
            str(inside.sum()),
            f"{said[inside].mean():.0%}",
            f"{kept[inside].mean():.0%}",
        ]
        for low, high in pairwise(EDGES)
        if (inside := (said >= low) & (said < high)).any()
    ]
    return table(["chance said", "performances", "mean", "kept"], rows)


def _tried_again(said: np.ndarray, first: np.ndarray, second: np.ndarray) -> str:
    """Write how often a promise is kept the second time, by how it went the first."""
    rows = [
        [name, str(chosen.sum()), f"{said[chosen].mean():.0%}", f"{second[chosen].mean():.0%}"]
        for name, chosen in (("kept", first == 1), ("not kept", first == 0))
        if chosen.any()
    ]
    return table(["first time", "objects", "chance said before", "kept the second time"], rows)


if __name__ == "__main__":
    tyro.cli(main)
