"""The command `neurosym execute`: a plan, run in the world."""

from pathlib import Path
from typing import Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.exit_codes import NO_RESULT
from neurosym.commands.options import Folder, ProblemName, TimeLimit, Tolerance, check_time_limit, opened
from neurosym.commands.plan_streams import STANDARD, saved_plan
from neurosym.commands.showing import Gif, Gui, Strip, say_written, showing_of
from neurosym.console import say, say_next
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.wording import quoted


def execute(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[
        Positional[Path],
        arg(metavar="PLAN", help="Any planner's plan, in IPC form; - reads it from standard input."),
    ],
    replanner: Annotated[
        str, arg(help="Whom to ask for a new plan: see `neurosym planners`, or module:factory.")
    ] = "fast-downward",
    replans: Annotated[
        Optional[int],
        arg(
            metavar="N",
            help="How many new plans may be asked for; 0: the plan is followed blindly to its end. "
            "Without it: 10, and 2 more for each primitive of the plan. Ten in a row that come no nearer "
            "end the run.",
        ),
    ] = None,
    time_limit: TimeLimit = None,
    disturb: Annotated[
        Optional[int],
        arg(metavar="SEED", help="Nudge an object by 3 to 8 cm once during the run, drawn from this seed."),
    ] = None,
    tolerance: Tolerance = None,
    gif: Gif = None,
    strip: Strip = None,
    gui: Gui = False,
    json: Json = False,
) -> int:
    """Run a plan in the simulator, each step beside its promise; exit code 3 if it misses.

    After every step what is left of the plan is replayed from what is seen. If it would miss the goal, a new
    plan is made, which takes into account what each object did so far.
    """
    from neurosym.commands.tables import show_run
    from neurosym.stages.executing import execute_stage, load_run
    from neurosym.stages.layout import run_file
    from neurosym.stages.plan_records import planned_tolerance

    check_time_limit(time_limit)
    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    if plan_file == STANDARD:
        plan_file = saved_plan(domain, name)
    if plan_file.exists() and not plan_file.is_file():
        raise InvalidFile(plan_file, "it is no file; name one that holds a plan")
    if not plan_file.is_file():
        raise InvalidValue(
            f"There is no plan file {plan_file}; `neurosym plan {quoted(folder)} {name}` writes one."
        )
    made_for = plan_file.stem.split(".")[0]
    if made_for != name and made_for in domain.problem_names():
        say(f"note: {plan_file} seems to be made for {made_for}, not for {name}")
    planned = planned_tolerance(plan_file)
    if planned is not None and tolerance is None:
        within = f"within {1000 * planned:g} mm"
        say(f"note: {plan_file} is a plan to come {within}; --tolerance {planned:g} judges it by that")
    stage = execute_stage(
        domain,
        name,
        plan_file,
        replanner=replanner,
        replans=replans,
        time_limit=time_limit,
        nudge_seed=disturb,
        tolerance=tolerance,
        showing=showing_of(gif, strip, gui),
    )
    domain.perform(stage, again=True)
    run = load_run(domain, name, plan_file)
    if not run.plan:
        say(f"note: {plan_file} holds no step")
    show_run(run)
    record = folder / run_file(name, plan_file)
    say_written(record, gif, strip)
    say_next(f"neurosym replay {quoted(folder)} {quoted(record)}")
    answer(run, file=str(record), reached=run.reached)
    return 0 if run.reached else NO_RESULT
