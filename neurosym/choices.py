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
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

from neurosym.errors import CannotWrite, NeurosymError, shortened

if TYPE_CHECKING:
    from threadpoolctl import ThreadpoolController

# What users choose among by name, and what is taken where they do not say; it imports next to nothing

TOLERANCE = 0.05
"""How near an object must come to its goal, and an outcome to its promise [m] (section III-E)."""
BUDGET = 4000
"""How often candidates and operators of one aim perform at most, if it is not said."""
ACTED, LOOKED = 2000, 4000
"""From so many random actions an eye learns, and from so many objects besides that it only looks at."""
CELL = 0.005  # edge of a grid cell unless the user says otherwise [m]
StrategyName = Literal["disagreement", "entropy", "curiosity", "random", "active"]
"""A way to explore; see `strategies`."""
DEFAULT_STRATEGY: StrategyName = "disagreement"
DEFAULT_PLANNER = "fast-downward"
EngineName = Literal["pybullet", "mujoco"]
"""What can simulate the tabletop, the default first."""
ENGINES: tuple[EngineName, ...] = get_args(EngineName)
TaskKind = Literal["anywhere", "swap", "row", "crowded"]  # what a task asks for; see `draw_task`
RelationTask = Literal["tower", "boxes", "unstack", "exchange"]
"""What a task of relations asks for; see `draw_relation_task`."""
AnyTask = TaskKind | RelationTask  # what a task may ask for
DrawnTask = Literal["anywhere", "swap", "row", "crowded", "tower", "boxes", "unstack", "exchange"]
"""What a task may ask for that needs no other scene."""


# The domains that come with neurosym. They are never written into: who uses one by its name gets a copy

DOMAINS = ("tabletop", "places", "towers", "camera", "tabletop-paper")  # the names of the shipped domains
_MADE_AGAIN = ("plans", "runs", "pictures")  # folders of a domain that hold what a user makes anew
_HERE = Path(__file__).parent
_HOMES = (_HERE / "shipped_domains", _HERE.parent / "domains")  # of an installed wheel, and of a checkout


def shipped_domain(name: str) -> Path | None:
    """Return where a shipped domain lies; None if there is none of that name."""
    homes = (home / name for home in _HOMES if name in DOMAINS and (home / name).is_dir())
    return next(homes, None)


def copy_shipped(name: str, folder: Path) -> bool:
    """Copy a shipped domain to a folder that does not exist, whole or not at all; say whether it exists."""
    if (source := shipped_domain(name)) is None:
        return False
    ignored = shutil.ignore_patterns(*_MADE_AGAIN)
    try:
        with tempfile.TemporaryDirectory(prefix=".neurosym-", dir=folder.absolute().parent) as draft:
            whole = Path(draft) / name
            shutil.copytree(source, whole, ignore=ignored, copy_function=shutil.copyfile)
            if not folder.exists():
                whole.rename(folder)
    except OSError as error:  # of which one that copies trees may hold many, each a triple
        first = error.args[0][0][2] if isinstance(error, shutil.Error) else error
        cause = first if isinstance(first, OSError) else OSError(0, str(first).rpartition("] ")[2])
        raise CannotWrite(folder, cause) from error
    return True


# Code of a user's own: `module:factory` names the function or class that makes a world, or a planner.
#
# A domain folder may come from a stranger, and its files say what is called. So no module is taken from
# inside the folder.

Invalid = Callable[[str, str], NeurosymError]
"""Makes the error for a factory's name and what is wrong with it."""
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


def one_line(text: str, longest: int = 200) -> str:
    """Keep of what somebody's own code says what can be printed, in one line of at most so many signs."""
    printable = "".join(sign if sign.isprintable() else " " for sign in text)
    return shortened(" ".join(printable.split()), longest)


def load_factory(name: str, invalid: Invalid) -> Any:
    """Import what a name, `module:factory`, names."""
    module_name, attribute = _split(name, invalid)
    module = _guarded(name, importlib.import_module, module_name, invalid)
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
    parts, inside = _split(name, invalid)[0].split("."), folder.resolve()
    search_here(folder)
    importlib.invalidate_caches()
    for depth in range(1, len(parts) + 1):  # looking for a.b imports a, which has been looked at by then
        spec = _guarded(name, importlib.util.find_spec, ".".join(parts[:depth]), invalid)
        if spec is None:
            stands_here = Path(f"{parts[0]}.py").is_file() or Path(parts[0]).is_dir()
            is_inside = stands_here and Path.cwd().is_relative_to(inside)
        else:
            files = [spec.origin] if spec.has_location and spec.origin else []
            places = (*files, *(spec.submodule_search_locations or ()))
            is_inside = any(Path(place).resolve().is_relative_to(inside) for place in places)
        if is_inside:
            wrong = f"has its code in the domain folder {folder}"
            raise invalid(name, f"{wrong}; a domain folder must not bring code of its own")
        if spec is None:
            raise _no_module(name, invalid)


def search_here(folder: Path) -> None:
    """Let modules be imported from the current folder too, unless it lies in a domain folder."""
    here = Path.cwd()
    if str(here) not in sys.path and not here.is_relative_to(folder.resolve()):
        sys.path.append(str(here))


def _split(name: str, invalid: Invalid) -> tuple[str, str]:
    if match := _NAME.fullmatch(name):
        return match[1], match[2]
    raise invalid(name, "is not of the form module:factory")


def _guarded(name: str, call: Callable[[str], Any], part: str, invalid: Invalid) -> Any:
    """Look for a part of a name's module by a call, and tell whatever its code raises."""
    try:
        return call(part)
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        module_name = name.partition(":")[0]
        if isinstance(error, ModuleNotFoundError) and f"{module_name}.".startswith(f"{error.name}."):
            raise _no_module(name, invalid) from error
        raise invalid(name, f"cannot be imported: {told(error)}") from error


def _no_module(name: str, invalid: Invalid) -> NeurosymError:
    module_name = name.partition(":")[0]
    said = f"no module {module_name!r} is installed or stands in the current folder"
    return invalid(name, f"cannot be found: {said}")


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
