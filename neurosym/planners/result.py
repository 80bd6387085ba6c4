"""What every planner returns."""

from dataclasses import dataclass
from enum import Enum

from neurosym.tasks.steps import PlanStep

LONGEST_REASON = 400
"""How many characters of a reason that somebody else's planner gives are kept."""


class PlanStatus(Enum):
    """How a search for a plan ended.

    `NEAREST` is a plan that comes as near to the goal as was found. `UNSOLVABLE` means proved: there is no
    plan. `NOT_FOUND` is a search that came to its own end, in depth or work, and proves nothing; `TIMEOUT`
    is one that the user's limit of time ended.
    """

    SOLVED = "solved"
    NEAREST = "nearest"
    UNSOLVABLE = "unsolvable"
    NOT_FOUND = "not found"
    TIMEOUT = "timeout"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class PlanResult:
    """The outcome of planning; finding no plan is an outcome, not an error.

    Attributes:
        status: How the search ended.
        steps: The plan; empty unless solved or nearest.
        seconds: How long it took [s].
        reason: Why there is no plan, or what is to be said about the one found.
        depth: How many primitives were looked ahead, by a search that ended there.
        work: How much was looked at for it [states, see `effort`]; 0 if that is not known.
    """

    status: PlanStatus
    steps: tuple[PlanStep, ...]
    seconds: float
    reason: str = ""
    depth: int | None = None
    work: int = 0

    @property
    def has_plan(self) -> bool:
        """Whether there is a plan, be it to the goal or only as near to it as can be."""
        return self.status in (PlanStatus.SOLVED, PlanStatus.NEAREST)


@dataclass(frozen=True, slots=True)
class PlannerAnswer:
    """What a PDDL planner says: the text of a plan if it found one.

    Attributes:
        status: How the search ended.
        text: The plan in IPC form; empty unless solved.
        seconds: How long it took [s].
        reason: The planner's last words if there is no plan.
        work: How much it looked at [states, see `effort`]; None if that is not known.
    """

    status: PlanStatus
    text: str = ""
    seconds: float = 0.0
    reason: str = ""
    work: int | None = None
