"""How much CPU an interaction takes beside that of an earlier version and in MuJoCo, and where things end."""

import io
import json
import math
import os
import subprocess
import sys
import tarfile
from pathlib import Path
from typing import Any

from tools.benchmarks.options import ROOT

BEFORE = "708e746f"
"""The version that simulated every motion of the hand."""
_INTERACTIONS, _BLOCK, _SEED = 300, 10, 4545
_CHILD = """
import sys, time, json
from neurosym.sim.tabletop import Tabletop, TabletopConfig
from tools.benchmarks.world.measures import random_tasks
world = Tabletop(TabletopConfig({options}))
tasks = random_tasks({count}, {seed}, world=world)
world.interact(tasks[0].scene, tasks[0].action, 0)
for line in sys.stdin:
    few, begin = tasks[int(line) : int(line) + {block}], time.process_time()
    ends = [world.interact(one.scene, one.action, 0).end.positions[0].tolist() for one in few]
    print(json.dumps([time.process_time() - begin, ends]), flush=True)
"""


def compare(work: Path) -> dict[str, Any]:
    """Perform the same random actions in both versions, and in MuJoCo, some at a time in turn."""
    former = work / "former"
    former.mkdir(exist_ok=True, parents=True)
    packed = subprocess.run(
        ["git", "archive", BEFORE, "neurosym", "tools"], cwd=ROOT, check=True, capture_output=True
    )
    with tarfile.open(fileobj=io.BytesIO(packed.stdout)) as archive:
        archive.extractall(former, filter="data")
    children = [_child(ROOT), _child(former), _child(ROOT, 'engine="mujoco"')]
    seconds, ends = [0.0] * 3, ([], [], [])  # type: tuple[list[float], tuple[list[Any], ...]]
    for first in range(0, _INTERACTIONS, _BLOCK):
        for number, child in enumerate(children):
            assert child.stdin, "a pipe"
            assert child.stdout, "a pipe"
            child.stdin.write(f"{first}\n")
            child.stdin.flush()
            took, found = json.loads(child.stdout.readline())
            seconds[number] += took
            ends[number].extend(found)
    for child in children:
        child.communicate()
    apart = [math.dist(one, other) for one, other in zip(*ends[:2], strict=True)]
    return {
        "ratio": seconds[0] / seconds[1],
        "mujoco": seconds[2] / seconds[0],
        "ms": [1000 * one / _INTERACTIONS for one in seconds],
        "ends_apart": {
            f"{1000 * most:g} mm": sum(one > most for one in apart) / len(apart)
            for most in (1e-4, 1e-3, 1e-2)
        },
        "interactions": _INTERACTIONS,
        "before": BEFORE,
    }


def _child(folder: Path, options: str = "") -> subprocess.Popen[str]:
    code = _CHILD.format(count=_INTERACTIONS, seed=_SEED, block=_BLOCK, options=options)
    environment = {**os.environ, "PYTHONPATH": str(folder.absolute()), "OMP_NUM_THREADS": "1"}
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    return subprocess.Popen([sys.executable, "-c", code], cwd=folder, env=environment, text=True, **pipes)
