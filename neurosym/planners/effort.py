"""What a search may spend: work, which is counted, and never more time than the user allows.

Plans must not depend on how fast a machine is, or how busy. So every budget of ours counts what is looked at.
A limit of time is the user's own ceiling: it ends planning as a whole, with no plan instead of another one.
"""

import dataclasses
import math
import sys
import time
from collections.abc import Callable

from neurosym.planners.result import PlanResult, PlanStatus


class TimeIsUp(Exception):
    """The user's ceiling cut in; whoever set the deadline turns this into a result."""


@dataclasses.dataclass(slots=True)
class Effort:
    """What was spent of a budget of work.

    Attributes:
        work: How many beginnings of plans, and ways to join plans, may be looked at.
        deadline: When the user's time is up, by `time.perf_counter()` [s].
        spent: How many were.
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
        found = timed_out(time_limit)
    return dataclasses.replace(found, seconds=time.perf_counter() - begin)


def timed_out(time_limit: float) -> PlanResult:
    """Return the result of a search that the user's ceiling [s] ended."""
    return PlanResult(PlanStatus.TIMEOUT, (), 0.0, f"the time limit of {time_limit:g} s cut in")
