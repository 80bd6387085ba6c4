"""The command `neurosym compare`: the same drawn tasks to several planners."""

import math
from typing import TYPE_CHECKING, Annotated

from tyro.conf import arg

from neurosym.choices import TOLERANCE
from neurosym.commands.answers import Json, answer_in
from neurosym.commands.options import (
    CPUS,
    Folder,
    Seed,
    Task,
    TimeLimit,
    Workers,
    check_least,
    check_time_limit,
    opened,
)
from neurosym.console import progress_bar, say, say_next, show_table
from neurosym.errors import InvalidValue
from neurosym.stages.manifest import Claim
from neurosym.wording import counted, quoted

if TYPE_CHECKING:
    from neurosym.evaluation.comparison_summary import Comparison
    from neurosym.stages.verdict import Verdict


def compare(
    folder: Folder,
    tasks: Annotated[int, arg(help="How many tasks to draw.")] = 100,
    objects: Annotated[int, arg(help="Objects in each; each gets a goal.")] = 1,
    seed: Seed = 0,
    task: Task = None,
    planners: Annotated[
        tuple[str, ...],
        arg(help="bfs (reads the network), bfs-operators (the table), ..., or module:factory."),
    ] = ("bfs", "fast-downward"),
    workers: Workers = CPUS,
    tolerance: Annotated[float, arg(help="How near each object must come to its goal [m].")] = TOLERANCE,
    time_limit: TimeLimit = None,
    json: Json = False,
) -> int:
    """Give the same drawn tasks to several planners, and judge each plan.

    Task number i is drawn with seed SEED + i. A plan is followed blindly, and once more with replanning by
    the planner that made it. Interrupt it when you like: what is measured is kept in DIR/comparison, and the
    same command goes on.
    """
    from neurosym.commands.tables import show_verdict
    from neurosym.evaluation.comparison import check_planners
    from neurosym.evaluation.comparison_summary import summarise
    from neurosym.evaluation.comparison_tasks import Order, compare_tasks
    from neurosym.files import write_json
    from neurosym.worlds.workers import check_workers

    check_workers(workers)
    check_least(1, tasks=tasks, objects=objects)
    check_least(0, seed=seed)
    check_time_limit(time_limit)
    if not 0 < tolerance < math.inf:
        raise InvalidValue(f"tolerance = {tolerance} must be a number greater than 0.")
    answer, planners = answer_in(json), tuple(dict.fromkeys(planners))
    check_planners(planners, folder)
    domain = opened(folder)
    order = Order(domain.path, objects, planners, tolerance, time_limit, task)
    records = []
    with domain.claimed(Claim.SHARED), progress_bar("comparing") as advance:
        for record in compare_tasks(order, range(seed, seed + tasks), workers=workers):
            records.append(record)
            advance(len(records), tasks)
    comparison = summarise(records, planners)
    write_json(order.place / "comparison.json", comparison)
    kind = f"{counted(objects, 'object')}, {1000 * tolerance:g} mm" + (f", {task}" if task else "")
    seeds = f"seed {seed}" if tasks == 1 else f"seeds {seed} to {seed + tasks - 1}"
    title = f"{counted(comparison.counted, 'task')} drawn with {seeds}, {kind}"
    _show(comparison, title)
    say(f"wrote {order.place / 'comparison.json'}, and a file for each task")
    verdict = _judged(comparison, tolerance)
    show_verdict(verdict)
    like = "" if objects == 1 else f" --objects {objects}"
    like += "" if task is None else f" --task {task}"
    like += "" if tolerance == TOLERANCE else f" --tolerance {tolerance:g}"
    say_next(f"neurosym new-problem {quoted(folder)} --name mine --seed {seed}{like}")
    answer(comparison, file=str(order.place / "comparison.json"), verdict=verdict)
    return 0


def _judged(comparison: "Comparison", tolerance: float) -> "Verdict":
    from neurosym.stages.verdict import Tries, judge_tries

    tries = {
        name: Tries(tally.reached_with_replanning, tally.found, comparison.counted)
        for name, tally in comparison.planners.items()
    }
    return judge_tries(tries, how="with replanning", tolerance=tolerance)


def _show(comparison: "Comparison", title: str) -> None:
    """Print how each planner did, and why where it did not."""
    tasks = max(comparison.counted, 1)
    columns = [title, *comparison.planners]
    shares = {
        "plan found": "found",
        "valid in the model": "valid",
        "predicted to arrive by the network": "predicted",
        "reached, followed blindly": "reached",
        "reached with replanning": "reached_with_replanning",
    }
    rows = [
        [words, *(f"{getattr(tally, field) / tasks:.0%}" for tally in comparison.planners.values())]
        for words, field in shares.items()
    ]
    tallies = comparison.planners.values()
    rows.append(["primitives, mean", *("-" if t.steps is None else f"{t.steps:.2f}" for t in tallies)])
    rows.append(
        ["planning, median [s]", *("-" if t.seconds is None else f"{t.seconds:.3f}" for t in tallies)]
    )
    rows.append(["own steps of those performed then", *(f"{t.own} of {t.performed}" for t in tallies)])
    show_table("the same tasks to each planner", columns, rows)
    if comparison.met_at_start:
        more = comparison.met_at_start
        said = "task needs no step and is" if more == 1 else "tasks need no step and are"
        say(f"{more} more {said} not counted")
    say(f"no plan by any of them: {comparison.solved_by_none} of {counted(comparison.counted, 'task')}")
    for name, tally in comparison.planners.items():
        for words, reasons in (
            ("no plan where another has one", tally.unfound),
            ("plan not valid", tally.invalid),
            ("missed, followed blindly", tally.missed),
            ("missed in spite of replanning", tally.missed_with_replanning),
        ):
            for reason, count in reasons.items():
                say(f"  {name}: {words}: {reason} ({count})")
