"""One net under everything: digests of what the commands print, draw, plan and run.

What is only moved or merged leaves every digest as it is. `python tests/test_net.py` writes them anew: look
at each line that changes then. Metres are rounded to millimetres: the simulator differs a little elsewhere.
Where an arm pushes, that can be more: what shipped domains do, and what two of them draw, is compared only on
processors like that on which it was written, which lacks some instructions.
"""

import hashlib
import json
import shutil
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
import pytest
import toy_domain
import toy_places
import toy_relations
from command_line import neurosym
from places import GOLDEN, ROOT

from neurosym.execution.executor import execute
from neurosym.execution.record import this_machine
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.planners import plan

DIGESTS = GOLDEN / "net.json"
SHIPPED = {
    "tabletop": ("--objects", 1, "--actions", 2),
    "tabletop-paper": ("--objects", 1, "--actions", 1),
    "places": ("--objects", 4, "--task", "row"),
    "towers": ("--objects", 4, "--task", "tower"),
    "camera": ("--objects", 2, "--task", "swap"),
}
"""What is asked for in a new problem of each shipped domain."""
PUSHED = {name: {"new-problem", "execute"} for name in ("tabletop", "tabletop-paper")}
PUSHED |= {name: {"execute"} for name in ("places", "towers")}
PUSHED |= {"camera": {"new-problem", "execute", "fast-downward", "lama-first", "bfs", "bfs-operators"}}
WRITTEN_WITHOUT = "X86_V4"
TOYS = {
    "toy": (toy_domain.WORLD, toy_domain.grounding, toy_domain.problem({"item-01": (0.68, 0.16, 0.025)})),
    "toy-places": (toy_domain.WORLD, toy_places.grounding, toy_places.swap()),
    "toy-relations": (toy_relations.WORLD, toy_relations.grounding, toy_relations.tower()),
}
PLANNERS = ("fast-downward", "lama-first", "bfs", "bfs-operators")


def rounded(value: object) -> object:
    """Round all numbers of a JSON value to three decimals, and leave out the machine and the time."""
    if isinstance(value, float):
        return round(value, 3) + 0.0
    if isinstance(value, list):
        return [rounded(one) for one in value]
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items() if k not in ("machine", "seconds", "deviation")}
    return value


def of_shipped(name: str, folder: Path) -> Iterator[tuple[str, str]]:
    """What the commands make in a copy of a shipped domain."""
    shutil.copytree(ROOT / "domains" / name, folder)
    assert neurosym("compile-domain", folder) == 0
    for pattern in ("*.pddl", "problems/*.numeric.pddl", "problems/*.pddl"):
        yield pattern, "".join(file.read_text() for file in sorted(folder.glob(pattern)))
    assert neurosym("new-problem", folder, "--name", "net", "--seed", 11, *SHIPPED[name]) == 0
    yield "new-problem", (folder / "problems/net.scene.json").read_text()
    for planner in PLANNERS:
        code = neurosym("plan", folder, "net", "--planner", planner)
        file = folder / f"plans/net.{planner}.plan"
        yield planner, f"{code} {file.read_text() if file.exists() else ''}"
    code = neurosym("execute", folder, "net", folder / "plans/net.fast-downward.plan")
    (run,) = folder.glob("runs/net.*.run.json")
    yield "execute", f"{code} {json.dumps(rounded(json.loads(run.read_text())))}"
    yield "replay", str(neurosym("replay", folder, run))


def of_toy(name: str, _: Path) -> Iterator[tuple[str, str]]:
    """What is printed, planned and done in a toy domain."""
    world, learned, problem = TOYS[name]
    grounding = learned()
    yield "domain", domain_text(grounding)
    yield "problem", problem_text(problem, grounding)
    for planner in PLANNERS:
        yield planner, str(plan(problem, grounding, planner).steps)
    steps = plan(problem, grounding).steps
    yield "plan", ground_plan(steps, problem, grounding).text
    run = execute(world, problem, grounding, steps)
    yield "execute", json.dumps(rounded(msgspec.to_builtins(run)))


def caught(what: Callable[[str, Path], Iterator[tuple[str, str]]], name: str, folder: Path) -> dict[str, str]:
    """Digests of what is made, by the names of it."""
    return {key: hashlib.sha256(text.encode()).hexdigest()[:16] for key, text in what(name, folder)}


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_domain_gives_what_it_gave(name: str, tmp_path: Path):
    now, before = caught(of_shipped, name, tmp_path / name), json.loads(DIGESTS.read_text())[name]
    apart = {key for key in before | now if now.get(key) != before.get(key)}
    is_alike = WRITTEN_WITHOUT not in this_machine().instructions
    assert apart <= (set() if is_alike else PUSHED.get(name, set()))


@pytest.mark.parametrize("name", TOYS)
def test_toy_domain_gives_what_it_gave(name: str, tmp_path: Path):
    assert caught(of_toy, name, tmp_path) == json.loads(DIGESTS.read_text())[name]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        found = {name: caught(of_shipped, name, Path(place) / name) for name in SHIPPED}
    found |= {name: caught(of_toy, name, Path()) for name in TOYS}
    DIGESTS.write_text(json.dumps(found, indent=1) + "\n")
