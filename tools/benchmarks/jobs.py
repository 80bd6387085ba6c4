"""Jobs of an evaluation: each writes a file of its own, so that an interrupted run goes on where it was."""

import io
import json
import os
import platform
import zipfile
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from neurosym.console import progress_bar, say
from neurosym.distribution import version_of
from neurosym.files import write_atomically

Job = Callable[[], Any]


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

    Args:
        folder: Where the files go.
        jobs: The jobs by name; each returns what JSON can hold.
        workers: How many at once.
        report: Called after each.
        fresh: Whether each job gets a process of its own, so that its memory can be told.
        label: What is shown beside the progress.
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
    """Print values as indented JSON."""
    return json.dumps(values, indent=1) + "\n"


def load_jobs(folder: Path) -> dict[str, Any]:
    """Read what the jobs found that are done, by name."""
    return {path.stem: json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))}


def pack(folder: Path, archive: Path, kind: str = "*.json") -> None:
    """Put the files of all jobs that are done into an archive; the same files give the same bytes.

    Args:
        folder: Where the files are.
        archive: A zip file.
        kind: Which files, as a pattern of names.
    """
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in sorted(folder.glob(kind)):
            packed.writestr(zipfile.ZipInfo(path.name), path.read_bytes(), zipfile.ZIP_DEFLATED)
    write_atomically(archive, content.getvalue())


def unpack(archive: Path, folder: Path) -> None:
    """Take from an archive what is not in the folder yet.

    Args:
        archive: A zip file that `pack` wrote, if there is one.
        folder: Where the files go.
    """
    if archive.exists():
        with zipfile.ZipFile(archive) as packed:
            for name in packed.namelist():
                path = folder / Path(name).name
                if not path.exists():
                    write_atomically(path, packed.read(name))


def machine(*packages: str) -> dict[str, str]:
    """Say what the figures were measured with.

    Args:
        packages: Those whose versions count.
    """
    versions = {name: version_of(name) for name in packages}
    return {"cpus": str(os.cpu_count()), "python": platform.python_version(), **versions}
