"""Following a written plan from the start of its problem, action by action, to see that it says what is so.

Objects are followed over cells, from place to place, and on and into one another, as the operators promise
for them; each argument must be the one that is true there. What stands for no step of its own must stand
where it can: the further parts of a move right after its first, what looks on places before what is carried
there, what takes an object before what puts it elsewhere, and what notes that a goal is met after the last
step with its object.

Plans in short, `(operator object)` or `(operator object place)`, have none of this, and are asked for none.
"""

import dataclasses
from collections.abc import Sequence

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pddl.moves import MOVE, REACH_GOAL, Encoding
from neurosym.pddl.place_domain import LEAVE as LEAVE_START
from neurosym.pddl.place_domain import LOOK, REACH
from neurosym.pddl.plan_cells import Cells, without_part
from neurosym.pddl.plan_lines import WrittenAction
from neurosym.pddl.plan_places import Places, Unlike, check_same, printed
from neurosym.pddl.plan_text import PlanStep
from neurosym.problems import Problem


class Misread(InvalidValue):
    """A plan that says what is not so.

    Attributes:
        step: Which step it is about, counted from 1.
        reached: How far the plan was followed: the number of the action that is wrong, and whether it has as
            many arguments as would be right.
    """

    def __init__(self, problem: str, step: int, reached: tuple[int, bool]):
        super().__init__(problem)
        self.step, self.reached = step, reached


def follow(
    actions: Sequence[WrittenAction], problem: Problem, grounding: Grounding, encoding: Encoding
) -> tuple[PlanStep, ...]:
    """Return the steps that the actions of a plan are.

    Args:
        actions: The actions.
        problem: The problem that the plan is for.
        grounding: The learned domain, on the grid that cells in the plan are of.
        encoding: How it names cells: `operators` all of a step in one action, and `stepwise` an axis at a
            time, as `sas` and `places` do.

    Raises:
        Misread: If the plan says what is not so, or lacks something.
    """
    return _Follower(actions, problem, grounding, encoding).steps()


class _Follower:
    """Follows a plan; see `follow`."""

    def __init__(
        self, actions: Sequence[WrittenAction], problem: Problem, grounding: Grounding, encoding: Encoding
    ):
        self._actions, self._problem, self._grounding = actions, problem, grounding
        self._operators = {one.name: one for one in grounding.every_operator}
        self._cells = Cells(actions, problem, grounding, encoding)
        self._places = Places(actions, problem, grounding)
        self._steps: list[PlanStep] = []
        self._reached: set[str] = set()
        self._at = 0

    def steps(self) -> tuple[PlanStep, ...]:
        try:
            while self._at < len(self._actions):
                self._follow(self._actions[self._at])
                self._at += 1
            self._at -= 1
            self._check_end()
        except (InvalidValue, UnknownChoice) as error:
            fits = isinstance(error, Unlike) and error.has_as_many
            raise Misread(str(error).rstrip("."), self._number(), (self._at, fits)) from error
        return tuple(self._steps)

    def _number(self) -> int:
        """Return the number of the step at hand: putting down belongs to its lift, and what notes to none."""
        action = self._actions[self._at]
        done = sum(not step.puts_down for step in self._steps)
        begins = without_part(action.name) in self._operators or self._places.put_named(action.name)
        return max(1, done + bool(begins))

    def _follow(self, action: WrittenAction) -> None:
        """Take an action, with those that belong to it."""
        name = action.name
        if name == REACH_GOAL and not action.arguments:
            return self._check_only_left(action)
        thing = self._thing(action)
        if name == REACH_GOAL:
            return self._reach(action, (name, thing, *self._cells.spot(thing)))
        if name == REACH:
            return self._reach(action, (name, thing, self._places.place_of(thing)))
        if name == LOOK:
            return self._places.look(action, thing)
        if name == LEAVE_START:
            return self._leave_start(action, thing)
        if self._places.takes(name):
            return self._places.take(action)
        if put := self._places.put_named(name):
            return self._done(PlanStep(put.name, thing, self._places.put(put, action, thing)))
        return self._move(action, thing)

    def _check_only_left(self, action: WrittenAction) -> None:
        """Raise unless nothing follows what a planner adds itself: that the goal is met, of no object."""
        if any(one.name != action.name or one.arguments for one in self._actions[self._at :]):
            raise InvalidValue("it names no object; valid: with an object and its cells, or at the end")

    def _thing(self, action: WrittenAction) -> str:
        """Return the object that an action is about."""
        words = action.arguments[self._cells.is_carrier(action.name) :]
        if not words:
            raise InvalidValue("it names no object; valid: (operator object), and what else belongs to it")
        if words[0] not in self._problem.object_names:
            raise UnknownChoice("object", words[0], self._problem.object_names)
        return words[0]

    def _reach(self, action: WrittenAction, right: tuple[str, ...]) -> None:
        """Note that an object is at its goal."""
        check_same(action, right)
        self._reached.add(right[1])

    def _leave_start(self, action: WrittenAction, thing: str) -> None:
        if thing not in self._reached:
            raise InvalidValue(f"({REACH_GOAL} {thing} ...) is missing before it")
        self._places.leave_start(action, thing)

    def _move(self, action: WrittenAction, thing: str) -> None:
        """Take a step, with the actions that are further parts of it."""
        self._check_begun(action)
        step = PlanStep(action.name, thing)
        operator = self._grounding.operator_named(step.base)
        self._check_fit(step, operator)
        if self._grounding.carries(operator):
            return self._done(dataclasses.replace(step, place=self._places.carry(action, step)))
        parts = self._cells.lead(step)
        for number, words in enumerate(parts):
            at = self._at + (number > 0)
            if at == len(self._actions) or self._actions[at].name != words[0]:
                raise InvalidValue(f"the step is not complete; {printed(words)} comes after it")
            self._at = at
            check_same(self._actions[at], words)
        return self._done(step)

    def _check_begun(self, action: WrittenAction) -> None:
        """Raise if an action is a further part of a step, which nothing begins."""
        begun = without_part(action.name)
        if self._cells.is_carrier(action.name):
            begun = action.arguments[0].removeprefix(MOVE)
        if begun != action.name and PlanStep(begun, "").base in self._operators:
            raise InvalidValue(f"it goes on with a step that nothing begins; ({begun} ...) comes before it")

    def _check_fit(self, step: PlanStep, operator: Operator) -> None:
        grounding, category = self._grounding, self._problem.object_named(step.object).category
        if operator.category != category:
            raise InvalidValue(
                f"{operator.name} is for objects of category {grounding.category(operator.category).name}, "
                f"and {step.object} is of category {grounding.category(category).name}"
            )
        if step.puts_down and not is_lift(operator):
            raise InvalidValue(
                f"{operator.name} does not end with the object held, so nothing can be put down"
            )

    def _done(self, step: PlanStep) -> None:
        self._reached.discard(step.object)
        self._steps.append(step)

    def _check_end(self) -> None:
        """Raise if something is left open at the end of the plan."""
        if taken := self._places.taken:
            raise InvalidValue(f"{taken.arguments[0]} was taken by {taken.text}, and is put nowhere")
        notes = any(one.name in (REACH_GOAL, REACH) and one.arguments for one in self._actions)
        missing = sorted(set(self._problem.goals) - self._reached)
        if notes and missing:
            raise InvalidValue(
                f"after it ({REACH_GOAL} {missing[0]} ...) or ({REACH} {missing[0]} ...) is missing, since "
                "the plan notes of others that they are at their goals, or moves it later"
            )
