"""How the files of a domain folder came about: the stages that made them, and a record of each."""

import platform
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import msgspec

from neurosym.distribution import version_of
from neurosym.errors import InvalidValue


class StageRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the files of one stage came about.

    Attributes:
        options: What the stage was asked for.
        inputs: SHA-256 of each file it read, by name.
        outputs: SHA-256 of each file it wrote, by name.
        seconds: How long it took, in the last session that worked on it [s].
        versions: Versions of Python and of the packages that decide the outcome.
    """

    options: dict[str, Any]
    inputs: dict[str, str]
    outputs: dict[str, str]
    seconds: float
    versions: dict[str, str]


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The stages that made a domain folder, by name."""

    stages: dict[str, StageRecord] = {}


class Claim(IntEnum):
    """How a stage has the folder while it works; each includes those before it."""

    NONE = 0
    """It looks at what is there, which changes whole files at a time."""
    SHARED = 1
    """It adds to what was learned: several can at the same time, while nobody learns."""
    ALONE = 2
    """It learns: what others would read changes."""


@dataclass(frozen=True, slots=True)
class Stage:
    """One step of the way: what it reads, what it writes, and the work itself.

    Attributes:
        name: The command's name, with the problem's where there is one.
        inputs: Files it reads, relative to the folder.
        outputs: Files it writes, relative to the folder.
        work: Does the work.
        options: What decides the outcome beside the inputs.
        claim: How it has the folder meanwhile.
        renews: Files of other stages that it may write anew; they still count as made by those.
    """

    name: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    work: Callable[[], None]
    options: dict[str, Any] = field(default_factory=dict)
    claim: Claim = Claim.SHARED
    renews: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.options.get("seed", 0) < 0:
            raise InvalidValue(f"seed = {self.options['seed']} must be at least 0.")


def versions() -> dict[str, str]:
    """Return the versions of Python and of the packages that decide what is learned."""
    packages = ("neurosym", "numpy", "pybullet", "torch", "up-fast-downward")
    return {"python": platform.python_version(), **{name: version_of(name) for name in packages}}


def rehearsal_options(manifest: Manifest) -> tuple[int, int]:
    """Return how many objects rehearsal sampled, and where its draws started.

    Args:
        manifest: How the files of the domain folder came about.
    """
    distilled = manifest.stages.get("distill")
    options = distilled.options if distilled else {}
    return options.get("objects", 100), options.get("seed", 0)
