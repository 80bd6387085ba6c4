"""Printing a problem for the encoding `relational`."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, product

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.moves import LIFTED, RELATIONAL, Encoding, domain_name
from neurosym.pddl.place_domain import NOWHERE
from neurosym.pddl.place_problem import START
from neurosym.pddl.printing import comment
from neurosym.pddl.relational_domain import (
    FROM_OBJECT,
    FROM_PLACE,
    LADEN,
    NONE,
    ONE,
    can_predicate,
    cost_function,
    relational_domain_text,
)
from neurosym.pddl.relational_task import Task, task_of
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.related import loads_of
from neurosym.tasks.carriers import Actions, Carrier, actions_of
from neurosym.tasks.occupants import occupants
from neurosym.tasks.places import is_at
from neurosym.tasks.puts import Put, bearing_states

COUNTS = (NONE, ONE, *(f"count-{number}" for number in range(2, 100)))
"""How many objects another one bears."""


def relational_problem_text(problem: Problem, grounding: Grounding, encoding: Encoding = RELATIONAL) -> str:
    """Print a problem.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.
        encoding: `relational`, or `relational-lifted`.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """
    return _text(task_of(problem, grounding), actions_of(grounding), encoding)


def needed_texts(problem: Problem, grounding: Grounding, encoding: Encoding = RELATIONAL) -> tuple[str, str]:
    """Print a domain with only those actions that a problem has a use for, and the problem.

    It has the same plans as with the whole domain, and planners read it faster.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.
        encoding: `relational`, or `relational-lifted`.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """
    task = task_of(problem, grounding)
    needed = task.needed()
    return relational_domain_text(grounding, encoding, needed), _text(task, needed, encoding)


def _text(task: Task, actions: Actions, encoding: Encoding) -> str:
    problem, printed = task.problem, _Printed(task, actions, is_lifted=encoding == LIFTED)
    sections = [
        _header(task, encoding),
        f"(define (problem {problem.name})\n  (:domain {domain_name(task.grounding, encoding)})",
        "\n".join(["  (:objects", *(f"    {line}" for line in printed.objects())]) + ")",
        "  (:init\n    (hand-empty) (= (total-cost) 0)",
        *(f"    {line}" for line in printed.facts()),
    ]
    goals = [f"(done {name})" for name in sorted(problem.goals)]
    goals += [f"({task.state_name(state)} {target} {other})" for target, other, state in problem.related]
    return "\n".join(sections) + f")\n  (:goal (and {' '.join(goals)}))\n  (:metric minimize (total-cost)))\n"


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


@dataclass(frozen=True, slots=True)
class _Printed:
    """What a problem is printed of.

    Attributes:
        task: The problem as the encoding sees it.
        actions: What the domain has actions for.
        is_lifted: Whether nothing is counted.
    """

    task: Task
    actions: Actions
    is_lifted: bool

    def objects(self) -> list[str]:
        """Declare objects, places and counts."""
        task, category = self.task, self.task.grounding.category
        lines = [f"{item.name} - {category(item.category).name}" for item in task.problem.objects]
        standing = [f"{START}{name}" for name in task.problem.object_names if name not in task.bearers]
        places = [*standing, *task.places]
        lines += [f"{' '.join(places)} - place", f"{' '.join(task.grades)} - grade"]
        more = COUNTS[2 : task.most_borne + 1]
        return lines if self.is_lifted or not more else [*lines, f"{' '.join(more)} - count"]

    def facts(self) -> list[str]:
        """List what holds at the start, a line for each thing."""
        task, names = self.task, self.task.problem.object_names
        lines = [line for name in names for line in self._start(name)]
        may_stand = occupants(task.flat, tuple(task.carriers))
        for place in task.places:
            lines += self._place(place, may_stand[place])
        takers = {*(target for (target, _), found in task.puts.items() if found), *task.carriers}
        lines += [f"(can-be-taken {name})" for name in names if name in takers]
        kinds = self._kinds()
        for target in names:
            said = [
                f"({kind} {one} {other})" for (one, other), kind in sorted(kinds.items()) if one == target
            ]
            lines += [" ".join(said)] if said else []
        if not self.is_lifted:
            counts = COUNTS[: task.most_borne + 1]
            lines.append(" ".join(f"(next {less} {more})" for less, more in pairwise(counts)))
        for (target, other), found in task.puts.items():
            likely = [f"({can_predicate(put.name)} {target} {other} {put.grade})" for put in found]
            lines += [" ".join(likely)] if likely else []
        return [*lines, *self._costs_on_pairs(), *self._costs_to_places()]

    def _kinds(self) -> Mapping[tuple[str, str], str]:
        """Return the kinds of those pairs that something in the domain is for, by target and reference."""
        problem, known = self.task.problem, self.actions.kinds
        pairs = problem.pairs if isinstance(problem.pairs, dict) else {}
        names = problem.object_names
        return {
            (target, other): known[kind]
            for (target, _, other), kind in ((key.partition(" "), kind) for key, kind in pairs.items())
            if kind in known and target in names and other in names
        }

    def _start(self, name: str) -> list[str]:
        task = self.task
        count = [] if self.is_lifted else [f"(bears {name} {COUNTS[len(loads_of(name, task.bearers))]})"]
        if name in task.bearers:
            borne = task.bearers[name]
            said = [f"({borne.state.name} {name} {borne.by})"]
            said += [f"(rests-with {name} {borne.by})"] if self.is_lifted else []
            return [" ".join([*said, *count])]
        place = f"{START}{name}"
        x, y, _ = task.flat.object_named(name).position
        return [" ".join([f"(stands {name} {place})", *self._goal_at(name, place, (x, y)), *count])]

    def _place(self, place: str, occupied_by: Sequence[str]) -> list[str]:
        x, y = spot = self.task.places[place]
        lines = [comment([f"{place} lies at ({x:.4f}, {y:.4f}) m"], "    ").lstrip(), f"(free {place})"]
        for name in occupied_by:
            goal = self._goal_at(name, place, spot)
            others = [f"{START}{other}" for other in self.task.blockers(name, spot)]
            if self.is_lifted:
                said = [f"(may-stand {name} {place})"]
                said += [f"(overlaps {name} {place} {other})" for other in others]
            else:
                chain = [*others, NOWHERE]
                said = [f"(room {name} {place} {chain[0]})"]
                said += [f"(look-next {name} {place} {here} {then})" for here, then in pairwise(chain)]
            lines.append(" ".join([*goal, *said]))
        return lines

    def _goal_at(self, name: str, place: str, spot: tuple[float, float]) -> list[str]:
        is_there = name in self.task.problem.goals and is_at(name, spot, self.task.flat)
        return [f"(goal-place {name} {place})"] if is_there else []

    def _costs_on_pairs(self) -> list[str]:
        """Say what operators on pairs cost, by how surely they are foreseen to go, and by third objects."""
        return [
            " ".join(self._put_costs(put, laden))
            for put in self.actions.puts
            for laden in ((False, True) if put.takes_laden else (False,))
        ]

    def _put_costs(self, put: Put, laden: bool) -> list[str]:
        function = cost_function(put.name + (LADEN if laden else ""))
        is_counted = put.takes_occupied and not self.is_lifted
        counts = COUNTS[: self.task.most_borne + 1] if is_counted else ("",)
        origins = (FROM_PLACE, FROM_OBJECT) if put.takes_borne else ("",)
        said = []
        for grade, count, origin in product(self.task.grades, counts, origins):
            words = " ".join(filter(None, (function, grade, count, origin)))
            case = {"borne": origin == FROM_OBJECT, "occupied": count not in ("", NONE), "laden": laden}
            said.append(f"(= ({words}) {replace(put, grade=grade).cost(self.task.grounding, **case)})")
        return said

    def _costs_to_places(self) -> list[str]:
        """Say what carries each object to places most cheaply, and what each operator costs."""
        lines, task = [], self.task
        for item in task.flat.objects:
            of_item = promised(task.grounding, item, task.problem.tolerance)
            cheapest = task.carriers.get(item.name)
            said = [f"({can_predicate(cheapest)} {item.name})"] if cheapest else []
            for carrier in self.actions.carriers:
                if carrier.operator.category == item.category:
                    said += self._carrier_costs(carrier, of_item[carrier.name], item.name)
            lines += [" ".join(said)] if said else []
        return lines

    def _carrier_costs(self, carrier: Carrier, operator: Operator, name: str) -> list[str]:
        function, costs = cost_function(carrier.name), {}
        for origin in (FROM_PLACE, FROM_OBJECT):
            costs[origin] = carrier.cost(operator, self.task.grounding, borne=origin == FROM_OBJECT)
        return [f"(= ({function} {name} {origin}) {cost})" for origin, cost in costs.items()]
