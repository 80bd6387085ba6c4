"""Where objects stand, or what bears them, while a written plan is followed by places and by relations."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.pddl.durative import MOST_OVER
from neurosym.pddl.place_domain import LEAVE as LEAVE_START
from neurosym.pddl.place_domain import LOOK, NOWHERE
from neurosym.pddl.place_problem import START
from neurosym.pddl.plan_cells import Words
from neurosym.pddl.plan_lines import WrittenAction
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.relational_domain import LADEN, LEAVE
from neurosym.pddl.relational_problem import COUNTS
from neurosym.pddl.relational_replay import Following
from neurosym.problems import Problem
from neurosym.related import is_relational, loads_of, relating
from neurosym.relation_goals import pair_key
from neurosym.relation_operators import RelationOperator
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.places import blockers, with_places
from neurosym.wording import counted


class Unlike(InvalidValue):
    """A ground action that is not the one that would be right.

    Attributes:
        has_as_many: Whether it has as many arguments as that.
    """

    def __init__(self, problem: str, *, has_as_many: bool):
        super().__init__(problem)
        self.has_as_many = has_as_many


def check_same(action: WrittenAction, right: Words) -> None:
    """Raise `Unlike` unless an action has the arguments that are right where it stands.

    Args:
        action: The action.
        right: What it would have to be; the name is known to be right.
    """
    written, wanted = action.arguments, right[1:]
    if len(written) != len(wanted):
        said = f"it has {counted(len(written), 'argument')}, where {printed(right)} would be right"
        raise Unlike(said, has_as_many=False)
    for number, (word, other) in enumerate(zip(written, wanted, strict=True), start=1):
        if word != other:
            said = f"argument {number} is {word}, where {other} would be right"
            raise Unlike(said, has_as_many=True)


def printed(words: Words) -> str:
    """Return a ground action in the IPC form."""
    return f"({' '.join(words)})"


class Places:
    """Where objects stand, or what bears them.

    Args:
        actions: The actions of a plan.
        problem: The problem it is for.
        grounding: The learned domain.
    """

    def __init__(self, actions: Sequence[WrittenAction], problem: Problem, grounding: Grounding):
        self._actions, self._problem, self._grounding = actions, problem, grounding
        self._stands = {name: f"{START}{name}" for name in problem.object_names}
        self._looked: dict[tuple[str, str], int] = {}
        self._puts: dict[str, RelationOperator | None] = {}
        self.taken: WrittenAction | None = None

    def takes(self, name: str) -> bool:
        """Say whether an action takes an object from where it is, for the next to put it elsewhere."""
        return self._grounding.relations is not None and name.startswith(LEAVE) and name != LEAVE_START

    def put_named(self, name: str) -> RelationOperator | None:
        """Return the operator on pairs of that name, with a load or without; None if there is none."""
        if name not in self._puts:
            found = relating(name, self._grounding)
            self._puts[name] = found or relating(name.removesuffix(LADEN), self._grounding)
        return self._puts[name]

    def place_of(self, name: str) -> str:
        """Return where an object stands.

        Args:
            name: The object.

        Raises:
            InvalidValue: If it stands at no place.
        """
        if name not in self._standing:
            raise InvalidValue(f"{name} stands at no place by then")
        return self._standing[name]

    @property
    def _standing(self) -> dict[str, str]:
        return self._now.stands if self._now else self._stands

    def leave_start(self, action: WrittenAction, name: str) -> None:
        """Note that an object that was led away has left where it started."""
        check_same(action, (LEAVE_START, name, self.place_of(name)))
        del self._stands[name]

    def look(self, action: WrittenAction, name: str) -> None:
        """Note that a place is free that another one overlaps."""
        if len(action.arguments) != 4:
            raise InvalidValue(f"it names {len(action.arguments)}; valid: an object and three places")
        place, here = action.arguments[1:3]
        chain, looked = self._chain(name, place), self._looked.get((name, place), 0)
        if here not in chain[:-1]:
            valid = ", ".join(chain[:-1]) or "none"
            raise InvalidValue(f"argument 3 is {here}; valid: what {place} overlaps, which is {valid}")
        number = chain.index(here)
        check_same(action, (LOOK, name, place, here, chain[number + 1]))
        if number > looked:
            self._check_looked(name, place, chain[: number + 1])
        other = here.removeprefix(START)
        is_taken = self.taken is not None and self.taken.arguments[0] == other
        if not is_taken and self._standing.get(other) == here:
            raise InvalidValue(f"argument 3 is {here}, which is not free by then: {other} stands there")
        self._looked[name, place] = max(looked, number + 1)

    def carry(self, action: WrittenAction, step: PlanStep) -> str:
        """Carry an object to a place, and return which: the only one that is named, or the second."""
        name, places = step.object, action.arguments[1:]
        if self._now:
            return self._carry_in(self._now, action, step)
        to = places[min(1, len(places) - 1)] if places else ""
        self._check_place(to)
        if len(places) == 2:
            check_same(action, (action.name, name, self.place_of(name), to))
            self._check_looked(name, to, self._chain(name, to))
        elif len(places) > 2:
            *over, nowhere = self._chain(name, to)
            over += [nowhere] * (MOST_OVER - len(over))
            check_same(action, (action.name, name, self.place_of(name), to, *over))
        self._stands[name] = to
        return to

    def take(self, action: WrittenAction) -> None:
        """Remember what takes an object; whether that is right shows where it is put."""
        if self.taken:
            raise InvalidValue(f"{self.taken.arguments[0]} was taken before, and is put nowhere")
        self.taken = action

    def put(self, operator: RelationOperator, action: WrittenAction, target: str) -> str:
        """Put an object on or into another, and return which."""
        reference, now = action.arguments[1] if len(action.arguments) > 1 else "", self._now
        self._check_pair(operator, target, reference)
        assert now is not None
        step = operator.name, target, reference
        if self._are_taken or len(action.arguments) > 2:
            if loads_of(target, now.bearers) and reference not in now.stands:
                raise InvalidValue(f"{target} bears something, and {reference} stands at no place")
            self._check_taken(now, action, step)
        now.do(step)
        return reference

    def _carry_in(self, now: Following, action: WrittenAction, step: PlanStep) -> str:
        """Carry an object to a place where objects may bear one another."""
        place = action.arguments[1] if len(action.arguments) > 1 else ""
        self._check_place(place)
        words = step.operator, step.object, place
        if self._are_taken or len(action.arguments) > 2:
            self._check_taken(now, action, words)
            self._check_looked(step.object, place, self._chain(step.object, place))
        now.do(words)
        return place

    def _check_taken(self, now: Following, action: WrittenAction, step: tuple[str, str, str]) -> None:
        """Raise unless the actions are right that take an object and put it elsewhere."""
        lines = [tuple(line.strip("()").split()) for line in now.ground(step)]
        if self._is_lifted:
            lines = [tuple(word for word in words if word not in COUNTS) for words in lines]
        (taking, *_, putting), taken = lines, self.taken
        if taken is None:
            raise InvalidValue(f"{printed(taking)} is missing before it")
        if (taken.name, *taken.arguments) != taking:
            raise InvalidValue(f"{taken.text} stands before it, where {printed(taking)} would be right")
        check_same(action, (action.name, *putting[1:]))
        if action.name != putting[0]:
            raise InvalidValue(f"{printed(putting)} would be right")
        self.taken = None

    @cached_property
    def _now(self) -> Following | None:
        """How objects bear one another by now; None if none does, and none is to."""
        if self._grounding.relations is None:
            return None
        puts = any(self.put_named(one.name) for one in self._actions)
        if puts or self._are_taken or is_relational(self._problem, self._grounding):
            return Following(self._problem, self._grounding)
        return None

    @cached_property
    def _are_taken(self) -> bool:
        """Whether objects are taken from where they are by actions of their own."""
        return any(self.takes(one.name) for one in self._actions)

    @cached_property
    def _is_lifted(self) -> bool:
        """Whether nothing is counted."""
        words = {word for one in self._actions for word in one.arguments}
        return words.isdisjoint(COUNTS)

    @cached_property
    def _looks(self) -> bool:
        """Whether the plan notes what is free; if it does nowhere, that is not asked for."""
        return any(one.name == LOOK for one in self._actions)

    @cached_property
    def _placed(self) -> Problem:
        """The problem with its places, and all its objects on the table."""
        return self._now.task.flat if self._now else with_places(self._problem, self._grounding)

    @cached_property
    def _apart(self) -> Float[np.ndarray, "M M 2"]:
        return footprints_apart(self._placed)

    def _check_place(self, place: str) -> None:
        if place.startswith(START):
            raise InvalidValue(
                f"Nothing is carried to {place}: no object goes back to where one stood at the start"
            )
        self._grounding.table.check(place, *self._placed.place_named(place))

    def _chain(self, name: str, place: str) -> tuple[str, ...]:
        """List the places that must be free for an object to have room at one, and what comes after them."""
        spot = self._placed.place_named(place)
        if self._now:
            others = self._now.task.blockers(name, spot)
        else:
            others = blockers(name, spot, self._placed, self._apart)
        return (*(f"{START}{other}" for other in others), NOWHERE)

    def _check_looked(self, name: str, place: str, chain: Words) -> None:
        """Raise unless it was noted of all places of a chain but the last that they are free, if of any."""
        looked = self._looked.get((name, place), 0)
        if self._looks and looked < len(chain) - 1:
            words = (LOOK, name, place, *chain[looked : looked + 2])
            raise InvalidValue(f"{printed(words)} is missing before it")

    def _check_pair(self, operator: RelationOperator, target: str, reference: str) -> None:
        problem = self._problem
        if reference not in problem.object_names or reference == target:
            valid = [name for name in problem.object_names if name != target]
            raise UnknownChoice("other object", reference, valid)
        kinds = with_pairs(problem, self._grounding.relations).pairs
        kind = kinds.get(pair_key(target, reference)) if isinstance(kinds, dict) else None
        if not operator.is_for(kind):
            raise InvalidValue(
                f"{operator.name} is for pairs of the kind {operator.pair}, and {target} with {reference} is "
                f"of the kind {kind}"
            )
