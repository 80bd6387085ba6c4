"""Running cases, and judging how they end."""

import os
import re
import shutil
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from unittest.mock import patch

from fuzz import own
from fuzz.cases import Case
from fuzz.lines import FOLDER, asks_for_much
from fuzz.server import begin, perform

MOST_WORK = 60.0
"""When a command is interrupted [CPU s]; none of the cases need nearly as much."""
PATIENCE, SHORT_PATIENCE = 600.0, 4.0
"""When a command that only waits is interrupted, and one that was asked for much work [s]."""
MUCH_MEMORY = 2 * 1024**3
"""How much memory no case needs [bytes]."""
LONGEST_LINE = 3000
"""How long a line of a message may be [characters]."""
FINE = {0, 2, 3, 130}
"""How commands end by themselves."""


@dataclass(frozen=True, slots=True)
class Ending:
    """How a case ended."""

    code: int = 0  # as a shell has it
    stage: int = 0  # 0 if it ended by itself, 1 if it had to be interrupted, 2 if it had to be killed
    memory: int = 0  # the most that it held [bytes]
    left: tuple[str, ...] = ()  # processes and files that it left behind
    files: tuple[str, ...] = ()
    output: str = ""  # what it printed, and what as errors
    errors: str = ""


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that must not happen: `key` is the same for findings of one cause."""

    key: str
    detail: str


class Runner:
    """Runs cases on copies of a domain folder, in a process that forks."""

    def __init__(self, pool: ProcessPoolExecutor, seed: Path):
        self._pool, self.seed = pool, seed

    def run(self, case: Case) -> Ending:
        """Run a case in a folder of its own, which is removed."""
        with tempfile.TemporaryDirectory(prefix="fuzz-", ignore_cleanup_errors=True) as place:
            root = Path(place)
            home, temporary = root / "home", root / "tmp"
            home.mkdir()
            temporary.mkdir()
            shutil.copytree(self.seed, home / FOLDER)
            shutil.copy(own.__file__, home / "own.py")
            shutil.copy(next((home / FOLDER / "plans").glob("*.plan")), home / "other.plan")
            case.prepare(home / FOLDER)
            patience = SHORT_PATIENCE if asks_for_much(case.arguments) else PATIENCE
            answer = self._pool.submit(perform, case.arguments, root, MOST_WORK, patience).result()
            files = tuple(_left_files(home, temporary))
            texts = {name: _read(root / name) for name in ("output", "errors")}
            return Ending(**answer, files=files, **texts)


@contextmanager
def runner(seed: Path) -> Iterator[Runner]:
    """Start a process that performs cases, which begin with this domain folder."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    with ProcessPoolExecutor(1, get_context("spawn"), initializer=begin) as pool:
        with patch.dict(os.environ, threads):
            pool.submit(int).result()
        yield Runner(pool, seed)


def _left_files(home: Path, temporary: Path) -> Iterator[str]:
    for path in sorted(temporary.iterdir()):
        yield f"tmp/{path.name}"
    for path in sorted(home.rglob(".*")):
        yield path.relative_to(home).as_posix()


def _read(path: Path) -> str:
    if not path.exists():
        return ""
    with path.open("rb") as file:
        return file.read(2_000_000).decode(errors="replace")


def judge(case: Case, ending: Ending) -> list[Finding]:
    """List what must not have happened."""
    said = ending.output + ending.errors
    command = next(iter(case.arguments), "")
    command = command if command.isidentifier() else "neurosym"
    left = re.sub(r"[\w]*\d\w*|_[\w]{6,}", "*", " ".join((*ending.left, *ending.files)))[:100]
    warning = re.search(r"neurosym/([\w/]+\.py):(\d+): (\w+Warning): ", said)
    warning = warning or re.search(r"(\w+Warning): (.{0,60})", said)
    holds = {
        _bad_end(case, ending, command): True,
        f"a message with None: {command}": re.search(r"^None: ", said, re.MULTILINE),
        f"a control character: {command}": re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", said),
        f"a warning of Python: {' '.join(warning.groups()) if warning else ''}": warning,
        f"a long line: {command}": any(len(line) > LONGEST_LINE for line in said.splitlines()),
        f"much memory: {command}": ending.memory > MUCH_MEMORY,
        f"a process left: {left}": ending.left,
        f"a file left: {left}": ending.files,
    }
    detail = f"{ending.left} {ending.files} {said[-3000:]}"
    return [Finding(key, detail) for key, is_so in holds.items() if key and is_so]


def _bad_end(case: Case, ending: Ending, command: str) -> str:
    """Name what is wrong with how a command ended; nothing if that is fine."""
    said, code = ending.output + ending.errors, ending.code
    if "Traceback (most recent call last)" in said and (frame := innermost(said)):
        return f"{_error(said)} in {frame}"
    if ending.stage == 2:
        return f"deaf to Ctrl-C: {command}"
    if ending.stage == 1:
        return "" if asks_for_much(case.arguments) else f"no end: {command}"
    if code not in FINE:
        last = re.sub(r"\d+|'[^']*'|/\S+", "*", (ending.errors.strip().splitlines() or [""])[-1])[:100]
        return f"exit code {code}: {last}"
    return "exit code 2 without a word" if code == 2 and not ending.errors.strip() else ""


def innermost(text: str) -> str:
    """Name the innermost function of ours in a traceback."""
    frames = re.findall(r'File "[^"]*?/(neurosym/[\w/]+\.py)", line \d+,? in (\S+)', text)
    return ":".join(frames[-1]) if frames else ""


def _error(text: str) -> str:
    """Name the last exception that a traceback ends with."""
    last = text.rpartition("Traceback (most recent call last)")[2]
    names = re.findall(r"^((?:\w+\.)*[A-Z]\w+)(?::|$)", last, re.MULTILINE)
    return names[0] if names else "an error"
