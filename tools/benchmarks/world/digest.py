"""Do random interactions have the same bytes on another Python, or with another build of PyBullet?

The command is `python -m tools.benchmarks.world.digest`; run it on each, and compare what it prints.
"""

import hashlib
import platform
from importlib.metadata import PackageNotFoundError, version
from typing import Annotated

import numpy as np
import tyro

from neurosym.errors import BUILDS
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.console import say
from neurosym.world import Place


def main(
    count: Annotated[int, tyro.conf.arg(help="Interactions; every fifth is aimed at a place.")] = 500,
) -> None:
    """Print the Python, the build of PyBullet, and a digest of what the interactions did."""
    world, digest = Tabletop(), hashlib.sha256()
    for number in range(count):
        rng = np.random.default_rng(number)
        scene = world.sample_scene(rng, 1 + number % 3)
        place = Place(rng.uniform(*world.table.x), rng.uniform(*world.table.y)) if number % 5 == 0 else None
        outcome = world.interact(scene, world.action_box.sample(rng, 1)[0], 0, reference=place)
        for end in (outcome.lifted, outcome.end):
            digest.update(end.positions.tobytes() + end.orientations.tobytes())
    say(f"Python {platform.python_version()}, {_build()}, {count} interactions: {digest.hexdigest()[:16]}")


def _build() -> str:
    for name in BUILDS["pybullet"]:
        try:
            return f"{name} {version(name)}"
        except PackageNotFoundError:
            continue
    return "PyBullet of unknown origin"


if __name__ == "__main__":
    tyro.cli(main)
