"""Performs cases, each in a process forked from this one, which has imported all but computed nothing.

So a case costs what the command does, and not the seconds that importing torch takes; and whatever it does to
its process, the next finds it as it was. Trainings are cut short: their code is run, with few steps.
"""

import atexit
import importlib
import os
import pkgutil
import resource
import signal
import sys
import threading
import time
import traceback
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from inspect import signature
from pathlib import Path
from typing import Any

GRACE = 15.0
"""How long a command may take to end once it was asked to [s]."""
LINGER = 3.0
"""How long a process that a command started may outlive it [s]."""
MORE_MEMORY = 3 * 1024**3
"""How much more memory a case may map than this process does [bytes]."""
LARGEST_FILE = 1024**3
"""How large a file a case may write [bytes]."""
_SKIPPED = ("neurosym.__main__", "neurosym.worlds.gymnasium_env")


def begin() -> None:
    """Get ready to perform cases."""
    os.setsid()  # Ctrl-C is for who asks
    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path)
    _adopt_orphans()
    _import_all()
    _train_shortly()


def _adopt_orphans() -> None:
    """Become the parent of what processes of a case leave behind."""
    import ctypes

    pr_set_child_subreaper = 36
    ctypes.CDLL(None, use_errno=True).prctl(pr_set_child_subreaper, 1, 0, 0, 0)


def _import_all() -> None:
    import neurosym

    for module in pkgutil.walk_packages(neurosym.__path__, "neurosym."):
        if module.name not in _SKIPPED:
            importlib.import_module(module.name)


def _train_shortly() -> None:
    from neurosym.exploration import loop
    from neurosym.learning import training_config
    from neurosym.primitives import distillation

    few = {"table_actions": 100, "table_objects": 8, "table_restarts": 1}
    for name, regime in training_config.REGIMES.items():
        training = regime.training
        short = replace(
            training,
            epochs=2,
            teacher=replace(training.teacher, epochs=2),
            naming=replace(training.naming, **few, actions=200, objects=50, steps=3),
            coding=replace(training.coding, steps=3),
            decoder=replace(training.decoder, imagined=200, imagined_epochs=1, epochs=2),
        )
        training_config.REGIMES[name] = replace(regime, training=short)
    _set_defaults(loop.ExplorationConfig, candidates=20)
    distillation.distill.__kwdefaults__ |= {"candidates": 8, "steps": 10}


def _set_defaults(kind: type, **defaults: object) -> None:
    """Give fields of a dataclass other defaults."""
    made = kind.__init__  # type: ignore[misc]
    parameters = signature(made).parameters.values()
    known = {one.name: one.default for one in parameters if one.default is not one.empty}
    made.__defaults__ = (*(known | defaults).values(),)


def perform(arguments: Sequence[str], place: Path, work: float, patience: float) -> dict[str, Any]:
    """Run a command in a process of its own, and watch how it ends.

    The place is a folder with `home`, `tmp`, and files for what the command prints. It is interrupted after
    so much work [CPU s], or patience [s].
    """
    process = os.fork()
    if process == 0:
        _become(arguments, place)
    return {**_watch(process, work, patience), "left": tuple(_left_behind())}


def _watch(process: int, work: float, patience: float) -> dict[str, Any]:
    start, stage, deadline = time.monotonic(), 0, patience
    while True:
        ended, status, usage = os.wait4(process, os.WNOHANG)
        if ended:
            code = os.waitstatus_to_exitcode(status)
            code = code if code >= 0 else 128 - code
            return {"code": code, "stage": stage, "memory": usage.ru_maxrss * 1024}
        now = time.monotonic() - start
        if stage < 2 and (now >= deadline or (stage == 0 and _cpu_seconds(process) >= work)):
            os.kill(process, (signal.SIGINT, signal.SIGKILL)[stage])
            stage, deadline = stage + 1, now + GRACE
        time.sleep(0.002)


def _cpu_seconds(process: int) -> float:
    """Measure how long a process computed: unlike the clock, that does not depend on what else goes on."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _left_behind() -> list[str]:
    """Name the processes that outlive the command that started them, and end them."""
    deadline = time.monotonic() + LINGER
    while _children() and time.monotonic() < deadline:
        time.sleep(0.01)
    names = []
    while left := _children():
        for process in left:
            with suppress(OSError):
                line = Path(f"/proc/{process}/cmdline").read_bytes().replace(b"\0", b" ")
                names.append(line.decode(errors="replace")[:200])
            with suppress(OSError):
                os.kill(process, signal.SIGKILL)
        time.sleep(0.01)
    return names


def _children() -> list[int]:
    with suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    listed = Path(f"/proc/self/task/{os.getpid()}/children").read_text()
    return [int(number) for number in listed.split()]


def _become(arguments: Sequence[str], place: Path) -> None:
    """Turn this process into the command; does not return."""
    code = 1
    try:
        _settle(place)
        code = _call(arguments)
    except BaseException:
        traceback.print_exc()
    finally:
        with suppress(BaseException):
            threading._shutdown()  # type: ignore[attr-defined]
            atexit._run_exitfuncs()
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(code)


def _settle(place: Path) -> None:
    os.setsid()
    os.chdir(place / "home")
    os.environ["TMPDIR"] = str(place / "tmp")
    for descriptor, path in ((0, os.devnull), (1, place / "output"), (2, place / "errors")):
        opened = os.open(path, os.O_RDONLY if descriptor == 0 else os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(opened, descriptor)
        os.close(opened)
    sys.stdin = open(0, closefd=False)  # noqa: SIM115
    sys.stdout = open(1, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
    sys.stderr = open(2, "w", encoding="utf-8", errors="backslashreplace", closefd=False)  # noqa: SIM115
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    size = pages * resource.getpagesize() + MORE_MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (size, resource.RLIM_INFINITY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.signal(signal.SIGINT, signal.default_int_handler)


def _call(arguments: Sequence[str]) -> int:
    from neurosym.commands import cli

    sys.argv = ["neurosym", *arguments]
    try:
        cli.main()
    except SystemExit as ended:
        if isinstance(ended.code, int) or ended.code is None:
            return ended.code or 0
        print(ended.code, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        traceback.print_exc()
        return 130
    return 0
