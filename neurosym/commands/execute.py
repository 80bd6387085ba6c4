"""Commands that run plans in the world: `execute`, `replay`, and `demo`, which compiles and plans before."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.choices import DEFAULT_PLANNER, copy_shipped
from neurosym.commands.arguments import (
    Folder,
    Json,
    ProblemName,
    TimeLimit,
    Tolerance,
    answer_in,
    check_file,
    opened,
    refuse_options,
)
from neurosym.commands.ending import NO_RESULT
from neurosym.commands.tasks import given_plan
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, check_extra, counted, quoted
from neurosym.files import make_folder, write_atomically
from neurosym.stages.console import print_raw, progress_bar, say, say_next, show_table
from neurosym.stages.folder import Claim, DomainFolder, Stage, load_scene
from neurosym.stages.layout import (
    DOMAIN,
    GROUNDING,
    PASTS,
    RECORD,
    RUNS,
    WORLD,
    plan_files,
    run_file,
    scene_file,
)

if TYPE_CHECKING:
    from neurosym.execution.performance import Agreement
    from neurosym.execution.record import Run
    from neurosym.stages.execution import Showing
    from neurosym.stages.meeting import Meeting


_Gif = Annotated[Optional[Path], arg(help="Write an animated GIF of the run here.")]
_Strip = Annotated[Optional[Path], arg(help="Write a PNG with a picture for each step here.")]
_Gui = Annotated[bool, arg(help="Show the run live in a window instead.")]


def execute(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[
        Positional[Path], arg(metavar="PLAN", help="Any planner's plan; - reads it from standard input.")
    ],
    replanner: Annotated[
        str, arg(help="Whom to ask for a new plan: see `neurosym planners`, or module:factory.")
    ] = DEFAULT_PLANNER,
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
    gif: _Gif = None,
    strip: _Strip = None,
    gui: _Gui = False,
    json: Json = False,
) -> int:
    """Run a plan in the simulator, each step beside its promise; exit code 3 if it misses.

    A plan that neurosym did not write, or that was changed since, is followed as it is, unless --replans
    says otherwise. Else what is left of the plan is replayed after every step from what is seen. If it would
    miss the goal, a new plan is made, which takes into account what each object did so far.
    """
    from neurosym.commands.tables import show_run
    from neurosym.stages.execution import execute_stage, load_run
    from neurosym.stages.plan_records import planned_tolerance, record_beside
    from neurosym.stages.value_stages import execute_values_stage, is_of_values

    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    if is_of_values(domain):
        refuse_options(gui=gui, gif=gif, strip=strip, disturb=disturb, tolerance=tolerance)
        plan_file = given_plan(domain, folder, name, plan_file, must_fit=False)
        stage = execute_values_stage(
            domain, name, plan_file, replanner=replanner, replans=replans, time_limit=time_limit
        )
        return _perform_values(domain, stage, answer)
    plan_file = given_plan(domain, folder, name, plan_file)
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
        showing=_showing_of(gif, strip, gui),
    )
    if stage.options["replans"] == 0:
        more = "neurosym did not write it: --replans 10 allows new plans"
        say(f"follows {plan_file} as it is, to its end{'' if record_beside(plan_file) else f'; {more}'}")
    else:
        say(f"follows {plan_file}, and asks {replanner} for a new plan where it would miss the goal")
    for remark in domain.outdated_file(plan_file):
        say(f"note: {remark}")
    domain.perform(stage, again=True)
    run = load_run(domain, name, plan_file)
    if not run.plan:
        say(f"note: {plan_file} holds no step")
    show_run(run)
    record = folder / run_file(name, plan_file)
    _say_written(record, gif, strip)
    say_next(f"neurosym replay {quoted(folder)} {quoted(record)}")
    answer(run, file=str(record), outcome=run.outcome, credit=run.credit)
    return 0 if run.reached else NO_RESULT


def _perform_values(domain: DomainFolder, stage: Stage, answer: Callable[..., None]) -> int:
    """Run a plan in a world of values, and show what came of each step."""
    from neurosym.commands.tables import show_value_run
    from neurosym.files import read_json
    from neurosym.stages.value_stages import domain_of
    from neurosym.values.value_execution import ValueRun

    domain.perform(stage, again=True)
    record = domain / stage.outputs[0]
    run = read_json(record, ValueRun)
    show_value_run(run, domain_of(domain))
    say(f"wrote {record}")
    answer(run, file=str(record))
    return 0 if run.reached else NO_RESULT


def meet(
    folder: Folder,
    scene: Annotated[
        Positional[str], arg(metavar="PROBLEM", help="A problem in DIR/problems whose objects are met.")
    ],
    tries: Annotated[
        int, arg(help="How many tries of each object there are in all; more go on from these.")
    ] = 3,
    object: Annotated[  # noqa: A002  (it is typed so)
        Optional[str], arg(metavar="ITEM", help="The only object to be met.")
    ] = None,
    forget: Annotated[
        bool, arg(help="Forget what the objects did; they are met as new, or not at all.")
    ] = False,
    json: Json = False,
) -> int:
    """Try things with the objects of a scene, and keep what each did by its name.

    Each try begins as the scene says, without the other objects, with what a plan for the object would do
    first and was not tried. Plans count what an object did from then on, and runs with it add to that.
    `--forget --tries 0` only forgets.
    """
    from neurosym.grounding import Grounding
    from neurosym.stages.meeting import Meeting, met_in_words
    from neurosym.stages.past_files import Past, forget_pasts, load_past
    from neurosym.stages.planning import load_problem
    from neurosym.stages.value_stages import is_of_values
    from neurosym.worlds.world_file import read_world

    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(scene)
    if is_of_values(domain):
        raise InvalidValue("With data of your own there are no objects to be met: --seed draws others.")
    with domain.claimed(Claim.SHARED):
        if forget:  # also what cannot be read
            path = domain / scene_file(name)
            every = load_scene(path).object_names if path.is_file() else ()
            names = [one for one in every if object in (None, one)]
            forgotten = forget_pasts(domain, names)
            say(f"forgot what {', '.join(forgotten) or 'none of them'} did")
        grounding, world = Grounding.load(domain.require(GROUNDING)), read_world(domain.require(WORLD))()
        problem = load_problem(domain, name, world)
        names = [problem.object_named(object).name] if object else [*problem.object_names]
        meetings = [Meeting(domain, problem, one, world, grounding) for one in names] if tries else []
        if rows := [row for one in meetings for row in _tried(one, tries)]:
            show_table("tries", ["object", "motion", "what came", "as promised"], rows)
        for line in met_in_words(domain, grounding, names):
            say(line)
    found = [past for one in names if (past := load_past(domain, problem.object_named(one)))]
    if not found:
        say("nothing is known of what they did")
    if tries:
        say(f"wrote {folder / PASTS}")
        say_next(f"neurosym plan {quoted(folder)} {name}")
    answer({"pasts": list[Past](found)})
    return 0


def _tried(meeting: "Meeting", tries: int) -> Iterator[list[str]]:
    """Try things with an object until there were so many tries, and tell of each."""
    name = meeting.past.name
    with progress_bar(f"meeting {name}") as advance:
        while meeting.tries < tries and (found := meeting.try_next()):
            advance(meeting.tries, tries)
            x, y, z = (f"{1000 * value:.0f}" for value in found.trial.effect)
            said = f"{found.trial.kind} {x}, {y}, {z} mm"
            yield [name, found.operator, said, "yes" if found.kept else "no"]


def replay(
    folder: Folder,
    record: Annotated[
        Positional[Path],
        arg(metavar="RUN", help="A record that `neurosym execute` wrote: its file, or its name in DIR/runs."),
    ],
    gif: _Gif = None,
    strip: _Strip = None,
    gui: _Gui = False,
    page: Annotated[
        Optional[Path], arg(help="Write the run here as one HTML page whose view can be turned.")
    ] = None,
) -> int:
    """Run a record again, nudge and all, and say whether the same happens (exit code 3: no).

    That is byte for byte on the machine that it was made on, and within a micrometre on another.
    """
    from neurosym.stages.execution import replay_run
    from neurosym.stages.value_stages import is_of_values

    domain = opened(folder)
    if page:
        check_extra()
        check_file(page, "page", ".html", ".htm")
    if is_of_values(domain):
        raise InvalidValue(
            "Runs with data of your own are not replayed; `neurosym execute` performs a plan again."
        )
    record = _record(domain, record)
    for remark in domain.outdated_file(record):
        say(f"note: {remark}")
    showing = _showing_of(gif, strip, gui)
    if page:
        run, agreement = _replayed_on_page(domain, record, showing, page)
    else:
        run, agreement = replay_run(domain, record, showing)
    _say_written(gif, strip, page)
    code = _say_course(run, agreement, record)
    seen = f"replay {quoted(folder)} {quoted(record)} --page run.html"
    say_next(f"neurosym {f'report {quoted(folder)}' if page else seen}")
    return code


def _say_course(run: "Run", agreement: "Agreement", record: Path) -> int:
    """Say whether the same happened again, and return the exit code."""
    happened = f"the same happened again in {counted(len(run.steps), 'step')}"
    if agreement.course == "same bytes":
        say(f"{happened}, byte for byte; {run.outcome}; {run.credit}")
        return 0
    is_other = agreement.course == "another"
    if is_other:
        by = f", by {1000 * agreement.apart:.2g} mm" if math.isfinite(agreement.apart) else ""
        say(f"something else happened than {record} says, first in {agreement.where}{by}")
    else:
        say(f"{happened}, within a micrometre; {run.outcome}; {run.credit}")
        by = f"lengths differ by {1000 * agreement.apart:.1g} mm at most, first in {agreement.where}"
        say(f"not byte for byte: {by}")
    say(_machines(run))
    return NO_RESULT if is_other else 0


def _replayed_on_page(
    domain: DomainFolder, record: Path, showing: "Showing", page: Path
) -> "tuple[Run, Agreement]":
    """Run a record again, and write what is seen as a page whose view can be turned."""
    import rich

    from neurosym.stages.execution import replay_run
    from neurosym.stages.planning import load_problem
    from neurosym.studio.library import Library
    from neurosym.studio.messages import Controls, Onlooker, Seen
    from neurosym.studio.view import film_of

    library, told = Library(domain, domain.path.name), list[object]()
    looking_on = replace(showing, audience=Onlooker(told.append, Controls(speed=0.0), pace=0.0))
    run, agreement = replay_run(domain, record, looking_on)
    if seen := [one for one in told if isinstance(one, Seen)]:
        rich.get_console().quiet = True  # on which the server of pages announces itself
        problem = load_problem(domain, run.problem).within(run.tolerance)
        write_atomically(page, film_of(library, problem, seen, run.steps))
    else:
        say("no page: nothing moves in this run")
    return run, agreement


def _machines(run: "Run") -> str:
    """Say on which machines a record was made and run again, as far as they differ."""
    from neurosym.execution.record import this_machine

    here = this_machine()
    if run.machine is None:
        return f"the record does not name its machine; this one has: {here.processor}, {here.system}"
    if apart := run.machine.differences(here):
        return f"the record was made on another machine than this: {'; '.join(apart)}"
    return f"machine and versions are those of the record: {here.processor}, {here.system}"


def _record(domain: DomainFolder, typed: Path) -> Path:
    """Find the record of a run that was typed as a file, or as a name."""
    if typed.exists() and not typed.is_dir():
        return typed
    known = {path.name.removesuffix(RECORD): path for path in (domain / RUNS).glob(f"*{RECORD}")}
    if found := known.get(typed.name.removesuffix(RECORD)) if typed.name == str(typed) else None:
        return found
    if not known:
        raise InvalidFile(typed, "there is no such file; `neurosym execute` writes one")
    raise UnknownChoice("record of a run", str(typed), known)


_SHIPPED, _TASK = "places", "swap-2-07"
"""Two objects stand where the other is to stand: one steps aside, so the plan has three steps."""


def demo(
    output: Annotated[
        Path, arg(metavar="FOLDER", help="Where the copy of the domain and the pictures go.")
    ] = Path("demo"),
) -> int:
    """Compile a shipped domain, plan how two objects change places, execute, film.

    It prints each command that it performs, so that any of them can be tried again with changes.
    """
    from neurosym.commands.learn import compile_domain
    from neurosym.commands.tasks import plan

    def say_command(*words: str | Path) -> None:
        print_raw(f"\n$ neurosym {' '.join(map(quoted, words))}")

    folder = output / _SHIPPED  # what an earlier demonstration left is used again
    make_folder(output)
    if not folder.exists() and not copy_shipped(_SHIPPED, folder):
        raise InvalidValue("No domain came with this installation; install neurosym-pddl again.")
    plan_file = folder / plan_files(_TASK, DEFAULT_PLANNER)[0]
    gif, strip = (output / f"{_TASK}{ending}" for ending in (".gif", ".png"))
    say_command("compile-domain", folder)
    compile_domain(folder)
    say(f"{_TASK} came with the domain: two objects are to change places")
    say_command("plan", folder, _TASK)
    if code := plan(folder, _TASK):
        return code
    say_command("execute", folder, _TASK, plan_file, "--gif", gif, "--strip", strip)
    code = execute(folder, _TASK, plan_file, gif=gif, strip=strip)
    say(f"look at {gif} and {strip}, and read {folder / DOMAIN}")
    say_next(f"neurosym report {quoted(folder)}")
    return code


def _showing_of(gif: Path | None, strip: Path | None, gui: bool) -> "Showing":
    """Check what was asked for of pictures: files with the right endings, or a window."""
    from neurosym.stages.execution import Showing

    if gui and (gif or strip):
        raise InvalidValue("Give --gui or files for pictures, not both.")
    check_file(gif, "picture", ".gif")
    check_file(strip, "picture", ".png")
    return Showing(gif, strip, gui)


def _say_written(*paths: Path | None) -> None:
    """Print which of some files were written."""
    for path in paths:
        if path and path.exists():
            say(f"wrote {path}")
