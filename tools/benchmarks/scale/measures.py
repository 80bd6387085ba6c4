"""What sizes cost: CPU seconds and memory, each measured in a process of its own."""

import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from neurosym.errors import NeurosymError
from neurosym.learning.training_config import ModelConfig
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.syntax import ENCODINGS
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.sim.config import TabletopConfig
from neurosym.sim.tabletop import Tabletop
from neurosym.tasks.transition import validate
from tools.benchmarks.jobs import children_cpu, cpu_seconds
from tools.benchmarks.scale.made import made_domain, made_problem, write_data

PLANNERS = ("counting", "fast-downward")
CEILING = 1800.0  # when a planner is given up [s]

Results = dict[str, Any]
Value = TypeVar("Value")


def command(name: str, rows: int, *options: str) -> Results:
    """Measure a command on a data set."""
    with tempfile.TemporaryDirectory() as place:
        write_data(Path(place) / "interactions.npz", rows)
        typed = [sys.executable, "-m", "neurosym", name, place, *options]
        ended = subprocess.run(typed, capture_output=True, text=True, check=False)
    return {
        "code": ended.returncode,
        "cpu_seconds": round(children_cpu(), 1),
        "megabytes": _megabytes(resource.RUSAGE_CHILDREN),
        "said": [line for line in ended.stdout.splitlines() if line.startswith("R2")],
    }


def symbols(action_bits: int) -> Results:
    """Measure compiling a domain of so many bits, and planning with it for one object."""
    grounding, compiling = _timed(lambda: made_domain(action_bits, 1))
    texts, printing = _timed(lambda: [domain_text(grounding, encoding) for encoding in ENCODINGS])
    size = max(map(len, texts)) / 1e6
    told = {"compile_and_print": round(compiling + printing, 2), "domain_megabytes": round(size, 2)}
    return {"operators": len(grounding.live), **told, **_planned(action_bits, 1)}


def objects(count: int) -> Results:
    """Measure printing, reading and solving a problem with so many objects, each with a goal."""
    grounding = made_domain(3, count)
    problem = made_problem(grounding, count)
    text, printing = _timed(lambda: problem_text(problem, grounding))
    _, numeric = _timed(lambda: problem_text(problem, grounding, "numeric"))
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "crowd.scene.json"
        problem.save(path)
        _, reading = _timed(lambda: Problem.load(path))
    told = {"print": round(printing, 2), "print_numeric": round(numeric, 2), "read": round(reading, 3)}
    return {**told, "problem_megabytes": round(len(text) / 1e6, 2), **_planned(3, count)}


def _planned(action_bits: int, count: int) -> Results:
    grounding = made_domain(action_bits, count)
    problem = made_problem(grounding, count)
    found: Results = {}
    for planner in PLANNERS:
        result, seconds = _timed(lambda: plan(problem, grounding, planner=planner, time_limit=CEILING))  # noqa: B023
        valid = bool(result.steps) and validate(result.steps, problem, grounding).valid
        found[planner] = {
            "status": result.status.value,
            "cpu_seconds": round(seconds, 1),
            "steps": len(result.steps),
            "valid": valid,
            "reason": result.reason,
        }
    return {**found, "megabytes": _megabytes(resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)}


def refusals() -> Results:
    """Say in which words what is beyond the limits is refused."""
    world, rng = Tabletop(TabletopConfig()), np.random.default_rng(0)
    scene = made_problem(made_domain(3, 9), 9).scene()
    action = (world.action_box.low + world.action_box.high) / 2
    return {
        "10 bits of action symbols, to be learned": _refused(lambda: ModelConfig(action_bits=10)),
        "9 objects in the simulator": _refused(lambda: world.interact(scene, action, 0)),
        "1,000 objects to be drawn on the tabletop": _refused(lambda: world.sample_scene(rng, 1000)),
    }


def _refused(call: Callable[[], object]) -> str:
    try:
        call()
    except NeurosymError as error:
        return str(error)
    return "not refused"


def _timed(call: Callable[[], Value]) -> tuple[Value, float]:
    """Call something, and measure the CPU seconds of this process and of those that it waits for."""
    begin = cpu_seconds()
    value = call()
    return value, cpu_seconds() - begin


def _megabytes(*kinds: int) -> int:
    """Return the memory of the largest process [MB]."""
    return round(max(resource.getrusage(kind).ru_maxrss for kind in kinds) / 1024)
