"""Pictures of plans for an editor: what the extension "PDDL" of Visual Studio Code (Jan Dolejsi) reads.

Beside a domain `NAME.pddl` it reads `NAME.planviz.json`. That names a script, whose value has functions that
turn a plan, or a state, into HTML. The script may load nothing, so it holds the scenes of all problems:
PDDL says in which cell or at which place an object stands, but not how large it is, nor where places lie.
"""

import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import msgspec

from neurosym.errors import NeurosymError
from neurosym.grounding import Grounding
from neurosym.pddl import strips
from neurosym.pddl.grid import check_on_table, grid_of
from neurosym.pddl.strips_problem import printed_cell
from neurosym.problems import Problem, SceneObject
from neurosym.reading import read_text
from neurosym.tasks.places import START
from neurosym.tasks.task import understand

SCRIPT = "planviz.js"
"""What the script is called; it lies in the folder of the domains."""
PlanvizScene = dict[str, Any]
"""What PDDL does not say of a problem."""
_PROGRAM = Path(__file__).with_suffix(".js")
_SCENES = "(/* scenes */ {})"  # where it takes them
_UNKNOWN_SIZE = (0.04, 0.04)  # of objects whose features are no lengths [m]


def planviz_json() -> str:
    """Return the configuration that names the script, the same for each domain.

    It also hides steps that only note something, and the cells and places among the rows of the time line.
    """
    hidden = [strips.MOVE_X, strips.MOVE_Y, strips.REACH_CELL, strips.REACH_LIFTED, strips.REACH_PLACE]
    hidden += [strips.NOTE_CLEAR, strips.LEAVE]
    configuration = {
        "customVisualization": SCRIPT,
        "excludeActions": [*(f"^{name}$" for name in sorted(hidden))],
        "ignoreActionParameters": [{"action": ".+", "parameterPattern": "^(?!o$)"}],
    }
    return msgspec.json.format(msgspec.json.encode(configuration), indent=2).decode() + "\n"


def planviz_script(
    grounding: Grounding, problems: Iterable[Problem], known: Mapping[str, PlanvizScene] | None = None
) -> str:
    """Return the script, with the scenes of some problems; those that cannot be drawn are left out.

    Args:
        grounding: The learned domain.
        problems: The problems.
        known: Scenes that an earlier script for the same domain holds; see `scenes_of`.
    """
    scenes = dict(known or {})
    for problem in problems:
        try:
            scenes[problem.name] = _scene(problem, grounding)
        except NeurosymError:
            scenes.pop(problem.name, None)
    table = {"x": _millimetres(grounding.table.x), "y": _millimetres(grounding.table.y)}
    data = {"table": table, "problems": scenes}
    text = msgspec.json.encode(data, order="deterministic").decode()
    before, after = _program()
    return f"{before}({text}){after}"


def scenes_of(script: str) -> dict[str, PlanvizScene]:
    """Return the scenes that a script holds, by problem; none if it is no such script.

    Args:
        script: The script.
    """
    before, after = _program()
    if not (script.startswith(f"{before}(") and script.endswith(f"){after}")):
        return {}
    data = script.removeprefix(f"{before}(").removesuffix(f"){after}")
    try:
        return msgspec.json.decode(data, type=_Data).problems
    except (msgspec.DecodeError, RecursionError):
        return {}


class _Data(msgspec.Struct):
    problems: dict[str, PlanvizScene]


def _program() -> tuple[str, str]:
    """Return what stands before the scenes and after them."""
    before, after = read_text(_PROGRAM).split(_SCENES)
    return before, after


def _scene(problem: Problem, grounding: Grounding) -> PlanvizScene:
    """Return how large objects and cells are, and where all is: lengths in metres, angles in degrees."""
    task = understand(problem, grounding)
    cells = msgspec.structs.replace(grounding, cell=printed_cell(task))
    starts = {f"{START}{item.name}": item.position[:2] for item in problem.objects}
    return {
        "cell": cells.cell,
        "objects": {item.name: _object(item, cells) for item in problem.objects},
        "goals": {name: _millimetres(goal[:2]) for name, goal in problem.goals.items()},
        "places": {name: _millimetres(spot) for name, spot in {**starts, **task.places}.items()},
    }


def _object(item: SceneObject, grounding: Grounding) -> dict[str, Any]:
    check_on_table(item, grounding)
    x, y, z, w = item.orientation
    turn = math.degrees(math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    return {
        "size": _millimetres(_size(item, grounding)),
        "at": _millimetres(item.position[:2]),
        "cell": grid_of(grounding).anchor(item.position)[:2],
        "turn": round(turn, 1) + 0.0,
    }


def _size(item: SceneObject, grounding: Grounding) -> tuple[float, ...]:
    """Return an object's extent along x and y: its first two features, if they can be that [m]."""
    widest = max(high - low for low, high in (grounding.table.x, grounding.table.y))
    size = item.features[:2]
    is_size = len(size) == len(_UNKNOWN_SIZE) and all(0 < length < widest for length in size)
    return size if is_size else _UNKNOWN_SIZE


def _millimetres(lengths: Iterable[float]) -> list[float]:
    """Round lengths to a tenth of a millimetre [m]."""
    return [round(length, 4) + 0.0 for length in lengths]
