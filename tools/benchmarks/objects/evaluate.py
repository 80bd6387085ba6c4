"""How are objects handled that nothing was learned of, by their features, and by what they did?

`make evaluate-objects`, into docs/results/objects.*. Domains that one command learned with its defaults are
tried on shapes never seen and on look-alikes with hidden properties, after so many tries of each object: with
each task the domain of another seed. Goes on where it was interrupted.
"""

import math
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.commands.pipeline import run
from neurosym.evaluation.comparison import Bench, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.tries import alone, try_once
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, symbols_of
from neurosym.planners.planner import PlanStatus
from neurosym.problems import Problem, SceneObject
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING
from neurosym.stages.rounds import budget_of
from neurosym.tasks.pasts import GRASPED, LEAST_CHANCE, keeps, trial_of
from neurosym.tasks.promises import performed_with, promised
from neurosym.tasks.transition import primitives
from neurosym.world import relative_to
from tools.benchmarks import options
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Found, Jobs
from tools.benchmarks.objects import contact, parts, tasks
from tools.benchmarks.objects.summary import PARTS, page, summarise
from tools.benchmarks.planning.trials import PLANNER

TRIES = (0, 1, 3, 5)
FIRST = 945_000  # seed of the first task, far from those of other evaluations
TIME_LIMIT = 60.0  # of one plan [s]; far more than any takes
UNSEEN_TASKS = {"carry": 30, "push": 30, "stack": 10}
"""How many tasks there are with each shape."""
LOOKALIKES, PUSHED_TASKS, EDGE_OBJECTS, BLOCK = 120, 120, 20, 5
"""How many there are: look-alikes, pushed only, of each edge; tried at once."""
MOTIONS_AT_AN_EDGE = 6  # that are tried with each object
SEEDS = 5
"""So many domains are learned; a task is tried with the next one in turn."""
STACKING = options.ROOT / "domains" / "towers"
"""The shipped domain that knows pairs: objects are stacked with it."""


def main(
    scale: options.Scale = 1.0,
    first: int = FIRST,
    work: Path = Path("evaluation/objects"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Learn, try, and write what came of it."""
    evaluation = Evaluation("objects", work, results, workers)

    def report() -> None:
        summary = summarise(evaluation.found())
        evaluation.write(summary, page(summary))

    def learned_and_tried(some: Jobs, label: str) -> None:
        if some.keys() - evaluation.found().keys():
            evaluation.perform(learning(evaluation), "learning", report, fresh=True)
        evaluation.perform(some, label, report)

    learned_and_tried(jobs(work, scale, first), "objects")
    learned_and_tried(stopping(work), "stopping pushes on their way")
    learned_and_tried(in_part(work, scale, first, evaluation.found()), "pushing in part")
    evaluation.perform(contact.jobs(), "learning from contact and force", report)
    report()


def learning(evaluation: Evaluation) -> Jobs:
    """List the domains to be learned, by name; those whose folders are gone, as on another machine, too."""
    found = Jobs()
    for seed in range(1, SEEDS + 1):
        if not (evaluation.work / f"seed-{seed}" / GROUNDING).exists():
            evaluation.path(f"learn-{seed}").unlink(missing_ok=True)
        found[f"learn-{seed}"] = partial(learn, evaluation.work, seed)
    return found


def learn(work: Path, seed: int) -> dict[str, int]:
    """Learn a domain by one command with its defaults, and say what that took."""
    draft, folder = work / f"draft-{seed}", work / f"seed-{seed}"
    run(draft, seed=seed, workers=1, problems=0)
    draft.rename(folder)
    return {"interactions": budget_of(DomainFolder(folder)).total}


def jobs(work: Path, scale: float, first: int) -> Jobs:
    """List what is tried, by name."""
    found = Jobs()
    for block in _blocks(options.scaled(scale, LOOKALIKES), first):
        for kind in ("carry", "pushes"):
            found[f"look-{kind}-{block.start}"] = partial(try_lookalikes, work, kind, block)
    for block in _blocks(options.scaled(scale, PUSHED_TASKS), first):
        found[f"pushed-{block.start}"] = partial(try_pushed, work, block)
    for block in _blocks(options.scaled(scale, EDGE_OBJECTS), first):
        for feature in range(3):
            for is_high in (False, True):
                name = f"edge-{feature}-{'high' if is_high else 'low'}-{block.start}"
                found[name] = partial(try_edge, work, feature, is_high, block)
    for kind, count in UNSEEN_TASKS.items():
        for block in _blocks(options.scaled(scale, count), first):
            for shape in tasks.SHAPES:
                found[f"{kind}-{shape}-{block.start}"] = partial(try_unseen, work, kind, shape, block)
    return found


def stopping(work: Path) -> Jobs:
    """List the choices of pushes that stop on their way, by name."""
    return {f"{PARTS}{seed}": partial(parts.find, work / f"seed-{seed}") for seed in range(1, SEEDS + 1)}


def in_part(work: Path, scale: float, first: int, found: Found) -> Jobs:
    """List tries of pushing with pushes that stop on their way, by name."""
    more = {seed: found.get(f"{PARTS}{seed}", ()) for seed in range(1, SEEDS + 1)}
    blocks = _blocks(options.scaled(scale, PUSHED_TASKS), first)
    return {f"in-part-{block.start}": partial(try_pushed, work, block, more) for block in blocks}


def _blocks(count: int, first: int) -> list[range]:
    return [range(first + at, first + min(at + BLOCK, count)) for at in range(0, count, BLOCK)]


def seed_of(task: int) -> int:
    """Say with which seed the domain is learned that a task is tried with."""
    return 1 + task % SEEDS


def bench_for(work: Path, kind: str, task: int) -> tuple[Bench, DomainFolder, Grounding]:
    """Return the domain that a task of some kind is tried with; `pushes` are those of one without places."""
    folder = STACKING if kind == "stack" else work / f"seed-{seed_of(task)}"
    bench = bench_of(folder)
    learned = bench.setting.grounding
    if kind == "push":
        learned = tasks.pushing(learned)
    if kind == "pushes":
        learned = tasks.without_places(learned)
    return bench, DomainFolder(folder), learned


def drawn(work: Path, kind: str, of: str, seed: int) -> tuple[Bench, Problem, Grounding]:
    """Draw a task for an object of some kind."""
    bench, folder, grounding = bench_for(work, kind, seed)
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


def try_unseen(work: Path, kind: str, shape: str, seeds: Sequence[int]) -> list[Any]:
    """Try tasks with a shape never seen, after each number of tries: whether each was reached, replanned.

    Kept is how far it ended from its goal, too, if that is a point [m].
    """
    found = []
    for seed in seeds:
        bench, task, grounding = drawn(work, kind, shape, seed)
        solve = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT)
        runs = []
        for problem in met(bench, task, grounding):
            plan = solve(problem, grounding)
            steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
            run = execute(bench.setting.world, problem, grounding, steps, replanner=solve)
            told = {"reached": run.reached, "steps": len(run.steps), "ended": run.ended}
            told["away"] = run.distances.get(task.object_names[0])
            runs.append(told | {"reason": "" if steps else plan.reason})
        found.append(runs)
    return found


def try_lookalikes(work: Path, kind: str, seeds: Sequence[int]) -> list[Any]:
    """Plan for look-alikes after each number of tries, and perform the first motion.

    Kept is how far it ended from its promise [m], if it ended in that way, else None.
    """
    found = []
    for seed in seeds:
        bench, task, grounding = drawn(work, kind, tasks.LOOKALIKE, seed)
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


def try_pushed(
    work: Path, seeds: Sequence[int], more: Mapping[int, Sequence[Any]] | None = None
) -> list[Any]:
    """Try to bring objects that can be pushed only to points within 20 mm: whether, in how many motions.

    Pushes that stop on their way are added to the domain of each seed, as `parts.find` tells of them.
    """
    found = list[Any]()
    for seed in seeds:
        bench, _, learned = bench_for(work, "carry", seed)
        grounding = parts.with_parts(learned, (more or {}).get(seed_of(seed), ()))
        solve = planner_of(bench.setting, PLANNER, time_limit=TIME_LIMIT)
        problem = tasks.pushed_only(bench, seed)
        plan = solve(problem, grounding)
        steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
        run = execute(bench.setting.world, problem, grounding, steps, replanner=solve)
        told = {"reached": run.reached, "steps": len(run.steps), "ended": run.ended}
        found.append(told | {"primitives": primitives(steps), "reason": "" if steps else plan.reason})
    return found


def try_edge(work: Path, feature: int, is_high: bool, seeds: Sequence[int]) -> list[Any]:
    """Perform what plans may use, with objects at an edge: the chance that is said, and whether it came."""
    found = list[Any]()
    for seed in seeds:
        bench, _, grounding = bench_for(work, "carry", seed)
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
            outcome = bench.setting.world.interact(scene, action, 0, **relative_to(bench.setting.world, aim))
            trial = trial_of(outcome, operator, grounding.turned)
            grasps = promise.kind in GRASPED
            found.append([round(operator.chance, 4), keeps(promise, trial, TOLERANCE), grasps])
    return found


if __name__ == "__main__":
    options.begin(main)
