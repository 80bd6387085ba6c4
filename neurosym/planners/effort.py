"""What a search may spend: work, which is counted, and never more time than the user allows.

Plans must not depend on how fast a machine is, or how busy. So every budget of ours counts what is looked at.
A limit of time is the user's own ceiling: it ends planning as a whole, with no plan instead of another one.

Where several searches share a budget, all count in states: one that A* without a heuristic looks at is 1.
Others weigh as many of these as they take as long as.
"""

import dataclasses
import math
import sys
import time
from collections.abc import Callable

from neurosym.planners.result import PlanResult, PlanStatus

PLACE = 10
"""How many states a place, a candidate or a beginning of a plan counts for that is looked at in Python."""
UNTOLD = 200_000
"""How many states a search counts for that does not tell."""


class TimeIsUp(Exception):
    """The user's ceiling cut in; whoever set the deadline turns this into a result."""


class WorkIsUp(Exception):
    """A budget that several searches share is spent; whoever set it turns this into a result."""


@dataclasses.dataclass(slots=True)
class Effort:
    """What was spent of a budget.

    Attributes:
        work: How much may be looked at: states, or beginnings of plans and ways to join them.
        deadline: When the user's time is up, by `time.perf_counter()` [s].
        spent: How much was.
    """

    work: int = sys.maxsize
    deadline: float = math.inf
    spent: int = 0

    def spend(self, amount: int = 1) -> bool:
        """Count some work, and say whether any is left to be spent.

        Args:
            amount: How much.

        Raises:
            TimeIsUp: If the deadline has passed.
        """
        check_time(self.deadline)
        self.spent += amount
        return not self.is_used_up

    @property
    def part(self) -> "Effort":
        """What is left, to be spent by what goes on beside others; its sum is counted here when it ends."""
        return Effort(max(0, self.work - self.spent), self.deadline)

    def check(self) -> None:
        """Raise if nothing may be spent any longer.

        Raises:
            TimeIsUp: If the deadline has passed.
            WorkIsUp: If the budget is spent.
        """
        check_time(self.deadline)
        if self.is_used_up:
            raise WorkIsUp

    @property
    def is_used_up(self) -> bool:
        """Whether the budget is spent, so that finding nothing means little."""
        return self.spent >= self.work


def check_time(deadline: float) -> None:
    """Raise `TimeIsUp` if a deadline by `time.perf_counter()` has passed."""
    if time.perf_counter() > deadline:
        raise TimeIsUp


def within(time_limit: float, search: Callable[[float], PlanResult]) -> PlanResult:
    """Search until a deadline; if it passes, that is the result, whatever was found by then.

    Args:
        time_limit: The user's ceiling, which may be infinite [s].
        search: Searches until a deadline by `time.perf_counter()` [s].

    Returns:
        What was found, with the seconds that it took.
    """
    begin = time.perf_counter()
    try:
        found = search(begin + time_limit)
    except TimeIsUp:
        reason = f"the time limit of {time_limit:g} s cut in"
        found = PlanResult(PlanStatus.TIMEOUT, (), 0.0, reason)
    return dataclasses.replace(found, seconds=time.perf_counter() - begin)


def all_spent(work: int) -> PlanResult:
    """Return the result of searches that spent their common budget of work, without a plan."""
    reason = f"the budget of {work:,} states for a plan was used up"
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason)
