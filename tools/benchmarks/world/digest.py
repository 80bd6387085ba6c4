"""Do random interactions have the same bytes on another Python, or with another build of PyBullet?

The command is `python -m tools.benchmarks.world.digest`; run it on each, and compare what it prints.
"""

import hashlib
import platform
from importlib.metadata import distributions
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
    builds = [one for one in distributions() if one.metadata["Name"] in BUILDS["pybullet"]]
    build = f"{builds[0].metadata['Name']} {builds[0].version}" if builds else "PyBullet of unknown origin"
    say(f"Python {platform.python_version()}, {build}, {count} interactions: {digest.hexdigest()[:16]}")


if __name__ == "__main__":
    tyro.cli(main)
