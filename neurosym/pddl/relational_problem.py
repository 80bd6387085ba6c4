"""Printing a problem for the encoding `relational`, and its ground actions."""

from collections import Counter
from collections.abc import Collection
from dataclasses import replace
from functools import cached_property
from itertools import pairwise, permutations, product

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.grounding import Grounding
from neurosym.operators import Operator, Vector
from neurosym.pair_sight import with_pairs
from neurosym.pair_states import extent
from neurosym.pddl.grades import GRADES, USUAL
from neurosym.pddl.moves import LIFTED, RELATIONAL, Encoding
from neurosym.pddl.occupants import occupants
from neurosym.pddl.place_domain import NOWHERE, carriers_for
from neurosym.pddl.place_problem import START
from neurosym.pddl.places import blockers, is_at, with_places
from neurosym.pddl.printing import comment
from neurosym.pddl.relational import (
    Put,
    bearing_states,
    puts_of,
)
from neurosym.pddl.relational_check import puts_for
from neurosym.pddl.relational_domain import (
    FROM_OBJECT,
    FROM_PLACE,
    LADEN,
    NONE,
    ONE,
    can_predicate,
    cost_function,
)
from neurosym.pddl.stacked_carriers import Carrier, relational_carriers
from neurosym.problems import ROUNDED, Problem
from neurosym.promises import promised
from neurosym.related import Borne, bearers_of, loads_of, relations_of

COUNTS = (NONE, ONE, *(f"count-{number}" for number in range(2, 100)))
"""How many objects another one bears."""


MOST_BORNE = 2
"""So many objects another one bears in a plan, unless a problem has or asks for more: each count is one more
thing for planners to look at."""


def relational_problem_text(problem: Problem, grounding: Grounding, encoding: Encoding = RELATIONAL) -> str:
    """Print a problem.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.
        encoding: `relational`, or `relational-lifted`.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """
    task = Task(problem, grounding)
    is_lifted = encoding == LIFTED
    sections = [
        _header(task, encoding),
        f"(define (problem {problem.name})\n  (:domain {grounding.name})",
        "\n".join(["  (:objects", *(f"    {line}" for line in task.objects(is_lifted))]) + ")",
        "  (:init\n    (hand-empty) (= (total-cost) 0)",
        *(f"    {line}" for line in task.facts(is_lifted)),
    ]
    goals = [f"(done {name})" for name in sorted(problem.goals)]
    goals += [f"({task.state_name(state)} {target} {other})" for target, other, state in problem.related]
    return "\n".join(sections) + f")\n  (:goal (and {' '.join(goals)}))\n  (:metric minimize (total-cost)))\n"


class Task:
    """A problem as the encoding sees it: what bears what, which places there are, and who has room there.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """

    def __init__(self, problem: Problem, grounding: Grounding):
        self.relations = relations_of(grounding, problem)
        self.grounding = grounding
        self.bearers = bearers_of(problem, self.relations)
        self.problem = with_pairs(problem, self.relations)
        self.flat = with_places(flattened(problem, self.bearers), grounding)
        self.apart = _footprints(problem, self.bearers)
        self._carriers = {one.name: one for one in relational_carriers(grounding)}
        self.carried = tuple(
            item.name for item in self.flat.objects if carriers_for(item, grounding, problem.tolerance)
        )

    @property
    def places(self) -> dict[str, tuple[float, float]]:
        """Where objects may be carried to: x and y of each place [m], by its name."""
        return self.flat.places if isinstance(self.flat.places, dict) else {}

    def state_name(self, state: str) -> str:
        """Return the name of a state that a goal names by its name or symbol."""
        return self.relations.state_named(state).name

    @cached_property
    def kinds(self) -> dict[tuple[str, str], str]:
        """Return the kinds of those pairs that something in the domain is for, by target and reference."""
        pairs = self.problem.pairs if isinstance(self.problem.pairs, dict) else {}
        known = {put.kind.symbol: put.kind.name for put in puts_of(self.grounding) if put.kind}
        return {
            (target, other): known[kind]
            for (target, _, other), kind in ((key.partition(" "), kind) for key, kind in pairs.items())
            if kind in known and target in self.problem.object_names and other in self.problem.object_names
        }

    @cached_property
    def puts(self) -> dict[tuple[str, str], tuple[Put, ...]]:
        """Return what is likely to work with each pair."""
        pairs = permutations(sorted(self.problem.object_names), 2)
        return {pair: puts_for(self.problem, self.grounding, *pair) for pair in pairs}

    @cached_property
    def named(self) -> dict[str, Put]:
        """Return the operators on pairs that the domain has, by name."""
        return {put.name: put for put in puts_of(self.grounding)}

    @cached_property
    def grades(self) -> tuple[str, ...]:
        """List how surely operators are foreseen to keep their promises with pairs of these objects."""
        found = {put.grade for puts in self.puts.values() for put in puts}
        return tuple(grade for grade in (USUAL, *GRADES) if grade in found) or (USUAL,)

    def blockers(self, name: str, spot: tuple[float, float]) -> tuple[str, ...]:
        """Name the other objects on the table that stand at first where an object would come to stand."""
        found = blockers(name, spot, self.flat, self.apart)
        return tuple(other for other in found if other not in self.bearers)

    def objects(self, is_lifted: bool) -> list[str]:
        """Declare objects, places and counts."""
        category = self.grounding.category
        lines = [f"{item.name} - {category(item.category).name}" for item in self.problem.objects]
        standing = [f"{START}{name}" for name in self.problem.object_names if name not in self.bearers]
        places = [*standing, *self.places]
        lines += [f"{' '.join(places)} - place", f"{' '.join(self.grades)} - grade"]
        more = COUNTS[2 : self.most_borne + 1]
        return lines if is_lifted or not more else [*lines, f"{' '.join(more)} - count"]

    @cached_property
    def most_borne(self) -> int:
        """Return how many objects another one bears at most in a plan: as many as asked for, or a few."""
        wanted = Counter(reference for _, reference, _ in self.problem.related)
        at_first = (len(loads_of(name, self.bearers)) for name in self.problem.object_names)
        takes_more = any(put.takes_occupied for put in puts_of(self.grounding))
        return max([MOST_BORNE if takes_more else 1, *wanted.values(), *at_first])

    def facts(self, is_lifted: bool) -> list[str]:
        """List what holds at the start, a line for each thing."""
        lines = [line for name in self.problem.object_names for line in self._start(name, is_lifted)]
        for place, spot in self.places.items():
            lines += self._place(place, spot, is_lifted)
        kinds = self.kinds
        puts = self.puts
        takers = {*(target for (target, _), found in puts.items() if found), *self.carried}
        lines += [f"(can-be-taken {name})" for name in self.problem.object_names if name in takers]
        for target in self.problem.object_names:
            said = [
                f"({kind} {one} {other})" for (one, other), kind in sorted(kinds.items()) if one == target
            ]
            lines += [" ".join(said)] if said else []
        if not is_lifted:
            counts = COUNTS[: self.most_borne + 1]
            lines.append(" ".join(f"(next {less} {more})" for less, more in pairwise(counts)))
        for (target, other), found in puts.items():
            likely = [f"({can_predicate(put.name)} {target} {other} {put.grade})" for put in found]
            lines += [" ".join(likely)] if likely else []
        return [*lines, *self._costs_on_pairs(is_lifted), *self._costs_to_places()]

    def _start(self, name: str, is_lifted: bool) -> list[str]:
        count = [] if is_lifted else [f"(bears {name} {COUNTS[len(loads_of(name, self.bearers))]})"]
        if name in self.bearers:
            borne = self.bearers[name]
            said = [f"({borne.state.name} {name} {borne.by})"]
            said += [f"(rests-with {name} {borne.by})"] if is_lifted else []
            return [" ".join([*said, *count])]
        place = f"{START}{name}"
        x, y, _ = self.flat.object_named(name).position
        is_there = name in self.problem.goals and is_at(name, (x, y), self.flat)
        goal = [f"(goal-place {name} {place})"] if is_there else []
        return [" ".join([f"(stands {name} {place})", *goal, *count])]

    def _place(self, place: str, spot: tuple[float, float], is_lifted: bool) -> list[str]:
        x, y = spot
        lines = [comment([f"{place} lies at ({x:.4f}, {y:.4f}) m"], "    ").lstrip(), f"(free {place})"]
        for name in occupants(self.flat, self.carried)[place]:
            goal = self._goal_at(name, place, spot)
            others = [f"{START}{other}" for other in self.blockers(name, spot)]
            if is_lifted:
                said = [f"(may-stand {name} {place})"]
                said += [f"(overlaps {name} {place} {other})" for other in others]
            else:
                chain = [*others, NOWHERE]
                said = [f"(room {name} {place} {chain[0]})"]
                said += [f"(look-next {name} {place} {here} {then})" for here, then in pairwise(chain)]
            lines.append(" ".join([*goal, *said]))
        return lines

    def _goal_at(self, name: str, place: str, spot: tuple[float, float]) -> list[str]:
        is_there = name in self.problem.goals and is_at(name, spot, self.flat)
        return [f"(goal-place {name} {place})"] if is_there else []

    def _costs_on_pairs(self, is_lifted: bool) -> list[str]:
        """Say what operators on pairs cost, by how surely they are foreseen to go, and by third objects."""
        return [
            " ".join(self._put_costs(put, is_lifted, laden))
            for put in puts_of(self.grounding)
            for laden in ((False, True) if put.takes_laden else (False,))
        ]

    def _put_costs(self, put: Put, is_lifted: bool, laden: bool) -> list[str]:
        function = cost_function(put.name + (LADEN if laden else ""))
        is_counted = put.takes_occupied and not is_lifted
        counts = COUNTS[: self.most_borne + 1] if is_counted else ("",)
        origins = (FROM_PLACE, FROM_OBJECT) if put.takes_borne else ("",)
        said = []
        for grade, count, origin in product(self.grades, counts, origins):
            words = " ".join(filter(None, (function, grade, count, origin)))
            case = {"borne": origin == FROM_OBJECT, "occupied": count not in ("", NONE), "laden": laden}
            said.append(f"(= ({words}) {replace(put, grade=grade).cost(self.grounding, **case)})")
        return said

    def _costs_to_places(self) -> list[str]:
        """Say what carries each object to places most cheaply, and what each operator costs."""
        lines = []
        for item in self.flat.objects:
            fit = [one.name for one in carriers_for(item, self.grounding, self.problem.tolerance)][:1]
            of_item = promised(self.grounding, item, self.problem.tolerance)
            said = [f"({can_predicate(name)} {item.name})" for name in fit if item.name in self.carried]
            for name, carrier in self._carriers.items():
                if carrier.operator.category == item.category:
                    said += self._carrier_costs(carrier, of_item[name], item.name)
            lines += [" ".join(said)] if said else []
        return lines

    def _carrier_costs(self, carrier: Carrier, operator: Operator, name: str) -> list[str]:
        function, costs = cost_function(carrier.name), {}
        for origin in (FROM_PLACE, FROM_OBJECT):
            costs[origin] = carrier.cost(operator, self.grounding, borne=origin == FROM_OBJECT)
        return [f"(= ({function} {name} {origin}) {cost})" for origin, cost in costs.items()]


def flattened(problem: Problem, bearers: dict[str, Borne]) -> Problem:
    """Return a problem whose borne objects are as high as they are when they stand on the table.

    Args:
        problem: The problem.
        bearers: What bears each object that another one bears.
    """
    scene = problem.scene()
    objects = []
    for row, item in enumerate(problem.objects):
        if item.name in bearers:
            x, y, _ = item.position
            low: Vector = (x, y, float(extent(scene, row)[2]) / 2)
            item = msgspec.structs.replace(item, position=low)
        objects.append(item)
    return msgspec.structs.replace(problem, objects=tuple(objects))


def _footprints(problem: Problem, bearers: Collection[str]) -> Float[np.ndarray, "M M 2"]:
    """Return how far apart the centres of two objects on the table must be on x or y [m].

    Of two that stand on it and overlap at the start nothing is asked.
    """
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    apart = (sizes[:, None] + sizes) / 2 - ROUNDED
    spots = problem.scene().positions[:, :2]
    stands = np.array([name not in bearers for name in problem.object_names])
    overlap = np.all(np.abs(spots[:, None] - spots) < apart, axis=-1)
    apart[overlap & stands[:, None] & stands] = 0.0
    return np.asarray(apart)


def _header(task: Task, encoding: Encoding) -> str:
    problem = task.problem
    named = ", ".join(state.name for state in bearing_states(task.grounding))
    lines = [
        f"Problem {problem.name} of the learned domain {task.grounding.name}, for its encoding {encoding}.",
        f"How it came about: {problem.provenance}.",
        f"States in which one object bears another: {named}.",
        "Objects stand at start-... at first, and none goes back there; park-... are places to wait at.",
    ]
    return comment(lines, "")
