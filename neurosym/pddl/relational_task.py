"""A problem as the encoding `relational` sees it: what bears what, and what can be done with what."""

from collections import Counter
from functools import cached_property
from itertools import permutations

from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.problems import Problem
from neurosym.related import bearers_of, loads_of, relations_of
from neurosym.tasks.carriers import Actions, actions_of, carriers_for
from neurosym.tasks.grades import GRADES, USUAL
from neurosym.tasks.pair_goals import puts_for
from neurosym.tasks.places import blockers, with_places
from neurosym.tasks.puts import Put, puts_of
from neurosym.tasks.task import MOST_BORNE, flattened, footprints


class Task:
    """A problem as the encoding sees it: what bears what, which places there are, and who has room there.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.

    Attributes:
        bearers: What bears each object that another one bears.
        flat: The problem with all objects on the table, and with its places.
        carriers: What carries each object to places most cheaply, by its name.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """

    def __init__(self, problem: Problem, grounding: Grounding):
        self.relations = relations_of(grounding, problem)
        self.grounding = grounding
        self.bearers = bearers_of(problem, self.relations)
        self.problem = with_pairs(problem, self.relations)
        self.flat = with_places(flattened(problem, self.bearers), grounding)
        self.apart = footprints(problem, self.bearers)
        carrying = {item.name: carriers_for(item, grounding, problem.tolerance) for item in self.flat.objects}
        self.carriers = {name: found[0].name for name, found in carrying.items() if found}

    @property
    def places(self) -> dict[str, tuple[float, float]]:
        """Where objects may be carried to: x and y of each place [m], by its name."""
        return self.flat.places if isinstance(self.flat.places, dict) else {}

    def state_name(self, state: str) -> str:
        """Return the name of a state that a goal names by its name or symbol."""
        return self.relations.state_named(state).name

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

    @cached_property
    def most_borne(self) -> int:
        """Return how many objects another one bears at most in a plan: as many as asked for, or a few."""
        wanted = Counter(reference for _, reference, _ in self.problem.related)
        at_first = (len(loads_of(name, self.bearers)) for name in self.problem.object_names)
        takes_more = any(put.takes_occupied for put in puts_of(self.grounding))
        return max([MOST_BORNE if takes_more else 1, *wanted.values(), *at_first])

    def needed(self) -> Actions:
        """Return what something at hand is likely to be done with; the rest only takes planners time."""
        every = actions_of(self.grounding)
        puts = {put.name for found in self.puts.values() for put in found}
        carriers = {*self.carriers.values()}
        return Actions(
            tuple(put for put in every.puts if put.name in puts),
            tuple(one for one in every.carriers if one.name in carriers),
        )

    def blockers(self, name: str, spot: tuple[float, float]) -> tuple[str, ...]:
        """Name the other objects on the table that stand at first where an object would come to stand."""
        found = blockers(name, spot, self.flat, self.apart)
        return tuple(other for other in found if other not in self.bearers)


_latest: list[tuple[Problem, Grounding, Task]] = []


def task_of(problem: Problem, grounding: Grounding) -> Task:
    """Return a problem as the encoding sees it; the same one while it is asked for of the same problem.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
    """
    for known, learned, task in _latest:
        if learned is grounding and known == problem:
            return task
    task = Task(problem, grounding)
    _latest[:] = [(problem, grounding, task)]
    return task
