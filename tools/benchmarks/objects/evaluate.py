"""How are objects handled that nothing was learned of, by their features, and by what they did?

`make evaluate-objects`, into docs/results/objects.*. The shipped domains are tried on shapes never seen and
on look-alikes with hidden properties, after so many tries of each object. Goes on where it was interrupted.
"""

import math
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.evaluation.comparison import Bench, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.tries import alone, try_once
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, symbols_of
from neurosym.planners.planner import PlanStatus
from neurosym.problems import Problem, SceneObject
from neurosym.stages.folder import DomainFolder
from neurosym.tasks.pasts import GRASPED, LEAST_CHANCE, keeps, trial_of
from neurosym.tasks.promises import performed_with, promised
from neurosym.tasks.transition import primitives
from neurosym.world import relative_to
from tools.benchmarks import options
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs
from tools.benchmarks.objects import contact, parts, tasks
from tools.benchmarks.objects.summary import PARTS, added, page, summarise
from tools.benchmarks.planning.trials import PLANNER

TRIES = (0, 1, 3, 5)
FIRST = 945_000  # seed of the first task, far from those of other evaluations
TIME_LIMIT = 60.0  # of one plan [s]; far more than any takes
UNSEEN_TASKS, LOOKALIKES, PUSHED_TASKS, EDGE_OBJECTS, BLOCK = 10, 120, 60, 20, 5
"""How many there are: of each shape and kind, look-alikes, pushed only, of each edge; tried at once."""
MOTIONS_AT_AN_EDGE = 6  # that are tried with each object
DOMAINS = {"carry": "places", "push": "places", "stack": "towers", "pushes": "tabletop"}
"""The shipped domain that each kind of task is tried with; `pushes` are those of one that cannot carry."""


def main(
    scale: options.Scale = 1.0,
    first: int = FIRST,
    work: Path = Path("evaluation/objects"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Try, and write what came of it."""
    evaluation = Evaluation("objects", work, results, workers)

    def report() -> None:
        summary = summarise(evaluation.found())
        evaluation.write(summary, page(summary))

    evaluation.perform(jobs(scale, first), "objects", report)
    evaluation.perform(stopping(), "stopping pushes on their way", report)
    evaluation.perform(in_part(scale, first, added(evaluation.found())), "pushing in part", report)
    evaluation.perform(contact.jobs(), "learning from contact and force", report)
    report()


def jobs(scale: float, first: int) -> Jobs:
    """List what is tried, by name."""
    found = Jobs()
    for block in _blocks(options.scaled(scale, LOOKALIKES), first):
        for kind in ("carry", "pushes"):
            found[f"look-{kind}-{block.start}"] = partial(try_lookalikes, kind, block)
    for block in _blocks(options.scaled(scale, PUSHED_TASKS), first):
        found[f"pushed-{block.start}"] = partial(try_pushed, block)
    for block in _blocks(options.scaled(scale, EDGE_OBJECTS), first):
        for feature in range(3):
            for is_high in (False, True):
                name = f"edge-{feature}-{'high' if is_high else 'low'}-{block.start}"
                found[name] = partial(try_edge, feature, is_high, block)
    for block in _blocks(options.scaled(scale, UNSEEN_TASKS), first):
        for shape in tasks.SHAPES:
            for kind in ("carry", "push", "stack"):
                found[f"{kind}-{shape}-{block.start}"] = partial(try_unseen, kind, shape, block)
    return found


def stopping() -> Jobs:
    """List the choices of pushes that stop on their way, by name."""
    folder, (_, _, grounding) = _folder("carry"), bench_for("carry")
    symbols = [one.symbol for one in grounding.objects.categories if one.objects]
    return {f"{PARTS}{symbol}": partial(parts.find, folder, symbol) for symbol in symbols}


def in_part(scale: float, first: int, found: Sequence[Any]) -> Jobs:
    """List tries of pushing with pushes that stop on their way, by name."""
    blocks = _blocks(options.scaled(scale, PUSHED_TASKS), first)
    return {f"in-part-{block.start}": partial(try_pushed, block, found) for block in blocks}


def _folder(kind: str) -> Path:
    return options.ROOT / "domains" / DOMAINS[kind]


def _blocks(count: int, first: int) -> list[range]:
    return [range(first + at, first + min(at + BLOCK, count)) for at in range(0, count, BLOCK)]


def bench_for(kind: str) -> tuple[Bench, DomainFolder, Grounding]:
    """Return the domain that a kind of task is tried with."""
    folder = _folder(kind)
    bench = bench_of(folder)
    learned = bench.setting.grounding
    return bench, DomainFolder(folder), tasks.pushing(learned) if kind == "push" else learned


def drawn(kind: str, of: str, seed: int) -> tuple[Bench, Problem, Grounding]:
    """Draw a task for an object of some kind."""
    bench, folder, grounding = bench_for(kind)
    if kind == "stack":
        return bench, tasks.to_a_stack(bench, folder, of, seed), grounding
    most = tasks.NEAR if kind == "push" else math.inf
    return bench, tasks.to_a_point(bench, of, seed, most=most), grounding


def met(bench: Bench, problem: Problem, grounding: Grounding) -> list[Problem]:
    """Return a problem with nothing seen of its first object, and after each number of tries of it."""
    name, found = problem.object_names[0], [problem]
    scene, trials = alone(problem, name), ()
    for number in range(1, TRIES[-1] + 1):
        scene = msgspec.structs.replace(scene, objects=(_after(scene.objects[0], trials),))
        tried = try_once(bench.setting.world, scene, grounding)
        trials = (*trials, tried.trial) if tried else trials
        if number in TRIES:
            items = (_after(problem.objects[0], trials), *problem.objects[1:])
            found.append(msgspec.structs.replace(problem, objects=items))
    return found


def _after(item: SceneObject, trials: Sequence[Any]) -> SceneObject:
    return msgspec.structs.replace(item, past=tuple(trials))


def try_unseen(kind: str, shape: str, seeds: Sequence[int]) -> list[Any]:
    """Try tasks with a shape never seen, after each number of tries: whether each was reached, replanned."""
    found = []
    for seed in seeds:
        bench, task, grounding = drawn(kind, shape, seed)
        solve = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT)
        runs = []
        for problem in met(bench, task, grounding):
            plan = solve(problem, grounding)
            steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
            run = execute(bench.setting.world, problem, grounding, steps, replanner=solve)
            told = {"reached": run.reached, "steps": len(run.steps), "ended": run.ended}
            first = {"first": run.steps[0].as_promised} if run.steps else {}
            runs.append(told | first | {"reason": "" if steps else plan.reason})
        found.append(runs)
    return found


def try_lookalikes(kind: str, seeds: Sequence[int]) -> list[Any]:
    """Plan for look-alikes after each number of tries, and perform the first motion.

    Kept is how far it ended from its promise [m], if it ended in that way, else None.
    """
    found = []
    for seed in seeds:
        bench, task, grounding = drawn(kind, tasks.LOOKALIKE, seed)
        solve = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT)
        firsts: list[float | None] = []
        for problem in met(bench, task, grounding):
            plan = solve(problem, grounding)
            steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
            begun = steps[: 2 if len(steps) > 1 and steps[1].puts_down else 1]
            run = execute(bench.setting.world, problem, grounding, begun)
            first = run.steps[0] if run.steps else None
            firsts.append(first.apart if first and first.happened == first.promised else None)
        found.append(firsts)
    return found


def try_pushed(seeds: Sequence[int], added: Sequence[Any] = ()) -> list[Any]:
    """Try to bring objects that can be pushed only to points within 20 mm: whether, in how many motions.

    Pushes that stop on their way are added, as `parts.find` tells of them.
    """
    bench, _, learned = bench_for("carry")
    grounding = parts.with_parts(learned, added)
    solve, found = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT), list[Any]()
    for seed in seeds:
        problem = tasks.pushed_only(bench, seed)
        plan = solve(problem, grounding)
        steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
        run = execute(bench.setting.world, problem, grounding, steps, replanner=solve)
        told = {"reached": run.reached, "steps": len(run.steps), "ended": run.ended}
        found.append(told | {"primitives": primitives(steps), "reason": "" if steps else plan.reason})
    return found


def try_edge(feature: int, is_high: bool, seeds: Sequence[int]) -> list[Any]:
    """Perform what plans may use, with objects at an edge: the chance that is said, and whether it came."""
    bench, _, grounding = bench_for("carry")
    world, found = bench.setting.world, list[Any]()
    for seed in seeds:
        scene, rng = tasks.at_an_edge(feature, is_high, seed), np.random.default_rng(seed)
        features = tuple(scene.features[0].tolist())
        category = symbols_of(bench.categorise, scene.features)[0]
        item = SceneObject("item-01", category, features, tuple(scene.positions[0].tolist()))
        likely = [one for one in promised(grounding, item).values() if one.chance >= LEAST_CHANCE]
        likely = [one for one in likely if one.promise and grounding.why_left_out(one) is None]
        for index in rng.permutation(len(likely))[:MOTIONS_AT_AN_EDGE]:
            operator = likely[index]
            promise, aim = operator.promise, None
            assert promise is not None, "others were left out"
            if operator.frame == "place":
                spot = rng.uniform(*np.array([grounding.table.x, grounding.table.y]).T)
                aim = grounding.table.nearest(*(spot - promise.resting_effect[:2]))
            action = performed_with(grounding, operator, item)
            outcome = world.interact(scene, action, 0, **relative_to(world, aim))
            trial = trial_of(outcome, operator, grounding.turned)
            grasps = promise.kind in GRASPED
            found.append([round(operator.chance, 4), keeps(promise, trial, TOLERANCE), grasps])
    return found


if __name__ == "__main__":
    options.begin(main)
