"""Tasks of relations that people bring: a tower, each thing into one of its own, a stack apart, a change.

What can be asked for is what was learned: who draws a task says which pairs can be brought into which states,
and by which action. Nothing here knows what a state looks like.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise, permutations
from typing import get_args

import msgspec
import numpy as np

from neurosym.checks import Float, check_count
from neurosym.choices import RelationTask
from neurosym.contract import guarded, placed
from neurosym.errors import InvalidValue, UnknownChoice, counted
from neurosym.operators import TOLERANCE, Categorise
from neurosym.pair_operators import RelationOperators
from neurosym.problems import Problem, RelationGoal
from neurosym.tasks.supports import bearers_of
from neurosym.world import OtherObject, World, relative_to
from neurosym.worlds.task_drawing import check_task, items_of, standing

RELATION_TASKS: tuple[RelationTask, ...] = get_args(RelationTask)
HEIGHT = 3
"""How many objects a tower or a stack has, if the caller does not say."""
_STREAM = 0x72656C6174  # keeps this randomness apart from any other
_DRAWS = 1000


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """What can be done with a pair of objects."""

    state: str  # name of the state that the pair is brought to
    holds_several: bool  # whether the reference may bear others then
    action: Float[np.ndarray, "A"]  # the action that does it


_Pair = tuple[str, str]
Ways = dict[_Pair, tuple[Way, ...]]
"""What can be done with each pair of objects, by the names of target and reference."""
FindWays = Callable[[Problem], Ways]


def draw_relation_task(
    world: World,
    categorise: Categorise,
    relations: RelationOperators,
    find_ways: FindWays,
    kind: RelationTask,
    *,
    name: str,
    objects: int,
    seed: int,
    height: int = HEIGHT,
    state: str = "",
    tolerance: float = TOLERANCE,
) -> Problem:
    """Draw a scene, and relations that what was learned can bring about.

    `tower`: so many of the objects shall stand on one another. `boxes`: half of the objects shall each come
    on or into another of its own, which if possible is one that can bear several. `unstack`: objects begin
    as a stack, and shall come apart like that. `exchange`: two objects that others bear shall change places.
    Stacks at the start are made in the world by the same actions, so a draw in which one of them fails is
    thrown away.

    Args:
        world: The world that the objects are drawn from.
        categorise: Gives objects their symbols.
        relations: What was learned of pairs.
        find_ways: Says what can be done with the pairs of a problem.
        kind: What is asked for.
        name: Name of the problem.
        objects: How many objects.
        seed: Same seed, same task.
        height: How many objects a tower or a stack has.
        state: The state that pairs shall come to; any, if not given.
        tolerance: How near objects must come to goals on the table, if any are added [m].

    Raises:
        UnknownChoice: If there is no such kind.
        InvalidValue: If no draw has what is asked for.
    """
    if kind not in RELATION_TASKS:
        raise UnknownChoice("kind of task", str(kind), RELATION_TASKS)
    world = guarded(world)
    check_task(name, objects, seed, tolerance)
    check_count("height", height, least=2)
    least = {"tower": height, "boxes": 2, "unstack": 2 * height - 1, "exchange": 4}[kind]
    if objects < least:
        said = f"{counted(objects, 'object')} will not do for the task {kind!r}"
        raise InvalidValue(f"{said}; valid: {least} or more.")
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, RELATION_TASKS.index(kind), objects, seed, draw])
        with placed(f"draw {draw + 1}"):
            items = items_of(world.sample_scene(rng, objects), categorise)
            told = f"{kind}, drawn with seed {seed}; draw {draw + 1}"
            problem = Problem(name, items, {}, tolerance, provenance=told)
            drawing = _Drawing(problem, relations, find_ways(problem), rng, height, state, world)
            if found := _KINDS[kind](drawing):
                return found
    asked = f" in the state {state}" if state else ""
    raise InvalidValue(
        f"None of {_DRAWS} draws of {objects} objects has a task {kind!r}{asked} that "
        "what was learned can do; ask for more objects, or another state."
    )


@dataclass(frozen=True, slots=True)
class _Drawing:
    """What a task is looked for in."""

    # the objects, all on the table; a task is this problem with goals, or None if there is none
    problem: Problem
    relations: RelationOperators  # what was learned of pairs
    ways: Ways  # what can be done with them
    rng: np.random.Generator  # where draws come from
    height: int  # how many objects a tower has
    state: str  # the state that is asked for; any, if empty
    world: World  # where stacks are made

    def tower(self) -> Problem | None:
        """Ask for so many objects on one another."""
        for state in self._states():
            if chain := self._chain(state):
                return _asking(self.problem, [(upper, lower, state) for upper, lower in pairwise(chain)])
        return None

    def boxes(self) -> Problem | None:
        """Ask for half of the objects on or in another each."""
        matched = self._matched(self._names(), len(self.problem.objects) // 2)
        return _asking(self.problem, matched) if matched else None

    def unstack(self) -> Problem | None:
        """Stack objects, and ask for them on or in others each."""
        for state in self._states():
            chain = self._chain(state)
            matched = self._matched(chain[:-1], len(chain) - 1, avoid=chain) if chain else []
            begun = self._stacked([*pairwise(chain)][::-1], state) if matched else None
            if begun is not None:
                return _asking(begun, matched)
        return None

    def exchange(self) -> Problem | None:
        """Put two objects on or into others, and ask for them the other way round."""
        for state in self._states():
            for one, other, here, there in permutations(self._names(), 4):
                pairs, goals = [(one, here), (other, there)], [(one, there), (other, here)]
                if all(self._way(pair, state) for pair in (*pairs, *goals)):
                    begun = self._stacked(pairs, state)
                    if begun is None:
                        break
                    return _asking(begun, [(*pair, state) for pair in goals])
        return None

    def _states(self) -> list[str]:
        """List the states that may be asked for, in a random order."""
        known = sorted({way.state for ways in self.ways.values() for way in ways})
        return [state for state in self._shuffled(known) if self.state in ("", state)]

    def _names(self) -> list[str]:
        """List the objects in a random order."""
        return self._shuffled(self.problem.object_names)

    def _shuffled(self, names: Sequence[str]) -> list[str]:
        return [names[index] for index in self.rng.permutation(len(names))]

    def _way(self, pair: _Pair, state: str) -> Way | None:
        """Return how a pair is brought to a state; None if it cannot be."""
        return next((way for way in self.ways.get(pair, ()) if way.state == state), None)

    def _chain(self, state: str) -> list[str]:
        """Name objects of which each can be put on the next, the uppermost first; none if too few."""
        names = self._names()

        def longer(chain: list[str]) -> list[str]:
            if len(chain) == self.height:
                return chain
            fitting = (name for name in names if name not in chain and self._way((name, chain[0]), state))
            return next((found for name in fitting if (found := longer([name, *chain]))), [])

        return next((found for name in names if (found := longer([name]))), [])

    def _matched(self, targets: Sequence[str], count: int, avoid: Sequence[str] = ()) -> list[RelationGoal]:
        """Give so many objects a reference each; none if there are too few."""
        for several in (True, False):
            for state in self._states():
                found = list[RelationGoal]()
                free = [name for name in self._names() if name not in avoid]
                for target in targets:
                    used = {name for goal in found for name in goal[:2]}
                    for other in free:
                        way = self._way((target, other), state)
                        if way and way.holds_several >= several and not {target, other} & used:
                            found.append((target, other, state))
                            break
                    if len(found) == count:
                        return found
        return []

    def _stacked(self, pairs: Sequence[_Pair], state: str) -> Problem | None:
        """Bring pairs to a state in the world, one after another; None if that fails."""
        scene, names = self.problem.scene(), self.problem.object_names
        contacts = tuple[tuple[int, int], ...]()
        for target, other in pairs:
            way, aim = self._way((target, other), state), OtherObject(names.index(other))
            assert way is not None, "only such pairs are asked for"
            try:
                outcome = self.world.interact(
                    scene, way.action, names.index(target), **relative_to(self.world, aim)
                )
            except InvalidValue:  # out of the arm's reach
                return None
            if outcome.kind != "carried" or outcome.disturbed:
                return None
            scene, contacts = outcome.end, outcome.contacts
        touching = tuple((names[one], names[other]) for one, other in contacts)
        items = standing(self.problem.objects, scene)
        begun = msgspec.structs.replace(self.problem, objects=items, touching=touching)
        bearers = bearers_of(begun, self.relations)
        found = {(target, borne.by) for target, borne in bearers.items() if borne.state.name == state}
        return begun if found >= set(pairs) else None


_KINDS: dict[str, Callable[[_Drawing], Problem | None]] = {
    "tower": _Drawing.tower,
    "boxes": _Drawing.boxes,
    "unstack": _Drawing.unstack,
    "exchange": _Drawing.exchange,
}


def _asking(problem: Problem, goals: Sequence[RelationGoal]) -> Problem:
    return msgspec.structs.replace(problem, relations=tuple(goals))
