"""Following a plan of relations: what bears what, where that is in metres, and whether a step is possible."""

from collections.abc import Sequence
from copy import copy
from itertools import pairwise

import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.pair_states import extent
from neurosym.pddl.moves import LIFTED, RELATIONAL, Encoding
from neurosym.pddl.place_domain import LOOK, NOWHERE, REACH
from neurosym.pddl.place_problem import START
from neurosym.pddl.relational_domain import FROM_OBJECT, FROM_PLACE, LADEN, LEAVE, LEAVE_PLACE
from neurosym.pddl.relational_problem import COUNTS
from neurosym.pddl.relational_task import task_of
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.related import Borne, carried_along, chain_below, loads_of
from neurosym.relation_goals import pair_key
from neurosym.tasks.carriers import Carrier, chance_of, relational_carriers
from neurosym.tasks.footprints import overlapping
from neurosym.tasks.puts import Put, put_named
from neurosym.wording import counted
from neurosym.world import Scene

Words = tuple[str, str, str]
"""Operator, object, and the place or the other object of a step."""


class Following:
    """The objects of a problem while a plan is followed step by step, as its operators promise.

    Args:
        problem: The problem.
        grounding: The learned domain.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """

    def __init__(self, problem: Problem, grounding: Grounding):
        self.task = task_of(problem, grounding)
        self.positions = problem.scene().positions
        self.bearers = dict(self.task.bearers)
        self.stands = {name: f"{START}{name}" for name in problem.object_names if name not in self.bearers}
        self._carriers = {one.name: one for one in relational_carriers(grounding)}
        self._room = self.task.flat.room(grounding.table)

    def why_impossible(self, step: Words) -> tuple[str, tuple[str, ...]] | None:
        """Say why a step is not possible now, and which other objects that is about; None if it is.

        Args:
            step: The step.
        """
        name, target, reference = step
        put, carrier = self._put(step), self._carriers.get(name)
        if put:
            return self._why_not_put(put, target, reference)
        if carrier:
            return self._why_not_carried(carrier, target, reference)
        return "it neither puts its object on another nor carries it to a place", ()

    def do(self, step: Words) -> Float[np.ndarray, "M 3"]:
        """Take a step, whether it is possible or not, and return where everything is then [m].

        Args:
            step: The step.
        """
        _, target, reference = step
        put, names = self._put(step), self.task.problem.object_names
        row = names.index(target)
        halves = [extent(self._scene(), index) / 2 for index in range(len(names))]
        if put:
            other = names.index(reference)
            there = self.positions[other] + np.array(put.end.offset) * (halves[row] + halves[other])
        else:
            there = np.array([*self.task.flat.place_named(reference), halves[row][2]])
        moved = [row, *(names.index(one) for one in carried_along(target, self.bearers))]
        positions = self.positions.copy()
        positions[moved] += there - self.positions[row]
        self.positions = positions
        self.stands.pop(target, None)
        self.bearers.pop(target, None)
        if put:
            self.bearers[target] = Borne(reference, put.state)
        else:
            self.stands[target] = reference
        return positions

    def after(self, step: Words) -> "Following":
        """Return how the objects stand after a step; here they stay as they are.

        Args:
            step: The step.
        """
        then = copy(self)
        then.bearers, then.stands = dict(self.bearers), dict(self.stands)
        then.do(step)
        return then

    def is_reached(self) -> bool:
        """Say whether all goals are met now."""
        return self.task.problem.is_met(self.positions) and self.missed() is None

    def chance(self, step: Words) -> float:
        """Return the chance that a step goes as promised now.

        Args:
            step: The step.
        """
        name, target, reference = step
        borne = target in self.bearers
        if put := self._put(step):
            return put.chance(borne=borne, **self._third(target, reference))
        item = self.task.flat.object_named(target)
        of_item = promised(self.task.grounding, item, self.task.problem.tolerance)
        usual = chance_of(of_item.get(name) or self.task.grounding.operator_named(name))
        kept = self._carriers[name].borne
        return min(usual, (kept.kept + 1) / (kept.trials + 2)) if borne and kept.trials else usual

    def cost(self, step: Words) -> int:
        """Return what a step costs now.

        Args:
            step: The step.
        """
        name, target, reference = step
        borne, grounding = target in self.bearers, self.task.grounding
        if put := self._put(step):
            return put.cost(grounding, borne=borne, **self._third(target, reference))
        item = self.task.flat.object_named(target)
        of_item = promised(grounding, item, self.task.problem.tolerance)
        operator = of_item.get(name) or grounding.operator_named(name)
        return self._carriers[name].cost(operator, grounding, borne=borne)

    def missed(self) -> tuple[str, str] | None:
        """Name the first object that misses a goal by relation now, and say which; None if none does."""
        for target, reference, state in self.task.problem.related:
            asked, borne = self.task.relations.state_named(state), self.bearers.get(target)
            if borne != Borne(reference, asked):
                now = f"{borne.state.name} {borne.by}" if borne else "borne by nothing"
                return target, f"{target} ends {now}, not {asked.name} {reference}"
        return None

    def ground(self, step: Words) -> list[str]:
        """Return the ground actions of a step in the encoding `relational`, before it is done.

        Args:
            step: The step.
        """
        name, target, reference = step
        put, borne = self._put(step), self.bearers.get(target)
        origin = FROM_OBJECT if borne else FROM_PLACE
        if borne:
            count = len(loads_of(borne.by, self.bearers))
            taken = f"{LEAVE}{borne.state.name} {target} {borne.by} {COUNTS[count - 1]} {COUNTS[count]}"
        else:
            taken = f"{LEAVE_PLACE} {target} {self.stands[target]}"
        if put:
            return [f"({taken})", f"({' '.join(self._put_words(put, target, reference, origin))})"]
        spot = self.task.flat.place_named(reference)
        others = [f"{START}{other}" for other in self.task.blockers(target, spot)]
        looks = [f"({LOOK} {target} {reference} {here} {then})" for here, then in _links(others)]
        from_where = [origin] if self._carriers[name].takes_borne else []
        return [f"({taken})", *looks, f"({' '.join([name, target, reference, *from_where])})"]

    def reach(self, name: str) -> str:
        """Return the ground action that notes that an object stands where its goal is."""
        return f"({REACH} {name} {self.stands.get(name, f'{START}{name}')})"

    def _put(self, step: Words) -> Put | None:
        """Return the operator on pairs of a step, as it is foreseen to turn out there; None if it is none."""
        name, target, reference = step
        put = self.task.named.get(name) or put_named(name, self.task.grounding)
        return put.with_pair(self.task.problem, target, reference) if put else None

    def _third(self, target: str, reference: str) -> dict[str, bool]:
        """Say whether third objects rest on the reference and on the target; see `Put.chance`."""
        others = {one for one in loads_of(reference, self.bearers) if one != target}
        return {"occupied": bool(others), "laden": bool(loads_of(target, self.bearers))}

    def _put_words(self, put: Put, target: str, reference: str, origin: str) -> list[str]:
        before = {name: borne for name, borne in self.bearers.items() if name != target}
        load = len(loads_of(target, self.bearers))
        words = [put.name + (LADEN if load else ""), target, reference]
        if load:
            words += [self.stands[reference], COUNTS[load - 1], COUNTS[load]]
        if put.takes_occupied:
            count = len(loads_of(reference, before))
            words += [COUNTS[count], COUNTS[count + 1]]
        return [*words, *([origin] if put.takes_borne else []), put.grade]

    def _why_not_put(self, put: Put, target: str, reference: str) -> tuple[str, tuple[str, ...]] | None:
        pairs = self.task.problem.pairs
        kind = pairs.get(pair_key(target, reference)) if isinstance(pairs, dict) else None
        if not put.operator.is_for(kind):
            return f"it is not for {target} with {reference}, a pair of the kind {kind}", (reference,)
        if target in chain_below(reference, self.bearers):
            return f"{reference} rests on {target} itself", (reference,)
        others = [one for one in loads_of(reference, self.bearers) if one != target]
        if others and not put.takes_occupied:
            return f"{reference} bears {others[0]}, which rehearsals forbid", (reference, others[0])
        if len(others) >= self.task.most_borne:
            return f"{reference} bears {counted(len(others), 'object')}, and plans count no more", (
                reference,
            )
        if loads_of(target, self.bearers) and reference not in self.stands:
            return f"{target} bears something, and {reference} stands at no place", (reference,)
        return self._why_not_taken(put, target)

    def _why_not_carried(
        self, carrier: Carrier, target: str, place: str
    ) -> tuple[str, tuple[str, ...]] | None:
        item = self.task.flat.object_named(target)
        if carrier.name not in promised(self.task.grounding, item, self.task.problem.tolerance):
            return f"it is not for {target}", ()
        if reason := self._why_not_taken(carrier, target):
            return reason
        names = self.task.problem.object_names
        row, spot = names.index(target), np.array(self.task.flat.place_named(place))
        if not np.all((spot >= self._room[0, row]) & (spot <= self._room[1, row])):
            return f"{target} leaves the table at x = {spot[0]:.3f}, y = {spot[1]:.3f} m", ()
        here = self.positions[:, :2]
        for index in np.flatnonzero(overlapping(spot, here, self.task.apart[row])):
            other = names[int(index)]
            if other in self.stands and other != target:
                return f"{target} ends where {other} is", (other,)
        return None

    def _why_not_taken(self, one: Put | Carrier, target: str) -> tuple[str, tuple[str, ...]] | None:
        borne, loads = self.bearers.get(target), loads_of(target, self.bearers)
        if borne and not one.takes_borne:
            return f"{target} rests on {borne.by}, which rehearsals forbid", (borne.by,)
        if loads and not one.takes_laden:
            return f"{target} bears {loads[0]}, which rehearsals forbid", (loads[0],)
        return None

    def _scene(self) -> Scene:
        scene = self.task.problem.scene()
        return Scene(scene.features, self.positions, scene.orientations)


def chances_along(steps: Sequence[Words], problem: Problem, grounding: Grounding) -> tuple[float, ...]:
    """Return the chance of each step of a plan to go as promised, by what rests where by then.

    Args:
        steps: The plan.
        problem: The problem it is for.
        grounding: The learned domain.
    """
    now, found = Following(problem, grounding), list[float]()
    for step in steps:
        found.append(now.chance(step))
        now.do(step)
    return tuple(found)


def print_relational_plan(
    steps: Sequence[Words], problem: Problem, grounding: Grounding, encoding: Encoding = RELATIONAL
) -> str:
    """Print a plan as ground actions of the domain, such that plan validators take it.

    Args:
        steps: The plan.
        problem: The problem it solves.
        grounding: The learned domain.
        encoding: The encoding of the domain; the lifted one counts nothing, and looks at no places.
    """
    now = Following(problem, grounding)
    lines = list[str]()
    for step in steps:
        lines += [one for one in now.ground(step) if not (encoding == LIFTED and one.startswith(f"({LOOK} "))]
        now.do(step)
    lines += [now.reach(name) for name in sorted(problem.goals)]
    return "\n".join(map(_uncounted, lines) if encoding == LIFTED else lines) + "\n"


def _uncounted(line: str) -> str:
    """Return a ground action of the lifted variant, which has no counts."""
    kept = [word for word in line.strip("()").split() if word not in COUNTS]
    return f"({' '.join(kept)})"


def _links(others: Sequence[str]) -> list[tuple[str, str]]:
    return list(pairwise([*others, NOWHERE]))
