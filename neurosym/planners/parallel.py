"""Planning for several objects at the same time, until one of them has no plan."""

import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial

from neurosym.errors import CannotStart
from neurosym.planners.process import end_calls
from neurosym.planners.result import PlanResult, PlanStatus

WORKERS = 2
"""How many objects are planned for at the same time."""


def plan_together(tasks: Sequence[Callable[[], PlanResult]]) -> tuple[PlanResult, ...]:
    """Make several plans at the same time; the results up to the first without a plan, in order.

    What still runs then, or when the user interrupts, is ended with all its processes.

    Args:
        tasks: Each makes a plan.

    Raises:
        CannotStart: If the system lets no thread or process be started.
    """
    threads: set[int] = set()

    def run(task: Callable[[], PlanResult]) -> PlanResult:
        threads.add(threading.get_ident())
        return task()

    pool = ThreadPoolExecutor(WORKERS)
    futures: list[Future[PlanResult]] = []
    results: list[PlanResult] = []
    try:
        for task in tasks:
            futures.append(_submitted(pool, partial(run, task)))
        for future in futures:
            results.append(future.result())
            if results[-1].status is not PlanStatus.SOLVED:
                break
    finally:
        _end(futures, threads)
        pool.shutdown(cancel_futures=True)
    return tuple(results)


def _submitted(pool: ThreadPoolExecutor, task: Callable[[], PlanResult]) -> Future[PlanResult]:
    try:
        return pool.submit(task)
    except RuntimeError as error:
        raise CannotStart("planner", str(error)) from error


def _end(futures: Sequence[Future[PlanResult]], threads: set[int]) -> None:
    """Kill what threads have started, again until they give up: a portfolio starts its next search.

    Whoever started a process also ends what that left behind.
    """
    for future in futures:
        future.cancel()
    while not all(future.done() for future in futures):
        end_calls(tuple(threads))
        time.sleep(0.02)
