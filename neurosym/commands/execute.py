"""The command `neurosym execute`: a plan, run in the world."""

from pathlib import Path
from typing import Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.exit_codes import NO_RESULT
from neurosym.commands.options import Folder, ProblemName, TimeLimit, Tolerance, check_time_limit, opened
from neurosym.commands.plan_streams import given_plan
from neurosym.commands.showing import Gif, Gui, Strip, say_written, showing_of
from neurosym.console import say, say_next
from neurosym.wording import quoted


def execute(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[
        Positional[Path], arg(metavar="PLAN", help="Any planner's plan; - reads it from standard input.")
    ],
    replanner: Annotated[
        str, arg(help="Whom to ask for a new plan: see `neurosym planners`, or module:factory.")
    ] = "fast-downward",
    replans: Annotated[
        Optional[int],
        arg(
            metavar="N",
            help="How many new plans may be asked for; 0: the plan is followed as it is, to its end. "
            "Without it: 0 for a plan that neurosym did not write, else 10, and 2 more for each primitive "
            "of the plan. Ten in a row that come no nearer end the run.",
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

    A plan that neurosym did not write, or that was changed since, is followed as it is, unless --replans
    says otherwise. Else what is left of the plan is replayed after every step from what is seen. If it would
    miss the goal, a new plan is made, which takes into account what each object did so far.
    """
    from neurosym.commands.tables import show_run
    from neurosym.stages.executing import execute_stage, load_run
    from neurosym.stages.layout import run_file
    from neurosym.stages.plan_records import planned_tolerance

    check_time_limit(time_limit)
    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    plan_file = given_plan(domain, folder, name, plan_file)
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
    _say_how(plan_file, replanner, stage.options["replans"])
    domain.perform(stage, again=True)
    run = load_run(domain, name, plan_file)
    if not run.plan:
        say(f"note: {plan_file} holds no step")
    show_run(run)
    record = folder / run_file(name, plan_file)
    say_written(record, gif, strip)
    say_next(f"neurosym replay {quoted(folder)} {quoted(record)}")
    answer(run, file=str(record), outcome=run.outcome, credit=run.credit)
    return 0 if run.reached else NO_RESULT


def _say_how(plan_file: Path, replanner: str, replans: int | None) -> None:
    """Say whether the plan is followed as it is, or planned anew on the way."""
    from neurosym.stages.plan_records import record_beside

    if replans == 0:
        whose = "" if record_beside(plan_file) else "; neurosym did not write it"
        more = f"{whose}: --replans 10 allows new plans" if whose else ""
        say(f"follows {plan_file} as it is, to its end{more}")
    else:
        say(f"follows {plan_file}, and asks {replanner} for a new plan where it would miss the goal")
