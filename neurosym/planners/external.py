"""Planners that are programs of their own, each run on our own PDDL as its authors mean it to be called.

What they are called with is all we know of them: they are run in an empty folder, and what they leave there
as a plan is read by us. Packages from the Python index bring them; none is imported.
"""

import importlib.util
import shutil
import sys
import sysconfig
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from neurosym.planners.planner import PlannerMissing
from neurosym.planners.process import Finished, read_text, run_limited
from neurosym.planners.result import PlannerAnswer, PlanStatus
from neurosym.planners.scratch import scratch_folder

PLAN = "plan"
"""The file that programs are asked to write a plan to."""
_OUT_OF_TIME = (21, 23, 24)  # of Fast Downward and its descendants


@dataclass(frozen=True, slots=True)
class Program:
    """How a planner is called, and what its end means.

    Attributes:
        title: What it is called.
        package: The Python package that brings it.
        distribution: What that is called in the Python index.
        arguments: Gives the command, from the package's folder, the domain, the problem, and the limit [s].
        plans: Where it leaves plans, as a pattern; of several, the last is the best.
        unsolvable: Exit codes that mean that there is no plan.
        no_plan: What it prints if there is no plan.
        needs: A command that must be there too, and what brings that.
    """

    title: str
    package: str
    distribution: str
    arguments: Callable[[Path, str, str, float], Sequence[str]]
    plans: str = PLAN
    unsolvable: tuple[int, ...] = ()
    no_plan: str = "no plan, if it said so"
    needs: tuple[str, str] | None = None

    def missing(self) -> str:
        """Say what to do about what is not installed, or nothing if everything is."""
        if _folder_of(self.package) is None:
            return f"`pip install {self.distribution}` brings it"
        if self.needs and shutil.which(self.needs[0]) is None:
            return f"it needs {self.needs[0]}, which {self.needs[1]} brings"
        return ""


def plan_program(domain: Path, problem: Path, *, time_limit: float, program: Program) -> PlannerAnswer:
    """Solve a PDDL problem with a program.

    Args:
        domain: File of the domain.
        problem: File of the problem.
        time_limit: When to give up [s].
        program: The program.

    Raises:
        PlannerMissing: If it is not installed.
    """
    begin = time.perf_counter()
    package = _folder_of(program.package)
    if package is None or program.missing():
        raise PlannerMissing(program.title, program.missing())
    with scratch_folder() as folder:
        files = (str(domain.resolve()), str(problem.resolve()))
        finished = run_limited(program.arguments(package, *files, time_limit), folder, time_limit)
        found = sorted(folder.glob(program.plans), key=lambda path: (len(path.name), path.name))
        text = read_text(found[-1]) if found else ""
    status, reason = _judge(finished, "(" in text, program)
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


def _judge(finished: Finished, has_plan: bool, program: Program) -> tuple[PlanStatus, str]:
    if has_plan:
        return PlanStatus.SOLVED, ""
    if finished.code is None or finished.code in _OUT_OF_TIME:
        return PlanStatus.TIMEOUT, f"{program.title} found no plan in time"
    if finished.code in program.unsolvable or program.no_plan in finished.output:
        return PlanStatus.UNSOLVABLE, f"{program.title} says that there is no plan"
    return PlanStatus.FAILED, f"{program.title} ended with code {finished.code}: {finished.last_words}"


def _folder_of(package: str) -> Path | None:
    """Find the folder of a package without importing it."""
    spec = importlib.util.find_spec(package)
    places = spec.submodule_search_locations if spec else None
    return Path(next(iter(places))) if places else None


def _kairos(_: Path, domain: str, problem: str, time_limit: float) -> Sequence[str]:
    program = str(Path(sysconfig.get_path("scripts")) / "kairos")
    limit = f"{max(0.8 * time_limit, 0.1):.1f}"
    options = ("--timeout", limit, "--no-improvement", "1", "--threads", "1", "--output", PLAN)
    return (program, "solve", domain, problem, *options)


def _enhsp(package: Path, domain: str, problem: str, _: float) -> Sequence[str]:
    java = ("java", "-Xmx1g", "-XX:CompressedClassSpaceSize=64m", "-XX:-UsePerfData")
    jar = str(package / "ENHSP" / "enhsp.jar")
    return (*java, "-jar", jar, "-o", domain, "-f", problem, "-planner", "sat-hadd", "-sp", PLAN)


def _lpg(package: Path, domain: str, problem: str, _: float) -> Sequence[str]:
    return (str(package / "lpg"), "-o", domain, "-f", problem, "-n", "1", "-seed", "1", "-out", PLAN)


def _symk(package: Path, domain: str, problem: str, _: float) -> Sequence[str]:
    driver = str(package / "symk" / "fast-downward.py")
    return (
        sys.executable,
        driver,
        *("--plan-file", PLAN, domain, problem, "--search-options", "--search", "sym_bd()"),
    )


def _kstar(package: Path, domain: str, problem: str, _: float) -> Sequence[str]:
    build = str(package / "builds" / "release" / "bin")
    search = "kstar(lmcut(),k=1,dump_plan_files=true)"
    command = (sys.executable, "-B", "-m", "kstar_planner.driver.main", "--build", build)
    return (*command, domain, problem, "--search", search)


def _forbid_iterative(package: Path, domain: str, problem: str, _: float) -> Sequence[str]:
    build = str(package / "builds" / "release" / "bin")
    command = (sys.executable, "-B", "-m", "forbiditerative.plan", "--build", build, "--planner", "topk")
    options = ("--number-of-plans", "1", "--symmetries", "--use-local-folder", "--clean-local-folder")
    return (*command, "--domain", domain, "--problem", problem, *options)


KAIROS = Program("Kairos", "kairos", "kairos-planner", _kairos, plans=f"{PLAN}*", unsolvable=(10,))
ENHSP = Program(
    "ENHSP",
    "up_enhsp",
    "up-enhsp",
    _enhsp,
    no_plan="nsolvable",
    needs=("java", "a Java runtime of version 17 or later"),
)
LPG = Program("LPG", "up_lpg", "up-lpg", _lpg, plans=f"{PLAN}*", no_plan="The problem is unsolvable")
SYMK = Program("SymK", "up_symk", "up-symk", _symk, unsolvable=(10, 11, 12))
KSTAR = Program(
    "K*", "kstar_planner", "kstar-planner", _kstar, plans="found_plans/*.1", unsolvable=(10, 11, 12)
)
FORBID_ITERATIVE = Program(
    "Forbid-Iterative",
    "forbiditerative",
    "forbiditerative",
    _forbid_iterative,
    plans="found_plans/done/*.1",
    no_plan="no solution",
)
