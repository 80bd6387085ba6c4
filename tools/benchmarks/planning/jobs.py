"""Which jobs `evaluate.py` does, in which order; each has a name that says what it depends on."""

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Literal, NamedTuple

from neurosym.data.origin import StrategyName
from neurosym.planners import PLANNERS
from neurosym.stages.layout import GROUNDING, MODEL, WORLD
from tools.benchmarks.jobs import Jobs
from tools.benchmarks.planning import measures
from tools.benchmarks.planning.tasks import DIFFICULTIES
from tools.benchmarks.planning.trials import PLANNER

SHIPPED = Path("domains/tabletop")
Strategy = Literal["curiosity", "random", "active", "entropy"]
STRATEGIES: dict[Strategy, StrategyName] = {
    "curiosity": "disagreement",
    "random": "random",
    "active": "active",
    "entropy": "entropy",
}  # what Table III compares, and what `neurosym explore` calls it; entropy is the paper's own curiosity
USUAL: tuple[Strategy, ...] = ("curiosity", "random", "active")  # who is compared unless asked otherwise
SIZES = {"single": 1, "double": 2}
COMPARED = ("bfs", PLANNER)
TOLERANCES = (0.05, 0.02)
SYMBOLIC_OBJECTS, SCALING_OBJECTS, FAR_OBJECTS = (1, 2, 4), (1, 2, 4, 8, 16), (1, 2, 4)
CELLS = [(objects, difficulty) for objects in SCALING_OBJECTS for difficulty in DIFFICULTIES]
"""Sizes and difficulties of the scaling table."""
_BLOCK, _FAR_BLOCK = 10, 5  # tasks in one job
_SCALING_SEEDS = 10_000  # the first of those that the symbolic tasks do not have
_PAGE, _NUMERIC = {"encoding": "strips", "costs": False}, {"encoding": "numeric", "costs": False}
CONTENDERS: dict[str, tuple[str, dict[str, Any]]] = {
    "BFS over operators, 3 deep": ("bfs", {}),
    "SAS+, object by object": (PLANNER, {}),
    "SAS+, object by object, no costs": (PLANNER, {"costs": False}),
    "SAS+, whole, no costs": (PLANNER, {"whole": True, "costs": False}),
    "page, object by object, no costs": (PLANNER, _PAGE),
    "page, whole, no costs": (PLANNER, _PAGE | {"whole": True}),
    "numeric with Kairos, object by object, no costs": ("kairos", _NUMERIC),
    "numeric with Kairos, whole, no costs": ("kairos", _NUMERIC | {"whole": True}),
    "numeric with ENHSP, object by object, no costs": ("enhsp", _NUMERIC),
    "counting": ("counting", {}),
}  # who is tried at scale: the planner, and what it is asked for; without costs, all operators cost alike

Turn = tuple[str, Jobs]  # what jobs are about, and the jobs by name


class Size(NamedTuple):
    """How much is measured."""

    seeds: int  # of Table III
    steps: int  # interactions of each exploration
    tasks: int  # drawn tasks of each size
    symbolic: int  # symbolic tasks of each size and difficulty
    scaling: int  # tasks in each cell of the scaling table
    disturbed: int  # disturbed runs of each size
    strategies: tuple[Strategy, ...]  # whom Table III compares
    precise: int  # tasks of each size that are tried in the shipped domain, blindly and with replanning
    far: tuple[int, ...]  # tasks with goals anywhere, with one, two and four objects


def size_of(seeds: int, steps: int, strategies: tuple[Strategy, ...] = USUAL) -> Size:
    """Say how much is measured: all of it, or the short form of a single seed."""
    if seeds == 1:
        return Size(seeds, steps, 30, 30, 2, 20, strategies, 30, (10, 5, 5))
    return Size(seeds, steps, 100, 150, 5, 100, strategies, 400, (200, 100, 100))


def domain_name(strategy: Strategy, seed: int) -> str:
    """Name the domain that a strategy leads to."""
    return f"{STRATEGIES[strategy]}-{seed}"


def stamp(folder: Path) -> str:
    """Tell a domain from others in the same place; one that is not compiled yet has none."""
    files = [folder / name for name in (WORLD, MODEL, GROUNDING)]
    if not all(path.is_file() for path in files):
        return "none"
    return hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:8]


def blocks(tasks: int, block: int = _BLOCK) -> list[range]:
    """Cut the seeds 0, 1, ... of so many tasks into blocks."""
    return [range(first, min(first + block, tasks)) for first in range(0, tasks, block)]


def _block_name(block: Sequence[int]) -> str:
    return f"{block[0]:03d}-{len(block)}"


@dataclass(frozen=True, slots=True)
class Agenda:
    """All jobs of so large an evaluation, whose files lie in a working folder."""

    work: Path
    size: Size

    def turns(self, *, learn: bool) -> Iterator[Turn]:
        """List the jobs, what is most asked for first; later jobs read what earlier ones wrote."""
        yield "drawing tasks", self._drawing()
        yield "shipped domain", self.table3("shipped", 0.05)
        yield "precision, 50 mm", self.precision(0.05)
        yield "far goals", {name: job for jobs in self.far().values() for name, job in jobs.items()}
        yield "precision, 20 mm", self.precision(0.02)
        yield "disturbed runs", self.disturbed()
        yield "without costs", self.costless()
        for seed in range(1, self.size.seeds + 1):
            yield from self._seed(seed, 0.05, learn=learn)
        yield "symbolic tasks", self.symbolic()
        yield "drawing scaling tasks", self._scaling_tasks()
        yield "scaling", self._scaling()
        yield "shipped domain, 20 mm", self.table3("shipped", 0.02)
        yield from self._seed(1, 0.02, learn=False)
        yield "kinds of primitive", self.kinds()

    def _seed(self, seed: int, tolerance: float, *, learn: bool) -> Iterator[Turn]:
        """List the jobs of one seed of Table III: learning, and then its tasks."""
        names = {domain_name(strategy, seed): STRATEGIES[strategy] for strategy in self.size.strategies}

        def tried() -> Jobs:
            return {job: do for name in names for job, do in self.table3(name, tolerance).items()}

        jobs, steps = tried(), self.size.steps
        if learn and not all(self._file(job).exists() for job in jobs):
            yield (
                f"learning, seed {seed}",
                {
                    f"learn-{name}-{steps}": partial(measures.learn, self._folder(name), how, seed, steps)
                    for name, how in names.items()
                },
            )
            jobs = {name: job for name, job in tried().items() if "-none-" not in name}
        yield f"seed {seed}, {1000 * tolerance:g} mm", jobs

    def table3(self, name: str, tolerance: float) -> Jobs:
        """List the jobs that compare planners in one domain."""
        measure = partial(measures.judge, self._folder(name), tolerance=tolerance, planners=COMPARED)
        prefix = f"table3-{name}-{self._known_stamp(name)}-{1000 * tolerance:g}mm"
        return self._on_drawn(prefix, self.size.tasks, measure)

    def precision(self, tolerance: float) -> Jobs:
        """List the jobs that try tasks drawn as the paper draws them."""
        prefix, measure = f"precision-{stamp(SHIPPED)}-{1000 * tolerance:g}mm", measures.precise
        return self._on_drawn(prefix, self.size.precise, partial(measure, SHIPPED, tolerance=tolerance))

    def far(self) -> dict[int, Jobs]:
        """List the jobs that try tasks with goals anywhere, each a few, by how many objects there are."""
        prefix = f"far-{stamp(SHIPPED)}"
        return {
            objects: {
                f"{prefix}-{objects}-{_block_name(few)}": partial(measures.far, SHIPPED, objects, few)
                for few in blocks(count, _FAR_BLOCK)
            }
            for objects, count in zip(FAR_OBJECTS, self.size.far, strict=True)
        }

    def disturbed(self) -> Jobs:
        """List the jobs that disturb runs in the shipped domain."""
        prefix, count = f"disturbed-{stamp(SHIPPED)}", min(self.size.disturbed, self.size.tasks)
        return self._on_drawn(prefix, count, partial(measures.disturbed, SHIPPED))

    def costless(self) -> Jobs:
        """List the jobs that plan without costs in the shipped domain."""
        measure = partial(measures.without_costs, SHIPPED)
        return self._on_drawn(f"costless-{stamp(SHIPPED)}", self.size.tasks, measure)

    def symbolic(self) -> Jobs:
        """List the jobs of symbolic tasks, all sizes in turn."""
        prefix = f"symbolic-{stamp(SHIPPED)}"
        return {
            f"{prefix}-{objects}-{hard}-{_block_name(some)}": partial(
                measures.symbolic, SHIPPED, objects, hard, some
            )
            for some in blocks(self.size.symbolic)
            for objects in SYMBOLIC_OBJECTS
            for hard in DIFFICULTIES
        }

    def kinds(self) -> Jobs:
        """List the jobs that say which kinds of primitive there are in the domain of each seed."""
        names = [domain_name("curiosity", seed) for seed in range(1, self.size.seeds + 1)]
        return {
            f"kinds-{name}-{self._known_stamp(name)}-found": partial(measures.kinds, self._folder(name))
            for name in names
        }

    def contender(self, objects: int, difficulty: str, contender: str) -> str:
        """Name the job of one contender in one cell of the scaling table."""
        words = "".join(letter if letter.isalnum() else "_" for letter in contender)
        return f"{self._cell(objects, difficulty)}-{words}"

    def _drawing(self) -> Jobs:
        """List the jobs that draw the tasks as the paper does, the same for every domain."""
        return {
            self._drawn(objects, block).stem: partial(measures.draw, SHIPPED, objects, block)
            for tasks in (self.size.tasks, self.size.precise, min(self.size.disturbed, self.size.tasks))
            for objects in SIZES.values()
            for block in blocks(tasks)
        }

    def _scaling_tasks(self) -> Jobs:
        """List the jobs that draw the tasks of each cell, with other seeds than the symbolic tasks have."""
        seeds = range(_SCALING_SEEDS, _SCALING_SEEDS + self.size.scaling)
        return {self._cell(*cell): partial(measures.draw_scaling, SHIPPED, *cell, seeds) for cell in CELLS}

    def _scaling(self) -> Jobs:
        """List the jobs of the scaling table, for planners that there are."""
        measure = partial(measures.scaling, SHIPPED / GROUNDING)
        return {
            self.contender(*cell, name): partial(measure, self._file(self._cell(*cell)), *asked)
            for cell in CELLS
            for name, asked in CONTENDERS.items()
            if asked[0] in PLANNERS
        }

    def _cell(self, objects: int, difficulty: str) -> str:
        return f"scaling-{stamp(SHIPPED)}-{objects}-{difficulty}-{self.size.scaling}"

    def _on_drawn(self, prefix: str, tasks: int, measure: Callable[[Path], Any]) -> Jobs:
        """List a job for each block of drawn tasks, single and double in turn."""
        return {
            f"{prefix}-{objects}-{_block_name(block)}": partial(measure, self._drawn(objects, block))
            for block in blocks(tasks)
            for objects in SIZES.values()
        }

    def _drawn(self, objects: int, block: Sequence[int]) -> Path:
        return self._file(f"drawn-{objects}-{_block_name(block)}")

    def _file(self, job: str) -> Path:
        return self.work / "jobs" / f"{job}.json"

    def _folder(self, name: str) -> Path:
        return SHIPPED if name == "shipped" else self.work / "domains" / name

    def _known_stamp(self, name: str) -> str:
        """Tell a domain from others, by its records if it is not there any more."""
        known = stamp(self._folder(name))
        if known == "none":
            found = (self.work / "jobs").glob(f"table3-{name}-*-*mm-*.json")
            known = next(iter(sorted({path.stem.split("-")[-5] for path in found})), known)
        return known
