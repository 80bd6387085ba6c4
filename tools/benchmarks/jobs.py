"""Jobs of an evaluation: each writes a file of its own, so that an interrupted run goes on where it was."""

import io
import json
import os
import platform
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


def nothing() -> None:
    """Report nothing."""


@dataclass(frozen=True)
class Evaluation:
    """An evaluation that goes on where it was interrupted: jobs in a working folder, and what came of them.

    Attributes:
        name: What its files are called.
        work: The working folder; its jobs lie in `jobs`.
        results: Folder for NAME.json, NAME.md, and NAME-records.zip, with which another machine goes on.
        workers: How many jobs are done at once.
    """

    name: str
    work: Path
    results: Path
    workers: int = 1

    def __post_init__(self) -> None:
        self.jobs.mkdir(parents=True, exist_ok=True)
        self.results.mkdir(parents=True, exist_ok=True)
        unpack(self.results / f"{self.name}-records.zip", self.jobs)

    @property
    def jobs(self) -> Path:
        """Folder of the jobs that are done."""
        return self.work / "jobs"

    def perform(
        self,
        jobs: Mapping[str, Job],
        label: str,
        report: Callable[[], None] = nothing,
        *,
        fresh: bool = False,
    ) -> None:
        """Do the jobs that were not done; see `perform`."""
        perform(self.jobs, jobs, self.workers, report, fresh=fresh, label=label)

    def found(self) -> dict[str, Any]:
        """Read what the jobs found that are done, by name."""
        return load_jobs(self.jobs)

    def write(self, summary: Any, page: str, *, records: bool = True) -> None:
        """Write what came of it: figures, a page, and the jobs themselves."""
        if records:
            pack(self.jobs, self.results / f"{self.name}-records.zip")
        write_atomically(self.results / f"{self.name}.json", as_text(summary))
        write_atomically(self.results / f"{self.name}.md", page)


def perform(
    folder: Path,
    jobs: Mapping[str, Job],
    workers: int,
    report: Callable[[], None],
    *,
    fresh: bool = False,
    label: str = "measuring",
) -> None:
    """Do the jobs that were not done, some at once, each to a file of its own.

    A job that fails is told of and left undone; the others go on.
    """
    left = {name: job for name, job in jobs.items() if not (folder / f"{name}.json").exists()}
    if not left:
        return
    pool = ProcessPoolExecutor(
        min(workers, len(left)), mp_context=get_context("spawn"), max_tasks_per_child=1 if fresh else None
    )
    with pool, progress_bar(label) as advance:
        running: dict[Future[Any], str] = {pool.submit(job): name for name, job in left.items()}
        try:
            for done, future in enumerate(as_completed(running), 1):
                _keep(folder / f"{running[future]}.json", future)
                report()
                advance(done, len(left))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _keep(path: Path, future: "Future[Any]") -> None:
    try:
        write_atomically(path, as_text(future.result()))
    except BrokenProcessPool:
        raise
    except Exception as error:
        say(f"{path.stem} failed: {type(error).__name__}: {error}")


def as_text(values: Any) -> str:
    """Print values as indented JSON, those of numpy, too."""
    return json.dumps(values, indent=1, default=lambda value: value.tolist()) + "\n"


def load_jobs(folder: Path) -> dict[str, Any]:
    """Read what the jobs found that are done, by name."""
    return {path.stem: json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))}


def pack(folder: Path, archive: Path, kind: str = "*.json") -> None:
    """Put the files of all jobs that are done into an archive; the same files give the same bytes."""
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
                path = folder / Path(name).name
                if not path.exists():
                    write_atomically(path, packed.read(name))


def machine(*packages: str) -> dict[str, str]:
    """Say what the figures were measured with: processor, Python, and the versions of packages that count."""
    versions = {name: version_of(name) for name in packages}
    cores, python = str(os.cpu_count()), platform.python_version()
    return {"cpu": this_machine().processor, "cpus": cores, "python": python, **versions}
