"""Plans of the page: steps as its ground actions, and its ground actions as steps."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding, is_lift
from neurosym.pddl import strips
from neurosym.pddl.strips_problem import COUNTS, StripsProblem, motion_name, price_name, step_name
from neurosym.pddl.syntax import Atom, Course
from neurosym.related import Borne, loads_of, relating
from neurosym.spots import spot_named
from neurosym.tasks.moves import PUT_DOWN, Move
from neurosym.tasks.places import START, check_place
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import PutOption, Task

Words = tuple[str, ...]
"""A ground action: its name, and its arguments."""


@dataclass(slots=True)
class Written:
    """A plan as ground actions.

    Attributes:
        actions: The ground actions.
        facts: What must hold at the start beside what the problem says.
        spots: Names of the spots that the problem must declare.
        led: Names of the objects that are led over cells.
        moves: Object and operator of each step that leads one.
    """

    actions: list[Words] = field(default_factory=list)
    facts: list[Atom] = field(default_factory=list)
    spots: list[str] = field(default_factory=list)
    led: list[str] = field(default_factory=list)
    moves: list[tuple[str, str]] = field(default_factory=list)


def write(steps: Sequence[PlanStep], printed: StripsProblem) -> Written:
    """Write a plan as ground actions of the page.

    Args:
        steps: The plan.
        printed: The problem, in which every object that steps lead over cells is led.

    Raises:
        InvalidValue: If a step is nothing that the problem offers, or leads off the grid.
    """
    return _Writer(printed).write(steps)


def led_by(steps: Iterable[PlanStep], task: Task) -> tuple[str, ...]:
    """Name the objects that are led over cells, in a plan or without any.

    Args:
        steps: The plan.
        task: The task.
    """
    pushed = {step.object for step in steps if not step.place}
    return tuple(name for name in task.names if name in pushed or name in task.led)


def action_for(operator: str, grounding: Grounding) -> str:
    """Name the action of the page that a step with an operator is an instance of.

    Args:
        operator: Name of the operator of a step.
        grounding: The learned domain.

    Raises:
        UnknownChoice: If there is no such operator.
    """
    if operator.startswith(PUT_DOWN):
        return strips.PUT_DOWN
    if relating(operator, grounding):
        return strips.PUT
    found = grounding.operator_named(operator)
    return strips.PUT_AT if grounding.carries(found) else strips.LIFT if is_lift(found) else strips.PUSH


class _Writer:
    """The actions written so far, and where objects are by then."""

    def __init__(self, printed: StripsProblem):
        self._printed, self._task = printed, printed.task
        task = self._task
        self._grid = printed.grid
        self._cells = {
            name: list(self._grid.anchor(task.flat.object_named(name).position)) for name in printed.led
        }
        self._stands = {name: f"{START}{name}" for name in task.names if name not in task.supports}
        self._supports = dict(task.supports)
        self._lifted: tuple[str, str] | None = None
        self._found = Written(led=[*printed.led])

    def write(self, steps: Sequence[PlanStep]) -> Written:
        task = self._task
        for number, step in enumerate(steps):
            if not step.place:
                self._lead(step)
                is_last = not any(later.object == step.object for later in steps[number + 1 :])
                if (
                    is_last
                    and task.places
                    and step.object in task.problem.goals
                    and step.object in self._stands
                ):
                    self._reach_cell(step.object)
                    self._say(strips.LEAVE, step.object, self._stands[step.object])
            elif relating(step.base, task.grounding):
                self._put(step)
            else:
                self._carry(step)
        noted = {
            words[1] for words in self._found.actions if words[0] in (strips.REACH_CELL, strips.REACH_LIFTED)
        }
        for name in sorted(task.problem.goals):
            if name in self._printed.led and not self._was_carried(name):
                if name not in noted:
                    self._reach_cell(name)
            else:
                self._say(strips.REACH_PLACE, name, self._stands.get(name, f"{START}{name}"))
        return self._found

    def _say(self, *words: str) -> None:
        self._found.actions.append(words)

    def _need(self, *facts: Atom) -> None:
        self._found.facts += facts

    def _was_carried(self, name: str) -> bool:
        return any(words[:2] == (strips.TAKE, name) for words in self._found.actions)

    # Cells

    def _lead(self, step: PlanStep) -> None:
        name, task = step.object, self._task
        every = {move.name: move for move in task.every_move_on(self._printed.cells, name)}
        move = every.get(step.operator)
        if move is None or name not in self._cells:
            raise InvalidValue(
                f"{step.operator} is not in the domain for {name}, so the plan cannot be printed."
            )
        if self._was_carried(name):
            raise InvalidValue(f"{name} is carried and then led over cells, so the plan cannot be printed.")
        verb = {"rest": strips.PUSH, "lift": strips.LIFT, "put-down": strips.PUT_DOWN}[move.kind]
        words = [name, motion_name(move), *(step_name(axis, move.cells[axis]) for axis in (0, 1))]
        if move.kind != "put-down":
            words.append(price_name(move.cost))
        self._say(verb, *words)
        self._found.moves.append((name, move.operator.name))
        self._need(
            {"rest": ("pushes", *words), "lift": ("lifts", *words), "put-down": ("lowers", *words)}[move.kind]
        )
        for axis, mover in enumerate((strips.MOVE_X, strips.MOVE_Y)):
            before, then = self._step(name, move, axis)
            self._say(mover, name, step_name(axis, move.cells[axis]), before, then)
            self._need((f"{'xy'[axis]}-sum", step_name(axis, move.cells[axis]), before, then))
        self._lifted = (name, motion_name(move)) if move.kind == "lift" else None

    def _step(self, name: str, move: Move, axis: int) -> tuple[str, str]:
        """Lead an object along an axis, and return the cells that it leaves and comes to."""
        here = self._cells[name]
        before, here[axis] = here[axis], here[axis] + move.cells[axis]
        if not 0 <= here[axis] <= self._grid.last[axis]:
            raise InvalidValue(f"{move.name} leads {name} off the grid along {'xy'[axis]}.")
        return self._grid.cell_name(axis, before), self._grid.cell_name(axis, here[axis])

    def _reach_cell(self, name: str) -> None:
        x, y = (self._grid.cell_name(axis, self._cells[name][axis]) for axis in (0, 1))
        if self._lifted and self._lifted[0] == name:
            self._say(strips.REACH_LIFTED, *self._lifted, x, y)
            self._need(("goal-lifted", *self._lifted))
        else:
            self._say(strips.REACH_CELL, name, x, y)
            self._need(("goal-on-table", name))
        self._need(("goal-cell", name, x, y))

    # Places and relations

    def _take(self, name: str) -> tuple[str, ...]:
        """Take an object, and return where it is from, if the domain tells."""
        has_origins = bool(self._task.grounding.relations)
        if borne := self._supports.pop(name, None):
            count = len(loads_of(borne.by, self._supports))
            self._say(
                strips.TAKE_OFF,
                name,
                self._printed.perch(borne.state, borne.by),
                borne.by,
                COUNTS[count],
                COUNTS[count + 1],
            )
            return (strips.FROM_PERCH,)
        self._say(strips.TAKE, name, self._stands.pop(name))
        return (strips.FROM_SPOT,) if has_origins else ()

    def _carry(self, step: PlanStep) -> None:
        name, place, task = step.object, step.place, self._task
        if name not in task.carriers:
            raise InvalidValue(f"nothing carries {name} to places, so the plan cannot be printed.")
        origin = self._take(name)
        row = self._printed.room(name, place)
        chain = [words[3:] for words in row if words[0] == "then"]
        for here, then in chain:
            self._say(strips.NOTE_CLEAR, name, place, here, then)
        cost = price_name(task.carry_cost(name, borne=origin == (strips.FROM_PERCH,)))
        self._say(strips.PUT_AT, name, place, *origin, cost)
        if spot_named(place) and place not in task.places:
            self._found.spots.append(place)
        self._need(("can-take", name), ("can-carry", name, *origin, cost), ("free", place), *row)
        self._stands[name] = place

    def _put(self, step: PlanStep) -> None:
        name, other = step.object, step.place
        borne = name in self._supports
        others = [one for one in loads_of(other, self._supports) if one != name]
        laden = bool(loads_of(name, self._supports))
        option = self._option(step, borne=borne, occupied=bool(others), laden=laden)
        (origin,) = self._take(name)
        count = len(loads_of(other, self._supports))
        way = self._printed.way_of((name, other), option)
        counts = (COUNTS[count], COUNTS[count + 1])
        words = [name, self._printed.perch(option.state, other), other, origin]
        if laden:
            if other not in self._stands:
                raise InvalidValue(f"{name} bears something, and {other} stands at no place.")
            load = len(loads_of(name, self._supports))
            words += [self._stands[other], COUNTS[load - 1], COUNTS[load]]
        self._say(strips.PUT_LOADED if laden else strips.PUT, *words, *counts, way, price_name(option.cost))
        self._supports[name] = Borne(other, option.state)

    def _option(self, step: PlanStep, *, borne: bool, occupied: bool, laden: bool) -> PutOption:
        """Return what the problem offers for a step."""
        found = relating(step.base, self._task.grounding)
        promise = found.promise if found else None
        for option in self._task.put_options.get((step.object, step.place), ()):
            is_same = promise is not None and option.state.symbol == promise.state
            if is_same and (option.borne, option.occupied, option.laden) == (borne, occupied, laden):
                return option
        raise InvalidValue(f"{step.operator} is not offered for {step.object} with {step.place} there.")


def read(actions: Sequence[Words], printed: StripsProblem) -> tuple[PlanStep, ...]:
    """Read ground actions of the page as steps.

    Each action must be possible where it stands. That an object is at its goal, and that it has room at a
    spot, is for the exact replay to judge.

    Args:
        actions: The ground actions.
        printed: The problem, in which every object that they lead over cells is led.

    Raises:
        Misread: If an action is not possible, or the plan lacks something.
    """
    return _Reader(printed, actions).read()


class Misread(InvalidValue):
    """A plan that says what is not so.

    Attributes:
        number: The number of the action that is wrong, from 0.
    """

    def __init__(self, problem: str, number: int):
        super().__init__(problem)
        self.number = number


def led_in(actions: Iterable[Words], task: Task) -> tuple[str, ...]:
    """Name the objects that ground actions lead over cells, and those that would be led anyway."""
    begun = {words[1] for words in actions if words[0] in (strips.PUSH, strips.LIFT) and len(words) > 1}
    return tuple(name for name in task.names if name in begun or name in task.led)


class _Reader:
    """What has been read so far; see `read`."""

    def __init__(self, printed: StripsProblem, actions: Sequence[Words]):
        self._printed, self._task, self._actions = printed, printed.task, actions
        holds = {*printed.data().atoms, *self._granted()}
        self._course = Course(strips.page(printed.task.grounding), holds)
        self._steps: list[PlanStep] = []

    def read(self) -> tuple[PlanStep, ...]:
        for number, (name, *arguments) in enumerate(self._actions):
            try:
                before = (
                    frozenset(self._course.holds) if name in (strips.PUT, strips.PUT_LOADED) else frozenset()
                )
                self._course.take(name, arguments)
                self._steps += self._step(name, arguments, before)
            except (InvalidValue, UnknownChoice) as error:
                raise Misread(str(error).rstrip("."), number) from error
        if self._actions and (lack := self._lacking()):
            raise Misread(lack, len(self._actions) - 1)
        return tuple(self._steps)

    def _granted(self) -> Iterator[Atom]:
        """List what is for the replay to judge: goals over cells, and room at spots of the table."""
        for name, *words in self._actions:
            if name == strips.REACH_CELL and len(words) == 3:
                yield from (("goal-on-table", words[0]), ("goal-cell", *words))
            elif name == strips.REACH_LIFTED and len(words) == 4:
                thing, motion, x, y = words
                yield from (("goal-lifted", thing, motion), ("goal-cell", thing, x, y))
            elif name == strips.PUT_AT and len(words) > 1 and words[0] in self._task.names:
                thing, place = words[:2]
                if place in self._task.places or spot_named(place):
                    yield from self._printed.room(thing, place)
                if place not in self._task.places:
                    yield ("free", place)

    def _step(self, name: str, arguments: Sequence[str], before: frozenset[Atom]) -> Iterator[PlanStep]:
        """Yield the step that an action begins, if it begins one."""
        task = self._task
        if name in (strips.PUSH, strips.LIFT, strips.PUT_DOWN):
            thing, motion, *_ = arguments
            kind = {strips.PUSH: "rest", strips.LIFT: "lift", strips.PUT_DOWN: "put-down"}[name]
            moves = self._printed.moves[thing]
            move = next(one for one in moves if (motion_name(one), one.kind) == (motion, kind))
            yield PlanStep(move.name, thing)
        elif name == strips.PUT_AT:
            check_place(arguments[1], task.flat, task.grounding)
            yield PlanStep(task.carriers[arguments[0]][0].name, arguments[0], arguments[1])
        elif name in (strips.PUT, strips.PUT_LOADED):
            thing, perch, other, origin = arguments[:4]
            count = next(atom[2] for atom in before if atom[:2] == ("bears", other))
            case = (origin == strips.FROM_PERCH, count != COUNTS[0], name == strips.PUT_LOADED)
            option = next(
                one
                for one in task.put_options[thing, other]
                if self._printed.perch(one.state, other) == perch and one.case[1:] == case
            )
            yield PlanStep(option.put.name, thing, other)

    def _lacking(self) -> str:
        """Say what the plan leaves open in the end."""
        holds = self._course.holds
        if taken := next((atom for atom in holds if atom[0] == "taken"), None):
            return f"{taken[1]} was taken, and is put nowhere"
        if ("ready",) not in holds:
            return f"the step is not complete; {strips.MOVE_X} and {strips.MOVE_Y} come after it"
        goals = [("done", name) for name in sorted(self._task.problem.goals)]
        missing = [name for atom, name in ((goal, goal[1]) for goal in goals) if atom not in holds]
        notes = any(name.startswith("reach-") for name, *_ in self._actions)
        if notes and missing:
            return f"after it nothing notes that {missing[0]} is at its goal, though that is noted of others"
        return ""
