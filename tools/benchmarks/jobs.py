"""Jobs of an evaluation: each writes a file of its own, so that an interrupted run goes on where it was."""

import io
import json
import os
import platform
import resource
import time
import zipfile
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from neurosym.errors import version_of
from neurosym.execution.record import this_machine
from neurosym.files import write_atomically
from neurosym.stages.console import progress_bar, say

Job = Callable[[], Any]
Jobs = dict[str, Job]  # by their names
Found = Mapping[str, Any]  # what jobs found, by their names


@dataclass(frozen=True)
class Evaluation:
    """An evaluation that goes on where it was interrupted: jobs in a working folder, and what came of them.

    Attributes:
        name: What its files are called.
        work: The working folder; what each job found lies in `jobs`.
        results: Folder for NAME.json, NAME.md, and NAME-records.zip, with which another machine goes on.
        workers: How many jobs are done at once.
    """

    name: str
    work: Path
    results: Path
    workers: int = 1

    def __post_init__(self) -> None:
        for folder in (self.work / "jobs", self.results):
            folder.mkdir(parents=True, exist_ok=True)
        unpack(self.results / f"{self.name}-records.zip", self.work / "jobs")

    def path(self, job: str) -> Path:
        """Say where what a job found is kept."""
        return self.work / "jobs" / f"{job}.json"

    def perform(
        self,
        jobs: Mapping[str, Job],
        label: str = "measuring",
        report: Callable[[], None] = lambda: None,
        *,
        fresh: bool = False,
    ) -> None:
        """Do the jobs that were not done, some at once, and report after each.

        A job that fails is told of and left undone; the others go on.
        """
        left = {name: job for name, job in jobs.items() if not self.path(name).exists()}
        if not left:
            return
        once, workers = 1 if fresh else None, min(self.workers, len(left))
        pool = ProcessPoolExecutor(workers, get_context("spawn"), max_tasks_per_child=once)
        with pool, progress_bar(label) as advance:
            running = {pool.submit(job): name for name, job in left.items()}
            try:
                for done, future in enumerate(as_completed(running), 1):
                    _keep(self.path(running[future]), future)
                    report()
                    advance(done, len(left))
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise

    def found(self) -> dict[str, Any]:
        """Read what the jobs found that are done."""
        files = sorted((self.work / "jobs").glob("*.json"))
        return {path.stem: json.loads(path.read_text()) for path in files}

    def write(self, summary: Any, page: str, *, records: bool = True) -> None:
        """Write what came of it: figures, a page, and the jobs themselves."""
        if records:
            pack(self.work / "jobs", self.results / f"{self.name}-records.zip")
        write_atomically(self.results / f"{self.name}.json", as_text(summary))
        write_atomically(self.results / f"{self.name}.md", page)


def _keep(path: Path, future: Future[Any]) -> None:
    try:
        write_atomically(path, as_text(future.result()))
    except BrokenProcessPool:
        raise
    except Exception as error:
        say(f"{path.stem} failed: {type(error).__name__}: {error}")


def as_text(values: Any) -> str:
    """Print values as indented JSON, those of numpy, too."""
    return json.dumps(values, indent=1, default=lambda value: value.tolist()) + "\n"


def pack(folder: Path, archive: Path, kind: str = "*.json") -> None:
    """Put files of a folder into an archive; the same files give the same bytes."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in sorted(folder.glob(kind)):
            packed.writestr(zipfile.ZipInfo(path.name), path.read_bytes(), zipfile.ZIP_DEFLATED)
    write_atomically(archive, content.getvalue())


def unpack(archive: Path, folder: Path) -> None:
    """Take from an archive what is not in the folder yet."""
    if archive.exists():
        with zipfile.ZipFile(archive) as packed:
            for name in packed.namelist():
                if not (path := folder / Path(name).name).exists():
                    write_atomically(path, packed.read(name))


def machine(*packages: str) -> dict[str, str]:
    """Say what the figures were measured with: processor, Python, and the versions of packages that count."""
    versions = {name: version_of(name) for name in packages}
    cores, python = str(os.cpu_count()), platform.python_version()
    return {"cpu": this_machine().processor, "cpus": cores, "python": python, **versions}


def children_cpu() -> float:
    """Return the CPU time of the processes that this one started and waited for [s]."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def cpu_seconds() -> float:
    """Return the CPU time of this process and of those that it started and waited for [s]."""
    return time.process_time() + children_cpu()
