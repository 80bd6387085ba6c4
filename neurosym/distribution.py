"""What is installed: the distribution that neurosym comes in, and the versions of others."""

from importlib.metadata import PackageNotFoundError, distribution, version

from neurosym.errors import OtherLibrary

NAME = "neurosym-pddl"
"""The name under which neurosym is installed; on the package index, `neurosym` is another library."""
BUILDS = {"neurosym": (NAME,), "pybullet": ("pybullet", "pybullet-arm64")}
"""Distributions that bring a package, where their name is not its own, the first that is installed."""
_COMMAND = "neurosym.commands.cli:main"


def version_of(package: str) -> str:
    """Return the version of an installed package; "unknown" if it was not installed.

    Args:
        package: What it is imported as, or its distribution.
    """
    for name in BUILDS.get(package, (package,)):
        try:
            return version(name)
        except PackageNotFoundError:
            continue
    return "unknown"


def refuse_other_library() -> None:
    """Raise `OtherLibrary` if the library that the package index calls `neurosym` is installed beside ours.

    Ours once had that name, too; it is told by its command.
    """
    try:
        other = distribution("neurosym")
    except PackageNotFoundError:
        return
    if not any(entry.value == _COMMAND for entry in other.entry_points):
        raise OtherLibrary(other.version, NAME)
