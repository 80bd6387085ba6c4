"""The commands that use a learned domain: compile it, make problems, plan, and execute."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import UseAppendAction, arg

from neurosym.command_options import NO_RESULT, Folder, ProblemName, Seed
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.folder import DomainFolder
from neurosym.quoting import quoted

if TYPE_CHECKING:
    from neurosym.plan_stages import PlanRecord


def compile_domain(
    folder: Folder, cell: Annotated[float, arg(help="Edge of a grid cell [m].")] = 0.005
) -> int:
    """Compile the PDDL domain: `primitives.json` -> `domain.pddl` and its like, and `grounding.json`.

    All domains say the same. `domain.pddl` moves one axis at a time and stays small on fine grids;
    `domain-operators.pddl` has one action for each operator, reads best, and takes the same problems;
    `domain-numeric.pddl` has numbers instead of a grid, and takes the problems NAME.numeric.pddl.
    """
    from neurosym.pddl.grounding import Grounding
    from neurosym.pddl_stages import compile_stage

    domain = DomainFolder(folder)
    domain.perform(compile_stage(domain, cell=cell), again=True)
    grounding = Grounding.load(domain / "grounding.json")
    say(f"{len(grounding.live)} operators in {folder / 'domain.pddl'}; left out: {len(grounding.left_out)}")
    for name, reason in grounding.left_out.items():
        say(f"  {name}: {reason}")
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0


def new_problem(
    folder: Folder,
    name: Annotated[
        str | None,
        arg(help="Its name: a letter, then a-z, digits, hyphens. Else the first free one of task-01, ..."),
    ] = None,
    objects: Annotated[int, arg(help="Objects on the table: item-01, item-02, ...")] = 1,
    actions: Annotated[int, arg(help="Random actions that lead to the goal, one after another.")] = 1,
    seed: Seed = 0,
    goal: Annotated[
        tuple[str, ...],
        UseAppendAction,
        arg(metavar="ITEM=X,Y[,Z]", help="A goal by hand, in the world frame [m], once for each object."),
    ] = (),
) -> int:
    """Make a problem: a random scene, and a goal that random actions lead to (one in the paper) or yours."""
    from neurosym.files import digest
    from neurosym.pddl_stages import problem_stage
    from neurosym.problems import check_names

    domain = DomainFolder(folder)
    name = domain.free_problem_name() if name is None else name
    check_names((name,))
    if goal and actions != 1:
        raise InvalidValue("Give --actions or goals by hand, not both.")
    goals = _parse_goals(goal) if goal else None
    scene = folder / f"problems/{name}.scene.json"
    before = digest(scene) if scene.is_file() else None
    verb = "replaced" if name in domain.problem_names() else "wrote"
    stage = problem_stage(domain, name=name, objects=objects, actions=actions, seed=seed, goals=goals)
    domain.perform(stage, again=True)
    say(f"{verb} {folder / 'problems' / name}.pddl and its scene")
    if before != digest(scene) and (stale := domain.made_for(name)):
        say(f"note: made for the former {name}, and stale now: {', '.join(stale)}")
    say_next(f"neurosym plan {quoted(folder)} {name}")
    return 0


def plan(
    folder: Folder,
    problem: ProblemName,
    planner: Annotated[str, arg(help="One of those that `neurosym planners` lists.")] = "fast-downward",
    time_limit: Annotated[float, arg(help="When to give up [s].")] = 60.0,
    encoding: Annotated[
        str | None, arg(help="For PDDL planners: sas, stepwise, operators or numeric, instead of the usual.")
    ] = None,
    whole: Annotated[bool, arg(help="For PDDL planners: all objects at once instead of one by one.")] = False,
    unit_costs: Annotated[
        bool, arg(help="Every step costs the same, instead of the more the rarer it goes well; not for bfs.")
    ] = False,
    nearest: Annotated[
        bool,
        arg(help="If there is no plan, plan as near to the goal as objects come (exit code 3 if it misses)."),
    ] = False,
    alternatives: Annotated[
        int, arg(metavar="K", help="Also write the K next-best plans: cheapest, of other steps.")
    ] = 0,
) -> int:
    """Plan for a problem; exit code 3 if there is no plan, with the reason.

    `bfs` is the paper's breadth-first search over the effects that the network predicts, three deep;
    `counting` finds the fewest primitives there can be. Any other planner can be given DIR/domain.pddl and
    DIR/problems/PROBLEM.pddl, and its plan file executed.
    """
    from neurosym.files import read_json
    from neurosym.plan_stages import PlanRecord, plan_files, plan_stage

    domain = DomainFolder(folder)
    name = domain.problem(problem)
    if not time_limit > 0:
        raise InvalidValue(f"time-limit = {time_limit} must be greater than 0 s.")
    stage = plan_stage(
        domain,
        name,
        planner=planner,
        time_limit=time_limit,
        encoding=encoding,
        whole=whole,
        unit_costs=unit_costs,
        nearest=nearest,
        more=alternatives,
    )
    domain.perform(stage, again=True)
    plan_file, record_file = plan_files(name, planner)
    record = read_json(domain / record_file, PlanRecord)
    _say_plan(record)
    if record.steps or record.solved:
        say(f"wrote {folder / plan_file}")
        _say_alternatives(record, folder, alternatives)
        say_next(f"neurosym execute {quoted(folder)} {name} {quoted(folder / plan_file)}")
    return 0 if record.solved else NO_RESULT


def _say_plan(record: "PlanRecord") -> None:
    if record.solved:
        remark = f" ({record.reason})" if record.reason else ""
        count = f"{len(record.steps)} step{'' if len(record.steps) == 1 else 's'}"
        chance = f"{record.chance or 0.0:.0%} likely to go as promised"
        say(f"{count} in {record.seconds:.2f} s{remark}, {chance}:")
    else:
        say(f"no plan for {record.problem} ({record.status}, {record.seconds:.2f} s): {record.reason}")
        if record.steps:
            say("as near as it comes:")
    _say_steps(record.steps)


def _say_alternatives(record: "PlanRecord", folder: Path, wanted: int) -> None:
    for other in record.alternatives:
        say(f"or, {other.chance:.0%} likely, {folder / other.file}:")
        _say_steps(other.steps)
    from neurosym.planners.alternatives import LONGER

    if len(record.alternatives) < wanted and record.solved:
        found = len(record.alternatives)
        only = f"only {found}" if found else "no"
        most = f"of at most {LONGER} more primitives an object"
        say(f"{only} other plan{'s' if found > 1 else ''} {most} {'were' if found > 1 else 'was'} found")


def _say_steps(steps: tuple[tuple[str, str], ...]) -> None:
    for operator, item in steps:
        say(f"  ({operator} {item})")


def _parse_goals(texts: tuple[str, ...]) -> dict[str, tuple[float, ...]]:
    goals = dict(map(_parse_goal, texts))
    if len(goals) < len(texts):
        raise InvalidValue(f"An object has two goals in {' '.join(texts)}; give each object one.")
    return goals


def _parse_goal(text: str) -> tuple[str, tuple[float, ...]]:
    name, _, numbers = text.partition("=")
    try:
        return name, tuple(float(number) for number in numbers.split(","))
    except ValueError as error:
        raise InvalidValue(f"The goal {text!r} cannot be read; write it as item-01=0.60,0.10.") from error
