"""What can be done with one object relative to another? `make evaluate-relations`, into docs/results/.

First by actions that a person wrote, and by random ones. Then for each seed what can be done with pairs is
learned, starting from what carries to places with that seed; it is judged by geometry, and tried on tasks
that a person can solve. Goes on where it was interrupted.
"""

import json
import shutil
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import msgspec
import tyro

from neurosym.files import make_folder, write_json
from neurosym.formats import PairFile
from neurosym.grounding import FORMAT_WITH_RELATIONS, Grounding
from neurosym.stages import layout
from neurosym.stages.learning import TO_OBJECTS
from tools.benchmarks import domains, options
from tools.benchmarks.carrying.evaluate import take_shipped
from tools.benchmarks.jobs import Evaluation, Jobs, machine
from tools.benchmarks.relations import by_hand, protocols, symbols, tasks
from tools.benchmarks.relations.summary import CURIOUS, RANDOM, SINGLY, Way, summarise
from tools.benchmarks.relations.tables import page
from tools.benchmarks.relations.trying import one_by_one, try_all
from tools.relearn_places import SEED
from tools.relearn_towers import FOLDER as SHIPPED
from tools.relearn_towers import RELATIONS as STEPS

DOMAINS, LEARNED = "relations-domains.zip", "places-domains.zip"
KEPT = (layout.RELATION_STATES, layout.RELATION_MODEL, layout.RELATION_CHANCES, layout.RELATION_OPERATORS)
"""What is needed of relations to try a domain; the rest is kept beside the results on places."""
FIRST_TASK = 740_000  # seed of the first task, far from those of other evaluations
NEW_PAIRS = 730_000
"""Added to the seed of a domain, so that it is judged on pairs that it was not learned with."""
BLOCK = 5  # tasks that are tried together
AT_RANDOM = 1  # seeds with which relations are learned from random actions, too
WORKERS = 2


def main(
    seeds: options.Seeds = 5,
    steps: Annotated[int, tyro.conf.arg(help="Interactions that are aimed at other objects.")] = STEPS,
    count: Annotated[int, tyro.conf.arg(help="Tasks of each kind and seed, a multiple of 5.")] = 10,
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/relations"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Measure, learn and try, and write the results; what was done is not done again."""
    own = tasks.cells(count)
    cells = (*own, *protocols.cells(count))
    evaluation = Evaluation("relations", work, results, workers)
    hand = _by_hand(evaluation, scale)
    make_folder(work / "places")
    domains.restore(results / LEARNED, work / "places")
    take_shipped(work / "places")
    domains.restore(results / DOMAINS, work, layout.RELATIONS)
    if steps == STEPS:
        _take_shipped_relations(work)

    def report() -> None:
        summary = summarise(hand, evaluation.found(), cells, seeds=seeds, steps=steps)
        evaluation.write(summary, page(summary))

    report()
    every, some = range(1, seeds + 1), range(1, min(seeds, AT_RANDOM) + 1)
    for seed in every:
        _joined(work, seed, CURIOUS)
    evaluation.perform(_learning(work, CURIOUS, every, steps), "learning relations", report)
    domains.keep(work, results / DOMAINS, _kept)
    evaluation.perform(_tried(evaluation, CURIOUS, every, cells), "trying tasks", report)
    singly = {
        f"{SINGLY}-{seed}-{name}": partial(one_by_one, CURIOUS.folder(work, seed), draw, numbers)
        for seed in every
        for name, draw, numbers in _blocks(seed, own)
    }
    evaluation.perform(singly, "trying with single objects", report)
    evaluation.perform(_learning(work, RANDOM, some, steps), "learning from random actions", report)
    evaluation.perform(_tried(evaluation, RANDOM, some, cells), "trying what was learned from these", report)


def _by_hand(evaluation: Evaluation, scale: float) -> dict[str, Any]:
    """Measure what needs no learning, over a share of the usual interactions, unless the results have it."""
    some = partial(options.scaled, scale)
    parts = {
        "put_over": partial(by_hand.put_over, some(50), 110, WORKERS),
        "towers_by_hand": partial(by_hand.towers, some(50), 111, WORKERS),
        "random": partial(by_hand.predictability, some(1000), 112, WORKERS),
    }
    path = evaluation.results / "relations.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    if known.get("scale") != scale or not parts.keys() <= known.keys():
        evaluation.perform({f"hand-{name}-{scale:g}": job for name, job in parts.items()}, "by hand")
        found = evaluation.found()
        known = {name: found[f"hand-{name}-{scale:g}"] for name in parts}
    about = {"command": "make evaluate-relations", "machine": machine("numpy", "pybullet"), "scale": scale}
    return about | {name: known[name] for name in parts}


def _learning(work: Path, way: Way, seeds: Iterable[int], steps: int) -> Jobs:
    return {f"learn-{way.label(seed)}": partial(learn, work, seed, steps, way) for seed in seeds}


def learn(work: Path, seed: int, steps: int, way: Way) -> dict[str, Any]:
    """Learn relations from the domain with places of a seed, unless that was done.

    Returns the measures of `symbols.measure` and `protocols.effect_errors`, and CPU seconds of each stage.
    """
    seconds, folder = {}, way.folder(work, seed)
    if not _joined(work, seed, way):
        seconds = domains.learn(folder, way.strategy, seed, steps, TO_OBJECTS)
        _joined(work, seed, way)
    measured = symbols.measure(folder, NEW_PAIRS + seed, workers=1)
    errors = protocols.effect_errors(folder, NEW_PAIRS + seed, workers=1)
    return {**measured, "effect_errors": errors, "cpu_seconds": seconds}


def _joined(work: Path, seed: int, way: Way) -> bool:
    """Put into a folder the domain with places of a seed, and join the relations, if they were learned."""
    places, folder = work / "places" / f"seed-{seed}", way.folder(work, seed)
    grounding = Grounding.load(places / layout.GROUNDING)
    make_folder(folder / layout.PLACES)
    for name in (layout.WORLD, layout.MODEL):
        shutil.copy(places / name, folder / name)
    write_json(folder / layout.PLACE_OPERATORS, grounding.places)
    if learned := (folder / layout.RELATION_OPERATORS).exists():
        relations = PairFile.load(folder / layout.RELATION_OPERATORS).table()
        joined = msgspec.structs.replace(grounding, relations=relations, format=FORMAT_WITH_RELATIONS)
        joined.save(folder / layout.GROUNDING)
    return learned


def _tried(evaluation: Evaluation, way: Way, seeds: Iterable[int], cells: Sequence[tasks.Cell]) -> Jobs:
    """List the tasks of those seeds with which something was learned, some at a time."""
    known, work = evaluation.found(), evaluation.work
    return {
        f"try-{way.label(seed)}-{name}": partial(try_all, way.folder(work, seed), words, draw, numbers)
        for seed in seeds
        if (words := known.get(f"learn-{way.label(seed)}", {}).get("words")) is not None
        for name, draw, numbers in _blocks(seed, cells)
    }


def _blocks(seed: int, cells: Sequence[tasks.Cell]) -> Iterator[tuple[str, tasks.Draw, range]]:
    """List what is tried together with the domain of a seed: name, what draws it, and seeds."""
    for name, draw, count in cells:
        for start in range(0, count, BLOCK):
            first = FIRST_TASK + 1000 * seed + start
            yield f"{tasks.slug(name)}-{start}", draw, range(first, first + BLOCK)


def _kept(folder: Path) -> Iterator[str]:
    """List what is kept of a domain that was learned, and is not the shipped one."""
    is_own = folder.name != f"seed-{SEED}" or not SHIPPED.exists()
    yield from KEPT if is_own and (folder / layout.RELATION_OPERATORS).exists() else ()


def _take_shipped_relations(work: Path) -> None:
    """Copy what the shipped domain, which is that of its seed, learned of relations, unless it is there."""
    for name in KEPT if SHIPPED.exists() else ():
        target = work / f"seed-{SEED}" / name
        if not target.exists():
            make_folder(target.parent)
            shutil.copy(SHIPPED / name, target)


if __name__ == "__main__":
    options.begin(main)
