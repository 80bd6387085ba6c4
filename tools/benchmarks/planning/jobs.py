"""Which jobs `evaluate.py` does, in which order; each has a name that says what it depends on."""

import hashlib
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Literal, NamedTuple

from neurosym.planners import PLANNERS
from neurosym.stages.layout import GROUNDING, MODEL, WORLD
from tools.benchmarks.jobs import Job
from tools.benchmarks.planning import measures
from tools.benchmarks.planning.tasks import DIFFICULTIES

SHIPPED = Path("domains/tabletop")
Strategy = Literal["curiosity", "random", "active", "entropy"]
STRATEGIES: dict[Strategy, str] = {
    "curiosity": "disagreement",
    "random": "random",
    "active": "active",
    "entropy": "entropy",
}
"""What Table III compares, and what `neurosym explore` calls it; entropy is the paper's own curiosity."""
USUAL: tuple[Strategy, ...] = ("curiosity", "random", "active")
"""Who is compared unless asked otherwise."""
BLOCK = 10
"""Tasks in one job."""
SIZES = {"single": 1, "double": 2}
COMPARED = ("bfs", measures.PLANNER)
TOLERANCES = (0.05, 0.02)
SYMBOLIC_OBJECTS, SCALING_OBJECTS, FAR_OBJECTS = (1, 2, 4), (1, 2, 4, 8, 16), (1, 2, 4)
_SCALING_SEEDS = 10_000
CONTENDERS: dict[str, tuple[str, dict[str, Any]]] = {
    "BFS over operators, 3 deep": ("bfs", {}),
    "SAS+, object by object": ("fast-downward", {}),
    "SAS+, object by object, no costs": ("fast-downward", {"costs": False}),
    "SAS+, whole, no costs": ("fast-downward", {"whole": True, "costs": False}),
    "page, object by object, no costs": ("fast-downward", {"encoding": "strips", "costs": False}),
    "page, whole, no costs": ("fast-downward", {"encoding": "strips", "whole": True, "costs": False}),
    "numeric with Kairos, object by object, no costs": ("kairos", {"encoding": "numeric", "costs": False}),
    "numeric with Kairos, whole, no costs": (
        "kairos",
        {"encoding": "numeric", "whole": True, "costs": False},
    ),
    "numeric with ENHSP, object by object, no costs": ("enhsp", {"encoding": "numeric", "costs": False}),
    "counting": ("counting", {}),
}
"""Who is tried at scale: the planner, and what it is asked for; without costs, all operators cost alike."""

Turn = tuple[str, dict[str, Job]]
"""What jobs are about, and the jobs by name."""


class Size(NamedTuple):
    """How much is measured.

    Attributes:
        seeds: Seeds of Table III.
        steps: Interactions of each exploration.
        tasks: Drawn tasks of each size.
        symbolic: Symbolic tasks of each size and difficulty.
        scaling: Tasks in each cell of the scaling table.
        disturbed: Disturbed runs of each size.
        strategies: Whom Table III compares.
        precise: Tasks of each size that are tried in the shipped domain, blindly and with replanning.
        far: Tasks with goals anywhere, with one, two and four objects.
    """

    seeds: int
    steps: int
    tasks: int
    symbolic: int
    scaling: int
    disturbed: int
    strategies: tuple[Strategy, ...]
    precise: int
    far: tuple[int, ...]


def size_of(
    seeds: int,
    steps: int,
    tasks: int | None = None,
    *,
    precise: int | None = None,
    far: tuple[int, ...] | None = None,
    strategies: tuple[Strategy, ...] = USUAL,
) -> Size:
    """Say how much is measured: all of it, or the short form of a single seed."""
    if seeds == 1:
        return Size(seeds, steps, tasks or 30, 30, 2, 20, strategies, precise or 30, far or (10, 5, 5))
    return Size(seeds, steps, tasks or 100, 150, 5, 100, strategies, precise or 400, far or (200, 100, 100))


def jobs_in_turn(work: Path, size: Size, *, learn: bool) -> Iterator[Turn]:
    """List the jobs, what is most asked for first; later jobs read what earlier ones wrote."""
    yield "drawing tasks", drawing_jobs(size)
    yield "shipped domain", table3_jobs(work, size, "shipped", 0.05)
    yield "disturbed runs", disturbed_jobs(work, size)
    yield "without costs", costless_jobs(work, size)
    for seed in range(1, size.seeds + 1):
        yield from seed_turns(work, size, seed, 0.05, learn=learn)
    yield "symbolic tasks", symbolic_jobs(size)
    yield "drawing scaling tasks", scaling_tasks(size)
    yield "scaling", scaling_jobs(work, size)
    yield "shipped domain, 20 mm", table3_jobs(work, size, "shipped", 0.02)
    yield from seed_turns(work, size, 1, 0.02, learn=False)
    yield "timings", timing_jobs(work)


def seed_turns(work: Path, size: Size, seed: int, tolerance: float, *, learn: bool) -> Iterator[Turn]:
    """List the jobs of one seed of Table III: learning, and then its tasks."""
    names = {domain_name(strategy, seed): STRATEGIES[strategy] for strategy in size.strategies}
    jobs: dict[str, Job] = {}
    for name in names:
        jobs |= table3_jobs(work, size, name, tolerance)
    if learn and not all((work / "jobs" / f"{job}.json").exists() for job in jobs):
        learning: dict[str, Job] = {
            f"learn-{name}-{size.steps}": partial(
                measures.learn, folder_of(work, name), strategy, seed, size.steps
            )
            for name, strategy in names.items()
        }
        yield f"learning, seed {seed}", learning
        for name in names:
            jobs |= table3_jobs(work, size, name, tolerance)
        jobs = {name: job for name, job in jobs.items() if "-none-" not in name}
    yield f"seed {seed}, {1000 * tolerance:g} mm", jobs


def domain_name(strategy: Strategy, seed: int) -> str:
    """Name the domain that a strategy leads to."""
    return f"{STRATEGIES[strategy]}-{seed}"


def folder_of(work: Path, name: str) -> Path:
    """Say where a domain lies."""
    return SHIPPED if name == "shipped" else work / "domains" / name


def stamp(folder: Path) -> str:
    """Tell a domain from others in the same place; one that is not compiled yet has none."""
    files = [folder / name for name in (WORLD, MODEL, GROUNDING)]
    if not all(path.is_file() for path in files):
        return "none"
    return hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:8]


def known_stamp(work: Path, name: str) -> str:
    """Tell a domain from others, by its records if it is not there any more."""
    known = stamp(folder_of(work, name))
    if known == "none":
        found = (work / "jobs").glob(f"table3-{name}-*-*mm-*.json")
        known = next(iter(sorted({path.stem.split("-")[-5] for path in found})), known)
    return known


def blocks(tasks: int, block: int = BLOCK) -> list[range]:
    """Cut the seeds 0, 1, ... of so many tasks into blocks."""
    return [range(first, min(first + block, tasks)) for first in range(0, tasks, block)]


def drawing_jobs(size: Size) -> dict[str, Job]:
    """List the jobs that draw the tasks as the paper does, the same for every domain."""
    return {
        _drawn(objects, block): partial(measures.draw, SHIPPED, objects, block)
        for tasks in (size.tasks, size.precise, min(size.disturbed, size.tasks))
        for objects in SIZES.values()
        for block in blocks(tasks)
    }


def table3_jobs(work: Path, size: Size, name: str, tolerance: float) -> dict[str, Job]:
    """List the jobs that compare planners in one domain; none if it is not there yet."""
    folder = folder_of(work, name)
    measure = partial(measures.judge, folder, tolerance=tolerance, planners=COMPARED)
    prefix = table3_prefix(work, name, tolerance)
    return on_drawn(work, prefix, size.tasks, measure)


def table3_prefix(work: Path, name: str, tolerance: float) -> str:
    """Begin the names of the jobs that compare planners in one domain."""
    millimetres = f"{1000 * tolerance:g}mm"
    return f"table3-{name}-{known_stamp(work, name)}-{millimetres}"


def disturbed_jobs(work: Path, size: Size) -> dict[str, Job]:
    """List the jobs that disturb runs in the shipped domain."""
    measure = partial(measures.disturbed, SHIPPED)
    return on_drawn(work, f"disturbed-{stamp(SHIPPED)}", min(size.disturbed, size.tasks), measure)


def costless_jobs(work: Path, size: Size) -> dict[str, Job]:
    """List the jobs that plan without costs in the shipped domain."""
    return on_drawn(work, f"costless-{stamp(SHIPPED)}", size.tasks, partial(measures.without_costs, SHIPPED))


def symbolic_jobs(size: Size) -> dict[str, Job]:
    """List the jobs of symbolic tasks, all sizes in turn."""
    prefix = f"symbolic-{stamp(SHIPPED)}"
    return {
        f"{prefix}-{objects}-{difficulty}-{block_name(block)}": partial(
            measures.symbolic, SHIPPED, objects, difficulty, block
        )
        for block in blocks(size.symbolic)
        for objects in SYMBOLIC_OBJECTS
        for difficulty in DIFFICULTIES
    }


def cells() -> list[tuple[int, str]]:
    """List the sizes and difficulties of the scaling table."""
    return [(objects, difficulty) for objects in SCALING_OBJECTS for difficulty in DIFFICULTIES]


def scaling_tasks(size: Size) -> dict[str, Job]:
    """List the jobs that draw the tasks of each cell, with other seeds than the symbolic tasks have."""
    seeds = range(_SCALING_SEEDS, _SCALING_SEEDS + size.scaling)
    return {cell_name(size, *cell): partial(measures.draw_scaling, SHIPPED, *cell, seeds) for cell in cells()}


def scaling_jobs(work: Path, size: Size) -> dict[str, Job]:
    """List the jobs of the scaling table, for planners that there are."""
    known = {name: asked for name, asked in CONTENDERS.items() if asked[0] in PLANNERS}
    return {
        contender_name(size, *cell, name): partial(
            measures.scaling, SHIPPED / GROUNDING, work / "jobs" / f"{cell_name(size, *cell)}.json", *asked
        )
        for cell in cells()
        for name, asked in known.items()
    }


def cell_name(size: Size, objects: int, difficulty: str) -> str:
    """Name the job that draws the tasks of one cell."""
    return f"scaling-{stamp(SHIPPED)}-{objects}-{difficulty}-{size.scaling}"


def contender_name(size: Size, objects: int, difficulty: str, contender: str) -> str:
    """Name the job of one contender in one cell."""
    words = "".join(letter if letter.isalnum() else "_" for letter in contender)
    return f"{cell_name(size, objects, difficulty)}-{words}"


def timing_jobs(work: Path) -> dict[str, Job]:
    """List the job that times whole processes."""
    drawn = work / "jobs" / f"{_drawn(2, range(BLOCK))}.json"
    return {f"timings-{stamp(SHIPPED)}": partial(measures.timings, SHIPPED, drawn)}


def on_drawn(work: Path, prefix: str, tasks: int, measure: Any) -> dict[str, Job]:
    """List a job for each block of drawn tasks, single and double in turn."""
    return {
        f"{prefix}-{objects}-{block_name(block)}": partial(
            measure, work / "jobs" / f"{_drawn(objects, block)}.json"
        )
        for block in blocks(tasks)
        for objects in SIZES.values()
    }


def _drawn(objects: int, block: Sequence[int]) -> str:
    return f"drawn-{objects}-{block_name(block)}"


def block_name(block: Sequence[int]) -> str:
    """Name a block of seeds by its first one and its length."""
    return f"{block[0]:03d}-{len(block)}"
