"""What is installed from a wheel works in an empty folder, away from the repository.

The environment is fresh but for the packages that neurosym needs, which are those of this one.
"""

import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest
from places import ROOT

from neurosym.choices import DOMAINS


def completed(*command: object, **options: object) -> subprocess.CompletedProcess[str]:
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, env=kept, timeout=600, **options
    )


@pytest.fixture(scope="module")
def built(tmp_path_factory) -> Path:
    """The folder of an sdist, and of the wheel that was made from it."""
    folder = tmp_path_factory.mktemp("built")
    done = completed(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, ROOT)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.fixture(scope="module")
def environment(built, tmp_path_factory) -> Path:
    """The folder of the programs of an environment into which the wheel was installed."""
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder, with_pip=False, symlinks=os.name != "nt")
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    python = programs / Path(sys.executable).name
    python = python if python.exists() else programs / "python"
    site = completed(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").stdout.strip()
    (Path(site) / "needed.pth").write_text(sysconfig.get_path("purelib") + "\n")
    pip = (sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-deps")
    done = completed(*pip, next(built.glob("*.whl")))
    assert done.returncode == 0, done.stderr
    return programs


@pytest.fixture
def neurosym(environment, tmp_path):
    """Call the installed command in an empty folder."""
    program = environment / "neurosym"
    return lambda *arguments: completed(program, *arguments, cwd=tmp_path)


def test_archives_hold_what_is_needed_and_are_what_the_package_index_takes(built):
    wheel, sdist = sorted(built.iterdir(), key=lambda path: path.suffix, reverse=True)
    assert completed(sys.executable, "-m", "twine", "check", "--strict", wheel, sdist).returncode == 0
    judged = completed(sys.executable, "-m", "check_wheel_contents", wheel, cwd=ROOT)
    assert judged.returncode == 0, judged.stdout
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    package = {path.relative_to(ROOT).as_posix() for path in (ROOT / "neurosym").rglob("*") if path.is_file()}
    assert {name for name in package if "__pycache__" not in name} <= names
    assert {f"neurosym/shipped_domains/{domain}/grounding.json" for domain in DOMAINS} <= names
    assert not [name for name in names if "/plans/" in name or "/runs/" in name]
    with tarfile.open(sdist) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {"hatch_build.py", "Makefile", "tests/places.py", "domains/tabletop/grounding.json"} <= names


def test_shipped_domain_is_named_by_its_name_and_copied_before_it_is_used(neurosym, environment, tmp_path):
    done = neurosym("plan", "tabletop", "task-01")
    assert done.returncode == 0, done.stderr
    assert "copied the shipped domain tabletop to the folder tabletop;" in done.stdout
    plan = Path("tabletop") / "plans" / "task-01.fast-downward.plan"
    assert (tmp_path / plan).is_file()
    executed = neurosym("execute", "tabletop", "task-01", plan)
    assert executed.returncode == 0, executed.stdout + executed.stderr
    assert "copied" not in executed.stdout
    home = next(environment.parent.rglob("shipped_domains/tabletop"))
    assert not (home / "plans").exists()
    assert (home / "manifest.json").read_bytes() != (tmp_path / "tabletop" / "manifest.json").read_bytes()


def test_unknown_domain_is_refused_and_says_which_come_along(neurosym, tmp_path):
    done = neurosym("explain", "tabeltop")
    assert done.returncode == 2
    assert "the shipped domain is called tabletop" in " ".join(done.stderr.split())
    assert not list(tmp_path.iterdir())
    done = neurosym("plan", "tabletop", "task-01", "--output", "-")
    assert all(line.startswith("(") for line in done.stdout.splitlines()), "no word about the copy"


def test_other_library_of_the_same_name_is_named_in_one_sentence(neurosym, environment):
    site = next(environment.parent.rglob("needed.pth")).parent
    other = site / "neurosym-0.0.90.dist-info"
    other.mkdir()
    (other / "METADATA").write_text("Metadata-Version: 2.1\nName: neurosym\nVersion: 0.0.90\n")
    try:
        done = neurosym("planners")
        assert done.returncode == 2
        assert "Another library called neurosym (version 0.0.90)" in " ".join(done.stderr.split())
    finally:
        shutil.rmtree(other)


@pytest.mark.evaluation
def test_demonstration_and_page_are_made_without_the_repository(neurosym, tmp_path):
    shown = neurosym("demo")
    assert shown.returncode == 0, shown.stdout + shown.stderr
    assert [path.name for path in (tmp_path / "demo").glob("*.gif")] == ["swap-2-07.gif"]
    assert "read demo/places/domain.pddl" in " ".join(shown.stdout.split())
    reported = neurosym("report", Path("demo") / "places")
    assert reported.returncode == 0, reported.stderr
    assert (tmp_path / "demo" / "places" / "report.html").stat().st_size > 1e6
