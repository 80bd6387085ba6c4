"""The command `neurosym demo`: a shipped domain compiled, planned with two planners, executed, with pictures.

For one object and for two, it takes the first shipped problem that Fast Downward finds a plan for, and says
which it passed over.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import arg

from neurosym.console import say, say_next, show_table
from neurosym.errors import InvalidValue
from neurosym.files import make_folder
from neurosym.shipped import copy_shipped
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import plan_files
from neurosym.wording import quoted

if TYPE_CHECKING:
    from neurosym.stages.plan_records import PlanRecord

DOMAIN = "tabletop"
PLANNERS = ("bfs", "fast-downward")


def demo(
    output: Annotated[
        Path, arg(metavar="FOLDER", help="Where the copy of the domain and the pictures go.")
    ] = Path("demo"),
) -> int:
    """Show what neurosym does: compile a shipped domain, plan with two planners, execute, take pictures."""
    from neurosym.stages.compiling import compile_stage

    folder = _copied(output)
    folder.perform(compile_stage(folder, cell=0.005), again=True)
    say(f"compiled {folder / 'domain.pddl'}")
    rows = []
    for objects in (1, 2):
        name = _first_solvable(folder, objects)
        rows += [_row(folder, name, objects, planner, output) for planner in PLANNERS]
    columns = ["problem", "objects", "planner", "found", "steps", "seconds", "reached", "why not"]
    show_table("plans for the shipped domain, executed in the simulator", columns, rows)
    say(f"domain, problems, plans, runs and pictures lie in {output}/")
    say(f"look at {output}/*.png and *.gif, and read {folder / 'domain-operators.pddl'}")
    say_next(f"neurosym report {quoted(folder.path)}")
    return 0


def _copied(output: Path) -> DomainFolder:
    """Copy the domain; what an earlier demonstration left is used again, and nothing is removed."""
    target = output / DOMAIN
    make_folder(output)
    if not target.exists() and not copy_shipped(DOMAIN, target):
        raise InvalidValue("No domain came with this installation; install neurosym-pddl again.")
    return DomainFolder(target)


def _first_solvable(folder: DomainFolder, objects: int) -> str:
    """Name the first problem with so many objects that Fast Downward solves, or else the first of all."""
    from neurosym.stages.planning import load_problem

    names = [name for name in folder.problem_names() if len(load_problem(folder, name).objects) == objects]
    for name in names:
        record = _planned(folder, name, "fast-downward")
        if record.solved:
            return name
        say(f"passed over {name}: {record.reason}")
    return names[0]


def _planned(folder: DomainFolder, name: str, planner: str) -> "PlanRecord":
    """Plan a problem and tell how it went."""
    from neurosym.reading import read_json
    from neurosym.stages.plan_records import PlanRecord
    from neurosym.stages.planning import plan_stage

    folder.perform(plan_stage(folder, name, planner=planner), again=True)
    return read_json(folder / plan_files(name, planner)[1], PlanRecord)


def _row(folder: DomainFolder, name: str, objects: int, planner: str, output: Path) -> list[str]:
    """Plan and execute a problem with one planner; returns a row of the table."""
    from neurosym.stages.executing import Showing, execute_stage, load_run

    record = _planned(folder, name, planner)
    row = [name, str(objects), planner, record.status.value, str(record.primitives), f"{record.seconds:.2f}"]
    if not record.solved:
        return [*row, "-", record.reason]
    plan_file = folder / plan_files(name, planner)[0]
    strip, gif = (output / f"{name}.{planner}.{ending}" for ending in ("png", "gif"))
    folder.perform(execute_stage(folder, name, plan_file, showing=Showing(gif, strip)), again=True)
    run = load_run(folder, name, plan_file)
    return [*row, "yes" if run.reached else "no", run.reason]
