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

from neurosym.checks import Float, check_count, check_length, check_seed
from neurosym.choices import RelationTask
from neurosym.contract import guarded, placed
from neurosym.errors import InvalidValue, UnknownChoice, counted
from neurosym.operators import TOLERANCE, Categorise
from neurosym.pair_operators import RelationOperators
from neurosym.problems import Problem, RelationGoal, check_names
from neurosym.tasks.supports import bearers_of
from neurosym.world import OtherObject, Scene, World, relative_to
from neurosym.worlds.task_drawing import draw_places, items_of, standing

RELATION_TASKS: tuple[RelationTask, ...] = get_args(RelationTask)
HEIGHT = 3
"""How many objects a tower or a stack has, if the caller does not say."""
_STREAM = 0x72656C6174  # keeps this randomness apart from any other
_DRAWS = 1000


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """What can be done with a pair of objects.

    Attributes:
        state: Name of the state that the pair is brought to.
        holds_several: Whether the reference may bear others then.
        action: The action that does it.
    """

    state: str
    holds_several: bool
    action: Float[np.ndarray, "A"]


_Pair = tuple[str, str]
Ways = dict[_Pair, tuple[Way, ...]]
"""What can be done with each pair of objects, by the names of target and reference."""
FindWays = Callable[[Problem], Ways]


@dataclass(frozen=True, slots=True)
class _Drawn:
    """A problem without goals, what can be done in it, and what is asked for.

    Attributes:
        problem: The objects, all on the table.
        relations: What was learned of pairs.
        ways: What can be done with them.
        rng: Where draws come from.
        height: How many objects a tower has.
        state: The state that is asked for; any, if empty.
    """

    problem: Problem
    relations: RelationOperators
    ways: Ways
    rng: np.random.Generator
    height: int
    state: str

    @property
    def states(self) -> tuple[str, ...]:
        """The states that may be asked for, in a random order."""
        known = sorted({way.state for ways in self.ways.values() for way in ways})
        shuffled = [known[index] for index in self.rng.permutation(len(known))]
        return tuple(state for state in shuffled if self.state in ("", state))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the objects in a random order."""
        names = self.problem.object_names
        return tuple(names[index] for index in self.rng.permutation(len(names)))

    def way(self, pair: _Pair, state: str) -> Way | None:
        """Return how a pair is brought to a state; None if it cannot be."""
        return next((way for way in self.ways.get(pair, ()) if way.state == state), None)

    def stacked(self, world: World, pairs: Sequence[_Pair], state: str) -> Problem | None:
        """Bring pairs to a state in the world, one after another; None if that fails."""
        ways = [self.way(pair, state) for pair in pairs]
        actions = [way.action for way in ways if way]
        begun = _stacked(self.problem, world, [*zip(pairs, actions, strict=True)])
        if begun is None:
            return None
        bearers = bearers_of(begun, self.relations)
        found = {(target, borne.by) for target, borne in bearers.items() if borne.state.name == state}
        return begun if found >= set(pairs) else None


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
    like: Problem | None = None,
    likened: Sequence[RelationGoal] = (),
    tolerance: float = TOLERANCE,
) -> Problem:
    """Draw a scene, and relations that what was learned can bring about.

    `tower`: so many of the objects shall stand on one another. `boxes`: half of the objects shall each come
    on or into another of its own, which if possible is one that can bear several. `unstack`: objects begin
    as a stack, and shall come apart like that. `exchange`: two objects that others bear shall change places.
    `like`: the objects of another scene shall stand to one another as they do there. Stacks at the start are
    made in the world by the same actions, so a draw in which one of them fails is thrown away.

    Args:
        world: The world that the objects are drawn from.
        categorise: Gives objects their symbols.
        relations: What was learned of pairs.
        find_ways: Says what can be done with the pairs of a problem.
        kind: What is asked for.
        name: Name of the problem.
        objects: How many objects; for `like` as many as the other scene has.
        seed: Same seed, same task.
        height: How many objects a tower or a stack has.
        state: The state that pairs shall come to; any, if not given.
        like: The other scene, for `like`.
        likened: How pairs stand to one another there.
        tolerance: How near objects must come to goals on the table, if any are added [m].

    Raises:
        UnknownChoice: If there is no such kind.
        InvalidValue: If no draw has what is asked for.
    """
    if kind not in RELATION_TASKS:
        raise UnknownChoice("kind of task", str(kind), RELATION_TASKS)
    world = guarded(world)
    check_count("objects", objects)
    check_count("height", height, least=2)
    check_names((name,))
    check_seed(seed)
    check_length("tolerance", tolerance)
    if kind == "like" and (like is None or not likened):
        raise InvalidValue("A task like another scene needs one in which an object bears another.")
    least, why = _least_objects(kind, height)
    if objects < least:
        raise InvalidValue(f"{counted(objects, 'object')} will not do: {why}.")
    number = RELATION_TASKS.index(kind)
    for draw in range(_DRAWS):
        rng = np.random.default_rng([_STREAM, number, objects, seed, draw])
        with placed(f"draw {draw + 1}"):
            scene = world.sample_scene(rng, objects) if like is None else _scattered(like, world, rng)
        if scene is None:
            continue
        told = f"{kind}, drawn with seed {seed}; draw {draw + 1}"
        items = items_of(scene, categorise) if like is None else standing(like.objects, scene)
        problem = Problem(name, items, {}, tolerance, provenance=told)
        if like is not None:
            return msgspec.structs.replace(problem, relations=tuple(likened))
        found = _KINDS[kind](_Drawn(problem, relations, find_ways(problem), rng, height, state), world)
        if found is not None:
            return found
    asked = f" in the state {state}" if state else ""
    lower, high = (", a lower height", f" of height {height}") if kind in ("tower", "unstack") else ("", "")
    raise InvalidValue(
        f"None of {_DRAWS} draws of {objects} objects has a task {kind!r}{asked}{high} that "
        f"what was learned can do; ask for more objects{lower}, or another state."
    )


def _least_objects(kind: RelationTask, height: int) -> tuple[int, str]:
    """Return how many objects a task needs at least, and why."""
    several, lower = 2 * height - 1, "or a lower height"
    apart = f"a stack of {height} is taken apart onto {height - 1} others"
    least = {
        "tower": (height, f"a tower of height {height} needs {height}; valid: {height} or more, {lower}"),
        "boxes": (2, "each thing comes into another; valid: 2 or more"),
        "unstack": (several, f"{apart}; valid: {several} or more, {lower}"),
        "exchange": (4, "two change places on two others; valid: 4 or more"),
    }
    return least.get(kind, (1, "there is nothing to do"))


def _tower(drawn: _Drawn, _: World) -> Problem | None:
    for state in drawn.states:
        chain = _chain(drawn, state)
        if chain:
            return _asking(drawn.problem, [(upper, lower, state) for upper, lower in pairwise(chain)])
    return None


def _boxes(drawn: _Drawn, _: World) -> Problem | None:
    matched = _matched(drawn, drawn.names, len(drawn.problem.objects) // 2)
    return _asking(drawn.problem, matched) if matched else None


def _unstack(drawn: _Drawn, world: World) -> Problem | None:
    for state in drawn.states:
        chain = _chain(drawn, state)
        matched = _matched(drawn, chain[:-1], len(chain) - 1, avoid=chain) if chain else []
        begun = drawn.stacked(world, [*pairwise(chain)][::-1], state) if matched else None
        if begun is not None:
            return _asking(begun, matched)
    return None


def _exchange(drawn: _Drawn, world: World) -> Problem | None:
    for state in drawn.states:
        for one, other, here, there in permutations(drawn.names, 4):
            pairs, goals = [(one, here), (other, there)], [(one, there), (other, here)]
            if all(drawn.way(pair, state) for pair in (*pairs, *goals)):
                begun = drawn.stacked(world, pairs, state)
                if begun is None:
                    break
                return _asking(begun, [(*pair, state) for pair in goals])
    return None


_KINDS: dict[str, Callable[[_Drawn, World], Problem | None]] = {
    "tower": _tower,
    "boxes": _boxes,
    "unstack": _unstack,
    "exchange": _exchange,
}


def _chain(drawn: _Drawn, state: str) -> list[str]:
    """Name objects of which each can be put on the next, the uppermost first; none if there are too few."""

    def longer(chain: list[str]) -> list[str]:
        if len(chain) == drawn.height:
            return chain
        fitting = (name for name in names if name not in chain and drawn.way((name, chain[0]), state))
        return next((found for name in fitting if (found := longer([name, *chain]))), [])

    names = drawn.names
    return next((found for name in names if (found := longer([name]))), [])


def _matched(
    drawn: _Drawn, targets: Sequence[str], count: int, avoid: Sequence[str] = ()
) -> list[RelationGoal]:
    """Give so many objects a reference each; none if there are too few."""
    for several in (True, False):
        for state in drawn.states:
            found = list[RelationGoal]()
            free = [name for name in drawn.names if name not in avoid]
            for target in targets:
                used = {name for goal in found for name in goal[:2]}
                for other in free:
                    way = drawn.way((target, other), state)
                    if way and way.holds_several >= several and not {target, other} & used:
                        found.append((target, other, state))
                        break
                if len(found) == count:
                    return found
    return []


def _asking(problem: Problem, goals: Sequence[RelationGoal]) -> Problem:
    return msgspec.structs.replace(problem, relations=tuple(goals))


def _stacked(
    problem: Problem, world: World, deeds: Sequence[tuple[_Pair, Float[np.ndarray, "A"]]]
) -> Problem | None:
    """Return a problem as it is after some actions, one after another; None if one of them fails."""
    scene, names = problem.scene(), problem.object_names
    contacts = tuple[tuple[int, int], ...]()
    for (target, other), action in deeds:
        aim = relative_to(world, OtherObject(names.index(other)))
        try:
            outcome = world.interact(scene, action, names.index(target), **aim)
        except InvalidValue:  # out of the arm's reach
            return None
        if outcome.kind != "carried" or outcome.disturbed:
            return None
        scene, contacts = outcome.end, outcome.contacts
    touching = tuple((names[one], names[other]) for one, other in contacts)
    return msgspec.structs.replace(problem, objects=standing(problem.objects, scene), touching=touching)


def _scattered(like: Problem, world: World, rng: np.random.Generator) -> Scene | None:
    """Set the objects of another scene apart on the table; None if they find no places."""
    before = like.scene()
    spots = draw_places(rng, before.features[:, :2], world.table)
    if spots is None:
        return None
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (len(before), 1))
    return Scene(before.features, np.column_stack([spots, before.features[:, 2] / 2]), upright)
