"""A plan as ground actions of the printed domain, and what the printed problem must have for it.

A problem is printed before anybody plans. Goal regions leave out the edge of what the tolerance allows, since
grids round, and only some places are drawn. So the exact replay may take a plan that ends a cell beside the
region, or that uses a spot of the table that has no name yet. Such a plan says here which facts it needs; the
problem beside it is then printed with them (`problem_text`), and any validator takes the two together.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from neurosym.grounding import Grounding
from neurosym.pddl.moves import NUMERIC, STRIPS, Encoding
from neurosym.pddl.numeric import write_numeric
from neurosym.pddl.strips_plan import led_by, write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.syntax import Atom, words
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import understand


@dataclass(frozen=True, slots=True)
class GroundPlan:
    """A plan as ground actions.

    Attributes:
        encoding: The encoding of the domain that has these actions.
        lines: The ground actions, one a line.
        facts: What must hold in the problem at the start beside what any plan may count on.
        spots: Names of the spots that the problem must declare.
        led: Names of the objects that are led over cells.
        moves: Object and operator of what leads them.
    """

    encoding: Encoding
    lines: tuple[str, ...]
    facts: tuple[Atom, ...] = ()
    spots: tuple[str, ...] = ()
    led: tuple[str, ...] = ()
    moves: tuple[tuple[str, str], ...] = ()

    @property
    def text(self) -> str:
        """The plan in IPC form."""
        return "\n".join(self.lines) + "\n"

    def missing(self, problem: str) -> tuple[str, ...]:
        """Return the facts that the text of a problem lacks."""
        return tuple(fact for fact in map(words, self.facts) if fact not in problem)


def ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding = STRIPS
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
    steps, task = tuple(steps), understand(problem, grounding)
    if encoding == NUMERIC:
        return GroundPlan(NUMERIC, tuple(map(words, write_numeric(steps, task))))
    found = write(steps, StripsProblem(task, led=led_by(steps, task)))
    return GroundPlan(
        STRIPS,
        tuple(map(words, found.actions)),
        tuple(dict.fromkeys(found.facts)),
        tuple(dict.fromkeys(found.spots)),
        tuple(found.led),
        tuple(dict.fromkeys(found.moves)),
    )


def print_ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding = STRIPS
) -> str:
    """Print a plan as ground actions; see `ground_plan`."""
    return ground_plan(steps, problem, grounding, encoding).text
