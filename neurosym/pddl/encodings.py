"""The encodings: how a domain, its problems and plans are written, and how plans are read back.

A problem is printed before anybody plans. Goal regions leave out the edge of what the tolerance allows, since
grids round, and only some places are drawn. So the exact replay may take a plan that ends a cell beside the
region, or that uses a spot of the table that has no name yet. Such a plan says which facts it needs; the
problem beside it is then printed with them, and any validator takes the two together.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import ENCODINGS, FORMER, NUMERIC, STRIPS, EncodingName
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_domain, numeric_problem, read_numeric, write_numeric
from neurosym.pddl.strips import page
from neurosym.pddl.strips_plan import GroundPlan as GroundPlan
from neurosym.pddl.strips_plan import led_by, led_in, read, write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.syntax import Atom, Domain, PddlProblem
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import Task, understand

Plan = tuple[PlanStep, ...]


@dataclass(frozen=True, slots=True)
class Encoding:
    """How domains, problems and plans are written.

    Attributes:
        name: What it is called.
        domain: Writes a learned domain.
        problem: Writes a task, such that some plans are plans of it; takes off its goal regions what the
            rounding of so many steps may take.
        write: Writes a plan of a task as ground actions.
        read: Reads ground actions as a plan.
    """

    name: EncodingName
    domain: Callable[[Grounding], Domain]
    problem: Callable[[Task, Sequence[GroundPlan], int], PddlProblem]
    write: Callable[[Plan, Task], GroundPlan]
    read: Callable[[Sequence[Atom], Task], Plan]


def encoding_named(name: str) -> Encoding:
    """Return an encoding that is printed, or refuse one that earlier versions had, or that there is not."""
    check_former(name)
    if name not in _VALUES:
        raise UnknownChoice("encoding", name, ENCODINGS)
    return _VALUES[name]


def check_former(encoding: str) -> None:
    """Raise `InvalidValue` if earlier versions had an encoding, and it is gone.

    Args:
        encoding: Its name.
    """
    if encoding in FORMER:
        raise InvalidValue(
            f"The encoding {encoding} is gone: one page, {STRIPS!r}, says what it said; valid: "
            f"{', '.join(ENCODINGS)}."
        )


def domain_text(grounding: Grounding, encoding: EncodingName = STRIPS, *, costs: bool = True) -> str:
    """Print the domain; equal groundings give equal bytes.

    Args:
        grounding: The learned domain.
        encoding: `strips` for the page, or `numeric` for planners that take numbers.
        costs: Whether what steps cost is printed; some planners take no costs.

    Raises:
        UnknownChoice: If there is no such encoding.
    """
    return encoding_named(encoding).domain(grounding).text(costs=costs)


def ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: EncodingName = STRIPS
) -> GroundPlan:
    """Turn a plan into ground actions of the domain, cells and all, such that plan validators take it.

    Args:
        steps: The plan; every operator in it must be in the domain.
        problem: The problem it solves.
        grounding: The learned domain.
        encoding: `numeric`, or else the page.

    Raises:
        InvalidValue: If an operator is not in the domain, or not for its object, or leads off the grid.
    """
    return _VALUES.get(encoding, PAGE).write(tuple(steps), understand(problem, grounding))


def _page_problem(task: Task, plans: Sequence[GroundPlan], steps: int) -> PddlProblem:
    led = {name for plan in plans for name in plan.led}
    printed = StripsProblem(
        task,
        led=[name for name in task.names if name in led or name in task.led],
        kept=[move for plan in plans for move in plan.moves],
        steps=steps,
    )
    facts = sorted(fact for plan in plans for fact in plan.facts)
    return printed.data(facts, sorted({spot for plan in plans for spot in plan.spots}))


def _page_plan(steps: Plan, task: Task) -> GroundPlan:
    return write(steps, StripsProblem(task, led=led_by(steps, task)))


def _read_page(actions: Sequence[Atom], task: Task) -> Plan:
    return read(actions, StripsProblem(task, led=led_in(actions, task), every=True))


def _numeric_problem(task: Task, plans: Sequence[GroundPlan], steps: int) -> PddlProblem:
    del plans  # their regions leave out no more than what numbers round
    return numeric_problem(task, steps=steps * NUMERIC_STEPS)


def _numeric_plan(steps: Plan, task: Task) -> GroundPlan:
    return GroundPlan(NUMERIC, tuple(write_numeric(steps, task)))


PAGE = Encoding(STRIPS, page, _page_problem, _page_plan, _read_page)
NUMBERS = Encoding(NUMERIC, numeric_domain, _numeric_problem, _numeric_plan, read_numeric)
_VALUES: Mapping[str, Encoding] = {one.name: one for one in (PAGE, NUMBERS)}
