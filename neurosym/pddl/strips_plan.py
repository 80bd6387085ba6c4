"""Plans of the page: steps as its ground actions, and its ground actions as steps."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding, is_lift
from neurosym.pair_operators import Case, case_of
from neurosym.pddl import strips
from neurosym.pddl.strips_problem import COUNTS, StripsProblem, motion_name, price_name, step_name
from neurosym.pddl.syntax import STRIPS, Atom, Course, EncodingName, words
from neurosym.problems import spot_named
from neurosym.tasks.options import PUT_DOWN, Move, Put
from neurosym.tasks.supports import loads_of
from neurosym.tasks.task import START, Task, check_place
from neurosym.tasks.transition import PlanStep, apply, start

_BEGUN_BY = {
    "rest": (strips.PUSH, "pushes"),
    "lift": (strips.LIFT, "lifts"),
    "put-down": (strips.PUT_DOWN, "lowers"),
}
"""What begins each kind of move, and what says that it is offered."""


@dataclass(frozen=True, slots=True)
class GroundPlan:
    """A plan as ground actions.

    Attributes:
        encoding: The encoding of the domain that has these actions.
        actions: The ground actions.
        facts: What must hold in the problem at the start beside what any plan may count on.
        spots: Names of the spots that the problem must declare.
        led: Names of the objects that are led over cells.
        moves: Object and operator of what leads them.
    """

    encoding: EncodingName
    actions: tuple[Atom, ...]
    facts: tuple[Atom, ...] = ()
    spots: tuple[str, ...] = ()
    led: tuple[str, ...] = ()
    moves: tuple[tuple[str, str], ...] = ()

    @property
    def lines(self) -> tuple[str, ...]:
        """The ground actions in IPC form, one a line."""
        return tuple(map(words, self.actions))

    @property
    def text(self) -> str:
        """The plan in IPC form."""
        return "\n".join(self.lines) + "\n"

    def missing(self, problem: str) -> tuple[str, ...]:
        """Return the facts that the text of a problem lacks."""
        return tuple(fact for fact in map(words, self.facts) if fact not in problem)


class Misread(InvalidValue):
    """A plan that says what is not so.

    Attributes:
        number: The number of the action that is wrong, from 0.
    """

    def __init__(self, problem: str, number: int):
        super().__init__(problem)
        self.number = number


def led_by(steps: Iterable[PlanStep], task: Task) -> tuple[str, ...]:
    """Name the objects that are led over cells, in a plan or without any."""
    pushed = {step.object for step in steps if not step.place}
    return tuple(name for name in task.names if name in pushed or name in task.led)


def led_in(actions: Iterable[Atom], task: Task) -> tuple[str, ...]:
    """Name the objects that ground actions lead over cells, and those that would be led anyway."""
    begun = {words[1] for words in actions if words[0] in (strips.PUSH, strips.LIFT) and len(words) > 1}
    return tuple(name for name in task.names if name in begun or name in task.led)


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
    if grounding.relation_named(operator):
        return strips.PUT
    found = grounding.operator_named(operator)
    return strips.PUT_AT if grounding.carries(found) else strips.LIFT if is_lift(found) else strips.PUSH


def write(steps: Sequence[PlanStep], printed: StripsProblem) -> GroundPlan:
    """Write a plan as ground actions of a problem, in which all is led that steps lead over cells."""
    return _Writer(printed).write(steps)


class _Writer:
    """The actions written so far, and where objects are by then."""

    def __init__(self, printed: StripsProblem):
        self._printed, self._task, self._grid = printed, printed.task, printed.grid
        self._now = start(self._task)
        self._cells = {
            name: list(self._grid.anchor(self._task.flat.object_named(name).position)) for name in printed.led
        }
        self._lifted: tuple[str, str] | None = None
        self._actions, self._facts = list[Atom](), list[Atom]()
        self._spots, self._moves = list[str](), list[tuple[str, str]]()

    def write(self, steps: Sequence[PlanStep]) -> GroundPlan:
        task = self._task
        for number, step in enumerate(steps):
            name = step.object
            if step.place:
                (self._put if task.grounding.relation_named(step.base) else self._carry)(step)
            else:
                self._lead(step)
                is_last = not any(later.object == name for later in steps[number + 1 :])
                if is_last and task.places and name in task.problem.goals and name in self._now.stands:
                    self._reach_cell(name)
                    self._say(strips.LEAVE, name, self._now.stands[name])
            self._now = apply(task, self._now, step)
        noted = {words[1] for words in self._actions if words[0] in (strips.REACH_CELL, strips.REACH_LIFTED)}
        for name in sorted(task.problem.goals):
            if name not in self._printed.led or self._was_carried(name):
                self._say(strips.REACH_PLACE, name, self._now.stands.get(name, f"{START}{name}"))
            elif name not in noted:
                self._reach_cell(name)
        return GroundPlan(
            STRIPS,
            tuple(self._actions),
            facts=tuple(dict.fromkeys(self._facts)),
            spots=tuple(dict.fromkeys(self._spots)),
            led=self._printed.led,
            moves=tuple(dict.fromkeys(self._moves)),
        )

    def _say(self, *words: str) -> None:
        self._actions.append(words)

    def _was_carried(self, name: str) -> bool:
        return any(words[:2] == (strips.TAKE, name) for words in self._actions)

    # Cells

    def _lead(self, step: PlanStep) -> None:
        name = step.object
        every = {move.name: move for move in self._task.every_move_on(self._printed.cells, name)}
        move = every.get(step.operator)
        if move is None or name not in self._cells:
            raise InvalidValue(
                f"{step.operator} is not in the domain for {name}, so the plan cannot be printed."
            )
        if self._was_carried(name):
            raise InvalidValue(f"{name} is carried and then led over cells, so the plan cannot be printed.")
        shifts = [step_name(axis, move.cells[axis]) for axis in (0, 1)]
        price = [price_name(move.cost)] if move.kind != "put-down" else []
        verb, offered = _BEGUN_BY[move.kind]
        self._say(verb, name, motion_name(move), *shifts, *price)
        self._facts.append((offered, name, motion_name(move), *shifts, *price))
        self._moves.append((name, move.operator.name))
        for axis, mover in enumerate((strips.MOVE_X, strips.MOVE_Y)):
            cells = self._step(name, move, axis)
            self._say(mover, name, shifts[axis], *cells)
            self._facts.append((f"{'xy'[axis]}-sum", shifts[axis], *cells))
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
            self._facts.append(("goal-lifted", *self._lifted))
        else:
            self._say(strips.REACH_CELL, name, x, y)
            self._facts.append(("goal-on-table", name))
        self._facts.append(("goal-cell", name, x, y))

    # Places and relations

    def _take(self, name: str) -> tuple[str, ...]:
        """Take an object, and return where it is from, if the domain tells."""
        borne = self._now.supports.get(name)
        if borne is None:
            self._say(strips.TAKE, name, self._now.stands[name])
            return (strips.FROM_SPOT,) if self._task.grounding.relations else ()
        count = len(loads_of(borne.by, self._now.supports))
        perch = self._printed.perch(borne.state, borne.by)
        self._say(strips.TAKE_OFF, name, perch, borne.by, COUNTS[count - 1], COUNTS[count])
        return (strips.FROM_PERCH,)

    def _carry(self, step: PlanStep) -> None:
        name, place, task = step.object, step.place, self._task
        if name not in task.carriers:
            raise InvalidValue(f"nothing carries {name} to places, so the plan cannot be printed.")
        origin = self._take(name)
        room = self._printed.room(name, place)
        for link in room:
            if link[0] == "then":
                self._say(strips.NOTE_CLEAR, *link[1:])
        cost = price_name(task.carry_cost(name, borne=origin == (strips.FROM_PERCH,)))
        self._say(strips.PUT_AT, name, place, *origin, cost)
        if spot_named(place) and place not in task.places:
            self._spots.append(place)
        self._facts += [("can-take", name), ("can-carry", name, *origin, cost), ("free", place), *room]

    def _put(self, step: PlanStep) -> None:
        name, other, supports = step.object, step.place, self._now.supports
        count = sum(one != name for one in loads_of(other, supports))
        load = len(loads_of(name, supports))
        option = self._option(step, case_of(name in supports, bool(count), bool(load)))
        (origin,) = self._take(name)
        said = [name, self._printed.perch(option.state, other), other, origin]
        if load:
            if other not in self._now.stands:
                raise InvalidValue(f"{name} bears something, and {other} stands at no place.")
            said += [self._now.stands[other], COUNTS[load - 1], COUNTS[load]]
        way, cost = self._printed.way_of((name, other), option), price_name(option.cost(self._task.grounding))
        verb = strips.PUT_LOADED if load else strips.PUT
        self._say(verb, *said, COUNTS[count], COUNTS[count + 1], way, cost)

    def _option(self, step: PlanStep, case: Case) -> Put:
        """Return what is offered for a step in a case."""
        found = self._task.grounding.relation_named(step.base)
        promise = found.promise if found else None
        for option in self._task.put_options.get((step.object, step.place), ()):
            if promise is not None and (option.state.symbol, option.case) == (promise.state, case):
                return option
        raise InvalidValue(f"{step.operator} is not offered for {step.object} with {step.place} there.")


def read(actions: Sequence[Atom], printed: StripsProblem) -> tuple[PlanStep, ...]:
    """Read ground actions of the page as steps.

    Each action must be possible where it stands. That an object is at its goal, and that it has room at a
    spot, is for the exact replay to judge.

    Args:
        actions: The ground actions.
        printed: The problem, in which every object that they lead over cells is led.

    Raises:
        Misread: If an action is not possible, or the plan lacks something.
    """
    holds = {*printed.data().atoms, *_granted(actions, printed)}
    course, steps = Course(strips.page(printed.task.grounding), holds), list[PlanStep]()
    for number, (name, *arguments) in enumerate(actions):
        try:
            course.take(name, arguments)
            steps += _begun(name, arguments, printed)
        except (InvalidValue, UnknownChoice) as error:
            raise Misread(str(error).rstrip("."), number) from error
    if actions and (lack := _lacking(actions, course.holds, printed.task)):
        raise Misread(lack, len(actions) - 1)
    return tuple(steps)


def _granted(actions: Iterable[Atom], printed: StripsProblem) -> Iterator[Atom]:
    """List what is for the replay to judge: goals over cells, and room at spots of the table."""
    task = printed.task
    for name, *said in actions:
        if name == strips.REACH_CELL and len(said) == 3:
            yield from (("goal-on-table", said[0]), ("goal-cell", *said))
        elif name == strips.REACH_LIFTED and len(said) == 4:
            thing, motion, x, y = said
            yield from (("goal-lifted", thing, motion), ("goal-cell", thing, x, y))
        elif name == strips.PUT_AT and len(said) > 1 and said[0] in task.names:
            thing, place = said[:2]
            if place in task.places or spot_named(place):
                yield from printed.room(thing, place)
            if place not in task.places:
                yield ("free", place)


def _begun(name: str, arguments: Sequence[str], printed: StripsProblem) -> Iterator[PlanStep]:
    """Yield the step that an action begins, if it begins one."""
    task, thing = printed.task, arguments[0]
    for kind, (verb, _) in _BEGUN_BY.items():
        if name == verb:
            moves = printed.moves[thing]
            found = next(one for one in moves if (motion_name(one), one.kind) == (arguments[1], kind))
            yield PlanStep(found.name, thing)
    if name == strips.PUT_AT:
        check_place(arguments[1], task.flat, task.grounding)
        yield PlanStep(task.carriers[thing][0].name, thing, arguments[1])
    if name in (strips.PUT, strips.PUT_LOADED):
        perch, other, origin = arguments[1:4]
        is_borne, is_occupied = origin == strips.FROM_PERCH, arguments[-4] != COUNTS[0]
        case = case_of(is_borne, is_occupied, name == strips.PUT_LOADED)
        option = next(
            one
            for one in task.put_options[thing, other]
            if printed.perch(one.state, other) == perch and one.case == case
        )
        yield PlanStep(option.name, thing, other)


def _lacking(actions: Sequence[Atom], holds: set[Atom], task: Task) -> str:
    """Say what a plan leaves open in the end."""
    if taken := next((atom for atom in holds if atom[0] == "taken"), None):
        return f"{taken[1]} was taken, and is put nowhere"
    if ("ready",) not in holds:
        return f"the step is not complete; {strips.MOVE_X} and {strips.MOVE_Y} come after it"
    missing = [name for name in sorted(task.problem.goals) if ("done", name) not in holds]
    if missing and any(name.startswith("reach-") for name, *_ in actions):
        return f"after it nothing notes that {missing[0]} is at its goal, though that is noted of others"
    return ""
