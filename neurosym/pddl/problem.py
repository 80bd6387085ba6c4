"""Printing a problem as PDDL; one text serves both encodings on a grid, another the numeric one."""

import math
import re
from collections.abc import Sequence
from functools import lru_cache

import msgspec

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl import own_steps
from neurosym.pddl.compiler import names_of_relations
from neurosym.pddl.grid import AXES, Grid, check_on_table, goal_region, grid_of
from neurosym.pddl.ground_plan import GroundPlan
from neurosym.pddl.moves import (
    BY_RELATIONS,
    MOVE,
    PLACES,
    REACH_GOAL,
    Encoding,
    carrier,
    domain_name,
    shift_predicate,
    shifts_of,
)
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_problem_text
from neurosym.pddl.place_domain import NOTES
from neurosym.pddl.place_problem import declared, facts, led_objects
from neurosym.pddl.printing import comment
from neurosym.pddl.relational_problem import relational_problem_text
from neurosym.problems import Problem, SceneObject
from neurosym.spots import SPOT
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.places import with_places

STEPS = 1
"""How many steps the rounding of is reckoned with, unless the caller says otherwise.

More would be safer, but smaller goals make plans longer or impossible; a replay tells when it matters.
"""


def problem_text(
    problem: Problem,
    grounding: Grounding,
    encoding: Encoding = "stepwise",
    *,
    steps: int = STEPS,
    margin: int = 0,
    plans: Sequence[GroundPlan] = (),
) -> str:
    """Print a problem.

    Args:
        problem: The problem.
        grounding: The learned domain.
        encoding: The encoding of the domain it is for; `stepwise` and `operators` share a text.
        steps: How many steps the rounding of is taken off the goal regions. For `numeric` it is that of ten
            times as many, which is still less.
        margin: How many cells at either edge of the table no step may end in.
        plans: Plans that the replay takes, and that stand beside the problem: it is printed such that they
            are its plans.

    Raises:
        InvalidValue: If an object stands off the table, or its name means something else in the domain.
        UnknownChoice: If an object is of a category that the domain does not have.
    """
    grid = grid_of(grounding)
    for item in problem.objects:
        check_object(item, grounding)
    if encoding in BY_RELATIONS:
        return relational_problem_text(problem, grounding, encoding)
    if encoding == "numeric":
        return numeric_problem_text(problem, grounding, steps=steps * NUMERIC_STEPS)
    if encoding == PLACES:
        return _place_problem(with_places(problem, grounding), grounding, grid, steps, margin, plans)
    sections = [
        _header(problem, grounding, steps),
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, encoding)})",
        _objects(problem, grounding, grid),
        "  (:init\n    (hand-empty) (ready) (= (total-cost) 0)",
        *(_start(item, grid) for item in problem.objects),
        *(_goal_facts(problem, name, grounding, grid, steps) for name in sorted(problem.goals)),
        *_step_facts(problem, grounding, grid, margin),
    ]
    return _ended(sections, problem, plans)


def _place_problem(
    problem: Problem,
    grounding: Grounding,
    grid: Grid,
    steps: int,
    margin: int,
    plans: Sequence[GroundPlan],
) -> str:
    """Print a problem whose objects are carried as far as they can be; only the others need cells."""
    names = led_objects(problem, grounding)
    headers = [
        _place_header(problem, grounding),
        *([_grid_header(problem, grounding, steps)] if names else []),
    ]
    sections = [
        "\n".join(headers),
        f"(define (problem {problem.name})\n  (:domain {domain_name(grounding, PLACES)})",
        "\n".join(["  (:objects", *_item_objects(problem, grounding), declared(problem), *_spots(plans)]),
        "  (:init\n    (hand-empty) (ready) (= (total-cost) 0)",
        *(f"    {line}" for line in facts(problem, grounding)),
    ]
    if names:
        items, goals = (
            tuple(problem.object_named(name) for name in names),
            {name: problem.goals[name] for name in names},
        )
        led = msgspec.structs.replace(problem, objects=items, goals=goals)
        sections[2] = "\n".join([sections[2], *_grid_objects(led, grounding, grid)])
        sections += [_start(item, grid) for item in items]
        sections += [_goal_facts(led, name, grounding, grid, steps) for name in names]
        sections += _step_facts(led, grounding, grid, margin)
    sections[2] += ")"
    return _ended(sections, problem, plans)


def _spots(plans: Sequence[GroundPlan]) -> list[str]:
    """Declare the spots that plans use."""
    names = sorted({name for plan in plans for name in plan.spots})
    return [f"    {' '.join(names)} - place"] if names else []


def _for_plans(plans: Sequence[GroundPlan], text: str) -> list[str]:
    """Print what plans beside the problem need, and what the text of the problem does not say so far."""
    facts = sorted({fact for plan in plans for fact in plan.missing(text)})
    about = (
        "For plans beside this problem, which the exact replay takes; others that use this, it must judge:"
    )
    return [comment([about], "    "), f"    {' '.join(facts)}"] if facts else []


def _ended(sections: list[str], problem: Problem, plans: Sequence[GroundPlan]) -> str:
    goals = " ".join(f"(done {name})" for name in sorted(problem.goals))
    text = "\n".join(sections)
    text = "\n".join([text, *_for_plans(plans, text)])
    text += "\n  " if text.splitlines()[-1].lstrip().startswith(";") else ""  # not into a comment
    return f"{text})\n  (:goal (and {goals}))\n  (:metric minimize (total-cost)))\n"


def check_object(item: SceneObject, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless an object stands on the table and its name is free in the domain."""
    grounding.category(item.category)
    check_on_table(item, grounding)
    by_name = grounding.places or grounding.relations
    taken = rf"nowhere|(start|goal|park|count)-.*|{SPOT.pattern}" if by_name else ""
    if is_taken(item.name, grounding) or re.fullmatch(taken, item.name):
        raise InvalidValue(f"No object can be called {item.name}, the domain uses that; try item-01.")


def is_taken(name: str, grounding: Grounding) -> bool:
    """Say whether the domain itself uses a name, so that no object or place of a problem can have it."""
    reserved = r"[xyz](\d*|-(step|(plus|minus)-\d+))" if grounding.is_refined else r"[xyz]\d*"
    return name in _words(grounding) or bool(re.fullmatch(reserved, name))


@lru_cache(maxsize=8)
def _words(grounding: Grounding) -> frozenset[str]:
    """List what the domain calls its types, actions and constants."""
    categories = (category.name for category in grounding.operators.categories)
    operators = [operator.name for operator in grounding.operators.operators]
    moves = [*operators, *(f"{PUT_DOWN}{name}" for name in operators)]
    constants = (f"{MOVE}{name}" for name in moves)
    carriers = (carrier(axis) for axis in range(3))
    words = ["movable", "object", "move", REACH_GOAL, *categories, *moves, *constants, *carriers]
    if grounding.places:
        names = [one.name for one in carriers_of(grounding)]
        words += ["place", *NOTES, *names, *(f"{MOVE}{name}" for name in names)]
    if grounding.relations:
        words += names_of_relations(grounding.relations)
    return frozenset(words)


def _header(problem: Problem, grounding: Grounding, steps: int) -> str:
    first = f"; Problem {problem.name} of the learned domain {grounding.name}, for its encodings on a grid."
    return "\n".join([first, _provenance(problem), _grid_header(problem, grounding, steps)])


def _place_header(problem: Problem, grounding: Grounding) -> str:
    return "\n".join(
        [
            f"; Problem {problem.name} of the learned domain {grounding.name}, with places.",
            _provenance(problem),
            "; A place starting with start- is where an object stands at first, goal- one that meets a goal,",
            "; park- one to wait at. room names the places that must be free for an object, one after",
            "; another; look-on notes that one is. can names what carries an object, at which cost.",
        ]
    )


def _provenance(problem: Problem) -> str:
    return f"; How it came about: {' '.join(problem.provenance.split())}."


def _grid_header(problem: Problem, grounding: Grounding, steps: int) -> str:
    return "\n".join(
        [
            f"; A goal is met within {problem.tolerance * 1000:g} mm. goal-xy and goal-z list the cells from",
            "; which it is met whatever the grid rounds on the way, in plans of at most",
            f"; {steps} step(s) and cells of {grounding.cell * 1000:g} mm.",
        ]
    )


def _objects(problem: Problem, grounding: Grounding, grid: Grid) -> str:
    lines = [*_item_objects(problem, grounding), *_grid_objects(problem, grounding, grid)]
    return "\n".join(["  (:objects", *lines]) + ")"


def _item_objects(problem: Problem, grounding: Grounding) -> list[str]:
    return [f"    {item.name} - {grounding.category(item.category).name}" for item in problem.objects]


def _grid_objects(problem: Problem, grounding: Grounding, grid: Grid) -> list[str]:
    """Declare the cells, and the steps that objects need beside those of the domain."""
    lines = [f"    {' '.join(grid.cell_names(axis))} - {letter}-cell" for axis, letter in enumerate(AXES)]
    return lines + (own_steps.declared_steps(problem, grounding) if grounding.is_refined else [])


def _start(item: SceneObject, grid: Grid) -> str:
    position = ", ".join(f"{value:.4f}" for value in item.position)
    cells = (grid.cell_name(axis, index) for axis, index in enumerate(grid.anchor(item.position)))
    facts = " ".join(f"(at-{letter} {item.name} {cell})" for letter, cell in zip(AXES, cells, strict=True))
    return f"    ; {item.name} starts at ({position}) m\n    {facts}"


def _goal_facts(problem: Problem, name: str, grounding: Grounding, grid: Grid, steps: int) -> str:
    item, goal = problem.object_named(name), problem.goals[name]
    region = goal_region(item, goal, problem.tolerance, grounding, steps=steps)
    position = ", ".join(f"{value:.4f}" for value in goal)
    away = math.dist(goal, item.position) * 1000
    lines = [f"; {name} shall come to ({position}) m, {away:.0f} mm from where it starts"]
    for x in sorted({x for x, _ in region.xy}):
        column = (y for across, y in region.xy if across == x)
        lines.append(
            " ".join(f"(goal-xy {name} {grid.cell_name(0, x)} {grid.cell_name(1, y)})" for y in column)
        )
    means = own_steps.mean_levels(item, region.z, grounding) if grounding.is_refined else set()
    lines.append(" ".join(f"(goal-z {name} {grid.cell_name(2, z)})" for z in sorted({*region.z, *means})))
    return "\n".join(f"    {line}" for line in lines if line)


def _step_facts(problem: Problem, grounding: Grounding, grid: Grid, margin: int) -> list[str]:
    """Print where steps lead, and where objects have steps of their own, which."""
    if not grounding.is_refined:
        return [_shift_facts(axis, cells, margin, grid) for axis, cells in shifts_of(grounding)]
    lines = [
        line for item in problem.objects for line in own_steps.facts_of(item, grounding, problem.tolerance)
    ]
    return [f"    {line}" for line in [*lines, *own_steps.leading(problem, grounding, grid, margin)]]


def _shift_facts(axis: int, cells: int, margin: int, grid: Grid) -> str:
    predicate = shift_predicate(axis, cells)
    pairs = grid.shifts(axis, cells, margin)
    facts = (f"({predicate} {grid.cell_name(axis, a)} {grid.cell_name(axis, b)})" for a, b in pairs)
    return "    " + " ".join(facts)
