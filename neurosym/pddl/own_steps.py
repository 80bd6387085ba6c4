"""What differs by object, on a grid: steps are objects of PDDL, and a problem says whose step is which.

The domain stays the same for all. Its actions move an object by the step that a fact of the problem names
for this object, this move and this axis, and cost what a function of the problem says (`leading`). All
groundings whose operators keep their rehearsals are printed so; see `promises`.
"""

from collections.abc import Iterable

from neurosym.grounding import Grounding, is_lift
from neurosym.pddl.grid import AXES, Grid
from neurosym.pddl.moves import cost_name, move_constant, shifts_of
from neurosym.pddl.printing import comment
from neurosym.problems import Problem, SceneObject
from neurosym.promises import is_rehearsed, promised, why_unfit
from neurosym.tasks.moves import Move, moves_for, moves_of, step_cost

Step = tuple[int, int]
"""An axis, and how many cells further along it."""


def step_name(axis: int, cells: int) -> str:
    """Name a step along an axis, like `x-minus-7`; `x-plus-0` stays where it is."""
    return f"{AXES[axis]}-{'minus' if cells < 0 else 'plus'}-{abs(cells)}"


def steps_along(move: Move, axis: int) -> tuple[str, list[str]]:
    """Return the parameters by which `operators` moves objects along an axis, and what must hold of them."""
    letter = AXES[axis]
    leads = f"({letter}-leads {step_name(axis, move.cells[axis])} ?{letter} ?to-{letter})"
    return f" ?{letter} ?to-{letter} - {letter}-cell", [leads]


def constants(grounding: Grounding) -> list[str]:
    """List the steps that operators make on average, which the encoding `operators` names, and the moves."""
    names = " ".join(move_constant(move) for move in moves_of(grounding))
    return [*_declared(shifts_of(grounding)), *([f"    {names} - move"] if names else [])]


def predicates() -> list[str]:
    """List the predicates of steps: where each leads, which moves are for an object, and by which steps."""
    return [
        *(f"({axis}-leads ?s - {axis}-step ?from ?to - {axis}-cell)" for axis in AXES),
        "(can ?m - move ?o - movable)",
        *(f"({axis}-of ?m - move ?o - movable ?s - {axis}-step)" for axis in AXES),
    ]


def functions(moves: Iterable[Move]) -> list[str]:
    """List the functions that say what a move of an object costs."""
    return [f"({cost_name(move)} ?o - {move.category}) - number" for move in moves if has_cost(move)]


def has_cost(move: Move) -> bool:
    """Say whether a move can cost anything: all but putting down."""
    return move.kind != "put-down"


def declared_steps(problem: Problem, grounding: Grounding) -> list[str]:
    """Declare the steps that objects of a problem need beside those of the domain, a line for each axis."""
    return _declared(_needed(problem, grounding) - set(shifts_of(grounding)))


def leading(problem: Problem, grounding: Grounding, grid: Grid, margin: int) -> list[str]:
    """List from which cell to which the steps lead that a problem needs, a line for each step.

    Args:
        problem: The problem.
        grounding: The learned domain.
        grid: Its grid.
        margin: How many cells at either edge of the table no step may end in; staying is none.
    """
    lines = []
    for axis, cells in sorted(_needed(problem, grounding)):
        leads = f"{AXES[axis]}-leads {step_name(axis, cells)}"
        pairs = grid.shifts(axis, cells, margin if cells else 0)
        facts = (f"({leads} {grid.cell_name(axis, a)} {grid.cell_name(axis, b)})" for a, b in pairs)
        lines.append(" ".join(facts))
    return lines


def facts_of(item: SceneObject, grounding: Grounding, tolerance: float) -> list[str]:
    """List what the operators promise for an object, a line for each of its moves.

    Args:
        item: The object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    lines = about(item, grounding)
    moves = moves_for(item, grounding, tolerance)
    for move in moves:
        of_item = f"{move_constant(move)} {item.name}"
        steps = (f"({AXES[axis]}-of {of_item} {step_name(axis, move.cells[axis])})" for axis in move.all_axes)
        can = (
            [f"(can {of_item})", f"(= ({cost_name(move)} {item.name}) {move.cost})"] if has_cost(move) else []
        )
        lines.append(" ".join([*can, *steps]))
    left = left_alone(item, grounding, {move.name for move in moves})
    operators = promised(grounding, item, tolerance)
    values = (f"(= (cost-of-{name} {item.name}) {step_cost(operators[name], grounding)})" for name in left)
    return [*lines, *reasons(left, f"Not for {item.name}, so there are costs but no steps:"), *values]


def about(item: SceneObject, grounding: Grounding) -> list[str]:
    """Print the comment above what is promised for an object, if anything is.

    Args:
        item: The object.
        grounding: The learned domain.
    """
    if not any(operator.category == item.category for operator in grounding.live):
        return []
    features = " ".join(f"{value:.4g}" for value in item.features)
    said = [f"What each operator promises for {item.name} (features {features})."]
    if not is_rehearsed(grounding.category(item.category), item.features):
        said.append(f"{item.name} is unlike all that were rehearsed: it is promised what its category is.")
    return [comment(said, "    ").lstrip()]


def left_alone(item: SceneObject, grounding: Grounding, used: set[str]) -> dict[str, str]:
    """Say why operators of the domain are not for an object of their category, by name.

    Args:
        item: The object.
        grounding: The learned domain.
        used: Names of those that are.
    """
    of_item = promised(grounding, item)
    names = [one.name for one in grounding.live if one.category == item.category and one.name not in used]
    return {name: why_unfit(of_item[name], grounding) or "left out" for name in names}


def reasons(left: dict[str, str], about: str) -> list[str]:
    """Print the comment that says why operators are not for an object, if there are such.

    Args:
        left: Why not, by name.
        about: What is said before.
    """
    said = [about, *(f"{name}: {why}." for name, why in left.items())]
    return [comment(said, "    ").lstrip()] if left else []


def mean_levels(item: SceneObject, levels: Iterable[int], grounding: Grounding) -> set[int]:
    """Return where lifts end on average that end for an object at some of its own levels, and no others.

    Args:
        item: The object.
        levels: Heights, in cells above where it rests.
        grounding: The learned domain.
    """
    levels = set(levels)
    means = {operator.name: grounding.cells(operator)[2] for operator in grounding.live if is_lift(operator)}
    own = [(means[name], move.cells[2]) for name, move in lifts_of(item, grounding).items()]
    return {mean for mean, level in own if level in levels} - {level for _, level in own}


def lifts_of(item: SceneObject, grounding: Grounding) -> dict[str, Move]:
    """Return the lifts of an object by name."""
    return {m.name: m for m in moves_for(item, grounding) if m.kind == "lift"}


def _needed(problem: Problem, grounding: Grounding) -> set[Step]:
    """Return the steps of all objects, and those that operators make on average with such objects."""
    names = {grounding.category(item.category).name for item in problem.objects}
    own = [move for item in problem.objects for move in moves_for(item, grounding)]
    usual = [move for move in moves_of(grounding) if move.category in names]
    found = {(axis, move.cells[axis]) for move in own for axis in move.all_axes}
    return found | {(axis, move.cells[axis]) for move in usual for axis in move.axes}


def _declared(steps: Iterable[Step]) -> list[str]:
    ordered = sorted(steps)
    by_axis = ([step_name(*step) for step in ordered if step[0] == axis] for axis in range(3))
    return [f"    {' '.join(names)} - {AXES[axis]}-step" for axis, names in enumerate(by_axis) if names]
