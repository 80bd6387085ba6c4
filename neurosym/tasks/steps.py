"""Plans as steps, and steps as text.

A step is one primitive on one object. `ground_plan` prints steps with cells and places, as the printed domain
has them; `plan_reading` reads what planners print.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from neurosym.checks import check_kind
from neurosym.tasks.moves import PUT_DOWN
from neurosym.wording import counted


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One step of a plan.

    Attributes:
        operator: Name of an operator, or `put-down-` and the name of the operator that lifted the object.
        object: Name of the object.
        place: Name of the place that the object is carried to, or of the other object that it is put on or
            into; empty if it is neither. Places and objects of a problem share no name.
    """

    operator: str
    object: str
    place: str = ""

    def __post_init__(self) -> None:
        for name in ("operator", "object", "place"):
            check_kind(f"{name} of a step", getattr(self, name), str, "its name")

    @property
    def puts_down(self) -> bool:
        """Whether the step puts an object down."""
        return self.operator.startswith(PUT_DOWN)

    @property
    def base(self) -> str:
        """Name of the operator in the table of operators."""
        return self.operator.removeprefix(PUT_DOWN)


Steps = tuple[tuple[str, ...], ...]
"""Operator and object of each step of a plan, and the place if it has one, as records hold it."""


def named_steps(steps: Iterable[PlanStep]) -> Steps:
    """Return the operator and the object of each step, and the place if it has one."""
    return tuple((step.operator, step.object, *filter(None, (step.place,))) for step in steps)


def primitives(steps: Iterable[PlanStep]) -> int:
    """Count the primitives of a plan: putting down belongs to its lift, and is counted nowhere."""
    return sum(not step.puts_down for step in steps)


def print_plan(steps: Sequence[PlanStep], comment: str = "") -> str:
    """Print a plan in IPC form, one `(operator object)` a line.

    Args:
        steps: The plan.
        comment: What the last line says; by default how many steps there are.
    """
    lines = [f"({' '.join(words)})" for words in named_steps(steps)]
    said = comment or counted(primitives(steps), "primitive")
    return "\n".join([*lines, f"; {' '.join(said.split())}"]) + "\n"
