"""The commands that run plans in the world, and that run their records again."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from neurosym.command_options import NO_RESULT, Folder, ProblemName
from neurosym.console import say, say_next
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.folder import DomainFolder
from neurosym.quoting import quoted

if TYPE_CHECKING:
    from neurosym.run_stages import Showing

Gif = Annotated[Path | None, arg(help="Write an animated GIF of the run here.")]
Strip = Annotated[Path | None, arg(help="Write a PNG with a picture for each step here.")]
Gui = Annotated[bool, arg(help="Show the run live in a window instead.")]


def execute(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[Positional[Path], arg(metavar="PLAN", help="Any planner's plan, in IPC form.")],
    replanner: Annotated[
        str, arg(help="The planner that is asked for a new plan; see `neurosym planners`.")
    ] = "fast-downward",
    replans: Annotated[
        int, arg(help="How many new plans may be asked for; 0: the plan is followed blindly to its end.")
    ] = 10,
    disturb: Annotated[
        int | None,
        arg(metavar="SEED", help="Nudge an object by 3 to 8 cm once during the run, drawn from this seed."),
    ] = None,
    gif: Gif = None,
    strip: Strip = None,
    gui: Gui = False,
) -> int:
    """Run a plan in the simulator, each step beside its promise; exit code 3 if it misses.

    After every step what is left of the plan is replayed from what is seen. If it would miss the goal, a new
    plan is made, which reckons with what each object did so far.
    """
    from neurosym.reporting import show_run
    from neurosym.run_stages import execute_stage, load_run, run_file

    domain = DomainFolder(folder)
    name = domain.problem(problem)
    if plan_file.exists() and not plan_file.is_file():
        raise InvalidFile(plan_file, "it is no file; name one that holds a plan")
    if not plan_file.is_file():
        raise InvalidValue(
            f"There is no plan file {plan_file}; `neurosym plan {quoted(folder)} {name}` writes one."
        )
    made_for = plan_file.stem.split(".")[0]
    if made_for != name and made_for in domain.problem_names():
        say(f"note: {plan_file} seems to be made for {made_for}, not for {name}")
    stage = execute_stage(
        domain,
        name,
        plan_file,
        replanner=replanner,
        replans=replans,
        nudge_seed=disturb,
        showing=_showing(gif, strip, gui),
    )
    domain.perform(stage, again=True)
    run = load_run(domain, name, plan_file)
    if not run.plan:
        say(f"note: {plan_file} holds no step")
    show_run(run)
    record = folder / run_file(name, plan_file)
    _say_written(record, gif, strip)
    say_next(f"neurosym replay {quoted(folder)} {quoted(record)}")
    return 0 if run.reached else NO_RESULT


def replay(
    folder: Folder,
    record: Annotated[
        Positional[Path],
        arg(metavar="RUN", help="A record that `neurosym execute` wrote: its file, or its name in DIR/runs."),
    ],
    gif: Gif = None,
    strip: Strip = None,
    gui: Gui = False,
) -> int:
    """Run a record again, nudge and all, and say whether the same happens byte by byte (exit code 3: no)."""
    from neurosym.run_stages import replay_run

    domain = DomainFolder(folder)
    record = _record(domain, record)
    inside = record.resolve()
    if inside.is_relative_to(domain.path.resolve()):
        for remark in domain.outdated((inside.relative_to(domain.path.resolve()).as_posix(),)):
            say(f"note: {remark}")
    run, difference = replay_run(domain, record, _showing(gif, strip, gui))
    _say_written(gif, strip)
    if difference:
        say(f"something else happened than {record} says, first in {difference}")
        return NO_RESULT
    steps = f"{len(run.steps)} step{'' if len(run.steps) == 1 else 's'}"
    say(f"the same happened again in {steps}, byte for byte; goal {'reached' if run.reached else 'missed'}")
    return 0


def _record(domain: DomainFolder, typed: Path) -> Path:
    """Find the record of a run that was typed as a file, or as a name."""
    from neurosym.run_stages import RECORD

    if typed.is_file():
        return typed
    known = {path.name.removesuffix(RECORD): path for path in (domain / "runs").glob(f"*{RECORD}")}
    if found := known.get(typed.name.removesuffix(RECORD)) if typed.name == str(typed) else None:
        return found
    if not known:
        raise InvalidFile(typed, "there is no such file; `neurosym execute` writes one")
    raise UnknownChoice("record of a run", str(typed), known)


def _showing(gif: Path | None, strip: Path | None, gui: bool) -> "Showing":
    from neurosym.pictures import check_picture_path
    from neurosym.run_stages import Showing

    if gui and (gif or strip):
        raise InvalidValue("Give --gui or files for pictures, not both.")
    for picture, ending in ((gif, ".gif"), (strip, ".png")):
        if picture:
            check_picture_path(picture, [ending])
    return Showing(gif, strip, gui)


def _say_written(*paths: Path | None) -> None:
    for path in paths:
        if path and path.exists():
            say(f"wrote {path}")
