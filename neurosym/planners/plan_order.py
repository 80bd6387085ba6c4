"""Putting the steps of a plan in another order: displacements commute, so the end stays the same.

What changes is where the objects are on the way: one order leads an object off the table or into another, and
the next does not. What is left to do says where everything stands, so no set of steps is looked at twice.
"""

import dataclasses
from collections import Counter
from collections.abc import Sequence

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.grounding import Grounding, is_lift
from neurosym.planners.planner import Effort
from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart
from neurosym.tasks.transition import PlanStep, Replay, operator_for, validate

MOST_STATES = 2_000
"""How many beginnings of plans are tried."""
MOST_TURNS = 100
"""How many orders of the objects are tried."""
MOST_DRAWS = 12
"""How often an order is drawn in which objects make way for each other."""
MOST_LOOKS = 20_000
"""How many beginnings of plans are tried in all of these draws."""
_Block = tuple[PlanStep, ...]
"""A step that an empty hand begins, and the put-down that ends it if it is a lift."""
_Order = tuple[int, ...]
"""Kinds of blocks, one after another."""


def mend(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, effort: Effort | None = None
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Find an order of the steps in which all are possible, beginning with the one given.

    Args:
        steps: The plan.
        problem: The problem it is for.
        grounding: The learned domain.
        effort: What the beginnings of plans that are tried are counted in, if given.

    Returns:
        The first order that is possible, or the one given if none is; and its replay.
    """
    given = validate(steps, problem, grounding)
    if given.possible:
        return tuple(steps), given  # valid, or missing its goal in every order
    blocks = _blocks(steps)
    last = blocks.pop() if ends_held(steps, grounding) else ()
    if not blocks:
        return tuple(steps), given
    search = _Search(blocks, problem, grounding)
    found = search.run()
    if effort:
        effort.spend(search.looks)
    if found is not None:
        ordered = (*found, *last)
        if (checked := validate(ordered, problem, grounding)).possible:
            return ordered, checked
    if search.stuck:
        names = tuple(problem.object_names[row] for row in sorted(search.stuck))
        reason = f"no order of the steps was found that brings {', '.join(names)} past the others"
        return tuple(steps), dataclasses.replace(given, reason=reason, concerned=names)
    return tuple(steps), given


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def _blocks(steps: Sequence[PlanStep]) -> list[_Block]:
    """Cut a plan before every step that an empty hand begins: a put-down stays with its lift."""
    blocks: list[_Block] = []
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1] += (step,)
        else:
            blocks.append((step,))
    return blocks


class _Search:
    """Search among the orders of blocks, equal blocks counted.

    Attributes:
        stuck: After a search without success: the objects that were left over most often.
        looks: How many beginnings of plans were tried.
    """

    def __init__(self, blocks: Sequence[_Block], problem: Problem, grounding: Grounding) -> None:
        self._kinds = list(dict.fromkeys(blocks))
        self._counts = tuple(blocks.count(kind) for kind in self._kinds)
        self._moved = np.array([problem.object_names.index(kind[0].object) for kind in self._kinds])
        shifts = [_shifts(kind, problem, grounding) for kind in self._kinds]
        self._first, self._last = (np.array(each) for each in zip(*shifts, strict=True))  # (K, 3)
        self._start = problem.scene().positions
        self._room = problem.room(grounding.table)[:, self._moved]  # (2, K, 2)
        self._apart = footprints_apart(problem)[self._moved]  # (K, M, 2)
        self.stuck: frozenset[int] = frozenset()
        self.looks = 0

    def run(self) -> tuple[PlanStep, ...] | None:
        """Return the steps in the first order that is found to be possible, or None if none is."""
        if self._ends_overlap():
            return None
        done = self._one_after_another()
        if done is None and len(np.unique(self._moved)) > 1:
            done = self._making_way()
        if done is None:
            done, _ = self._ordered(self._counts, self._start)
        return None if done is None else tuple(step for kind in done for step in self._kinds[kind])

    def _one_after_another(self) -> _Order | None:
        """Move one object after another; who is in the way of another goes before it, or after."""
        rng, order = np.random.default_rng(0), list(dict.fromkeys(self._moved.tolist()))
        for _ in range(MOST_TURNS):
            here = self._start.copy()
            done: _Order = ()
            for moved in order:
                counts = tuple(np.where(self._moved == moved, self._counts, 0).tolist())
                path, blockers = self._ordered(counts, here)
                if path is None:
                    break
                here[moved] += np.array(counts) @ self._last
                done += path
            else:
                return done
            movable = [other for other in order if other in blockers and other != moved]
            if not movable:
                return None
            other = movable[int(rng.integers(len(movable)))]
            was_before = order.index(other) < order.index(moved)
            first, then = (moved, other) if was_before else (other, moved)
            order.remove(first)
            order.insert(order.index(then), first)
        return None

    def _making_way(self) -> _Order | None:
        """Finish whoever can be finished; if nobody can, let somebody make a step. Who, is drawn."""
        rng, left_over = np.random.default_rng(0), Counter[frozenset[int]]()
        most = self.looks + MOST_LOOKS
        for _ in range(MOST_DRAWS):
            here, left = self._start.copy(), np.array(self._counts)
            done: _Order = ()
            while path := self._finish_one(left, here, rng) or self._one_step(left, here, rng):
                for kind in path:
                    here[self._moved[kind]] += self._last[kind]
                    left[kind] -= 1
                done += path
                if self.looks > most:
                    break
            if not left.any():
                return done
            left_over[frozenset(self._moved[left > 0].tolist())] += 1
            if self.looks > most:
                break
        self.stuck = left_over.most_common(1)[0][0]
        return None

    def _finish_one(
        self, left: Int[np.ndarray, " K"], here: Float[np.ndarray, "M 3"], rng: np.random.Generator
    ) -> _Order:
        """Return all that is left to do with an object that can be finished; nothing if none can."""
        for moved in rng.permutation(np.unique(self._moved[left > 0])):
            path, _ = self._ordered(tuple(np.where(self._moved == moved, left, 0).tolist()), here)
            if path:
                return path
        return ()

    def _one_step(
        self, left: Int[np.ndarray, " K"], here: Float[np.ndarray, "M 3"], rng: np.random.Generator
    ) -> _Order:
        """Return a block that is possible; nothing if none is."""
        wanted = np.flatnonzero(left)
        hit = self._hit(here[self._moved] + self._last, here)[wanted]
        free = wanted[self._stay(here, wanted) & ~hit.any(axis=1)]
        return (int(rng.choice(free)),) if len(free) else ()

    def _ordered(
        self, counts: tuple[int, ...], start: Float[np.ndarray, "M 3"]
    ) -> tuple[_Order | None, set[int]]:
        """Order so many blocks of each kind, depth first; else say which objects were in the way."""
        seen, blockers = {counts}, set[int]()
        waiting: list[tuple[_Order, tuple[int, ...], Float[np.ndarray, "M 3"]]] = [((), counts, start)]
        while waiting and len(seen) < MOST_STATES:
            done, left, here = waiting.pop()
            self.looks += 1
            if not any(left):
                return done, blockers
            wanted = np.flatnonzero(left)
            stay, hit = self._stay(here, wanted), self._hit(here[self._moved] + self._last, here)[wanted]
            blockers |= set(np.flatnonzero(hit[stay].any(axis=0)).tolist())
            for kind in reversed(wanted[stay & ~hit.any(axis=1)].tolist()):
                fewer = (*left[:kind], left[kind] - 1, *left[kind + 1 :])
                if fewer not in seen:
                    seen.add(fewer)
                    after = here.copy()
                    after[self._moved[kind]] += self._last[kind]
                    waiting.append(((*done, kind), fewer, after))
        return None, blockers

    def _ends_overlap(self) -> bool:
        """Say whether an object that is moved ends in another, which no order can help."""
        end = self._start.copy()
        np.add.at(end, self._moved, np.array(self._counts)[:, None] * self._last)
        return bool(self._hit(end[self._moved], end).any())

    def _stay(self, here: Float[np.ndarray, "M 3"], kinds: np.ndarray) -> Bool[np.ndarray, " K"]:
        """Say which kinds of blocks keep their object on the table."""
        low, high = self._room[:, kinds]
        start = here[self._moved[kinds]]
        spots = np.stack([start + self._first[kinds], start + self._last[kinds]])[..., :2]  # (2, K, 2)
        return np.asarray(np.all((spots >= low) & (spots <= high), axis=(0, 2)))

    def _hit(
        self, spots: Float[np.ndarray, "K 3"], here: Float[np.ndarray, "M 3"]
    ) -> Bool[np.ndarray, "K M"]:
        """Say in which others the object of each kind of block would stand at a spot."""
        return np.asarray(np.all(np.abs(here[:, :2] - spots[:, None, :2]) < self._apart, axis=-1))


def _shifts(
    block: _Block, problem: Problem, grounding: Grounding
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Return by how much a block moves its object, after its first step and in all [m]."""
    operator = operator_for(block[0], problem, grounding)
    first = np.array(grounding.displacement(operator))
    return first, first + np.array(grounding.put_down_displacement(operator)) if len(block) > 1 else first
