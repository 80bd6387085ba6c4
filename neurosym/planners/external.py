"""Planners that are programs of their own: how each is called, and how they are run and leave nothing behind.

Programs run on our own PDDL as their authors mean them to be called. What they are called with is all we know
of them: they are run in an empty folder, and what they leave there as a plan is read by us. Packages from the
Python index bring them; none is imported.
"""

import atexit
import importlib.util
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import textwrap
import threading
import time
import uuid
from collections.abc import Container, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from neurosym.errors import CannotStart, InvalidFile
from neurosym.files import naming, read_bytes
from neurosym.planners import keeper
from neurosym.planners.keeper import FOLDER_PREFIX, MARK, end_marked
from neurosym.planners.planner import PddlCall, PlannerAnswer, PlannerMissing, PlanStatus

# Running a planner as a process that leaves nothing behind.
#
# Planners start processes of their own, some in sessions of their own, and write files wherever they stand,
# or where temporary files go. Each call gets a folder of its own for both. When it ends or its time is up,
# all its descendants are killed: its session, and what has a session of its own by a mark in the environment.
# When we are killed ourselves, the keeper does that (`keeper.py`).

MEMORY = 4 * 1024**3
"""How much memory a planner may take, unless this process may take less [bytes]."""
FILE_SIZE = 1024**3
"""How large a file a planner may write, its output included, unless this process may write less [bytes]."""
_TOLD = 1024**2  # how much of its output is kept, from the end [bytes]
_keepers: dict[int, tuple[str, "subprocess.Popen[bytes] | None"]] = {}
"""Mark and keeper of a process, by its number; a forked process has none yet."""
_PATIENCE = 2.0  # for the keeper to end [s]
_starting = threading.Lock()


@dataclass(frozen=True, slots=True)
class Finished:
    """How a process ended."""

    code: int | None  # its exit code; None if it was killed because the time was up
    output: str  # what it wrote, errors included

    @property
    def last_words(self) -> str:
        """The last line that it wrote, shortened, without control characters."""
        plain = "".join(sign if sign.isprintable() or sign == "\n" else " " for sign in self.output)
        lines = [line.strip() for line in plain.splitlines() if line.strip()]
        return textwrap.shorten(lines[-1], 200) if lines else "it said nothing"


def run_limited(
    command: Sequence[str],
    folder: Path,
    time_limit: float,
    *,
    stdin: Path | None = None,
    environment: Mapping[str, str] | None = None,
    memory: int = MEMORY,
) -> Finished:
    """Run a command in a session of its own, and kill all that is left of it when it ends or its time is up.

    The folder is its working directory, and where its temporary files go. Its time may be infinite [s], and
    its memory is limited [bytes]. Variables are added to the environment.
    """
    mark = f"{_kept()}.{uuid.uuid4().hex}"
    source_file = stdin or Path(os.devnull)
    # A shell limits itself and then becomes the command, so that no moment is without the limits.
    kibibytes, blocks = _at_most(resource.RLIMIT_AS, memory) // 1024, _at_most(resource.RLIMIT_FSIZE) // 512
    limits = f"{{ ulimit -v {kibibytes}; ulimit -f {blocks}; }} 2>/dev/null"  # not every system has both
    with source_file.open("rb") as source, tempfile.TemporaryFile() as sink:
        try:
            process = subprocess.Popen(
                ["/bin/sh", "-c", f'{limits}; exec "$@"', "sh", *command],
                cwd=folder,
                stdin=source,
                stdout=sink,
                stderr=subprocess.STDOUT,
                env={**os.environ, "TMPDIR": str(folder), **(environment or {}), MARK: mark},
                start_new_session=True,
            )
        except OSError as error:
            raise CannotStart("planner", str(error.strerror)) from error
        code: int | None = None
        try:
            with suppress(subprocess.TimeoutExpired):
                code = process.wait(timeout=None if math.isinf(time_limit) else max(time_limit, 0.0))
        finally:
            if process.returncode is None:  # and so its number is still its own
                with suppress(ProcessLookupError, PermissionError):
                    os.killpg(process.pid, signal.SIGKILL)
            end_marked(mark)
            process.wait()
        sink.seek(max(0, sink.seek(0, os.SEEK_END) - _TOLD))
        return Finished(code, sink.read().decode(errors="replace"))


def read_text(path: Path) -> str:
    """Read what a planner wrote, whatever it is; nothing if there is no such file, or it is too large."""
    with suppress(InvalidFile):
        return read_bytes(path, _TOLD).decode(errors="replace")
    return ""


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Make an empty folder, and remove it with all that is in it; also when this process is killed."""
    with tempfile.TemporaryDirectory(prefix=f"{FOLDER_PREFIX}{_kept()}-", ignore_cleanup_errors=True) as name:
        yield Path(name)


def _kept() -> str:
    """Return the mark of this process, whose keeper clears away what it leaves when it ends."""
    with _starting:
        if os.getpid() not in _keepers:
            owner, started = uuid.uuid4().hex, None
            program = [sys.executable, "-I", "-S", keeper.__file__, tempfile.gettempdir(), owner]
            with suppress(OSError):
                started = subprocess.Popen(
                    program,
                    cwd="/",
                    stdin=subprocess.PIPE,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    env={name: value for name, value in os.environ.items() if name != MARK},
                    start_new_session=True,
                )
            _keepers[os.getpid()] = owner, started
        return _keepers[os.getpid()][0]


@atexit.register
def _dismiss() -> None:
    """Tell the keeper whether something is left that it should clear away, and wait for its end."""
    owner, found = _keepers.pop(os.getpid(), ("", None))
    if found:
        is_left = any(Path(tempfile.gettempdir()).glob(f"{FOLDER_PREFIX}{owner}-*"))
        with suppress(OSError, subprocess.TimeoutExpired):
            found.communicate(b"" if is_left else b".", timeout=_PATIENCE)


def _at_most(kind: int, most: int = FILE_SIZE) -> int:
    """Return what a planner may have, which is never more than this process may have."""
    return min(limit for limit in (most, *resource.getrlimit(kind)) if limit != resource.RLIM_INFINITY)


PLAN = "plan"
"""The file that programs are asked to write a plan to."""
UNSOLVABLE, OUT_OF_MEMORY = (10, 11), (20, 22)
"""Exit codes of Fast Downward and its descendants."""
_INCOMPLETE, _OUT_OF_TIME = 12, (21, 23, 24)


@dataclass(frozen=True, slots=True)
class Program:
    """How a planner is called, and what its end means."""

    title: str  # what it is called
    package: str  # the Python package that brings it
    # the words of the command; in them, {python}, {scripts} and {package} stand for the interpreter, the
    # folder of installed commands and that of the package, {domain}, {problem} and {plan} for files, and
    # {seconds} for how long it may take
    command: Sequence[str]
    plans: str = PLAN  # where it leaves plans, as a pattern; of several, the last is the best
    unsolvable: tuple[int, ...] = ()  # exit codes that mean that there is no plan
    no_plan: str = ""  # what it prints if there is no plan
    needs: tuple[str, str] | None = None  # a command that must be there too, and what brings that
    # what the package is called in the Python index, if it is not its own name with hyphens
    distribution: str = ""

    def missing(self) -> str:
        """Say what to do about what is not installed, or nothing if everything is."""
        if _folder_of(self.package) is None:
            named = self.distribution or self.package.replace("_", "-")
            return f"`pip install {named}` brings it"
        if self.needs and shutil.which(self.needs[0]) is None:
            return f"it needs {self.needs[0]}, which {self.needs[1]} brings"
        return ""


def answer_to(call: PddlCall, texts: Sequence[str], *, time_limit: float) -> PlannerAnswer:
    """Have a program answer to the texts of domain and problem, or to one of both in SAS+, in a time [s]."""
    names = ("domain.pddl", "problem.pddl") if len(texts) > 1 else (f"problem{SAS_SUFFIX}",)
    with scratch_folder() as folder:
        files = [folder / name for name in names]
        for file, text in zip(files, texts, strict=True):
            with naming(file):
                file.write_text(text)
        return call(files[0], files[-1], time_limit=time_limit)


def plan_program(domain: Path, problem: Path, *, time_limit: float, program: Program) -> PlannerAnswer:
    """Solve a PDDL problem, given as files, with a program; `PlannerMissing` is raised if it is not there."""
    begin = time.perf_counter()
    if remedy := program.missing():
        raise PlannerMissing(program.title, remedy)
    with scratch_folder() as folder:
        given = {
            "{python}": sys.executable,
            "{scripts}": sysconfig.get_path("scripts"),
            "{package}": str(_folder_of(program.package)),
            "{domain}": str(domain.resolve()),
            "{problem}": str(problem.resolve()),
            "{plan}": PLAN,
            "{seconds}": f"{max(0.8 * time_limit, 0.1):.1f}",
        }
        words = (
            re.sub(r"{\w+}", lambda found: given.get(found[0], found[0]), one) for one in program.command
        )
        finished = run_limited([*words], folder, time_limit)
        found = sorted(folder.glob(program.plans), key=lambda path: (len(path.name), path.name))
        text = read_text(found[-1]) if found else ""
    status, reason = PlanStatus.SOLVED, ""
    if "(" not in text:
        status, reason = _judged(finished, program.title, program.unsolvable, program.no_plan)
        if status is PlanStatus.SOLVED:
            status, reason = _failed(finished, program.title)
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


def _judged(
    finished: Finished, title: str, unsolvable: Container[int] = UNSOLVABLE, no_plan: str = ""
) -> tuple[PlanStatus, str]:
    """Say what the end of a program means; SOLVED if it ended well."""
    code = finished.code
    if code is None or code in _OUT_OF_TIME:
        return PlanStatus.TIMEOUT, f"{title} found no plan in time"
    if code in unsolvable or (no_plan and no_plan in finished.output):
        return PlanStatus.UNSOLVABLE, f"{title} says that there is no plan"
    if code == _INCOMPLETE:
        return PlanStatus.NOT_FOUND, f"{title} found no plan; its search does not look at everything"
    if code in OUT_OF_MEMORY:
        remedy = "ask for fewer goals at a time, or for another planner"
        return PlanStatus.NOT_FOUND, f"{title} ran out of memory; {remedy}"
    return (PlanStatus.SOLVED, "") if code == 0 else _failed(finished, title)


def _failed(finished: Finished, title: str) -> tuple[PlanStatus, str]:
    return PlanStatus.FAILED, f"{title} ended with code {finished.code}: {finished.last_words}"


def _folder_of(package: str) -> Path | None:
    """Find the folder of a package without importing it."""
    spec = importlib.util.find_spec(package)
    places = (spec.submodule_search_locations if spec else None) or []
    return next(map(Path, places), None)


# Fast Downward, the one that the package up-fast-downward brings, on our own SAS+ or PDDL.
#
# Going through unified-planning takes seconds on fine grids, because it makes every ground fluent. Here one
# search runs after another: the cheapest plan if it can be had in little memory (blind A*: our states are
# small, and heuristics cost more than they save), any plan otherwise. PDDL is translated once before.
#
# Fast Downward knows no limit of expansions, but how many states fit into some memory does not depend on
# how busy a machine is. So memory is the budget of a search, and the user's time ends all of them at once.

LAMA_FIRST = (
    "let(hlm,eval_modify_costs(landmark_sum(lm_factory=lm_reasonable_orders_hps(lm_rhw()),pref=false),"
    "cost_type=one),let(hff,eval_modify_costs(ff(),cost_type=one),"
    "lazy_greedy([hff,hlm],preferred=[hff,hlm],cost_type=one,reopen_closed=false)))"
)


@dataclass(frozen=True, slots=True)
class Search:
    """One search of a portfolio."""

    configuration: str  # what Fast Downward calls it; no blanks
    memory: int = MEMORY  # how much memory it may take [bytes]; the next search begins when it wants more
    for_task: int = 0  # how much more for each byte of the task that it reads [bytes]
    weight: int = 15  # how many states of blind A* one that it evaluates takes as long as

    def work(self, output: str, memory: int) -> int:
        """Return how much it has looked at [states, see `Effort`].

        Where the memory ended it, that is what fits into so much [bytes], and no sum of what it said: the
        last line that it writes then may differ.
        """
        evaluated = _EVALUATED.search(output)
        if evaluated:
            return self.weight * int(evaluated[1])
        return max(0, memory - _ITSELF) // (_PER_STATE if self.weight == 1 else _PER_HEAVY)


_EVALUATED = re.compile(r"\] Evaluated (\d+) state")
_ITSELF = 12 * 1024**2
"""How much memory Fast Downward takes before it searches [bytes]."""
_PER_STATE, _PER_HEAVY = 48, 16
"""How much memory without success counts as a state [bytes]: of blind A*; and of others, which are slower."""
_TRANSLATING, _PER_FACT = 50_000, 2
"""As how many states translating a task counts, and how much of it counts as one more [bytes]."""

PORTFOLIO = (Search("astar(blind())", memory=256 * 1024**2, weight=1), Search(LAMA_FIRST))
"""The cheapest plan first: some 10 million states fit; a grid for one object has less than one million."""

FOR_PLACES = (
    Search("astar(blind())", memory=16 * 1024**2, weight=1),
    Search("astar(lmcut())", memory=11 * 1024**2, for_task=7),
    Search(LAMA_FIRST, memory=24 * 1024**2, for_task=12),
)
"""With places there are few steps in a plan, and so many orders of them that more memory seldom helps.

Relations are as places. Four objects fit. With eight, twice the memory took three times as long and was as
seldom enough. Landmark cuts find the cheapest plan with relations, where plans have few steps; states take
them long, so they get little memory. The last search finds plans for thirty objects in hardly more memory
than reading them takes, seven bytes for each of the task, and took 18 MB for eight that pass one another.
"""

SAS_SUFFIX = ".sas"
_TITLE = "Fast Downward"


def plan_fast_downward(
    domain: Path, problem: Path, *, time_limit: float, searches: Sequence[Search] = ()
) -> PlannerAnswer:
    """Solve a problem with Fast Downward: translate it, and search until one has memory enough.

    A file of both in SAS+ (`.sas`) is not translated. What is tried is by what a problem needs, if not given.
    """
    begin = time.perf_counter()
    programs = _programs()
    if programs is None:
        raise PlannerMissing(_TITLE, missing())
    is_sas = problem.suffix == SAS_SUFFIX
    has_places = not is_sas and b" - spot" in read_bytes(problem)
    status, reason, text, work = PlanStatus.SOLVED, "", "", 0
    with scratch_folder() as folder:
        task, plan = problem.resolve() if is_sas else folder / "output.sas", folder / PLAN
        if not is_sas:
            files = str(domain.resolve()), str(problem.resolve())
            translate = [sys.executable, "-m", "fast_downward.translate", *files]
            added = {"PYTHONPATH": str(programs)}
            status, reason = _judged(run_limited(translate, folder, time_limit, environment=added), _TITLE)
            work = _TRANSLATING + (task.stat().st_size // _PER_FACT if task.is_file() else 0)
        tried = searches or (FOR_PLACES if has_places else PORTFOLIO)
        for search in tried if status is PlanStatus.SOLVED else ():
            memory = min(MEMORY, search.memory + search.for_task * task.stat().st_size)
            command = [str(programs / "downward"), "--search", search.configuration]
            left = time_limit - (time.perf_counter() - begin)
            to_file = "--internal-plan-file", str(plan)
            finished = run_limited([*command, *to_file], folder, left, stdin=task, memory=memory)
            work += search.work(finished.output, memory)
            status, reason = _judged(finished, _TITLE)
            text = read_text(plan) if status is PlanStatus.SOLVED else ""
            if finished.code not in OUT_OF_MEMORY:
                break
    if status is PlanStatus.SOLVED and not text:
        status, reason = PlanStatus.FAILED, f"{_TITLE} wrote no plan"
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason, work)


def missing() -> str:
    """Say what to do if it is not installed, or nothing if it is."""
    return "" if _programs() else "`pip install up-fast-downward` brings it"


def _programs() -> Path | None:
    """Find the folder of the compiled planner without importing unified-planning."""
    package = _folder_of("up_fast_downward")
    folder = package / "downward" / "builds" / "release" / "bin" if package else None
    return folder if folder and (folder / "downward").is_file() else None
