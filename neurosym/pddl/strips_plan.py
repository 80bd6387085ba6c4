"""Plans of the page: steps as its ground actions, and its ground actions as steps."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding, is_lift
from neurosym.pair_operators import case_of
from neurosym.pddl import strips
from neurosym.pddl.grid import anchor
from neurosym.pddl.strips_problem import (
    BEGUN_BY,
    COUNTS,
    StripsProblem,
    motion_name,
    price_name,
    words_of,
    zone_name,
)
from neurosym.pddl.syntax import STRIPS, Atom, Course, EncodingName, words
from neurosym.problems import spot_named
from neurosym.tasks.options import PUT_DOWN, put_named, step_cost
from neurosym.tasks.supports import loads_of
from neurosym.tasks.task import START, Task
from neurosym.tasks.transition import PlanStep, apply, start


@dataclass(frozen=True, slots=True)
class GroundPlan:
    """A plan as ground actions."""

    encoding: EncodingName  # the encoding of the domain that has these actions
    actions: tuple[Atom, ...]  # the ground actions
    facts: tuple[Atom, ...] = ()  # at the start, beside what any plan may count on
    spots: tuple[str, ...] = ()  # names of the spots that the problem must declare
    led: tuple[str, ...] = ()  # names of the objects that are led over cells
    moves: tuple[tuple[str, str], ...] = ()  # object and operator of what leads them

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


def led_in(actions: Iterable[Atom], task: Task) -> tuple[str, ...]:
    """Name the objects that ground actions lead over cells, and those that would be led anyway."""
    begun = {words[1] for words in actions if words[0] in ("push", "lift") and len(words) > 1}
    return tuple(name for name in task.names if name in begun or name in task.led)


def action_for(operator: str, grounding: Grounding) -> str:
    """Name the action of the page that a step with an operator of that name is an instance of."""
    if operator.startswith(PUT_DOWN):
        return "put-down"
    found = grounding.operator_named(operator)
    return {"pair": "put", "place": "put-at", "side": "set-upright"}.get(found.frame) or (
        "lift" if is_lift(found) else "push"
    )


def write(steps: Sequence[PlanStep], printed: StripsProblem) -> GroundPlan:
    """Write a plan as ground actions of a problem, in which all is led that steps lead over cells."""
    writer, task = _Writer(printed), printed.task
    for number, step in enumerate(steps):
        writer.take(step, is_last=all(later.object != step.object for later in steps[number + 1 :]))
    noted = {words[1] for words in writer.actions if words[0] in ("reach-cell", "reach-lifted")}
    for name in sorted(task.problem.goals):
        if name not in printed.led or writer.was_carried(name):
            place = writer.now.stands.get(name, f"{START}{name}")
            writer.actions.append(("reach-place", name, place))
        elif name not in noted:
            writer.reach_cell(name)
    return GroundPlan(
        STRIPS,
        tuple(writer.actions),
        facts=tuple(dict.fromkeys(writer.facts)),
        spots=tuple(dict.fromkeys(writer.spots)),
        led=printed.led,
        moves=tuple(dict.fromkeys(writer.moves)),
    )


_WITHOUT_ZONE = {"reach-cell": 4, "reach-lifted": 5}
"""So many words such an action had in earlier versions, which did not say in which zone of the goal."""


class _Writer:
    """The actions written so far, what they need, and where objects are by then."""

    def __init__(self, printed: StripsProblem):
        self._printed, self._task = printed, printed.task
        self.now = start(self._task)
        flat = self._task.flat
        self._cells = {
            name: [*anchor(self._printed.grid, flat.object_named(name).position)] for name in printed.led
        }
        self._lifted: tuple[str, str] | None = None
        self.actions, self.facts = list[Atom](), list[Atom]()
        self.spots, self.moves = list[str](), list[tuple[str, str]]()

    def take(self, step: PlanStep, *, is_last: bool) -> None:
        """Write a step, which may be the last with its object."""
        name, task = step.object, self._task
        if task.grounding.operator_named(step.base).frame == "side":
            if name not in self.now.lying:
                raise InvalidValue(f"{name} need not be set upright, so the plan cannot be printed.")
            cost = step_cost(task.lying[name], task.grounding)
            self.actions.append(("set-upright", name, price_name(cost)))
        elif step.place:
            (self._put if task.grounding.operator_named(step.base).frame == "pair" else self._carry)(step)
        else:
            self._lead(step)
            if is_last and task.places and name in task.problem.goals and name in self.now.stands:
                self.reach_cell(name)
                self.actions.append(("leave", name, self.now.stands[name]))
        self.now = apply(task, self.now, step)

    def was_carried(self, name: str) -> bool:
        """Say whether an object was taken from a spot."""
        return any(words[:2] == ("take", name) for words in self.actions)

    def _lead(self, step: PlanStep) -> None:
        name = step.object
        every = {move.name: move for move in self._task.every_move_on(self._printed.cells, name)}
        move = every.get(step.operator)
        if move is None or name not in self._cells:
            raise InvalidValue(
                f"{step.operator} is not in the domain for {name}, so the plan cannot be printed."
            )
        if self.was_carried(name):
            raise InvalidValue(f"{name} is carried and then led over cells, so the plan cannot be printed.")
        verb, offered = BEGUN_BY[move.kind]
        told, here = words_of(name, move), self._cells[name]
        self.actions.append((verb, *told))
        self.facts.append((offered, *told))
        self.moves.append((name, move.operator.name))
        for axis, mover in enumerate(("move-x", "move-y")):
            before, here[axis] = here[axis], here[axis] + move.cells[axis]
            if not 0 <= here[axis] < self._printed.grid[axis].count:
                raise InvalidValue(f"{move.name} leads {name} off the grid along {'xy'[axis]}.")
            cells = [self._printed.grid[axis].name(cell) for cell in (before, here[axis])]
            self.actions.append((mover, name, told[2 + axis], *cells))
            self.facts.append((f"{'xy'[axis]}-sum", told[2 + axis], *cells))
        self._lifted = (name, motion_name(move)) if move.kind == "lift" else None

    def reach_cell(self, name: str) -> None:
        """Note that an object is at its goal, over cells."""
        x, y, _ = self._cells[name]
        zone = zone_name(self._printed.regions[name].zone.get((x, y), 1))
        here = [self._printed.grid[0].name(x), self._printed.grid[1].name(y), zone]
        if self._lifted and self._lifted[0] == name:
            self.actions.append(("reach-lifted", *self._lifted, *here))
            self.facts.append(("goal-lifted", *self._lifted, zone))
        else:
            self.actions.append(("reach-cell", name, *here))
            self.facts.append(("goal-on-table", name, zone))
        self.facts.append(("goal-cell", name, *here))

    def _take(self, name: str) -> tuple[str, ...]:
        """Take an object, and return where it is from, if the domain tells."""
        borne = self.now.supports.get(name)
        if borne is None:
            self.actions.append(("take", name, self.now.stands[name]))
            return (strips.FROM_SPOT,) if self._task.grounding.relations else ()
        count = len(loads_of(borne.by, self.now.supports))
        perch = self._printed.perch(borne.state, borne.by)
        self.actions.append(("take-off", name, perch, borne.by, COUNTS[count - 1], COUNTS[count]))
        return (strips.FROM_PERCH,)

    def _carry(self, step: PlanStep) -> None:
        name, place, task = step.object, step.place, self._task
        if name not in task.carriers:
            raise InvalidValue(f"nothing carries {name} to places, so the plan cannot be printed.")
        origin, room = self._take(name), self._printed.room(name, place)
        self.actions += [("note-clear", *link[1:]) for link in room if link[0] == "then"]
        cost = price_name(task.carry_cost(name, borne=origin == (strips.FROM_PERCH,)))
        self.actions.append(("put-at", name, place, *origin, cost))
        if spot_named(place) and place not in task.places:
            self.spots.append(place)
        self.facts += [("can-take", name), ("can-carry", name, *origin, cost), ("free", place), *room]

    def _put(self, step: PlanStep) -> None:
        name, other, supports, task = step.object, step.place, self.now.supports, self._task
        count, load = sum(one != name for one in loads_of(other, supports)), len(loads_of(name, supports))
        case = case_of(name in supports, bool(count), bool(load))
        put, options = put_named(step.base, task.grounding), task.put_options.get((name, other), ())
        option = next((one for one in options if put and (one.state, one.case) == (put.state, case)), None)
        if option is None:
            raise InvalidValue(f"{step.operator} is not offered for {name} with {other} there.")
        (origin,) = self._take(name)
        said = [name, self._printed.perch(option.state, other), other, origin]
        if load:
            if other not in self.now.stands:
                raise InvalidValue(f"{name} bears something, and {other} stands at no place.")
            said += [self.now.stands[other], COUNTS[load - 1], COUNTS[load]]
        way, cost = self._printed.way_of((name, other), option), price_name(option.cost(task.grounding))
        verb = "put-loaded" if load else "put"
        self.actions.append((verb, *said, COUNTS[count], COUNTS[count + 1], way, cost))


def read(actions: Sequence[Atom], printed: StripsProblem) -> Iterator[PlanStep | None]:
    """Read ground actions of the page, of a problem in which every object that they lead over cells is led.

    Returns an iterator over the steps that the actions begin, None for an action that begins none. Each must
    be possible where it stands, and the plan lack nothing. That an object is at its goal, and that it has
    room at a spot, is for the exact replay to judge.
    """
    actions = [(*one, zone_name(1)) if len(one) == _WITHOUT_ZONE.get(one[0]) else one for one in actions]
    holds = {*printed.data().atoms, *_granted(actions, printed)}
    return _followed(actions, printed, Course(strips.page(printed.task.grounding), holds))


def _followed(actions: Sequence[Atom], printed: StripsProblem, course: Course) -> Iterator[PlanStep | None]:
    task = printed.task
    for name, *arguments in actions:
        course.take(name, arguments)
        yield _begun(name, arguments, printed)
    taken = [atom[1] for atom in course.holds if atom[0] == "taken"]
    missing = [name for name in sorted(task.problem.goals) if ("done", name) not in course.holds]
    lack = ""
    if taken:
        lack = f"{taken[0]} was taken, and is put nowhere"
    elif ("ready",) not in course.holds:
        lack = "the step is not complete; move-x and move-y come after it"
    elif missing and any(name.startswith("reach-") for name, *_ in actions):
        lack = f"after it nothing notes that {missing[0]} is at its goal, though that is noted of others"
    if actions and lack:
        raise InvalidValue(lack)


def _granted(actions: Iterable[Atom], printed: StripsProblem) -> Iterator[Atom]:
    """List what is for the replay to judge: goals over cells, and room at spots of the table."""
    for name, *said in actions:
        if name == "reach-cell" and len(said) == 4:
            yield from (("goal-on-table", said[0], said[3]), ("goal-cell", *said))
        elif name == "reach-lifted" and len(said) == 5:
            yield from (("goal-lifted", *said[:2], said[4]), ("goal-cell", said[0], *said[2:]))
        elif name == "put-at" and len(said) > 1 and said[0] in printed.task.names:
            thing, place = said[:2]
            is_known = place in printed.task.places
            if is_known or spot_named(place):
                yield from printed.room(thing, place)
            if not is_known:
                yield ("free", place)


def _begun(name: str, arguments: Sequence[str], printed: StripsProblem) -> PlanStep | None:
    """Return the step that an action begins, if it begins one."""
    task, thing = printed.task, arguments[0]
    if kind := next((kind for kind, (verb, _) in BEGUN_BY.items() if verb == name), None):
        wanted, moves = (arguments[1], kind), printed.moves[thing]
        return PlanStep(next(one.name for one in moves if (motion_name(one), one.kind) == wanted), thing)
    if name == "set-upright":
        return PlanStep(task.lying[thing].name, thing)
    if name == "put-at":
        task.grounding.table.check(arguments[1], *task.flat.place_named(arguments[1]))
        return PlanStep(task.carriers[thing][0].name, thing, arguments[1])
    if name in ("put", "put-loaded"):
        perch, other, origin = arguments[1:4]
        is_borne, is_occupied = origin == strips.FROM_PERCH, arguments[-4] != COUNTS[0]
        case = case_of(is_borne, is_occupied, name == "put-loaded")
        options = [one for one in task.put_options[thing, other] if one.case == case]
        put = next(one.name for one in options if printed.perch(one.state, other) == perch)
        return PlanStep(put, thing, other)
    return None
