"""What users choose by name: strategies, tasks, shipped domains, and code of their own."""

import importlib
import importlib.util
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, partial
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from neurosym.errors import CannotWrite, NeurosymError, shortened

if TYPE_CHECKING:
    from threadpoolctl import ThreadpoolController


# What users choose among by name, and what is taken where they do not say.
#
# It imports next to nothing, so that a command line is read without what it is about.

TOLERANCE = 0.05
"""How near an object must come to its goal, and an outcome to its promise [m] (section III-E)."""
CELL = 0.005
"""Edge of a grid cell unless the user says otherwise [m]."""
StrategyName = Literal["disagreement", "entropy", "curiosity", "random", "active"]
"""A way to explore; see `strategies`."""
DEFAULT_STRATEGY: StrategyName = "disagreement"
TaskKind = Literal["anywhere", "swap", "row", "crowded"]
"""What a task asks for; see `draw_task`."""
RelationTask = Literal["tower", "boxes", "unstack", "exchange", "like"]
"""What a task of relations asks for; see `draw_relation_task`."""
AnyTask = TaskKind | RelationTask
"""What a task may ask for."""
DrawnTask = Literal["anywhere", "swap", "row", "crowded", "tower", "boxes", "unstack", "exchange"]
"""What a task may ask for that needs no other scene."""


# The domains that come with neurosym. They are never written into: who uses one by its name gets a copy

DOMAINS = ("tabletop", "places", "towers", "tabletop-paper")
"""The names of the shipped domains."""
MADE_AGAIN = ("plans", "runs", "pictures")
"""Folders of a domain that hold what a user makes anew."""
_HERE = Path(__file__).parent
_HOMES = (_HERE / "shipped_domains", _HERE.parent / "domains")  # of an installed wheel, and of a checkout


def shipped_domain(name: str) -> Path | None:
    """Return where a shipped domain lies; None if there is none of that name.

    Args:
        name: Its name.
    """
    if name not in DOMAINS:
        return None
    return next((home / name for home in _HOMES if (home / name).is_dir()), None)


def copy_shipped(name: str, folder: Path) -> bool:
    """Copy a shipped domain to a folder that does not exist, whole or not at all; say whether there is one.

    Args:
        name: Its name.
        folder: Where to; a folder that somebody else makes meanwhile stays as it is.

    Raises:
        CannotWrite: If the system does not let it be written.
    """
    if (source := shipped_domain(name)) is None:
        return False
    draft = None
    try:
        draft = Path(tempfile.mkdtemp(prefix=".neurosym-", dir=folder.absolute().parent))
        whole = draft / name
        shutil.copytree(
            source, whole, ignore=shutil.ignore_patterns(*MADE_AGAIN), copy_function=shutil.copyfile
        )
        if not folder.exists():
            whole.rename(folder)
    except OSError as error:  # of which one that copies trees may hold many, each a triple
        first = error.args[0][0][2] if isinstance(error, shutil.Error) else error
        cause = first if isinstance(first, OSError) else OSError(0, str(first).rpartition("] ")[2])
        raise CannotWrite(folder, cause) from error
    finally:
        if draft:
            shutil.rmtree(draft, ignore_errors=True)
    return True


# Code of a user's own: `module:factory` names the function or class that makes a world, or a planner.
#
# A domain folder may come from a stranger, and its files say what is called. So no module is taken from
# inside the folder.

Invalid = Callable[[str, str], NeurosymError]
"""Makes the error for a factory's name and what is wrong with it."""
_LONGEST = 200
_NAME = re.compile(r"([^\W\d]\w*(?:\.[^\W\d]\w*)*):([^\W\d]\w*)")


def is_factory(name: str) -> bool:
    """Say whether a name is that of somebody's own, `module:factory`."""
    return ":" in name


def told(error: BaseException) -> str:
    """Tell an exception in one line of at most 200 characters, without a full stop."""
    kind = type(error).__name__
    try:
        text = one_line(str(error)).rstrip(".")
    except Exception:  # an exception of somebody's own may not even say what it is
        return kind
    return f"{kind}: {text}" if text else kind


def one_line(text: str, longest: int = _LONGEST) -> str:
    """Keep of what somebody's own code says what can be printed, in one line.

    Args:
        text: What it says.
        longest: How many characters the line has at most.
    """
    printable = "".join(sign if sign.isprintable() else " " for sign in text)
    return shortened(" ".join(printable.split()), longest)


def load_factory(name: str, invalid: Invalid) -> Any:
    """Import what a name names.

    Args:
        name: `module:factory`.
        invalid: Makes the error if there is none.
    """
    module_name, attribute = _split(name, invalid)
    module = _guarded(name, module_name, partial(importlib.import_module, module_name), invalid)
    if not hasattr(module, attribute):
        raise invalid(name, f"cannot be found: the module {module_name!r} has no {attribute!r}")
    return getattr(module, attribute)


def admit(name: str, folder: Path, invalid: Invalid) -> None:
    """Let a module be imported from the current folder too, but not from inside a domain folder.

    Worker processes inherit the search path.

    Args:
        name: `module:factory`.
        folder: The domain folder.
        invalid: Makes the error if the module is not found, or lies in the domain folder.
    """
    module_name, _ = _split(name, invalid)
    inside = folder.resolve()
    search_here(folder)
    importlib.invalidate_caches()
    parts = module_name.split(".")
    for depth in range(1, len(parts) + 1):
        part = ".".join(parts[:depth])  # looking for a.b imports a, which has been looked at by then
        spec = _guarded(name, module_name, partial(importlib.util.find_spec, part), invalid)
        is_inside = spec is None and Path.cwd().is_relative_to(inside) and _stands_here(parts[0])
        if is_inside or (spec and any(place.is_relative_to(inside) for place in _places(spec))):
            raise invalid(
                name,
                f"has its code in the domain folder {folder}; a domain folder must not bring code of its own",
            )
        if spec is None:
            raise _no_module(name, module_name, invalid)


def search_here(folder: Path) -> None:
    """Let modules be imported from the current folder too, unless it lies in a domain folder.

    Args:
        folder: The domain folder.
    """
    here = Path.cwd()
    if str(here) not in sys.path and not here.is_relative_to(folder.resolve()):
        sys.path.append(str(here))


def _split(name: str, invalid: Invalid) -> tuple[str, str]:
    match = _NAME.fullmatch(name)
    if match is None:
        raise invalid(name, "is not of the form module:factory")
    return match[1], match[2]


def _guarded(name: str, module_name: str, call: Callable[[], Any], invalid: Invalid) -> Any:
    try:
        return call()
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        if isinstance(error, ModuleNotFoundError) and f"{module_name}.".startswith(f"{error.name}."):
            raise _no_module(name, module_name, invalid) from error
        raise invalid(name, f"cannot be imported: {told(error)}") from error


def _no_module(name: str, module_name: str, invalid: Invalid) -> NeurosymError:
    return invalid(
        name, f"cannot be found: no module {module_name!r} is installed or stands in the current folder"
    )


def _stands_here(module: str) -> bool:
    """Say whether the current folder has a module of that name."""
    return Path(f"{module}.py").is_file() or Path(module).is_dir()


def _places(spec: ModuleSpec) -> list[Path]:
    files = [spec.origin] if spec.has_location and spec.origin else []
    return [Path(place).resolve() for place in (*files, *(spec.submodule_search_locations or ()))]


# In how many threads small matrices are computed: in one.
#
# Several would wait for one another much longer than they compute: 356 decompositions of matrices of a
# hundred rows took 5.2 s of CPU on two threads, and 0.08 s on one.

_VARIABLE = "OPENBLAS_NUM_THREADS"  # of what numpy computes with; networks compute with something else


def compute_in_one_thread() -> None:
    """Have numpy compute in one thread, in this process and those it starts, unless the user says how many.

    It is said before numpy is imported, which takes half the time then.
    """
    os.environ.setdefault(_VARIABLE, "1")


@contextmanager
def one_thread() -> Iterator[None]:
    """Have numpy compute in one thread meanwhile, however it was imported."""
    if os.environ.get(_VARIABLE) == "1":
        yield
        return
    with _controller().limit(limits=1, user_api="blas"):
        yield


@cache
def _controller() -> "ThreadpoolController":
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
