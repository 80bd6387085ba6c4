"""What is installed: the distribution that neurosym comes in, and the versions of others.

Installers write down what they install in folders beside the packages, whose names tell name and version.
These are read here, in a thousandth of the time that importing `importlib.metadata` takes.
"""

import os
import re
import sys
from functools import cache

from neurosym.errors import OtherLibrary

NAME = "neurosym-pddl"
"""The name under which neurosym is installed; on the package index, `neurosym` is another library."""
BUILDS = {"neurosym": (NAME,), "pybullet": ("pybullet", "pybullet-arm64")}
"""Distributions that bring a package, where their name is not its own, the first that is installed."""
_COMMAND = "neurosym.commands.cli:main"
_RECORD = re.compile(r"(?P<name>[^-]+)(?:-(?P<version>[^-]+)(?:-py\d[^-]*)?)?\.(?:dist|egg)-info")


def version_of(package: str) -> str:
    """Return the version of an installed package; "unknown" if it was not installed.

    Args:
        package: What it is imported as, or its distribution.
    """
    names = BUILDS.get(package, (package,))
    recorded = _recorded(tuple(sys.path))
    return next((recorded[name] for name in map(_canonical, names) if recorded.get(name)), "unknown")


def refuse_other_library() -> None:
    """Raise `OtherLibrary` if the library that the package index calls `neurosym` is installed beside ours.

    Ours once had that name, too; it is told by its command.
    """
    if "neurosym" not in _recorded(tuple(sys.path)):
        return
    from importlib.metadata import distribution

    other = distribution("neurosym")
    if not any(entry.value == _COMMAND for entry in other.entry_points):
        raise OtherLibrary(other.version, NAME)


@cache
def _recorded(places: tuple[str, ...]) -> dict[str, str]:
    """Return the versions of what is installed, by canonical name; the first folder that holds it counts."""
    found: dict[str, str] = {}
    for place in places:
        try:
            names = os.listdir(place or ".")  # noqa: PTH208 (as many as there are packages, and no more than names)
        except OSError:  # a zip file, or a folder that is gone
            continue
        for record in filter(None, map(_RECORD.fullmatch, sorted(names))):
            found.setdefault(_canonical(record["name"]), record["version"] or "")
    return found


def _canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
