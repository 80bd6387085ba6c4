"""Running cases, and judging how they end."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from fuzz import own
from fuzz.cases import Case
from fuzz.lines import FOLDER, asks_for_much

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
_NUMBERS = {"SIGINT": 130, "SIGTERM": 143, "SIGHUP": 129}
_ROOT = Path(__file__).parent.parent.parent


@dataclass(frozen=True, slots=True)
class Ending:
    """How a case ended.

    Attributes:
        code: Its exit code, as a shell has it.
        stage: 0 if it ended by itself, 1 if it had to be interrupted, 2 if it had to be killed.
        memory: The most that it held [bytes].
        left: Processes that it left behind.
        files: Files that it left behind.
        output: What it printed.
        errors: What it printed as errors.
        stack: Where it was when it was interrupted.
        seconds: How long it took [s].
    """

    code: int
    stage: int
    memory: int
    left: tuple[str, ...]
    files: tuple[str, ...]
    output: str
    errors: str
    stack: str
    seconds: float


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that must not happen: `key` is the same for findings of one cause."""

    key: str
    detail: str


class Runner:
    """Runs cases on copies of a domain folder, by a server that forks."""

    def __init__(self, server: "subprocess.Popen[str]", seed: Path):
        self._server, self._seed = server, seed

    def run(self, case: Case) -> Ending:
        """Run a case in a folder of its own, which is removed."""
        with tempfile.TemporaryDirectory(prefix="fuzz-", ignore_cleanup_errors=True) as place:
            root = Path(place)
            home, temporary = root / "home", root / "tmp"
            home.mkdir()
            temporary.mkdir()
            shutil.copytree(self._seed, home / FOLDER)
            shutil.copy(own.__file__, home / "own.py")
            shutil.copy(next((home / FOLDER / "plans").glob("*.plan")), home / "other.plan")
            case.prepare(home / FOLDER)
            files = {name: root / name for name in ("output", "errors", "stack")}
            request = {
                "arguments": [os.fsencode(text).hex() for text in case.arguments],
                **{name: str(path) for name, path in files.items()},
                "home": str(home),
                "temporary": str(temporary),
                "alone": case.alone,
                "signal": case.signal,
                "after": case.after,
                "work": MOST_WORK,
                "patience": SHORT_PATIENCE if asks_for_much(case.arguments) else PATIENCE,
            }
            answer = self._ask(request)
            texts = {name: _read(path) for name, path in files.items()}
            left = tuple(answer.pop("left"))
            return Ending(**answer, left=left, files=tuple(_left_files(home, temporary)), **texts)

    def _ask(self, request: dict[str, object]) -> dict[str, object]:
        assert self._server.stdin is not None
        assert self._server.stdout is not None
        self._server.stdin.write(json.dumps(request) + "\n")
        self._server.stdin.flush()
        answer: dict[str, object] = json.loads(self._server.stdout.readline())
        return answer


@contextmanager
def runner(seed: Path) -> Iterator[Runner]:
    """Start a server.

    Args:
        seed: The domain folder that every case begins with.
    """
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    path = os.pathsep.join([str(_ROOT), str(_ROOT / "tests"), os.environ.get("PYTHONPATH", "")])
    server = subprocess.Popen(
        [sys.executable, "-m", "fuzz.server"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, **threads, "PYTHONPATH": path},
        start_new_session=True,  # Ctrl-C is for us
    )
    with server:
        assert server.stdout is not None
        assert server.stdout.readline() == "ready\n", "the server starts"
        try:
            yield Runner(server, seed)
        finally:
            server.terminate()


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
    found = list(_bad_ends(case, ending))
    said = ending.output + ending.errors
    if "Traceback (most recent call last)" in said and (frame := innermost(said)):
        found = [Finding(f"{_error(said)} in {frame}", said[-3000:])]
    command = next(iter(case.arguments), "") if next(iter(case.arguments), "").isidentifier() else "neurosym"
    for words, holds in (
        ("a message with None:", re.search(r"^None: ", said, re.MULTILINE)),
        ("a control character", re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", said)),
        ("a warning of Python", re.search(r"\w+Warning: ", said)),
        ("a long line", any(len(line) > LONGEST_LINE for line in said.splitlines())),
        ("much memory", ending.memory > MUCH_MEMORY),
        ("a process left", ending.left),
        ("a file left", ending.files),
    ):
        if holds:
            about = _cause(words, said, ending)
            found.append(
                Finding(f"{words}: {about or command}", f"{ending.left} {ending.files} {said[-2000:]}")
            )
    return found


def _cause(words: str, said: str, ending: Ending) -> str:
    if "warning" in words:
        match = re.search(r"neurosym/([\w/]+\.py):(\d+): (\w+)", said) or re.search(
            r"(\w+)Warning: (.{0,60})", said
        )
        return " ".join(match.groups()) if match else ""
    if "left" in words:
        return re.sub(r"[\w]*\d\w*|_[\w]{6,}", "*", " ".join((*ending.left, *ending.files)))[:100]
    return ""


def _bad_ends(case: Case, ending: Ending) -> Iterator[Finding]:
    allowed = FINE | {_NUMBERS[case.signal]} if case.signal else FINE
    if ending.stage == 2:
        yield Finding(
            f"deaf to Ctrl-C in {innermost(ending.stack, reverse=True)}", ending.stack or ending.errors
        )
    elif ending.stage == 1 and not asks_for_much(case.arguments):
        where = innermost(ending.stack, reverse=True) or " ".join(case.arguments[:1])
        yield Finding(f"no end of {where}", ending.stack)
    elif ending.code not in allowed and not (case.signal == "SIGINT" and not innermost(ending.errors)):
        last = re.sub(r"\d+|'[^']*'|/\S+", "*", (ending.errors.strip().splitlines() or [""])[-1])[:100]
        yield Finding(f"exit code {ending.code}: {last}", (ending.output + ending.errors)[-3000:])
    elif ending.code == 2 and not ending.errors.strip():
        yield Finding("exit code 2 without a word", ending.output[-1000:])


def innermost(text: str, *, reverse: bool = False) -> str:
    """Name the innermost function of ours in a traceback, which comes last, or else first (`reverse`)."""
    frames = re.findall(r'File "[^"]*?/(neurosym/[\w/]+\.py)", line \d+,? in (\S+)', text)
    return ":".join(frames[0 if reverse else -1]) if frames else ""


def _error(text: str) -> str:
    """Name the last exception that a traceback ends with."""
    names = re.findall(
        r"^((?:\w+\.)*[A-Z]\w+)(?::|$)", text.rpartition("Traceback (most recent call last)")[2], re.MULTILINE
    )
    return names[0] if names else "an error"
