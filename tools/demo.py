"""What `make demo` shows: the shipped domain compiled, planned with two planners, executed, with pictures.

Works on a copy in `demo/`, so that `domains/tabletop` stays as it was shipped. For one object and for two,
it takes the first shipped problem that Fast Downward finds a plan for, and says which it passed over.
"""

import shutil
from pathlib import Path

from neurosym.console import say, show_table
from neurosym.reading import read_json
from neurosym.stages.compiling import compile_stage
from neurosym.stages.executing import Showing, execute_stage, load_run
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import plan_files
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.planning import load_problem, plan_stage

SHIPPED = Path(__file__).parent.parent / "domains" / "tabletop"
DEMO = Path("demo")
PLANNERS = ("bfs", "fast-downward")
LEARNED = ("world.toml", "effect_model.safetensors", "primitives.json", "problems")


def main() -> None:
    """Run the demonstration."""
    folder = copy_shipped()
    folder.perform(compile_stage(folder, cell=0.005), again=True)
    say(f"compiled {folder / 'domain.pddl'}")
    rows = []
    for objects in (1, 2):
        name = first_solvable(folder, objects)
        rows += [row_of(folder, name, objects, planner) for planner in PLANNERS]
    columns = ["problem", "objects", "planner", "found", "steps", "seconds", "reached", "why not"]
    show_table("plans for the shipped domain, executed in the simulator", columns, rows)
    say(f"domain, problems, plans, runs and pictures lie in {DEMO}/")
    say(f"next: open {DEMO}/*.png and *.gif; read {folder / 'domain-operators.pddl'}; neurosym --help")


def copy_shipped() -> DomainFolder:
    """Copy what was learned, without what the demonstration is to make again."""
    target = DEMO / "tabletop"
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for name in LEARNED:
        copy = shutil.copytree if (SHIPPED / name).is_dir() else shutil.copy2
        copy(SHIPPED / name, target / name)
    return DomainFolder(target)


def first_solvable(folder: DomainFolder, objects: int) -> str:
    """Name the first problem with so many objects that Fast Downward solves, or else the first of all."""
    names = [name for name in folder.problem_names() if len(load_problem(folder, name).objects) == objects]
    for name in names:
        record = planned(folder, name, "fast-downward")
        if record.solved:
            return name
        say(f"passed over {name}: {record.reason}")
    return names[0]


def planned(folder: DomainFolder, name: str, planner: str) -> PlanRecord:
    """Plan a problem and tell how it went."""
    folder.perform(plan_stage(folder, name, planner=planner), again=True)
    return read_json(folder / plan_files(name, planner)[1], PlanRecord)


def row_of(folder: DomainFolder, name: str, objects: int, planner: str) -> list[str]:
    """Plan and execute a problem with one planner; returns a row of the table."""
    record = planned(folder, name, planner)
    row = [name, str(objects), planner, record.status.value, str(record.primitives), f"{record.seconds:.2f}"]
    if not record.solved:
        return [*row, "-", record.reason]
    plan_file = folder / plan_files(name, planner)[0]
    strip, gif = (DEMO / f"{name}.{planner}.{ending}" for ending in ("png", "gif"))
    folder.perform(execute_stage(folder, name, plan_file, showing=Showing(gif, strip)), again=True)
    run = load_run(folder, name, plan_file)
    return [*row, "yes" if run.reached else "no", run.reason]


if __name__ == "__main__":
    main()
