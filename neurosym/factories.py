"""Code of a user's own: `module:factory` names the function or class that makes a world, or a planner.

A domain folder may come from a stranger, and its files say what is called. So no module is taken from inside
the folder.
"""

import importlib
import importlib.util
import re
import sys
from collections.abc import Callable
from functools import partial
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import Any

from neurosym.errors import NeurosymError, shortened

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
