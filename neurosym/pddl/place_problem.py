"""Printing a problem for the encoding `places`."""

from itertools import pairwise

import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.pddl.moves import MOVE
from neurosym.pddl.place_domain import LEAVE, LOOK, NOWHERE, REACH
from neurosym.pddl.printing import comment
from neurosym.problems import Problem, SceneObject
from neurosym.promises import promised
from neurosym.tasks.carriers import carriers_for, carriers_of
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.moves import step_cost
from neurosym.tasks.occupants import occupants
from neurosym.tasks.places import blockers, is_at, with_places

START = "start-"
"""What the names of places begin with that objects stand at when a plan begins."""


def carried_objects(problem: Problem, grounding: Grounding) -> tuple[str, ...]:
    """Name the objects that stand at places: those that can be carried, unless their goal is in the air.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    places = with_places(problem, grounding).places
    return tuple(
        item.name
        for item in problem.objects
        if carriers_for(item, grounding, problem.tolerance)
        and (item.name not in problem.goals or _reach(item, places, problem))
    )


def led_objects(problem: Problem, grounding: Grounding) -> tuple[str, ...]:
    """Name the objects that are led over cells: those with a goal that cannot be carried to it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    carried = carried_objects(problem, grounding)
    return tuple(name for name in problem.object_names if name in problem.goals and name not in carried)


class PlaceNotes:
    """Where objects stand while a plan with places is printed as ground actions.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
    """

    def __init__(self, problem: Problem, grounding: Grounding):
        self._problem, self._apart = problem, footprints_apart(problem)
        self._stands = {name: f"{START}{name}" for name in problem.object_names}
        self.carried = carried_objects(problem, grounding)
        self.led = led_objects(problem, grounding)

    def carry(self, operator: str, name: str, place: str) -> list[str]:
        """Return the ground actions that carry an object to a place, those that look before it first."""
        others = blockers(name, self._problem.place_named(place), self._problem, self._apart)
        links = pairwise(_chain(others))
        looks = [f"({LOOK} {name} {place} {here} {then})" for here, then in links]
        before, self._stands[name] = self._stands[name], place
        return [*looks, f"({operator} {name} {before} {place})"]

    def leave(self, name: str) -> str:
        """Return the ground action that notes that an object has left where it started."""
        return f"({LEAVE} {name} {START}{name})"

    def reach(self, name: str) -> str:
        """Return the ground action that notes that an object stands where its goal is."""
        return f"({REACH} {name} {self._stands[name]})"


def declared(problem: Problem) -> str:
    """Declare the places of a problem, those that objects stand at first."""
    names = [f"{START}{name}" for name in problem.object_names] + list(_places(problem))
    return f"    {' '.join(names)} - place"


def facts(problem: Problem, grounding: Grounding) -> list[str]:
    """List what holds of places at the start, a line for each thing.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
    """
    places, apart = _places(problem), footprints_apart(problem)
    carried, led = carried_objects(problem, grounding), led_objects(problem, grounding)
    may_stand = occupants(problem, carried)
    lines = [_start(item, problem, is_led=item.name in led) for item in problem.objects]
    for name, (x, y) in places.items():
        lines.append(comment([f"{name} lies at ({x:.4f}, {y:.4f}) m"], "    ").lstrip())
        lines.append(f"(free {name})")
        for thing in may_stand[name]:
            lines.append(" ".join(_room(thing, name, problem, apart)))
    for item in problem.objects:
        if item.name in carried:
            lines += _carriers(item, problem, grounding)
    return lines


def place_facts(name: str, place: str, problem: Problem) -> list[str]:
    """List what must hold at the start for an object to be carried to a place in the course of a plan.

    Args:
        name: The object.
        place: The place, which may be a spot that the problem does not declare.
        problem: The problem, with its places.
    """
    return [f"(free {place})", *_room(name, place, problem, footprints_apart(problem))]


def _places(problem: Problem) -> dict[str, tuple[float, float]]:
    assert isinstance(problem.places, dict), "with_places gives them"
    return problem.places


def _reach(item: SceneObject, places: object, problem: Problem) -> bool:
    """Say whether some place is within the tolerance of an object's goal."""
    return isinstance(places, dict) and any(is_at(item.name, spot, problem) for spot in places.values())


def _start(item: SceneObject, problem: Problem, *, is_led: bool) -> str:
    place = f"{START}{item.name}"
    x, y, _ = item.position
    at_goal = item.name in problem.goals and is_at(item.name, (x, y), problem)
    said = [f"(stands {item.name} {place})"]
    said += [f"(goal-place {item.name} {place})"] if at_goal else []
    said += [f"(led {item.name})"] if is_led else []
    return " ".join(said)


def _room(thing: str, place: str, problem: Problem, apart: Float[np.ndarray, "M M 2"]) -> list[str]:
    """Say which places must be free, one after another, for an object to have room at a place."""
    spot = problem.place_named(place)
    at_goal = thing in problem.goals and is_at(thing, spot, problem)
    chain = _chain(blockers(thing, spot, problem, apart))
    return [
        *([f"(goal-place {thing} {place})"] if at_goal else []),
        f"(room {thing} {place} {chain[0]})",
        *(f"(look-next {thing} {place} {here} {then})" for here, then in pairwise(chain)),
    ]


def _chain(others: tuple[str, ...]) -> list[str]:
    """List the places that must be free, one after another, and what comes after the last."""
    return [*(f"{START}{other}" for other in others), NOWHERE]


def _carriers(item: SceneObject, problem: Problem, grounding: Grounding) -> list[str]:
    """Say what carries an object most cheaply, and what each operator of its category costs.

    All lead to the same, so the others would only give planners more to look at.
    """
    fit = [one.name for one in carriers_for(item, grounding, problem.tolerance)][:1]
    of_item = promised(grounding, item, problem.tolerance)
    every = [of_item[one.name] for one in carriers_of(grounding) if one.category == item.category]
    costs = {one.name: f"(= (cost-of-{one.name} {item.name}) {step_cost(one, grounding)})" for one in every}
    lines = [f"(can {MOVE}{name} {item.name}) {costs[name]}" for name in fit]
    return [*lines, *(cost for name, cost in costs.items() if name not in fit)]
