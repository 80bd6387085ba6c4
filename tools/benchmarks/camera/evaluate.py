"""What is lost where objects are seen, not known? `make evaluate-camera`, into docs/results/camera.*.

The same is learned from true features and from what a camera sees, and tried on the same kinds of tasks.
"""

import shutil
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import msgspec
import numpy as np

from neurosym.commands.pipeline import run
from neurosym.evaluation.comparison import Bench, planner_of
from neurosym.execution.executor import execute
from neurosym.files import read_json
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import TOLERANCE, symbols_of
from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.sim.camera_world import CameraWorld
from neurosym.sim.shapes import FEATURE_NAMES
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.rounds import budget_of
from neurosym.world import Scene
from tools.benchmarks import options
from tools.benchmarks.camera import seeing, towers
from tools.benchmarks.camera.summary import page, summarise
from tools.benchmarks.carrying.tasks import is_graspable
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs, cpu_seconds
from tools.benchmarks.objects.tasks import LOOKALIKE, SHAPES, to_a_point
from tools.benchmarks.planning import measures
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.trials import PLANNER, tried

FIRST_TASK = 840_000  # seed of the first task, far from those of other evaluations
FIRST_SHAPE = 848_000
WORLDS = {"features": "tabletop", "images": "camera"}
CELLS = {"single": (1, 100), "far-1": (1, 20), "far-4": (4, 20)}
"""What is tried: objects of a task, and how many tasks for each seed."""
TOWERS = 40
"""So many towers are tried."""
KEPT = (layout.WORLD, layout.EYE, layout.MODEL, layout.TRAINING, layout.GROUNDING, layout.BUDGET)
NOISY = "noisy"
TRUE = len(FEATURE_NAMES)
"""So many of the numbers that only the simulator knows of an object are its true features."""
_BLOCK = 10


def main(
    seeds: options.Seeds = 5,
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/camera"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """See, learn, try, and write what came of it."""
    evaluation = Evaluation("camera", work, results, workers)

    def report() -> None:
        summary = summarise(evaluation.found())
        evaluation.write(summary, page(summary))

    looks: Jobs = {f"seen-{name}": partial(seeing.errors, name) for name in seeing.CAMERAS}
    evaluation.perform(looks, "looking", report)
    if not (work / "crops.npz").exists():
        evaluation.path("crops").unlink(missing_ok=True)
    evaluation.perform({"crops": partial(seeing.draw_crops, work)}, "looking at what was explored")
    same: Jobs = {f"same-{seed}": partial(seeing.compare, work, seed) for seed in range(1, seeds + 1)}
    evaluation.perform(same, "training on the same interactions", report, fresh=True)
    related: Jobs = {f"relate-{kind}-1": partial(relate, work, kind, 1) for kind in WORLDS}
    for seed in range(1, seeds + 1):
        both = (work / f"{kind}-{seed}" for kind in WORLDS)
        trying: Jobs = {f"agree-{seed}": partial(seeing.agree, *both)}
        for kind in (*WORLDS, NOISY):
            for cell, (objects, count) in CELLS.items():
                if kind != NOISY or cell == "single":
                    for block in blocks(options.scaled(scale, count), _BLOCK):
                        name = f"try-{kind}-{seed}-{cell}-{block.start}"
                        trying[name] = partial(attempt, work, kind, seed, cell, objects, block)
        asked = {*trying, *(related if seed == 1 else ())}
        for kind in WORLDS:  # what is gone, as on another machine, is learned anew if it is asked for
            if asked - evaluation.found().keys() and not (work / f"{kind}-run-{seed}").exists():
                evaluation.path(f"learn-{kind}-{seed}").unlink(missing_ok=True)
        learning: Jobs = {f"learn-{kind}-{seed}": partial(learn, work, kind, seed) for kind in WORLDS}
        evaluation.perform(learning, f"learning with seed {seed}", report, fresh=True)
        evaluation.perform(trying, f"tasks with seed {seed}", report)
    evaluation.perform(related, "learning relations", report, fresh=True)
    building, known = Jobs(), evaluation.found()
    for kind in WORLDS:
        if told := known.get(f"relate-{kind}-1"):
            for block in blocks(options.scaled(scale, TOWERS), _BLOCK):
                seeds = range(towers.FIRST_TOWER + block.start, towers.FIRST_TOWER + block.stop)
                folder, words = work / f"{kind}-related-1", told["words"]
                building[f"tower-{kind}-1-{block.start}"] = partial(towers.build, folder, words, seeds)
    evaluation.perform(building, "towers", report)
    unseen: Jobs = {
        f"shape-{kind}-{shape}": partial(carry, work, kind, shape, range(FIRST_SHAPE, FIRST_SHAPE + count))
        for kind in WORLDS
        for shape, count in {**dict.fromkeys(SHAPES, 10), LOOKALIKE: 20}.items()
    }
    evaluation.perform(unseen, "shapes never seen", report)
    report()


def learn(work: Path, kind: str, seed: int) -> dict[str, Any]:
    """Learn a domain by one command, and keep what it takes to try it; say what that took."""
    begin, folder, copy = cpu_seconds(), work / f"{kind}-run-{seed}", work / f"{kind}-{seed}"
    run(folder, world=WORLDS[kind], seed=seed, workers=1, problems=0)
    cpu, domain = cpu_seconds() - begin, DomainFolder(folder)
    for name in (*KEPT, layout.PLACE_OPERATORS):
        if (folder / name).exists():
            (copy / name).parent.mkdir(exist_ok=True, parents=True)
            shutil.copy(folder / name, copy / name)
    if kind == "images":
        noisy = work / f"{NOISY}-{seed}"
        shutil.copytree(copy, noisy, dirs_exist_ok=True)
        text = (copy / layout.WORLD).read_text()
        for name in ("depth_step", "dropout", "offset"):
            text = text.replace(f"{name} = 0.0", f"{name} = {getattr(seeing.NOISE, name)}")
        (noisy / layout.WORLD).write_text(text)
    report = read_json(folder / layout.TRAINING, TrainingReport)
    return {
        "cpu": cpu,
        "interactions": budget_of(domain).total,
        "kinds": measures.kinds(folder) or [],
        "r2": report.r2_through_codes,
        "direct_r2": report.r2_direct,
    }


def relate(work: Path, kind: str, seed: int) -> dict[str, Any]:
    """Learn relations beside what was learned (see `towers.relate`)."""
    return towers.relate(work / f"{kind}-run-{seed}", work / f"{kind}-related-{seed}", seed)


def attempt(work: Path, kind: str, seed: int, cell: str, objects: int, block: Sequence[int]) -> list[Any]:
    """Try tasks, blindly and with replanning."""
    bench, first = bench_of(work / f"{kind}-{seed}"), FIRST_TASK + 1000 * seed
    drawn = (draw(bench, cell, objects, first + number) for number in block)
    return tried(bench.setting, drawn, time_limit=measures.TIME_LIMIT)


def carry(work: Path, kind: str, shape: str, seeds: Sequence[int]) -> list[bool]:
    """Carry objects of a shape that nothing was learned of to points: whether each came there, replanned."""
    known, bench = bench_of(work / "features-1"), bench_of(work / f"{kind}-1")
    world, found = bench.setting.world, list[bool]()
    solve = planner_of(bench.setting, PLANNER, time_limit=measures.TIME_LIMIT)
    for seed in seeds:
        problem = to_a_point(known, shape, seed)
        if isinstance(world, CameraWorld):
            problem = as_seen(problem, world, bench)
        plan = solve(problem, bench.setting.grounding)
        steps = plan.steps if plan.status is PlanStatus.SOLVED else ()
        run = execute(world, problem, bench.setting.grounding, steps, replanner=solve)
        found.append(run.reached)
    return found


def as_seen(problem: Problem, world: CameraWorld, bench: Bench) -> Problem:
    """Return a problem of one object as a camera sees it."""
    scene = world.seen(problem.scene())
    assert scene is not None, "one object is told apart from none"
    (item,), (goal,) = problem.objects, problem.goals.values()
    seen = msgspec.structs.replace(
        item,
        category=symbols_of(bench.categorise, scene.features)[0],
        features=tuple(scene.features[0].tolist()),
        position=tuple(scene.positions[0].tolist()),
        orientation=tuple(scene.orientations[0].tolist()),
        unseen=tuple(scene.unseen[0].tolist()),
    )
    return msgspec.structs.replace(problem, objects=(seen,), goals={item.name: (*goal[:2], seen.position[2])})


def draw(bench: Bench, cell: str, objects: int, seed: int) -> Problem:
    """Draw a task; objects with goals anywhere are such that a person finds a grasp for."""
    if cell == "single":
        return bench.draw(objects, seed, TOLERANCE)
    world, known = bench.setting.world, dict[bytes, np.ndarray]()
    drawn = world.sample_scene

    def remembered(rng: np.random.Generator, objects: int) -> Scene:
        scene = drawn(rng, objects)
        truth = scene.unseen[:, :TRUE] if isinstance(world, CameraWorld) else scene.features
        known.update(zip(map(np.ndarray.tobytes, scene.features), truth, strict=True))
        return scene

    with patch.object(world, "sample_scene", remembered):
        return bench.draw(
            objects, seed, TOLERANCE, "anywhere", lambda features: is_graspable(known[features.tobytes()])
        )


if __name__ == "__main__":
    options.begin(main)
