"""The machine that a run was made on: another processor, or other versions, may round otherwise."""

import functools
import platform
from pathlib import Path

import msgspec
import numpy as np

from neurosym.distribution import version_of

PACKAGES = ("numpy", "pybullet")
"""The packages whose arithmetic decides how a run goes."""
_CPUINFO = Path("/proc/cpuinfo")
_UNKNOWN = "unknown"


class Machine(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the last digits of a run may depend on besides its input.

    Attributes:
        processor: Model of the processor.
        instructions: The groups of vector instructions that numpy found on it.
        architecture: What kind of machine it is, like x86_64.
        system: Operating system, with its C library where it has one of its own.
        versions: Versions of Python and of the packages that compute, by name.
    """

    processor: str
    instructions: str
    architecture: str
    system: str
    versions: dict[str, str]

    def differences(self, other: "Machine") -> tuple[str, ...]:
        """Say in what another machine differs, as "processor: this one's and the other's"."""
        pairs = {
            name: (getattr(self, name), getattr(other, name))
            for name in ("processor", "instructions", "architecture", "system")
        }
        for name in sorted({*self.versions, *other.versions}):
            pairs[name] = (self.versions.get(name, _UNKNOWN), other.versions.get(name, _UNKNOWN))
        return tuple(f"{name}: {one} and {two}" for name, (one, two) in pairs.items() if one != two)


@functools.cache
def this_machine() -> Machine:
    """Return the machine that this process runs on; always the same as long as nothing is installed."""
    libc = " ".join(filter(None, platform.libc_ver()))
    return Machine(
        processor=_processor(),
        instructions=_instructions(),
        architecture=platform.machine() or _UNKNOWN,
        system=f"{platform.system()} {libc or platform.release()}".strip(),
        versions={"python": platform.python_version(), **{name: version_of(name) for name in PACKAGES}},
    )


def _processor() -> str:
    """Name the processor; names that clouds give are of whole families, so that its numbers are added."""
    try:
        lines = _CPUINFO.read_text(errors="replace").split("\n\n")[0].splitlines()
    except OSError:
        return platform.processor() or _UNKNOWN
    values = {name.strip(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
    numbers = {"family": "cpu family", "model": "model", "stepping": "stepping"}
    known = ", ".join(f"{word} {values[name]}" for word, name in numbers.items() if values.get(name))
    name = values.get("model name") or platform.processor() or _UNKNOWN
    return f"{name} ({known})" if known else name


def _instructions() -> str:
    found = np.show_config(mode="dicts").get("SIMD Extensions", {})
    return " ".join((*found.get("baseline", ()), *found.get("found", ())))
