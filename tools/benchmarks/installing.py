"""What installing takes, on each Python that runs here: `python -m tools.benchmarks.installing`.

A fresh clone is installed by `make install`, a fresh wheel by pip; then `neurosym demo` runs. No compiler is
at hand: `CC` and `CXX` name a program that fails. Goes on where it was interrupted, into docs/results/.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.console import say
from neurosym.files import write_atomically
from neurosym.markdown import markdown_table
from neurosym.reading import read_text
from tools.benchmarks.jobs import as_text
from tools.benchmarks.places import ROOT
from tools.benchmarks.world.evaluate import machine

RESULTS = Path("docs/results")
PYTHONS = ("python3.11", "python3.12", "python3.13")
WITHOUT_COMPILER = {"CC": "false", "CXX": "false"}
"""Programs that packages compile with; this one fails."""
_MEGABYTE = 1e6


def main(
    pythons: Annotated[tuple[str, ...], tyro.conf.arg(help="Interpreters to try.")] = PYTHONS,
    results: Annotated[Path, tyro.conf.arg(help="Folder for the table.")] = RESULTS,
    remark: Annotated[str, tyro.conf.arg(help="What to say of the machine, such as that it was busy.")] = "",
) -> None:
    """Install, run the demonstration, and write what it took; what was measured is not measured again."""
    path = results / "installing.json"
    kept: dict[str, Any] = json.loads(path.read_text()) if path.exists() else {}
    kept |= {"remark": remark} if remark else {}
    for python in pythons:
        if not _runs(python):
            say(f"{python} does not run here")
            continue
        for way, install in (("wheel", _from_wheel), ("clone", _from_clone)):
            if f"{python}, {way}" not in kept:
                kept[f"{python}, {way}"] = measured(partial(install, python))
                kept["machine"] = machine()
                write_atomically(path, as_text(kept))
    write_atomically(path, as_text(kept))
    write_atomically(results / "installing.md", page(kept))
    say(f"wrote {results / 'installing.md'}")


def measured(install: Callable[[Path], Path]) -> dict[str, float]:
    """Install into a folder, run the demonstration there, and say what both took.

    Args:
        install: Installs into a folder, and returns that of the virtual environment.
    """
    with tempfile.TemporaryDirectory() as name:
        begin = time.perf_counter()
        environment = install(Path(name))
        installed = time.perf_counter()
        _call(environment / "bin/neurosym", "demo", cwd=Path(name))
        done = time.perf_counter()
        size = sum(path.lstat().st_size for path in environment.rglob("*"))
    return {
        "install_seconds": round(installed - begin, 1),
        "demo_seconds": round(done - installed, 1),
        "environment_megabytes": round(size / _MEGABYTE),
    }


def page(kept: Mapping[str, Any]) -> str:
    """Write what was measured as a page.

    Args:
        kept: What was measured, by Python and way.
    """
    rows = [
        [name, *(f"{one[key]:g}" for key in ("install_seconds", "demo_seconds", "environment_megabytes"))]
        for name, one in kept.items()
        if name not in ("machine", "remark")
    ]
    about = (
        "`python -m tools.benchmarks.installing` wrote this page: a fresh clone with `make install`, or a "
        "fresh wheel with pip, and then `neurosym demo`. No compiler was at hand. Packages come from where "
        "pip finds them here, so seconds say little about another network. Clones bring what developers need."
    )
    about += f" {kept['remark']}" if "remark" in kept else ""
    head = ["installed", "install [s]", "demo [s]", "environment [MB]"]
    return f"# Installing\n\n{about}\n\n{markdown_table(head, rows)}\n"


def _from_wheel(python: str, folder: Path) -> Path:
    _call(sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, ROOT)
    environment = folder / "environment"
    _call(python, "-m", "venv", environment)
    wheel = next(folder.glob("*.whl"))
    _call(environment / "bin/pip", "install", "--constraint", ROOT / "constraints.txt", wheel)
    return environment


def _from_clone(python: str, folder: Path) -> Path:
    clone = folder / "clone"
    _call("git", "clone", "--quiet", ROOT, clone)
    _call("make", "install", f"PYTHON={shutil.which(python)}", cwd=clone)
    return clone / ".venv"


def _runs(python: str) -> bool:
    """Say whether an interpreter runs; a name on the path may be a stand-in."""
    try:
        return subprocess.run([python, "-c", ""], capture_output=True, check=False).returncode == 0
    except OSError:
        return False


def _call(*command: object, cwd: Path | None = None) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    with tempfile.NamedTemporaryFile(suffix=".log") as log:
        done = subprocess.run(
            [str(word) for word in command],
            stdout=log,
            stderr=subprocess.STDOUT,
            cwd=cwd,
            env=environment | WITHOUT_COMPILER,
            check=False,
        )
        assert done.returncode == 0, read_text(Path(log.name))[-2000:]


if __name__ == "__main__":
    tyro.cli(main)
