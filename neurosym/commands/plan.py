"""The command `neurosym plan`: a problem to a plan."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, Optional

from tyro.conf import arg

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.exit_codes import NO_RESULT
from neurosym.commands.options import Folder, ProblemName, TimeLimit, Tolerance, check_time_limit, opened
from neurosym.commands.plan_streams import STANDARD, check_output, hand_over
from neurosym.console import be_quiet, is_quiet, say, say_next
from neurosym.wording import counted, quoted

if TYPE_CHECKING:
    from neurosym.stages.plan_records import PlanRecord

UNLIKELY = 0.1
"""Below this chance it is said that a plan seldom goes through."""


def plan(
    folder: Folder,
    problem: ProblemName,
    planner: Annotated[
        str, arg(help="One that `neurosym planners` lists, or your own as module:factory.")
    ] = "fast-downward",
    time_limit: TimeLimit = None,
    encoding: Annotated[
        Optional[Literal["strips", "numeric", "sas"]],
        arg(help="For PDDL planners: strips, numeric or sas, instead of the usual."),
    ] = None,
    whole: Annotated[bool, arg(help="For PDDL planners: all objects at once instead of one by one.")] = False,
    nearest: Annotated[
        bool,
        arg(help="If there is no plan, plan as near to the goal as objects come (exit code 3 if it misses)."),
    ] = False,
    tolerance: Tolerance = None,
    output: Annotated[
        Optional[Path],
        arg(metavar="FILE", help="Write the plan here, too; - prints it to standard output, and only it."),
    ] = None,
    json: Json = False,
) -> int:
    """Plan for a problem; exit code 3 if there is no plan, with the reason.

    `bfs` is the paper's breadth-first search over what the network predicts, three deep without relations;
    `counting` finds the fewest primitives there can be. Any other planner can be given DIR/domain.pddl and
    DIR/problems/PROBLEM.pddl, and its plan file executed.
    """
    from neurosym.reading import read_json
    from neurosym.stages.plan_records import PlanRecord, written_steps
    from neurosym.stages.planning import plan_stage

    check_time_limit(time_limit)
    check_output(output, json)
    be_quiet(is_quiet() or output == STANDARD)
    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    stage = plan_stage(
        domain,
        name,
        planner=planner,
        time_limit=time_limit,
        encoding=encoding,
        whole=whole,
        nearest=nearest,
        tolerance=tolerance,
    )
    plan_file, record_file, _ = stage.outputs
    had_plan = (domain / plan_file).exists()
    domain.perform(stage, again=True)
    record = read_json(domain / record_file, PlanRecord)
    _say_plan(record)
    if had_plan and not (domain / plan_file).exists():
        say(f"removed {folder / plan_file}, the plan of an earlier call")
    written = written_steps(domain, name, record.planner)
    if written:
        why = "" if record.unprinted in ("", record.misses) else f": {record.unprinted}"
        said = f"; these steps are no plan of the printed problem{why}" if record.unprinted else ""
        say(f"wrote {folder / written}{said}")
        within = "" if record.tolerance is None else f" --tolerance {record.tolerance:g}"
        say_next(f"neurosym execute {quoted(folder)} {name} {quoted(folder / written)}{within}")
    if output and written:
        hand_over(domain / written, output)
    answer(record, file=str(domain / written) if written else None)
    return 0 if record.solved else NO_RESULT


def _say_plan(record: "PlanRecord") -> None:
    from neurosym.stages.plan_records import MORE_MOTIONS

    if record.solved:
        remark = f" ({record.reason})" if record.reason else ""
        chance = 1.0 if record.chance is None else record.chance
        count = counted(record.primitives, "primitive")
        say(f"{count} in {_spent():.2f} s of CPU{remark}, {_likely(chance)} to go as promised:")
    else:
        say(f"no plan for {record.problem} ({record.status.value}, {_spent():.2f} s of CPU): {record.reason}")
        if record.steps:
            say("as near as it comes:")
    _say_steps(record.steps)
    if record.solved and record.steps and record.chance_replanned is not None:
        motions = record.primitives + MORE_MOTIONS
        likely = _likely(record.chance_replanned)
        say(f"planned anew on the way, {likely} to reach the goal within {motions} motions")
    if record.misses:
        say(
            f"note: by what was rehearsed, {record.misses}; "
            "`neurosym execute` plans anew on the way (unless --replans 0)"
        )
    elif record.solved and record.chance is not None and record.chance < UNLIKELY:
        say(
            f"note: a plan of {counted(record.primitives, 'primitive')} seldom goes through as it stands; "
            "let `neurosym execute` plan anew on the way (unless --replans 0), or bring the goals nearer"
        )


def _spent() -> float:
    """Return the CPU of this process and of all it started [s]."""
    return sum(os.times()[:4])


def _likely(chance: float) -> str:
    if chance < 0.005:
        return "less than 1% likely"
    return f"{chance:.0%} likely" if chance < 0.995 else "more than 99% likely"


def _say_steps(steps: tuple[tuple[str, ...], ...]) -> None:
    for words in steps:
        say(f"  ({' '.join(words)})")
